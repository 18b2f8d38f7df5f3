//! Reads the text line by line, obeys its directives and leaves out what they skip.

use std::borrow::Cow;

use super::condition::{self, misplaced, wrong};
use super::expand::{Costs, Expansion};
use super::findings::Findings;
use super::lexer::{Lexeme, Lexer};
use super::macros::{Macro, MacroId, Macros, Maker};
use super::token::{Kind, Token};
use super::{MAX_SPLICES, Options, define, request};
use crate::glsl::names::Names;
use crate::source::{Diagnostic, FileId, SourceMap, Span};

/// The text with its directives obeyed: definitions are in force, skipped lines are gone.
#[derive(Debug)]
pub(super) struct Directives<'a> {
    files: &'a SourceMap,
    /// Files still to come, the last first.
    units: Vec<FileId>,
    /// Where the text is being read.
    pub lexer: Option<Lexer<'a>>,
    /// The texts around it, where it stands in the place of a directive, with what `line_offset` and `file_number`
    /// were there.
    outer: Vec<(Lexer<'a>, i64, i32)>,
    at_line_start: bool,
    /// What `__LINE__` is ahead of the lexer's own count, from 1.
    line_offset: i64,
    /// What `__FILE__` is.
    file_number: i32,
    pub macros: Macros,
    conditionals: Vec<Conditional>,
    is_skipping: bool,
    pub names: Names,
    pub findings: Findings,
    pub options: Options<'a>,
    pub costs: Costs,
    /// Nothing more comes, whatever is left.
    pub is_stopped: bool,
}

/// What a directive is.
#[derive(Clone, Copy, Debug)]
enum Directive {
    Opening(Opening),
    Turning(Turning),
    Define,
    Undef,
    Line,
    Error,
    Pragma,
    Version,
    Extension,
    Include,
    Unknown,
}

/// What begins a part that may be skipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Opening {
    If,
    Ifdef,
    Ifndef,
}

/// What ends such a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Turning {
    Elif,
    Else,
    Endif,
}

impl Directive {
    fn of(name: &str) -> Self {
        match name {
            "if" => Directive::Opening(Opening::If),
            "ifdef" => Directive::Opening(Opening::Ifdef),
            "ifndef" => Directive::Opening(Opening::Ifndef),
            "elif" => Directive::Turning(Turning::Elif),
            "else" => Directive::Turning(Turning::Else),
            "endif" => Directive::Turning(Turning::Endif),
            "define" => Directive::Define,
            "undef" => Directive::Undef,
            "line" => Directive::Line,
            "error" => Directive::Error,
            "pragma" => Directive::Pragma,
            "version" => Directive::Version,
            "extension" => Directive::Extension,
            "include" => Directive::Include,
            _ => Directive::Unknown,
        }
    }
}

/// An `#if` without its `#endif` yet.
#[derive(Debug)]
struct Conditional {
    place: Span,
    /// Whether the whole of it is in a part that is skipped.
    outer_skips: bool,
    /// Whether the present branch is skipped.
    skips: bool,
    /// Whether a branch was taken already.
    taken: bool,
    had_else: bool,
}

impl<'a> Directives<'a> {
    pub fn new(
        files: &'a SourceMap,
        units: &[FileId],
        options: &Options<'a>,
        names: Names,
    ) -> Self {
        let mut source = Directives {
            files,
            units: units.iter().rev().copied().collect(),
            lexer: None,
            outer: Vec::new(),
            at_line_start: true,
            line_offset: 1,
            file_number: 0,
            macros: Macros::default(),
            conditionals: Vec::new(),
            is_skipping: false,
            names,
            findings: Findings::default(),
            options: *options,
            costs: Costs::default(),
            is_stopped: false,
        };
        if let Some(&first) = units.first() {
            let start = Span {
                file: first,
                start: 0,
                end: 0,
            };
            define::predefine(&mut source, start);
            source.begin_unit();
        }
        source
    }

    /// Defines a macro that is not the text's.
    pub fn define(&mut self, name: &str, body: Vec<Token>, maker: Maker) {
        let name = self.names.intern(name);
        self.macros.define(name, Macro::new(None, body, maker));
    }

    /// The value of `__LINE__` or `__FILE__` where the reading is.
    pub fn position(&mut self, maker: Maker, place: Span) -> Token {
        let lines = self.lexer.as_ref().map_or(0, |lexer| lexer.lines);
        let value = match maker {
            Maker::File => i64::from(self.file_number),
            _ => i64::from(lines) + self.line_offset,
        };
        let value = self.names.intern(&value.to_string());
        Token::new(Kind::Number, value, place, false)
    }

    /// A token's spelling for a message.
    pub fn quoted(&self, token: &Token) -> Cow<'_, str> {
        self.names.quoted(token.spelling)
    }

    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.findings.push(diagnostic);
    }

    /// Reports what a use of a macro is to blame for, with a note at the macro's definition.
    pub fn report_use(&mut self, token: &Token, found: MacroId, problem: Diagnostic) {
        let mut problem = token.blame(problem);
        if let Some(place) = self.macros.get(found).place() {
            problem = problem.note(place, format!("`{}` is defined here", self.quoted(token)));
        }
        self.report(problem);
    }

    /// The next token outside directives and skipped parts.
    pub fn next(&mut self) -> Option<Token> {
        let lexeme = self.scan()?;
        self.token(lexeme)
    }

    /// The token that was scanned last.
    #[inline(always)]
    pub fn token(&self, lexeme: Lexeme) -> Option<Token> {
        Some(self.lexer.as_ref()?.token(lexeme))
    }

    /// The same as [`Directives::next`], in a form that stays in registers.
    #[inline(always)]
    pub fn scan(&mut self) -> Option<Lexeme> {
        while !self.is_stopped {
            let Some(lexer) = &mut self.lexer else {
                self.require_endifs();
                return None;
            };
            match lexer.scan(&mut self.names, &mut self.findings) {
                None => self.end_unit(),
                Some((Kind::LineEnd, ..)) => self.at_line_start = true,
                Some((Kind::Odd, ..)) if self.at_line_start && lexer.is_hash() => self.directive(),
                Some(lexeme) => {
                    self.at_line_start = false;
                    if !self.is_skipping {
                        return Some(lexeme);
                    }
                }
            }
        }
        None
    }

    /// Goes on to the next file, on a new line.
    #[cold]
    fn end_unit(&mut self) {
        let Some(lexer) = self.lexer.take() else {
            return;
        };
        if let Some((outer, line_offset, file_number)) = self.outer.pop() {
            self.lexer = Some(outer);
            self.line_offset = line_offset;
            self.file_number = file_number;
            self.at_line_start = true;
            return;
        }
        self.line_offset += i64::from(lexer.lines) + 1;
        if lexer.ends_early() {
            self.units.clear();
            let message = "the text ends here, at a NUL character";
            self.report(Diagnostic::warning("nul", message).at(lexer.place()));
        }
        self.begin_unit();
        self.at_line_start = true;
    }

    fn begin_unit(&mut self) {
        self.lexer = self.units.pop().map(|file| self.lexer_of(file));
    }

    fn lexer_of(&mut self, file: FileId) -> Lexer<'a> {
        let text = &self.files.get(file).text;
        Lexer::new(file, text, self.options.strict, &mut self.findings)
    }

    /// Passes over a directive that the host has obeyed, and goes on in the text that stands there instead.
    fn splice(&mut self) -> bool {
        let Some(lexer) = &mut self.lexer else {
            return false;
        };
        let here = lexer.token_place();
        let splices = self.options.splices;
        let key = |span: &Span| (span.file, span.start);
        let found = splices.binary_search_by_key(&key(&here), |(place, _)| key(place));
        let Ok(found) = found else { return false };
        let (place, text) = splices[found];
        lexer.skip_to(place.end as usize);
        if let Some(text) = text
            && !self.is_skipping
            && self.outer.len() < MAX_SPLICES
        {
            let inner = self.lexer_of(text);
            if let Some(outer) = self.lexer.replace(inner) {
                let state = (outer, self.line_offset, self.file_number);
                self.outer.push(state);
                self.line_offset = 1;
            }
        }
        self.at_line_start = true;
        true
    }

    /// Finds out whether what follows is skipped.
    fn note_skipping(&mut self) {
        let last = self.conditionals.last();
        self.is_skipping = last.is_some_and(|last| last.skips || last.outer_skips);
    }

    fn require_endifs(&mut self) {
        for conditional in std::mem::take(&mut self.conditionals) {
            self.report(wrong(conditional.place, "this `#if` has no `#endif`"));
        }
    }

    /// The rest of a line, its end taken.
    fn rest_of_line(&mut self) -> Vec<Token> {
        let mut tokens = Vec::new();
        while let Some(lexer) = &mut self.lexer {
            match lexer.next(&mut self.names, &mut self.findings) {
                Some(token) if token.kind != Kind::LineEnd => tokens.push(token),
                Some(_) => break,
                None => {
                    self.end_unit();
                    break;
                }
            }
        }
        self.at_line_start = true;
        tokens
    }

    /// What the author wrote there.
    pub fn written(&self, span: Span) -> &'a str {
        let text = &self.files.get(span.file).text;
        text.get(span.start as usize..span.end as usize)
            .unwrap_or_default()
    }

    /// Obeys the directive behind a `#`.
    #[cold]
    fn directive(&mut self) {
        if self.splice() {
            return;
        }
        let mut rest = self.rest_of_line();
        if rest.is_empty() {
            return;
        }
        let name = rest.remove(0);
        let directive = Directive::of(self.names.text(name.spelling));
        match directive {
            Directive::Opening(opening) => self.open(opening, &name, rest),
            Directive::Turning(turning) => self.turn(turning, &name, rest),
            _ if self.is_skipping => {}
            Directive::Define => define::define(self, &name, rest),
            Directive::Undef => define::undefine(self, &name, &rest),
            Directive::Line => self.set_line(&name, rest),
            Directive::Error => {
                let words: Vec<_> = rest.iter().map(|token| self.written(token.span)).collect();
                let message = format!("the text stops here itself: {}", words.join(" "));
                self.report(wrong(name.span, message));
            }
            Directive::Pragma => request::pragma(self, &rest),
            Directive::Version => request::version(self, &name, &rest),
            Directive::Extension => request::extension(self, &name, &rest),
            Directive::Include => self.report(
                wrong(name.span, "GLSL has no `#include`").hint("paste the text in its place"),
            ),
            Directive::Unknown => self.report(
                wrong(name.span, "there is no such directive").hint(
                    "GLSL has define, undef, if, ifdef, ifndef, elif, else, endif, error, pragma and line",
                ),
            ),
        }
    }

    /// Complains about what follows a complete directive.
    pub fn require_end(&mut self, rest: &[Token]) {
        if let Some(extra) = rest.first() {
            self.report(wrong(extra.span, "the line should end before this"));
        }
    }

    /// `#if`, `#ifdef` and `#ifndef`.
    fn open(&mut self, opening: Opening, name: &Token, rest: Vec<Token>) {
        let outer_skips = self.is_skipping;
        let holds = match opening {
            _ if outer_skips => false,
            Opening::If => condition::holds(self, name, rest),
            Opening::Ifdef | Opening::Ifndef => match rest.split_first() {
                Some((word, rest)) if word.kind == Kind::Identifier => {
                    self.require_end(rest);
                    self.macros.find_mentioned(word.spelling).is_some()
                        == (opening == Opening::Ifdef)
                }
                _ => {
                    self.report(wrong(name.span, "a name is missing here"));
                    false
                }
            },
        };
        self.conditionals.push(Conditional {
            place: name.span,
            outer_skips,
            skips: !holds,
            taken: holds,
            had_else: false,
        });
        self.note_skipping();
    }

    /// `#elif`, `#else` and `#endif`.
    fn turn(&mut self, turning: Turning, name: &Token, rest: Vec<Token>) {
        let Some(mut conditional) = self.conditionals.pop() else {
            let message = format!("this `#{}` has no `#if`", self.quoted(name));
            return self.report(wrong(name.span, message));
        };
        match turning {
            Turning::Elif | Turning::Else if conditional.outer_skips => {}
            Turning::Elif if conditional.had_else => {
                self.report(wrong(name.span, "`#elif` after `#else`"));
            }
            Turning::Elif => {
                let holds = !conditional.taken && condition::holds(self, name, rest);
                conditional.skips = !holds;
                conditional.taken |= holds;
            }
            Turning::Else => {
                self.require_end(&rest);
                if conditional.had_else {
                    self.report(wrong(name.span, "a second `#else` for the same `#if`"));
                }
                conditional.had_else = true;
                conditional.skips = conditional.taken;
                conditional.taken = true;
            }
            Turning::Endif => {
                self.note_skipping();
                return self.require_end(&rest);
            }
        }
        self.conditionals.push(conditional);
        self.note_skipping();
    }

    /// `#line` changes what `__LINE__` is in the lines that follow, and `__FILE__` if it has a
    /// second number.
    fn set_line(&mut self, directive: &Token, rest: Vec<Token>) {
        const MOST: u32 = i32::MAX as u32;
        let rest = Expansion::of_list(rest, self);
        let numbers = condition::evaluate(&rest, directive.span, MOST, &self.names).and_then(
            |(line, length)| {
                let rest = &rest[length..];
                if rest.is_empty() {
                    return Ok((line, self.file_number));
                }
                let (file, length) = condition::evaluate(rest, directive.span, MOST, &self.names)?;
                match rest.get(length) {
                    Some(extra) => Err(misplaced(extra, &self.names)),
                    None => Ok((line, file)),
                }
            },
        );
        match numbers {
            Ok((line, file)) => {
                let lines = self.lexer.as_ref().map_or(0, |lexer| lexer.lines);
                self.line_offset = i64::from(line) - i64::from(lines);
                self.file_number = file;
            }
            Err(problem) => self.report(problem),
        }
    }
}
