//! "Forest": trunks on brown ground, and a bright sky through the crowns.

use std::sync::LazyLock;

use super::cubemap::{Blur, Direction, normalized};
use super::field::{blend, fractal_in_space, noise_in_space, scaled, smoothstep};
use super::hash::Random;
use super::painting::Tone;

/// Over all six faces.
pub const TONE: Tone = [(112.9, 80.0), (111.1, 83.2), (104.6, 86.5)];

/// The blurred one.
pub const BLUR: Blur = Blur {
    doublings: 4,
    tone: [(159.0, 97.0), (155.9, 100.0), (151.2, 104.0)],
};

const EYE: f32 = 1.6;
const SKY: [f32; 3] = [4.6, 5.0, 5.3];

/// Where the evening sun is, along the ground.
const SUN: [f32; 2] = [0.6, -0.8];

/// An upright cylinder.
struct Trunk {
    at: [f32; 2],
    radius: f32,
    /// The tone of its bark.
    tone: f32,
}

static TRUNKS: LazyLock<Vec<Trunk>> = LazyLock::new(|| {
    let mut random = Random::new(0xf0e57);
    (0..70)
        .map(|i| {
            // Fewer and thicker ones stand near, and none at the eye.
            let angle = (i as f32 * 0.618_034 + random.between(0.0, 0.05)) * std::f32::consts::TAU;
            let far = 3.6 + 26.0 * (i as f32 / 70.0) + random.between(0.0, 2.5);
            Trunk {
                at: [far * angle.cos(), far * angle.sin()],
                radius: random.between(0.14, 0.42),
                tone: random.unit(),
            }
        })
        .collect()
});

/// What is seen in a direction.
pub fn light(towards: Direction) -> [f32; 3] {
    let [x, y, z] = normalized(towards);
    let flat = x.hypot(z).max(1e-5);
    let heading = [x / flat, z / flat];
    let rise = y / flat;
    let mut nearest: Option<(f32, &Trunk, f32)> = None;
    for trunk in TRUNKS.iter() {
        let along = trunk.at[0] * heading[0] + trunk.at[1] * heading[1];
        if along <= 0.0 {
            continue;
        }
        // Trunks get thinner upward, down to a third.
        let height = EYE + rise * along;
        let radius = trunk.radius
            * (1.0 - height * 0.03).clamp(0.3, 1.0)
            * (1.0 + 0.7 * smoothstep(0.7, 0.0, height));
        let beside = trunk.at[0] * heading[1] - trunk.at[1] * heading[0];
        if beside.abs() < radius && nearest.is_none_or(|(before, ..)| along < before) {
            nearest = Some((along, trunk, beside / radius));
        }
    }
    let to_ground = if rise < 0.0 { EYE / -rise } else { f32::MAX };
    if let Some((along, trunk, beside)) = nearest
        && along < to_ground
        && along * rise < 24.0
    {
        let bark = bark(trunk, beside, heading, along, EYE + rise * along);
        // Leaves hide the upper trunks in part.
        let (leaves, cover) = crowns([x, y, z], heading, rise);
        return blend(bark, leaves, 0.6 * cover * smoothstep(0.5, 1.6, rise));
    }
    if to_ground < 60.0 {
        return ground(heading[0] * to_ground, heading[1] * to_ground);
    }
    let (leaves, cover) = crowns([x, y, z], heading, rise);
    let open = sky(heading, rise);
    blend(open, leaves, cover)
}

/// How much a heading is towards the sun.
fn sunward(heading: [f32; 2]) -> f32 {
    heading[0] * SUN[0] + heading[1] * SUN[1]
}

fn bark(trunk: &Trunk, beside: f32, heading: [f32; 2], along: f32, height: f32) -> [f32; 3] {
    let turn = beside.asin();
    let grain = fractal_in_space(3, [turn * 3.0 + trunk.at[0], height * 0.8, trunk.at[1]], 4);
    let round = (1.0 - beside * beside).sqrt();
    let base = blend([0.16, 0.14, 0.11], [0.26, 0.19, 0.13], trunk.tone);
    // The low sun reaches some trunks from the side.
    let side = heading[0] * SUN[1] - heading[1] * SUN[0];
    let sun = smoothstep(0.1, 0.9, -beside * side) * smoothstep(0.55, 0.8, trunk.tone);
    let lit = blend(
        scaled(base, 0.55 + 0.5 * round),
        [0.95, 0.5, 0.14],
        0.7 * sun,
    );
    let lit = scaled(lit, 1.0 + 0.9 * grain);
    // Far trunks are paler in the light between.
    blend(lit, [0.5, 0.5, 0.42], 0.5 * smoothstep(8.0, 34.0, along))
}

/// The sky, and the dim wood where it comes down to the ground.
fn sky(heading: [f32; 2], rise: f32) -> [f32; 3] {
    let depth = noise_in_space(11, [heading[0] * 5.0, 2.0, heading[1] * 5.0]);
    let bush = noise_in_space(12, [heading[0] * 24.0, rise * 14.0, heading[1] * 24.0]);
    let thick = smoothstep(0.28, 0.04, rise + 0.1 * depth + 0.06 * bush);
    let wood = scaled([0.16, 0.18, 0.1], 1.0 + 0.6 * bush);
    let warm = smoothstep(0.6, 1.0, sunward(heading)) * smoothstep(0.8, 0.1, rise);
    let open = blend(SKY, [4.6, 3.9, 2.6], warm);
    blend(open, wood, thick)
}

/// The crowns' colour and how much they cover; they stream away from straight above.
fn crowns([x, y, z]: Direction, heading: [f32; 2], rise: f32) -> ([f32; 3], f32) {
    let around = [heading[0] * 7.0, heading[1] * 7.0];
    let out = (1.0 - y).sqrt() * 5.0;
    let boughs = noise_in_space(21, [around[0], out, around[1]]);
    let leaves = fractal_in_space(22, [x * 13.0, y * 13.0, z * 13.0], 4);
    let twigs = noise_in_space(27, [heading[0] * 22.0, out * 2.0, heading[1] * 22.0]);
    let gaps = 0.3 * smoothstep(0.9, 0.2, y) * noise_in_space(28, [x * 2.2, y * 2.2, z * 2.2]);
    let dense = 0.5 * boughs + 1.3 * leaves + 0.35 * twigs - gaps - 0.1;
    let low = smoothstep(0.15, 0.4, rise);
    let cover = smoothstep(0.0, 0.16, dense) * low;
    let green = scaled([0.2, 0.23, 0.18], 1.0 + 0.8 * leaves);
    let warm = smoothstep(0.5, 1.0, sunward(heading)) * smoothstep(0.9, 0.3, y);
    (blend(green, [0.36, 0.24, 0.06], 0.6 * warm), cover)
}

/// Leaf litter.
fn ground(x: f32, z: f32) -> [f32; 3] {
    let far = x.hypot(z);
    let litter = fractal_in_space(31, [x * 7.0, 0.5, z * 7.0], 4);
    let patches = fractal_in_space(32, [x * 0.7, 3.5, z * 0.7], 4);
    let leaf = smoothstep(
        0.1,
        0.5,
        fractal_in_space(33, [x * 11.0, 7.5, z * 11.0], 3) * 1.6,
    );
    let base = blend([0.15, 0.12, 0.08], [0.24, 0.19, 0.14], 0.5 + patches);
    let lit = blend(base, [0.4, 0.34, 0.22], 0.55 * leaf);
    // The sun lies on the ground in stripes.
    let stripe = noise_in_space(34, [(x * SUN[1] - z * SUN[0]) * 0.8, 0.0, 0.0]);
    let sun = smoothstep(0.25, 0.8, stripe) * smoothstep(2.0, 12.0, far);
    let lit = blend(lit, [0.62, 0.36, 0.12], 0.4 * sun);
    scaled(lit, (1.0 + 0.9 * litter).max(0.2))
}
