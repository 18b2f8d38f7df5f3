//! Functions over the plane and over space that pictures are composed of: noise, cells and curves.
//!
//! Those over the plane take places in the unit square and repeat with it, so that what is made of them tiles.

use super::hash::{lattice, unit};

/// From one number to another.
pub fn mix(from: f32, to: f32, share: f32) -> f32 {
    from + (to - from) * share
}

/// From one colour to another.
pub fn blend(from: [f32; 3], to: [f32; 3], share: f32) -> [f32; 3] {
    [0, 1, 2].map(|i| mix(from[i], to[i], share))
}

/// A colour made lighter or darker.
pub fn scaled(colour: [f32; 3], factor: f32) -> [f32; 3] {
    colour.map(|part| part * factor)
}

/// GLSL's `smoothstep`.
pub fn smoothstep(low: f32, high: f32, at: f32) -> f32 {
    let t = ((at - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// How far a number is from the nearest whole one.
pub fn to_whole(at: f32) -> f32 {
    (at - floor(at + 0.5) as f32).abs()
}

/// The distance between two places on a circle of the length 1, with its sign.
pub fn around(from: f32, to: f32) -> f32 {
    let straight = to - from;
    straight - floor(straight + 0.5) as f32
}

fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// The whole number below; faster than `f32::floor`, which is a call on processors without an instruction for it.
fn floor(at: f32) -> i32 {
    let near = at as i32;
    near - i32::from(near as f32 > at)
}

/// A number of cells wrapped around; most places are in the unit square already.
fn wrapped(at: i32, cells: i32) -> i32 {
    if (0..cells).contains(&at) {
        at
    } else {
        at.rem_euclid(cells)
    }
}

/// Gradient noise of some cells across and down the unit square; nearly all of it lies between −1 and 1.
pub fn noise(seed: u32, at: [f32; 2], cells: [i32; 2]) -> f32 {
    let x = at[0] * cells[0] as f32;
    let y = at[1] * cells[1] as f32;
    let (left, top) = (floor(x), floor(y));
    let (dx, dy) = (x - left as f32, y - top as f32);
    let columns = [0, 1].map(|i| wrapped(left + i, cells[0]));
    let rows = [0, 1].map(|j| wrapped(top + j, cells[1]));
    let corner = |i: usize, j: usize| {
        let bits = lattice([columns[i], rows[j], 0], seed);
        let gradient = [(bits & 0xffff) as f32, (bits >> 16) as f32].map(|g| g / 32767.5 - 1.0);
        gradient[0] * (dx - i as f32) + gradient[1] * (dy - j as f32)
    };
    let (sx, sy) = (fade(dx), fade(dy));
    let above = mix(corner(0, 0), corner(1, 0), sx);
    let below = mix(corner(0, 1), corner(1, 1), sx);
    1.6 * mix(above, below, sy)
}

/// Octaves of [`noise`], each with twice the cells and a `gain` times the height of the one before.
pub fn fractal(seed: u32, at: [f32; 2], cells: [i32; 2], octaves: u32, gain: f32) -> f32 {
    let mut sum = 0.0;
    let mut height = 1.0;
    for octave in 0..octaves {
        let finer = cells.map(|n| n << octave);
        sum += height * noise(seed.wrapping_add(octave), at, finer);
        height *= gain;
    }
    sum
}

/// Octaves of noise folded at 0, so that they have sharp crests; from about 0 to 1.
pub fn ridges(seed: u32, at: [f32; 2], cells: [i32; 2], octaves: u32) -> f32 {
    let mut sum = 0.0;
    let mut height = 0.5;
    for octave in 0..octaves {
        let finer = cells.map(|n| n << octave);
        let crest = 1.0 - noise(seed.wrapping_add(octave), at, finer).abs();
        sum += height * crest * crest;
        height *= 0.5;
    }
    sum
}

/// What [`cells`] finds.
pub struct Cell {
    /// How far the nearest point is, in cells.
    pub nearest: f32,
    /// How far the one after it is.
    pub second: f32,
    /// Bits that belong to the nearest point.
    pub bits: u32,
}

/// One point anywhere in each cell of a grid on the unit square (Worley's cellular texture).
pub fn cells(seed: u32, at: [f32; 2], cells: [i32; 2]) -> Cell {
    let x = at[0] * cells[0] as f32;
    let y = at[1] * cells[1] as f32;
    let (left, top) = (floor(x), floor(y));
    let columns = [-1, 0, 1].map(|i| wrapped(left + i, cells[0]));
    let rows = [-1, 0, 1].map(|j| wrapped(top + j, cells[1]));
    let mut found = Cell {
        nearest: f32::MAX,
        second: f32::MAX,
        bits: 0,
    };
    for (j, row) in (top - 1..).zip(rows) {
        for (i, column) in (left - 1..).zip(columns) {
            let bits = lattice([column, row, 1], seed);
            let dx = i as f32 + (bits & 0xffff) as f32 / 65536.0 - x;
            let dy = j as f32 + (bits >> 16) as f32 / 65536.0 - y;
            let distance = dx * dx + dy * dy;
            if distance < found.nearest {
                found.second = found.nearest;
                found.nearest = distance;
                found.bits = bits;
            } else if distance < found.second {
                found.second = distance;
            }
        }
    }
    found.nearest = found.nearest.sqrt();
    found.second = found.second.sqrt();
    found
}

/// Value noise in space, from −1 to 1, one cell a unit; it does not repeat.
pub fn noise_in_space(seed: u32, at: [f32; 3]) -> f32 {
    let low = at.map(floor);
    let share = [0, 1, 2].map(|i| fade(at[i] - low[i] as f32));
    let corner = |i: i32, j: i32, k: i32| {
        let place = [low[0] + i, low[1] + j, low[2] + k];
        2.0 * unit(lattice(place, seed)) - 1.0
    };
    let row = |j, k| mix(corner(0, j, k), corner(1, j, k), share[0]);
    let layer = |k| mix(row(0, k), row(1, k), share[1]);
    mix(layer(0), layer(1), share[2])
}

/// Octaves of [`noise_in_space`].
pub fn fractal_in_space(seed: u32, at: [f32; 3], octaves: u32) -> f32 {
    let mut sum = 0.0;
    let mut height = 0.5;
    for octave in 0..octaves {
        let finer = at.map(|part| part * (1 << octave) as f32);
        sum += height * noise_in_space(seed.wrapping_add(octave), finer);
        height *= 0.5;
    }
    sum
}
