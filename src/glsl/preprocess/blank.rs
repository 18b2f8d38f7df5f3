//! White space and comments.

use memchr::{memchr2, memchr3};

use super::findings::Findings;
use super::lexer::Lexer;
use crate::source::Diagnostic;

impl Lexer<'_> {
    /// Moves over white space and comments, but not over line ends outside comments. Whether there
    /// was any.
    #[inline(always)]
    pub(super) fn skip_blanks(&mut self, findings: &mut Findings) -> bool {
        let begin = self.at;
        while matches!(self.byte(self.at), Some(b' ' | b'\t' | 0x0b | 0x0c)) {
            self.at += 1;
        }
        let space = self.at > begin;
        match self.byte(self.at) {
            Some(b'/' | b'\\') => self.skip_comments(space, findings),
            _ => space,
        }
    }

    /// The same where it may be a comment, or lines that are joined; `space` is the answer so far.
    #[inline(never)]
    fn skip_comments(&mut self, mut space: bool, findings: &mut Findings) -> bool {
        loop {
            match self.peek() {
                b' ' | b'\t' | 0x0b | 0x0c => {
                    self.at += 1;
                    space = true;
                }
                b'/' => {
                    let (start, lines) = (self.at, self.lines);
                    self.at += 1;
                    match self.peek() {
                        // The line ends behind it, so that it is no white space for anyone.
                        b'/' => self.line_comment(),
                        b'*' => {
                            self.block_comment(start, findings);
                            space = true;
                        }
                        _ => {
                            (self.at, self.lines) = (start, lines);
                            return space;
                        }
                    }
                }
                _ => return space,
            }
        }
    }

    fn line_comment(&mut self) {
        self.at += 1;
        let bytes = self.text.as_bytes();
        while let Some(length) = memchr2(b'\n', b'\r', &bytes[self.at..]) {
            self.at += length;
            if length == 0 || bytes[self.at - 1] != b'\\' {
                return;
            }
            self.at += self.line_end(self.at);
            self.lines += 1;
        }
        self.at = bytes.len();
    }

    fn block_comment(&mut self, start: usize, findings: &mut Findings) {
        self.at += 1;
        let opening = self.span(start, self.at);
        let bytes = self.text.as_bytes();
        while let Some(length) = memchr3(b'*', b'\n', b'\r', &bytes[self.at..]) {
            self.at += length + 1;
            match bytes[self.at - 1] {
                b'*' if self.peek() == b'/' => {
                    self.at += 1;
                    return;
                }
                b'\n' => self.lines += 1,
                b'\r' if self.byte(self.at) != Some(b'\n') => self.lines += 1,
                _ => {}
            }
        }
        self.at = bytes.len();
        findings.push(
            Diagnostic::error("unclosed-comment", "this comment is never closed")
                .at(opening)
                .hint("add `*/` where it should end"),
        );
    }
}
