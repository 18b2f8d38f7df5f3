//! "Organic 1" to "Organic 4".

use super::field::{blend, cells, fractal, noise, ridges, scaled, smoothstep};
use super::hash::unit;
use super::painting::{Painting, Tone, each_texel, slopes};

const BARK: Tone = [(142.2, 50.7), (122.4, 51.1), (89.6, 48.2)];
const RUST: Tone = [(105.0, 61.6), (69.2, 51.3), (50.8, 40.0)];
const GRANITE: Tone = [(116.2, 29.2), (113.5, 28.6), (109.5, 29.7)];
const MARBLE: Tone = [(148.3, 31.2), (117.2, 31.8), (104.1, 31.6)];

/// The middle of a texel in the unit square.
fn middle([width, height]: [usize; 2], x: usize, y: usize) -> [f32; 2] {
    [(x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32]
}

/// A picture with a relief: light falls on heights, and a colour is asked for each place, its height and its light.
fn carved(
    size: [usize; 2],
    height: impl Fn([f32; 2]) -> f32 + Sync,
    colour: impl Fn([f32; 2], f32, f32) -> [f32; 3] + Sync,
) -> Painting {
    let heights = each_texel(size, |x, y| height(middle(size, x, y)));
    let light = slopes(size, &heights);
    let texels = each_texel(size, |x, y| {
        let at = y * size[0] + x;
        colour(middle(size, x, y), heights[at], light[at])
    });
    Painting { size, texels }
}

/// A place moved about by noise.
fn bent(seed: u32, at: [f32; 2], n: [i32; 2], far: f32, octaves: u32) -> [f32; 2] {
    [
        at[0] + far * fractal(seed, at, n, octaves, 0.5),
        at[1] + far * fractal(seed + 50, at, n, octaves, 0.5),
    ]
}

/// Pale bark: cracks across it, and round scars with dark hearts.
pub fn bark(size: [usize; 2]) -> Painting {
    let crack = |at: [f32; 2]| {
        let moved = bent(21, at, [6, 6], 0.03, 4);
        // A crack runs where noise passes through 0, and only in parts of the picture.
        let line = fractal(22, moved, [2, 9], 3, 0.5).abs();
        let opens = smoothstep(-0.25, 0.6, noise(25, at, [3, 7]));
        let twigs = cells(26, bent(27, at, [12, 12], 0.02, 3), [9, 7]);
        let twig = smoothstep(0.05, 0.0, twigs.second - twigs.nearest)
            * smoothstep(0.2, 0.7, noise(28, at, [4, 4]));
        (smoothstep(0.1, 0.0, line) * opens).max(0.8 * twig)
    };
    let scar = |at: [f32; 2]| {
        let spot = cells(31, bent(32, at, [16, 16], 0.008, 2), [13, 13]);
        let is_there = unit(spot.bits) < 0.55 + 0.4 * noise(34, at, [3, 3]);
        let heart = if is_there { smoothstep(0.22, 0.05, spot.nearest) } else { 0.0 };
        let rim = if is_there { smoothstep(0.12, 0.0, (spot.nearest - 0.36).abs()) } else { 0.0 };
        (heart, rim)
    };
    carved(
        size,
        |at| {
            let (heart, rim) = scar(at);
            0.02 * fractal(35, at, [10, 14], 6, 0.65) - 0.02 * crack(at) - 0.008 * heart + 0.006 * rim
        },
        |at, height, light| {
            let (heart, rim) = scar(at);
            let patch = smoothstep(-0.5, 0.6, fractal(41, at, [2, 3], 5, 0.6));
            let tan = blend([0.42, 0.33, 0.18], [0.7, 0.63, 0.5], patch);
            let green = smoothstep(0.2, 0.8, fractal(44, at, [3, 3], 4, 0.6));
            let tan = blend(tan, [0.5, 0.5, 0.34], 0.5 * green);
            let lit = scaled(tan, (1.0 + 0.22 * light + 4.0 * height).max(0.1));
            let dark = (0.9 * crack(at)).max(0.75 * heart);
            blend(blend(lit, [0.74, 0.68, 0.55], 0.35 * rim), [0.1, 0.08, 0.05], dark)
        },
    )
    .toned(BARK)
}

/// Glowing brown and orange, eaten through with dark holes.
pub fn rust(size: [usize; 2]) -> Painting {
    let holes = |at: [f32; 2]| {
        let small = cells(51, bent(52, at, [20, 20], 0.006, 2), [38, 38]);
        let crowded = 0.5 + 0.6 * fractal(53, at, [4, 4], 3, 0.6);
        let size = unit(small.bits);
        if size < crowded { smoothstep(0.12 + 0.3 * size, 0.05, small.nearest) } else { 0.0 }
    };
    carved(
        size,
        |at| {
            let lumps = cells(55, bent(56, at, [6, 6], 0.03, 3), [14, 14]);
            0.03 * (1.0 - lumps.nearest) + 0.016 * fractal(57, at, [12, 12], 4, 0.6)
                - 0.012 * holes(at)
        },
        |at, height, light| {
            let warm = 0.5 + 0.55 * fractal(61, at, [4, 4], 4, 0.6);
            let body = blend([0.2, 0.09, 0.05], [0.72, 0.48, 0.3], warm.clamp(0.0, 1.0));
            let shade = (0.85 + 0.45 * light + 12.0 * (height - 0.015)).max(0.05);
            let glow = smoothstep(0.5, 1.5, light + 0.8 * warm);
            let lit = blend(scaled(body, shade), [0.98, 0.74, 0.56], 0.6 * glow);
            let violet = smoothstep(0.35, 0.9, fractal(65, at, [7, 7], 3, 0.6));
            let lit = blend(lit, scaled([0.5, 0.42, 0.46], shade), 0.6 * violet);
            blend(lit, [0.03, 0.015, 0.02], 0.95 * holes(at))
        },
    )
    .toned(RUST)
}

/// Weathered stone in greys, blues and browns.
pub fn granite(size: [usize; 2]) -> Painting {
    carved(
        size,
        |at| {
            0.011 * ridges(71, bent(72, at, [8, 8], 0.02, 3), [14, 20], 6)
                + 0.007 * fractal(73, at, [40, 48], 4, 0.75)
        },
        |at, height, light| {
            let brown = smoothstep(-0.4, 0.6, fractal(81, at, [3, 4], 5, 0.65));
            let pale = smoothstep(0.1, 0.8, fractal(84, at, [5, 5], 6, 0.7));
            let stone = blend([0.4, 0.45, 0.5], [0.47, 0.43, 0.36], brown);
            let stone = blend(stone, [0.62, 0.58, 0.52], 0.7 * pale);
            let speckle = fractal(87, at, [160, 160], 2, 0.9);
            let hollow = smoothstep(0.004, -0.003, height - 0.004);
            let lit = scaled(stone, (1.0 + 0.16 * light + 0.1 * speckle).max(0.1));
            blend(lit, [0.2, 0.2, 0.19], 0.6 * hollow)
        },
    )
    .toned(GRANITE)
}

/// Rosy marble full of eddies.
pub fn marble(size: [usize; 2]) -> Painting {
    let flow = |at: [f32; 2]| {
        let once = bent(91, at, [3, 3], 0.12, 4);
        let twice = bent(93, once, [4, 4], 0.1, 4);
        let wave = fractal(95, twice, [6, 6], 5, 0.6);
        (wave, once)
    };
    carved(
        size,
        |at| {
            let (wave, _) = flow(at);
            0.006 * (9.0 * wave).sin() + 0.008 * wave + 0.003 * fractal(96, at, [60, 60], 3, 0.75)
        },
        |at, _, light| {
            let (wave, once) = flow(at);
            let band = 0.5 + 0.5 * (7.0 * wave).sin();
            let brown = smoothstep(-0.3, 0.7, fractal(97, once, [2, 2], 4, 0.55));
            let body = blend([0.56, 0.43, 0.42], [0.55, 0.4, 0.28], brown);
            let body = blend(body, [0.68, 0.58, 0.52], 0.6 * band);
            let violet = smoothstep(0.2, 0.7, fractal(98, once, [3, 3], 4, 0.55));
            let body = blend(body, [0.42, 0.32, 0.36], 0.6 * violet);
            let grain = fractal(99, at, [200, 200], 2, 0.9);
            scaled(body, (1.0 + 0.11 * light + 0.05 * grain).max(0.1))
        },
    )
    .toned(MARBLE)
}
