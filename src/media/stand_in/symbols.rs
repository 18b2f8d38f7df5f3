//! The first two rows of "Font 1": the buttons of a player, notes, arrows and some more.

use std::f32::consts::{PI, TAU};

use super::shape::{Point, Shape};

/// The parts of a cell's symbol, in a cell of 64 × 64. `None` from the third row on.
pub fn shapes(code: usize) -> Option<Vec<Shape>> {
    Some(match code {
        0x00 => vec![
            bar(9.0),
            triangle(34.0, 15.0, -20.0),
            triangle(55.0, 35.0, -20.0),
        ],
        0x01 => vec![triangle(33.0, 12.0, -21.0), triangle(52.0, 31.0, -21.0)],
        0x02 => vec![triangle(42.0, 23.0, -19.0)],
        0x03 => vec![Shape::Disc([32.0, 31.0], 18.0)],
        0x04 => vec![Shape::rectangle([14.0, 13.0], [50.0, 49.0])],
        0x05 => vec![triangle(22.0, 41.0, 19.0)],
        0x06 => vec![
            Shape::rectangle([20.0, 12.0], [28.0, 52.0]),
            Shape::rectangle([36.0, 12.0], [44.0, 52.0]),
        ],
        0x07 => vec![triangle(12.0, 33.0, 21.0), triangle(31.0, 52.0, 21.0)],
        0x08 => vec![
            triangle(9.0, 29.0, 20.0),
            triangle(30.0, 49.0, 20.0),
            bar(51.0),
        ],
        0x09 => vec![head(27.0, 46.0, 5.5), stem(33.0, 46.0, 8.0)],
        0x0a => vec![
            head(28.0, 44.0, 3.8),
            stem(32.0, 44.0, 21.0),
            Shape::Stroke([[32.0, 22.0], [37.0, 29.0]], 1.2),
            Shape::Stroke([[37.0, 29.0], [37.0, 35.0]], 1.0),
        ],
        0x0b => beamed([23.0, 37.0], [46.0, 44.0], 21.0, 3.5),
        0x0c => beamed([17.0, 43.0], [47.0, 41.0], 9.0, 6.0),
        0x0d => vec![
            stem(26.5, 51.0, 9.0),
            Shape::Arc([28.0, 38.0], 11.0, 1.8, [-PI / 2.0, PI / 3.0]),
            Shape::Stroke([[33.5, 47.0], [26.5, 51.0]], 1.5),
        ],
        0x0e => vec![
            stem(26.0, 41.0, 10.0),
            stem(38.0, 50.0, 19.0),
            Shape::Stroke([[26.0, 25.0], [38.0, 22.0]], 2.0),
            Shape::Stroke([[26.0, 39.0], [38.0, 36.0]], 2.0),
        ],
        0x0f => vec![
            stem(27.0, 53.0, 18.0),
            stem(36.0, 50.0, 15.0),
            Shape::Stroke([[23.0, 29.0], [40.0, 24.0]], 2.2),
            Shape::Stroke([[23.0, 43.0], [40.0, 38.0]], 2.2),
        ],
        0x10 => arrow([55.0, 31.5], [9.0, 31.5], 12.0),
        0x11 => arrow([32.0, 53.0], [32.0, 7.0], 12.0),
        0x12 => arrow([9.0, 31.5], [55.0, 31.5], 12.0),
        0x13 => arrow([32.0, 7.0], [32.0, 53.0], 12.0),
        0x14 => double_arrow([6.0, 31.0], [58.0, 31.0], 12.0),
        0x15 => double_arrow([32.0, 10.0], [32.0, 49.0], 9.0),
        0x16 => arrow([52.0, 51.0], [11.0, 11.0], 12.0),
        0x17 => arrow([11.0, 53.0], [53.0, 11.0], 12.0),
        0x18 => arrow([11.0, 11.0], [52.0, 52.0], 12.0),
        0x19 => arrow([53.0, 11.0], [11.0, 53.0], 12.0),
        0x1a => turning(false),
        0x1b => turning(true),
        0x1c => vec![star()],
        0x1d => vec![smile()],
        0x1e => speaker(-10.0),
        0x1f => {
            let mut parts = speaker(0.0);
            for radius in [14.0, 20.0, 26.0] {
                parts.push(Shape::Arc(
                    [36.0, 33.0],
                    radius,
                    1.3,
                    [PI * 0.78, PI * 1.22],
                ));
            }
            parts
        }
        _ => return None,
    })
}

/// An upright bar, 4 wide.
fn bar(left: f32) -> Shape {
    Shape::rectangle([left, 12.0], [left + 4.0, 52.0])
}

/// A triangle with an upright side and a tip; `reach` says how far and to which side.
fn triangle(side: f32, tip: f32, reach: f32) -> Shape {
    let half = reach.abs();
    Shape::polygon(&[[side, 32.0 - half], [tip, 32.0], [side, 32.0 + half]])
}

/// The head of a note, leaning upward to the right.
fn head(x: f32, y: f32, radius: f32) -> Shape {
    let lean = [radius * 0.35, radius * -0.2];
    Shape::Stroke(
        [[x - lean[0], y - lean[1]], [x + lean[0], y + lean[1]]],
        radius * 0.85,
    )
}

/// The stem of a note.
fn stem(x: f32, bottom: f32, top: f32) -> Shape {
    Shape::rectangle([x - 1.0, top], [x + 1.0, bottom])
}

/// Two notes with two beams.
fn beamed(first: Point, second: Point, top: f32, radius: f32) -> Vec<Shape> {
    let (left, right) = (first[0] + radius, second[0] + radius);
    let (top, falls) = ([top + 5.0, top], 2.0 * radius);
    let beam = |below: f32| {
        let half = radius * 0.4;
        Shape::polygon(&[
            [left - 1.0, top[0] + below - half],
            [right + 1.0, top[1] + below - half],
            [right + 1.0, top[1] + below + half],
            [left - 1.0, top[0] + below + half],
        ])
    };
    vec![
        head(first[0], first[1] + 8.0, radius),
        head(second[0], second[1], radius),
        stem(left, first[1] + 8.0, top[0]),
        stem(right, second[1], top[1]),
        beam(0.0),
        beam(falls),
    ]
}

/// From where to where an arrow's head goes: its tip and its two other corners.
fn arrow_head(from: Point, tip: Point, half: f32) -> Shape {
    let (x, y) = (tip[0] - from[0], tip[1] - from[1]);
    let length = x.hypot(y);
    let (x, y) = (x / length * half, y / length * half);
    Shape::polygon(&[
        tip,
        [tip[0] - x - y, tip[1] - y + x],
        [tip[0] - x + y, tip[1] - y - x],
    ])
}

fn arrow(from: Point, tip: Point, half: f32) -> Vec<Shape> {
    let short = [0, 1].map(|i| tip[i] + (from[i] - tip[i]) * 0.15);
    vec![
        Shape::Stroke([from, short], 2.6),
        arrow_head(from, tip, half),
    ]
}

fn double_arrow(from: Point, to: Point, half: f32) -> Vec<Shape> {
    let inner = |end: Point, other: Point| [0, 1].map(|i| end[i] + (other[i] - end[i]) * 0.15);
    vec![
        Shape::Stroke([inner(from, to), inner(to, from)], 2.4),
        arrow_head(from, to, half),
        arrow_head(to, from, half),
    ]
}

/// An arrow that goes nearly all around.
fn turning(is_clockwise: bool) -> Vec<Shape> {
    let side = if is_clockwise { -1.0 } else { 1.0 };
    let tip: Point = [32.0 + 5.0 * side, 14.0];
    vec![
        Shape::Arc([32.0, 32.0], 15.0, 1.6, [PI * -0.3, PI * 1.3]),
        Shape::polygon(&[
            tip,
            [tip[0] + 11.0 * side, 16.5],
            [tip[0] + 3.0 * side, 26.0],
        ]),
    ]
}

/// A star with five points.
fn star() -> Shape {
    let corners = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map(|corner| {
        let angle = TAU * (corner as f32 / 10.0 - 0.25);
        let radius = if corner % 2 == 0 { 20.0 } else { 7.6 };
        [32.0 + radius * angle.cos(), 32.0 + radius * angle.sin()]
    });
    Shape::polygon(&corners)
}

/// A face that smiles, dark features on a disc.
fn smile() -> Shape {
    let without = |shape, hole| Shape::Without(Box::new([shape, hole]));
    let face = Shape::Disc([32.0, 32.0], 20.0);
    let face = without(face, Shape::Disc([25.5, 26.0], 3.2));
    let face = without(face, Shape::Disc([38.5, 26.0], 3.2));
    without(
        face,
        Shape::Arc([32.0, 32.0], 11.5, 1.8, [PI * 0.1, PI * 0.9]),
    )
}

/// A loudspeaker.
fn speaker(shift: f32) -> Vec<Shape> {
    let at = |x: f32, y: f32| [x + shift, y];
    vec![
        Shape::polygon(&[
            at(32.0, 17.0),
            at(43.0, 27.0),
            at(43.0, 39.0),
            at(32.0, 49.0),
        ]),
        Shape::rectangle(at(40.0, 27.0), at(50.0, 39.0)),
    ]
}
