//! What is wrong, in words: each mistake once, where the author will look for it.

use super::ast::TokenIndex;
use super::lexeme::{Lexeme, blame, blame_behind};
use super::parser::{Failed, MAX_ERRORS, Parser};
use crate::glsl::names::Name;
use crate::glsl::words::{Symbol, instead_of};
use crate::source::Diagnostic;

impl Parser<'_> {
    /// Reports a diagnostic about what was found at a token, unless it is a consequence of another.
    pub fn report(&mut self, at: usize, diagnostic: Diagnostic) {
        if at < self.quiet_until || self.lexemes[at] == Lexeme::Refused {
            return;
        }
        let before = at.saturating_sub(1);
        if (before..=at).any(|at| self.misused.contains(&self.lexemes[at])) {
            return;
        }
        self.quiet_until = at + 1;
        self.diagnostics.push((at, diagnostic));
        if self.diagnostics.len() >= MAX_ERRORS {
            self.give_up();
        }
    }

    /// Goes to the end of the text and reports no more.
    pub fn give_up(&mut self) {
        self.at = self.lexemes.len() - 1;
        self.quiet_until = usize::MAX;
    }

    /// Reports that something else was expected at the token at hand.
    pub fn unexpected(&mut self, expected: &str) -> Failed {
        self.unexpected_but(expected, None)
    }

    /// Like [`Parser::unexpected`], with a hint.
    pub fn unexpected_but(&mut self, expected: &str, hint: Option<&str>) -> Failed {
        if self.peek() == Lexeme::End {
            return self.too_early(expected);
        }
        if let Some((name, at)) = self.blamed_word() {
            let word = self.ast.names.text(name);
            let message = format!("`{word}` is a reserved word and means nothing here");
            let diagnostic = Diagnostic::error("reserved-word", message).hint(instead_of(word));
            let diagnostic = blame(&self.tokens[at], diagnostic);
            // Once is enough; after that the word is left to explain its other uses in silence.
            if !self.blamed.contains(&name) {
                self.blamed.push(name);
                self.report(self.at, diagnostic);
            }
            return Failed;
        }
        let found = self.spelling(self.at);
        let message = format!("expected {expected}, found {found}");
        let is_behind_comma = matches!(
            self.peek(),
            Lexeme::Symbol(Symbol::RightParenthesis | Symbol::Semicolon | Symbol::Comma)
        ) && self.at > 0
            && self.lexemes[self.at - 1] == Lexeme::Symbol(Symbol::Comma);
        let hint = hint.or(is_behind_comma.then_some("is there a `,` too many before it?"));
        self.wrong(self.at, message, hint)
    }

    /// Reports a mistake at a token.
    pub fn wrong(&mut self, at: usize, message: impl Into<String>, hint: Option<&str>) -> Failed {
        let mut diagnostic = Diagnostic::error("syntax", message);
        if let Some(hint) = hint {
            diagnostic = diagnostic.hint(hint);
        }
        self.report(at, blame(&self.tokens[at], diagnostic));
        Failed
    }

    /// Reports a mistake that the token at hand gives away about an earlier one.
    pub fn wrong_about(&mut self, earlier: usize, message: String, hint: &str) -> Failed {
        let diagnostic = Diagnostic::error("syntax", message).hint(hint);
        match self.blamed_word() {
            Some(_) => self.unexpected("something else"),
            None => {
                self.report(self.at, blame(&self.tokens[earlier], diagnostic));
                Failed
            }
        }
    }

    /// Refuses the keyword at hand as a name, moves over it and takes it for one. Whatever goes wrong
    /// where it is used is not worth telling.
    pub fn keyword_as_name(&mut self) -> (Name, TokenIndex) {
        let at = self.advance();
        let token = &self.tokens[at as usize];
        let name = token.spelling;
        let message = format!(
            "{} is a keyword and cannot be a name",
            self.spelling(at as usize)
        );
        let diagnostic = Diagnostic::error("syntax", message).hint("choose another name");
        let diagnostic = blame(token, diagnostic);
        self.report(at as usize, diagnostic);
        self.misused.push(self.lexeme(at));
        (name, at)
    }

    /// A token as messages quote it.
    pub fn spelling(&self, at: usize) -> String {
        format!("`{}`", self.ast.names.quoted(self.tokens[at].spelling))
    }

    pub fn too_early(&mut self, expected: &str) -> Failed {
        if let Some(last) = self.tokens.last() {
            let diagnostic = Diagnostic::error("syntax", "the text ends too early")
                .hint(format!("{expected} is missing, here or somewhere above"));
            let diagnostic = blame_behind(last, diagnostic);
            if !self.braces_are_off {
                self.report(self.at, diagnostic);
            }
        }
        Failed
    }

    /// Reports that something is nested beyond reason.
    pub fn too_deep(&mut self, at: TokenIndex, message: String, hint: &str) -> Failed {
        let at = (at as usize).min(self.tokens.len() - 1);
        let diagnostic = Diagnostic::error("too-deep", message).hint(hint);
        let diagnostic = blame(&self.tokens[at], diagnostic);
        self.report(self.at.min(self.lexemes.len() - 1), diagnostic);
        Failed
    }

    /// A reserved word at hand or just before, which explains why nothing fits: as in `static float x`
    /// or `enum E {`.
    pub fn blamed_word(&self) -> Option<(Name, usize)> {
        let before = self.at.checked_sub(1);
        let is_name = |at: &usize| matches!(self.lexemes[*at], Lexeme::Name(_));
        let two_before = before.filter(is_name).and_then(|at| at.checked_sub(1));
        let places = [two_before, before, Some(self.at)];
        places.into_iter().flatten().find_map(|at| {
            let Lexeme::Name(name) = self.lexemes[at] else {
                return None;
            };
            let is_member = at > 0 && self.lexemes[at - 1] == Lexeme::Symbol(Symbol::Dot);
            let is_reserved = self.reserved.iter().any(|(reserved, _)| *reserved == name);
            (is_reserved && !is_member).then_some((name, at))
        })
    }
}
