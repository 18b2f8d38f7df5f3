//! The samples of a sound that are known so far, music, and where in them it plays.

use std::sync::Arc;

use crate::frame::SAMPLE_RATE;
use crate::media::sound::Sound;
use crate::render::SOUND_BLOCK;
use crate::session::Track;

/// How far sound and picture may part, in seconds, before the sound jumps to where the picture is.
const SLACK: f64 = 0.1;

/// How long it takes to fall silent and to become loud again, in seconds, so that it does not click.
const FADE: f64 = 0.01;

/// How many blocks are computed ahead of the one that plays.
const AHEAD: usize = 1;

/// What plays, and where.
#[derive(Debug)]
pub(super) struct Tape {
    /// Left and right, a block an entry, in the order of time; those that are not known yet are empty.
    blocks: Vec<Vec<[f32; 2]>>,
    /// What plays along from the first sample on, and again behind its end.
    music: Vec<Arc<Sound>>,
    /// The sample that plays next.
    at: f64,
    runs: bool,
    is_muted: bool,
    /// How loud it is at this moment, from 0 to 1.
    gain: f32,
}

impl Tape {
    pub fn new(is_muted: bool) -> Self {
        Tape {
            blocks: Vec::new(),
            music: Vec::new(),
            at: 0.0,
            runs: false,
            is_muted,
            gain: 0.0,
        }
    }

    /// Another sound begins, of which nothing is known yet.
    pub fn begin(&mut self) {
        let samples = Track::SECONDS * f64::from(SAMPLE_RATE);
        let blocks = (samples / f64::from(SOUND_BLOCK)).ceil() as usize;
        self.blocks = vec![Vec::new(); blocks];
    }

    /// There is no sound.
    pub fn clear(&mut self) {
        self.blocks.clear();
    }

    /// This music plays along from now on.
    pub fn set_music(&mut self, music: Vec<Arc<Sound>>) {
        self.music = music;
    }

    /// This does so too, unless it does already.
    pub fn add_music(&mut self, sound: Arc<Sound>) {
        if !self.music.iter().any(|known| Arc::ptr_eq(known, &sound)) {
            self.music.push(sound);
        }
    }

    /// The block that is needed next.
    pub fn wanted(&self) -> Option<usize> {
        let now = (self.at / f64::from(SOUND_BLOCK)) as usize;
        let mut soon = now..self.blocks.len().min(now + 1 + AHEAD);
        soon.find(|&block| self.blocks[block].is_empty())
    }

    /// A block is known. What is no number is silent.
    pub fn put(&mut self, block: usize, mut samples: Vec<[f32; 2]>) {
        for sample in samples.iter_mut().flatten() {
            *sample = if sample.is_nan() {
                0.0
            } else {
                sample.clamp(-1.0, 1.0)
            };
        }
        if let Some(place) = self.blocks.get_mut(block) {
            *place = samples;
        }
    }

    /// The picture is at this time, in seconds, and goes on or stands still.
    pub fn follow(&mut self, time: f64, runs: bool) {
        let at = time.max(0.0) * f64::from(SAMPLE_RATE);
        if (at - self.at).abs() > SLACK * f64::from(SAMPLE_RATE) {
            self.at = at;
        }
        self.runs = runs;
    }

    pub fn toggle_mute(&mut self) -> bool {
        self.is_muted = !self.is_muted;
        self.is_muted
    }

    /// Gives a device of so many channels and frames a second what it plays next.
    pub fn fill(&mut self, out: &mut [f32], channels: usize, rate: f64) {
        let step = f64::from(SAMPLE_RATE) / rate;
        let change = (1.0 / (FADE * rate)) as f32;
        for frame in out.chunks_mut(channels.max(1)) {
            let aim = if self.runs && !self.is_muted {
                1.0
            } else {
                0.0
            };
            self.gain += (aim - self.gain).clamp(-change, change);
            let [left, right] = self.between().map(|sample| sample * self.gain);
            match frame {
                [only] => *only = 0.5 * (left + right),
                [first, second, others @ ..] => {
                    (*first, *second) = (left, right);
                    others.fill(0.0);
                }
                [] => {}
            }
            if self.runs {
                self.at += step;
            }
        }
    }

    /// What sounds where it plays, linear between two samples.
    fn between(&self) -> [f32; 2] {
        let part = self.at.fract() as f32;
        let (before, behind) = (
            self.sample(self.at as usize),
            self.sample(self.at as usize + 1),
        );
        [0, 1].map(|ear| before[ear] + part * (behind[ear] - before[ear]))
    }

    /// What sounds at a sample; what is not known of the scene's own sound or behind its end is silent.
    fn sample(&self, number: usize) -> [f32; 2] {
        let block = SOUND_BLOCK as usize;
        let is_over = number as f64 >= Track::SECONDS * f64::from(SAMPLE_RATE);
        let known = self.blocks.get(number / block).filter(|_| !is_over);
        let own = known.and_then(|samples| samples.get(number % block));
        let music = self.music.iter().map(|sound| sound.frames());
        let music = music.filter_map(|frames| frames.get(number.checked_rem(frames.len())?));
        let mut sum = [0.0; 2];
        for sample in own.into_iter().chain(music) {
            sum = [0, 1].map(|ear| sum[ear] + sample[ear]);
        }
        sum.map(|sample: f32| sample.clamp(-1.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: usize = SOUND_BLOCK as usize;
    const RATE: f64 = SAMPLE_RATE as f64;

    /// A tape that has run for long enough to be loud.
    fn running() -> Tape {
        let mut tape = Tape::new(false);
        tape.begin();
        tape.follow(0.0, true);
        tape.fill(&mut vec![0.0; 2 * 500], 2, RATE);
        tape
    }

    #[test]
    fn samples_play_in_order_across_blocks() {
        let mut tape = running();
        let ramp = |first: usize| {
            let number = |at: usize| (first + at) as f32 / 1e6;
            (0..BLOCK).map(|at| [number(at), -number(at)]).collect()
        };
        tape.put(0, ramp(0));
        tape.put(1, ramp(BLOCK));
        tape.follow((BLOCK - 2) as f64 / RATE, true);
        let mut out = [0.0; 8];
        tape.fill(&mut out, 2, RATE);
        for (frame, number) in out.chunks(2).zip(BLOCK - 2..) {
            let expected = number as f32 / 1e6;
            assert!((frame[0] - expected).abs() < 1e-6, "{frame:?}");
            assert!((frame[1] + expected).abs() < 1e-6, "{frame:?}");
        }
    }

    #[test]
    fn a_device_of_another_rate_plays_at_the_same_speed() {
        let mut tape = running();
        tape.put(0, (0..BLOCK).map(|at| [at as f32 / 1e6; 2]).collect());
        let from = tape.at;
        let mut out = vec![0.0; 48_000];
        tape.fill(&mut out, 1, 48_000.0);
        assert!((tape.at - from - RATE).abs() < 1e-6);
        assert!((f64::from(out[24_000]) - (from + RATE / 2.0) / 1e6).abs() < 1e-6);
    }

    #[test]
    fn what_stands_still_falls_silent_without_a_click() {
        let mut tape = running();
        tape.put(0, vec![[0.5; 2]; BLOCK]);
        tape.follow(0.0, false);
        let mut out = vec![0.0; 2 * 1000];
        tape.fill(&mut out, 2, RATE);
        let steps = out.chunks(2).map(|frame| frame[0]).collect::<Vec<_>>();
        assert!(
            steps
                .windows(2)
                .all(|pair| (pair[0] - pair[1]).abs() < 0.01)
        );
        assert_eq!(steps[999], 0.0);
    }

    #[test]
    fn it_jumps_only_where_the_picture_is_far_away() {
        let mut tape = running();
        let at = tape.at;
        tape.follow(at / RATE + 0.05, true);
        assert_eq!(tape.at, at);
        tape.follow(42.0, true);
        assert_eq!(tape.at, 42.0 * RATE);
        assert_eq!(tape.wanted(), Some(42 * 44_100 / BLOCK));
    }

    #[test]
    fn what_plays_is_wanted_first_and_nothing_behind_the_end() {
        let mut tape = running();
        assert_eq!(tape.wanted(), Some(0));
        tape.put(0, vec![[f32::NAN, 7.0]; BLOCK]);
        assert_eq!(tape.blocks[0][0], [0.0, 1.0]);
        assert_eq!(tape.wanted(), Some(1));
        tape.put(1, vec![[0.0; 2]; BLOCK]);
        assert_eq!(tape.wanted(), None);
        tape.follow(500.0, true);
        assert_eq!(tape.wanted(), None);
        let mut out = [1.0; 4];
        tape.fill(&mut out, 2, RATE);
        assert_eq!(out, [0.0; 4]);
    }
    #[test]
    fn music_plays_along_and_begins_again_behind_its_end() {
        let mut tape = running();
        let music = |frames: &[[f32; 2]]| Arc::new(Sound::new(frames.to_vec()));
        tape.set_music(vec![
            music(&[[0.1, 0.0], [0.2, 0.5], [0.3, 1.0]]),
            music(&[]),
        ]);
        tape.put(0, vec![[0.5, -0.25]; BLOCK]);
        assert_eq!(tape.sample(3), [0.6, -0.25]);
        assert_eq!(tape.sample(4), [0.7, 0.25]);
        assert_eq!(tape.sample(5), [0.8, 0.75]);
        // Behind the end of the sound it goes on, and nothing is louder than can be played.
        assert_eq!(tape.sample(10_000_000_001), [0.3, 1.0]);
        tape.set_music(vec![music(&[[0.75, -7.0]])]);
        assert_eq!(tape.sample(0), [1.0, -1.0]);
    }
}
