//! Where a text has directives for its host.

/// A directive, as it stands in the text.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Found<'a> {
    /// The word behind the `#`.
    pub name: &'a str,
    /// Where the `#` stands.
    pub start: usize,
    /// What follows the word, to the end of the line.
    pub rest: &'a str,
}

impl Found<'_> {
    /// Where the rest begins.
    pub fn rest_start(&self) -> usize {
        self.start + 1 + self.name.len()
    }

    /// Where the line ends.
    pub fn end(&self) -> usize {
        self.rest_start() + self.rest.len()
    }
}

/// Every directive for the host outside comments, in order. A directive stands first in its line, as with GLSL's own.
pub(super) fn scan(text: &str) -> Vec<Found<'_>> {
    let bytes = text.as_bytes();
    let at = |index: usize| bytes.get(index).copied().unwrap_or(0);
    let mut found = Vec::new();
    let mut index = match text.starts_with('\u{feff}') {
        true => '\u{feff}'.len_utf8(),
        false => 0,
    };
    let mut is_line_start = true;
    while index < bytes.len() {
        match bytes[index] {
            b'#' if is_line_start => {
                let line = line_at(text, index);
                match directive(line, index) {
                    Some(directive) => {
                        index = directive.end();
                        found.push(directive);
                    }
                    None => {
                        is_line_start = false;
                        index += 1;
                    }
                }
            }
            b'/' if at(index + 1) == b'/' => index = comment_end(bytes, index),
            b'/' if at(index + 1) == b'*' => {
                let end = text[index + 2..].find("*/");
                index = end.map_or(bytes.len(), |end| index + 2 + end + 2);
            }
            b'\\' if matches!(at(index + 1), b'\n' | b'\r') => {
                index += continuation(bytes, index);
            }
            byte => {
                match byte {
                    b'\n' | b'\r' => is_line_start = true,
                    b' ' | b'\t' | 0x0b | 0x0c => {}
                    _ => is_line_start = false,
                }
                index += 1;
            }
        }
    }
    found
}

fn line_at(text: &str, start: usize) -> &str {
    let rest = &text[start..];
    &rest[..rest.find(['\n', '\r']).unwrap_or(rest.len())]
}

/// The length of a backslash and the line end behind it.
fn continuation(bytes: &[u8], at: usize) -> usize {
    match bytes.get(at + 1..at + 3) {
        Some(b"\r\n") => 3,
        _ => 2,
    }
}

/// The line end behind a comment of one line; a backslash ahead of it makes the next line part of the comment.
fn comment_end(bytes: &[u8], start: usize) -> usize {
    let mut index = start;
    while index < bytes.len() && !matches!(bytes[index], b'\n' | b'\r') {
        let joins = bytes[index] == b'\\' && matches!(bytes.get(index + 1), Some(b'\n' | b'\r'));
        index += match joins {
            true => continuation(bytes, index),
            false => 1,
        };
    }
    index.min(bytes.len())
}

/// The directive that a line begins with, if it is one for the host.
fn directive(line: &str, start: usize) -> Option<Found<'_>> {
    let word = line.strip_prefix('#')?;
    let length = word
        .find(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .unwrap_or(word.len());
    let (name, rest) = word.split_at(length);
    let is_host = match name {
        // What stands in angle brackets is no file of the author's, and GLSL has no such directive.
        "include" => rest.trim_start().starts_with(['"', '\'']),
        "iUniform" | "iKeyboard" | "iVertex" | "iFirstPersonControls" | "StrictCompatibility" => {
            true
        }
        _ => name.starts_with("iChannel"),
    };
    is_host.then_some(Found { name, start, rest })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &str) -> Vec<(&str, &str)> {
        let found = scan(text).into_iter();
        found.map(|one| (one.name, one.rest)).collect()
    }

    #[test]
    fn directives_stand_first_in_a_line() {
        assert_eq!(
            names("\u{feff}#iKeyboard\r\n  #iChannel0 \"a\" // b\n/* c */ #include 'd'"),
            [
                ("iKeyboard", ""),
                ("iChannel0", " \"a\" // b"),
                ("include", " 'd'")
            ]
        );
        assert_eq!(
            names("float x; #iKeyboard\n# iKeyboard\n#define a\n#include <b>"),
            []
        );
    }

    #[test]
    fn comments_hold_none() {
        assert_eq!(
            names("// a \\\n#iKeyboard\n/*\n#iKeyboard\n*/\n#iChannel1::Type 'x'").len(),
            1
        );
        assert_eq!(names("/* open\n#iKeyboard"), []);
        assert_eq!(names("// a \\\r\n#iKeyboard\n"), []);
        assert_eq!(names("float a = b \\\n#iKeyboard\n"), []);
    }

    #[test]
    fn places_are_those_of_the_text() {
        let text = "\u{e4};\n  #iUniform float x\r\n";
        let [found] = &scan(text)[..] else {
            panic!("one directive");
        };
        assert_eq!(&text[found.start..found.end()], "#iUniform float x");
        assert_eq!(&text[found.rest_start()..found.end()], " float x");
    }
}
