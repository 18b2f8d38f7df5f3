use std::io::IsTerminal as _;
use std::process::ExitCode;

use vitrine::output;
use vitrine::report;
use vitrine::source::Report;
use vitrine::translate::{self, Language};

use super::{
    SCENE_HAS_PROBLEMS, Translation, failure, options, print, source, translated, unwritable,
};
use crate::cli::{self, TranslateArgs};

pub fn translate(args: TranslateArgs) -> anyhow::Result<ExitCode> {
    if args.to == cli::Language::Spirv && args.out.is_none() && std::io::stdout().is_terminal() {
        return Err(failure(
            "SPIR-V is binary and would spoil the terminal",
            "name a file with `--out FILE.spv`, or redirect the output",
        ));
    }
    let options = options(args.define);
    let (scene, programs) = match translated(&source(&args.scene, args.web.refresh)?, &options)? {
        Translation::Done(scene, programs) => (scene, programs),
        Translation::Problems(report) => {
            report::show(&report);
            return Ok(SCENE_HAS_PROBLEMS.into());
        }
    };
    let Some(program) = programs
        .iter()
        .find(|program| program.kind.name().eq_ignore_ascii_case(&args.pass))
    else {
        let names: Vec<_> = programs.iter().map(|p| p.kind.name()).collect();
        return Err(failure(
            format!("the scene has no pass `{}`", args.pass),
            &format!("it has: {}", names.join(", ")),
        ));
    };
    let text = match translate::write(program, language(args.to)) {
        Ok(text) => text,
        Err(diagnostic) => {
            report::show(&Report {
                files: scene.files,
                diagnostics: vec![diagnostic],
            });
            return Ok(SCENE_HAS_PROBLEMS.into());
        }
    };
    match &args.out {
        Some(path) => {
            output::place(path, &text, true).map_err(|error| unwritable(path, &error))?;
        }
        None => print(&text)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn language(language: cli::Language) -> Language {
    match language {
        cli::Language::Wgsl => Language::Wgsl,
        cli::Language::Spirv => Language::Spirv,
        cli::Language::Glsl => Language::Glsl,
        cli::Language::Hlsl => Language::Hlsl,
        cli::Language::Msl => Language::Msl,
    }
}
