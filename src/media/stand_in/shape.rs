//! Signed distances from shapes, negative inside: what letters are made of.

/// A place, x to the right and y down.
pub type Point = [f32; 2];

/// The squared distance of a place from the line between two others.
fn to_line_squared(at: Point, [from, to]: [Point; 2]) -> f32 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let here = [at[0] - from[0], at[1] - from[1]];
    let length = along[0] * along[0] + along[1] * along[1];
    let share = if length > 0.0 {
        ((here[0] * along[0] + here[1] * along[1]) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let beside = [here[0] - share * along[0], here[1] - share * along[1]];
    beside[0] * beside[0] + beside[1] * beside[1]
}

/// Lines that enclose something. Where they go around a place more often one way than the other, it is inside.
pub struct Outline {
    /// The lines.
    pub lines: Vec<[Point; 2]>,
    /// How far outside the lines the edge is.
    pub grown: f32,
}

impl Outline {
    /// The outline of a polygon.
    pub fn polygon(corners: &[Point]) -> Self {
        let next = corners.iter().cycle().skip(1);
        Self {
            lines: corners
                .iter()
                .zip(next)
                .map(|(&from, &to)| [from, to])
                .collect(),
            grown: 0.0,
        }
    }

    /// The distance of a place, negative inside.
    pub fn distance(&self, at: Point) -> f32 {
        let mut nearest = f32::MAX;
        let mut turns = 0;
        for &line in &self.lines {
            nearest = nearest.min(to_line_squared(at, line));
            let [from, to] = line;
            let is_below = |point: Point| point[1] > at[1];
            if is_below(from) != is_below(to) {
                let share = (at[1] - from[1]) / (to[1] - from[1]);
                if from[0] + share * (to[0] - from[0]) > at[0] {
                    turns += if is_below(to) { 1 } else { -1 };
                }
            }
        }
        let nearest = nearest.sqrt();
        if turns == 0 {
            nearest - self.grown
        } else {
            -nearest - self.grown
        }
    }
}

/// One of the parts that a symbol is put together of.
pub enum Shape {
    /// A polygon.
    Polygon(Outline),
    /// A disc: its middle and its radius.
    Disc(Point, f32),
    /// A stroke with round ends: its line and half its width.
    Stroke([Point; 2], f32),
    /// Part of a ring: its middle, the radius of the stroke's middle, half the stroke's width, and from which angle
    /// to which it goes, clockwise from the right.
    Arc(Point, f32, f32, [f32; 2]),
    /// Everything that the first has and the second has not.
    Without(Box<[Shape; 2]>),
}

impl Shape {
    /// A polygon with those corners.
    pub fn polygon(corners: &[Point]) -> Self {
        Self::Polygon(Outline::polygon(corners))
    }

    /// A rectangle with upright sides.
    pub fn rectangle([left, top]: Point, [right, bottom]: Point) -> Self {
        Self::polygon(&[[left, top], [right, top], [right, bottom], [left, bottom]])
    }

    /// The distance of a place, negative inside.
    pub fn distance(&self, at: Point) -> f32 {
        match self {
            Self::Polygon(outline) => outline.distance(at),
            Self::Disc(middle, radius) => (at[0] - middle[0]).hypot(at[1] - middle[1]) - radius,
            &Self::Stroke(line, half) => to_line_squared(at, line).sqrt() - half,
            &Self::Arc(middle, radius, half, [from, to]) => {
                let (x, y) = (at[0] - middle[0], at[1] - middle[1]);
                let angle = (y.atan2(x) - from).rem_euclid(std::f32::consts::TAU);
                if angle <= to - from {
                    (x.hypot(y) - radius).abs() - half
                } else {
                    let end = |angle: f32| {
                        (x - radius * angle.cos()).hypot(y - radius * angle.sin()) - half
                    };
                    end(from).min(end(to))
                }
            }
            Self::Without(pair) => pair[0].distance(at).max(-pair[1].distance(at)),
        }
    }
}

/// The distance of a place from the nearest of some shapes.
pub fn to_nearest(shapes: &[Shape], at: Point) -> f32 {
    shapes
        .iter()
        .map(|shape| shape.distance(at))
        .fold(f32::MAX, f32::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_negative_inside_and_true_outside() {
        let square = Shape::rectangle([1.0, 1.0], [5.0, 5.0]);
        assert_eq!(square.distance([3.0, 2.0]), -1.0);
        assert_eq!(square.distance([8.0, 9.0]), 5.0);
        let ring = Shape::Arc([0.0, 0.0], 5.0, 1.0, [0.0, std::f32::consts::PI]);
        assert!((ring.distance([0.0, 5.0]) + 1.0).abs() < 1e-5);
        assert!((ring.distance([5.0, -4.0]) - 3.0).abs() < 1e-5);
    }
}
