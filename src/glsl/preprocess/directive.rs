use std::borrow::Cow;
use std::rc::Rc;

use super::expand::{Macro, Macros};
use super::lexer::{Kind, Lexer, Token};
use super::{MAX_EXPANDED, condition};
use crate::source::{Diagnostic, FileId, SourceMap, Span};

/// The text with its directives obeyed: definitions are in force, skipped lines are gone.
#[derive(Debug)]
pub(super) struct Directives<'a> {
    files: &'a SourceMap,
    /// Files still to come, the last first.
    units: Vec<FileId>,
    lexer: Option<Lexer<'a>>,
    at_line_start: bool,
    /// What `__LINE__` is ahead of the lexer's own count, from 1.
    line_offset: i64,
    macros: Macros<'a>,
    conditionals: Vec<Conditional>,
    diagnostics: Vec<Diagnostic>,
    budget: usize,
    /// Nothing more comes, whatever is left.
    stopped: bool,
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
    pub fn new(files: &'a SourceMap, units: &[FileId], defines: &[(&'a str, &'a str)]) -> Self {
        let mut source = Directives {
            files,
            units: units.iter().rev().copied().collect(),
            lexer: None,
            at_line_start: true,
            line_offset: 1,
            macros: Macros::new(),
            conditionals: Vec::new(),
            diagnostics: Vec::new(),
            budget: MAX_EXPANDED,
            stopped: false,
        };
        if let Some(&first) = units.first() {
            let nowhere = Span {
                file: first,
                start: 0,
                end: 0,
            };
            let language = [
                ("GL_ES", "1"),
                ("GL_FRAGMENT_PRECISION_HIGH", "1"),
                ("__VERSION__", "300"),
                ("__LINE__", "0"),
                ("__FILE__", "0"),
            ];
            for (name, value) in language {
                source.define(name, number(value, nowhere), true);
            }
            for &(name, value) in defines {
                source.define(name, number(value, nowhere), false);
            }
        }
        source
    }

    fn define(&mut self, name: &str, value: Token<'a>, predefined: bool) {
        let definition = Macro {
            parameters: None,
            body: vec![value],
            predefined,
        };
        self.macros.insert(name.to_owned(), Rc::new(definition));
    }

    /// The macro that an identifier names.
    pub fn find(&self, name: &Token<'a>) -> Option<Rc<Macro<'a>>> {
        let found = self.macros.get(&*name.text)?;
        if name.text == "__LINE__" {
            let line = self.line().to_string();
            let mut token = number("", name.span);
            token.text = Cow::Owned(line);
            return Some(Rc::new(Macro {
                parameters: None,
                body: vec![token],
                predefined: true,
            }));
        }
        Some(Rc::clone(found))
    }

    fn line(&self) -> i64 {
        let lines = self.lexer.as_ref().map_or(0, |lexer| lexer.lines);
        i64::from(lines) + self.line_offset
    }

    /// Counts work; `false` when there has been too much of it.
    pub fn spend(&mut self, tokens: usize) -> bool {
        match self.budget.checked_sub(tokens) {
            Some(left) => self.budget = left,
            None if self.stopped => {}
            None => {
                let place = self.diagnostic_place();
                self.give_up("macros expand without end here", place);
            }
        }
        !self.stopped
    }

    /// Where the reading is.
    fn diagnostic_place(&self) -> Option<Span> {
        self.lexer.as_ref().map(Lexer::place)
    }

    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Reports what cannot be gone on with.
    pub fn give_up(&mut self, message: &str, place: impl Into<Option<Span>>) {
        self.stopped = true;
        self.report(
            Diagnostic::error("too-complex", message)
                .at(place)
                .hint("write macros that use fewer others, or functions in their stead"),
        );
    }

    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.diagnostics
    }

    /// The next token outside directives and skipped parts.
    pub fn next(&mut self) -> Option<Token<'a>> {
        while !self.stopped {
            let Some(token) = self.lex() else {
                self.require_endifs();
                return None;
            };
            if token.kind == Kind::LineEnd {
                self.at_line_start = true;
            } else if self.at_line_start && token.is("#") {
                self.directive();
            } else {
                self.at_line_start = false;
                if !self.is_skipping() {
                    return Some(token);
                }
            }
        }
        None
    }

    /// The next token of the files, a line end behind each of them.
    fn lex(&mut self) -> Option<Token<'a>> {
        loop {
            if let Some(lexer) = &mut self.lexer {
                if let Some(token) = lexer.next() {
                    return Some(token);
                }
                self.diagnostics.append(&mut lexer.diagnostics);
                self.line_offset += i64::from(lexer.lines) + 1;
                let end = lexer.place();
                self.lexer = None;
                return Some(Token {
                    kind: Kind::LineEnd,
                    ..number("", end)
                });
            }
            let file = self.units.pop()?;
            self.lexer = Some(Lexer::new(file, &self.files.get(file).text));
        }
    }

    fn is_skipping(&self) -> bool {
        self.conditionals
            .last()
            .is_some_and(|conditional| conditional.skips || conditional.outer_skips)
    }

    fn require_endifs(&mut self) {
        for conditional in std::mem::take(&mut self.conditionals) {
            self.report(
                Diagnostic::error("preprocessor", "this `#if` has no `#endif`")
                    .at(conditional.place),
            );
        }
    }

    /// The rest of a line, its end taken.
    fn rest_of_line(&mut self) -> Vec<Token<'a>> {
        let mut tokens = Vec::new();
        while let Some(token) = self.lex() {
            if token.kind == Kind::LineEnd {
                break;
            }
            tokens.push(token);
        }
        self.at_line_start = true;
        tokens
    }

    /// Obeys the directive behind a `#`.
    fn directive(&mut self) {
        let mut line = self.rest_of_line();
        if line.is_empty() {
            return;
        }
        let name = line.remove(0);
        match &*name.text {
            "if" | "ifdef" | "ifndef" => return self.open(&name, line),
            "elif" | "else" | "endif" => return self.turn(&name, line),
            _ if self.is_skipping() => return,
            _ => {}
        }
        match &*name.text {
            "define" => self.define_directive(&name, line),
            "undef" => self.undefine(&name, line),
            "line" => self.line_directive(&name, line),
            "error" => {
                let words: Vec<_> = line.iter().map(|token| &*token.text).collect();
                let message = format!("the text stops here itself: {}", words.join(" "));
                self.report(Diagnostic::error("preprocessor", message).at(name.span));
            }
            "pragma" => {}
            "version" => self.report(
                Diagnostic::error("version", "`#version` cannot be given here")
                    .at(name.span)
                    .hint("remove the line: the text is GLSL ES 3.00 already"),
            ),
            "extension" => self.report(
                Diagnostic::warning("extension", "WebGL2 refuses `#extension` lines")
                    .at(name.span)
                    .hint("remove the line: GLSL ES 3.00 needs no extension for derivatives"),
            ),
            "include" => self.report(
                Diagnostic::error("preprocessor", "GLSL has no `#include`")
                    .at(name.span)
                    .hint("paste the text in its place"),
            ),
            _ => self.wrong(&name, "there is no such directive"),
        }
    }

    fn wrong(&mut self, at: &Token<'_>, message: &str) {
        self.report(Diagnostic::error("preprocessor", message).at(at.span));
    }

    /// Complains about what follows a complete directive.
    fn require_end(&mut self, rest: &[Token<'_>]) {
        if let Some(extra) = rest.first() {
            self.wrong(extra, "the line should end before this");
        }
    }

    /// `#if`, `#ifdef` and `#ifndef`.
    fn open(&mut self, name: &Token<'a>, line: Vec<Token<'a>>) {
        let outer_skips = self.is_skipping();
        let holds = match &*name.text {
            _ if outer_skips => false,
            "if" => condition::holds(self, name, line),
            test => match line.split_first() {
                Some((word, rest)) if word.kind == Kind::Identifier => {
                    self.require_end(rest);
                    self.macros.contains_key(&*word.text) == (test == "ifdef")
                }
                _ => {
                    self.wrong(name, "a name is missing here");
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
    }

    /// `#elif`, `#else` and `#endif`.
    fn turn(&mut self, name: &Token<'a>, line: Vec<Token<'a>>) {
        let Some(mut conditional) = self.conditionals.pop() else {
            let message = format!("this `#{}` has no `#if`", name.text);
            return self.wrong(name, &message);
        };
        match &*name.text {
            "elif" | "else" if conditional.outer_skips => {}
            "elif" if conditional.had_else => self.wrong(name, "`#elif` after `#else`"),
            "elif" => {
                let holds = !conditional.taken && condition::holds(self, name, line);
                conditional.skips = !holds;
                conditional.taken |= holds;
            }
            "else" => {
                self.require_end(&line);
                if conditional.had_else {
                    self.wrong(name, "a second `#else` for the same `#if`");
                }
                conditional.had_else = true;
                conditional.skips = conditional.taken;
                conditional.taken = true;
            }
            _ => return self.require_end(&line),
        }
        self.conditionals.push(conditional);
    }

    fn define_directive(&mut self, directive: &Token<'a>, mut line: Vec<Token<'a>>) {
        let Some(name) = self.macro_name(directive, &line) else {
            return;
        };
        line.remove(0);
        let is_function = line.first().is_some_and(|next| next.is("(") && !next.space);
        let parameters = match is_function {
            false => None,
            true => match self.parameters(&name, &mut line) {
                Some(parameters) => Some(parameters),
                None => return,
            },
        };
        let new = Macro {
            parameters,
            body: line,
            predefined: false,
        };
        if let Some(old) = self.macros.get(&*name.text)
            && (old.predefined || !old.agrees_with(&new))
        {
            let message = format!("the macro `{}` is already defined, differently", name.text);
            self.report(
                Diagnostic::error("preprocessor", message)
                    .at(name.span)
                    .hint("put an `#undef` before it, or choose another name"),
            );
            return;
        }
        self.macros.insert(name.text.into_owned(), Rc::new(new));
    }

    /// The name that `#define` or `#undef` is about.
    fn macro_name(&mut self, directive: &Token<'a>, line: &[Token<'a>]) -> Option<Token<'a>> {
        let Some(name) = line.first().filter(|token| token.kind == Kind::Identifier) else {
            self.wrong(
                line.first().unwrap_or(directive),
                "a macro's name is missing here",
            );
            return None;
        };
        if name.is("defined") || name.text.starts_with("GL_") {
            let message = format!("`{}` cannot be a macro: the name is reserved", name.text);
            self.wrong(name, &message);
            return None;
        }
        Some(name.clone())
    }

    /// Takes `(a, b)` off the line.
    fn parameters(&mut self, name: &Token<'a>, line: &mut Vec<Token<'a>>) -> Option<Vec<String>> {
        let Some(close) = line.iter().position(|token| token.is(")")) else {
            self.wrong(name, "the macro's parameters are never closed with `)`");
            return None;
        };
        let tokens: Vec<Token<'a>> = line.drain(..=close).collect();
        let inner = &tokens[1..close];
        let mut parameters: Vec<String> = Vec::new();
        for (i, token) in inner.iter().enumerate() {
            let wants_name = i % 2 == 0;
            let fits = match wants_name {
                true => token.kind == Kind::Identifier,
                false => token.is(","),
            };
            if !fits {
                self.wrong(
                    token,
                    "a macro's parameters are names with commas between them",
                );
                return None;
            }
            if wants_name && parameters.iter().any(|known| *known == token.text) {
                self.wrong(token, "two parameters of this macro have the same name");
                return None;
            }
            if wants_name {
                parameters.push(token.text.clone().into_owned());
            }
        }
        Some(parameters)
    }

    fn undefine(&mut self, directive: &Token<'a>, line: Vec<Token<'a>>) {
        let Some(name) = self.macro_name(directive, &line) else {
            return;
        };
        self.require_end(&line[1..]);
        match self.macros.get(&*name.text) {
            Some(old) if old.predefined => {
                self.wrong(&name, "this macro cannot be undefined: the host brings it");
            }
            _ => {
                self.macros.remove(&*name.text);
            }
        }
    }

    /// `#line` changes what `__LINE__` is in the lines that follow.
    fn line_directive(&mut self, directive: &Token<'a>, mut line: Vec<Token<'a>>) {
        // The second of two numbers names a file; it changes nothing here.
        if line.len() == 2 && line.iter().all(|token| token.kind == Kind::Number) {
            line.pop();
        }
        match condition::value(self, directive, line) {
            Ok(number) => self.line_offset += i64::from(number) - self.line(),
            Err(problem) => self.report(problem),
        }
    }

    /// Whether a name is defined, for `#if`.
    pub fn is_defined(&self, name: &str) -> bool {
        self.macros.contains_key(name)
    }
}

/// A token that stands for a number.
pub(super) fn number(text: &str, span: Span) -> Token<'_> {
    Token {
        kind: Kind::Number,
        text: Cow::Borrowed(text),
        span,
        space: false,
        painted: false,
    }
}
