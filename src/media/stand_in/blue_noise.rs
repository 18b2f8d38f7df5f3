//! Noise whose low frequencies are all but gone: neighbours differ as much as they can.
//!
//! White noise is filtered and its histogram made flat again, in turns. The void-and-cluster method would take minutes for
//! a picture of this size.

use std::thread;

use super::hash::{lattice, unit};

/// Turns of filtering and flattening. More of them change little.
const ROUNDS: usize = 8;

/// The blur that is taken away, as weights of the texels 0, 1, 2 and more away: Gaussian with the deviation 1.5.
const WEIGHTS: [f32; 6] = [
    0.265_963, 0.212_967, 0.109_341, 0.035_994, 0.007_597, 0.001_028,
];

/// Four independent channels for a square that tiles.
pub fn rgba(size: usize, seed: u32) -> Vec<u8> {
    let channels: Vec<Vec<u8>> = thread::scope(|scope| {
        let running: Vec<_> = (0..4)
            .map(|channel| scope.spawn(move || gray(size, seed + channel)))
            .collect();
        let joined = running.into_iter().map(thread::ScopedJoinHandle::join);
        joined
            .map(|channel| channel.expect("it does not panic"))
            .collect()
    });
    (0..size * size)
        .flat_map(|at| [0, 1, 2, 3].map(|channel: usize| channels[channel][at]))
        .collect()
}

/// One channel: every value equally often.
pub fn gray(size: usize, seed: u32) -> Vec<u8> {
    let mut values: Vec<f32> = (0..size * size)
        .map(|at| unit(lattice([at as i32, 0, 0], seed)))
        .collect();
    for round in 1..=ROUNDS {
        let smooth = blurred(size, &values);
        for (value, smooth) in values.iter_mut().zip(&smooth) {
            *value -= smooth;
        }
        if round < ROUNDS {
            flatten_roughly(&mut values);
        } else {
            flatten(&mut values);
        }
    }
    let count = values.len() as f32;
    values
        .iter()
        .map(|value| ((value * count) as usize * 256 / (size * size)) as u8)
        .collect()
}

/// Replaces each value by the share of values in the bins below its own, which is quick.
fn flatten_roughly(values: &mut [f32]) {
    const BINS: usize = 1 << 14;
    // Values lie between −1 and 1.
    let bin = |value: f32| ((value + 1.0) * (BINS / 2) as f32) as usize % BINS;
    let mut below = vec![0_u32; BINS];
    for &value in &*values {
        below[bin(value)] += 1;
    }
    let mut sum = 0;
    for count in &mut below {
        (*count, sum) = (sum, sum + *count);
    }
    for value in &mut *values {
        *value = below[bin(*value)] as f32 / sum as f32;
    }
}

/// Replaces each value by its rank, from 0 to just below 1.
fn flatten(values: &mut [f32]) {
    let mut order: Vec<u64> = (0_u64..)
        .zip(&*values)
        .map(|(at, &value)| {
            // Values lie between −1 and 1, so that these 32 bits sort as they do.
            let height = ((value + 2.0) * 1_073_741_824.0) as u64;
            height << 32 | at
        })
        .collect();
    order.sort_unstable();
    let count = values.len() as f32;
    for (rank, entry) in order.iter().enumerate() {
        values[(entry & 0xffff_ffff) as usize] = (rank as f32 + 0.5) / count;
    }
}

/// A blur that wraps around.
fn blurred(size: usize, values: &[f32]) -> Vec<f32> {
    let reach = WEIGHTS.len() - 1;
    let mut across = vec![0.0; values.len()];
    let mut row = vec![0.0; size + 2 * reach];
    for (from, to) in values.chunks(size).zip(across.chunks_mut(size)) {
        for (at, padded) in row.iter_mut().enumerate() {
            *padded = from[(at + size - reach % size) % size];
        }
        for (x, sum) in to.iter_mut().enumerate() {
            *sum = WEIGHTS[0] * row[x + reach];
            for (away, weight) in WEIGHTS.iter().enumerate().skip(1) {
                *sum += weight * (row[x + reach - away] + row[x + reach + away]);
            }
        }
    }
    let mut down = vec![0.0; values.len()];
    for (y, to) in down.chunks_mut(size).enumerate() {
        let mut add = |y: usize, weight: f32| {
            let from = &across[y % size * size..][..size];
            for (sum, value) in to.iter_mut().zip(from) {
                *sum += weight * value;
            }
        };
        add(y, WEIGHTS[0]);
        for (away, &weight) in WEIGHTS.iter().enumerate().skip(1) {
            add(y + size - away, weight);
            add(y + away, weight);
        }
    }
    down
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn low_frequencies_are_nearly_gone_and_the_histogram_is_flat() {
        let bytes = gray(128, 3);
        let values: Vec<f32> = bytes.iter().map(|&byte| f32::from(byte) - 127.5).collect();
        let energy = |values: &[f32]| values.iter().map(|value| value * value).sum::<f32>();
        let left = energy(&blurred(128, &values)) / energy(&values);
        // What the blur leaves of white noise is the sum of its squared weights.
        let across = 2.0 * energy(&WEIGHTS) - WEIGHTS[0] * WEIGHTS[0];
        let of_white = across * across;
        assert!(left < 0.1 * of_white, "{left} and {of_white}");
        let mut histogram = [0; 256];
        for &byte in &bytes {
            histogram[usize::from(byte)] += 1;
        }
        assert!(histogram.iter().all(|&count| count == 64), "{histogram:?}");
    }

    #[test]
    fn channels_are_unrelated() {
        let bytes = rgba(64, 9);
        let part = |texel: &[u8], channel: usize| f64::from(texel[channel]) - 127.5;
        for (one, other) in [(0, 1), (0, 2), (2, 3)] {
            let sum: f64 = bytes
                .chunks(4)
                .map(|texel| part(texel, one) * part(texel, other))
                .sum();
            assert!((sum / 4096.0 / 5461.0).abs() < 0.07, "{one} and {other}");
        }
    }
}
