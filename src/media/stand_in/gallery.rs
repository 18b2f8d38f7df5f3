//! "Uffizi Gallery": a long courtyard along x between two high fronts, and a strip of white sky.

use super::cubemap::{Blur, Direction};
use super::field::{blend, fractal_in_space, noise_in_space, scaled, smoothstep, to_whole};
use super::hash::{lattice, unit};
use super::painting::Tone;

/// Over all six faces.
pub const TONE: Tone = [(124.5, 52.0), (118.8, 52.7), (120.9, 52.4)];

/// The blurred one.
pub const BLUR: Blur = Blur {
    doublings: 6,
    tone: [(74.8, 70.0), (70.0, 70.7), (71.7, 70.8)],
};

const EYE: f32 = 1.7;
const HALF_WIDTH: f32 = 9.0;
const ROOF: f32 = 25.0;
/// How far off the courtyard ends, towards +x with a house over an arch, towards −x with a tower beyond.
const ENDS: [f32; 2] = [62.0, 70.0];
const SKY: [f32; 3] = [5.0, 5.0, 5.1];

/// What is seen in a direction.
pub fn light([x, y, z]: Direction) -> [f32; 3] {
    let to_side = HALF_WIDTH / z.abs().max(1e-6);
    let end = ENDS[usize::from(x < 0.0)];
    let to_end = end / x.abs().max(1e-6);
    let to_ground = if y < 0.0 { EYE / -y } else { f32::MAX };
    let nearest = to_side.min(to_end);
    if to_ground < nearest {
        return paving([x * to_ground, z * to_ground]);
    }
    let height = EYE + y * nearest;
    if to_side < to_end {
        if height > ROOF + 0.8 {
            return beyond([x, y, z]);
        }
        return front(x * nearest, height, z > 0.0);
    }
    if x > 0.0 && height < ROOF - 6.0 {
        let across = z * nearest;
        let arch = across.abs() < 2.6 && height < 6.0 + (6.8 - across * across).max(0.0).sqrt();
        return if arch {
            [0.75, 0.73, 0.72]
        } else {
            front(across, height, true)
        };
    }
    beyond([x, y, z])
}

/// The sky, and far off towards −x a tower before it.
fn beyond([x, y, z]: Direction) -> [f32; 3] {
    if x < 0.0 {
        let (across, up) = ((z / x).abs(), y / -x);
        let half = if (0.52..0.6).contains(&up) {
            0.05
        } else {
            0.036
        };
        if across < half && up < 0.68 {
            let stripe = to_whole(up * 30.0) < 0.1;
            return scaled([0.62, 0.57, 0.53], if stripe { 0.8 } else { 1.0 });
        }
        if up < 0.2 {
            return [0.6, 0.57, 0.56];
        }
    }
    SKY
}

/// One of the long fronts: a colonnade, and three floors of windows above it.
fn front(along: f32, height: f32, is_north: bool) -> [f32; 3] {
    let side = i32::from(is_north);
    let dirt = fractal_in_space(1, [along * 0.6, height * 0.6, side as f32 * 9.5], 4);
    let stone = scaled([0.47, 0.44, 0.455], 1.0 + 0.3 * dirt);
    let plaster = scaled([0.66, 0.63, 0.64], 1.0 + 0.15 * dirt);
    let bay = along / 3.4;
    let across = to_whole(bay);
    let wide_bay = to_whole(along / 10.2);
    if height < 0.9 {
        // Steps.
        return scaled(stone, 0.75 + 0.25 * to_whole(height * 3.0 + 0.5));
    }
    if height < 6.6 {
        // Pillars with niches, two columns between them, and the dark hall behind.
        let pillar = wide_bay * 10.2 < 0.95;
        let niche = wide_bay * 10.2 < 0.42 && (2.0..4.6).contains(&height);
        if niche {
            let statue = to_whole(along / 10.2) * 10.2 < 0.22 && height < 4.0;
            return if statue {
                [0.55, 0.53, 0.53]
            } else {
                [0.14, 0.13, 0.13]
            };
        }
        if pillar {
            return scaled(stone, 0.95);
        }
        let out = across * 3.4;
        if out < 0.34 {
            return scaled(stone, 1.15 - 1.2 * out);
        }
        let depth = noise_in_space(2, [along * 0.8, height * 1.2, 3.0]);
        let door = unit(lattice([bay.floor() as i32, side, 0], 3)) < 0.3 && height < 3.6;
        return scaled(
            [0.09, 0.08, 0.085],
            if door { 2.2 } else { 1.0 + 0.6 * depth },
        );
    }
    let above = height - 6.6;
    let bands: [f32; 6] = [0.5, 3.0, 4.2, 9.6, 10.8, 17.6];
    if bands.iter().any(|band| (above - band).abs() < 0.3) {
        return scaled(stone, 1.3);
    }
    if bands
        .iter()
        .any(|band| (0.3..0.6).contains(&(band - above)))
    {
        return scaled(stone, 0.45);
    }
    let rows: [(f32, f32); 3] = [(1.0, 2.6), (5.0, 8.6), (11.8, 16.0)];
    for (low, high) in rows {
        if (low..high).contains(&above) {
            let out = (to_whole(bay - 0.5)) * 3.4;
            if out < 0.62 && above > low + 0.2 && above < high - 0.5 {
                let bars = to_whole(out * 1.6) < 0.06 || to_whole(above * 1.1) < 0.05;
                let pane = unit(lattice([bay.floor() as i32, low as i32, side], 4));
                let glass = scaled([0.16, 0.155, 0.17], 0.6 + 0.9 * pane);
                return if bars { scaled(stone, 0.8) } else { glass };
            }
            if out < 0.95 {
                return scaled(stone, 1.05);
            }
        }
    }
    if above > 18.0 {
        // The eaves, in their own shadow but for the beams' ends.
        return scaled(
            stone,
            if to_whole(along * 1.3) < 0.2 {
                0.9
            } else {
                0.45
            },
        );
    }
    let pier = smoothstep(0.12, 0.08, across);
    blend(plaster, stone, pier)
}

/// Slabs laid askew, some darker and some damp.
fn paving([x, z]: [f32; 2]) -> [f32; 3] {
    let turned = [(x + z) * 0.75, (x - z) * 0.75];
    let course = turned[1].floor();
    let along = turned[0] + 0.5 * course;
    let slab = unit(lattice([along.floor() as i32, course as i32, 7], 5));
    let joint = to_whole(along).min(to_whole(turned[1]));
    let far = x.hypot(z);
    // Far off, joints are finer than a texel and even out.
    let clear = smoothstep(40.0, 4.0, far);
    let wear = fractal_in_space(6, [x * 1.7, z * 1.7, 0.5], 5);
    let damp = smoothstep(0.0, 0.35, fractal_in_space(7, [x * 0.35, z * 0.35, 2.5], 4));
    let base = 0.44 + 0.07 * (slab - 0.5) * clear + 0.1 * wear - 0.05 * damp;
    let shade = if joint < 0.035 {
        1.0 - 0.25 * clear
    } else {
        1.0
    };
    // The fronts keep light from what lies near them.
    let open = smoothstep(HALF_WIDTH * 1.1, HALF_WIDTH * 0.4, z.abs());
    scaled([1.03, 0.975, 0.99], base * shade * (0.85 + 0.2 * open))
}
