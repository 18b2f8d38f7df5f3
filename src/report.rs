//! Draws diagnostics: for people, with an excerpt and carets, and for tools, one JSON object a line.

use std::io::Write as _;

use annotate_snippets::renderer::DEFAULT_TERM_WIDTH;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use serde::Serialize;

use crate::source::{Diagnostic, Location, Report, Severity, Span};

/// How many bytes of a line are laid out to show some of them.
const LONGEST_LINE: usize = 10_000;

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
        let mut group = Group::with_title(title);
        if let Some(span) = diagnostic.span {
            group = place(group, report, span);
        }
        if let Some(hint) = &diagnostic.hint {
            group = group.element(Level::HELP.message(printable(hint)));
        }
        let notes = diagnostic.notes.iter().map(|(span, note)| {
            let title = Level::NOTE.secondary_title(printable(note));
            place(Group::with_title(title), report, *span)
        });
        let groups: Vec<_> = std::iter::once(group).chain(notes).collect();
        text.push_str(&renderer.render(&groups));
        text.push('\n');
    }
    text
}

/// Adds the line that a place is on, with a mark below the place.
fn place<'a>(group: Group<'a>, report: &'a Report, span: Span) -> Group<'a> {
    let file = report.files.get(span.file);
    let path = printable(&file.name);
    let excerpt = Excerpt::around(&file.text, span.start as usize, span.end as usize);
    if excerpt.mark.start > LONGEST_LINE {
        // The line would be laid out as a whole before the part to show is cut out.
        let location = file.location(span.start);
        let origin = Origin::path(path).line(location.line);
        return group.element(origin.char_column(location.column));
    }
    let snippet = Snippet::source(excerpt.text)
        .line_start(file.location(excerpt.offset as u32).line)
        .path(path);
    group.element(snippet.annotation(AnnotationKind::Primary.span(excerpt.mark)))
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
    /// The lines that `start..end` touches; of a long range only the first, of a long line only what
    /// can be shown.
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
        let line_end = boundary(line_end.min(start + LONGEST_LINE));
        end = end.min(line_end);
        Excerpt {
            text: &file[offset..line_end],
            offset,
            mark: start - offset..end.max(start) - offset,
        }
    }
}

/// A diagnostic as tools are told of it. Lines and columns start at 1 and count characters; the end
/// is one past the last character.
#[derive(Clone, Debug, Serialize)]
pub struct Entry<'a> {
    /// The file that it points into.
    pub file: Option<&'a str>,
    /// Where in it.
    pub line: Option<usize>,
    /// Where in that line.
    pub column: Option<usize>,
    /// Where the marked text ends.
    pub end_line: Option<usize>,
    /// Where in that line.
    pub end_column: Option<usize>,
    /// `error` or `warning`.
    pub severity: &'static str,
    /// What is wrong.
    pub message: &'a str,
    /// The pass that it concerns.
    pub pass: Option<&'a str>,
    /// The kind of problem.
    pub code: &'static str,
    /// What to do about it.
    pub hint: Option<&'a str>,
    /// Other places that belong to it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<Note<'a>>,
}

/// A place that belongs to a diagnostic.
#[derive(Clone, Debug, Serialize)]
pub struct Note<'a> {
    /// The file that it points into.
    pub file: &'a str,
    /// Where in it.
    pub line: usize,
    /// Where in that line.
    pub column: usize,
    /// What is there.
    pub message: &'a str,
}

/// One JSON object for each diagnostic, each on a line of its own, with the keys of [`Entry`].
pub fn json(report: &Report) -> String {
    report
        .diagnostics
        .iter()
        .map(|diagnostic| {
            serde_json::to_string(&entry(report, diagnostic)).expect("plain data") + "\n"
        })
        .collect()
}

/// What tools are told of a diagnostic of this report.
pub fn entry<'a>(report: &'a Report, diagnostic: &'a Diagnostic) -> Entry<'a> {
    let file = diagnostic.span.map(|span| report.files.get(span.file));
    let at = |offset: fn(crate::source::Span) -> u32| -> Option<Location> {
        Some(file?.location(offset(diagnostic.span?)))
    };
    let (start, end) = (at(|span| span.start), at(|span| span.end));
    let note = |(span, message): &'a (Span, String)| {
        let file = report.files.get(span.file);
        let place = file.location(span.start);
        Note {
            file: &file.name,
            line: place.line,
            column: place.column,
            message,
        }
    };
    Entry {
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
        notes: diagnostic.notes.iter().map(note).collect(),
    }
}
