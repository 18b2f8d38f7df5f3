//! From any rate to the one that shaders know.

use std::f64::consts::PI;

use super::RATE;

/// Zeros of the kernel on each side of its middle. With so many, what lies below 18 kHz stays as it is, and what would be
/// folded down to there is 80 dB weaker.
const ZEROS: usize = 16;
/// Values of the kernel between two zeros; between these it is linear, which is wrong by less than 10⁻⁵.
const STEPS: usize = 512;
/// Where the kernel cuts, as a part of the lower of both rates' limits: the filter's slope has a width.
const CUT: f64 = 0.92;

/// Phases between two input samples whose weights are computed in advance; common rates have 441 at most.
const PHASES: u64 = 1024;

/// Makes samples of [`RATE`] from those of another rate, with a windowed sinc, piece by piece.
pub(super) struct Resampler {
    rate: u64,
    /// The right half of the kernel over its argument in zeros.
    kernel: Vec<f32>,
    /// Weights of the input samples for each phase, one row behind the other; empty if there are too many phases.
    phases: Vec<f32>,
    /// How much of [`RATE`] lies between two phases.
    step: u64,
    /// Zeros of the kernel an input sample.
    density: f64,
    /// Input samples on each side that an output sample depends on.
    reach: u64,
    /// What has come in and is still needed.
    pending: Vec<[f32; 2]>,
    /// Which input sample the first of `pending` is, counted from `reach` zeros before the first.
    base: u64,
    /// Input samples so far, without zeros.
    taken: u64,
    /// Output samples so far.
    made: u64,
}

impl Resampler {
    /// For input of `rate` samples a second, which is not 0.
    pub(super) fn new(rate: u32) -> Resampler {
        let density = CUT * f64::min(1.0, f64::from(RATE) / f64::from(rate));
        let reach = (ZEROS as f64 / density).ceil() as u64 + 1;
        let mut resampler = Resampler {
            rate: rate.into(),
            kernel: kernel(),
            phases: Vec::new(),
            step: common_divisor(rate.into(), RATE.into()),
            density,
            reach,
            pending: vec![[0.0; 2]; reach as usize],
            base: 0,
            taken: 0,
            made: 0,
        };
        let count = u64::from(RATE) / resampler.step;
        if count <= PHASES {
            let mut row = vec![0.0; 2 * reach as usize + 1];
            for phase in 0..count {
                resampler.weigh(phase as f64 / count as f64, &mut row);
                resampler.phases.extend(&row);
            }
        }
        resampler
    }

    /// Takes the next input samples and appends what can be made of them, but not beyond `limit` samples in all.
    pub(super) fn push(&mut self, input: &[[f32; 2]], output: &mut Vec<[f32; 2]>, limit: usize) {
        self.taken += input.len() as u64;
        if self.rate == u64::from(RATE) {
            let room = limit.saturating_sub(output.len());
            output.extend(&input[..input.len().min(room)]);
            return;
        }
        self.pending.extend(input);
        self.make(output, limit);
    }

    /// Appends the rest.
    pub(super) fn finish(mut self, output: &mut Vec<[f32; 2]>, limit: usize) {
        if self.rate != u64::from(RATE) {
            let padded = self.pending.len() + 2 * self.reach as usize;
            self.pending.resize(padded, [0.0; 2]);
            self.make(output, limit);
        }
    }

    fn make(&mut self, output: &mut Vec<[f32; 2]>, limit: usize) {
        let out_rate = u64::from(RATE);
        let taps = 2 * self.reach as usize + 1;
        let mut row = vec![0.0; taps];
        while output.len() < limit {
            let whole = self.made * self.rate / out_rate;
            let part = self.made * self.rate % out_rate;
            // In the padded count the middle lies `reach` further on, so the first needed sample is at `whole`.
            let first = (whole - self.base) as usize;
            if whole >= self.taken || first + taps > self.pending.len() {
                break;
            }
            let phase = (part / self.step) as usize * taps;
            let weights = match self.phases.get(phase..phase + taps) {
                Some(weights) => weights,
                None => {
                    self.weigh(part as f64 / out_rate as f64, &mut row);
                    &row
                }
            };
            let mut sum = [0.0_f32; 2];
            for (weight, [left, right]) in weights.iter().zip(&self.pending[first..first + taps]) {
                sum[0] += weight * left;
                sum[1] += weight * right;
            }
            output.push(sum);
            self.made += 1;
        }
        // What no later output sample needs can go; moving the rest is only worth while for many.
        let next = self.made * self.rate / out_rate;
        let spent = ((next - self.base) as usize).min(self.pending.len());
        if spent > self.pending.len() / 2 {
            self.pending.drain(..spent);
            self.base += spent as u64;
        }
    }

    /// The weights of all input samples around a place, which lies so far behind the middle one.
    fn weigh(&self, part: f64, row: &mut [f32]) {
        for (tap, weight) in row.iter_mut().enumerate() {
            *weight = self.weight(tap as f64 - self.reach as f64 - part);
        }
    }

    /// The kernel so many input samples from its middle.
    fn weight(&self, distance: f64) -> f32 {
        let at = distance.abs() * self.density * STEPS as f64;
        let index = at as usize;
        match self.kernel.get(index..index + 2) {
            Some(&[low, high]) => {
                (low + (high - low) * (at - index as f64) as f32) * self.density as f32
            }
            _ => 0.0,
        }
    }
}

/// The greatest number that divides both.
fn common_divisor(a: u64, b: u64) -> u64 {
    match b {
        0 => a,
        _ => common_divisor(b, a % b),
    }
}

/// sin(πx)/(πx) under a Blackman window, from the middle to the last zero.
fn kernel() -> Vec<f32> {
    let values = (0..=ZEROS * STEPS).map(|step| {
        let x = step as f64 / STEPS as f64;
        let turn = PI * x / ZEROS as f64;
        let window = 0.42 + 0.5 * turn.cos() + 0.08 * (2.0 * turn).cos();
        let sinc = match step {
            0 => 1.0,
            _ => (PI * x).sin() / (PI * x),
        };
        (sinc * window) as f32
    });
    values.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(rate: u32, hertz: f64, count: usize) -> Vec<[f32; 2]> {
        let value = |i: usize| (2.0 * PI * hertz * i as f64 / f64::from(rate)).sin() as f32;
        (0..count).map(|i| [value(i), -value(i)]).collect()
    }

    fn resampled(rate: u32, input: &[[f32; 2]], piece: usize) -> Vec<[f32; 2]> {
        let mut resampler = Resampler::new(rate);
        let mut output = Vec::new();
        for piece in input.chunks(piece) {
            resampler.push(piece, &mut output, usize::MAX);
        }
        resampler.finish(&mut output, usize::MAX);
        output
    }

    #[test]
    fn a_sine_stays_a_sine() {
        for rate in [8_000, 22_050, 44_100, 48_000, 48_001, 96_000] {
            let output = resampled(rate, &sine(rate, 1000.0, rate as usize / 5), 1000);
            assert!(output.len().abs_diff(44_100 / 5) <= 1, "{}", output.len());
            let wanted = sine(RATE, 1000.0, output.len());
            // Beyond both ends is silence, which the kernel sees.
            for i in 500..output.len() - 500 {
                let error = (output[i][0] - wanted[i][0]).abs();
                assert!(error < 1e-3, "{rate}: {i}: {:?} {:?}", output[i], wanted[i]);
                assert_eq!(output[i][0], -output[i][1]);
            }
        }
    }

    #[test]
    fn what_cannot_be_heard_does_not_fold_down() {
        let output = resampled(96_000, &sine(96_000, 30_000.0, 19_200), 333);
        let loudest = output[500..8000]
            .iter()
            .fold(0.0_f32, |most, [left, _]| most.max(left.abs()));
        assert!(loudest < 2e-4, "{loudest}");
    }

    #[test]
    fn pieces_make_no_difference() {
        let input = sine(48_000, 333.0, 5000);
        assert_eq!(
            resampled(48_000, &input, 7),
            resampled(48_000, &input, 5000)
        );
        assert!(resampled(48_000, &[], 1).is_empty());
        assert_eq!(resampled(1, &[[1.0; 2]], 1).len(), 44_100);
    }
}
