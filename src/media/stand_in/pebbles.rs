//! "Pebbles": how high a bed of round stones is.

use super::field::{around, fractal, smoothstep};
use super::hash::Random;
use super::painting::{Painting, Tone};

const TONE: Tone = [(94.3, 39.9); 3];

struct Pebble {
    middle: [f32; 2],
    radius: f32,
    /// How much longer than wide, and which way.
    stretch: f32,
    turn: [f32; 2],
    height: f32,
}

/// Large stones that hardly overlap, and ever more smaller ones that lie between and under them.
fn scattered() -> Vec<Pebble> {
    let mut random = Random::new(0x0bb1e);
    let mut pebbles: Vec<Pebble> = Vec::new();
    let kinds = [
        (0.085, 90, 0.85),
        (0.06, 260, 0.8),
        (0.045, 500, 0.72),
        (0.032, 900, 0.66),
        (0.02, 2200, 0.6),
        (0.012, 2500, 0.6),
    ];
    for (radius, tries, apart) in kinds {
        for _ in 0..tries {
            let middle = [random.unit(), random.unit()];
            let radius = radius * random.between(0.75, 1.3);
            let is_free = pebbles.iter().all(|other| {
                let x = around(middle[0], other.middle[0]);
                let y = around(middle[1], other.middle[1]);
                let least = apart * (radius + other.radius);
                x * x + y * y > least * least
            });
            let angle = random.between(0.0, std::f32::consts::TAU);
            let stretch = random.between(1.0, 1.45);
            let lift = random.unit();
            if is_free {
                pebbles.push(Pebble {
                    middle,
                    radius,
                    stretch,
                    turn: [angle.cos(), angle.sin()],
                    height: 2.6 * radius + 0.3 * lift * lift * smoothstep(0.01, 0.05, radius),
                });
            }
        }
    }
    pebbles
}

/// The whole picture.
pub fn heights(size: [usize; 2]) -> Painting {
    let [width, height] = size;
    let bend = |at: [f32; 2]| [1, 2].map(|seed| 0.008 * fractal(seed, at, [10, 10], 2, 0.5));
    let mut painting = Painting::new(size, |at| [0.1 * fractal(3, at, [5, 5], 3, 0.5); 3]);
    for pebble in scattered() {
        // Each stone rises out of the ground where its middle is.
        let foot = 0.1 * fractal(3, pebble.middle, [5, 5], 3, 0.5);
        let [cos, sin] = pebble.turn;
        let reach = pebble.radius * 1.3 + 0.012;
        let [wide, high] = [width, height].map(|extent| (reach * extent as f32).ceil() as i32);
        let [column, row] = [
            (pebble.middle[0] * width as f32) as i32,
            (pebble.middle[1] * height as f32) as i32,
        ];
        for y in row - high..=row + high {
            for x in column - wide..=column + wide {
                let at = [
                    (x as f32 + 0.5) / width as f32,
                    (y as f32 + 0.5) / height as f32,
                ];
                let bent = bend(at);
                let away = [0, 1].map(|i| at[i] + bent[i] - pebble.middle[i]);
                let along = (away[0] * cos + away[1] * sin) / pebble.stretch.sqrt();
                let beside = (away[1] * cos - away[0] * sin) * pebble.stretch.sqrt();
                let out = (along * along + beside * beside) / (pebble.radius * pebble.radius);
                if out < 1.0 {
                    let dome = (1.0 - out).sqrt() * (1.0 - 0.25 * out);
                    let [x, y] = [x.rem_euclid(width as i32), y.rem_euclid(height as i32)];
                    let texel = &mut painting.texels[y as usize * width + x as usize];
                    *texel = texel.map(|before| before.max(foot + dome * pebble.height));
                }
            }
        }
    }
    painting.toned(TONE)
}
