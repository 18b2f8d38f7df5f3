//! Music and murmur that are made, for inputs whose sound is not there.

use std::f32::consts::TAU;

use super::RATE;

/// Quarters of a piece: eight bars.
const BEATS: usize = 32;
/// The loudest sample of a piece.
const PEAK: f32 = 0.8;
/// Semitones of the natural minor scale above its root.
const MINOR: [i32; 7] = [0, 2, 3, 5, 7, 8, 10];
/// Steps of the scale that chords stand on, two bars each.
const PROGRESSIONS: [[usize; 4]; 4] = [[0, 5, 2, 6], [0, 3, 5, 4], [0, 6, 5, 6], [0, 2, 3, 4]];

/// Eight bars of music; the name decides tempo, key, chords, patterns and instruments.
pub(super) fn music(name: &str) -> Vec<[f32; 2]> {
    let mut chance = Chance::new(name);
    let tempo = 92.0 + 4.0 * chance.below(11) as f32;
    let mut piece = Piece::new(tempo);
    let root = 45.0 + chance.below(7) as f32;
    let progression = PROGRESSIONS[chance.below(PROGRESSIONS.len())];
    let lead = [Wave::Square, Wave::Saw, Wave::Triangle][chance.below(3)];
    let swing = [0.0, 0.0, 0.06][chance.below(3)];
    let melody: [usize; 16] = std::array::from_fn(|_| chance.below(8));
    let is_offbeat_bass = chance.below(2) == 0;
    let note = |step: usize| root + (MINOR[step % 7] + 12 * (step / 7) as i32) as f32;

    for beat in 0..BEATS {
        let at = beat as f32;
        let chord = progression[(beat / 8) % 4];
        piece.kick(at);
        if beat % 2 == 1 {
            piece.snare(at, &mut chance);
        }
        if beat % 8 == 7 && chance.below(2) == 0 {
            piece.kick(at + 0.75);
        }
        for quarter in 0..4 {
            let late = if quarter % 2 == 1 { swing } else { 0.0 };
            let time = at + 0.25 * quarter as f32 + late;
            let is_open = quarter == 2;
            let level = if quarter % 2 == 0 { 0.16 } else { 0.09 };
            piece.hat(time, level, is_open, &mut chance);
            if (quarter != 0 || !is_offbeat_bass) && quarter != 3 {
                piece.tone(Tone {
                    wave: Wave::Saw,
                    dull: 0.08,
                    level: 0.42,
                    decay: 3.5,
                    ..Tone::new(time, 0.24, note(chord) - 12.0)
                });
            }
            // Every second bar the melody rests on some of its notes, so that levels change.
            let step = melody[(4 * beat + quarter) % 16];
            if step < 6 || beat % 8 < 4 {
                let side = if quarter % 2 == 0 { 0.35 } else { 0.65 };
                for (echo, level) in [(0.0, 0.16), (0.75, 0.06)] {
                    piece.tone(Tone {
                        wave: lead,
                        dull: 0.45,
                        level,
                        decay: 5.0,
                        side: if echo > 0.0 { 1.0 - side } else { side },
                        ..Tone::new(time + echo, 0.5, note(chord + step) + 24.0)
                    });
                }
            }
        }
        if beat % 8 == 0 {
            for (voice, side) in [(0, 0.5), (2, 0.2), (4, 0.8)] {
                for detuned in [-0.06, 0.06] {
                    piece.tone(Tone {
                        wave: Wave::Saw,
                        dull: 0.12,
                        level: 0.09,
                        decay: 0.12,
                        attack: 0.2,
                        side,
                        ..Tone::new(at, 8.0, note(chord + voice) + 12.0 + detuned)
                    });
                }
            }
        }
    }
    piece.finish()
}

/// Somebody talking to himself, with pauses: buzzing vowels, hissing consonants and the noise of the room.
pub(super) fn murmur() -> Vec<[f32; 2]> {
    /// The first three resonances of some vowels, in hertz.
    const VOWELS: [[f32; 3]; 5] = [
        [730.0, 1090.0, 2440.0],
        [270.0, 2290.0, 3010.0],
        [530.0, 1840.0, 2480.0],
        [570.0, 840.0, 2410.0],
        [300.0, 870.0, 2240.0],
    ];
    let rate = RATE as f32;
    let mut chance = Chance::new("microphone");
    let mut samples: Vec<f32> = (0..12 * RATE).map(|_| 0.0006 * chance.noise()).collect();
    let mut start = 0.3;
    while start < 11.3 {
        let vowel = VOWELS[chance.below(VOWELS.len())];
        let length = 0.12 + 0.02 * chance.below(6) as f32;
        let pitch = 105.0 + 6.0 * chance.below(7) as f32;
        let mut resonances = vowel.map(|hertz| Resonance::new(hertz, 60.0 + 0.05 * hertz));
        let mut phase = 0.0;
        let first = (start * rate) as usize;
        let count = (length * rate) as usize;
        for i in 0..count {
            let done = i as f32 / count as f32;
            phase += pitch * (1.1 - 0.2 * done) / rate;
            let pulse = if phase >= 1.0 { 1.0 } else { 0.0 };
            phase -= pulse;
            let loudness = (done * (1.0 - done) * 4.0).sqrt();
            let voice: f32 = (resonances.iter_mut())
                .zip([1.0, 0.6, 0.3])
                .map(|(resonance, level)| level * resonance.next(pulse + 0.004 * chance.noise()))
                .sum();
            samples[first + i] += loudness * voice;
        }
        if chance.below(3) == 0 {
            let mut last = 0.0;
            for i in 0..RATE as usize / 14 {
                let noise = chance.noise();
                samples[first + count + i] += 0.02 * (noise - last);
                last = noise;
            }
        }
        start += length + 0.04 * chance.below(3) as f32;
        if chance.below(7) == 0 {
            start += 0.5;
        }
    }
    let peak = samples.iter().fold(1e-6_f32, |most, s| most.max(s.abs()));
    samples.iter().map(|s| [0.5 * s / peak; 2]).collect()
}

/// What a name decides.
struct Chance(u64);

impl Chance {
    /// From a name, by FNV-1a.
    fn new(name: &str) -> Chance {
        let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
        Chance(hash)
    }

    /// The next 64 bits (SplitMix64).
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `count`, which is small.
    fn below(&mut self, count: usize) -> usize {
        ((self.next() >> 33) % count as u64) as usize
    }

    /// From −1 to 1.
    fn noise(&mut self) -> f32 {
        (self.next() >> 40) as f32 / (1 << 23) as f32 - 1.0
    }
}

/// A filter that rings at one frequency.
struct Resonance {
    gain: f32,
    feedback: [f32; 2],
    last: [f32; 2],
}

impl Resonance {
    fn new(hertz: f32, width: f32) -> Resonance {
        let radius = (-TAU / 2.0 * width / RATE as f32).exp();
        Resonance {
            gain: 1.0 - radius,
            feedback: [
                2.0 * radius * (TAU * hertz / RATE as f32).cos(),
                -radius * radius,
            ],
            last: [0.0; 2],
        }
    }

    fn next(&mut self, input: f32) -> f32 {
        let [one, two] = self.last;
        let value = self.gain * input + self.feedback[0] * one + self.feedback[1] * two;
        self.last = [value, one];
        value
    }
}

/// The form of an oscillation.
#[derive(Clone, Copy)]
enum Wave {
    Saw,
    Square,
    Triangle,
}

/// One note of an instrument.
#[derive(Clone, Copy)]
struct Tone {
    /// Beginning and length in beats.
    at: f32,
    length: f32,
    /// Semitones, where 69 is the A of 440 Hz.
    pitch: f32,
    wave: Wave,
    /// How much of a new sample a filter lets through at once, up to 1.
    dull: f32,
    level: f32,
    /// How fast it fades: e-folds a second.
    decay: f32,
    /// Seconds until it is there.
    attack: f32,
    /// From 0, left, to 1, right.
    side: f32,
}

impl Tone {
    fn new(at: f32, length: f32, pitch: f32) -> Tone {
        Tone {
            at,
            length,
            pitch,
            wave: Wave::Saw,
            dull: 1.0,
            level: 0.1,
            decay: 1.0,
            attack: 0.003,
            side: 0.5,
        }
    }
}

/// Samples that notes are added to; what rings beyond the end rings at the beginning.
struct Piece {
    frames: Vec<[f32; 2]>,
    /// Samples a beat.
    beat: f32,
}

impl Piece {
    fn new(tempo: f32) -> Piece {
        let beat = 60.0 / tempo * RATE as f32;
        let length = (beat * BEATS as f32).round() as usize;
        Piece {
            frames: vec![[0.0; 2]; length],
            beat,
        }
    }

    /// Adds so many seconds of what `sample` gives for seconds since the beginning.
    fn add(&mut self, at: f32, seconds: f32, side: f32, mut sample: impl FnMut(f32) -> f32) {
        let first = (at * self.beat) as usize;
        let length = self.frames.len();
        let gains = [2.0 * (1.0 - side), 2.0 * side];
        for i in 0..(seconds * RATE as f32) as usize {
            let value = sample(i as f32 / RATE as f32);
            let frame = &mut self.frames[(first + i) % length];
            frame[0] += gains[0] * value;
            frame[1] += gains[1] * value;
        }
    }

    fn kick(&mut self, at: f32) {
        self.add(at, 0.3, 0.5, |t| {
            // Its frequency falls from 160 to 45 hertz.
            let turns = 45.0 * t + 115.0 / 35.0 * (1.0 - (-35.0 * t).exp());
            0.8 * (TAU * turns).sin() * (-9.0 * t).exp() * (1.0 - t / 0.3)
        });
    }

    fn snare(&mut self, at: f32, chance: &mut Chance) {
        self.add(at, 0.22, 0.5, |t| {
            let tone = (TAU * 185.0 * t).sin() * (-25.0 * t).exp();
            0.3 * (chance.noise() + tone) * (-16.0 * t).exp()
        });
    }

    fn hat(&mut self, at: f32, level: f32, is_open: bool, chance: &mut Chance) {
        let decay = if is_open { 18.0 } else { 60.0 };
        let mut last = 0.0;
        self.add(at, 4.0 / decay, 0.6, |t| {
            let noise = chance.noise();
            // The difference of neighbours has little below some kilohertz.
            let high = 0.5 * (noise - last);
            last = noise;
            level * high * (-decay * t).exp()
        });
    }

    fn tone(&mut self, tone: Tone) {
        let hertz = 440.0 * ((tone.pitch - 69.0) / 12.0).exp2();
        let seconds = tone.length * self.beat / RATE as f32;
        let (mut phase, mut filtered) = (0.0_f32, 0.0);
        // Fading by a factor a sample spares an exponential in each.
        let (fading, mut loudness) = ((-tone.decay / RATE as f32).exp(), tone.level);
        self.add(tone.at, seconds, tone.side, |t| {
            phase += hertz / RATE as f32;
            phase -= phase.floor();
            let value = match tone.wave {
                Wave::Saw => 2.0 * phase - 1.0,
                Wave::Square if phase < 0.5 => 0.7,
                Wave::Square => -0.7,
                Wave::Triangle => 4.0 * (phase - 0.5).abs() - 1.0,
            };
            filtered += tone.dull * (value - filtered);
            loudness *= fading;
            let envelope = (t / tone.attack).min((seconds - t) / 0.01).clamp(0.0, 1.0);
            filtered * loudness * envelope
        });
    }

    /// The whole, as loud as it may be.
    fn finish(mut self) -> Vec<[f32; 2]> {
        let peak = (self.frames.iter().flatten()).fold(1e-6_f32, |most, s| most.max(s.abs()));
        for frame in &mut self.frames {
            *frame = frame.map(|sample| PEAK * sample / peak);
        }
        self.frames
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Analyser, BINS, Sound};

    #[test]
    fn pieces_are_the_same_for_a_name_and_differ_between_names() {
        let names = ["8 Bit Mentality", "Experiment", "X TrackTure"];
        let pieces = names.map(Sound::synthetic);
        assert_eq!(pieces[0], Sound::synthetic(names[0]));
        for (i, piece) in pieces.iter().enumerate() {
            assert!(
                (13.0..22.0).contains(&piece.seconds()),
                "{}",
                piece.seconds()
            );
            let peak = piece
                .frames()
                .iter()
                .flatten()
                .fold(0.0_f32, |a, b| a.max(b.abs()));
            assert!((peak - 0.8).abs() < 1e-3, "{peak}");
            assert!(pieces[..i].iter().all(|other| other != piece));
        }
        assert!(Sound::synthetic("").seconds() > 1.0);
    }

    /// Mean, lowest and highest of some bins' mean over a few seconds.
    fn levels(sound: &Sound, bins: std::ops::Range<usize>) -> [f64; 3] {
        let mut analyser = Analyser::new();
        let mut bytes = [0; 2 * BINS];
        let levels = (60..480).step_by(7).map(|frame| {
            analyser.write(sound, frame, &mut bytes);
            let sum: u32 = bytes[bins.clone()]
                .iter()
                .map(|byte| u32::from(*byte))
                .sum();
            f64::from(sum) / bins.len() as f64
        });
        let levels: Vec<f64> = levels.collect();
        let mean = levels.iter().sum::<f64>() / levels.len() as f64;
        let lowest = levels.iter().copied().fold(f64::MAX, f64::min);
        [mean, lowest, levels.into_iter().fold(0.0, f64::max)]
    }

    #[test]
    fn spectra_of_pieces_are_alive_from_bass_to_treble() {
        for name in ["8 Bit Mentality", "Electronebulae", "Tropical Beeper"] {
            let sound = Sound::synthetic(name);
            for (bins, least) in [(1..6, 190.0), (10..60, 110.0), (200..500, 30.0)] {
                let [mean, lowest, highest] = levels(&sound, bins.clone());
                assert!(mean > least, "{name} {bins:?}: {mean}");
                assert!(
                    highest - lowest > 12.0,
                    "{name} {bins:?}: {lowest} {highest}"
                );
            }
        }
    }

    #[test]
    fn the_murmur_has_words_and_pauses() {
        let [mean, lowest, highest] = levels(&Sound::murmur(), 2..100);
        assert!(
            mean > 40.0 && lowest < 30.0 && highest > 90.0,
            "{mean} {lowest} {highest}"
        );
    }
}
