//! Why a file cannot stand behind an input.

use std::fmt;
use std::io;
use std::path::PathBuf;
use std::time::Duration;

/// Why a picture, a volume, a sound or a film cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum MediaError {
    /// The system does not give the file.
    #[error("cannot read `{}`: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: io::Error,
    },
    /// The file holds something else.
    #[error("`{}` is no {what}: {words}", path.display())]
    NotA {
        /// The file.
        path: PathBuf,
        /// What it should be, behind "no": "picture", "volume", "sound" or "film".
        what: &'static str,
        /// What the decoder said.
        words: String,
    },
    /// It has more texels than a texture can have.
    #[error("`{}` has {} texels; at most {limit} a side can be used", path.display(), Size(*size))]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Width, height and depth in texels; what is flat has the depth 1.
        size: [u32; 3],
        /// The most texels that a side may have.
        limit: u32,
    },
    /// It lasts longer than what is kept in memory.
    #[error("`{}` lasts more than {} minutes", path.display(), limit.as_secs() / 60)]
    TooLong {
        /// The file.
        path: PathBuf,
        /// The longest that is taken.
        limit: Duration,
    },
    /// The file ends before what it announces.
    #[error("`{}` is cut short: {words}", path.display())]
    CutShort {
        /// The file.
        path: PathBuf,
        /// What is missing.
        words: String,
    },
    /// The site has no such file.
    #[error("there is no `{name}` among the site's media")]
    Unknown {
        /// How the scene names it.
        name: String,
    },
    /// The programs that decode films are not there.
    #[error("films need the programs `ffmpeg` and `ffprobe`, which are not in the PATH")]
    NoFfmpeg,
}

impl MediaError {
    /// What the user can do about it, as a sentence without a capital and a full stop.
    pub fn hint(&self) -> &'static str {
        match self {
            MediaError::Io { error, .. } => match error.kind() {
                io::ErrorKind::NotFound => "look whether the name is spelled as the file's",
                io::ErrorKind::PermissionDenied => {
                    "look whether you are allowed to read the file and its folder"
                }
                _ => "name a file that can be read from beginning to end",
            },
            MediaError::NotA { what, .. } => match *what {
                "sound" => "sounds can be MP3, Ogg Vorbis, WAV, FLAC, or AAC in MP4",
                "film" => "films can be MP4, WebM, Matroska, Ogg, AVI, MPEG, FLV, GIF or Y4M",
                "volume" => "volumes are the site's `.bin` files",
                "picture" => "pictures can be PNG, JPEG, WebP, GIF, HDR or EXR",
                "cubemap" => {
                    "a cubemap is six square pictures, `sky.png` with `sky_1.png` to `sky_5.png`, or one cross or strip"
                }
                _ => "convert the file to a common format, or look whether it is damaged",
            },
            MediaError::TooLarge { .. } => "scale it down",
            MediaError::TooLong { .. } => "cut out the part that you need",
            MediaError::CutShort { .. } => "copy or download the file again",
            MediaError::Unknown { .. } => "`vitrine media` lists what there is",
            MediaError::NoFfmpeg => {
                "install FFmpeg: `apt install ffmpeg` on Debian and Ubuntu, `brew install ffmpeg` on macOS, \
                 `winget install Gyan.FFmpeg` on Windows"
            }
        }
    }
}

/// A size in words.
struct Size([u32; 3]);

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height, depth] = self.0;
        write!(f, "{width} × {height}")?;
        if depth != 1 {
            write!(f, " × {depth}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_name_the_file_and_the_limit() {
        let flat = MediaError::TooLarge {
            path: "a.png".into(),
            size: [9000, 20, 1],
            limit: 8192,
        };
        assert_eq!(
            flat.to_string(),
            "`a.png` has 9000 × 20 texels; at most 8192 a side can be used"
        );
        let long = MediaError::TooLong {
            path: "a.mp3".into(),
            limit: Duration::from_secs(1200),
        };
        assert_eq!(long.to_string(), "`a.mp3` lasts more than 20 minutes");
    }

    #[test]
    fn whoever_lacks_ffmpeg_is_told_where_it_comes_from() {
        let hint = MediaError::NoFfmpeg.hint();
        for word in ["apt", "brew", "winget"] {
            assert!(hint.contains(word), "{hint}");
        }
    }
}
