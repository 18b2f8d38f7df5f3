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
    [
        (x as f32 + 0.5) / width as f32,
        (y as f32 + 0.5) / height as f32,
    ]
}

/// A picture with a relief: light falls on heights, and a colour is asked for each place and its light.
///
/// What was found on the way to a height is handed on to the colour.
fn carved<const N: usize>(
    size: [usize; 2],
    height: impl Fn([f32; 2]) -> (f32, [f32; N]) + Sync,
    colour: impl Fn([f32; 2], [f32; N], f32) -> [f32; 3] + Sync,
) -> Painting
where
    [f32; N]: Default,
{
    let found = each_texel(size, |x, y| height(middle(size, x, y)));
    let heights: Vec<f32> = found.iter().map(|(height, _)| *height).collect();
    let light = slopes(size, &heights);
    let texels = each_texel(size, |x, y| {
        let at = y * size[0] + x;
        colour(middle(size, x, y), found[at].1, light[at])
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
        let moved = bent(21, at, [6, 8], 0.025, 3);
        // A crack runs where noise passes through 0, and only in parts of the picture.
        let line = fractal(22, moved, [2, 9], 2, 0.5).abs();
        let opens = smoothstep(-0.2, 0.5, noise(25, at, [3, 7]));
        let twigs = cells(26, moved, [9, 8]);
        let twig = smoothstep(0.04, 0.0, twigs.second - twigs.nearest)
            * smoothstep(0.0, 0.6, noise(28, at, [4, 5]));
        (smoothstep(0.06, 0.0, line) * opens).max(0.8 * twig)
    };
    carved(
        size,
        |at| {
            let crack = crack(at);
            let ragged = noise(31, at, [28, 28]);
            let spot = cells(32, [at[0] + 0.006 * ragged, at[1]], [15, 15]);
            let is_there = unit(spot.bits) < 0.5 + 0.6 * noise(34, at, [3, 3]);
            let heart = smoothstep(0.3 + 0.15 * ragged, 0.02, spot.nearest) * f32::from(is_there);
            let rough = fractal(35, at, [20, 28], 5, 0.7);
            (
                0.011 * rough - 0.012 * crack - 0.005 * heart,
                [crack, heart, rough],
            )
        },
        |at, [crack, heart, rough], light| {
            let patch = smoothstep(-0.5, 0.5, fractal(41, at, [2, 3], 5, 0.65));
            let tan = blend([0.48, 0.4, 0.26], [0.68, 0.61, 0.48], patch);
            let green = smoothstep(0.1, 0.7, fractal(44, at, [4, 4], 3, 0.6));
            let tan = blend(tan, [0.5, 0.49, 0.36], 0.5 * green);
            let lit = scaled(tan, (1.0 + 0.2 * light + 0.14 * rough).max(0.1));
            // Soot lies in specks, more of them on dark patches.
            let soot = smoothstep(
                0.3,
                0.95,
                fractal(46, at, [56, 56], 3, 0.75) + 0.3 - 0.3 * patch,
            );
            let dark = (0.9 * crack).max(0.75 * heart).max(0.65 * soot);
            blend(lit, [0.1, 0.08, 0.05], dark)
        },
    )
    .toned(BARK)
}

/// Glowing brown and orange, eaten through with dark holes.
pub fn rust(size: [usize; 2]) -> Painting {
    carved(
        size,
        |at| {
            let moved = bent(52, at, [14, 14], 0.008, 3);
            let crowded = 0.5 + 0.6 * fractal(53, at, [4, 4], 3, 0.6);
            let hole = |seed: u32, n: i32, most: f32| {
                let hole = cells(seed, moved, [n, n]);
                let size = unit(hole.bits);
                smoothstep(0.1 + 0.4 * size, 0.05, hole.nearest) * f32::from(size < most * crowded)
            };
            let holes = hole(51, 46, 0.9).max(hole(54, 20, 0.6));
            let lump = 1.0 - cells(55, moved, [13, 13]).nearest;
            let rough = fractal(57, at, [16, 16], 5, 0.62);
            (
                0.012 * lump + 0.012 * rough - 0.008 * holes,
                [holes, lump, rough],
            )
        },
        |at, [holes, lump, rough], light| {
            let warm = 0.5 + 0.7 * fractal(61, at, [5, 5], 4, 0.65);
            let body = blend([0.2, 0.09, 0.05], [0.66, 0.44, 0.28], warm.clamp(0.0, 1.0));
            let shade = (0.6 + 0.3 * light + 0.5 * lump + 0.3 * rough).max(0.05);
            let glow = smoothstep(0.9, 2.0, shade + warm);
            let lit = blend(scaled(body, shade), [0.95, 0.76, 0.6], 0.7 * glow);
            let gray = smoothstep(0.2, 0.9, fractal(65, at, [7, 7], 3, 0.6));
            let lit = blend(lit, scaled([0.4, 0.36, 0.37], shade), 0.7 * gray);
            blend(lit, [0.02, 0.012, 0.015], 0.95 * holes)
        },
    )
    .toned(RUST)
}

/// Weathered stone in greys, blues and browns.
pub fn granite(size: [usize; 2]) -> Painting {
    carved(
        size,
        |at| {
            let moved = bent(72, at, [6, 9], 0.02, 2);
            let ridge = ridges(71, moved, [8, 14], 5);
            let rough = fractal(73, at, [36, 48], 4, 0.8);
            (0.01 * ridge + 0.006 * rough, [ridge, rough])
        },
        |at, [ridge, rough], light| {
            let brown = smoothstep(-0.5, 0.6, fractal(81, at, [3, 4], 6, 0.75));
            let pale = smoothstep(-0.1, 0.9, fractal(84, at, [5, 5], 6, 0.75));
            let stone = blend([0.39, 0.42, 0.445], [0.45, 0.42, 0.38], brown);
            let stone = blend(stone, [0.66, 0.63, 0.6], 0.75 * pale);
            let hollow = smoothstep(0.62, 0.32, ridge + 0.16 * rough);
            let lit = scaled(stone, (1.0 + 0.17 * light + 0.12 * rough).max(0.1));
            blend(lit, [0.24, 0.24, 0.23], 0.4 * hollow)
        },
    )
    .toned(GRANITE)
}

/// Rosy marble full of eddies.
pub fn marble(size: [usize; 2]) -> Painting {
    carved(
        size,
        |at| {
            let once = bent(91, at, [3, 3], 0.1, 3);
            let twice = bent(93, once, [7, 7], 0.035, 3);
            let wave = fractal(95, twice, [6, 6], 5, 0.62);
            let rough = fractal(96, at, [40, 40], 4, 0.8);
            (
                0.0035 * (6.0 * wave).sin() + 0.004 * rough,
                [wave, rough, once[0], once[1]],
            )
        },
        |at, [wave, rough, x, y], light| {
            let band = 0.5 + 0.5 * (5.0 * wave).sin();
            let brown = smoothstep(-0.2, 0.8, fractal(97, [x, y], [2, 2], 4, 0.6));
            let body = blend([0.58, 0.46, 0.43], [0.52, 0.4, 0.32], brown);
            let body = blend(body, [0.68, 0.59, 0.55], 0.5 * band);
            let violet = smoothstep(0.1, 0.7, fractal(98, [x, y], [3, 3], 4, 0.6));
            let body = blend(body, [0.42, 0.34, 0.35], 0.6 * violet);
            let cloud = fractal(99, at, [5, 5], 4, 0.7);
            scaled(
                body,
                (1.0 + 0.1 * light + 0.06 * rough + 0.12 * cloud).max(0.1),
            )
        },
    )
    .toned(MARBLE)
}
