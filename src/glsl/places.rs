//! From tokens to places in the author's files.

use super::names::Name;
use super::preprocess::Token;
use super::syntax::ast::{Extent, TokenIndex};
use crate::source::{Diagnostic, Span};

/// Finds where tokens were written.
#[derive(Clone, Copy, Debug)]
pub struct Places<'t> {
    tokens: &'t [Token],
}

impl<'t> Places<'t> {
    /// The places of these tokens.
    pub fn new(tokens: &'t [Token]) -> Self {
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
        match self.origin(extent) {
            Some(origin) => diagnostic.note(origin, "a macro brings it from here"),
            None => diagnostic,
        }
    }

    /// Where the definition of a macro has the first token, if a macro has brought it.
    pub fn origin(&self, extent: Extent) -> Option<Span> {
        self.token(extent.first)?.origin()
    }

    /// What the token is.
    pub fn spelling(&self, index: TokenIndex) -> Option<Name> {
        Some(self.token(index)?.spelling)
    }

    fn token(&self, index: TokenIndex) -> Option<&'t Token> {
        let last = self.tokens.len().checked_sub(1)?;
        self.tokens.get((index as usize).min(last))
    }
}
