//! The kinds of file that channels read.

use std::path::{Path, PathBuf};

use super::{Input, Media, site};

/// The kinds of input that lie in files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileKind {
    Texture,
    Cubemap,
    Volume,
    Video,
    Music,
    MusicStream,
}

/// What files are, by how their names end.
const ENDINGS: [(FileKind, &[&str]); 4] = [
    (
        FileKind::Texture,
        &[
            "png", "jpg", "jpeg", "gif", "bmp", "webp", "tga", "tif", "tiff", "hdr", "exr", "ppm",
            "qoi",
        ],
    ),
    (
        FileKind::Music,
        &["mp3", "ogg", "oga", "wav", "flac", "m4a", "aac", "opus"],
    ),
    (
        FileKind::Video,
        &["mp4", "webm", "ogv", "mov", "mkv", "avi", "m4v"],
    ),
    (FileKind::Volume, &["bin"]),
];

/// A cubemap has as many.
pub(super) const FACES: usize = 6;

/// The picture of a cubemap's face, counted from 0, where the first one is this: `sky.png`, `sky_1.png` to `sky_5.png`.
pub(super) fn face_of(first: &Path, number: usize) -> PathBuf {
    if number == 0 {
        return first.to_owned();
    }
    let stem = first.file_stem().unwrap_or_default().to_string_lossy();
    let ending = first.extension().unwrap_or_default().to_string_lossy();
    first.with_file_name(format!("{stem}_{number}.{ending}"))
}

impl FileKind {
    /// What a file is, by how its name ends.
    pub fn of_file(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
        let mut all = ENDINGS.iter();
        let found = all.find(|(_, endings)| endings.contains(&&*ending));
        found.map(|(kind, _)| *kind)
    }

    /// All endings that tell what a file is.
    pub fn endings() -> impl Iterator<Item = &'static str> {
        ENDINGS
            .iter()
            .flat_map(|(_, endings)| endings.iter().copied())
    }

    pub fn name(self) -> &'static str {
        match self {
            FileKind::Texture => "texture",
            FileKind::Cubemap => "cubemap",
            FileKind::Volume => "volume",
            FileKind::Video => "video",
            FileKind::Music => "music",
            FileKind::MusicStream => "musicstream",
        }
    }

    pub fn input(self, media: Media) -> Input {
        match self {
            FileKind::Texture => Input::Texture(media),
            FileKind::Cubemap => Input::Cubemap(media),
            FileKind::Volume => Input::Volume(media),
            FileKind::Video => Input::Video(media),
            FileKind::Music => Input::Music(media),
            FileKind::MusicStream => Input::MusicStream(media),
        }
    }

    /// What the site has of this kind, for a hint.
    pub fn offered(self) -> String {
        let items = site::ITEMS.iter();
        let items = items.filter(|item| item.kind.name() == self.name());
        let names: Vec<_> = items.map(|item| item.name).collect();
        names.join(", ")
    }
}
