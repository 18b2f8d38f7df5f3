//! What there is to say of one scene.

use std::path::Path;

use serde::{Deserialize, Serialize};
use vitrine::report::{self, Entry};
use vitrine::scene::Scene;
use vitrine::source::{Diagnostic, Report};
use vitrine::translate::{Options, translate};

use super::super::{loaded, source};
use crate::cli::{CheckArgs, Format};

/// What became of a scene, or of one of its passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Verdict {
    Accept,
    Refuse,
    /// It took too long or too much, and nothing is known about it.
    CutOff,
    /// A file could not be read.
    Unreadable,
}

/// A scene's verdict and what is printed of it. Workers send it as JSON.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Judgement {
    pub verdict: Verdict,
    /// The scene is accepted, with a warning.
    pub is_warned: bool,
    /// What the first error is called.
    pub code: Option<String>,
    /// All that is said, in the format asked for; whole lines.
    pub text: String,
    /// Of a scene that nothing is known about: why, for people; whole lines.
    pub complaint: String,
}

/// A scene as tools are told of it.
#[derive(Serialize)]
struct Line<'a> {
    file: &'a str,
    verdict: Verdict,
    passes: Vec<PassLine<'a>>,
    /// What concerns no single pass.
    diagnostics: Vec<Entry<'a>>,
}

#[derive(Serialize)]
struct PassLine<'a> {
    name: &'static str,
    verdict: Verdict,
    diagnostics: Vec<Entry<'a>>,
}

/// Loads and translates a scene.
pub(super) fn judge(path: &Path, args: &CheckArgs, options: &Options) -> Judgement {
    let format = args.format;
    let scene = match source(path, args.web.refresh).and_then(|source| loaded(&source)) {
        Ok(Ok(scene)) => scene,
        Ok(Err(report)) => return judgement(path, format, None, &report),
        Err(error) => return unreadable(path, format, &error),
    };
    let mut report = Report {
        files: scene.files.clone(),
        diagnostics: scene.warnings.clone(),
    };
    match translate(&scene, options) {
        Ok(programs) => {
            let warnings = programs.into_iter().flat_map(|program| program.warnings);
            report.diagnostics.extend(warnings);
        }
        Err(found) => report.diagnostics.extend(found.diagnostics),
    }
    judgement(path, format, Some(&scene), &report)
}

fn judgement(path: &Path, format: Format, scene: Option<&Scene>, report: &Report) -> Judgement {
    let verdict = match report.has_errors() {
        true => Verdict::Refuse,
        false => Verdict::Accept,
    };
    let text = match format {
        Format::Json => line(path, verdict, scene, report),
        Format::Human if verdict == Verdict::Accept => {
            format!("{}{}: fine\n", report::human(report), path.display())
        }
        Format::Human => report::human(report),
    };
    let first = report.diagnostics.iter().find(|found| found.is_error());
    Judgement {
        verdict,
        is_warned: first.is_none() && !report.diagnostics.is_empty(),
        code: first.map(|found| found.code.to_owned()),
        text,
        complaint: String::new(),
    }
}

fn line(path: &Path, verdict: Verdict, scene: Option<&Scene>, report: &Report) -> String {
    let entries = |pass: Option<&str>| {
        let found = report.diagnostics.iter();
        found
            .filter(|found| found.pass.as_deref() == pass)
            .map(|found| report::entry(report, found))
            .collect()
    };
    let passes = scene.map_or(&[][..], |scene| &scene.passes);
    let passes = passes.iter().map(|pass| {
        let name = pass.kind.name();
        let mut found = report.diagnostics.iter();
        let is_refused = found.any(|d| d.is_error() && d.pass.as_deref() == Some(name));
        PassLine {
            name,
            verdict: match is_refused {
                true => Verdict::Refuse,
                false => Verdict::Accept,
            },
            diagnostics: entries(Some(name)),
        }
    });
    let line = Line {
        file: &path.to_string_lossy(),
        verdict,
        passes: passes.collect(),
        diagnostics: entries(None),
    };
    serde_json::to_string(&line).expect("plain data") + "\n"
}

fn unreadable(path: &Path, format: Format, error: &anyhow::Error) -> Judgement {
    let complaint = format!("{error:#}\n");
    let plain = anstream::adapter::strip_str(&complaint).to_string();
    let first = plain.lines().next().unwrap_or_default();
    let message = first.strip_prefix("error: ").unwrap_or(first);
    let diagnostic = Diagnostic::error("unreadable", message);
    unknown(path, format, Verdict::Unreadable, diagnostic, complaint)
}

/// The judgement on a scene whose checking was ended.
pub(super) fn cut_off(path: &Path, format: Format, why: &str, hint: &str) -> Judgement {
    let message = format!("`{}` was cut off: {why}", path.display());
    let diagnostic = Diagnostic::error("cut-off", message).hint(hint);
    let complaint = report::human(&Report {
        diagnostics: vec![diagnostic.clone()],
        ..Report::default()
    });
    unknown(path, format, Verdict::CutOff, diagnostic, complaint)
}

fn unknown(
    path: &Path,
    format: Format,
    verdict: Verdict,
    diagnostic: Diagnostic,
    complaint: String,
) -> Judgement {
    let code = Some(diagnostic.code.to_owned());
    let report = Report {
        diagnostics: vec![diagnostic],
        ..Report::default()
    };
    Judgement {
        verdict,
        is_warned: false,
        code,
        text: match format {
            Format::Json => line(path, verdict, None, &report),
            Format::Human => complaint.clone(),
        },
        complaint,
    }
}
