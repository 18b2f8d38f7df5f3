use std::io;
use std::path::PathBuf;

/// Why a picture, a sound or a film cannot be had.
#[derive(Debug, thiserror::Error)]
pub enum MediaError {
    /// A file cannot be read.
    #[error("cannot read `{path}`: {error}")]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: io::Error,
    },
    /// A file is something else.
    #[error("`{path}` is no {what} that can be read: {words}")]
    NotA {
        /// The file.
        path: PathBuf,
        /// What it should be, as in "picture".
        what: &'static str,
        /// What the decoder said.
        words: String,
    },
    /// A file is larger than what is accepted. It was not decoded.
    #[error("`{path}` is too large: {words}")]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// How large, and what the limit is.
        words: String,
    },
    /// A file ends before what its beginning announces.
    #[error("`{path}` is cut short: {words}")]
    CutShort {
        /// The file.
        path: PathBuf,
        /// What is missing.
        words: String,
    },
    /// Films are decoded by another program, which is not there.
    #[error("cannot play `{path}`: the program `{program}` is not there")]
    NoFfmpeg {
        /// The file.
        path: PathBuf,
        /// Which program.
        program: &'static str,
    },
    /// The user's folder has no such file, and there is no stand-in.
    #[error("there is no `{name}` among the site's media")]
    Unknown {
        /// How the scene names it.
        name: String,
    },
}

impl MediaError {
    /// The way out, or nothing.
    pub fn hint(&self) -> &'static str {
        match self {
            MediaError::Io { .. } => "does the file exist, and may you read it?",
            MediaError::NotA { what, .. } => match *what {
                "picture" => "pictures are PNG, JPEG, WebP, GIF, HDR or EXR",
                "volume" => {
                    "volumes begin with 20 bytes: `BIN`, a zero, width, height and depth, then channels and format"
                }
                "cubemap" => {
                    "a cubemap is six square pictures, `sky.png` with `sky_1.png` to `sky_5.png`, or one cross or strip"
                }
                _ => "",
            },
            MediaError::TooLarge { .. } => "make it smaller with a program for it",
            MediaError::CutShort { .. } => "fetch or write the file again",
            MediaError::NoFfmpeg { .. } => {
                "install ffmpeg: `apt install ffmpeg`, `brew install ffmpeg` or `winget install ffmpeg`"
            }
            MediaError::Unknown { .. } => "`vitrine media` lists what there is",
        }
    }
}
