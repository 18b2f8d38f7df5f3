//! "St. Peter's Basilica": a crossing of two vaulted aisles under a dome, with windows and a floor that shines.

use super::cubemap::{Blur, Direction, normalized};
use super::field::{blend, fractal_in_space, noise_in_space, scaled, smoothstep, to_whole};
use super::painting::Tone;

/// Over all six faces.
pub const TONE: Tone = [(133.5, 61.0), (84.5, 47.7), (70.7, 43.2)];

/// The blurred one.
pub const BLUR: Blur = Blur {
    doublings: 6,
    tone: [(149.9, 55.0), (103.9, 62.0), (91.5, 64.0)],
};

const EYE: f32 = 1.7;
/// Half the aisles' width, where their vaults begin, and how long they are from the crossing.
const HALF_WIDTH: f32 = 7.0;
const SPRING: f32 = 13.0;
const LENGTH: f32 = 42.0;
const LAMP: [f32; 3] = [9.0, 8.6, 8.4];

/// What is seen in a direction.
pub fn light(towards: Direction) -> [f32; 3] {
    let [x, y, z] = normalized(towards);
    if y >= -1e-4 {
        return above([x, y, z], [0.0, 0.0]);
    }
    let to_ground = EYE / -y;
    let at = [x * to_ground, z * to_ground];
    let far = at[0].hypot(at[1]);
    let inside = at[0].abs() < HALF_WIDTH || at[1].abs() < HALF_WIDTH;
    if !inside || at[0].abs() > LENGTH || at[1].abs() > LENGTH {
        return above([x, y, z], [0.0, 0.0]);
    }
    // Polished marble: the flatter the sight, the more it mirrors.
    let mirrored = above([x, -y, z], at);
    let share = 0.03 + 0.3 * (1.0 + y).powi(3);
    let mirrored = mirrored.map(|part| part.min(3.0));
    blend(floor(at, far), mirrored, share)
}

/// What a sight from somewhere on the floor meets above it.
fn above([x, y, z]: Direction, from: [f32; 2]) -> [f32; 3] {
    // The walls beside the aisle in which the sight goes out.
    let is_along_x = x.abs() > z.abs();
    let (along, across) = if is_along_x { (x, z) } else { (z, x) };
    let (start, side) = if is_along_x {
        (from[0], from[1])
    } else {
        (from[1], from[0])
    };
    let side = side.clamp(-HALF_WIDTH, HALF_WIDTH);
    let to_side = if across.abs() < 1e-5 {
        f32::MAX
    } else {
        (HALF_WIDTH - side * across.signum()) / across.abs()
    };
    let to_end = ((LENGTH - start * along.signum()) / along.abs().max(1e-5)).max(0.0);
    let nearest = to_side.min(to_end);
    let eye = if from == [0.0, 0.0] && y.abs() < 1.0 {
        EYE
    } else {
        0.0
    };
    let height = eye + y * nearest;
    if height > SPRING {
        return vault([x, y, z], is_along_x);
    }
    let end = [x > 0.0, z > 0.0];
    if to_end < to_side {
        return far_end(side + across * nearest, height, is_along_x, end);
    }
    wall(start + along * nearest, height, is_along_x, across > 0.0)
}

const STONE: [f32; 3] = [0.47, 0.29, 0.24];

/// A wall with pilasters and niches.
fn wall(along: f32, height: f32, is_along_x: bool, is_right: bool) -> [f32; 3] {
    let seed = u32::from(is_along_x) * 2 + u32::from(is_right);
    let dirt = fractal_in_space(seed, [along * 0.7, height * 0.7, seed as f32 * 7.3], 5);
    // The further from the dome, the darker, with light from each chapel between.
    let dim = 1.0 - 0.35 * smoothstep(7.0, 30.0, along.abs());
    let stone = scaled(STONE, (1.0 + 0.45 * dirt) * dim);
    let bay = along.abs() / 7.0;
    let out = to_whole(bay) * 7.0;
    if (SPRING - height).abs() < 1.3 {
        return scaled(stone, 0.6 + 0.7 * to_whole(height * 1.2));
    }
    if out < 1.0 {
        let flute = to_whole(out * 3.0) < 0.14;
        return scaled(stone, if flute { 0.8 } else { 1.25 });
    }
    let middle = to_whole(bay - 0.5) * 7.0;
    let arch = middle < 1.7 && height < 6.2 + (2.9 - middle * middle).max(0.0).sqrt();
    if arch {
        // Windows of the chapels on one side of each aisle let light in.
        let is_bright = is_along_x != is_right && height > 3.0 && middle < 1.1;
        let statue = middle < 0.6 && height < 4.0;
        return match (is_bright && along.abs() > 8.0, statue) {
            (true, _) => LAMP,
            (false, true) => scaled(stone, 0.95),
            _ => scaled(stone, 0.28),
        };
    }
    let panel = (middle - 2.1).abs() < 0.12 || (height - 9.0).abs() < 0.15;
    scaled(stone, if panel { 1.35 } else { 0.85 })
}

/// What closes an aisle: an altar under a dark canopy, or an apse with windows.
fn far_end(across: f32, height: f32, is_along_x: bool, end: [bool; 2]) -> [f32; 3] {
    let dirt = fractal_in_space(9, [across, height, f32::from(is_along_x)], 4);
    let stone = scaled(STONE, 0.8 + 0.4 * dirt);
    if !is_along_x && end[1] {
        let post = (across.abs() - 3.0).abs() < 0.45 && height < 11.0;
        let roof = across.abs() < 4.0 && (9.5..12.0).contains(&height);
        let candle = to_whole(across * 1.1) < 0.16 && (1.6..2.3).contains(&height);
        return if candle {
            scaled(LAMP, 0.3)
        } else if post || roof {
            [0.08, 0.05, 0.04]
        } else {
            scaled(stone, 0.6)
        };
    }
    let window =
        across.abs() < 2.4 && (5.0..10.5).contains(&height) && to_whole(across / 2.0) > 0.08;
    if window { LAMP } else { stone }
}

/// The coffered vaults with their lights, and the dome straight above.
fn vault([x, y, z]: Direction, is_along_x: bool) -> [f32; 3] {
    let flat = [x / y.max(1e-4), z / y.max(1e-4)];
    let out = flat[0].hypot(flat[1]);
    let gold = [0.62, 0.42, 0.26];
    if out < 0.42 {
        // The dome: a lantern, ribs and a ring of windows.
        let around = flat[1].atan2(flat[0]) / std::f32::consts::TAU;
        if out < 0.05 {
            return LAMP;
        }
        let rib = to_whole(around * 16.0) < 0.1;
        let ring = (0.31..0.37).contains(&out);
        if ring && to_whole(around * 16.0 - 0.5) < 0.22 {
            return scaled(LAMP, 0.25);
        }
        let shade = 0.55 + 0.9 * out;
        return scaled(gold, if rib { 1.3 * shade } else { shade });
    }
    if out < 0.5 {
        return scaled([0.75, 0.6, 0.46], 0.6 + 1.5 * to_whole(out * 30.0));
    }
    let (along, across) = if is_along_x {
        (flat[0], flat[1])
    } else {
        (flat[1], flat[0])
    };
    if across.abs() < 0.44 && along.abs() > 0.5 {
        // A row of windows along each vault's crown.
        let lamp =
            to_whole(along.abs().ln() * 2.2) < 0.16 && across.abs() < 0.1 * along.abs().min(2.0);
        if lamp && along.abs() < 6.0 {
            return LAMP;
        }
        let coffer = to_whole(along.abs().ln() * 8.0).min(to_whole(across * 12.0)) < 0.13;
        return scaled(gold, if coffer { 0.75 } else { 0.32 });
    }
    // The pillars' crowns between the aisles.
    let worn = noise_in_space(12, [flat[0] * 6.0, 1.0, flat[1] * 6.0]);
    scaled(STONE, 0.6 + 0.35 * worn)
}

/// Marble in circles and frames.
fn floor(at: [f32; 2], far: f32) -> [f32; 3] {
    let veins = fractal_in_space(15, [at[0] * 1.3, 0.5, at[1] * 1.3], 5);
    let pale = scaled([0.66, 0.44, 0.36], 1.0 + 0.3 * veins);
    let dark = scaled([0.24, 0.12, 0.1], 1.0 + 0.6 * veins);
    let grey = scaled([0.42, 0.34, 0.31], 1.0 + 0.3 * veins);
    let box_out = at[0].abs().max(at[1].abs() * 1.3);
    if box_out < 1.25 {
        // The emblem straight below.
        let bow = (at[0].hypot(at[1] * 1.2) - 0.42 - 0.16 * (5.0 * at[1].atan2(at[0])).cos()).abs();
        return if bow < 0.1 { pale } else { dark };
    }
    if box_out < 1.4 {
        return pale;
    }
    if box_out < 1.9 {
        return grey;
    }
    // Further out: discs in a net of bands.
    let cell = [at[0] / 4.2, at[1] / 4.2].map(|part| part - part.round());
    let disc = cell[0].hypot(cell[1]);
    let band = cell[0].abs().max(cell[1].abs()) > 0.45;
    let fine = smoothstep(40.0, 15.0, far);
    let inner = if disc < 0.2 {
        dark
    } else if disc < 0.25 {
        pale
    } else if disc < 0.34 {
        grey
    } else if band {
        dark
    } else {
        pale
    };
    blend(scaled([0.5, 0.32, 0.27], 1.0), inner, fine)
}
