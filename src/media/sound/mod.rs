//! Sounds: decoded from files or made, and what shaders see of them.

mod decode;
mod feed;
mod resample;
mod spectrum;
mod synthetic;

use std::path::Path;
use std::time::Duration;

pub use feed::SoundFeed;
pub use spectrum::{Analyser, BINS};

use super::MediaError;

/// Samples a second of every sound: what shaders see as `iSampleRate`.
pub const RATE: u32 = 44_100;

/// The longest sound that is taken. Decoded it needs 404 MiB.
pub const LONGEST: Duration = Duration::from_secs(20 * 60);

/// A sound in memory: stereo, [`RATE`] samples a second.
#[derive(Clone, Debug, PartialEq)]
pub struct Sound {
    /// Left and right.
    frames: Vec<[f32; 2]>,
}

impl Sound {
    /// Decodes a file: MP3, Ogg Vorbis, WAV, FLAC, or AAC in MP4. What is cut short or damaged is used as far as it goes.
    pub fn open(path: &Path) -> Result<Sound, MediaError> {
        decode::decode(path).map(|frames| Sound { frames })
    }

    /// Some seconds of music with drums, bass, chords and a melody, without a seam where it begins again: for pieces whose
    /// files are not there. It is different for each name, and always the same for one.
    pub fn synthetic(name: &str) -> Sound {
        Sound::new(synthetic::music(name))
    }

    /// Some seconds of murmur with pauses, without a seam: for the microphone.
    pub fn murmur() -> Sound {
        Sound::new(synthetic::murmur())
    }

    /// A sound of such samples, left and right, [`RATE`] of them a second. What is not finite becomes silence, and
    /// nothing is louder than 16 times what can be played.
    pub fn new(mut frames: Vec<[f32; 2]>) -> Sound {
        for frame in &mut frames {
            *frame = frame.map(decode::tame);
        }
        Sound { frames }
    }

    /// Left and right, [`RATE`] of them a second; from −1 to 1, where nothing is clipped.
    pub fn frames(&self) -> &[[f32; 2]] {
        &self.frames
    }

    /// How long it lasts.
    pub fn seconds(&self) -> f64 {
        self.frames.len() as f64 / f64::from(RATE)
    }

    /// Fills `into` with both channels' mean, the last sample being the one before `end`. Before the sound is silence;
    /// behind its end it begins again.
    pub fn mono(&self, end: u64, into: &mut [f32]) {
        let start = end.saturating_sub(into.len() as u64);
        let silent = into.len() - (end - start) as usize;
        into[..silent].fill(0.0);
        let length = self.frames.len() as u64;
        if length == 0 {
            into.fill(0.0);
            return;
        }
        let first = (start % length) as usize;
        let frames = self.frames[first..]
            .iter()
            .chain(self.frames.iter().cycle());
        for (sample, [left, right]) in into[silent..].iter_mut().zip(frames) {
            *sample = 0.5 * (left + right);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn silence_comes_before_a_sound_and_its_beginning_behind_its_end() {
        let sound = Sound::new(vec![[0.5, 0.0], [1.0, 1.0], [-0.5, -1.0]]);
        let mut mono = [9.0; 4];
        sound.mono(2, &mut mono);
        assert_eq!(mono, [0.0, 0.0, 0.25, 1.0]);
        sound.mono(8, &mut mono);
        assert_eq!(mono, [1.0, -0.75, 0.25, 1.0]);
        sound.mono(0, &mut mono);
        assert_eq!(mono, [0.0; 4]);
    }

    #[test]
    fn samples_that_are_no_numbers_are_silence() {
        let sound = Sound::new(vec![[f32::NAN, f32::INFINITY], [1e30, -1e30]]);
        assert_eq!(sound.frames(), [[0.0, 0.0], [16.0, -16.0]]);
        let mut mono = [9.0; 4];
        Sound::new(Vec::new()).mono(3, &mut mono);
        assert_eq!(mono, [0.0; 4]);
    }
}
