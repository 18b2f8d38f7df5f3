use std::borrow::Cow;

use super::MAX_SPELLING;
use super::findings::Findings;
use super::token::{Kind, Token};
use crate::source::{Diagnostic, FileId, Span};

/// A token as its place in the file, which is all that most of them ever need.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lexeme {
    start: u32,
    end: u32,
    pub kind: Kind,
    flags: u8,
}

/// White space or a comment stands before it.
const SPACE: u8 = 1;
/// Lines are joined within it.
const JOINED: u8 = 2;
/// It is a `?` in the place of a character outside ASCII.
const STAND_IN: u8 = 4;

impl Lexeme {
    /// The end of a line that has none.
    pub const LINE_END: Lexeme = Lexeme {
        start: 0,
        end: 0,
        kind: Kind::LineEnd,
        flags: 0,
    };
}

/// Turns one file into tokens, line ends included.
#[derive(Debug)]
pub(super) struct Lexer<'a> {
    /// The text, up to the first NUL: there it ends for a browser.
    pub(super) text: &'a str,
    file: FileId,
    pub(super) at: usize,
    /// Behind the last character of the token being read; `at` may be behind a continuation already.
    end: usize,
    /// Line ends passed so far.
    pub lines: u32,
    /// How often the `?` of a character outside ASCII is still to come: once for each of its UTF-16
    /// units.
    owed: usize,
    ends_early: bool,
    strict: bool,
}

impl<'a> Lexer<'a> {
    pub fn new(file: FileId, text: &'a str, strict: bool, findings: &mut Findings) -> Self {
        let nul = memchr::memchr(0, text.as_bytes());
        let mut lexer = Lexer {
            text: &text[..nul.unwrap_or(text.len())],
            file,
            at: 0,
            end: 0,
            lines: 0,
            owed: 0,
            ends_early: nul.is_some(),
            strict,
        };
        if text.starts_with('\u{feff}') {
            lexer.at = '\u{feff}'.len_utf8();
            if strict {
                findings.push(
                    Diagnostic::error("byte-order-mark", "WebGL2 refuses a byte-order mark")
                        .at(lexer.span(0, lexer.at))
                        .hint("save the file as UTF-8 without a byte-order mark"),
                );
            }
        }
        lexer
    }

    /// Where the reading is.
    pub fn place(&self) -> Span {
        self.span(self.at, self.at)
    }

    /// Whether nothing may follow this file, because a NUL ends it.
    pub fn ends_early(&self) -> bool {
        self.ends_early
    }

    pub(super) fn span(&self, start: usize, end: usize) -> Span {
        Span {
            file: self.file,
            start: start as u32,
            end: end as u32,
        }
    }

    pub(super) fn byte(&self, at: usize) -> Option<u8> {
        self.text.as_bytes().get(at).copied()
    }

    /// The length of a line end at `at`. LF CR is two of them.
    pub(super) fn line_end(&self, at: usize) -> usize {
        match (self.byte(at), self.byte(at + 1)) {
            (Some(b'\r'), Some(b'\n')) => 2,
            (Some(b'\r' | b'\n'), _) => 1,
            _ => 0,
        }
    }

    /// Moves over backslashes before line ends, which join lines everywhere, even within a name.
    /// Whether there were any.
    #[cold]
    fn skip_continuations(&mut self) -> bool {
        let begin = self.at;
        while self.byte(self.at) == Some(b'\\') {
            match self.line_end(self.at + 1) {
                0 => break,
                length => {
                    self.at += 1 + length;
                    self.lines += 1;
                }
            }
        }
        self.at > begin
    }

    /// The next byte, continuations passed; 0 at the end.
    pub(super) fn peek(&mut self) -> u8 {
        if self.byte(self.at) == Some(b'\\') {
            self.skip_continuations();
        }
        self.byte(self.at).unwrap_or(0)
    }

    /// Makes the next byte part of the token if it is this one.
    fn take(&mut self, byte: u8) -> bool {
        let is_next = self.peek() == byte;
        if is_next {
            self.at += 1;
            self.end = self.at;
        }
        is_next
    }

    /// Makes all bytes of a class part of the token.
    fn take_all(&mut self, class: u8) {
        loop {
            let rest = &self.text.as_bytes()[self.at..];
            let is_other = |byte: &u8| CLASSES[usize::from(*byte)] & class == 0;
            let length = rest.iter().position(is_other).unwrap_or(rest.len());
            if length > 0 {
                self.at += length;
                self.end = self.at;
            }
            if self.byte(self.at) != Some(b'\\') || !self.skip_continuations() {
                return;
            }
        }
    }

    /// The next token; `None` at the end of the file, which is preceded by a line end.
    #[inline]
    pub fn next(&mut self, findings: &mut Findings) -> Option<Lexeme> {
        if self.owed > 0 {
            return Some(self.stand_in(0));
        }
        let space = if self.skip_blanks(findings) { SPACE } else { 0 };
        let (start, lines) = (self.at, self.lines);
        let kind = match self.byte(start)? {
            b'\n' | b'\r' => {
                self.at += self.line_end(start);
                self.end = self.at;
                self.lines += 1;
                return Some(self.lexeme(Kind::LineEnd, start, 0));
            }
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => {
                self.take_all(WORD);
                Kind::Identifier
            }
            b'0'..=b'9' => self.number(start),
            b'.' => {
                self.take(b'.');
                match self.peek() {
                    b'0'..=b'9' => self.number(start),
                    _ => Kind::Punctuator,
                }
            }
            0x80.. => {
                let character = self.text[start..].chars().next()?;
                self.at += character.len_utf8();
                self.end = self.at;
                self.owed = character.len_utf16();
                return Some(self.stand_in(space));
            }
            first => self.symbol(first),
        };
        let joined = self.lines > lines && self.end > start + 1 && {
            let raw = &self.text.as_bytes()[start..self.end];
            raw.contains(&b'\\')
        };
        let joined = if joined { JOINED } else { 0 };
        let lexeme = self.lexeme(kind, start, space | joined);
        if self.end - start > MAX_SPELLING {
            self.require_short(lexeme, findings);
        }
        Some(lexeme)
    }

    fn lexeme(&self, kind: Kind, start: usize, flags: u8) -> Lexeme {
        Lexeme {
            start: start as u32,
            end: self.end as u32,
            kind,
            flags,
        }
    }

    /// The `?` in the place of the character just read.
    #[cold]
    fn stand_in(&mut self, space: u8) -> Lexeme {
        self.owed -= 1;
        let read = &self.text[..self.end];
        let length = read.chars().next_back().map_or(0, char::len_utf8);
        let start = self.end - length;
        self.lexeme(Kind::Punctuator, start, space | STAND_IN)
    }

    /// How a token is spelled.
    #[inline]
    pub fn spelling(&self, lexeme: Lexeme) -> Cow<'a, str> {
        let raw = &self.text[lexeme.start as usize..lexeme.end as usize];
        match lexeme.flags & (JOINED | STAND_IN) {
            0 => Cow::Borrowed(raw),
            STAND_IN => Cow::Borrowed("?"),
            _ => Cow::Owned(joined(raw)),
        }
    }

    /// The token in full.
    #[inline]
    pub fn token(&self, lexeme: Lexeme) -> Token<'a> {
        let span = self.span(lexeme.start as usize, lexeme.end as usize);
        let mut token = Token::new(lexeme.kind, self.spelling(lexeme), span);
        token.set_space(lexeme.flags & SPACE != 0);
        token
    }

    /// Whether a token is the `#` of a directive, if it stands first in its line.
    pub fn is_hash(&self, lexeme: Lexeme) -> bool {
        lexeme.kind == Kind::Odd && self.byte(lexeme.start as usize) == Some(b'#')
    }

    #[cold]
    fn require_short(&self, lexeme: Lexeme, findings: &mut Findings) {
        let token = self.token(lexeme);
        if token.text.len() > MAX_SPELLING {
            findings.push(self.too_long(&token));
        }
    }

    fn too_long(&self, token: &Token<'_>) -> Diagnostic {
        let what = match token.kind {
            Kind::Number => "number",
            _ => "name",
        };
        let message = format!("WebGL2 refuses a {what} of more than {MAX_SPELLING} characters");
        match self.strict {
            true => Diagnostic::error("too-long", message),
            false => Diagnostic::warning("too-long", message),
        }
        .at(token.span)
    }

    /// Everything that looks like one number, right or wrong.
    fn number(&mut self, start: usize) -> Kind {
        self.take_all(NUMBER);
        // A sign belongs to the number only where it makes a float complete: `0xE+1` is a sum.
        let last = self.byte(self.end - 1);
        if matches!(last, Some(b'e' | b'E')) && matches!(self.peek(), b'+' | b'-') {
            let (at, lines) = (self.at, self.lines);
            let raw = &self.text[start..self.end - 1];
            self.at += 1;
            if self.peek().is_ascii_digit() && is_mantissa(raw) {
                self.take_all(DIGIT);
                let _ = self.take(b'f') || self.take(b'F');
            } else {
                (self.at, self.lines) = (at, lines);
            }
        }
        Kind::Number
    }

    fn symbol(&mut self, first: u8) -> Kind {
        self.at += 1;
        self.end = self.at;
        match first {
            b'+' | b'-' | b'&' | b'|' | b'^' => {
                let _ = self.take(first) || self.take(b'=');
            }
            b'*' | b'/' | b'%' | b'=' | b'!' => {
                self.take(b'=');
            }
            b'<' | b'>' => {
                self.take(first);
                self.take(b'=');
            }
            b'(' | b')' | b'[' | b']' | b'{' | b'}' | b'~' | b':' | b';' | b',' | b'?' => {}
            _ => return Kind::Odd,
        }
        Kind::Punctuator
    }
}

/// A spelling without its line continuations.
#[cold]
fn joined(raw: &str) -> String {
    raw.replace(['\\', '\r', '\n'], "")
}

/// Whether an exponent may follow, continuations overlooked.
fn is_mantissa(raw: &str) -> bool {
    let of_interest = |byte: &u8| !matches!(byte, b'\\' | b'\r' | b'\n');
    let mut dots = 0;
    raw.bytes().filter(of_interest).all(|byte| {
        dots += u32::from(byte == b'.');
        byte.is_ascii_digit() || (byte == b'.' && dots == 1)
    })
}

const DIGIT: u8 = 1;
/// Letters, digits and `_`.
const WORD: u8 = 2;
/// What may follow the first digit of a number, signs apart.
const NUMBER: u8 = 4;

/// The classes that each byte belongs to.
const CLASSES: [u8; 256] = {
    let mut classes = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let character = byte as u8;
        if character.is_ascii_digit() {
            classes[byte] |= DIGIT;
        }
        if character.is_ascii_alphanumeric() || character == b'_' {
            classes[byte] |= WORD | NUMBER;
        }
        if character == b'.' {
            classes[byte] |= NUMBER;
        }
        byte += 1;
    }
    classes
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::SourceMap;

    fn spellings(text: &str) -> Vec<String> {
        let file = SourceMap::default().add("a", text);
        let mut findings = Findings::default();
        let mut lexer = Lexer::new(file, text, false, &mut findings);
        let mut spellings = Vec::new();
        while let Some(lexeme) = lexer.next(&mut findings) {
            let token = lexer.token(lexeme);
            let space = if token.has_space() { " " } else { "" };
            let text = match token.kind {
                Kind::LineEnd => "¶",
                _ => &token.text,
            };
            spellings.push(format!("{space}{text}"));
        }
        spellings
    }

    #[test]
    fn tokens() {
        assert_eq!(spellings("a+=b<<1"), ["a", "+=", "b", "<<", "1"]);
        assert_eq!(spellings("a/**/b /* */ // c\n d"), ["a", " b", "¶", " d"]);
        assert_eq!(spellings("a/b"), ["a", "/", "b"]);
        assert_eq!(
            spellings("a<<=b>=c^^d--e"),
            ["a", "<<=", "b", ">=", "c", "^^", "d", "--", "e"]
        );
        assert_eq!(spellings("\u{b}a\u{c}b\tc"), [" a", " b", " c"]);
    }

    #[test]
    fn numbers_are_as_long_as_can_be() {
        assert_eq!(
            spellings("1.5e-3f.x .5 a.b"),
            ["1.5e-3f", ".", "x", " .5", " a", ".", "b"]
        );
        assert_eq!(spellings("1.5f.x"), ["1.5f.x"]);
        assert_eq!(spellings("0xE+1"), ["0xE", "+", "1"]);
        assert_eq!(
            spellings("1e+ 1e+x 1e"),
            ["1e", "+", " 1e", "+", "x", " 1e"]
        );
        assert_eq!(spellings("1\\\ne\\\n+\\\n5\\\nf"), ["1e+5f"]);
    }

    #[test]
    fn lines_end_in_three_ways() {
        assert_eq!(
            spellings("x\r\ny\rz\n\rw"),
            ["x", "¶", "y", "¶", "z", "¶", "¶", "w"]
        );
    }

    #[test]
    fn a_backslash_joins_lines_everywhere() {
        assert_eq!(spellings("ab\\\ncd +\\\r\n= e"), ["abcd", " +=", " e"]);
        assert_eq!(spellings("// a\\\nb\nc"), ["¶", "c"]);
        assert_eq!(spellings("// a\\\\\r\nb\\\rc\rd"), ["¶", "d"]);
        assert_eq!(spellings("a\\ \nb"), ["a", "\\", "¶", "b"]);
        assert_eq!(spellings("a/\\\n* b *\\\n/c"), ["a", " c"]);
        assert_eq!(spellings("\\\n\\\na"), ["a"]);
        assert_eq!(spellings("a\\"), ["a", "\\"]);
    }

    #[test]
    fn characters_outside_ascii_are_question_marks() {
        assert_eq!(spellings("\u{feff}é@ é 🙂"), ["?", "@", " ?", " ?", "?"]);
        assert_eq!(spellings("café /* é */"), ["caf", "?"]);
    }

    #[test]
    fn nul_ends_the_text() {
        assert_eq!(spellings("a\0b"), ["a"]);
        assert_eq!(spellings("a // \0\nb"), ["a"]);
    }
}
