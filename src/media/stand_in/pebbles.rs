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

/// The stones of one size and more of each smaller one, scattered so that they hardly overlap.
fn scattered() -> Vec<Pebble> {
    let mut random = Random::new(0x0bb1e);
    let mut pebbles: Vec<Pebble> = Vec::new();
    for (radius, tries) in [(0.1, 40), (0.07, 120), (0.05, 300), (0.033, 700), (0.02, 900)] {
        for _ in 0..tries {
            let middle = [random.unit(), random.unit()];
            let radius = radius * random.between(0.8, 1.15);
            let is_free = pebbles.iter().all(|other| {
                let x = around(middle[0], other.middle[0]);
                let y = around(middle[1], other.middle[1]);
                x.hypot(y) > 0.86 * (radius + other.radius)
            });
            let angle = random.between(0.0, std::f32::consts::TAU);
            let stretch = random.between(1.0, 1.3);
            let lift = random.between(0.6, 1.2);
            if is_free {
                pebbles.push(Pebble {
                    middle,
                    radius,
                    stretch,
                    turn: [angle.cos(), angle.sin()],
                    height: lift * (0.25 + 5.0 * radius),
                });
            }
        }
    }
    pebbles
}

/// The whole picture.
pub fn heights(size: [usize; 2]) -> Painting {
    let pebbles = scattered();
    Painting::new(size, |at| {
        let bent = [
            at[0] + 0.006 * fractal(1, at, [8, 8], 2, 0.5),
            at[1] + 0.006 * fractal(2, at, [8, 8], 2, 0.5),
        ];
        let ground = 0.12 + 0.05 * fractal(3, at, [6, 6], 3, 0.5);
        let mut height = ground;
        for pebble in &pebbles {
            let x = around(pebble.middle[0], bent[0]);
            let y = around(pebble.middle[1], bent[1]);
            let reach = pebble.radius * 1.2;
            if x.abs() > reach || y.abs() > reach {
                continue;
            }
            let [cos, sin] = pebble.turn;
            let along = (x * cos + y * sin) / pebble.stretch.sqrt();
            let beside = (y * cos - x * sin) * pebble.stretch.sqrt();
            let out = (along * along + beside * beside) / (pebble.radius * pebble.radius);
            let dome = (1.0 - out * out).max(0.0).sqrt();
            height = height.max(ground + dome * pebble.height * smoothstep(1.0, 0.8, out));
        }
        [height; 3]
    })
    .toned(TONE)
}
