use std::borrow::Cow;

use crate::source::{Diagnostic, FileId, Span};

/// A preprocessing token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token<'a> {
    /// What sort of token.
    pub kind: Kind,
    /// Its spelling, line continuations removed.
    pub text: Cow<'a, str>,
    /// Where it was written: for a token of a macro, in the macro's definition.
    pub span: Span,
    /// Whether white space or a comment precedes it.
    pub space: bool,
    /// Whether it names a macro that was being expanded when it was read, and so is no use of it.
    pub(super) painted: bool,
}

/// The sorts of token that a preprocessor tells apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A name or keyword.
    Identifier,
    /// Something that begins like a number, well-formed or not.
    Number,
    /// An operator or a bracket.
    Punctuator,
    /// A character that GLSL does not know.
    Odd,
    /// The end of a line. Directives end there; the parser never sees it.
    LineEnd,
}

impl Token<'_> {
    /// Whether the token is this operator, bracket or word.
    pub fn is(&self, text: &str) -> bool {
        self.text == text
    }
}

/// Operators of more than one character, longest first.
const LONG: [&str; 21] = [
    "<<=", ">>=", "++", "--", "<=", ">=", "==", "!=", "&&", "||", "^^", "<<", ">>", "+=", "-=",
    "*=", "/=", "%=", "&=", "|=", "^=",
];

/// Turns one file into tokens, line ends included.
#[derive(Debug)]
pub(super) struct Lexer<'a> {
    text: &'a str,
    file: FileId,
    at: usize,
    /// Line ends passed so far.
    pub lines: u32,
    pub diagnostics: Vec<Diagnostic>,
}

impl<'a> Lexer<'a> {
    pub fn new(file: FileId, text: &'a str) -> Self {
        Lexer {
            text,
            file,
            at: if text.starts_with('\u{feff}') { 3 } else { 0 },
            lines: 0,
            diagnostics: Vec::new(),
        }
    }

    /// Where the reading is.
    pub fn place(&self) -> Span {
        self.span(self.at)
    }

    /// The length of a line end at `at`: CR, LF, CRLF and LFCR all end lines.
    fn line_end(&self, at: usize) -> usize {
        match self.text.as_bytes()[at..] {
            [b'\r', b'\n', ..] | [b'\n', b'\r', ..] => 2,
            [b'\r' | b'\n', ..] => 1,
            _ => 0,
        }
    }

    /// Moves over backslashes before line ends, which join lines everywhere, even within a name.
    fn skip_continuations(&mut self) {
        while self.text.as_bytes().get(self.at) == Some(&b'\\') {
            match self.line_end(self.at + 1) {
                0 => return,
                length => {
                    self.at += 1 + length;
                    self.lines += 1;
                }
            }
        }
    }

    fn peek(&mut self) -> Option<char> {
        self.skip_continuations();
        self.text[self.at..].chars().next()
    }

    fn bump(&mut self) -> Option<char> {
        let next = self.peek()?;
        self.at += next.len_utf8();
        Some(next)
    }

    fn take_while(&mut self, mut belongs: impl FnMut(char) -> bool) {
        while self.peek().is_some_and(&mut belongs) {
            self.bump();
        }
    }

    fn span(&self, start: usize) -> Span {
        Span {
            file: self.file,
            start: start as u32,
            end: self.at as u32,
        }
    }

    /// The next token; `None` at the end of the file, which is preceded by a line end.
    pub fn next(&mut self) -> Option<Token<'a>> {
        let space = self.skip_blanks();
        let start = self.at;
        let next = self.peek()?;
        // A continuation before the token is not part of it.
        let start = start.max(self.at);
        let kind = match next {
            '\n' | '\r' => {
                self.at += self.line_end(self.at);
                self.lines += 1;
                Kind::LineEnd
            }
            'a'..='z' | 'A'..='Z' | '_' => {
                self.take_while(|c| c.is_ascii_alphanumeric() || c == '_');
                Kind::Identifier
            }
            '0'..='9' => self.number(),
            '.' => {
                self.bump();
                match self.peek() {
                    Some('0'..='9') => self.number(),
                    _ => Kind::Punctuator,
                }
            }
            _ => self.symbol(),
        };
        let raw = &self.text[start..self.at];
        Some(Token {
            kind,
            text: match raw.contains('\\') && kind != Kind::Odd {
                true => Cow::Owned(raw.replace(['\\', '\r', '\n'], "")),
                false => Cow::Borrowed(raw),
            },
            span: self.span(start),
            space,
            painted: false,
        })
    }

    /// Everything that looks like one number: the parser judges it.
    fn number(&mut self) -> Kind {
        let mut last = '0';
        self.take_while(|c| {
            let belongs = c.is_ascii_alphanumeric()
                || matches!(c, '_' | '.')
                || (matches!(c, '+' | '-') && matches!(last, 'e' | 'E'));
            last = c;
            belongs
        });
        Kind::Number
    }

    fn symbol(&mut self) -> Kind {
        // Operators with a continuation inside are rare; the plain case is tried first.
        if let Some(long) = LONG
            .iter()
            .find(|long| self.text[self.at..].starts_with(**long))
        {
            self.at += long.len();
            return Kind::Punctuator;
        }
        let first = self.bump().expect("not at the end");
        let known = "+-*/%<>[](){}^|&~=!:;,?#";
        if !known.contains(first) {
            return Kind::Odd;
        }
        let mut so_far = first.to_string();
        while let Some(next) = self.peek() {
            so_far.push(next);
            if !LONG.iter().any(|long| long.starts_with(&so_far)) {
                break;
            }
            self.bump();
        }
        Kind::Punctuator
    }

    /// Moves over white space and comments, but not over line ends outside comments.
    fn skip_blanks(&mut self) -> bool {
        let begin = self.at;
        loop {
            match self.peek() {
                Some(' ' | '\t' | '\u{b}' | '\u{c}') => {
                    self.bump();
                }
                Some('/') => {
                    let (start, lines) = (self.at, self.lines);
                    self.bump();
                    match self.peek() {
                        Some('/') => self.take_while(|c| c != '\n' && c != '\r'),
                        Some('*') => self.block_comment(start),
                        _ => {
                            (self.at, self.lines) = (start, lines);
                            return start > begin;
                        }
                    }
                }
                _ => return self.at > begin,
            }
        }
    }

    fn block_comment(&mut self, start: usize) {
        self.bump();
        let opening = self.span(start);
        let mut last = ' ';
        loop {
            match self.bump() {
                Some('/') if last == '*' => return,
                Some(c) => {
                    if c == '\n' || (c == '\r' && self.peek() != Some('\n')) {
                        self.lines += 1;
                    }
                    last = c;
                }
                None => {
                    self.diagnostics.push(
                        Diagnostic::error("unclosed-comment", "this comment is never closed")
                            .at(opening)
                            .hint("add `*/` where it should end"),
                    );
                    return;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::SourceMap;

    fn spellings(text: &str) -> Vec<String> {
        let file = SourceMap::default().add("a", text);
        let mut lexer = Lexer::new(file, text);
        let mut spellings = Vec::new();
        while let Some(token) = lexer.next() {
            let space = if token.space { " " } else { "" };
            let text = if token.kind == Kind::LineEnd {
                "¶"
            } else {
                &token.text
            };
            spellings.push(format!("{space}{text}"));
        }
        spellings
    }

    #[test]
    fn tokens() {
        assert_eq!(spellings("a+=b<<1"), ["a", "+=", "b", "<<", "1"]);
        assert_eq!(
            spellings("1.5e-3f.x .5 a.b"),
            ["1.5e-3f.x", " .5", " a", ".", "b"]
        );
        assert_eq!(
            spellings("x\r\ny\rz\n\rw"),
            ["x", "¶", "y", "¶", "z", "¶", "w"]
        );
        assert_eq!(spellings("a/**/b // c\n d"), ["a", " b", " ¶", " d"]);
        assert_eq!(spellings("a/b"), ["a", "/", "b"]);
        assert_eq!(spellings("\u{feff}é@"), ["é", "@"]);
    }

    #[test]
    fn a_backslash_joins_lines_everywhere() {
        assert_eq!(spellings("ab\\\ncd +\\\r\n= e"), ["abcd", " +=", " e"]);
        assert_eq!(spellings("// a\\\nb\nc"), [" ¶", "c"]);
        assert_eq!(spellings("a\\ \nb"), ["a", "\\", " ¶", "b"]);
    }
}
