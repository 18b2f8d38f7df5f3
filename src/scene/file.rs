//! A single text: the Image pass alone, as it is pasted from the site.

use std::path::Path;

use super::load::{Failure, Loading, Parts};
use super::{CHANNELS, Pass, PassKind};
use crate::source::{Diagnostic, FileId, SourceMap};

pub(super) fn load(loading: &mut Loading, path: &Path) -> Result<Parts, Failure> {
    let file = loading.read(path)?;
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    single(&loading.files, &stem.to_string_lossy(), file)
}

pub(super) fn load_text(loading: &mut Loading, name: &str, bytes: &[u8]) -> Result<Parts, Failure> {
    let file = loading.accept(name, bytes)?;
    single(&loading.files, name.trim_matches(['<', '>']), file)
}

fn single(files: &SourceMap, name: &str, file: FileId) -> Result<Parts, Failure> {
    refuse_empty(files, file)?;
    Ok(Parts {
        name: name.to_owned(),
        passes: vec![Pass {
            kind: PassKind::Image,
            sources: vec![file],
            channels: [None; CHANNELS],
        }],
    })
}

/// A pass needs some text of its own; saying so beats "no mainImage" for an unsaved file.
pub(super) fn refuse_empty(files: &SourceMap, file: FileId) -> Result<(), Failure> {
    let text = &files.get(file).text;
    if text.trim_start_matches('\u{feff}').trim().is_empty() {
        return Err(Diagnostic::error("empty", "the file is empty")
            .at(files.whole(file))
            .hint("paste a ShaderToy shader into it: code with a `mainImage` function")
            .into());
    }
    Ok(())
}
