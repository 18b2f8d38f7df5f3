//! Draws diagnostics: for people, with an excerpt and carets, and for tools, one JSON object a line.

use std::io::Write as _;

use annotate_snippets::renderer::DEFAULT_TERM_WIDTH;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use serde::Serialize;

use crate::source::{Diagnostic, Location, Report, Severity};

/// Writes a line to standard error, with colours where it is a terminal. That nobody can read it any
/// more is no reason to stop.
pub fn tell(line: impl std::fmt::Display) {
    let _ = writeln!(anstream::stderr().lock(), "{line}");
}

/// Writes a report to standard error, for people.
pub fn show(report: &Report) {
    let _ = write!(anstream::stderr().lock(), "{}", human(report));
}

/// Text for a terminal, with escape codes for colour; strip them where there is none. Ends with a
/// line end unless it is empty.
pub fn human(report: &Report) -> String {
    let renderer = Renderer::styled().term_width(DEFAULT_TERM_WIDTH);
    let mut text = String::new();
    for diagnostic in &report.diagnostics {
        let level = match diagnostic.severity {
            Severity::Warning => Level::WARNING,
            Severity::Error => Level::ERROR,
        };
        let title = level
            .primary_title(printable(&diagnostic.message))
            .id(diagnostic.code);
        let mut group = annotate_snippets::Group::with_title(title);
        if let Some(span) = diagnostic.span {
            let file = report.files.get(span.file);
            let excerpt = Excerpt::around(&file.text, span.start as usize, span.end as usize);
            group = group.element(
                Snippet::source(excerpt.text)
                    .line_start(file.location(excerpt.offset as u32).line)
                    .path(printable(&file.name))
                    .annotation(AnnotationKind::Primary.span(excerpt.mark)),
            );
        }
        if let Some(hint) = &diagnostic.hint {
            group = group.element(Level::HELP.message(printable(hint)));
        }
        text.push_str(&renderer.render(&[group]));
        text.push('\n');
    }
    text
}

/// Replaces what a terminal would obey.
fn printable(text: &str) -> String {
    text.replace(|c: char| c.is_control() && c != '\n', "\u{fffd}")
}

/// The few lines that a diagnostic shows, so that a report on a large file stays cheap.
struct Excerpt<'a> {
    text: &'a str,
    /// Where `text` begins in the file.
    offset: usize,
    /// What is marked, within `text`.
    mark: std::ops::Range<usize>,
}

impl<'a> Excerpt<'a> {
    /// The lines that `start..end` touches; of a long range only the first.
    fn around(file: &'a str, start: usize, end: usize) -> Self {
        let boundary = |mut at: usize| {
            at = at.min(file.len());
            while !file.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let (start, mut end) = (boundary(start), boundary(end));
        let offset = file[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = file[start..].find('\n').map_or(file.len(), |n| start + n);
        let line_end = start.max(file[..line_end].trim_end_matches('\r').len());
        end = end.min(line_end);
        Excerpt {
            text: &file[offset..line_end],
            offset,
            mark: start - offset..end.max(start) - offset,
        }
    }
}

#[derive(Serialize)]
struct Line<'a> {
    file: Option<&'a str>,
    line: Option<usize>,
    column: Option<usize>,
    end_line: Option<usize>,
    end_column: Option<usize>,
    severity: &'static str,
    message: &'a str,
    pass: Option<&'a str>,
    code: &'static str,
    hint: Option<&'a str>,
}

/// One JSON object for each diagnostic, each on a line of its own. Lines and columns start at 1 and
/// count characters; the end is one past the last character.
pub fn json(report: &Report) -> String {
    report
        .diagnostics
        .iter()
        .map(|diagnostic| {
            let line = line(report, diagnostic);
            serde_json::to_string(&line).expect("plain data") + "\n"
        })
        .collect()
}

fn line<'a>(report: &'a Report, diagnostic: &'a Diagnostic) -> Line<'a> {
    let file = diagnostic.span.map(|span| report.files.get(span.file));
    let at = |offset: fn(crate::source::Span) -> u32| -> Option<Location> {
        Some(file?.location(offset(diagnostic.span?)))
    };
    let (start, end) = (at(|span| span.start), at(|span| span.end));
    Line {
        file: file.map(|file| file.name.as_str()),
        line: start.map(|place| place.line),
        column: start.map(|place| place.column),
        end_line: end.map(|place| place.line),
        end_column: end.map(|place| place.column),
        severity: diagnostic.severity.as_str(),
        message: &diagnostic.message,
        pass: diagnostic.pass.as_deref(),
        code: diagnostic.code,
        hint: diagnostic.hint.as_deref(),
    }
}
