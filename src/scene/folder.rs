//! A folder: `scene.toml` names the texts and what is bound to the channels. Without one,
//! `image.glsl` is the Image pass and `common.glsl`, if present, its Common.

use std::path::{Component, Path, PathBuf};

use serde::Deserialize;
use toml::Spanned;

use super::load::{Failure, Loading, Parts};
use super::{CHANNELS, Channel, Filter, Input, Pass, PassKind, Sampling, Wrap, file};
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
    image: ImageEntry,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ImageEntry {
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

impl ImageEntry {
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

/// Filter and wrap default to what the site gives a new texture.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChannelEntry {
    procedural: Procedural,
    #[serde(default = "mipmap")]
    filter: Filter,
    #[serde(default = "repeat")]
    wrap: Wrap,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Procedural {
    Noise,
}

fn mipmap() -> Filter {
    Filter::Mipmap
}

fn repeat() -> Wrap {
    Wrap::Repeat
}

impl ChannelEntry {
    fn channel(&self) -> Channel {
        Channel {
            input: match self.procedural {
                Procedural::Noise => Input::Noise,
            },
            sampling: Sampling {
                filter: self.filter,
                wrap: self.wrap,
                vflip: true,
            },
        }
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
    let common = folder.join("common.glsl");
    let mut sources = Vec::new();
    if loading.is_file(&common) {
        sources.push(loading.read(&common)?);
    } else {
        loading.depends_on(&common);
    }
    sources.push(loading.read(&image)?);
    image_scene(loading, folder_name, sources, Default::default())
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
    let mut sources = Vec::new();
    for entry in manifest.common.iter().chain([&manifest.image.source]) {
        sources.push(referred(loading, folder, id, entry)?);
    }
    let channels = manifest.image.channels();
    image_scene(
        loading,
        manifest.name.unwrap_or(folder_name),
        sources,
        channels,
    )
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

fn image_scene(
    loading: &Loading,
    name: String,
    sources: Vec<FileId>,
    channels: [Option<Channel>; CHANNELS],
) -> Result<Parts, Failure> {
    if let Some(&own) = sources.last() {
        file::refuse_empty(&loading.files, own)?;
    }
    let kind = PassKind::Image;
    Ok(Parts {
        name,
        passes: vec![Pass {
            kind,
            sources,
            channels,
        }],
    })
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
