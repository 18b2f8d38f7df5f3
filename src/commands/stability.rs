use std::process::ExitCode;

use vitrine::measure::stability::{Examination, Verdict, cases, examine};
use vitrine::render::Gpu;
use vitrine::report;
use vitrine::translate::{Checks, Options};

use super::opening::{adapter_choice, explain, gpu_failure, ready, watchdog};
use super::progress::Progress;
use super::{SCENE_HAS_PROBLEMS, options, print, source};
use crate::cli::{Format, StabilityArgs};

pub fn stability(args: StabilityArgs) -> anyhow::Result<ExitCode> {
    let source = source(&args.scene, args.web.refresh)?;
    let options = Options {
        checks: match args.sanitize {
            true => Checks::All,
            false => Checks::None,
        },
        ..options(args.define.clone())
    };
    let Some(ready) = ready(&source, options, &args.inputs)? else {
        return Ok(SCENE_HAS_PROBLEMS.into());
    };
    let gpu = Gpu::headless(&adapter_choice(&args.gpu)).map_err(|error| gpu_failure(&error))?;
    if !gpu.has_float64() {
        report::tell("the adapter has no 64-bit floats, so that rounding is not looked at");
    }
    let watchdog = watchdog(&args.gpu);
    let cases = cases(&args.vary);
    let mut progress = Progress::new(cases.len() as u32, "cases");
    let examination = examine(&gpu, &source, &ready.setup, &cases, &mut |done, next| {
        watchdog.begin();
        progress.say(next);
        progress.at(done as u32);
    });
    watchdog.rest();
    progress.end();
    let Examination { verdicts, findings } = match examination {
        Ok(examination) => examination,
        Err(error) => return explain(error).map(Into::into),
    };
    let format = if args.json { Format::Json } else { args.format };
    match format {
        Format::Human => {
            print(table(&verdicts).as_bytes())?;
            report::show(&findings);
        }
        Format::Json => print((json(&verdicts)? + &report::json(&findings)).as_bytes())?,
    }
    let fails = |verdict: &&Verdict| verdict.required && !verdict.faults.is_empty();
    Ok(match verdicts.iter().filter(fails).count() {
        0 => ExitCode::SUCCESS,
        _ => SCENE_HAS_PROBLEMS.into(),
    })
}

fn table(verdicts: &[Verdict]) -> String {
    let width = verdicts
        .iter()
        .map(|verdict| verdict.name.chars().count())
        .max()
        .unwrap_or(0);
    let mut text = String::new();
    for verdict in verdicts {
        let word = match (verdict.faults.is_empty(), verdict.required) {
            (true, _) => "holds",
            (false, true) => "FAILS",
            (false, false) => "breaks",
        };
        let rounding = verdict.rounding.map_or(String::new(), |share| {
            format!("  rounding {:5.1} %", share * 100.0)
        });
        text += &format!("{:width$}  {word:6}{rounding}", verdict.name);
        let mut faults: Vec<_> = verdict.faults.iter().map(ToString::to_string).collect();
        match verdict.findings {
            None | Some(0) => {}
            Some(1) => faults.push("1 finding".to_owned()),
            Some(count) => faults.push(format!("{count} findings")),
        }
        if !faults.is_empty() {
            text += &format!("  {}", faults.join("; "));
        }
        text.push('\n');
    }
    text
}

/// One object a line.
fn json(verdicts: &[Verdict]) -> anyhow::Result<String> {
    let mut text = String::new();
    for verdict in verdicts {
        text += &serde_json::to_string(verdict)?;
        text.push('\n');
    }
    Ok(text)
}
