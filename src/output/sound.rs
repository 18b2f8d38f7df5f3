//! WAV files.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use hound::{SampleFormat, WavSpec, WavWriter};
use tempfile::NamedTempFile;

use super::{WriteError, part, persist};

/// Bytes that a WAV file's header and its frame around the samples may take.
const HEADER: u64 = 128;

/// How the samples of a sound are kept in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Samples {
    /// Whole numbers of 16 bits; what lies beyond −1 and 1 is clipped.
    #[default]
    Pcm16,
    /// 32-bit floats, as they are.
    Float32,
}

impl Samples {
    /// Bytes of a frame: left and right.
    fn frame_bytes(self) -> u64 {
        match self {
            Samples::Pcm16 => 4,
            Samples::Float32 => 8,
        }
    }

    /// The most frames that a WAV file can hold, whose sizes have 32 bits.
    pub fn most_frames(self) -> u64 {
        (u64::from(u32::MAX) - HEADER) / self.frame_bytes()
    }
}

/// Writes a stereo sound piece by piece. The file appears when it is finished; one that is dropped before leaves nothing.
pub struct WavSink {
    path: PathBuf,
    overwrite: bool,
    samples: Samples,
    /// Frames that still have room.
    room: u64,
    writer: WavWriter<BufWriter<File>>,
    /// The file that `writer` writes to, under its other name.
    part: NamedTempFile,
}

impl std::fmt::Debug for WavSink {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("WavSink")
            .field("path", &self.path)
            .finish_non_exhaustive()
    }
}

impl WavSink {
    /// Begins a file of `rate` frames a second, for at most `frames` of them. What a WAV file cannot hold, and a file that is
    /// there already without `overwrite`, is refused before anything is computed or written.
    pub fn create(
        path: &Path,
        rate: u32,
        samples: Samples,
        frames: u64,
        overwrite: bool,
    ) -> Result<WavSink, WriteError> {
        let begin = || {
            if frames > samples.most_frames() {
                return Err(too_long());
            }
            if !overwrite && path.exists() {
                return Err(io::ErrorKind::AlreadyExists.into());
            }
            let (bits_per_sample, sample_format) = match samples {
                Samples::Pcm16 => (16, SampleFormat::Int),
                Samples::Float32 => (32, SampleFormat::Float),
            };
            let spec = WavSpec {
                channels: 2,
                sample_rate: rate,
                bits_per_sample,
                sample_format,
            };
            let part = part(path)?;
            let file = BufWriter::with_capacity(1 << 16, part.as_file().try_clone()?);
            Ok((WavWriter::new(file, spec).map_err(as_io)?, part))
        };
        match begin() {
            Ok((writer, part)) => Ok(WavSink {
                path: path.to_owned(),
                overwrite,
                samples,
                room: frames,
                writer,
                part,
            }),
            Err(error) => Err(WriteError {
                path: path.to_owned(),
                error,
            }),
        }
    }

    /// Appends frames, left and right, from −1 to 1. What is no number is silence.
    pub fn push(&mut self, frames: &[[f32; 2]]) -> Result<(), WriteError> {
        let written = match self.room.checked_sub(frames.len() as u64) {
            Some(room) => {
                self.room = room;
                self.append(frames).map_err(as_io)
            }
            None => Err(io::Error::new(
                io::ErrorKind::InvalidInput,
                "it has more samples than were announced",
            )),
        };
        written.map_err(|error| WriteError {
            path: self.path.clone(),
            error,
        })
    }

    fn append(&mut self, frames: &[[f32; 2]]) -> hound::Result<()> {
        for sample in frames.iter().flatten() {
            let sample = if sample.is_nan() { 0.0 } else { *sample };
            match self.samples {
                // The conversion clips.
                Samples::Pcm16 => self
                    .writer
                    .write_sample((sample * 32767.0).round() as i16)?,
                Samples::Float32 => self.writer.write_sample(sample)?,
            }
        }
        Ok(())
    }

    /// Ends the file and puts it in its place. It may have fewer frames than were announced.
    pub fn finish(self) -> Result<(), WriteError> {
        let WavSink {
            path,
            overwrite,
            writer,
            part,
            ..
        } = self;
        (writer.finalize().map_err(as_io))
            .and_then(|()| persist(part, &path, overwrite))
            .map_err(|error| WriteError { path, error })
    }
}

fn too_long() -> io::Error {
    io::Error::new(
        io::ErrorKind::InvalidInput,
        "it would be larger than 4 GiB, which a WAV file cannot be",
    )
}

fn as_io(error: hound::Error) -> io::Error {
    match error {
        hound::Error::IoError(error) => error,
        hound::Error::TooWide => too_long(),
        other => io::Error::other(other),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_sound_comes_back_as_it_was_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new/a.wav");
        let frames = [[0.0, 1.0], [-1.0, 0.5], [f32::NAN, 7.0]];
        let mut sink = WavSink::create(&path, 44_100, Samples::Pcm16, 3, false).unwrap();
        sink.push(&frames[..1]).unwrap();
        sink.push(&frames[1..]).unwrap();
        assert!(!path.exists());
        sink.finish().unwrap();
        let mut reader = hound::WavReader::open(&path).unwrap();
        assert_eq!(
            (reader.spec().channels, reader.spec().sample_rate),
            (2, 44_100)
        );
        let samples: Vec<i16> = reader.samples().map(Result::unwrap).collect();
        assert_eq!(samples, [0, 32767, -32767, 16384, 0, 32767]);

        let mut sink = WavSink::create(&path, 8_000, Samples::Float32, 9, true).unwrap();
        sink.push(&frames).unwrap();
        sink.finish().unwrap();
        let mut reader = hound::WavReader::open(&path).unwrap();
        let samples: Vec<f32> = reader.samples().map(Result::unwrap).collect();
        assert_eq!(samples, [0.0, 1.0, -1.0, 0.5, 0.0, 7.0]);
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
    }

    #[test]
    fn nothing_remains_of_a_sound_that_is_given_up() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.wav");
        let mut sink = WavSink::create(&path, 44_100, Samples::Pcm16, 2, false).unwrap();
        sink.push(&[[0.5; 2]]).unwrap();
        assert!(sink.push(&[[0.5; 2]; 2]).is_err());
        drop(sink);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn what_cannot_be_written_is_refused_before() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.wav");
        for samples in [Samples::Pcm16, Samples::Float32] {
            let frames = samples.most_frames() + 1;
            let error = WavSink::create(&path, 44_100, samples, frames, false).unwrap_err();
            assert!(error.to_string().contains("4 GiB"), "{error}");
        }
        fs::write(&path, "mine").unwrap();
        assert!(WavSink::create(&path, 44_100, Samples::Pcm16, 1, false).is_err());
        assert_eq!(fs::read(&path).unwrap(), b"mine");
    }
}
