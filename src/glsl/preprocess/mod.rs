//! From text to tokens: comments, line continuation, directives, macros (GLSL ES 3.00, §3.3 to §3.5).
//!
//! Where the specification leaves room, ANGLE decides, because WebGL2 is what authors know. Every
//! token remembers where it was written. Work and memory are bounded whatever the text: macros that
//! expand without end are an error.

mod blank;
mod call;
mod condition;
mod define;
mod directive;
mod expand;
mod findings;
mod lexer;
mod macros;
pub mod number;
mod request;
mod token;

pub use token::{Kind, Token};

use rustc_hash::FxHashSet;

use crate::glsl::names::{Name, Names};
use crate::source::{Diagnostic, FileId, SourceMap, Span};
use directive::Directives;
use expand::Expansion;
use number::NumberError;

/// The longest name or number that a browser takes.
const MAX_SPELLING: usize = 1024;

/// Texts in texts, where each stands in the place of a directive.
const MAX_SPLICES: usize = 32;

/// Macro calls in arguments of macro calls, as deep as a browser goes.
const MAX_DEPTH: usize = 1000;

/// The most tokens in the arguments of a macro call, or in what comes of it, for a browser.
const MAX_CALL: usize = 10_000;

/// The most tokens that macros may bring, those counted that are in memory on the way: 50 MB of
/// them. The largest of some 141,000 published shaders has fewer than a million tokens in all.
const MAX_BROUGHT: usize = 1_800_000;

/// The most tokens that may be read again on the way there: some tenths of a second.
const MAX_READ: usize = 8 << 20;

/// How to preprocess a text, apart from what it says itself.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// Macros of the host, name and value, as if defined before the text begins.
    pub defines: &'a [(&'a str, &'a str)],
    /// Macros of the user, name and value. The text can neither undefine nor redefine them: what it
    /// says about these names is overlooked. Their tokens come from the first definition that they
    /// override, or from the beginning of the text where it has none.
    pub overrides: &'a [(String, String)],
    /// Directives that the host has obeyed already, in the order of files and places: each counts as a blank line, or
    /// as the text that stands there instead. Such a text may hold more of them.
    pub splices: &'a [(Span, Option<FileId>)],
    /// Whether all that a browser refuses is an error. Else what is clear all the same is a warning:
    /// `#extension`, `#version 300 es`, a byte-order mark, names, numbers and macro calls that are
    /// too long.
    pub strict: bool,
}

/// What the preprocessor makes of a text.
#[derive(Debug)]
pub struct Preprocessed<'a> {
    /// The tokens that are left for the parser.
    pub tokens: Vec<Token>,
    /// How they are spelled.
    pub names: Names,
    /// What is wrong, in the order of the text. Tokens are not to be relied on if any is an error.
    pub diagnostics: Vec<Diagnostic>,
    /// The first character outside ASCII that is left for the parser, as a warning. It reads as `?`,
    /// so that it is most likely to blame if the parser finds something wrong.
    pub odd_character: Option<Diagnostic>,
    /// The names of [`Options::overrides`] that the text never mentions.
    pub unused_overrides: Vec<&'a str>,
}

/// Preprocesses files as if they were one text. Texts that are put together later share `names`.
pub fn preprocess<'a>(
    files: &'a SourceMap,
    units: &[FileId],
    options: &Options<'a>,
    names: Names,
) -> Preprocessed<'a> {
    let mut source = Directives::new(files, units, options, names);
    let mut expansion = Expansion::of_text();
    // Texts of several programs have a token in every four bytes or so.
    let bytes: usize = units.iter().map(|&unit| files.get(unit).text.len()).sum();
    let mut tokens = Vec::with_capacity(bytes / 4);
    let mut odd_character = None;
    // Most numbers are written more than once.
    let mut good_numbers = FxHashSet::<Name>::default();
    while let Some(kind) = expansion.next_into(&mut tokens, &mut source) {
        let Some(token) = tokens.last() else { break };
        let problem = match kind {
            Kind::Number if good_numbers.contains(&token.spelling) => None,
            Kind::Number => {
                let problem = bad_number(token, &source.names);
                if problem.is_none() {
                    good_numbers.insert(token.spelling);
                }
                problem
            }
            Kind::Odd => Some(meaningless(token, &source.names)),
            _ => {
                if odd_character.is_none() {
                    odd_character = stand_in(&source, token);
                }
                None
            }
        };
        if let Some(problem) = problem {
            source.report(problem);
            tokens.pop();
        }
    }
    Preprocessed {
        tokens,
        odd_character,
        unused_overrides: define::unused_overrides(&source),
        diagnostics: source.findings.into_list(),
        names: source.names,
    }
}

fn bad_number(token: &Token, names: &Names) -> Option<Diagnostic> {
    let what = match number::parse(names.text(token.spelling)).err()? {
        NumberError::Malformed => "is not a number",
        NumberError::Overflow => "is too large for an integer",
    };
    let message = format!("`{}` {what}", names.quoted(token.spelling));
    let problem = token.blame(Diagnostic::error("invalid-number", message));
    let hint = "write it as `1`, `1u`, `0x1F` or `1.0`, whole numbers with no more than 32 bits";
    Some(problem.hint(hint))
}

fn meaningless(token: &Token, names: &Names) -> Diagnostic {
    let character = names.text(token.spelling).chars().next().unwrap_or(' ');
    let shown = visible(character);
    let message = format!("the character `{shown}` means nothing here");
    let problem = token.blame(Diagnostic::error("preprocessor", message));
    match character {
        '#' => problem.hint("a directive stands on a line of its own; GLSL cannot paste tokens"),
        '\\' => problem.hint("a backslash joins lines only at the very end of one"),
        _ => problem,
    }
}

/// The character, or a code for it where nothing could be seen.
fn visible(character: char) -> String {
    match character {
        '\'' | '"' | '\\' => character.to_string(),
        _ => character.escape_debug().to_string(),
    }
}

/// What to say of a `?` that is another character in truth.
fn stand_in(source: &Directives<'_>, token: &Token) -> Option<Diagnostic> {
    let place: Span = token.origin().unwrap_or(token.span);
    let written = source.written(place);
    let character = written
        .chars()
        .next()
        .filter(|character| !character.is_ascii())?;
    let shown = visible(character);
    let message = format!("the character `{shown}` means nothing here: WebGL2 reads it as `?`");
    let problem = token.blame(Diagnostic::warning("preprocessor", message));
    Some(problem.hint("typographic quotes and dashes come from word processors"))
}

#[cfg(test)]
mod tests;
