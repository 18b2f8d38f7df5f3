//! Between the site's JSON and scene folders.

use std::io;
use std::path::Path;
use std::process::ExitCode;

use vitrine::output;
use vitrine::report;
use vitrine::scene::{self, LoadError, LoadErrorKind};

use super::{SCENE_HAS_PROBLEMS, failure, print, source, unreadable, unwritable};
use crate::cli::{ImportArgs, PackArgs};

/// Writes a scene folder of a shader in JSON.
pub fn import(args: &ImportArgs) -> anyhow::Result<ExitCode> {
    let imported = match scene::import(&source(&args.shader, false)?) {
        Ok(imported) => imported,
        Err(error) => return refused(error),
    };
    report::show(&imported.warnings);
    output::folder(&args.into, &imported.files, args.overwrite)
        .map_err(|error| not_written(&args.into, &error))?;
    report::tell(format!("{} holds the scene", args.into.display()));
    Ok(ExitCode::SUCCESS)
}

/// Writes the JSON of a scene folder.
pub fn pack(args: &PackArgs) -> anyhow::Result<ExitCode> {
    if !args.folder.is_dir() {
        return Err(failure(
            format!("`{}` is no folder", args.folder.display()),
            "what is packed is a scene folder, with a `scene.toml` or an `image.glsl`",
        ));
    }
    let packed = match scene::pack(&args.folder) {
        Ok(packed) => packed,
        Err(error) => return refused(error),
    };
    report::show(&packed.warnings);
    match &args.out {
        Some(path) => output::place(path, packed.text.as_bytes(), true)
            .map_err(|error| unwritable(path, &error))?,
        None => print(packed.text.as_bytes())?,
    }
    Ok(ExitCode::SUCCESS)
}

fn refused(error: LoadError) -> anyhow::Result<ExitCode> {
    match error.kind {
        LoadErrorKind::Scene(problems) => {
            report::show(&problems);
            Ok(SCENE_HAS_PROBLEMS.into())
        }
        LoadErrorKind::Io { path, error } => Err(unreadable(&path, &error)),
    }
}

fn not_written(path: &Path, error: &io::Error) -> anyhow::Error {
    match error.kind() {
        io::ErrorKind::DirectoryNotEmpty => failure(
            format!("the folder `{}` is there and not empty", path.display()),
            "name another one, or write into it with `--overwrite`",
        ),
        io::ErrorKind::NotADirectory => failure(
            format!("`{}` is a file, not a folder", path.display()),
            "name a folder that is not there yet",
        ),
        _ => unwritable(path, error),
    }
}
