//! "Rusty Metal" and "Wood".

use super::field::{blend, fractal, noise, scaled, smoothstep};
use super::painting::{Painting, Tone};

const METAL: Tone = [(121.0, 16.7), (118.1, 16.6), (123.4, 20.2)];
const WOOD: Tone = [(147.4, 23.3), (79.5, 18.5), (40.7, 15.2)];

/// Blue-grey sheet metal, rust running down it.
pub fn metal(size: [usize; 2]) -> Painting {
    Painting::new(size, |at| {
        let clouds = fractal(1, at, [2, 2], 6, 0.55);
        let streaks = fractal(2, at, [12, 2], 4, 0.6);
        let grain = fractal(3, at, [128, 64], 2, 0.8);
        let sheet = scaled([0.46, 0.47, 0.54], 1.0 + 0.12 * clouds + 0.1 * grain);
        // Rust begins at the upper edge and thins out downward, and a little comes up from below.
        let height = 0.6 * (std::f32::consts::TAU * (at[1] - 0.16)).cos() - 0.5;
        let rust = smoothstep(-0.1, 0.5, height + 1.3 * clouds + 0.5 * streaks);
        let speckle = smoothstep(0.15, 0.7, fractal(5, at, [40, 40], 4, 0.7));
        let brown = blend([0.42, 0.39, 0.37], [0.62, 0.42, 0.35], speckle);
        let spots = smoothstep(0.75, 1.0, fractal(7, at, [48, 48], 3, 0.6) + 0.2 * rust);
        let bare = blend(sheet, scaled(brown, 1.0 + 0.1 * grain), rust);
        blend(bare, [0.54, 0.43, 0.38], 0.6 * spots)
    })
    .toned(METAL)
}

/// A varnished board, its grain from left to right.
pub fn wood(size: [usize; 2]) -> Painting {
    Painting::new(size, |at| {
        let waves = fractal(11, at, [2, 5], 3, 0.5);
        let bent = [at[0], at[1] + 0.008 * waves];
        let broad = fractal(12, bent, [1, 14], 4, 0.6);
        let fibres = fractal(13, bent, [6, 180], 2, 0.7);
        let streaks = fractal(17, bent, [10, 100], 3, 0.8);
        let pores = noise(14, bent, [20, 256]) + 0.6 * noise(15, bent, [40, 500]);
        let veins = smoothstep(0.55, 1.0, fractal(16, bent, [4, 56], 3, 0.6) - 0.35 * broad);
        let light = 0.56 + 0.055 * broad + 0.06 * fibres + 0.09 * pores + 0.03 * streaks;
        let board = [light, 0.55 * light - 0.02 + 0.02 * broad, 0.28 * light];
        let dark = scaled(board, 0.55);
        let pits = smoothstep(0.75, 1.1, pores + 0.3 * fibres);
        blend(blend(board, dark, 0.8 * veins), dark, 0.7 * pits)
    })
    .toned(WOOD)
}
