//! From text to tokens: comments, line continuation, directives, macros (GLSL ES 3.00, §3.3 to §3.5).
//!
//! Where the specification leaves room, ANGLE decides, because WebGL2 is what authors know. Every
//! token remembers where it was written. Work and memory are bounded whatever the text: macros that
//! expand without end are an error.

mod condition;
mod directive;
mod expand;
mod lexer;
mod number;

pub use lexer::{Kind, Token};

use crate::source::{Diagnostic, FileId, SourceMap};
use directive::Directives;
use expand::Expansion;

/// The most tokens that macros may bring, those within them counted each time they are expanded. The
/// largest of some 141,000 published shaders has fewer than a million tokens in all.
const MAX_EXPANDED: usize = 4 << 20;

/// What the preprocessor makes of a text.
#[derive(Debug)]
pub struct Preprocessed<'a> {
    /// The tokens that are left for the parser.
    pub tokens: Vec<Token<'a>>,
    /// What is wrong, in the order of the text. Tokens are not to be relied on if any is an error.
    pub diagnostics: Vec<Diagnostic>,
}

/// Preprocesses files as if they were one text that begins with a `#define` for each of `defines`, a
/// name and a number.
pub fn preprocess<'a>(
    files: &'a SourceMap,
    units: &[FileId],
    defines: &[(&'a str, &'a str)],
) -> Preprocessed<'a> {
    let mut source = Directives::new(files, units, defines);
    let mut expansion = Expansion::of_text();
    let tokens: Vec<_> = std::iter::from_fn(|| expansion.next(&mut source)).collect();
    let mut diagnostics = source.into_diagnostics();
    let is_odd = |token: &&Token<'_>| token.kind == Kind::Odd || token.is("#");
    diagnostics.extend(tokens.iter().find(is_odd).map(odd_character));
    let is_bad_number =
        |token: &&Token<'_>| token.kind == Kind::Number && !number::is_well_formed(&token.text);
    diagnostics.extend(tokens.iter().filter(is_bad_number).map(bad_number));
    Preprocessed {
        tokens,
        diagnostics,
    }
}

fn bad_number(token: &Token<'_>) -> Diagnostic {
    Diagnostic::error(
        "invalid-number",
        format!("`{}` is not a number", token.text),
    )
    .at(token.span)
    .hint("write it as `1`, `1u`, `0x1F` or `1.0`, whole numbers with no more than 32 bits")
}

fn odd_character(token: &Token<'_>) -> Diagnostic {
    let character = token.text.chars().next().unwrap_or(' ');
    let message = format!(
        "the character `{}` means nothing here",
        character.escape_debug()
    );
    let diagnostic = Diagnostic::error("preprocessor", message).at(token.span);
    match character {
        '#' => diagnostic.hint("a directive stands on a line of its own; GLSL cannot paste tokens"),
        _ if character.is_ascii() => diagnostic,
        _ => diagnostic.hint("typographic quotes and dashes come from word processors"),
    }
}

#[cfg(test)]
mod tests;
