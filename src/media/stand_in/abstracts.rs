//! "Abstract 1" to "Abstract 3".

use super::field::{around, blend, cells, fractal, noise, scaled, smoothstep};
use super::hash::{Random, lattice, unit};
use super::painting::{Painting, Tone};

const GLASS: Tone = [(62.9, 52.5), (70.4, 57.4), (54.6, 52.0)];
const STRAW: Tone = [(122.7, 53.5), (102.2, 48.8), (78.1, 41.9)];
const SMEARS: Tone = [(130.4, 36.1), (118.7, 35.0), (105.9, 35.2)];

/// One piece of glass.
struct Stone {
    middle: [f32; 2],
    radius: f32,
    colour: [f32; 3],
    seed: u32,
}

/// Pieces of glass that keep clear of each other, large ones first.
fn stones() -> Vec<Stone> {
    const COLOURS: [[f32; 3]; 6] = [
        [0.16, 0.5, 0.36],
        [0.25, 0.58, 0.52],
        [0.27, 0.32, 0.46],
        [0.2, 0.55, 0.4],
        [0.33, 0.38, 0.44],
        [0.35, 0.34, 0.2],
    ];
    let mut random = Random::new(0x91a55);
    let mut stones: Vec<Stone> = Vec::new();
    for (radius, tries) in [(0.15, 12), (0.1, 20), (0.07, 60), (0.045, 90), (0.018, 60)] {
        for _ in 0..tries {
            let middle = [random.unit(), random.unit()];
            let radius = radius * random.between(0.8, 1.2);
            let colour = COLOURS[random.bits() as usize % COLOURS.len()];
            // The two greatest are nearly white.
            let colour = if stones.len() < 2 {
                [0.8, 0.84, 0.74]
            } else {
                colour
            };
            let seed = random.bits();
            let is_free = stones.iter().all(|other| {
                let x = around(middle[0], other.middle[0]);
                let y = around(middle[1], other.middle[1]);
                x.hypot(y) > 1.05 * (radius + other.radius)
            });
            if is_free {
                stones.push(Stone {
                    middle,
                    radius,
                    colour,
                    seed,
                });
            }
        }
    }
    stones
}

/// Pieces of coloured glass in dark resin.
pub fn glass(size: [usize; 2]) -> Painting {
    let stones = stones();
    Painting::new(size, |at| {
        let bent = [
            at[0] + 0.034 * fractal(1, at, [5, 5], 3, 0.45),
            at[1] + 0.034 * fractal(2, at, [5, 5], 3, 0.45),
        ];
        // How far outside the nearest piece, in shares of its radius.
        let (mut nearest, mut out) = (None, f32::MAX);
        for stone in &stones {
            let x = around(stone.middle[0], bent[0]);
            let y = around(stone.middle[1], bent[1]);
            let beyond = x.hypot(y) - stone.radius;
            if beyond < out {
                out = beyond;
                nearest = Some((stone, [x, y]));
            }
        }
        let clouds = 0.5 + 0.5 * fractal(3, at, [4, 4], 5, 0.55);
        let veins = cells(4, [bent[0], bent[1]], [8, 8]);
        let vein = smoothstep(0.12, 0.0, veins.second - veins.nearest);
        let glow = smoothstep(0.3, 0.9, 0.5 + 0.6 * fractal(5, at, [2, 2], 2, 0.5));
        let resin = blend(
            [0.1, 0.08, 0.03],
            [0.36, 0.34, 0.16],
            clouds * (0.4 + 0.6 * glow),
        );
        let resin = scaled(resin, 1.0 - 0.6 * vein);
        let Some((stone, [x, y])) = nearest else {
            return resin;
        };
        let rim = smoothstep(0.016, 0.004, out.abs());
        let inside = smoothstep(0.0, -0.004, out);
        let depth = (-out / stone.radius).clamp(0.0, 1.0);
        let cracks = cells(stone.seed, bent, [14, 14]);
        let crack = smoothstep(0.05, 0.0, cracks.second - cracks.nearest)
            * smoothstep(-0.1, 0.5, noise(6, at, [7, 7]));
        // Light from the upper left, and a bright spot where it gathers at the lower right.
        let side = (x + y) / stone.radius;
        let spot =
            (-6.0 * ((x / stone.radius - 0.25).powi(2) + (y / stone.radius - 0.3).powi(2))).exp();
        let shade = 0.35 + 0.6 * depth.sqrt() + 0.15 * side + 0.35 * (clouds - 0.5) - 0.3 * crack;
        let lit = blend(
            scaled(stone.colour, shade.max(0.05)),
            [0.95, 1.0, 0.9],
            0.5 * spot * spot,
        );
        scaled(blend(resin, lit, inside), 1.0 - 0.92 * rim)
    })
    .toned(GLASS)
}

/// A loose weave of straw.
pub fn straw(size: [usize; 2]) -> Painting {
    let [width, height] = size;
    let mut painting = Painting::new(size, |at| {
        scaled(
            [0.2, 0.15, 0.1],
            1.0 + 0.5 * fractal(11, at, [32, 32], 3, 0.7),
        )
    });
    let mut random = Random::new(0x57a3);
    let scale = width as f32 / 512.0;
    for stalk in 0..620 {
        let is_upright = stalk % 2 == 0;
        let length = if is_upright { height } else { width };
        // They lie in bundles.
        let bundle = unit(lattice([(random.bits() % 34) as i32, stalk % 2, 0], 0xb0));
        let place = bundle + random.between(-0.016, 0.016) + 0.2 * random.unit() * random.unit();
        let half = random.between(0.7, 1.9) * scale;
        let light = random.between(0.35, 1.35);
        let redness = random.between(0.9, 1.05);
        let seed = random.bits();
        // A stalk shows for a part of its way: elsewhere others lie over it.
        let (from, share) = (random.unit(), random.between(0.25, 0.95));
        let steps = (share * length as f32) as usize;
        for step in 0..steps {
            let along = (from + step as f32 / length as f32).fract();
            let sway = 0.014 * noise(seed, [along, 0.5], [3, 1]);
            let across =
                (place + sway).rem_euclid(1.0) * if is_upright { width } else { height } as f32;
            let taper = smoothstep(0.0, 0.06, step.min(steps - step) as f32 / steps as f32);
            let sheen = light * (1.0 + 0.25 * noise(seed ^ 1, [along, 0.5], [40, 1]));
            let reach = half.ceil() as i32 + 1;
            for side in -reach..=reach {
                let texel = across.floor() + side as f32;
                let out = (texel + 0.5 - across) / half;
                let cover = taper * smoothstep(1.0 + 0.6 / half, 1.0 - 0.2 / half, out.abs());
                let round = (1.0 - 0.3 * out * out - 0.25 * out).max(0.2) * sheen;
                let beside = (texel as i32)
                    .rem_euclid(if is_upright { width } else { height } as i32)
                    as usize;
                let down = (along * length as f32) as usize % length;
                let at = if is_upright {
                    down * width + beside
                } else {
                    beside * width + down
                };
                let colour = scaled([0.66, 0.53 * redness, 0.36 * redness], round);
                painting.texels[at] = blend(painting.texels[at], colour, cover);
            }
        }
    }
    painting.toned(STRAW)
}

/// Soft smears in beige, blue and brown, drawn downward.
pub fn smears(size: [usize; 2]) -> Painting {
    Painting::new(size, |at| {
        let broad = fractal(21, at, [3, 3], 4, 0.5);
        let blue = smoothstep(0.0, 0.55, fractal(24, at, [3, 4], 4, 0.5) - 0.1 * broad);
        let brown = smoothstep(0.15, 0.65, fractal(27, at, [4, 3], 4, 0.5));
        let streaks = fractal(31, at, [26, 4], 2, 0.5);
        let pale = 0.5 + 0.5 * fractal(34, at, [12, 6], 3, 0.5);
        let body = blend([0.54, 0.42, 0.34], [0.66, 0.58, 0.5], pale);
        let body = blend(
            body,
            blend([0.27, 0.29, 0.31], [0.52, 0.57, 0.6], pale),
            blue,
        );
        let body = blend(body, [0.25, 0.2, 0.17], 0.8 * brown);
        scaled(body, 1.0 + 0.24 * streaks + 0.2 * broad)
    })
    .toned(SMEARS)
}
