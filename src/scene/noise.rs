//! The noise texture that ShaderToy code knows as "RGBA Noise Medium", made rather than copied.

/// Width and height of [`noise_texture`] in texels.
pub const NOISE_SIZE: u32 = 256;

/// How far one channel is shifted against the next: one step in z of the 3D noise that shaders read
/// out of this texture.
const SHIFT: (u32, u32) = (37, 17);

/// A 256 × 256 texture of white noise, four bytes a texel, row 0 first; the same on every machine.
///
/// The channels are related so that the usual 3D noise from a 2D texture is continuous in z:
/// `G(x + 37, y + 17) = R(x, y)` and `A(x + 37, y + 17) = B(x, y)`, wrapping around. R and B are
/// independent, and each holds every byte value exactly 256 times.
pub fn noise_texture() -> Vec<u8> {
    let red = shuffled_bytes(0x5eed_0001);
    let blue = shuffled_bytes(0x5eed_0002);
    let texels = (NOISE_SIZE * NOISE_SIZE) as usize;
    let mut rgba = Vec::with_capacity(4 * texels);
    for y in 0..NOISE_SIZE {
        for x in 0..NOISE_SIZE {
            let here = index(x, y);
            let behind = index(x + NOISE_SIZE - SHIFT.0, y + NOISE_SIZE - SHIFT.1);
            rgba.extend([red[here], red[behind], blue[here], blue[behind]]);
        }
    }
    rgba
}

fn index(x: u32, y: u32) -> usize {
    ((y % NOISE_SIZE) * NOISE_SIZE + x % NOISE_SIZE) as usize
}

/// Every byte value equally often, in an order that `seed` decides (a Fisher–Yates shuffle).
fn shuffled_bytes(seed: u64) -> Vec<u8> {
    let count = NOISE_SIZE * NOISE_SIZE;
    let mut bytes: Vec<u8> = (0..count).map(|i| (i % 256) as u8).collect();
    let mut state = seed;
    for i in (1..count as usize).rev() {
        let pick = (split_mix(&mut state) % (i as u64 + 1)) as usize;
        bytes.swap(i, pick);
    }
    bytes
}

/// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texel(rgba: &[u8], x: u32, y: u32) -> [u8; 4] {
        let at = 4 * index(x, y);
        rgba[at..at + 4].try_into().unwrap()
    }

    #[test]
    fn each_channel_is_the_shifted_neighbour_of_another() {
        let rgba = noise_texture();
        for y in 0..NOISE_SIZE {
            for x in 0..NOISE_SIZE {
                let [r, _, b, _] = texel(&rgba, x, y);
                let [_, g, _, a] = texel(&rgba, x + SHIFT.0, y + SHIFT.1);
                assert_eq!((g, a), (r, b), "at {x}, {y}");
            }
        }
    }

    #[test]
    fn every_value_is_equally_frequent_in_every_channel() {
        let rgba = noise_texture();
        for channel in 0..4 {
            let mut histogram = [0; 256];
            for texel in rgba.chunks(4) {
                histogram[usize::from(texel[channel])] += 1;
            }
            assert!(histogram.iter().all(|&n| n == 256), "channel {channel}");
        }
    }

    #[test]
    fn neighbours_and_channels_are_uncorrelated() {
        let rgba = noise_texture();
        let at = |x, y, c: usize| f64::from(texel(&rgba, x, y)[c]) - 127.5;
        for (dx, dy, from, to) in [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 0, 2), (0, 0, 0, 1)] {
            let mut sum = 0.0;
            for y in 0..NOISE_SIZE {
                for x in 0..NOISE_SIZE {
                    sum += at(x, y, from) * at(x + dx, y + dy, to);
                }
            }
            let variance = (256.0 * 256.0 - 1.0) / 12.0;
            let correlation = sum / f64::from(NOISE_SIZE * NOISE_SIZE) / variance;
            assert!(
                correlation.abs() < 0.016,
                "{correlation}: four standard deviations"
            );
        }
    }

    #[test]
    fn the_bytes_are_the_same_everywhere() {
        let fnv = noise_texture()
            .iter()
            .fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
                (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
            });
        assert_eq!(fnv, 0xedba_0e2d_f5a0_4629, "FNV-1a of the texture");
    }

    /// The seed's `noise3D`, as the GPU evaluates it with linear filtering.
    fn noise_3d(rgba: &[u8], x: [f64; 3]) -> f64 {
        let p = x.map(f64::floor);
        let f = [0, 1, 2]
            .map(|i| x[i] - p[i])
            .map(|f| f * f * (3.0 - 2.0 * f));
        let uv = [p[0] + 37.0 * p[2] + f[0], p[1] + 17.0 * p[2] + f[1]];
        let cell = uv.map(f64::floor);
        let t = [uv[0] - cell[0], uv[1] - cell[1]];
        let bilinear = |channel: usize| {
            let at = |dx: i64, dy: i64| {
                let wrap = |v: f64, d: i64| (v as i64 + d).rem_euclid(256) as u32;
                f64::from(texel(rgba, wrap(cell[0], dx), wrap(cell[1], dy))[channel]) / 255.0
            };
            let low = at(0, 0) + (at(1, 0) - at(0, 0)) * t[0];
            let high = at(0, 1) + (at(1, 1) - at(0, 1)) * t[0];
            low + (high - low) * t[1]
        };
        let (r, g) = (bilinear(0), bilinear(1));
        g + (r - g) * f[2]
    }

    #[test]
    fn the_3d_noise_is_continuous_across_whole_z() {
        let rgba = noise_texture();
        for z in -300..300 {
            for (x, y) in [(0.3, 0.7), (-5.5, 100.25), (255.9, 255.1)] {
                let below = noise_3d(&rgba, [x, y, f64::from(z) - 1e-6]);
                let above = noise_3d(&rgba, [x, y, f64::from(z) + 1e-6]);
                assert!(
                    (below - above).abs() < 1e-6,
                    "z = {z}: {below} then {above}"
                );
            }
        }
    }
}
