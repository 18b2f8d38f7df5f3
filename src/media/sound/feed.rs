//! A sound as shaders read it.

use std::sync::Arc;

use super::{Analyser, BINS, RATE, Sound};
use crate::media::feed::{Feed, sane};
use crate::media::{Format, MediaError};

/// Spectrum and waveform of a sound that begins again behind its end: 512 × 2 texels of one byte.
#[derive(Debug)]
pub struct SoundFeed {
    sound: Arc<Sound>,
    /// Whether it is a recording with a position, not something live.
    is_recorded: bool,
    analyser: Analyser,
    bytes: [u8; 2 * BINS],
    /// The analysis that `bytes` are of.
    shown: Option<u64>,
}

impl SoundFeed {
    /// A piece of music, which plays from the scene's time 0 on.
    pub fn music(sound: Arc<Sound>) -> SoundFeed {
        SoundFeed {
            sound,
            is_recorded: true,
            analyser: Analyser::new(),
            bytes: [0; 2 * BINS],
            shown: None,
        }
    }

    /// What a microphone hears: it has no position, so its `iChannelTime` stays 0.
    pub fn microphone(sound: Arc<Sound>) -> SoundFeed {
        SoundFeed {
            is_recorded: false,
            ..SoundFeed::music(sound)
        }
    }

    /// The music in a file.
    pub fn open(path: &std::path::Path) -> Result<SoundFeed, MediaError> {
        Sound::open(path).map(|sound| SoundFeed::music(Arc::new(sound)))
    }
}

impl Feed for SoundFeed {
    fn size(&self) -> [u32; 2] {
        [BINS as u32, 2]
    }

    fn format(&self) -> Format {
        Format::R8
    }

    fn position(&self, time: f64) -> f64 {
        match self.is_recorded && !self.sound.frames().is_empty() {
            // In samples, whose number is exact, so that whole rounds end at 0.
            true => {
                let rate = f64::from(RATE);
                (sane(time) * rate) % self.sound.frames().len() as f64 / rate
            }
            false => 0.0,
        }
    }

    fn texels(&mut self, time: f64) -> Option<&[u8]> {
        let number = Analyser::number(sane(time));
        if self.shown == Some(number) {
            return None;
        }
        self.analyser.write(&self.sound, number, &mut self.bytes);
        self.shown = Some(number);
        Some(&self.bytes)
    }

    fn sound(&self) -> Option<&Arc<Sound>> {
        // A microphone is not played back.
        self.is_recorded.then_some(&self.sound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_come_once_for_each_sixtieth_of_a_second() {
        let mut feed = SoundFeed::music(Arc::new(Sound::synthetic("a")));
        assert_eq!((feed.size(), feed.format()), ([512, 2], Format::R8));
        assert_eq!(feed.texels(1.0).map(<[u8]>::len), Some(1024));
        assert!(feed.texels(1.001).is_none());
        assert!(feed.texels(61.0 / 60.0).is_some());
        assert!(feed.texels(0.0).is_some());
        assert!(feed.texels(f64::NAN).is_none());
        assert!(feed.texels(f64::INFINITY).is_some());
    }

    #[test]
    fn music_has_a_position_within_its_length_and_a_microphone_has_none() {
        let sound = Arc::new(Sound::new(vec![[0.0; 2]; 44_100 * 2]));
        let music = SoundFeed::music(Arc::clone(&sound));
        assert!((music.position(5.5) - 1.5).abs() < 1e-9);
        assert_eq!(music.position(-1.0), 0.0);
        assert!(music.sound().is_some());
        let microphone = SoundFeed::microphone(sound);
        assert_eq!(microphone.position(5.5), 0.0);
        assert!(microphone.sound().is_none());
        let nothing = Arc::new(Sound::new(Vec::new()));
        assert_eq!(SoundFeed::music(nothing).position(5.5), 0.0);
    }
}
