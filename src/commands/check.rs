use std::process::ExitCode;

use vitrine::report;
use vitrine::source::Report;

use super::{HOST_FAILED, SCENE_HAS_PROBLEMS, Translation, complain, print, source, translated};
use crate::cli::{CheckArgs, Format};

/// Checks every scene, also after one that is wrong or missing.
pub fn check(args: CheckArgs) -> anyhow::Result<ExitCode> {
    let mut worst = 0;
    for path in &args.scenes {
        let result = source(path).and_then(|source| translated(&source));
        let report = match result {
            Err(error) => {
                complain(&error);
                worst = worst.max(HOST_FAILED);
                continue;
            }
            Ok(Translation::Problems(report)) => report,
            Ok(Translation::Done(scene, programs)) => Report {
                files: scene.files,
                diagnostics: programs.into_iter().flat_map(|p| p.warnings).collect(),
            },
        };
        match args.format {
            Format::Human => report::show(&report),
            Format::Json => print(report::json(&report).as_bytes())?,
        }
        if report.has_errors() {
            worst = worst.max(SCENE_HAS_PROBLEMS);
        } else if args.format == Format::Human {
            report::tell(format_args!("{}: fine", path.display()));
        }
    }
    Ok(worst.into())
}
