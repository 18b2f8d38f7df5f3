use crate::glsl::names::Name;
use crate::glsl::words::Symbol;
use crate::source::{Diagnostic, FileId, Span};

/// A preprocessing token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// How it is spelled, line continuations removed.
    pub spelling: Name,
    /// Where it stands in the text. For a token of a macro's definition: the outermost use of a
    /// macro that brought it. For a token of an argument: the place in that argument.
    pub span: Span,
    // Bare numbers instead of `Option<Span>`, so that a token is 28 bytes and not 36.
    origin_start: u32,
    origin_end: u32,
    origin_file: u16,
    /// What sort of token.
    pub kind: Kind,
    flags: u8,
}

/// The sorts of token that a preprocessor tells apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A name or keyword.
    Identifier,
    /// Something that begins like a number, well-formed or not.
    Number,
    /// An operator or a bracket. A character outside ASCII reads as `?`, as in a browser.
    Punctuator,
    /// A character of ASCII that GLSL does not know.
    Odd,
    /// The end of a line. Directives end there; the parser never sees it.
    LineEnd,
}

/// White space or a comment stands before the token.
const SPACE: u8 = 1;
/// The token names a macro that was being expanded when it was read, and so is no use of it.
const PAINTED: u8 = 2;
/// The token names a parameter of the macro in whose body it stands.
const PARAMETER: u8 = 4;

const NO_FILE: u16 = u16::MAX;

impl Token {
    #[inline]
    pub(super) fn new(kind: Kind, spelling: Name, span: Span, has_space: bool) -> Self {
        Token {
            spelling,
            span,
            origin_start: 0,
            origin_end: 0,
            origin_file: NO_FILE,
            kind,
            flags: if has_space { SPACE } else { 0 },
        }
    }

    /// Whether the token is this operator or bracket.
    pub(super) fn is(&self, symbol: Symbol) -> bool {
        self.spelling == symbol.into()
    }

    /// Where the token was written in the definition of a macro; `None` if it stands in the text
    /// itself.
    pub fn origin(&self) -> Option<Span> {
        (self.origin_file != NO_FILE).then(|| Span {
            file: FileId::from_index(self.origin_file.into()),
            start: self.origin_start,
            end: self.origin_end,
        })
    }

    /// Points a diagnostic at the token, with a note if it comes from a macro.
    pub fn blame(&self, diagnostic: Diagnostic) -> Diagnostic {
        let diagnostic = diagnostic.at(self.span);
        match self.origin() {
            Some(origin) => diagnostic.note(origin, "a macro brings it from here"),
            None => diagnostic,
        }
    }

    /// The token of a macro's definition as a use of the macro brings it.
    pub(super) fn brought_to(&self, place: Span) -> Self {
        let origin = self.span;
        // Of more files than a scene ever has, the last ones go without notes.
        let origin_file = u16::try_from(origin.file.index()).unwrap_or(NO_FILE);
        Token {
            span: place,
            origin_start: origin.start,
            origin_end: origin.end,
            origin_file,
            ..*self
        }
    }

    pub(super) fn has_space(&self) -> bool {
        self.flags & SPACE != 0
    }

    pub(super) fn set_space(&mut self, space: bool) {
        self.flags = self.flags & !SPACE | u8::from(space);
    }

    pub(super) fn is_painted(&self) -> bool {
        self.flags & PAINTED != 0
    }

    pub(super) fn paint(&mut self) {
        self.flags |= PAINTED;
    }

    /// Which parameter a token of a macro's body names.
    pub(super) fn parameter(&self) -> Option<usize> {
        (self.flags & PARAMETER != 0).then_some(self.origin_start as usize)
    }

    /// Tokens of a body have no origin, so that there is room for the number.
    pub(super) fn set_parameter(&mut self, index: u32) {
        self.flags |= PARAMETER;
        self.origin_start = index;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_are_small() {
        assert!(size_of::<Token>() <= 28);
    }
}
