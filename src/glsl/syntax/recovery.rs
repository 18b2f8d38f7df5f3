//! Going on behind what is wrong, where the next thing is likely to begin.

use super::ast::TokenIndex;
use super::lexeme::Lexeme;
use super::parser::{Parse, Parser};
use crate::glsl::words::{Symbol, Word};

impl Parser<'_> {
    /// Forgets what was begun; the next token may well be wrong for the same reason as the last.
    pub fn settle(&mut self) {
        self.nesting = 0;
        self.pending.clear();
        self.arguments.clear();
        self.quiet_until = self.quiet_until.max(self.at + 1);
    }

    /// Moves behind the end of a statement that begins at `start`, but not out of its block.
    pub fn skip_statement(&mut self, start: usize) {
        loop {
            match self.peek() {
                Lexeme::End | Lexeme::Symbol(Symbol::RightBrace) => break,
                Lexeme::Symbol(Symbol::Semicolon) => {
                    self.advance();
                    break;
                }
                Lexeme::Symbol(Symbol::LeftBrace) => {
                    self.skip_braces();
                    break;
                }
                Lexeme::Word(word)
                    if self.at > start && (word.begins_statement() || word == Word::Else) =>
                {
                    break;
                }
                _ => {
                    self.advance();
                }
            }
        }
        self.settle();
    }

    /// Moves to where another item is likely to begin, at least by one token from `start`.
    pub fn skip_item(&mut self, start: usize) {
        loop {
            match self.peek() {
                Lexeme::End => break,
                Lexeme::Symbol(Symbol::Semicolon) => {
                    self.advance();
                    break;
                }
                Lexeme::Symbol(Symbol::LeftBrace) => {
                    self.skip_braces();
                    self.accept(Symbol::Semicolon);
                    break;
                }
                _ if self.at > start && self.begins_item() => break,
                _ => {
                    self.advance();
                }
            }
        }
        self.settle();
    }

    fn begins_item(&self) -> bool {
        match self.peek() {
            Lexeme::Symbol(Symbol::RightBrace)
            | Lexeme::Word(Word::Struct | Word::Uniform | Word::Precision | Word::Const) => true,
            Lexeme::Type(_) | Lexeme::Name(_) => matches!(
                (self.peek_at(1), self.peek_at(2)),
                (
                    Lexeme::Name(_),
                    Lexeme::Symbol(Symbol::LeftParenthesis | Symbol::Assign)
                )
            ),
            _ => false,
        }
    }

    /// Moves from a `{` behind its `}`.
    fn skip_braces(&mut self) {
        let mut depth = 0;
        loop {
            match self.peek() {
                Lexeme::End => return,
                Lexeme::Symbol(Symbol::LeftBrace) => depth += 1,
                Lexeme::Symbol(Symbol::RightBrace) => depth -= 1,
                _ => {}
            }
            self.advance();
            if depth == 0 {
                return;
            }
        }
    }

    /// Moves behind the `)` of the `(` at `open`, which something before the token at hand follows.
    /// Stops before what cannot stand in parentheses.
    pub fn skip_header(&mut self, open: TokenIndex, may_hold_semicolons: bool) {
        let here = self.at;
        self.at = open as usize;
        let mut depth = 0;
        loop {
            match self.peek() {
                Lexeme::Symbol(Symbol::LeftParenthesis) => depth += 1,
                Lexeme::Symbol(Symbol::RightParenthesis) => depth -= 1,
                Lexeme::End | Lexeme::Symbol(Symbol::LeftBrace | Symbol::RightBrace) => break,
                Lexeme::Symbol(Symbol::Semicolon) if !may_hold_semicolons => break,
                _ => {}
            }
            self.advance();
            if depth == 0 {
                break;
            }
        }
        self.at = self.at.max(here);
        self.settle();
    }

    /// Reads what stands in the `(…)` of a statement or function, and the `)`. If it is wrong, moves
    /// behind the `)` all the same, so that the body can be read.
    pub fn in_header<T>(
        &mut self,
        open: TokenIndex,
        may_hold_semicolons: bool,
        expected: &str,
        read: impl FnOnce(&mut Self) -> Parse<T>,
    ) -> Parse<T> {
        let content = read(self).and_then(|content| {
            self.close(open, Symbol::RightParenthesis, expected)?;
            Ok(content)
        });
        if content.is_err() {
            self.skip_header(open, may_hold_semicolons);
        }
        content
    }
}
