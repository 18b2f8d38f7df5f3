//! What stands behind a directive's name, piece by piece.

use crate::source::{Diagnostic, FileId, Span};

use super::scan::Found;

/// The rest of a directive's line.
pub(super) struct Line<'a> {
    file: FileId,
    rest: &'a str,
    /// Where the rest begins in the file.
    start: usize,
    at: usize,
}

/// A place and what is there.
pub(super) struct Piece<'a> {
    pub text: &'a str,
    pub place: Span,
}

impl<'a> Line<'a> {
    pub fn new(file: FileId, found: &Found<'a>) -> Self {
        Line {
            file,
            rest: found.rest,
            start: found.rest_start(),
            at: 0,
        }
    }

    fn span(&self, from: usize, to: usize) -> Span {
        let offset = |at: usize| u32::try_from(self.start + at).unwrap_or(u32::MAX);
        Span {
            file: self.file,
            start: offset(from),
            end: offset(to),
        }
    }

    fn left(&self) -> &'a str {
        &self.rest[self.at..]
    }

    fn skip_blanks(&mut self) {
        self.at += self.left().len() - self.left().trim_start().len();
    }

    /// An error at what comes next, or at the end of the line.
    pub fn expected(&mut self, what: &str) -> Diagnostic {
        self.skip_blanks();
        let next = self.left();
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let word = next.find(|c| !is_word(c)).unwrap_or(next.len());
        let length = match word {
            0 => next.chars().next().map_or(0, char::len_utf8),
            word => word,
        };
        let place = self.span(self.at, self.at + length);
        Diagnostic::error("directive", format!("{what} is missing here")).at(place)
    }

    /// A text in quotes of either kind.
    pub fn string(&mut self, what: &str) -> Result<Piece<'a>, Diagnostic> {
        self.skip_blanks();
        let left = self.left();
        let quote = left.chars().next().filter(|&c| c == '"' || c == '\'');
        let end = quote.and_then(|quote| left[1..].find(quote));
        let Some(end) = end else {
            return Err(self.expected(what));
        };
        let place = self.span(self.at, self.at + end + 2);
        self.at += end + 2;
        Ok(Piece {
            text: &left[1..=end],
            place,
        })
    }

    /// A name, or a word such as `in`.
    pub fn word(&mut self, what: &str) -> Result<Piece<'a>, Diagnostic> {
        self.skip_blanks();
        let left = self.left();
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let length = left.find(|c| !is_word(c)).unwrap_or(left.len());
        if length == 0 || left.starts_with(|c: char| c.is_ascii_digit()) {
            return Err(self.expected(what));
        }
        let place = self.span(self.at, self.at + length);
        self.at += length;
        Ok(Piece {
            text: &left[..length],
            place,
        })
    }

    /// A number, its sign included.
    pub fn number(&mut self) -> Option<&'a str> {
        self.skip_blanks();
        let left = self.left();
        let bytes = left.as_bytes();
        let digits = |mut at: usize| {
            while bytes.get(at).is_some_and(u8::is_ascii_digit) {
                at += 1;
            }
            at
        };
        let sign = usize::from(left.starts_with(['-', '+']));
        let whole = digits(sign);
        let mut end = match bytes.get(whole) {
            Some(b'.') => digits(whole + 1),
            _ => whole,
        };
        if end == sign || (end == sign + 1 && whole == sign) {
            return None;
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'-' | b'+')));
            let exponent = digits(end + 1 + sign);
            if exponent > end + 1 + sign {
                end = exponent;
            }
        }
        self.at += end;
        Some(&left[..end])
    }

    /// Goes over a text if it comes next.
    pub fn take(&mut self, text: &str) -> bool {
        self.skip_blanks();
        let is_next = self.left().starts_with(text);
        if is_next {
            self.at += text.len();
        }
        is_next
    }

    /// Nothing but a comment may follow.
    pub fn end(&mut self) -> Result<(), Diagnostic> {
        self.skip_blanks();
        let left = self.left();
        let is_comment = |left: &str| {
            let inside = left.strip_prefix("/*");
            let behind = inside.and_then(|inside| inside.split_once("*/"));
            behind.is_some_and(|(_, behind)| behind.trim().is_empty())
        };
        // A semicolon changes nothing, and is a habit.
        let left = left.strip_prefix(';').unwrap_or(left).trim_start();
        if left.is_empty() || left.starts_with("//") || is_comment(left) {
            return Ok(());
        }
        let place = self.span(self.at, self.rest.trim_end().len());
        Err(Diagnostic::error("directive", "the line should end before this").at(place))
    }
}
