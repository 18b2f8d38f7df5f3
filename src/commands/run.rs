use std::io::{self, ErrorKind};
use std::path::Path;
use std::process::ExitCode;

use glam::UVec2;
use vitrine::scene::Source;
use vitrine::translate;
use vitrine::window::{self, Options, PlayError, Record};

use super::findings::checks;
use super::opening::{adapter_choice, date, explain, gpu_failure, ready, watchdog};
use super::{SCENE_HAS_PROBLEMS, failure, options, source, unwritable};
use crate::cli::RunArgs;

/// The picture of a scene that is made for no size.
const USUAL_SIZE: UVec2 = UVec2::new(960, 540);

pub fn run(args: RunArgs) -> anyhow::Result<ExitCode> {
    let source = match &args.scene {
        Some(path) => source(path, args.web.refresh)?,
        None => Source::Embedded,
    };
    let translate = translate::Options {
        checks: checks(args.sanitize),
        low_samplers: args.lowp,
        ..options(args.define)
    };
    let date = date(args.date.as_deref())?;
    let overwrite = args.overwrite;
    let record = args.record_input.map(|path| Record { path, overwrite });
    if let Some(record) = &record
        && !record.overwrite
        && record.path.exists()
    {
        return Err(unrecordable(&record.path, &ErrorKind::AlreadyExists.into()));
    }
    let Some(ready) = ready(&source, translate, &args.inputs)? else {
        return Ok(SCENE_HAS_PROBLEMS.into());
    };
    let options = Options {
        size: ready.size(args.size, USUAL_SIZE),
        source,
        setup: ready.setup,
        scale: args.scale,
        fps_limit: args.fps_limit,
        watch: !args.no_watch,
        date,
        mute: args.mute,
        record,
        adapter: adapter_choice(&args.gpu),
    };
    match window::play(options, watchdog(&args.gpu)) {
        Ok(()) => Ok(ExitCode::SUCCESS),
        Err(PlayError::Open(error)) => explain(error).map(Into::into),
        Err(PlayError::Gpu(error)) => Err(gpu_failure(&error)),
        Err(PlayError::Record { path, error }) => Err(unrecordable(&path, &error)),
        Err(PlayError::Window(message)) => Err(failure(
            format!("no window can be opened: {message}"),
            "is there a display? `vitrine export` draws to files without one",
        )),
    }
}

/// Input cannot be recorded to this file.
fn unrecordable(path: &Path, error: &io::Error) -> anyhow::Error {
    match error.kind() {
        ErrorKind::AlreadyExists => failure(
            format!("`{}` exists already", path.display()),
            "add `--overwrite` to replace it, or choose another `--record-input`",
        ),
        _ => unwritable(path, error),
    }
}
