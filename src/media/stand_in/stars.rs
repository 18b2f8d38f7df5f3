//! "Stars": a star cluster in front of brown dust.

use super::field::{fractal, mix};
use super::hash::Random;
use super::painting::{Painting, Tone};

const TONE: Tone = [(85.1, 37.0), (65.4, 34.5), (49.0, 30.2)];

/// The whole picture.
pub fn cluster(size: [usize; 2]) -> Painting {
    let mut painting = Painting::new(size, |at| {
        let dust = 0.5 + 0.5 * fractal(1, at, [3, 3], 6, 0.6);
        let grain = fractal(2, at, [96, 96], 3, 0.9);
        let tint = 0.5 + 0.5 * fractal(4, at, [10, 10], 4, 0.7);
        let light = (0.06 + 0.26 * dust + 0.08 * grain).max(0.02);
        [
            light * mix(1.1, 1.45, tint),
            light * 0.95,
            light * mix(0.8, 0.5, tint),
        ]
    });
    let mut random = Random::new(0x57a5);
    // As many as there are in a picture of 512 × 512, whatever the size.
    for star in 0..20_000 {
        let at = [random.unit(), random.unit()];
        let density = fractal(5, at, [2, 2], 3, 0.6);
        let colour = match random.bits() % 8 {
            0 => [0.9, 0.95, 1.0],
            1 | 2 => [1.0, 0.95, 0.85],
            3..6 => [1.0, 0.75, 0.38],
            _ => [1.0, 0.55, 0.3],
        };
        let (radius, light) = match star {
            0..16 => (random.between(2.5, 4.5), 0.75),
            16..60 => (random.between(1.5, 3.2), 0.5),
            _ => {
                let light = random.unit();
                (
                    random.between(0.5, 0.95),
                    0.04 + 0.5 * light * light * light,
                )
            }
        };
        if star >= 60 && random.between(-0.6, 0.9) > density {
            continue;
        }
        shine(
            &mut painting,
            at,
            radius,
            colour.map(|part| part * light),
            star < 60,
        );
    }
    painting.toned(TONE)
}

/// Adds a star, with a wide glow or without; what it reaches beyond an edge comes in at the other.
fn shine(painting: &mut Painting, at: [f32; 2], radius: f32, colour: [f32; 3], glows: bool) {
    let [width, height] = painting.size;
    let scale = width as f32 / 512.0;
    let radius = (radius * scale).max(0.3);
    let reach = (radius * if glows { 8.0 } else { 2.5 }).ceil() as i32;
    let middle = [at[0] * width as f32, at[1] * height as f32];
    for y in -reach..=reach {
        for x in -reach..=reach {
            let place = [middle[0].floor() + x as f32, middle[1].floor() + y as f32];
            let out = [0, 1].map(|i| (place[i] + 0.5 - middle[i]) / radius);
            let out = out[0] * out[0] + out[1] * out[1];
            let mut light = (-out).exp();
            if glows {
                light += 0.5 * (-out * 0.09).exp() - 0.002;
            }
            let column = (place[0] as i32).rem_euclid(width as i32) as usize;
            let row = (place[1] as i32).rem_euclid(height as i32) as usize;
            let texel = &mut painting.texels[row * width + column];
            *texel = [0, 1, 2].map(|i| texel[i] + light.max(0.0) * colour[i]);
        }
    }
}
