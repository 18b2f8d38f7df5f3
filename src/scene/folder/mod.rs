//! A folder: `scene.toml` names the texts and what is bound to the channels. Without one,
//! `image.glsl` is the Image pass, `buffer_a.glsl` to `buffer_d.glsl` are buffers, `cube_a.glsl` is the cubemap,
//! `sound.glsl` the sound, and `common.glsl`, if present, is the Common of all.

mod embedded;
mod manifest;
mod reference;

pub(super) use embedded::{EMBEDDED, embedded};
pub(super) use reference::{Refusal, within};

use std::path::{Path, PathBuf};

use super::load::{Failure, Loading, Parts};
use super::{BufferLetter, CHANNELS, Channel, Input, Pass, PassKind, Sampling, file, missing_pass};
use crate::source::Diagnostic;
use manifest::{Bound, ChannelEntry, Manifest};
use reference::References;

/// The file that says what a scene folder holds.
pub(super) const MANIFEST: &str = "scene.toml";

/// The largest picture that a scene may ask for, each way.
const MAX_SIDE: u32 = 16_384;

/// What a scene folder consists of, before its texts are read.
pub(super) struct Plan {
    /// What the manifest calls the scene.
    pub name: Option<String>,
    /// What the folder is called.
    pub folder_name: String,
    pub description: Option<String>,
    pub size: Option<[u32; 2]>,
    /// The files of the Common texts.
    pub common: Vec<PathBuf>,
    /// In the order in which they are drawn.
    pub passes: Vec<Planned>,
}

/// A pass whose text has not been read.
pub(super) struct Planned {
    pub kind: PassKind,
    pub source: PathBuf,
    pub channels: [Option<Channel>; CHANNELS],
}

pub(super) fn load(loading: &mut Loading, folder: &Path) -> Result<Parts, Failure> {
    let plan = plan(loading, folder)?;
    let mut common = Vec::new();
    for path in &plan.common {
        common.push(loading.read(path)?);
    }
    let mut passes = Vec::new();
    for planned in plan.passes {
        let own = loading.read(&planned.source)?;
        file::refuse_empty(&loading.files, own)?;
        passes.push(Pass {
            kind: planned.kind,
            sources: common.iter().copied().chain([own]).collect(),
            channels: planned.channels,
            splices: Vec::new(),
        });
    }
    Ok(Parts {
        name: plan.name.unwrap_or(plan.folder_name),
        size: plan.size,
        passes,
    })
}

/// Finds out what the folder consists of.
pub(super) fn plan(loading: &mut Loading, folder: &Path) -> Result<Plan, Failure> {
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
    by_names(loading, folder, folder_name)
}

/// A folder whose files have the customary names.
fn by_names(loading: &mut Loading, folder: &Path, folder_name: String) -> Result<Plan, Failure> {
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
    let buffers = BufferLetter::ALL.map(PassKind::Buffer);
    let kinds = [PassKind::Sound].into_iter().chain(buffers);
    let kinds = kinds.chain([PassKind::Cube, PassKind::Image]);
    let mut found = Vec::new();
    for kind in kinds {
        found.extend(optional(loading, folder, file_of(kind)).map(|source| (kind, source)));
    }
    // Without a manifest, each pass reads Buffer A through iChannel0, Buffer B through iChannel1 and so on.
    let mut channels = [const { None }; CHANNELS];
    for (kind, _) in &found {
        if let PassKind::Buffer(letter) = *kind {
            let input = Input::Buffer(letter);
            let sampling = Sampling::usual(&input);
            channels[letter.index()] = Some(Channel { input, sampling });
        }
    }
    let passes = found.into_iter().map(|(kind, source)| Planned {
        kind,
        source,
        // Sound is computed ahead of all pictures.
        channels: match kind {
            PassKind::Sound => Default::default(),
            _ => channels.clone(),
        },
    });
    Ok(Plan {
        name: None,
        folder_name,
        description: None,
        size: None,
        common: optional(loading, folder, "common.glsl")
            .into_iter()
            .collect(),
        passes: passes.collect(),
    })
}

/// A file that a scene may have.
fn optional(loading: &mut Loading, folder: &Path, name: &str) -> Option<PathBuf> {
    let path = folder.join(name);
    let exists = loading.is_file(&path);
    if !exists {
        loading.depends_on(&path);
    }
    exists.then_some(path)
}

/// The customary name of a pass's file.
pub(super) fn file_of(kind: PassKind) -> &'static str {
    match kind {
        PassKind::Image => "image.glsl",
        PassKind::Cube => "cube_a.glsl",
        PassKind::Sound => "sound.glsl",
        PassKind::Buffer(BufferLetter::A) => "buffer_a.glsl",
        PassKind::Buffer(BufferLetter::B) => "buffer_b.glsl",
        PassKind::Buffer(BufferLetter::C) => "buffer_c.glsl",
        PassKind::Buffer(BufferLetter::D) => "buffer_d.glsl",
    }
}

fn from_manifest(
    loading: &mut Loading,
    folder: &Path,
    path: &Path,
    folder_name: String,
) -> Result<Plan, Failure> {
    let id = loading.read(path)?;
    let references = References {
        folder,
        manifest: id,
    };
    let manifest: Manifest = match toml::from_str(&loading.files.get(id).text) {
        Ok(manifest) => manifest,
        Err(error) => {
            let range = error.span().unwrap_or(0..0);
            return Err(Diagnostic::error("manifest", error.message())
                .at(references.span(range))
                .hint("docs/cli.md describes scene.toml")
                .into());
        }
    };
    let mut common = Vec::new();
    for entry in &manifest.common {
        common.push(references.file(loading, entry.get_ref(), entry.span())?);
    }
    let buffers = manifest.buffers().map_err(|place| {
        Diagnostic::error(
            "manifest",
            "`order` does not name each buffer of the scene once",
        )
        .at(references.span(place))
        .hint("leave it away to draw the buffers in the order of the alphabet")
    })?;
    let buffers = buffers.into_iter().map(PassKind::Buffer);
    let kinds = [PassKind::Sound].into_iter().chain(buffers);
    let kinds = kinds.chain([PassKind::Cube, PassKind::Image]);
    let mut passes = Vec::new();
    for (kind, entry) in kinds.filter_map(|kind| Some((kind, manifest.pass(kind)?))) {
        let place = entry.span();
        let entry = entry.get_ref();
        let source = match &entry.source {
            Some(source) => references.file(loading, source.get_ref(), source.span())?,
            None => references.file(loading, file_of(kind), place)?,
        };
        let mut channels = [const { None }; CHANNELS];
        for (index, entry) in entry.channels().into_iter().enumerate() {
            let Some(entry) = entry else { continue };
            let channel = channel(loading, &references, entry.get_ref())?;
            let place = references.span(entry.span());
            let is_drawn = |kind| manifest.pass(kind).is_some();
            let missing = missing_pass(kind, index, &channel.input, is_drawn);
            loading
                .warnings
                .extend(missing.map(|found| found.at(place)));
            channels[index] = Some(channel);
        }
        passes.push(Planned {
            kind,
            source,
            channels,
        });
    }
    Ok(Plan {
        name: manifest.name.clone(),
        folder_name,
        size: size(&manifest, &references)?,
        description: manifest.description,
        common,
        passes,
    })
}

fn channel(
    loading: &mut Loading,
    references: &References<'_>,
    entry: &ChannelEntry,
) -> Result<Channel, Failure> {
    let input = match &entry.bound {
        Bound::Input(input) => input.clone(),
        Bound::File(kind, name) => references.input(loading, *kind, name)?,
    };
    let mut sampling = Sampling::usual(&input);
    // Between keys there is nothing.
    if input != Input::Keyboard {
        sampling.filter = entry.filter.unwrap_or(sampling.filter);
        sampling.wrap = entry.wrap.unwrap_or(sampling.wrap);
        sampling.vflip = entry.vflip.unwrap_or(sampling.vflip);
    }
    Ok(Channel { input, sampling })
}

fn size(manifest: &Manifest, references: &References<'_>) -> Result<Option<[u32; 2]>, Diagnostic> {
    let Some(size) = &manifest.size else {
        return Ok(None);
    };
    match size
        .get_ref()
        .iter()
        .all(|side| (1..=MAX_SIDE).contains(side))
    {
        true => Ok(Some(*size.get_ref())),
        false => Err(Diagnostic::error(
            "manifest",
            format!("a picture has from 1 to {MAX_SIDE} pixels each way"),
        )
        .at(references.span(size.span()))
        .hint("write width and height in pixels, as in `size = [1280, 720]`")),
    }
}
