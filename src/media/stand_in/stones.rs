//! "Rock Tiles" and "Lichen".

use super::field::{around, blend, cells, fractal, noise, scaled, smoothstep};
use super::hash::{Random, unit};
use super::painting::{Painting, Tone, each_texel, slopes};

const TILES: Tone = [(153.3, 26.2), (127.6, 27.8), (114.8, 26.3)];
const LICHEN: Tone = [(80.0, 50.8), (85.2, 50.6), (79.5, 52.2)];

/// The wall is made of this many units across and down.
const UNITS: usize = 12;

/// Which stone covers each unit of the wall: its left upper unit, its size, and a number of its own.
type Wall = Vec<([usize; 2], [usize; 2], u32)>;

/// Rectangles of a few sizes, that fill a wall which goes on around its edges.
fn wall() -> Wall {
    let mut random = Random::new(0x7115);
    let mut taken = [[false; UNITS]; UNITS];
    let mut wall = Vec::new();
    for sizes in [
        &[[4, 4], [4, 3], [3, 4]][..],
        &[[3, 2], [2, 3], [3, 3]],
        &[[2, 2], [3, 2], [2, 1]],
    ] {
        for _ in 0..90 {
            let at = [0, 1].map(|_| random.bits() as usize % UNITS);
            let size = sizes[random.bits() as usize % sizes.len()];
            place(&mut taken, &mut wall, at, size, random.bits());
        }
    }
    // What is left is filled with whatever fits.
    for size in [[3, 1], [1, 3], [2, 1], [1, 2], [1, 1]] {
        for at in 0..UNITS * UNITS {
            place(
                &mut taken,
                &mut wall,
                [at % UNITS, at / UNITS],
                size,
                random.bits(),
            );
        }
    }
    wall
}

fn place(
    taken: &mut [[bool; UNITS]; UNITS],
    wall: &mut Wall,
    at: [usize; 2],
    size: [usize; 2],
    bits: u32,
) {
    let units = || {
        (0..size[0] * size[1]).map(|unit| {
            [
                (at[0] + unit % size[0]) % UNITS,
                (at[1] + unit / size[0]) % UNITS,
            ]
        })
    };
    if units().all(|[x, y]| !taken[y][x]) {
        units().for_each(|[x, y]| taken[y][x] = true);
        wall.push((at, size, bits));
    }
}

/// A wall of hewn stones with pale mortar.
pub fn tiles(size: [usize; 2]) -> Painting {
    let wall = wall();
    // How far inside a stone, in units, and which.
    let stone = |at: [f32; 2]| {
        let bent = [
            at[0] + 0.004 * fractal(1, at, [12, 12], 3, 0.6),
            at[1] + 0.004 * fractal(2, at, [12, 12], 3, 0.6),
        ];
        let mut found = (f32::MIN, 0);
        for &(corner, extent, bits) in &wall {
            let inside = [0, 1].map(|i| {
                let half = extent[i] as f32 / 2.0;
                let middle = (corner[i] as f32 + half) / UNITS as f32;
                half - UNITS as f32 * around(middle, bent[i]).abs()
            });
            let inside = inside[0].min(inside[1]);
            if inside > found.0 {
                found = (inside, bits);
            }
        }
        found
    };
    let at = |x: usize, y: usize| {
        [
            (x as f32 + 0.5) / size[0] as f32,
            (y as f32 + 0.5) / size[1] as f32,
        ]
    };
    let found = each_texel(size, |x, y| stone(at(x, y)));
    let heights = each_texel(size, |x, y| {
        let (inside, bits) = found[y * size[0] + x];
        let face = smoothstep(0.04, 0.22, inside);
        // Each stone breaks in facets of its own.
        let facets = cells(bits, at(x, y), [9, 9]);
        let rough = fractal(bits ^ 5, at(x, y), [16, 16], 5, 0.6);
        face * (0.008 + 0.014 * facets.nearest + 0.012 * rough)
    });
    let light = slopes(size, &heights);
    let texels = each_texel(size, |x, y| {
        let index = y * size[0] + x;
        let (inside, bits) = found[index];
        let clouds = fractal(bits ^ 9, at(x, y), [4, 4], 4, 0.6);
        let tan = blend(
            [0.57, 0.465, 0.44],
            [0.615, 0.505, 0.395],
            unit(bits) + 0.5 * clouds,
        );
        let tan = scaled(
            tan,
            0.85 + 0.25 * unit(bits.rotate_left(13)) + 0.12 * clouds,
        );
        let grain = fractal(6, at(x, y), [128, 128], 2, 0.8);
        let lit = scaled(tan, (1.0 + 0.2 * light[index] + 0.05 * grain).max(0.2));
        let dark = smoothstep(0.02, 0.0, (inside - 0.12).abs()) * 0.35;
        let mortar = scaled([0.66, 0.56, 0.53], 1.0 + 0.06 * grain);
        scaled(
            blend(mortar, lit, smoothstep(0.06, 0.12, inside)),
            1.0 - dark,
        )
    });
    Painting { size, texels }.toned(TILES)
}

/// Dark layered rock with lichen on it.
pub fn lichen(size: [usize; 2]) -> Painting {
    let at = |x: usize, y: usize| {
        [
            (x as f32 + 0.5) / size[0] as f32,
            (y as f32 + 0.5) / size[1] as f32,
        ]
    };
    let bent = |at: [f32; 2]| {
        // The layers rise a little to the right.
        let sway = 0.05 * fractal(11, at, [2, 2], 3, 0.5);
        [at[0] + 0.4 * sway, at[1] + sway]
    };
    // Lichen grows in colonies of small lobes.
    let growth = |at: [f32; 2]| {
        let colony = smoothstep(0.36, 0.75, fractal(12, at, [4, 4], 3, 0.55));
        let lobes = cells(
            14,
            [at[0] + 0.006 * noise(15, at, [40, 40]), at[1]],
            [110, 110],
        );
        let spread = smoothstep(0.6, 0.3, lobes.nearest + 0.5 * (1.0 - colony));
        (spread * smoothstep(0.05, 0.3, colony), unit(lobes.bits))
    };
    let heights = each_texel(size, |x, y| {
        let here = bent(at(x, y));
        let layers = fractal(21, here, [3, 11], 5, 0.62);
        let cracks = 1.0 - smoothstep(0.0, 0.3, fractal(24, here, [3, 16], 4, 0.55).abs());
        let (grown, _) = growth(at(x, y));
        0.035 * layers - 0.014 * cracks
            + 0.008 * fractal(27, here, [30, 50], 3, 0.75)
            + 0.006 * grown
    });
    let light = slopes(size, &heights);
    let texels = each_texel(size, |x, y| {
        let index = y * size[0] + x;
        let here = bent(at(x, y));
        let clouds = 0.5 + 0.7 * fractal(31, here, [3, 5], 5, 0.62);
        let rock = blend(
            [0.12, 0.14, 0.135],
            [0.44, 0.46, 0.44],
            clouds.clamp(0.0, 1.0),
        );
        let deep = smoothstep(-0.004, -0.028, heights[index]);
        let lit = scaled(rock, (1.0 + 0.3 * light[index]).max(0.03));
        let lit = scaled(lit, 1.0 - 0.75 * deep);
        let (grown, kind) = growth(at(x, y));
        // Some of it is yellow, in a few places.
        let yellow = smoothstep(0.45, 0.6, noise(34, at(x, y), [3, 3]));
        let pale = blend([0.36, 0.42, 0.39], [0.74, 0.78, 0.75], kind);
        let pale = blend(pale, [0.6, 0.64, 0.25], 0.8 * yellow);
        let pale = scaled(pale, (0.85 + 0.3 * light[index]).clamp(0.15, 1.3));
        blend(lit, pale, 0.85 * grown)
    });
    Painting { size, texels }.toned(LICHEN)
}
