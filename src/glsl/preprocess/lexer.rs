use super::MAX_SPELLING;
use super::findings::Findings;
use super::token::{Kind, Token};
use crate::glsl::names::{Name, Names, pack};
use crate::glsl::words::Symbol;
use crate::source::{Diagnostic, FileId, Span};

/// What sort a token is, how it is spelled, and whether there is white space before it. Its place is
/// where the lexer is.
pub(super) type Lexeme = (Kind, Name, bool);

/// Turns one file into tokens, line ends included.
#[derive(Debug)]
pub(super) struct Lexer<'a> {
    /// The text, up to the first NUL: there it ends for a browser.
    pub(super) text: &'a str,
    file: FileId,
    pub(super) at: usize,
    /// Where the token being read begins.
    start: usize,
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
            start: 0,
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

    /// Where the token that was scanned last stands.
    pub fn token_place(&self) -> Span {
        self.span(self.start, self.end)
    }

    /// Goes on at another place of the same line, behind this one.
    pub fn skip_to(&mut self, at: usize) {
        if self.at <= at && at <= self.text.len() && self.text.is_char_boundary(at) {
            self.at = at;
        }
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

    /// Makes all bytes of a class part of the token, and packs them.
    #[inline]
    fn take_all(&mut self, class: u8) -> u64 {
        let mut packed = 0;
        loop {
            let rest = &self.text.as_bytes()[self.at..];
            let mut length = 0;
            for &byte in rest {
                if CLASSES[usize::from(byte)] & class == 0 {
                    break;
                }
                packed = pack(packed, byte);
                length += 1;
            }
            if length > 0 {
                self.at += length;
                self.end = self.at;
            }
            if self.byte(self.at) != Some(b'\\') || !self.skip_continuations() {
                return packed;
            }
        }
    }

    /// The next token; `None` at the end of the file, which is preceded by a line end.
    pub fn next(&mut self, names: &mut Names, findings: &mut Findings) -> Option<Token> {
        let lexeme = self.scan(names, findings)?;
        Some(self.token(lexeme))
    }

    /// The token that was scanned last.
    #[inline(always)]
    pub fn token(&self, (kind, spelling, has_space): Lexeme) -> Token {
        Token::new(kind, spelling, self.span(self.start, self.end), has_space)
    }

    /// The same as [`Lexer::next`] in a form that stays in registers.
    #[inline(always)]
    pub fn scan(&mut self, names: &mut Names, findings: &mut Findings) -> Option<Lexeme> {
        if self.owed > 0 {
            return Some((Kind::Punctuator, self.stand_in(), false));
        }
        let has_space = self.skip_blanks(findings);
        let (start, lines) = (self.at, self.lines);
        self.start = start;
        let kind = match self.byte(start)? {
            b'\n' | b'\r' => {
                self.at += self.line_end(start);
                self.end = self.at;
                self.lines += 1;
                return Some((Kind::LineEnd, Name::default(), false));
            }
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => {
                let packed = self.take_all(WORD);
                let raw = &self.text[start..self.end];
                if self.lines == lines && raw.len() <= MAX_SPELLING {
                    let name = names.intern_packed(packed, raw);
                    return Some((Kind::Identifier, name, has_space));
                }
                Kind::Identifier
            }
            b'0'..=b'9' => self.number(),
            b'.' => {
                self.take(b'.');
                match self.peek() {
                    b'0'..=b'9' => self.number(),
                    _ => return Some((Kind::Punctuator, Symbol::Dot.into(), has_space)),
                }
            }
            0x80.. => {
                let character = self.text[start..].chars().next()?;
                self.at += character.len_utf8();
                self.end = self.at;
                self.owed = character.len_utf16();
                return Some((Kind::Punctuator, self.stand_in(), has_space));
            }
            first => match self.symbol(first) {
                Some(symbol) => return Some((Kind::Punctuator, symbol.into(), has_space)),
                None => Kind::Odd,
            },
        };
        let is_joined = self.lines > lines;
        Some((
            kind,
            self.spelling(kind, is_joined, names, findings),
            has_space,
        ))
    }

    /// How the token just scanned is spelled, where that needs a closer look.
    fn spelling(
        &self,
        kind: Kind,
        is_joined: bool,
        names: &mut Names,
        findings: &mut Findings,
    ) -> Name {
        let raw = &self.text[self.start..self.end];
        let text = match is_joined && raw.contains('\\') {
            true => &joined(raw),
            false => raw,
        };
        if text.len() > MAX_SPELLING {
            findings.push(self.too_long(kind));
        }
        match kind {
            Kind::Punctuator => names.intern(text),
            _ => names.intern_word(text),
        }
    }

    /// The `?` in the place of the character just read.
    #[cold]
    fn stand_in(&mut self) -> Name {
        self.owed -= 1;
        let read = &self.text[..self.end];
        let length = read.chars().next_back().map_or(0, char::len_utf8);
        self.start = self.end - length;
        Symbol::Question.into()
    }

    /// Whether the token that was scanned last is the `#` of a directive, if it stands first in its
    /// line.
    pub fn is_hash(&self) -> bool {
        self.byte(self.start) == Some(b'#')
    }

    #[cold]
    fn too_long(&self, kind: Kind) -> Diagnostic {
        let what = match kind {
            Kind::Number => "number",
            _ => "name",
        };
        let message = format!("WebGL2 refuses a {what} of more than {MAX_SPELLING} characters");
        match self.strict {
            true => Diagnostic::error("too-long", message),
            false => Diagnostic::warning("too-long", message),
        }
        .at(self.span(self.start, self.end))
    }

    /// Everything that looks like one number, right or wrong.
    fn number(&mut self) -> Kind {
        self.take_all(NUMBER);
        // A sign belongs to the number only where it makes a float complete: `0xE+1` is a sum.
        let last = self.byte(self.end - 1);
        if matches!(last, Some(b'e' | b'E')) && matches!(self.peek(), b'+' | b'-') {
            let (at, lines) = (self.at, self.lines);
            let raw = &self.text[self.start..self.end - 1];
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

    /// The longest operator or bracket that begins with a byte; `None` if none does. The byte is
    /// taken in any case.
    fn symbol(&mut self, first: u8) -> Option<Symbol> {
        use Symbol as S;
        self.at += 1;
        self.end = self.at;
        Some(match first {
            b'(' => S::LeftParenthesis,
            b')' => S::RightParenthesis,
            b'[' => S::LeftBracket,
            b']' => S::RightBracket,
            b'{' => S::LeftBrace,
            b'}' => S::RightBrace,
            b',' => S::Comma,
            b':' => S::Colon,
            b';' => S::Semicolon,
            b'?' => S::Question,
            b'~' => S::Complement,
            b'=' => self.either(b'=', S::Equal, S::Assign),
            b'!' => self.either(b'=', S::NotEqual, S::Not),
            b'*' => self.either(b'=', S::StarAssign, S::Star),
            b'/' => self.either(b'=', S::SlashAssign, S::Slash),
            b'%' => self.either(b'=', S::PercentAssign, S::Percent),
            b'+' if self.take(b'+') => S::Increment,
            b'+' => self.either(b'=', S::PlusAssign, S::Plus),
            b'-' if self.take(b'-') => S::Decrement,
            b'-' => self.either(b'=', S::MinusAssign, S::Minus),
            b'&' if self.take(b'&') => S::AndAnd,
            b'&' => self.either(b'=', S::AndAssign, S::And),
            b'|' if self.take(b'|') => S::OrOr,
            b'|' => self.either(b'=', S::OrAssign, S::Or),
            b'^' if self.take(b'^') => S::XorXor,
            b'^' => self.either(b'=', S::XorAssign, S::Xor),
            b'<' if self.take(b'<') => self.either(b'=', S::ShiftLeftAssign, S::ShiftLeft),
            b'<' => self.either(b'=', S::LessEqual, S::Less),
            b'>' if self.take(b'>') => self.either(b'=', S::ShiftRightAssign, S::ShiftRight),
            b'>' => self.either(b'=', S::GreaterEqual, S::Greater),
            _ => return None,
        })
    }

    /// The one operator if this byte follows, the other if not.
    fn either(&mut self, byte: u8, with: Symbol, without: Symbol) -> Symbol {
        if self.take(byte) { with } else { without }
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
        let (mut findings, mut names) = Default::default();
        let mut lexer = Lexer::new(file, text, false, &mut findings);
        let mut spellings = Vec::new();
        while let Some(token) = lexer.next(&mut names, &mut findings) {
            let space = if token.has_space() { " " } else { "" };
            let text = match token.kind {
                Kind::LineEnd => "¶",
                _ => names.text(token.spelling),
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
