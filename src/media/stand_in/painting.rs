//! A picture in floats, on its way to bytes.

use std::thread;

/// Mean and standard deviation that a channel shall have, in bytes' steps.
pub type Tone = [(f32, f32); 3];

/// Red, green and blue of each texel, row by row from the top, mostly from 0 to 1.
pub struct Painting {
    /// Width and height.
    pub size: [usize; 2],
    /// The texels.
    pub texels: Vec<[f32; 3]>,
}

impl Painting {
    /// Asks for the colour of each texel's middle, in a unit square whose y grows downward.
    pub fn new(size: [usize; 2], colour: impl Fn([f32; 2]) -> [f32; 3] + Sync) -> Self {
        let texels = each_texel(size, |x, y| {
            colour([
                (x as f32 + 0.5) / size[0] as f32,
                (y as f32 + 0.5) / size[1] as f32,
            ])
        });
        Self { size, texels }
    }

    /// The same with the mean of n² colours a texel, where a picture has sharp edges.
    pub fn smooth(
        size: [usize; 2],
        n: usize,
        colour: impl Fn([f32; 2]) -> [f32; 3] + Sync,
    ) -> Self {
        let texels = each_texel(size, |x, y| {
            let mut sum = [0.0; 3];
            for sample in 0..n * n {
                let found = colour([
                    ((x * n + sample % n) as f32 + 0.5) / (n * size[0]) as f32,
                    ((y * n + sample / n) as f32 + 0.5) / (n * size[1]) as f32,
                ]);
                // A lamp next to something dark shall not hide it: what counts is what can be shown.
                sum = [0, 1, 2].map(|i| sum[i] + found[i].clamp(0.0, 1.0));
            }
            sum.map(|part| part / (n * n) as f32)
        });
        Self { size, texels }
    }

    /// Moves and stretches each channel until it has that mean and that deviation, clipping included.
    pub fn toned(mut self, tone: Tone) -> Self {
        tone_texels(&mut self.texels, tone);
        self
    }

    /// Red, green, blue and 255 of each texel.
    pub fn rgba(&self) -> Vec<u8> {
        let bytes = |texel: &[f32; 3]| {
            let [r, g, b] = texel.map(byte);
            [r, g, b, 255]
        };
        self.texels.iter().flat_map(bytes).collect()
    }

    /// Red alone.
    pub fn red(&self) -> Vec<u8> {
        self.texels.iter().map(|texel| byte(texel[0])).collect()
    }
}

/// From 0 to 1 in 255 steps.
pub fn byte(part: f32) -> u8 {
    (part.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// See [`Painting::toned`].
pub fn tone_texels(texels: &mut [[f32; 3]], tone: Tone) {
    // First light and dark alone, so that colours do not become gaudy where much contrast is missing.
    let gray = |texel: &[f32; 3]| texel.iter().sum::<f32>() / 3.0;
    let (is, varies) = statistics(texels.iter().map(gray));
    let deviation = tone.iter().map(|(_, deviation)| deviation).sum::<f32>() / 3.0 / 255.0;
    let gain = (deviation / varies.max(1e-6)).clamp(0.2, 5.0);
    for texel in &mut *texels {
        let moved = (gray(texel) - is) * (gain - 1.0);
        *texel = texel.map(|part| part + moved);
    }
    for (channel, &(mean, deviation)) in tone.iter().enumerate() {
        let (mean, deviation) = (mean / 255.0, deviation / 255.0);
        // What is clipped pulls both back, so that it takes some rounds.
        for _ in 0..6 {
            let (is, varies) = statistics(texels.iter().map(|texel| texel[channel]));
            let gain = (deviation / varies.max(1e-6)).clamp(0.2, 5.0);
            for texel in &mut *texels {
                texel[channel] = mean + (texel[channel] - is) * gain;
            }
        }
    }
}

/// Mean and standard deviation of numbers as far as they can be shown, from 0 to 1.
pub fn statistics(parts: impl Iterator<Item = f32>) -> (f32, f32) {
    let (mut count, mut sum, mut squares) = (0.0_f64, 0.0_f64, 0.0_f64);
    for part in parts {
        let part = f64::from(part.clamp(0.0, 1.0));
        count += 1.0;
        sum += part;
        squares += part * part;
    }
    let mean = sum / count;
    (
        mean as f32,
        (squares / count - mean * mean).max(0.0).sqrt() as f32,
    )
}

/// Something for each texel, row by row, in as many threads as the machine has cores.
pub fn each_texel<T: Send + Copy + Default>(
    size: [usize; 2],
    value: impl Fn(usize, usize) -> T + Sync,
) -> Vec<T> {
    let mut texels = vec![T::default(); size[0] * size[1]];
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let rows = size[1].div_ceil(threads);
    thread::scope(|scope| {
        for (part, chunk) in texels.chunks_mut(rows * size[0]).enumerate() {
            let value = &value;
            scope.spawn(move || {
                for (at, texel) in chunk.iter_mut().enumerate() {
                    *texel = value(at % size[0], part * rows + at / size[0]);
                }
            });
        }
    });
    texels
}

/// Light that falls from the upper left on a relief that tiles: the slope towards it at each texel, 0 on level ground.
/// Heights and distances are measured alike where the picture's width is 1.
pub fn slopes(size: [usize; 2], heights: &[f32]) -> Vec<f32> {
    let [width, height] = size;
    each_texel(size, |x, y| {
        let at = |x: usize, y: usize| heights[y % height * width + x % width];
        let across = at(x + 1, y) - at(x + width - 1, y);
        let down = at(x, y + 1) - at(x, y + height - 1);
        (across + down) * 0.25 * width as f32
    })
}
