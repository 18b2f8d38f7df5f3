//! Cubemaps from what is seen in each direction, sharp and blurred. Faces meet without a seam, because nothing but the
//! direction counts.

use super::painting::{Painting, Tone, each_texel, tone_texels};

/// A direction, y up. It has no particular length.
pub type Direction = [f32; 3];

/// How a blurred cubemap is made.
pub struct Blur {
    /// Doublings of the cosine's power that light is weighted with: the more, the sharper.
    pub doublings: u32,
    /// What it looks like over all six faces.
    pub tone: Tone,
}

/// The direction of a place on a face, which goes from (−1, −1) in its upper left corner to (1, 1): OpenGL's table.
/// The upper row is the first one.
pub fn direction(face: usize, [s, t]: [f32; 2]) -> Direction {
    match face {
        0 => [1.0, -t, -s],
        1 => [-1.0, -t, s],
        2 => [s, 1.0, t],
        3 => [s, -1.0, -t],
        4 => [s, -t, 1.0],
        _ => [-s, -t, -1.0],
    }
}

/// A direction with the length 1.
pub fn normalized([x, y, z]: Direction) -> Direction {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

/// The six faces in one column.
fn faces(size: usize, n: usize, light: impl Fn(Direction) -> [f32; 3] + Sync) -> Painting {
    let seen = |[x, y]: [f32; 2]| {
        let face = ((y * 6.0) as usize).min(5);
        let inside = [x, y * 6.0 - face as f32].map(|part| 2.0 * part - 1.0);
        light(direction(face, inside))
    };
    Painting::smooth([size, 6 * size], n, seen)
}

/// A cubemap of what `light` sees.
pub fn sharp(size: usize, tone: Tone, light: fn(Direction) -> [f32; 3]) -> Vec<u8> {
    faces(size, 2, light).toned(tone).rgba()
}

/// A blurred one: what a rough surface with that normal reflects. Lamps count with their full brightness.
pub fn blurred(size: usize, blur: &Blur, light: fn(Direction) -> [f32; 3]) -> Vec<u8> {
    let coarse = size.div_ceil(4);
    let middle = |x: usize, y: usize, size: usize| {
        let place = [x, y % size].map(|at| (2 * at + 1) as f32 / size as f32 - 1.0);
        (y / size, place)
    };
    // The light of each coarse texel, and how much of the sphere it is.
    let sources = each_texel([coarse, 6 * coarse], |x, y| {
        let (face, place) = middle(x, y, coarse);
        let towards = direction(face, place);
        let length = towards.iter().map(|part| part * part).sum::<f32>().sqrt();
        let mut sum = [0.0; 3];
        for sample in 0..36 {
            let shift = [sample % 6, sample / 6].map(|i| (i as f32 - 2.5) / 3.0 / coarse as f32);
            let found = light(direction(face, [place[0] + shift[0], place[1] + shift[1]]));
            sum = [0, 1, 2].map(|i| sum[i] + found[i] / 36.0);
        }
        (normalized(towards), sum, length.powi(-3))
    });
    let mut texels = each_texel([size, 6 * size], |x, y| {
        let (face, place) = middle(x, y, size);
        let normal = normalized(direction(face, place));
        let (mut sum, mut all) = ([0.0; 3], 0.0);
        for (towards, light, share) in &sources {
            let cosine = normal[0] * towards[0] + normal[1] * towards[1] + normal[2] * towards[2];
            let mut weight = cosine.max(0.0);
            for _ in 0..blur.doublings {
                weight *= weight;
            }
            weight *= share;
            all += weight;
            sum = [0, 1, 2].map(|i| sum[i] + weight * light[i]);
        }
        sum.map(|part| part / all)
    });
    tone_texels(&mut texels, blur.tone);
    Painting {
        size: [size, 6 * size],
        texels,
    }
    .rgba()
}

#[cfg(test)]
mod tests {
    use super::super::{basilica, forest, gallery};
    use super::*;

    #[test]
    fn faces_meet_at_all_edges() {
        // Each face's four edges, three places on each: some other face has the same direction there.
        let edge = |at: f32| [[at, -1.0], [at, 1.0], [-1.0, at], [1.0, at]];
        for face in 0..6 {
            for place in [-0.5, 0.0, 0.5].into_iter().flat_map(edge) {
                let here = direction(face, place);
                let elsewhere = (0..6).filter(|&other| other != face).any(|other| {
                    [-0.5, 0.0, 0.5]
                        .into_iter()
                        .flat_map(edge)
                        .any(|place| direction(other, place) == here)
                });
                assert!(elsewhere, "face {face} at {place:?}");
            }
        }
    }

    /// The same as what GL's table gives for a direction: face, s and t from 0 to 1.
    fn looked_up([x, y, z]: Direction) -> (usize, [f32; 2]) {
        let (face, sc, tc, ma) = if x.abs() >= y.abs() && x.abs() >= z.abs() {
            if x > 0.0 {
                (0, -z, -y, x)
            } else {
                (1, z, -y, -x)
            }
        } else if y.abs() >= z.abs() {
            if y > 0.0 {
                (2, x, z, y)
            } else {
                (3, x, -z, -y)
            }
        } else if z > 0.0 {
            (4, x, -y, z)
        } else {
            (5, -x, -y, -z)
        };
        (face, [sc, tc].map(|part| (part / ma + 1.0) / 2.0))
    }

    #[test]
    fn directions_are_those_of_gl() {
        for face in 0..6 {
            let (found, [s, t]) = looked_up(direction(face, [0.5, -0.25]));
            assert_eq!((found, s, t), (face, 0.75, 0.375));
        }
    }

    #[test]
    fn neighbouring_texels_on_two_faces_are_alike() {
        let n = 16;
        for light in [forest::light, gallery::light, basilica::light] {
            let blur = Blur {
                doublings: 3,
                tone: forest::BLUR.tone,
            };
            let bytes = blurred(n, &blur, light);
            let texel = |face: usize, x: usize, y: usize| bytes[4 * ((face * n + y) * n + x)];
            let most = (0..6 * n * (n - 1))
                .map(|at| (at / (n * (n - 1)), at % (n - 1), at / (n - 1) % n))
                .map(|(face, x, y)| {
                    let across = texel(face, x, y).abs_diff(texel(face, x + 1, y));
                    across.max(texel(face, y, x).abs_diff(texel(face, y, x + 1)))
                })
                .max();
            for at in 0..n {
                // +Z's right edge is +X's left one, and +Z's upper edge is +Y's lower one.
                assert!(Some(texel(4, n - 1, at).abs_diff(texel(0, 0, at))) <= most);
                assert!(Some(texel(4, at, 0).abs_diff(texel(2, at, n - 1))) <= most);
            }
        }
    }
}
