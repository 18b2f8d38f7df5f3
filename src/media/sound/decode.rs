//! Sounds out of files, with Symphonia.

use std::fs::File;
use std::path::Path;

use symphonia::core::codecs::audio::AudioDecoderOptions;
use symphonia::core::errors::Error;
use symphonia::core::formats::probe::Hint;
use symphonia::core::formats::{FormatOptions, TrackType};
use symphonia::core::io::MediaSourceStream;
use symphonia::core::meta::MetadataOptions;

use super::resample::Resampler;
use super::{LONGEST, MediaError, RATE};

/// Rates that sounds have. Others are damage, and would make millions of samples out of one.
const RATES: std::ops::RangeInclusive<u32> = 1_000..=768_000;
/// Packets in a row that may be damaged before the rest is given up.
const DAMAGED: u32 = 500;

/// All of a file as stereo of [`RATE`], at most [`LONGEST`].
pub(super) fn decode(path: &Path) -> Result<Vec<[f32; 2]>, MediaError> {
    // Damaged files make some of Symphonia's readers panic, where they count with a header's numbers. Nothing outlives
    // the call, so nothing can be left in a broken state.
    std::panic::catch_unwind(|| read(path)).unwrap_or_else(|_| {
        Err(MediaError::NotA {
            path: path.to_owned(),
            what: "sound",
            words: "it is damaged".to_owned(),
        })
    })
}

fn read(path: &Path) -> Result<Vec<[f32; 2]>, MediaError> {
    let io = |error| MediaError::Io {
        path: path.to_owned(),
        error,
    };
    let not_a = |words: String| MediaError::NotA {
        path: path.to_owned(),
        what: "sound",
        words,
    };
    let file = File::open(path).map_err(io)?;
    // Reading from a pipe or a device might never end.
    if !file.metadata().map_err(io)?.is_file() {
        return Err(not_a("it is no regular file".into()));
    }
    let mut hint = Hint::new();
    if let Some(extension) = path.extension().and_then(|extension| extension.to_str()) {
        hint.with_extension(extension);
    }
    let stream = MediaSourceStream::new(Box::new(file), Default::default());
    let mut format = symphonia::default::get_probe()
        .probe(
            &hint,
            stream,
            FormatOptions::default(),
            MetadataOptions::default(),
        )
        .map_err(|error| not_a(in_words(&error)))?;
    let track = format
        .default_track(TrackType::Audio)
        .ok_or_else(|| not_a("it has no sound".into()))?;
    let id = track.id;
    let parameters = track
        .codec_params
        .as_ref()
        .and_then(|parameters| parameters.audio())
        .ok_or_else(|| not_a("its coding is unknown".into()))?;
    let mut decoder = symphonia::default::get_codecs()
        .make_audio_decoder(parameters, &AudioDecoderOptions::default())
        .map_err(|error| not_a(in_words(&error)))?;

    let limit = LONGEST.as_secs() as usize * RATE as usize;
    let mut frames = Vec::new();
    let mut resampler: Option<(u32, Resampler)> = None;
    let (mut interleaved, mut stereo) = (Vec::<f32>::new(), Vec::new());
    let mut damaged = 0;
    let mut words = "it has no samples".to_owned();
    while damaged < DAMAGED {
        let packet = match format.next_packet() {
            Ok(Some(packet)) => packet,
            Ok(None) => break,
            // Also the end of a file that was cut short, and a second stream in an Ogg file.
            Err(error) => {
                words = in_words(&error);
                break;
            }
        };
        if packet.track_id != id {
            continue;
        }
        let decoded = match decoder.decode(&packet) {
            Ok(decoded) => decoded,
            Err(error) => {
                words = in_words(&error);
                damaged += 1;
                continue;
            }
        };
        damaged = 0;
        let (rate, channels) = (decoded.spec().rate(), decoded.spec().channels().count());
        if channels == 0 || decoded.is_empty() {
            continue;
        }
        if !RATES.contains(&rate) {
            return Err(not_a(format!("{rate} samples a second")));
        }
        interleaved.resize(decoded.samples_interleaved(), 0.0);
        decoded.copy_to_slice_interleaved(&mut interleaved);
        stereo.clear();
        stereo.extend(interleaved.chunks_exact(channels).map(in_stereo));
        // The rate changes only in damaged or strange files, but then it must not change the pitch.
        if let Some((_, last)) = resampler.take_if(|(last, _)| *last != rate) {
            last.finish(&mut frames, limit + 1);
        }
        let (_, resampler) = resampler.get_or_insert_with(|| (rate, Resampler::new(rate)));
        resampler.push(&stereo, &mut frames, limit + 1);
        if frames.len() > limit {
            return Err(MediaError::TooLong {
                path: path.to_owned(),
                limit: LONGEST,
            });
        }
    }
    if let Some((_, last)) = resampler {
        last.finish(&mut frames, limit);
    }
    if frames.is_empty() {
        return Err(not_a(words));
    }
    frames.shrink_to_fit();
    Ok(frames)
}

/// One frame's channels as left and right, as Web Audio mixes them.
fn in_stereo(channels: &[f32]) -> [f32; 2] {
    const HALF_POWER: f32 = std::f32::consts::FRAC_1_SQRT_2;
    let stereo = match *channels {
        [] => [0.0; 2],
        [both] => [both; 2],
        [left, right, back_left, back_right] => {
            [0.5 * (left + back_left), 0.5 * (right + back_right)]
        }
        [left, right, centre, _, side_left, side_right] => [
            left + HALF_POWER * (centre + side_left),
            right + HALF_POWER * (centre + side_right),
        ],
        [left, right, ..] => [left, right],
    };
    stereo.map(tame)
}

/// A number that can be computed with: files of floats may hold anything.
pub(super) fn tame(sample: f32) -> f32 {
    match sample.is_finite() {
        true => sample.clamp(-16.0, 16.0),
        false => 0.0,
    }
}

/// What Symphonia says, without its general words in front.
fn in_words(error: &Error) -> String {
    match error {
        Error::DecodeError(words) | Error::Unsupported(words) | Error::LimitError(words) => {
            (*words).to_owned()
        }
        Error::IoError(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
            "it ends too early, or its format is unknown".to_owned()
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::super::Sound;
    use super::*;

    fn wav(spec: hound::WavSpec, samples: impl Iterator<Item = f32>) -> Vec<u8> {
        let mut bytes = std::io::Cursor::new(Vec::new());
        let mut writer = hound::WavWriter::new(&mut bytes, spec).unwrap();
        for sample in samples {
            match spec.sample_format {
                hound::SampleFormat::Float => writer.write_sample(sample).unwrap(),
                hound::SampleFormat::Int => writer.write_sample((sample * 32767.0) as i16).unwrap(),
            }
        }
        writer.finalize().unwrap();
        bytes.into_inner()
    }

    fn spec(channels: u16, rate: u32) -> hound::WavSpec {
        hound::WavSpec {
            channels,
            sample_rate: rate,
            bits_per_sample: 16,
            sample_format: hound::SampleFormat::Int,
        }
    }

    fn open(name: &str, bytes: &[u8]) -> Result<Sound, MediaError> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        Sound::open(&path)
    }

    #[test]
    fn a_wav_file_is_read_and_brought_to_our_rate() {
        let samples = [0.5, -0.25].into_iter().cycle().take(2 * 4410);
        let sound = open("a.wav", &wav(spec(2, 44_100), samples)).unwrap();
        assert_eq!(sound.frames().len(), 4410);
        let [left, right] = sound.frames()[100];
        assert!((left - 0.5).abs() < 1e-4 && (right + 0.25).abs() < 1e-4);

        let sound = open("a.wav", &wav(spec(1, 22_050), (0..2205).map(|_| 0.5))).unwrap();
        assert_eq!(sound.frames().len(), 4410);
        let [left, right] = sound.frames()[2000];
        assert!((left - 0.5).abs() < 1e-3 && left == right);
    }

    #[test]
    fn floats_that_are_no_numbers_are_silence() {
        let spec = hound::WavSpec {
            bits_per_sample: 32,
            sample_format: hound::SampleFormat::Float,
            ..spec(1, 44_100)
        };
        let sound = open("a.wav", &wav(spec, [f32::NAN, 0.5, 1e38].into_iter())).unwrap();
        assert_eq!(sound.frames(), [[0.0; 2], [0.5; 2], [16.0; 2]]);
    }

    #[test]
    fn what_is_no_sound_is_told_so() {
        for (name, bytes) in [
            ("empty.mp3", &b""[..]),
            ("text.ogg", b"these are words and no music"),
            ("zero.wav", &wav(spec(2, 44_100), std::iter::empty())),
            ("slow.wav", &wav(spec(1, 1), (0..4).map(|_| 0.5))),
        ] {
            let error = open(name, bytes).unwrap_err();
            assert!(
                matches!(error, MediaError::NotA { what: "sound", .. }),
                "{error}"
            );
        }
        let error = Sound::open(Path::new("no/such/file.mp3")).unwrap_err();
        assert!(matches!(error, MediaError::Io { .. }), "{error}");
        let error = Sound::open(Path::new("src")).unwrap_err();
        assert!(!error.to_string().is_empty());
    }

    #[test]
    fn a_file_that_is_cut_short_is_used_as_far_as_it_goes() {
        let whole = wav(
            spec(2, 44_100),
            (0..2 * 44_100).map(|i| (i % 100) as f32 / 100.0),
        );
        let sound = open("a.wav", &whole[..whole.len() / 2]).unwrap();
        assert!(sound.frames().len() > 20_000);
        // Wherever it is cut or damaged, nothing breaks.
        for end in 0..48 {
            let _ = open("a.wav", &whole[..end]);
            let mut damaged = whole[..4000].to_vec();
            damaged[end] ^= 0xff;
            let _ = open("a.wav", &damaged);
        }
    }

    #[test]
    fn compressed_files_are_read_and_damaged_ones_break_nothing() {
        let folder = tempfile::tempdir().unwrap();
        for (name, codec) in [
            ("a.mp3", "libmp3lame"),
            ("a.ogg", "libvorbis"),
            ("a.flac", "flac"),
            ("a.m4a", "aac"),
        ] {
            let path = folder.path().join(name);
            let made = std::process::Command::new("ffmpeg")
                .args(["-v", "error", "-f", "lavfi", "-i"])
                .args([
                    "sine=frequency=1000:duration=2:sample_rate=48000",
                    "-c:a",
                    codec,
                ])
                .arg(&path)
                .status();
            if !made.is_ok_and(|status| status.success()) {
                eprintln!("skipped {name}: no ffmpeg that can make it");
                continue;
            }
            let sound = Sound::open(&path).unwrap();
            assert!(
                (sound.seconds() - 2.0).abs() < 0.06,
                "{name}: {}",
                sound.seconds()
            );
            let crossings = sound.frames()[22_050..44_100]
                .windows(2)
                .filter(|pair| pair[0][0] < 0.0 && pair[1][0] >= 0.0)
                .count();
            assert!((495..=505).contains(&crossings), "{name}: {crossings}");

            let whole = fs::read(&path).unwrap();
            // So short an Ogg file is one page, and MP4 has its index at the end.
            let half = open(name, &whole[..whole.len() / 2]);
            assert!(
                matches!(name, "a.m4a" | "a.ogg") || half.unwrap().seconds() > 0.5,
                "{name}"
            );
            for round in 0..12 {
                let mut damaged = whole.clone();
                for at in (round * 7..damaged.len()).step_by(211) {
                    damaged[at] = damaged[at].wrapping_mul(31).wrapping_add(round as u8);
                }
                let _ = open(name, &damaged);
                let _ = open(name, &whole[..whole.len() * round / 12]);
            }
        }
    }

    #[test]
    fn surround_is_mixed_down() {
        assert_eq!(in_stereo(&[0.25]), [0.25, 0.25]);
        assert_eq!(in_stereo(&[1.0, 0.0, 0.5, 0.5]), [0.75, 0.25]);
        let [left, right] = in_stereo(&[0.1, 0.2, 0.0, 9.0, 0.0, 0.0]);
        assert_eq!([left, right], [0.1, 0.2]);
    }
}
