//! White noise: every texel and every channel a number of its own.

use super::hash::{lattice, mixed};
use crate::scene;

/// One channel of noise for so many texels.
pub fn gray(texels: usize, seed: u32) -> Vec<u8> {
    (0..texels)
        .map(|at| (lattice([at as i32, 0, 0], seed) >> 24) as u8)
        .collect()
}

/// Four independent channels.
pub fn rgba(texels: usize, seed: u32) -> Vec<u8> {
    gray(4 * texels, seed)
}

/// "RGBA Noise Medium": green is red and alpha is blue, 37 texels further right and 17 further down, which shaders rely
/// on for noise in three dimensions.
pub fn rgba_medium() -> Vec<u8> {
    scene::noise_texture()
}

/// "RGBA Noise Small": as on the site, alpha is blue one texel further left, and all else is independent.
pub fn rgba_small(size: usize, seed: u32) -> Vec<u8> {
    let mut bytes = rgba(size * size, mixed(seed));
    for row in bytes.chunks_mut(4 * size) {
        for x in 0..size {
            row[4 * x + 3] = row[4 * ((x + 1) % size) + 2];
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texel(bytes: &[u8], size: usize, x: usize, y: usize) -> &[u8] {
        &bytes[4 * (y % size * size + x % size)..][..4]
    }

    #[test]
    fn green_is_red_37_to_the_right_and_17_down() {
        let bytes = rgba_medium();
        for (x, y) in [(0, 0), (200, 250), (255, 1), (219, 239)] {
            let here = texel(&bytes, 256, x, y);
            let there = texel(&bytes, 256, x + 37, y + 17);
            assert_eq!((here[0], here[2]), (there[1], there[3]), "at {x}, {y}");
        }
    }

    #[test]
    fn the_small_one_has_blue_in_alpha_one_to_the_left() {
        let bytes = rgba_small(64, 1);
        for (x, y) in [(0, 0), (63, 0), (20, 40), (63, 63)] {
            let here = texel(&bytes, 64, x, y);
            assert_eq!(here[3], texel(&bytes, 64, x + 1, y)[2], "at {x}, {y}");
        }
    }

    #[test]
    fn all_values_are_about_equally_frequent_and_neighbours_unrelated() {
        let bytes = gray(256 * 256, 7);
        let mut histogram = [0; 256];
        for &byte in &bytes {
            histogram[usize::from(byte)] += 1;
        }
        assert!(
            histogram.iter().all(|count| (180..340).contains(count)),
            "{histogram:?}"
        );
        let product = |pair: &[u8]| (f64::from(pair[0]) - 127.5) * (f64::from(pair[1]) - 127.5);
        let sum: f64 = bytes.windows(2).map(product).sum();
        assert!((sum / 65535.0 / 5461.0).abs() < 0.016);
    }
}
