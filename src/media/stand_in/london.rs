//! "London": a street between two curved rows of houses, under a white sky.

use super::field::{blend, fractal, mix, scaled, smoothstep, to_whole};
use super::hash::{lattice, unit};
use super::painting::{Painting, Tone};

const TONE: Tone = [(146.5, 66.4), (135.8, 67.9), (122.7, 66.2)];

/// The road's middle is this times the squared distance to the right, in metres.
const BEND: f32 = 0.0042;

/// How far the houses are from the road's middle.
const HALF_WIDTH: f32 = 10.5;

/// How far the kerbs are.
const KERB: f32 = 6.5;

const EYE: f32 = 2.2;
const HOUSES: f32 = 19.0;
const SKY: [f32; 3] = [0.95, 0.92, 0.88];

/// The whole picture.
pub fn street(size: [usize; 2]) -> Painting {
    Painting::smooth(size, 3, |at| {
        light([(at[0] - 0.47) * 1.5, (0.6 - at[1]) * 1.5])
    })
    .toned(TONE)
}

/// What is seen along a line of sight, which goes so far right and up for each metre ahead.
fn light([right, up]: [f32; 2]) -> [f32; 3] {
    // Where the sight meets the row of houses on the left; it always does, because the street bends to the right.
    let root = (right * right + 4.0 * BEND * HALF_WIDTH).sqrt();
    let left = (right + root) / (2.0 * BEND);
    let to_right = right * right - 4.0 * BEND * HALF_WIDTH;
    let meets_right = to_right > 0.0 && right > 0.0;
    let (ahead, side) = if meets_right {
        ((right - to_right.sqrt()) / (2.0 * BEND), 1)
    } else {
        (left, 0)
    };
    let height = EYE + up * ahead;
    let haze = 1.0 - (-ahead / 190.0).exp();
    if height < 0.0 {
        let ahead = EYE / -up;
        let beside = right * ahead - BEND * ahead * ahead;
        let haze = 1.0 - (-ahead / 300.0).exp();
        return blend(ground(beside, ahead), SKY, haze);
    }
    let top = HOUSES - 0.5 + roof(ahead, side);
    if height > top {
        let cloud = fractal(1, [0.25 * right + 0.5, 0.25 * up + 0.5], [4, 4], 4, 0.5);
        return scaled(SKY, 1.0 + 0.04 * cloud - 0.05 * up.max(0.0));
    }
    if let Some(colour) = passer_by(ahead, height, side) {
        return blend(colour, SKY, 0.6 * haze);
    }
    blend(house(ahead, height, side), SKY, haze)
}

/// How much a roof stands out: balustrades, and chimneys here and there.
fn roof(along: f32, side: i32) -> f32 {
    let chimney = lattice([(along / 5.0).floor() as i32, side, 3], 5);
    let is_stack = unit(chimney) < 0.3 && (along / 5.0).fract() < 0.35;
    if is_stack { 4.0 } else { 0.0 }
}

/// A front: shops behind arches, three rows of windows, cornices.
fn house(along: f32, height: f32, side: i32) -> [f32; 3] {
    let bay = along / 3.2;
    let across = to_whole(bay - 0.5);
    // The left row lies in the shade.
    let shade = if side == 0 { 0.78 } else { 0.95 };
    let stone = scaled([0.82, 0.74, 0.62], shade);
    let dirt = fractal(7, [(along / 40.0).fract(), height / 40.0], [16, 16], 3, 0.6);
    let stone = scaled(stone, 1.0 + 0.09 * dirt);
    let dark = [0.13, 0.11, 0.1];
    if height < 5.2 {
        let arch = height < 3.4 + (0.1 - across * across).max(0.0) * 9.0 && across < 0.36;
        let number = lattice([bay.floor() as i32, side, 4], 6);
        let shop = blend(dark, [0.5, 0.38, 0.26], 0.6 * unit(number));
        return if arch { shop } else { scaled(stone, 0.8) };
    }
    let cornices: [f32; 4] = [5.5, 9.6, 16.4, 18.2];
    if let Some(below) = cornices.iter().find(|line| (height - **line).abs() < 0.35) {
        return scaled(stone, if height > *below { 1.12 } else { 0.6 });
    }
    let floor = (height - 5.8) / 3.6;
    let inside = floor.fract();
    let is_window = across < 0.2 && (0.22..0.8).contains(&inside) && height < 16.0;
    let is_frame = across < 0.28 && (0.14..0.88).contains(&inside) && height < 16.0;
    if is_window {
        let bar = to_whole(across * 5.0) < 0.06 || to_whole(inside * 3.3) < 0.05;
        let pane = lattice([bay.floor() as i32, floor as i32, side], 8);
        let glass = blend(dark, [0.4, 0.42, 0.42], 0.7 * unit(pane));
        return if bar { scaled(stone, 0.7) } else { glass };
    }
    if is_frame {
        return scaled(stone, 1.12);
    }
    // Half columns between the windows of the upper floors.
    let column = 1.0 - 0.3 * smoothstep(0.42, 0.36, across) * smoothstep(9.8, 10.0, height);
    scaled(stone, column)
}

/// People on the pavements, and a red bus: dark shapes before the houses.
fn passer_by(along: f32, height: f32, side: i32) -> Option<[f32; 3]> {
    let bus = (62.0..71.0).contains(&along) && side == 0 && height < 4.4;
    if bus {
        let is_glass = (1.4..2.2).contains(&height) || (3.0..3.8).contains(&height);
        return Some(if is_glass {
            [0.16, 0.12, 0.12]
        } else {
            [0.66, 0.1, 0.1]
        });
    }
    let place = along * 0.9;
    let bits = lattice([place.floor() as i32, side, 9], 10);
    let tall = 1.55 + 0.3 * unit(bits);
    let wide = to_whole(place - 0.5) / 0.9;
    let is_there = unit(bits.rotate_left(9)) < 0.6;
    let half = if height > tall - 0.28 { 0.1 } else { 0.24 };
    (is_there && height < tall && wide < half).then(|| {
        let cloth = unit(bits.rotate_left(17));
        let red = if cloth > 0.85 { 0.4 } else { 0.12 };
        [
            mix(0.06, red, cloth),
            mix(0.05, 0.2, cloth),
            mix(0.07, 0.24, cloth),
        ]
    })
}

/// The road with its lines, and the pavements.
fn ground(beside: f32, ahead: f32) -> [f32; 3] {
    let grain = fractal(
        11,
        [
            (beside / 32.0).rem_euclid(1.0),
            (ahead / 32.0).rem_euclid(1.0),
        ],
        [64, 32],
        3,
        0.6,
    );
    let out = beside.abs();
    let near = smoothstep(60.0, 10.0, ahead);
    if out > KERB {
        let joint = to_whole(ahead / 1.2) < 0.03 || to_whole(out / 0.9) < 0.03;
        let slab = scaled([0.56, 0.51, 0.46], 1.0 + 0.1 * grain * near);
        let rail = out < KERB + 0.12;
        return scaled(
            slab,
            if rail {
                1.25
            } else if joint {
                0.8
            } else {
                1.0
            },
        );
    }
    let road = scaled([0.46, 0.44, 0.43], 1.0 + 0.12 * grain * near);
    let lines = (out - KERB + 0.35).abs() < 0.06 || (out - KERB + 0.6).abs() < 0.06;
    if lines {
        return [0.72, 0.63, 0.36];
    }
    let dash = beside.abs() < 0.08 && (ahead / 4.0).fract() < 0.5;
    let arrow = arrow(beside + 3.2, ahead - 11.0) || arrow(beside - 3.0, ahead - 7.5);
    if dash || arrow {
        [0.86, 0.84, 0.8]
    } else {
        road
    }
}

/// An arrow painted on the road, four metres long.
fn arrow(right: f32, ahead: f32) -> bool {
    let shaft = right.abs() < 0.16 && (0.0..2.6).contains(&ahead);
    let head = (2.6..4.0).contains(&ahead) && right.abs() < 0.5 * (4.0 - ahead);
    shaft || head
}
