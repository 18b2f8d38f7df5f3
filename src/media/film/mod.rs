//! Films: from files through the programs of FFmpeg, and made ones.

mod painter;
mod probe;
mod stream;
mod test_card;

use std::fmt;
use std::path::{Path, PathBuf};
use std::time::Duration;

pub use test_card::TestCard;

use super::feed::{Feed, sane};
use super::{Format, MediaError};
use probe::{Facts, not_a};
use stream::{Next, Stream};

/// How long a picture is waited for. Then the one before stays.
const PATIENCE: Duration = Duration::from_secs(5);
/// How far forward it is quicker to decode everything than to start anew, in seconds.
const NEAR: f64 = 3.0;

/// A film in a file, decoded by a child process. It begins again behind its end.
///
/// Pictures stand on a grid of the film's own rate; a film whose pictures last differently has them on the grid of its
/// shortest. ffmpeg reads this file alone: no network, and no other file that its content may name.
pub struct Film {
    path: PathBuf,
    facts: Facts,
    stream: Option<Stream>,
    /// The beginning, decoded while the end is shown.
    again: Option<Stream>,
    picture: Vec<u8>,
    /// The number of `picture`.
    shown: u64,
    /// The number of the picture that was given out last.
    given: Option<u64>,
    /// The number of the last picture that there is; found out when it is reached.
    last: u64,
}

impl fmt::Debug for Film {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (f.debug_struct("Film").field("path", &self.path))
            .field("facts", &self.facts)
            .field("shown", &self.shown)
            .finish_non_exhaustive()
    }
}

impl Film {
    /// Asks ffprobe what it is, and decodes its first picture. It may have 4096 texels a side.
    pub fn open(path: &Path) -> Result<Film, MediaError> {
        let facts = probe::probe(path)?;
        let mut stream = Stream::start(path, &facts, 0)?;
        let picture = match stream.next(3 * PATIENCE) {
            Next::Picture(_, picture) => picture,
            Next::Ended => {
                let words = stream.complaint();
                return Err(not_a(
                    path,
                    words.as_deref().unwrap_or("it has no pictures"),
                ));
            }
            Next::Late => return Err(not_a(path, "ffmpeg gave no picture within 15 seconds")),
        };
        Ok(Film {
            path: path.to_owned(),
            last: (facts.seconds * facts.rate()).ceil() as u64,
            facts,
            stream: Some(stream),
            again: None,
            picture,
            shown: 0,
            given: None,
        })
    }

    /// How long it lasts, in seconds.
    pub fn seconds(&self) -> f64 {
        self.facts.seconds
    }

    /// Makes `picture` the one with that number, or the nearest that can be had.
    fn go_to(&mut self, wanted: u64) {
        let near = (NEAR * self.facts.rate()) as u64;
        let reaches = |stream: &Option<Stream>, wanted: u64| {
            (stream.as_ref()).is_some_and(|s| s.next <= wanted && wanted <= s.next + near)
        };
        let mut wanted = wanted.min(self.last);
        if wanted == self.shown {
            return;
        }
        if !reaches(&self.stream, wanted) {
            self.stream = match reaches(&self.again, wanted) {
                true => self.again.take(),
                // A program that cannot be started now could be when the film was opened: the picture stays.
                false => Stream::start(&self.path, &self.facts, wanted).ok(),
            };
        }
        while let Some(stream) = &mut self.stream {
            match stream.next(PATIENCE) {
                Next::Picture(number, picture) => {
                    stream.give_back(std::mem::replace(&mut self.picture, picture));
                    self.shown = number;
                    if number >= wanted {
                        break;
                    }
                }
                Next::Late => break,
                Next::Ended if stream.next > stream.first => {
                    self.last = stream.next - 1;
                    break;
                }
                // Sound may go on where there are no pictures any more: the last one is shown, wherever it is.
                Next::Ended if stream.first > 0 => {
                    wanted = stream.first - 1;
                    let first = stream.first.saturating_sub(near + 1);
                    self.last = wanted;
                    self.stream = Stream::start(&self.path, &self.facts, first).ok();
                }
                Next::Ended => break,
            }
        }
        let soon = (0.5 * self.facts.rate()) as u64;
        if self.last > 4 * soon && self.shown + soon > self.last && self.again.is_none() {
            self.again = Stream::start(&self.path, &self.facts, 0).ok();
        }
    }
}

impl Feed for Film {
    fn size(&self) -> [u32; 2] {
        self.facts.size
    }

    fn format(&self) -> Format {
        Format::Rgba8
    }

    fn position(&self, time: f64) -> f64 {
        sane(time) % self.facts.seconds
    }

    fn texels(&mut self, time: f64) -> Option<&[u8]> {
        // A hundredth of a picture, so that times on the grid do not fall below it by rounding.
        let number = (self.position(time) * self.facts.rate() + 0.01) as u64;
        self.go_to(number);
        if self.given == Some(self.shown) {
            return None;
        }
        self.given = Some(self.shown);
        Some(&self.picture)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::process::Command;

    use super::*;

    /// Films whose picture number n is grey, 8 · (n mod 32) bright, at 10 pictures a second; `None` without ffmpeg.
    fn film(folder: &Path, name: &str, more: &[&str]) -> Option<PathBuf> {
        let path = folder.join(name);
        let made = Command::new("ffmpeg")
            .args(["-v", "error", "-f", "lavfi", "-i"])
            .arg("color=black:size=64x48:rate=10:duration=12,format=gray,geq=lum='8*mod(N,32)'")
            .args(more)
            .arg(Path::new(".").join(&path))
            .status();
        let is_made = made.is_ok_and(|status| status.success());
        if !is_made {
            eprintln!("skipped: no ffmpeg that can make {name}");
        }
        is_made.then_some(path)
    }

    /// The number modulo 32 of the picture that the film shows.
    fn number(film: &mut Film, time: f64) -> Option<u8> {
        film.texels(time).map(|texels| {
            assert_eq!(texels.len(), 4 * 64 * 48);
            assert_eq!(texels[3], 255);
            (texels[4 * 1000] + 4) / 8
        })
    }

    #[test]
    fn pictures_follow_the_time_wherever_it_goes() {
        let folder = tempfile::tempdir().unwrap();
        for (name, codec) in [
            (
                "a.mp4",
                &["-c:v", "libx264", "-g", "25", "-pix_fmt", "yuv444p"][..],
            ),
            ("a.webm", &["-c:v", "libvpx", "-b:v", "1M", "-g", "40"]),
            ("a.avi", &["-c:v", "ffv1"]),
        ] {
            let Some(path) = film(folder.path(), name, codec) else {
                continue;
            };
            let mut film = Film::open(&path).unwrap();
            assert_eq!((film.size(), film.format()), ([64, 48], Format::Rgba8));
            assert!((film.seconds() - 12.0).abs() < 0.01, "{}", film.seconds());
            for frame in 0_u8..40 {
                let shown = number(&mut film, f64::from(frame) / 20.0);
                let wanted = frame.is_multiple_of(2).then_some(frame / 2);
                assert_eq!(shown, wanted, "{name} {frame}");
            }
            for (time, wanted) in [
                (0.0, 0),
                (11.95, 119),
                (6.0, 60),
                (6.5, 65),
                (9.95, 99),
                (0.31, 3),
            ] {
                assert_eq!(number(&mut film, time), Some(wanted % 32), "{name} {time}");
            }
            assert_eq!(number(&mut film, 0.35), None);
            for tenth in 115..125 {
                let shown = number(&mut film, f64::from(tenth) / 10.0);
                assert_eq!(shown, Some((tenth % 120 % 32) as u8), "{name} {tenth}");
            }
            assert!((film.position(25.0) - 1.0).abs() < 0.05);
            assert_eq!(number(&mut film, f64::NAN), Some(0));
        }
    }

    #[test]
    fn where_only_sound_goes_on_the_last_picture_stays() {
        let folder = tempfile::tempdir().unwrap();
        let sound = [
            "-f",
            "lavfi",
            "-i",
            "sine=duration=20",
            "-c:v",
            "ffv1",
            "-c:a",
            "pcm_s16le",
        ];
        let Some(path) = film(folder.path(), "a.mkv", &sound) else {
            return;
        };
        let mut film = Film::open(&path).unwrap();
        for time in [19.0, 1.0, 12.5, 19.5] {
            let wanted = if time > 12.0 { 119 % 32 } else { 10 };
            if let Some(shown) = number(&mut film, time) {
                assert_eq!(shown, wanted, "{time}");
            }
        }
        assert_eq!(film.shown, 119);
    }

    #[test]
    fn strange_names_are_only_names() {
        let folder = tempfile::tempdir().unwrap();
        let Some(path) = film(folder.path(), "a.avi", &["-c:v", "ffv1", "-t", "1"]) else {
            return;
        };
        for name in ["-i", "http:", "concat:a.avi|b.avi", "a%03d.avi", "-"] {
            let strange = folder.path().join(name);
            if fs::copy(&path, &strange).is_ok() {
                assert!(Film::open(&strange).is_ok(), "{name}");
            }
        }
    }

    #[test]
    fn what_is_no_film_is_told_so() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.mp4");
        let missing = Film::open(&path).unwrap_err();
        assert!(matches!(missing, MediaError::Io { .. }), "{missing}");
        for bytes in [
            &b""[..],
            b"#EXTM3U\nhttp://localhost/a.ts\n",
            b"ffconcat version 1.0\nfile 'b.mp4'\n",
            b"\0\0\0\x20ftypisom and nothing else",
            b"\x1a\x45\xdf\xa3",
        ] {
            fs::write(&path, bytes).unwrap();
            let error = Film::open(&path).unwrap_err();
            let is_told = matches!(
                error,
                MediaError::NotA { what: "film", .. } | MediaError::NoFfmpeg
            );
            assert!(is_told, "{error}");
        }
    }

    #[test]
    fn a_film_that_is_cut_short_is_shown_as_far_as_it_goes() {
        let folder = tempfile::tempdir().unwrap();
        let Some(path) = film(folder.path(), "a.mkv", &["-c:v", "ffv1"]) else {
            return;
        };
        let whole = fs::read(&path).unwrap();
        fs::write(&path, &whole[..whole.len() / 2]).unwrap();
        let mut film = Film::open(&path).unwrap();
        assert_eq!(number(&mut film, 1.0), Some(10));
        let late = number(&mut film, 11.9).expect("another picture");
        assert!(film.shown > 20 && film.shown < 119, "{late} {}", film.shown);
    }
}
