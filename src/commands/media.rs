//! The site's media: what stands in for which, and where commands that draw get them from.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use serde::Serialize;
use vitrine::config::{self, Config};
use vitrine::media::{Entry, Library, Origin, StandIns};

use super::{failure, print, unwritable};
use crate::cli::{Format, MediaArgs, MediaListArgs};

/// Where the files come from that scenes read.
pub fn library(args: &MediaArgs) -> anyhow::Result<Arc<Library>> {
    let stand_ins = match (args.no_stand_ins, config::cache()) {
        (true, _) => StandIns::None,
        (false, Some(folder)) => StandIns::Kept(folder),
        (false, None) => StandIns::Made,
    };
    let config = configured()?;
    let folder = args.media.as_deref().or(config.media.as_deref());
    let library = Library::new(folder, stand_ins).map_err(|error| failure(&error, error.hint()))?;
    Ok(Arc::new(library))
}

/// What the user wants in every run.
pub fn configured() -> anyhow::Result<Config> {
    Config::load().map_err(|error| {
        let hint = "it is TOML: `api_key = \"…\"` and `media = \"FOLDER\"`";
        failure(error, hint)
    })
}

#[derive(Serialize)]
struct Line<'a> {
    name: &'a str,
    id: &'a str,
    kind: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<PathBuf>,
    stand_in: bool,
}

pub fn media(args: MediaListArgs) -> anyhow::Result<ExitCode> {
    let library = library(&args.media)?;
    if let Some(folder) = &args.write {
        for entry in library.entries() {
            let Some(png) = library
                .to_png(entry.item)
                .map_err(|error| failure(&error, error.hint()))?
            else {
                continue;
            };
            let path = folder.join(format!("{}.png", entry.item.name));
            std::fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
            vitrine::output::place(&path, &png, true).map_err(|error| unwritable(&path, &error))?;
        }
    }
    let mut text = String::new();
    for Entry { item, origin } in library.entries() {
        let kind = item.kind.name();
        match args.format {
            Format::Human => {
                let from = match &origin {
                    Origin::File(path) => path.display().to_string(),
                    Origin::StandIn => "stand-in".to_owned(),
                };
                writeln!(text, "{kind:8} {}  {:29} {from}", item.id, item.name)?;
            }
            Format::Json => {
                let (file, stand_in) = match origin {
                    Origin::File(path) => (Some(path), false),
                    Origin::StandIn => (None, true),
                };
                let line = Line {
                    name: item.name,
                    id: item.id,
                    kind,
                    file,
                    stand_in,
                };
                writeln!(text, "{}", serde_json::to_string(&line)?)?;
            }
        }
    }
    print(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
