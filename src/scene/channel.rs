//! What a pass reads through `iChannel0` to `iChannel3`, and how.

use std::fmt;
use std::path::PathBuf;

use super::{BufferLetter, PassKind};

/// What is bound to one channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Where the texels come from.
    pub input: Input,
    /// How they are read.
    pub sampling: Sampling,
}

/// A source of texels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Input {
    /// The generated noise texture, see [`noise_texture`](super::noise_texture).
    Noise,
    /// A picture.
    Texture(Media),
    /// Six pictures around the viewer.
    Cubemap(Media),
    /// A block of texels.
    Volume(Media),
    /// What a buffer pass drew, this frame if it is drawn before the reader, else in the last one. A
    /// scene may read a buffer that no pass draws: it stays clear.
    Buffer(BufferLetter),
    /// What the cubemap pass drew.
    CubeBuffer,
    /// Which keys are held, were just pressed, and are toggled.
    Keyboard,
    /// Spectrum and waveform of a piece of music.
    Music(Media),
    /// The same of music from a streaming service.
    MusicStream(Media),
    /// The same of the microphone.
    Mic,
    /// A film.
    Video(Media),
    /// The camera.
    Webcam,
}

impl Input {
    /// What this kind of input is called: in a manifest, by the site's JSON, or by its tab.
    pub fn name(&self) -> &'static str {
        match self {
            Input::Noise => "noise",
            Input::Texture(_) => "texture",
            Input::Cubemap(_) => "cubemap",
            Input::Volume(_) => "volume",
            Input::Buffer(letter) => letter.pass_name(),
            Input::CubeBuffer => "Cube A",
            Input::Keyboard => "keyboard",
            Input::Music(_) => "music",
            Input::MusicStream(_) => "musicstream",
            Input::Mic => "mic",
            Input::Video(_) => "video",
            Input::Webcam => "webcam",
        }
    }

    /// How the channel is declared.
    pub fn sampler(&self) -> SamplerKind {
        match self {
            Input::Cubemap(_) | Input::CubeBuffer => SamplerKind::Cube,
            Input::Volume(_) => SamplerKind::ThreeD,
            _ => SamplerKind::TwoD,
        }
    }

    /// The pass that draws it, if one does.
    pub fn pass(&self) -> Option<PassKind> {
        match self {
            Input::Buffer(letter) => Some(PassKind::Buffer(*letter)),
            Input::CubeBuffer => Some(PassKind::Cube),
            _ => None,
        }
    }

    /// Which file it is, if it is one.
    pub fn media(&self) -> Option<&Media> {
        match self {
            Input::Texture(media)
            | Input::Cubemap(media)
            | Input::Volume(media)
            | Input::Music(media)
            | Input::MusicStream(media)
            | Input::Video(media) => Some(media),
            _ => None,
        }
    }
}

/// Where the texels or the sounds of an input lie.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Media {
    /// One of the site's files, as its JSON names it. Both are text that came with the scene: a path here is a name to
    /// look up, never one to open.
    Site {
        /// Six characters, or a number in the public interface.
        id: String,
        /// A path on the site, or the address of a stream.
        path: String,
    },
    /// Files on the user's disk: one, or the six faces of a cubemap in the order +X, −X, +Y, −Y, +Z, −Z. They lie where
    /// the form of the scene allows it, or were named by the user.
    Files(Vec<PathBuf>),
}

impl fmt::Display for Media {
    /// Its path.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Media::Site { path, .. } => f.write_str(path),
            Media::Files(files) => match &**files {
                [first, ..] => first.display().fmt(f),
                [] => Ok(()),
            },
        }
    }
}

/// The types of sampler that a channel can be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SamplerKind {
    /// `sampler2D`, also what an unbound channel is.
    #[default]
    TwoD,
    /// `sampler3D`
    ThreeD,
    /// `samplerCube`
    Cube,
}

impl SamplerKind {
    /// The type's name in GLSL.
    pub fn glsl(self) -> &'static str {
        match self {
            SamplerKind::TwoD => "sampler2D",
            SamplerKind::ThreeD => "sampler3D",
            SamplerKind::Cube => "samplerCube",
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
    /// Whether v = 0 is the bottom row of a picture. Only textures, cubemaps, films and the camera
    /// heed it.
    pub vflip: bool,
}

impl Sampling {
    /// How the site reads a new input of this kind, and one whose JSON does not say how.
    pub fn usual(input: &Input) -> Sampling {
        let (filter, wrap, vflip) = match input {
            Input::Noise | Input::Texture(_) | Input::Volume(_) => {
                (Filter::Mipmap, Wrap::Repeat, true)
            }
            Input::Cubemap(_) | Input::CubeBuffer => (Filter::Mipmap, Wrap::Clamp, false),
            // Between keys there is nothing.
            Input::Keyboard => (Filter::Nearest, Wrap::Clamp, true),
            Input::Buffer(_)
            | Input::Music(_)
            | Input::MusicStream(_)
            | Input::Mic
            | Input::Video(_)
            | Input::Webcam => (Filter::Linear, Wrap::Clamp, true),
        };
        Sampling {
            filter,
            wrap,
            vflip,
        }
    }
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
    /// The texture again, every other time the wrong way round. The site does not have it.
    Mirror,
}

impl Wrap {
    /// The spelling of the site's JSON and of manifests.
    pub fn name(self) -> &'static str {
        match self {
            Wrap::Clamp => "clamp",
            Wrap::Repeat => "repeat",
            Wrap::Mirror => "mirror",
        }
    }
}
