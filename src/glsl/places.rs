//! From tokens to places in the author's files.

use super::preprocess::Token;
use super::syntax::ast::{Extent, TokenIndex};
use crate::source::{Diagnostic, Span};

/// Finds where tokens were written.
#[derive(Clone, Copy, Debug)]
pub struct Places<'t, 'a> {
    tokens: &'t [Token<'a>],
}

impl<'t, 'a> Places<'t, 'a> {
    /// The places of these tokens.
    pub fn new(tokens: &'t [Token<'a>]) -> Self {
        Places { tokens }
    }

    /// From the first token to the last, unless macros or several files have brought them from places
    /// that are not in this order: then it is the first token.
    pub fn span(&self, extent: Extent) -> Option<Span> {
        let first = self.token(extent.first)?.span;
        match self.token(extent.last) {
            Some(last) if last.span.file == first.file && last.span.end >= first.end => {
                Some(Span {
                    end: last.span.end,
                    ..first
                })
            }
            _ => Some(first),
        }
    }

    /// Points a diagnostic at some tokens, with a note if a macro has brought them.
    pub fn point(&self, diagnostic: Diagnostic, extent: Extent) -> Diagnostic {
        let diagnostic = diagnostic.at(self.span(extent));
        match self.token(extent.first).and_then(Token::origin) {
            Some(origin) => diagnostic.note(origin, "a macro brings it from here"),
            None => diagnostic,
        }
    }

    /// What the token is.
    pub fn text(&self, index: TokenIndex) -> &'t str {
        self.token(index).map_or("", |token| &token.text)
    }

    fn token(&self, index: TokenIndex) -> Option<&'t Token<'a>> {
        let last = self.tokens.len().checked_sub(1)?;
        self.tokens.get((index as usize).min(last))
    }
}
