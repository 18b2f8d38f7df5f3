//! Scenes: what to draw, with every reference resolved, before any GPU is involved.
//!
//! [`load()`] turns one form of input (a single file, a folder, a text) into a [`Scene`], or says what
//! is wrong with it. After that nothing about a scene can fail.

mod file;
mod folder;
mod load;
mod noise;

pub use load::{LoadError, LoadErrorKind, MAX_BYTES, Source, load};
pub use noise::{NOISE_SIZE, noise_texture};

use std::path::PathBuf;

use crate::source::{FileId, SourceMap};

/// The number of input channels of a pass, `iChannel0` to `iChannel3`.
pub const CHANNELS: usize = 4;

/// A scene, ready to be translated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scene {
    /// What the scene is called, for titles and file names.
    pub name: String,
    /// The texts that the scene consists of.
    pub files: SourceMap,
    /// Passes in the order they are drawn; the Image pass is the last.
    pub passes: Vec<Pass>,
    /// The files that were read from disk: a change to one of them is a change to the scene.
    pub read: Vec<PathBuf>,
}

impl Scene {
    /// The pass whose colour is the picture.
    pub fn image(&self) -> &Pass {
        self.passes
            .last()
            .expect("a loaded scene has an Image pass")
    }
}

/// One full-screen shader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pass {
    /// Which of ShaderToy's tabs this is.
    pub kind: PassKind,
    /// The texts that make up the pass, in order: every Common text, then the pass's own.
    pub sources: Vec<FileId>,
    /// What `iChannel0` to `iChannel3` read; an unbound channel reads (0, 0, 0, 1).
    pub channels: [Option<Channel>; CHANNELS],
}

/// ShaderToy's kinds of pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassKind {
    /// Draws the picture; its alpha is ignored.
    Image,
}

impl PassKind {
    /// The site's name of the tab.
    pub fn name(self) -> &'static str {
        match self {
            PassKind::Image => "Image",
        }
    }
}

/// What is bound to one channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Where the texels come from.
    pub input: Input,
    /// How they are read.
    pub sampling: Sampling,
}

/// A source of texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The generated noise texture, see [`noise_texture`].
    Noise,
}

impl Input {
    /// The name that a manifest and `inspect` use.
    pub fn name(self) -> &'static str {
        match self {
            Input::Noise => "noise",
        }
    }
}

/// ShaderToy's sampler settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Between texels.
    pub filter: Filter,
    /// Beyond the edges.
    pub wrap: Wrap,
}

/// How a value between texels is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Filter {
    /// The texel nearest to the coordinate.
    Nearest,
    /// Linear between the four texels around it; no smaller levels exist.
    Linear,
    /// As `Linear`, and linear between levels where the texture is shrunk.
    Mipmap,
}

impl Filter {
    /// The site's spelling.
    pub fn name(self) -> &'static str {
        match self {
            Filter::Nearest => "nearest",
            Filter::Linear => "linear",
            Filter::Mipmap => "mipmap",
        }
    }
}

/// What lies beyond the edges of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Wrap {
    /// The edge texel.
    Clamp,
    /// The texture again.
    Repeat,
}

impl Wrap {
    /// The site's spelling.
    pub fn name(self) -> &'static str {
        match self {
            Wrap::Clamp => "clamp",
            Wrap::Repeat => "repeat",
        }
    }
}
