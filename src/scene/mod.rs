//! Scenes: what to draw, with every reference resolved, before any GPU is involved.
//!
//! [`load()`] turns one form of input (a single file, a folder, ShaderToy's JSON, a text) into a [`Scene`], or says what
//! is wrong with it. After that nothing about a scene can fail.

mod binding;
mod channel;
mod directive;
mod exchange;
mod file;
mod file_kind;
mod folder;
mod json;
mod load;
mod noise;
pub mod site;

pub use binding::Binding;
pub use channel::{Channel, Filter, Input, Media, SamplerKind, Sampling, Wrap};
pub use exchange::{Imported, Packed, SIDECAR, import, pack};
pub use load::{LoadError, LoadErrorKind, MAX_BYTES, Source, load};
pub use noise::{NOISE_SIZE, noise_texture};

use file_kind::FileKind;

use std::path::PathBuf;

use crate::source::{Diagnostic, FileId, SourceMap, Span};

/// The number of input channels of a pass, `iChannel0` to `iChannel3`.
pub const CHANNELS: usize = 4;

/// A scene, ready to be translated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scene {
    /// What the scene is called, for titles and file names.
    pub name: String,
    /// The size that the scene is made for, width and height in pixels, if it says one.
    pub size: Option<[u32; 2]>,
    /// The texts that the scene consists of.
    pub files: SourceMap,
    /// Passes in the order they are drawn; the Image pass is the last.
    pub passes: Vec<Pass>,
    /// What the author should know although the scene could be loaded.
    pub warnings: Vec<Diagnostic>,
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
    /// Places in the texts that the host has obeyed, in the order of files and places.
    pub splices: Vec<Splice>,
}

impl Pass {
    /// Every text that has a part in the pass: its own and those that come in the place of a directive.
    pub fn texts<'a>(&self, files: &'a SourceMap) -> Vec<&'a str> {
        let spliced = self.splices.iter().filter_map(|splice| splice.text);
        let mut seen = Vec::new();
        for file in self.sources.iter().copied().chain(spliced) {
            if !seen.contains(&file) {
                seen.push(file);
            }
        }
        seen.into_iter()
            .map(|file| &*files.get(file).text)
            .collect()
    }
}

/// A directive for the host, not for GLSL: it counts as a blank line, or as the text that it brings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Splice {
    /// The directive, from its `#` to the end of its line.
    pub place: Span,
    /// What stands there instead, if anything does.
    pub text: Option<FileId>,
}

/// What to say of a channel that reads a pass which the scene does not have.
fn missing_pass(
    reader: PassKind,
    channel: usize,
    input: &Input,
    is_drawn: impl Fn(PassKind) -> bool,
) -> Option<Diagnostic> {
    let read = match input {
        Input::Buffer(letter) => PassKind::Buffer(*letter),
        Input::CubeBuffer => PassKind::Cube,
        _ => return None,
    };
    if is_drawn(read) {
        return None;
    }
    let (reader, read) = (reader.name(), read.name());
    let message = format!(
        "{reader}: iChannel{channel} reads {read}, which the scene does not have: it reads black"
    );
    Some(Diagnostic {
        pass: Some(reader.to_owned()),
        ..Diagnostic::warning("missing-pass", message)
    })
}

/// ShaderToy's kinds of pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PassKind {
    /// Draws the picture; its alpha is ignored.
    Image,
    /// Draws a texture of the picture's size, in floats, that other passes read, alpha included.
    Buffer(BufferLetter),
    /// Draws the six faces of a cubemap that other passes read.
    Cube,
    /// Computes the samples of a sound.
    Sound,
}

impl PassKind {
    /// The site's name of the tab.
    pub fn name(self) -> &'static str {
        match self {
            PassKind::Image => "Image",
            PassKind::Buffer(letter) => letter.pass_name(),
            PassKind::Cube => "Cube A",
            PassKind::Sound => "Sound",
        }
    }
}

/// Which of the four buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "they are letters")]
pub enum BufferLetter {
    A,
    B,
    C,
    D,
}

impl BufferLetter {
    /// Every buffer.
    pub const ALL: [BufferLetter; 4] = [
        BufferLetter::A,
        BufferLetter::B,
        BufferLetter::C,
        BufferLetter::D,
    ];

    /// Its place in the alphabet, from 0.
    pub fn index(self) -> usize {
        self as usize
    }

    /// The site's name of the tab.
    pub fn pass_name(self) -> &'static str {
        ["Buffer A", "Buffer B", "Buffer C", "Buffer D"][self.index()]
    }
}
