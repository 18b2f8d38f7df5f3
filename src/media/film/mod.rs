//! Films: from files through the programs of FFmpeg, and made ones.

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
mod tests;
