//! Reads the text line by line, obeys its directives and leaves out what they skip.

use super::condition::{self, misplaced, wrong};
use super::expand::{Costs, Expansion};
use super::findings::Findings;
use super::lexer::{Lexeme, Lexer};
use super::macros::{Macro, MacroId, Macros, Maker};
use super::token::{Kind, Token};
use super::{Options, define, request};
use crate::source::{Diagnostic, FileId, SourceMap, Span};

/// The text with its directives obeyed: definitions are in force, skipped lines are gone.
#[derive(Debug)]
pub(super) struct Directives<'a> {
    files: &'a SourceMap,
    /// Files still to come, the last first.
    units: Vec<FileId>,
    /// Where the text is being read.
    pub lexer: Option<Lexer<'a>>,
    at_line_start: bool,
    /// What `__LINE__` is ahead of the lexer's own count, from 1.
    line_offset: i64,
    /// What `__FILE__` is.
    file_number: i32,
    pub macros: Macros<'a>,
    conditionals: Vec<Conditional>,
    is_skipping: bool,
    pub findings: Findings,
    pub options: Options<'a>,
    pub costs: Costs,
    /// Nothing more comes, whatever is left.
    pub is_stopped: bool,
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
    pub fn new(files: &'a SourceMap, units: &[FileId], options: &Options<'a>) -> Self {
        let mut source = Directives {
            files,
            units: units.iter().rev().copied().collect(),
            lexer: None,
            at_line_start: true,
            line_offset: 1,
            file_number: 0,
            macros: Macros::default(),
            conditionals: Vec::new(),
            is_skipping: false,
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
            source.end_unit();
        }
        source
    }

    /// Defines a macro that is not the text's.
    pub fn define(&mut self, name: &'a str, body: Vec<Token<'a>>, maker: Maker) {
        self.macros.define(name, Macro::new(None, body, maker));
    }

    /// The value of `__LINE__` or `__FILE__` where the reading is.
    pub fn position(&self, maker: Maker, place: Span) -> Token<'a> {
        let lines = self.lexer.as_ref().map_or(0, |lexer| lexer.lines);
        let value = match maker {
            Maker::File => i64::from(self.file_number),
            _ => i64::from(lines) + self.line_offset,
        };
        Token::new(Kind::Number, value.to_string(), place)
    }

    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.findings.push(diagnostic);
    }

    /// Reports what a use of a macro is to blame for, with a note at the macro's definition.
    pub fn report_use(&mut self, token: &Token<'a>, found: MacroId, problem: Diagnostic) {
        let mut problem = token.blame(problem);
        if let Some(place) = self.macros.get(found).place() {
            problem = problem.note(place, format!("`{}` is defined here", token.quoted()));
        }
        self.report(problem);
    }

    /// The next token outside directives and skipped parts.
    pub fn next(&mut self) -> Option<Token<'a>> {
        let lexeme = self.next_lexeme()?;
        self.token(lexeme)
    }

    /// The same, not made a token yet.
    #[inline(always)]
    pub fn next_lexeme(&mut self) -> Option<Lexeme> {
        while !self.is_stopped {
            let Some(lexeme) = self.lex() else {
                self.require_endifs();
                return None;
            };
            if lexeme.kind == Kind::LineEnd {
                self.at_line_start = true;
            } else if self.at_line_start && self.lexer.as_ref()?.is_hash(lexeme) {
                self.directive();
            } else {
                self.at_line_start = false;
                if !self.is_skipping {
                    return Some(lexeme);
                }
            }
        }
        None
    }

    /// The token that was read last.
    #[inline]
    pub fn token(&self, lexeme: Lexeme) -> Option<Token<'a>> {
        Some(self.lexer.as_ref()?.token(lexeme))
    }

    /// The next token of the files, a line end behind each of them.
    #[inline]
    fn lex(&mut self) -> Option<Lexeme> {
        let lexer = self.lexer.as_mut()?;
        match lexer.next(&mut self.findings) {
            None => self.end_unit(),
            lexeme => lexeme,
        }
    }

    /// Goes on to the next file; the line ends.
    #[cold]
    fn end_unit(&mut self) -> Option<Lexeme> {
        if let Some(lexer) = self.lexer.take() {
            self.line_offset += i64::from(lexer.lines) + 1;
            if lexer.ends_early() {
                self.units.clear();
                let message = "the text ends here, at a NUL character";
                self.report(Diagnostic::warning("nul", message).at(lexer.place()));
            }
        }
        self.lexer = self.units.pop().map(|file| {
            let text = &self.files.get(file).text;
            Lexer::new(file, text, self.options.strict, &mut self.findings)
        });
        Some(Lexeme::LINE_END)
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
    fn rest_of_line(&mut self) -> Vec<Token<'a>> {
        let mut tokens = Vec::new();
        while let Some(lexeme) = self.lex()
            && lexeme.kind != Kind::LineEnd
            && let Some(lexer) = &self.lexer
        {
            tokens.push(lexer.token(lexeme));
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
        let mut rest = self.rest_of_line();
        if rest.is_empty() {
            return;
        }
        let name = rest.remove(0);
        match &*name.text {
            "if" | "ifdef" | "ifndef" => self.open(&name, rest),
            "elif" | "else" | "endif" => self.turn(&name, rest),
            _ if self.is_skipping => {}
            "define" => define::define(self, &name, rest),
            "undef" => define::undefine(self, &name, &rest),
            "line" => self.set_line(&name, rest),
            "error" => {
                let words: Vec<_> = rest.iter().map(|token| self.written(token.span)).collect();
                let message = format!("the text stops here itself: {}", words.join(" "));
                self.report(wrong(name.span, message));
            }
            "pragma" => request::pragma(self, &rest),
            "version" => request::version(self, &name, &rest),
            "extension" => request::extension(self, &name, &rest),
            "include" => self.report(
                wrong(name.span, "GLSL has no `#include`").hint("paste the text in its place"),
            ),
            _ => self.report(wrong(name.span, "there is no such directive")),
        }
    }

    /// Complains about what follows a complete directive.
    pub fn require_end(&mut self, rest: &[Token<'_>]) {
        if let Some(extra) = rest.first() {
            self.report(wrong(extra.span, "the line should end before this"));
        }
    }

    /// `#if`, `#ifdef` and `#ifndef`.
    fn open(&mut self, name: &Token<'a>, rest: Vec<Token<'a>>) {
        let outer_skips = self.is_skipping;
        let holds = match &*name.text {
            _ if outer_skips => false,
            "if" => condition::holds(self, name, rest),
            test => match rest.split_first() {
                Some((word, rest)) if word.kind == Kind::Identifier => {
                    self.require_end(rest);
                    self.macros.find_mentioned(&word.text).is_some() == (test == "ifdef")
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
    fn turn(&mut self, name: &Token<'a>, rest: Vec<Token<'a>>) {
        let Some(mut conditional) = self.conditionals.pop() else {
            let message = format!("this `#{}` has no `#if`", name.text);
            return self.report(wrong(name.span, message));
        };
        match &*name.text {
            "elif" | "else" if conditional.outer_skips => {}
            "elif" if conditional.had_else => {
                self.report(wrong(name.span, "`#elif` after `#else`"));
            }
            "elif" => {
                let holds = !conditional.taken && condition::holds(self, name, rest);
                conditional.skips = !holds;
                conditional.taken |= holds;
            }
            "else" => {
                self.require_end(&rest);
                if conditional.had_else {
                    self.report(wrong(name.span, "a second `#else` for the same `#if`"));
                }
                conditional.had_else = true;
                conditional.skips = conditional.taken;
                conditional.taken = true;
            }
            _ => {
                self.note_skipping();
                return self.require_end(&rest);
            }
        }
        self.conditionals.push(conditional);
        self.note_skipping();
    }

    /// `#line` changes what `__LINE__` is in the lines that follow, and `__FILE__` if it has a
    /// second number.
    fn set_line(&mut self, directive: &Token<'a>, rest: Vec<Token<'a>>) {
        const MOST: u32 = i32::MAX as u32;
        let rest = Expansion::of_list(rest, self);
        let numbers =
            condition::evaluate(&rest, directive.span, MOST).and_then(|(line, length)| {
                let rest = &rest[length..];
                if rest.is_empty() {
                    return Ok((line, self.file_number));
                }
                let (file, length) = condition::evaluate(rest, directive.span, MOST)?;
                match rest.get(length) {
                    Some(extra) => Err(misplaced(extra)),
                    None => Ok((line, file)),
                }
            });
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
