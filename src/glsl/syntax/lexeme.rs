//! What the parser sees of a preprocessing token: everything in this folder that knows what tokens
//! look like is here.

use std::sync::LazyLock;

use super::ast::TokenIndex;
use crate::glsl::names::{Name, Names};
use crate::glsl::preprocess::number::{self, Number};
use crate::glsl::preprocess::{Kind, Token};
use crate::glsl::types::Base;
use crate::glsl::words::{self, Item, Symbol, Word};
use crate::source::{Diagnostic, Span};

/// One token, as the grammar takes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Lexeme {
    /// A name of the program.
    Name(Name),
    /// The 32 bits of a whole number.
    Int(i32),
    /// A whole number with `u`.
    Uint(u32),
    /// A number with a point or an exponent.
    Float(f64),
    /// `true` or `false`.
    Bool(bool),
    /// A type that has a keyword.
    Type(Base),
    /// Any other keyword.
    Word(Word),
    /// An operator or a bracket.
    Symbol(Symbol),
    /// What the preprocessor has already refused.
    Refused,
    /// Behind the last token.
    End,
}

/// A text's tokens, read once.
#[derive(Debug)]
pub(super) struct Lexemes {
    /// One for each token, and [`Lexeme::End`].
    pub list: Vec<Lexeme>,
    /// Reserved words that are used as names, each with its first place.
    pub reserved: Vec<(Name, TokenIndex)>,
}

/// What each of the vocabulary is to the parser.
static VOCABULARY: LazyLock<Vec<Option<Lexeme>>> = LazyLock::new(|| {
    let lexeme = |item| match item {
        Item::Symbol(symbol) => Some(Lexeme::Symbol(symbol)),
        Item::Word(word) => Some(Lexeme::Word(word)),
        Item::Type(base) => Some(Lexeme::Type(base)),
        Item::Bool(value) => Some(Lexeme::Bool(value)),
        Item::Reserved => None,
    };
    words::vocabulary().map(|(_, item)| lexeme(item)).collect()
});

/// Reads the tokens.
pub(super) fn read(tokens: &[Token], names: &Names) -> Lexemes {
    let vocabulary = &**VOCABULARY;
    let mut list = Vec::with_capacity(tokens.len() + 1);
    let mut reserved: Vec<(Name, TokenIndex)> = Vec::new();
    let mut after_dot = false;
    for (index, token) in tokens.iter().enumerate() {
        let name = token.spelling;
        let lexeme = match (token.kind, vocabulary.get(name.index())) {
            (Kind::Number, _) => number(names.text(name)),
            (Kind::Odd | Kind::LineEnd, _) => Lexeme::Refused,
            // Behind a dot every word is just a name.
            (Kind::Identifier, _) if after_dot => Lexeme::Name(name),
            (_, Some(&Some(lexeme))) => lexeme,
            (_, Some(None)) => {
                if reserved.iter().all(|(earlier, _)| *earlier != name) {
                    reserved.push((name, index as TokenIndex));
                }
                Lexeme::Name(name)
            }
            (_, None) => Lexeme::Name(name),
        };
        after_dot = lexeme == Lexeme::Symbol(Symbol::Dot);
        list.push(lexeme);
    }
    list.push(Lexeme::End);
    Lexemes { list, reserved }
}

/// The value of a number. One that is not well-formed has been refused already and counts as zero, so
/// that it is not refused once more.
fn number(text: &str) -> Lexeme {
    match number::parse(text) {
        // The specification has a number's bits decide, not its sign.
        Ok(Number::Int(bits)) => Lexeme::Int(bits as i32),
        Ok(Number::Uint(bits)) => Lexeme::Uint(bits),
        Ok(Number::Float(value)) => Lexeme::Float(value),
        // The preprocessor has said what is wrong with it.
        Err(_) => Lexeme::Int(0),
    }
}

/// Points a diagnostic at a token.
pub(super) fn blame(token: &Token, diagnostic: Diagnostic) -> Diagnostic {
    token.blame(diagnostic)
}

/// Points a diagnostic at what should follow a token.
pub(super) fn blame_behind(token: &Token, diagnostic: Diagnostic) -> Diagnostic {
    diagnostic.at(Span {
        start: token.span.end,
        ..token.span
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lexemes_are_small() {
        assert!(size_of::<Lexeme>() <= 16);
    }

    #[test]
    fn values_of_numbers() {
        for (text, value) in [
            ("0", Lexeme::Int(0)),
            ("42", Lexeme::Int(42)),
            ("017", Lexeme::Int(15)),
            ("0x1f", Lexeme::Int(31)),
            ("0xFFFFFFFF", Lexeme::Int(-1)),
            ("4294967295", Lexeme::Int(-1)),
            ("2147483648", Lexeme::Int(i32::MIN)),
            ("0u", Lexeme::Uint(0)),
            ("0xeu", Lexeme::Uint(14)),
            ("4294967295U", Lexeme::Uint(u32::MAX)),
            ("1.", Lexeme::Float(1.0)),
            (".5f", Lexeme::Float(0.5)),
            ("1e3", Lexeme::Float(1000.0)),
            ("1.e-3F", Lexeme::Float(0.001)),
            ("08.5", Lexeme::Float(8.5)),
            ("0.1", Lexeme::Float(0.1)),
            ("1e9999", Lexeme::Float(f64::INFINITY)),
            // Refused by the preprocessor.
            ("1.2.3", Lexeme::Int(0)),
            ("0x", Lexeme::Int(0)),
        ] {
            assert_eq!(number(text), value, "{text}");
        }
    }
}
