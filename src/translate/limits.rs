//! What no recursive parser should be asked to read.

use crate::glsl::preprocess::Token;
use crate::source::{Diagnostic, Span};

/// Brackets deeper than this are refused: parsers recurse on them.
const MAX_NESTING: usize = 250;

/// Tokens in one statement, commas apart; each may cost a parser one level of recursion.
const MAX_STATEMENT: usize = 20_000;

/// `else`s within one function; a ladder of them nests.
const MAX_ELSES: usize = 2_000;

/// Refuses a text that is nested beyond all reason, macros expanded.
pub(super) fn require_shallow(tokens: &[Token<'_>]) -> Result<(), Diagnostic> {
    let mut limits = Limits::default();
    tokens
        .iter()
        .try_for_each(|token| limits.count(&token.text, token.span))
}

#[derive(Default)]
struct Limits {
    nesting: usize,
    braces: usize,
    statement: usize,
    elses: usize,
}

impl Limits {
    fn count(&mut self, token: &str, place: Span) -> Result<(), Diagnostic> {
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
            return Ok(());
        };
        Err(Diagnostic::error("too-deep", what)
            .at(place)
            .hint("move part of it into a function, or into a loop"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glsl::preprocess::preprocess;
    use crate::source::SourceMap;

    fn is_shallow(text: &str) -> bool {
        let mut files = SourceMap::default();
        let file = files.add("a", text);
        require_shallow(&preprocess(&files, &[file], &[]).tokens).is_ok()
    }

    #[test]
    fn what_no_parser_should_see() {
        assert!(!is_shallow(&"(".repeat(251)));
        assert!(!is_shallow(&"- ".repeat(30_000)));
        assert!(!is_shallow(&"for(;;)".repeat(9_000)));
        let ladder = format!("void f() {{ {} }}", "else if (a) {}".repeat(2_001));
        assert!(!is_shallow(&ladder));
        let by_macros = "#define A ((((((((((((((((\n#define B A A A A A A A A\nB B B";
        assert!(!is_shallow(by_macros));
    }

    #[test]
    fn large_tables_and_many_functions_are_fine() {
        assert!(is_shallow(&"1.0 + 2.0,".repeat(50_000)));
        assert!(is_shallow(
            &"void f() { if (a) b(); else c(); }\n".repeat(3_000)
        ));
    }
}
