//! The analyser of the Web Audio API, as the site sets it up.

use std::f64::consts::TAU;
use std::fmt;
use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{RealFftPlanner, RealToComplex};

use super::{RATE, Sound};

/// Bins of the spectrum that shaders see, and samples of the waveform.
pub const BINS: usize = 512;
/// Samples that are analysed at once.
const WINDOW: usize = 2048;
/// How much of the analysis before remains in the next.
const SMOOTHING: f32 = 0.8;
/// The level of the byte 0, in decibels.
const QUIETEST: f64 = -100.0;
/// The level of the byte 255, in decibels.
const LOUDEST: f64 = -30.0;
/// Analyses a second: browsers make one for each frame that they draw.
const ANALYSES: u64 = 60;
/// Analyses that the smoothing remembers. What came before them weighs 0.8¹²⁸ = 4·10⁻¹³: full loudness has become
/// −234 dB, and nothing below −100 dB is shown.
const MEMORY: usize = 128;

/// What the site makes of a sound: the spectrum, smoothed in time, and the waveform.
///
/// Its results depend on the time alone: the analyses stand on a grid of 60 a second, and the smoothing is a sum over the
/// last 128 of them, always added up in the same order, from whatever is still known and what must be made anew.
pub struct Analyser {
    fft: Arc<dyn RealToComplex<f32>>,
    window: Vec<f32>,
    /// Samples under the window, and the transform's memory.
    samples: Vec<f32>,
    complex: Vec<Complex<f32>>,
    scratch: Vec<Complex<f32>>,
    /// Magnitudes of the latest analyses, each where its number modulo [`MEMORY`] puts it.
    rows: Vec<[f32; BINS]>,
    /// Which analysis each row is of; none has the number 0.
    numbers: Vec<u64>,
}

impl fmt::Debug for Analyser {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Analyser").finish_non_exhaustive()
    }
}

impl Default for Analyser {
    fn default() -> Self {
        Analyser::new()
    }
}

impl Analyser {
    /// One that has heard nothing yet. Each sound needs its own.
    pub fn new() -> Analyser {
        let fft = RealFftPlanner::new().plan_fft_forward(WINDOW);
        let window = (0..WINDOW).map(|i| {
            // Web Audio's Blackman window: α = 0.16, and a period of the whole length.
            let turn = TAU * i as f64 / WINDOW as f64;
            let value = 0.42 - 0.5 * turn.cos() + 0.08 * (2.0 * turn).cos();
            // The transform is divided by its length.
            (value / WINDOW as f64) as f32
        });
        Analyser {
            window: window.collect(),
            samples: fft.make_input_vec(),
            complex: fft.make_output_vec(),
            scratch: fft.make_scratch_vec(),
            fft,
            rows: vec![[0.0; BINS]; MEMORY],
            numbers: vec![0; MEMORY],
        }
    }

    /// Which analysis is shown at `time`, in seconds from 0. Number 0 is silence.
    pub(super) fn number(time: f64) -> u64 {
        // Frames at 60 a second must not fall below their analysis by rounding, be their times of 32 bits or 64.
        (time * ANALYSES as f64 + 0.01) as u64
    }

    /// Writes the analysis with that number: [`BINS`] bytes of the spectrum, from 0 for −100 dB to 255 for −30 dB, and
    /// as many of the waveform, where 128 is zero.
    pub(super) fn write(&mut self, sound: &Sound, number: u64, bytes: &mut [u8; 2 * BINS]) {
        let mut smoothed = [0.0_f32; BINS];
        let first = (number + 1).saturating_sub(MEMORY as u64).max(1);
        for analysis in first..=number {
            let at = (analysis % MEMORY as u64) as usize;
            if self.numbers[at] != analysis {
                self.transform(sound, analysis, at);
                self.numbers[at] = analysis;
            }
            for (smoothed, magnitude) in smoothed.iter_mut().zip(&self.rows[at]) {
                *smoothed = SMOOTHING * *smoothed + (1.0 - SMOOTHING) * magnitude;
            }
        }
        let (spectrum, waveform) = bytes.split_at_mut(BINS);
        for (byte, magnitude) in spectrum.iter_mut().zip(smoothed) {
            let decibels = 20.0 * f64::from(magnitude).log10();
            // The conversion rounds down and clamps, as the API asks; silence is −∞.
            *byte = (255.0 / (LOUDEST - QUIETEST) * (decibels - QUIETEST)) as u8;
        }
        // The API copies the first samples of the window if fewer are asked for than there are: the oldest ones.
        sound.mono(end(number), &mut self.samples);
        for (byte, sample) in waveform.iter_mut().zip(&self.samples) {
            *byte = (128.0 * (1.0 + sample)) as u8;
        }
    }

    /// Fills a row with the magnitudes of one analysis.
    fn transform(&mut self, sound: &Sound, analysis: u64, row: usize) {
        sound.mono(end(analysis), &mut self.samples);
        for (sample, weight) in self.samples.iter_mut().zip(&self.window) {
            *sample *= weight;
        }
        (self.fft)
            .process_with_scratch(&mut self.samples, &mut self.complex, &mut self.scratch)
            .expect("all lengths are the transform's own");
        for (magnitude, value) in self.rows[row].iter_mut().zip(&self.complex) {
            *magnitude = value.norm();
        }
    }
}

/// The sample before which the window of an analysis ends.
fn end(analysis: u64) -> u64 {
    analysis * (u64::from(RATE) / ANALYSES)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(amplitude: f32, bin: f64, seconds: f64) -> Sound {
        let value = |i: usize| amplitude * (TAU * bin * i as f64 / WINDOW as f64).sin() as f32;
        let count = (seconds * f64::from(RATE)) as usize;
        Sound::new((0..count).map(|i| [value(i); 2]).collect())
    }

    fn at(analyser: &mut Analyser, sound: &Sound, time: f64) -> [u8; 2 * BINS] {
        let mut bytes = [7; 2 * BINS];
        analyser.write(sound, Analyser::number(time), &mut bytes);
        bytes
    }

    #[test]
    fn a_sine_is_as_loud_as_theory_says() {
        for (amplitude, bin) in [(0.01, 100), (0.1, 17), (0.001, 400)] {
            let sound = sine(amplitude, bin.into(), 10.0);
            let bytes = at(&mut Analyser::new(), &sound, 5.0);
            // Half of a sine lies in each of two bins; the window lets 0.42 through in the middle, and 0.25 beside it.
            for (beside, gain) in [(0, 0.42), (1, 0.25), (-1, 0.25)] {
                let decibels = 20.0 * (f64::from(amplitude) * 0.5 * gain).log10();
                let wanted = (255.0 * (decibels + 100.0) / 70.0).min(255.0);
                let byte = f64::from(bytes[(bin + beside) as usize]);
                assert!((byte - wanted).abs() <= 1.0, "{bin}: {byte} {wanted}");
            }
            assert_eq!(bytes[(bin + 5) as usize], 0);
            let loudest = bytes[..BINS]
                .iter()
                .enumerate()
                .max_by_key(|(_, byte)| **byte);
            assert_eq!(loudest.unwrap().0, bin as usize);
        }
    }

    #[test]
    fn silence_is_0_and_128() {
        let sound = Sound::new(vec![[0.0; 2]; 44_100]);
        for time in [0.0, 0.5, 100.0] {
            let bytes = at(&mut Analyser::new(), &sound, time);
            assert_eq!(bytes[..BINS], [0; BINS]);
            assert_eq!(bytes[BINS..], [128; BINS]);
        }
        // Nothing has sounded yet at the very beginning of anything.
        let bytes = at(&mut Analyser::new(), &sine(1.0, 20.0, 1.0), 0.0);
        assert_eq!(bytes[..BINS], [0; BINS]);
    }

    #[test]
    fn jumping_is_the_same_as_running() {
        let sound = Sound::synthetic("a");
        let mut running = Analyser::new();
        for frame in 0..200 {
            let time = f64::from(frame) / 60.0;
            let ran = at(&mut running, &sound, time);
            if frame % 37 == 0 {
                assert_eq!(ran, at(&mut Analyser::new(), &sound, time), "{time}");
            }
        }
        let mut jumping = Analyser::new();
        for time in [3.0, 1.0, 2.9, 0.0, 1.1] {
            let jumped = at(&mut jumping, &sound, time);
            assert_eq!(jumped, at(&mut Analyser::new(), &sound, time), "{time}");
        }
    }

    #[test]
    fn smoothing_lets_a_sound_fade() {
        let mut frames = sine(0.1, 50.0, 1.0).frames().to_vec();
        frames.resize(4 * 44_100, [0.0; 2]);
        let sound = Sound::new(frames);
        let level = |time| {
            let bytes = at(&mut Analyser::new(), &sound, time);
            f64::from(bytes[50]) * 70.0 / 255.0
        };
        // 0.8 a frame is 1.94 dB.
        let fallen = level(1.2) - level(1.3);
        assert!((fallen - 6.0 * 1.938).abs() < 0.6, "{fallen}");
        assert_eq!(level(2.5), 0.0);
    }

    #[test]
    fn the_waveform_is_that_of_the_oldest_samples() {
        let ramp = (0..44_100).map(|i| [i as f32 / 44_100.0; 2]).collect();
        let bytes = at(&mut Analyser::new(), &Sound::new(ramp), 0.5);
        let wanted = |i: usize| {
            let sample = 22_050 - WINDOW + i;
            (128.0 * (1.0 + sample as f32 / 44_100.0)) as u8
        };
        assert_eq!(bytes[BINS], wanted(0));
        assert_eq!(bytes[2 * BINS - 1], wanted(BINS - 1));
    }
}
