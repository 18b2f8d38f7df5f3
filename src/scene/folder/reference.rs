//! Files that a scene refers to, and names of the site's media.

use std::ops::Range;
use std::path::{Component, Path, PathBuf};

use toml::Spanned;

use super::super::file_kind::{FACES, face_of};
use super::super::load::{Failure, Loading};
use super::super::site::Item;
use super::super::{FileKind, Input, Media};
use super::manifest::MediaName;
use crate::source::{Diagnostic, FileId, Span};

/// Where names in a manifest lead.
pub(super) struct References<'a> {
    pub folder: &'a Path,
    pub manifest: FileId,
}

impl References<'_> {
    pub fn span(&self, range: Range<usize>) -> Span {
        let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Span {
            file: self.manifest,
            start: offset(range.start),
            end: offset(range.end),
        }
    }

    fn error(&self, place: Range<usize>, message: String) -> Diagnostic {
        Diagnostic::error("manifest", message).at(self.span(place))
    }

    /// A file that the manifest names. A manifest may come from anywhere, so it reaches no further
    /// than the folder that its scene folder lies in, where scenes share their Common.
    pub fn file(
        &self,
        loading: &mut Loading,
        name: &str,
        place: Range<usize>,
    ) -> Result<PathBuf, Failure> {
        match within(loading, self.folder, name, self.folder) {
            Ok(path) => Ok(path),
            Err(Refusal::Outside) => Err(self
                .error(place, format!("`{name}` lies outside the scene"))
                .hint(
                    "name a file in the scene folder or in a folder beside it, by a relative path",
                )
                .into()),
            Err(Refusal::Missing(path)) => Err(self
                .error(place, format!("there is no file `{}`", path.display()))
                .hint("paths are relative to the folder of scene.toml")
                .into()),
        }
    }

    /// What a channel is bound to that lies in a file. A file wins over a name of the site's.
    pub fn input(
        &self,
        loading: &mut Loading,
        kind: FileKind,
        name: &Spanned<MediaName>,
    ) -> Result<Input, Failure> {
        let place = name.span();
        let media = match name.get_ref() {
            MediaName::Site(site) => Media::Site {
                id: site.id.clone(),
                path: site.path.clone(),
            },
            MediaName::Six(files) if kind == FileKind::Cubemap && files.len() == FACES => {
                let mut faces = Vec::new();
                for file in files {
                    faces.push(self.file(loading, file, place.clone())?);
                }
                Media::Files(faces)
            }
            MediaName::Six(_) => {
                let message = "a list of files is the six faces of a `cubemap`";
                return Err(self
                    .error(place, message.to_owned())
                    .hint("their order is +X, \u{2212}X, +Y, \u{2212}Y, +Z, \u{2212}Z")
                    .into());
            }
            MediaName::One(url) if kind == FileKind::MusicStream => Media::Site {
                id: String::new(),
                path: url.clone(),
            },
            MediaName::One(name) => self.one(loading, kind, name, place)?,
        };
        if let Media::Files(files) = &media {
            files.iter().for_each(|file| loading.depends_on(file));
        }
        Ok(kind.input(media))
    }

    fn one(
        &self,
        loading: &mut Loading,
        kind: FileKind,
        name: &str,
        place: Range<usize>,
    ) -> Result<Media, Failure> {
        let missing = match within(loading, self.folder, name, self.folder) {
            Ok(path) if kind == FileKind::Cubemap => {
                return self.faces(loading, path, place);
            }
            Ok(path) => return Ok(Media::Files(vec![path])),
            Err(Refusal::Missing(path)) => Some(path),
            Err(Refusal::Outside) => None,
        };
        match (Item::named(name), missing) {
            (Some(item), _) if item.kind.name() == kind.name() => Ok(item.media()),
            (Some(item), _) => {
                let what = item.kind.name();
                let message = format!("`{name}` is a {what}, not a {}", kind.name());
                let hint = format!("bind it as `{what} = \"{name}\"`");
                Err(self.error(place, message).hint(hint).into())
            }
            (None, Some(path)) => {
                // Its appearance mends the scene.
                loading.depends_on(&path);
                let message = format!("there is no file `{}`", path.display());
                let hint = format!(
                    "name a file, relative to the folder of scene.toml, or one of the site's: {}",
                    kind.offered()
                );
                Err(self.error(place, message).hint(hint).into())
            }
            (None, None) => self
                .file(loading, name, place)
                .map(|path| Media::Files(vec![path])),
        }
    }

    /// One picture of a cubemap, or six of which it is the first: `sky.png`, `sky_1.png` to `sky_5.png`.
    fn faces(
        &self,
        loading: &mut Loading,
        first: PathBuf,
        place: Range<usize>,
    ) -> Result<Media, Failure> {
        let face = |number| face_of(&first, number);
        if !loading.is_file(&face(1)) {
            loading.depends_on(&face(1));
            return Ok(Media::Files(vec![first]));
        }
        let mut faces = vec![first.clone()];
        for path in (1..FACES).map(face) {
            if !loading.is_file(&path) {
                loading.depends_on(&path);
                let message = format!(
                    "there is no file `{}`, a face of the cubemap",
                    path.display()
                );
                return Err(self
                    .error(place, message)
                    .hint("a cubemap is one picture, or six: the first, and those with `_1` to `_5` behind its name")
                    .into());
            }
            if !loading.lies_within(&path, &self.folder.join("..")) {
                let message = format!("`{}` lies outside the scene", path.display());
                return Err(self.error(place, message).into());
            }
            faces.push(path);
        }
        Ok(Media::Files(faces))
    }
}

/// Why a name leads to no file.
pub(in crate::scene) enum Refusal {
    /// Beyond the folder that the scene's folder lies in.
    Outside,
    /// There is nothing, or a folder.
    Missing(PathBuf),
}

/// The file that `name`, relative to `folder`, leads to, if it lies in the folder `root` or in one beside that.
pub(in crate::scene) fn within(
    loading: &mut Loading,
    folder: &Path,
    name: &str,
    root: &Path,
) -> Result<PathBuf, Refusal> {
    let path = without_detours(&folder.join(name));
    if Path::new(name).is_absolute() || !loading.lies_within(&path, &root.join("..")) {
        return Err(Refusal::Outside);
    }
    if !loading.is_file(&path) {
        loading.depends_on(&path);
        return Err(Refusal::Missing(path));
    }
    Ok(path)
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
