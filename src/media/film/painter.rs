//! Simple shapes in a picture.

/// A place, across and down.
pub(super) type Point = [f32; 2];
/// Red, green and blue from 0 to 1.
pub(super) type Colour = [f32; 3];

/// Paints shapes over one another. Heights count from 0 at the top to 1, and widths with the same measure.
pub(super) struct Painter {
    /// Width and height in texels, both even.
    pub size: [u32; 2],
    /// Red, green, blue and alpha, top row first.
    pub texels: Vec<u8>,
}

impl Painter {
    /// A white picture.
    pub(super) fn new(size: [u32; 2]) -> Painter {
        Painter {
            size,
            texels: vec![255; 4 * size[0] as usize * size[1] as usize],
        }
    }

    /// Paints everything, two by two texels at once: what fills a picture is smooth. Both sides are even.
    pub(super) fn fill(&mut self, colour: impl Fn(f32, f32) -> Colour) {
        let scale = 1.0 / self.size[1] as f32;
        let row = 4 * self.size[0] as usize;
        for (y, rows) in self.texels.chunks_exact_mut(2 * row).enumerate() {
            let (upper, lower) = rows.split_at_mut(row);
            for (x, pair) in upper.chunks_exact_mut(8).enumerate() {
                let colour = colour(scale * (2 * x + 1) as f32, scale * (2 * y + 1) as f32);
                let [red, green, blue] = colour.map(|channel| (255.0 * channel + 0.5) as u8);
                pair.copy_from_slice(&[red, green, blue, 255, red, green, blue, 255]);
            }
            lower.copy_from_slice(upper);
        }
    }

    /// What lies within `radius` of the line between two points.
    pub(super) fn capsule(&mut self, a: Point, b: Point, radius: f32, colour: Colour) {
        let low = [0, 1].map(|axis| a[axis].min(b[axis]) - radius);
        let high = [0, 1].map(|axis| a[axis].max(b[axis]) + radius);
        let along = [b[0] - a[0], b[1] - a[1]];
        let square = (along[0] * along[0] + along[1] * along[1]).max(1e-9);
        self.shape(low, high, colour, |x, y| {
            let (dx, dy) = (x - a[0], y - a[1]);
            let t = ((dx * along[0] + dy * along[1]) / square).clamp(0.0, 1.0);
            let (dx, dy) = (dx - t * along[0], dy - t * along[1]);
            (dx * dx + dy * dy).sqrt() - radius
        });
    }

    /// What lies within an ellipse of such half widths.
    pub(super) fn ellipse(&mut self, [x, y]: Point, [rx, ry]: Point, colour: Colour) {
        self.shape([x - rx, y - ry], [x + rx, y + ry], colour, |px, py| {
            let (dx, dy) = ((px - x) / rx, (py - y) / ry);
            ((dx * dx + dy * dy).sqrt() - 1.0) * rx.min(ry)
        });
    }

    /// Paints where `distance` is below 0, and thinner over the width of a texel.
    fn shape(
        &mut self,
        low: Point,
        high: Point,
        colour: Colour,
        distance: impl Fn(f32, f32) -> f32,
    ) {
        let height = self.size[1] as f32;
        let [columns, rows] = [0, 1].map(|axis| {
            let most = self.size[axis] as usize;
            // Negative numbers become 0.
            let first = ((low[axis] * height) - 1.0) as usize;
            let last = ((high[axis] * height) + 2.0) as usize;
            first.min(most)..last.min(most)
        });
        let colour = colour.map(|channel| 255.0 * channel.clamp(0.0, 1.0));
        for y in rows {
            let row = 4 * y * self.size[0] as usize;
            for x in columns.clone() {
                let off = distance((x as f32 + 0.5) / height, (y as f32 + 0.5) / height);
                let cover = (0.5 - off * height).clamp(0.0, 1.0);
                if cover > 0.0 {
                    let texel = &mut self.texels[row + 4 * x..row + 4 * x + 3];
                    for (byte, channel) in texel.iter_mut().zip(colour) {
                        let under = f32::from(*byte);
                        *byte = (under + cover * (channel - under) + 0.5) as u8;
                    }
                }
            }
        }
    }
}
