//! A single text: the Image pass alone, as it is pasted from the site, one with directives for its host, or ShaderToy's
//! JSON.

use std::path::Path;

use super::load::{Failure, Loading, Parts};
use super::{Pass, PassKind, directive, json};
use crate::source::{Diagnostic, FileId, SourceMap};

pub(super) fn load(loading: &mut Loading, path: &Path) -> Result<Parts, Failure> {
    let file = loading.read(path)?;
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    let must_be_json = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    single(
        loading,
        &stem.to_string_lossy(),
        file,
        Some(path),
        must_be_json,
    )
}

pub(super) fn load_text(loading: &mut Loading, name: &str, bytes: &[u8]) -> Result<Parts, Failure> {
    let file = loading.accept(name, bytes)?;
    single(loading, name.trim_matches(['<', '>']), file, None, false)
}

fn single(
    loading: &mut Loading,
    name: &str,
    file: FileId,
    path: Option<&Path>,
    must_be_json: bool,
) -> Result<Parts, Failure> {
    refuse_empty(&loading.files, file)?;
    if must_be_json || json::is_json(&loading.files.get(file).text) {
        return json::load(loading, name, file);
    }
    if directive::has_directives(&loading.files.get(file).text) {
        return directive::load(loading, name, file, path);
    }
    Ok(Parts {
        name: name.to_owned(),
        size: None,
        passes: vec![Pass {
            kind: PassKind::Image,
            sources: vec![file],
            channels: Default::default(),
            splices: Vec::new(),
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
