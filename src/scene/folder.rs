//! A folder: `scene.toml` names the texts and what is bound to the channels. Without one,
//! `image.glsl` is the Image pass, `buffer_a.glsl` to `buffer_d.glsl` are buffers and `common.glsl`, if
//! present, is the Common of all.

use std::path::{Component, Path, PathBuf};

use serde::Deserialize;
use toml::Spanned;

use super::load::{Failure, Loading, Parts};
use super::{BufferLetter, CHANNELS, Channel, Filter, Input, Pass, PassKind, Sampling, Wrap, file};
use crate::source::{Diagnostic, FileId, Span};

const MANIFEST: &str = "scene.toml";

/// The folder of the embedded scene, as [`embedded`] spells it.
pub(super) const EMBEDDED: &str = "template";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Manifest {
    name: Option<String>,
    /// For people who read the manifest; the program shows it nowhere.
    #[serde(rename = "description")]
    _description: Option<String>,
    #[serde(default)]
    common: Vec<Spanned<String>>,
    /// In which order the buffers are drawn, if it is not that of the alphabet.
    order: Option<Spanned<Vec<Letter>>>,
    buffer_a: Option<PassEntry>,
    buffer_b: Option<PassEntry>,
    buffer_c: Option<PassEntry>,
    buffer_d: Option<PassEntry>,
    image: PassEntry,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PassEntry {
    source: Spanned<String>,
    #[serde(rename = "iChannel0")]
    channel0: Option<ChannelEntry>,
    #[serde(rename = "iChannel1")]
    channel1: Option<ChannelEntry>,
    #[serde(rename = "iChannel2")]
    channel2: Option<ChannelEntry>,
    #[serde(rename = "iChannel3")]
    channel3: Option<ChannelEntry>,
}

impl PassEntry {
    fn channels(&self) -> [Option<Channel>; CHANNELS] {
        [
            &self.channel0,
            &self.channel1,
            &self.channel2,
            &self.channel3,
        ]
        .map(|entry| entry.as_ref().map(ChannelEntry::channel))
    }
}

/// A channel is bound to one thing. Filter and wrap default to what the site gives a new input of its kind.
#[derive(Deserialize)]
#[serde(try_from = "ChannelKeys")]
struct ChannelEntry {
    input: Input,
    filter: Option<Filter>,
    wrap: Option<Wrap>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChannelKeys {
    procedural: Option<Procedural>,
    buffer: Option<Letter>,
    #[serde(default)]
    keyboard: bool,
    filter: Option<Filter>,
    wrap: Option<Wrap>,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Procedural {
    Noise,
}

/// A buffer, as a manifest spells it.
#[derive(Clone, Copy, PartialEq, Deserialize)]
enum Letter {
    A,
    B,
    C,
    D,
}

impl Letter {
    fn buffer(self) -> BufferLetter {
        BufferLetter::ALL[self as usize]
    }
}

impl TryFrom<ChannelKeys> for ChannelEntry {
    type Error = &'static str;

    fn try_from(keys: ChannelKeys) -> Result<Self, Self::Error> {
        let input = match (keys.procedural, keys.buffer, keys.keyboard) {
            (Some(Procedural::Noise), None, false) => Input::Noise,
            (None, Some(letter), false) => Input::Buffer(letter.buffer()),
            (None, None, true) => Input::Keyboard,
            _ => {
                return Err(
                    "a channel is bound to one thing: `procedural = \"noise\"`, `keyboard = true`, or a buffer as in `buffer = \"A\"`",
                );
            }
        };
        Ok(ChannelEntry {
            input,
            filter: keys.filter,
            wrap: keys.wrap,
        })
    }
}

impl ChannelEntry {
    fn channel(&self) -> Channel {
        let mut sampling = usual_sampling(&self.input);
        // Between keys there is nothing.
        if self.input != Input::Keyboard {
            sampling.filter = self.filter.unwrap_or(sampling.filter);
            sampling.wrap = self.wrap.unwrap_or(sampling.wrap);
        }
        Channel {
            input: self.input.clone(),
            sampling,
        }
    }
}

/// How the site reads a new input of this kind.
fn usual_sampling(input: &Input) -> Sampling {
    let (filter, wrap) = match input {
        Input::Buffer(_) => (Filter::Linear, Wrap::Clamp),
        Input::Keyboard => (Filter::Nearest, Wrap::Clamp),
        _ => (Filter::Mipmap, Wrap::Repeat),
    };
    Sampling {
        filter,
        wrap,
        vflip: true,
    }
}

pub(super) fn load(loading: &mut Loading, folder: &Path) -> Result<Parts, Failure> {
    // The folder's own name, also when it was given as `.`.
    let real = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let folder_name = real.file_name().map_or_else(
        || "scene".into(),
        |name| name.to_string_lossy().into_owned(),
    );
    let manifest = folder.join(MANIFEST);
    if loading.is_file(&manifest) {
        return from_manifest(loading, folder, &manifest, folder_name);
    }
    loading.depends_on(&manifest);
    let image = folder.join("image.glsl");
    if !loading.is_file(&image) {
        loading.depends_on(&image);
        return Err(Diagnostic::error(
            "no-scene",
            format!("the folder `{}` holds no scene", folder.display()),
        )
        .hint("a scene folder has a `scene.toml`, or an `image.glsl` (and perhaps a `common.glsl`)")
        .into());
    }
    let common = optional(loading, folder, "common.glsl")?;
    let mut passes = Vec::new();
    for letter in BufferLetter::ALL {
        if let Some(own) = optional(loading, folder, buffer_file(letter))? {
            passes.push((PassKind::Buffer(letter), own));
        }
    }
    // Without a manifest, each pass reads Buffer A through iChannel0, Buffer B through iChannel1 and so on.
    let mut channels = [const { None }; CHANNELS];
    for (kind, _) in &passes {
        if let PassKind::Buffer(letter) = *kind {
            let input = Input::Buffer(letter);
            let sampling = usual_sampling(&input);
            channels[letter.index()] = Some(Channel { input, sampling });
        }
    }
    passes.push((PassKind::Image, loading.read(&image)?));
    let passes = passes.into_iter().map(|(kind, own)| Pass {
        kind,
        sources: common.into_iter().chain([own]).collect(),
        channels: channels.clone(),
    });
    scene(loading, folder_name, passes.collect())
}

/// Reads a file that a scene may have.
fn optional(loading: &mut Loading, folder: &Path, name: &str) -> Result<Option<FileId>, Failure> {
    let path = folder.join(name);
    if loading.is_file(&path) {
        return Ok(Some(loading.read(&path)?));
    }
    loading.depends_on(&path);
    Ok(None)
}

fn buffer_file(letter: BufferLetter) -> &'static str {
    [
        "buffer_a.glsl",
        "buffer_b.glsl",
        "buffer_c.glsl",
        "buffer_d.glsl",
    ][letter.index()]
}

fn from_manifest(
    loading: &mut Loading,
    folder: &Path,
    path: &Path,
    folder_name: String,
) -> Result<Parts, Failure> {
    let id = loading.read(path)?;
    let manifest: Manifest = match toml::from_str(&loading.files.get(id).text) {
        Ok(manifest) => manifest,
        Err(error) => {
            let range = error.span().unwrap_or(0..0);
            return Err(Diagnostic::error("manifest", error.message())
                .at(span(id, range))
                .hint("docs/cli.md describes scene.toml")
                .into());
        }
    };
    let mut common = Vec::new();
    for entry in &manifest.common {
        common.push(referred(loading, folder, id, entry)?);
    }
    let mut passes = Vec::new();
    for letter in manifest.order(id)? {
        if let Some(entry) = manifest.buffer(letter) {
            passes.push((PassKind::Buffer(letter), entry));
        }
    }
    passes.push((PassKind::Image, &manifest.image));
    let mut read = Vec::new();
    for (kind, entry) in passes {
        let own = referred(loading, folder, id, &entry.source)?;
        read.push(Pass {
            kind,
            sources: common.iter().copied().chain([own]).collect(),
            channels: entry.channels(),
        });
    }
    let name = manifest.name.clone().unwrap_or(folder_name);
    scene(loading, name, read)
}

impl Manifest {
    fn buffer(&self, letter: BufferLetter) -> Option<&PassEntry> {
        let entries = [
            &self.buffer_a,
            &self.buffer_b,
            &self.buffer_c,
            &self.buffer_d,
        ];
        entries[letter.index()].as_ref()
    }

    /// The order of the buffers; one that is given names each of them once.
    fn order(&self, manifest: FileId) -> Result<Vec<BufferLetter>, Diagnostic> {
        let Some(order) = &self.order else {
            return Ok(BufferLetter::ALL.into());
        };
        let given: Vec<BufferLetter> = order
            .get_ref()
            .iter()
            .map(|letter| letter.buffer())
            .collect();
        let is_right = BufferLetter::ALL.into_iter().all(|letter| {
            let count = given.iter().filter(|&&other| other == letter).count();
            count == usize::from(self.buffer(letter).is_some())
        });
        match is_right {
            true => Ok(given),
            false => Err(Diagnostic::error(
                "manifest",
                "`order` does not name each buffer of the scene once",
            )
            .at(span(manifest, order.span()))
            .hint("leave it away to draw the buffers in the order of the alphabet")),
        }
    }
}

/// Reads a file that the manifest names. A manifest may come from anywhere, so it reaches no further
/// than the folder that its scene folder lies in, where scenes share their Common.
fn referred(
    loading: &mut Loading,
    folder: &Path,
    manifest: FileId,
    entry: &Spanned<String>,
) -> Result<FileId, Failure> {
    let place = span(manifest, entry.span());
    let name = entry.get_ref();
    let path = without_detours(&folder.join(name));
    let root = folder.join("..");
    if Path::new(name).is_absolute() || !loading.lies_within(&path, &root) {
        return Err(
            Diagnostic::error("manifest", format!("`{name}` lies outside the scene"))
                .at(place)
                .hint(
                    "name a file in the scene folder or in a folder beside it, by a relative path",
                )
                .into(),
        );
    }
    if !loading.is_file(&path) {
        loading.depends_on(&path);
        return Err(Diagnostic::error(
            "manifest",
            format!("there is no file `{}`", path.display()),
        )
        .at(place)
        .hint("paths are relative to the folder of scene.toml")
        .into());
    }
    loading.read(&path)
}

fn scene(loading: &Loading, name: String, passes: Vec<Pass>) -> Result<Parts, Failure> {
    for own in passes.iter().filter_map(|pass| pass.sources.last()) {
        file::refuse_empty(&loading.files, *own)?;
    }
    Ok(Parts { name, passes })
}

/// Leaves out of a path what cancels out, `a/../b` for `b`, so that messages read well. Only where
/// `a` is a real folder: behind a symbolic link, `..` leads elsewhere.
fn without_detours(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        let cancels = part == Component::ParentDir
            && matches!(plain.components().next_back(), Some(Component::Normal(_)))
            && !plain.is_symlink();
        match part {
            Component::CurDir => {}
            _ if cancels => {
                plain.pop();
            }
            part => plain.push(part),
        }
    }
    plain
}

fn span(file: FileId, range: std::ops::Range<usize>) -> Span {
    let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
    Span {
        file,
        start: offset(range.start),
        end: offset(range.end),
    }
}

/// The text of an embedded file; `path` is relative to `shadertoy/`.
pub(super) fn embedded(path: &Path) -> Option<&'static str> {
    macro_rules! table {
        ($($name:literal),* $(,)?) => {
            [$(($name, include_str!(concat!("../../shadertoy/", $name)))),*]
        };
    }
    const FILES: &[(&str, &str)] = &table![
        "template/scene.toml",
        "common/settings.glsl",
        "common/hash.glsl",
        "common/noise.glsl",
        "common/fbm.glsl",
        "common/levels.glsl",
        "common/march.glsl",
        "common/normal.glsl",
        "common/shadow.glsl",
        "common/material.glsl",
        "common/lighting.glsl",
        "common/atmosphere.glsl",
        "common/path.glsl",
        "common/camera.glsl",
        "template/image.glsl",
    ];
    FILES
        .iter()
        .find(|(name, _)| Path::new(name) == path)
        .map(|(_, text)| *text)
}
