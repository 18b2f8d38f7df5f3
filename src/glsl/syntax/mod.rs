//! From tokens to a syntax tree: a recursive descent that looks no further ahead than a declaration
//! is long, and goes on behind what is wrong.

pub mod ast;

mod complaint;
mod declaration;
mod expression;
mod lexeme;
mod parser;
mod recovery;
mod specifier;
mod statement;

use crate::glsl::names::Names;
use crate::glsl::preprocess::Token;
use crate::source::Diagnostic;
use ast::Ast;
use parser::Parser;

/// What the parser makes of a text.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The tree. Parts of it are missing if any diagnostic is an error.
    pub ast: Ast,
    /// What is wrong, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

/// Parses a text. `strict` refuses reserved words as names, as a browser does; otherwise there is
/// just a warning.
///
/// Time and memory are proportional to the number of tokens, and a stack of 16 MiB (64 MiB in an
/// unoptimised build) is enough for whatever they are. No tree is deeper than
/// [`MAX_EXPRESSION_HEIGHT`] and [`MAX_STATEMENT_HEIGHT`].
pub fn parse(tokens: &[Token], names: Names, strict: bool) -> Parsed {
    let mut parser = Parser::new(tokens, names);
    parser.translation_unit();
    parser.finish(strict)
}

pub use parser::{MAX_EXPRESSION_HEIGHT, MAX_STATEMENT_HEIGHT};

#[cfg(test)]
mod show;
#[cfg(test)]
mod tests;
