//! A first look at the author's text, ahead of any parser: which words it uses, and whether a
//! recursive parser can be trusted with it.

use std::collections::HashSet;

use crate::source::{Diagnostic, FileId, Span};

/// Brackets deeper than this are refused: parsers recurse on them.
const MAX_NESTING: usize = 250;

/// Tokens in one statement, commas apart; each may cost a parser one level of recursion.
const MAX_STATEMENT: usize = 20_000;

/// `else`s within one function; a ladder of them nests.
const MAX_ELSES: usize = 2_000;

/// What a text looks like from outside.
pub(super) struct Scan<'a> {
    /// Every identifier, outside comments, whether or not the preprocessor would keep it.
    pub words: HashSet<&'a str>,
    /// What no parser should be asked to read.
    pub problems: Vec<Diagnostic>,
}

/// Scans one file.
pub(super) fn scan(file: FileId, text: &str) -> Scan<'_> {
    let mut scan = Scan {
        words: HashSet::new(),
        problems: Vec::new(),
    };
    let mut limits = Limits::default();
    let mut at = 0;
    while at < text.len() {
        let (token, length) = next(&text[at..]);
        let place = Span {
            file,
            start: at as u32,
            end: (at + length.min(40)) as u32,
        };
        match token {
            Token::Blank => {}
            Token::OpenComment => scan.problems.push(
                Diagnostic::error("unclosed-comment", "this comment is never closed")
                    .at(Span {
                        end: place.start + 2,
                        ..place
                    })
                    .hint("add `*/` where it should end"),
            ),
            Token::Word => {
                scan.words.insert(&text[at..at + length]);
                limits.count(&text[at..at + length], place);
            }
            Token::Other => limits.count(&text[at..at + length], place),
        }
        at += length;
    }
    scan.problems.extend(limits.exceeded);
    scan
}

/// Where the first character stands, outside comments, that GLSL ES 3.00 (§3.1) does not know.
pub(super) fn odd_character(text: &str) -> Option<usize> {
    let mut at = 0;
    while at < text.len() {
        let (token, length) = next(&text[at..]);
        if let Token::Other = token
            && text[at..].starts_with(|c: char| !c.is_ascii() || "@$`'\"".contains(c))
        {
            return Some(at);
        }
        at += length;
    }
    None
}

enum Token {
    Blank,
    Word,
    Other,
    OpenComment,
}

/// The token that `rest` begins with, and its length in bytes. `rest` is not empty.
fn next(rest: &str) -> (Token, usize) {
    let first = rest.chars().next().expect("not at the end");
    if rest.starts_with("//") {
        // A backslash before the line end continues the comment, as it continues any line.
        let mut end = 0;
        loop {
            end += rest[end..].find('\n').unwrap_or(rest.len() - end);
            let line = rest[..end].trim_end_matches('\r');
            if end == rest.len() || !line.ends_with('\\') {
                return (Token::Blank, end);
            }
            end += 1;
        }
    }
    if let Some(body) = rest.strip_prefix("/*") {
        return match body.find("*/") {
            Some(end) => (Token::Blank, end + 4),
            None => (Token::OpenComment, rest.len()),
        };
    }
    if first.is_whitespace() {
        return (Token::Blank, first.len_utf8());
    }
    let in_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if in_word(first) {
        let length = rest.find(|c| !in_word(c)).unwrap_or(rest.len());
        return match first.is_ascii_digit() {
            true => (Token::Other, length),
            false => (Token::Word, length),
        };
    }
    (Token::Other, first.len_utf8())
}

#[derive(Default)]
struct Limits {
    nesting: usize,
    braces: usize,
    statement: usize,
    elses: usize,
    exceeded: Option<Diagnostic>,
}

impl Limits {
    fn count(&mut self, token: &str, place: Span) {
        self.statement += 1;
        match token {
            "(" | "[" => self.nesting += 1,
            ")" | "]" => self.nesting = self.nesting.saturating_sub(1),
            "{" => {
                self.nesting += 1;
                self.braces += 1;
                self.statement = 0;
            }
            "}" => {
                self.nesting = self.nesting.saturating_sub(1);
                self.braces = self.braces.saturating_sub(1);
                self.statement = 0;
                if self.braces == 0 {
                    self.elses = 0;
                }
            }
            "," => self.statement = 0,
            // The semicolons of a `for` header lie deeper than the braces around it.
            ";" if self.nesting == self.braces => self.statement = 0,
            "else" => self.elses += 1,
            _ => {}
        }
        let what = if self.nesting > MAX_NESTING {
            format!("brackets are nested more than {MAX_NESTING} deep")
        } else if self.statement > MAX_STATEMENT {
            format!("one statement has more than {MAX_STATEMENT} tokens")
        } else if self.elses > MAX_ELSES {
            format!("one function has more than {MAX_ELSES} `else`s")
        } else {
            return;
        };
        self.exceeded.get_or_insert_with(|| {
            Diagnostic::error("too-deep", what)
                .at(place)
                .hint("move part of it into a function, or into a loop")
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::SourceMap;

    fn words(text: &str) -> Vec<&str> {
        let file = SourceMap::default().add("a", text);
        let mut words: Vec<_> = scan(file, text).words.into_iter().collect();
        words.sort_unstable();
        words
    }

    fn problem(text: &str) -> Option<&'static str> {
        let file = SourceMap::default().add("a", text);
        scan(file, text)
            .problems
            .first()
            .map(|problem| problem.code)
    }

    #[test]
    fn words_outside_comments_only() {
        assert_eq!(
            words("a+b2 // c\n/* d\n*/ _e 3f 0x1u .5f"),
            ["_e", "a", "b2"]
        );
        assert_eq!(words("// a \\\n b\nc // d \\\r\n e"), ["c"]);
        assert_eq!(words("ä/**/x"), ["x"]);
    }

    #[test]
    fn what_no_parser_should_see() {
        assert_eq!(problem("float a; /* b"), Some("unclosed-comment"));
        assert_eq!(problem(&"(".repeat(251)), Some("too-deep"));
        assert_eq!(problem(&"-".repeat(30_000)), Some("too-deep"));
        assert_eq!(problem(&"for(;;)".repeat(9_000)), Some("too-deep"));
        let ladder = format!("void f() {{ {} }}", "else if (a) {}".repeat(2_001));
        assert_eq!(problem(&ladder), Some("too-deep"));
    }

    #[test]
    fn large_tables_and_many_functions_are_fine() {
        assert_eq!(problem(&"1.0 + 2.0,".repeat(50_000)), None);
        let function = "void f() { if (a) b(); else c(); }\n";
        assert_eq!(problem(&function.repeat(3_000)), None);
    }
}
