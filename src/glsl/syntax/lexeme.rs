//! What the parser sees of a preprocessing token: everything in this folder that knows what tokens
//! look like is here.

use super::ast::TokenIndex;
use super::words::{KNOWN, Known, Word, spelled};
use crate::glsl::names::{Name, Names, hash};
use crate::glsl::preprocess::number::{self, Number};
use crate::glsl::preprocess::{Kind, Token};
use crate::glsl::types::Base;
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

spelled! {
    /// An operator or a bracket.
    Symbol {
        LeftParenthesis = "(",
        RightParenthesis = ")",
        LeftBracket = "[",
        RightBracket = "]",
        LeftBrace = "{",
        RightBrace = "}",
        Dot = ".",
        Comma = ",",
        Colon = ":",
        Semicolon = ";",
        Question = "?",
        Assign = "=",
        Not = "!",
        Complement = "~",
        Plus = "+",
        Minus = "-",
        Star = "*",
        Slash = "/",
        Percent = "%",
        Less = "<",
        Greater = ">",
        Or = "|",
        Xor = "^",
        And = "&",
        Increment = "++",
        Decrement = "--",
        LessEqual = "<=",
        GreaterEqual = ">=",
        Equal = "==",
        NotEqual = "!=",
        AndAnd = "&&",
        OrOr = "||",
        XorXor = "^^",
        ShiftLeft = "<<",
        ShiftRight = ">>",
        PlusAssign = "+=",
        MinusAssign = "-=",
        StarAssign = "*=",
        SlashAssign = "/=",
        PercentAssign = "%=",
        AndAssign = "&=",
        OrAssign = "|=",
        XorAssign = "^=",
        ShiftLeftAssign = "<<=",
        ShiftRightAssign = ">>=",
    }
}

impl Symbol {
    /// Whether it may follow a variable's name at the beginning of a statement.
    pub fn follows_place(self) -> bool {
        use Symbol::*;
        matches!(
            self,
            LeftParenthesis
                | Dot
                | Increment
                | Decrement
                | Assign
                | PlusAssign
                | MinusAssign
                | StarAssign
                | SlashAssign
                | PercentAssign
                | AndAssign
                | OrAssign
                | XorAssign
                | ShiftLeftAssign
                | ShiftRightAssign
        )
    }
}

/// A text's tokens, read once.
#[derive(Debug)]
pub(super) struct Lexemes {
    /// One for each token, and [`Lexeme::End`].
    pub list: Vec<Lexeme>,
    /// Reserved words that are used as names, each with its first place.
    pub reserved: Vec<(Name, TokenIndex)>,
}

/// Reads the tokens.
pub(super) fn read(tokens: &[Token<'_>], names: &mut Names) -> Lexemes {
    let known = &*KNOWN;
    let mut list = Vec::with_capacity(tokens.len() + 1);
    let mut reserved: Vec<(Name, TokenIndex)> = Vec::new();
    let mut after_dot = false;
    for (index, token) in tokens.iter().enumerate() {
        let text: &str = &token.text;
        let lexeme = match token.kind {
            // Behind a dot every word is just a name.
            Kind::Identifier if after_dot => Lexeme::Name(names.intern(text)),
            Kind::Identifier => {
                let hashed = hash(text);
                match known.get(hashed, text) {
                    None => Lexeme::Name(names.intern_hashed(hashed, text)),
                    Some(Known::Lexeme(lexeme)) => lexeme,
                    Some(Known::Reserved) => {
                        let name = names.intern_hashed(hashed, text);
                        if reserved.iter().all(|(earlier, _)| *earlier != name) {
                            reserved.push((name, index as TokenIndex));
                        }
                        Lexeme::Name(name)
                    }
                }
            }
            Kind::Number => number(text),
            Kind::Punctuator => punctuator(text),
            Kind::Odd | Kind::LineEnd => Lexeme::Refused,
        };
        after_dot = lexeme == Lexeme::Symbol(Symbol::Dot);
        list.push(lexeme);
    }
    list.push(Lexeme::End);
    Lexemes { list, reserved }
}

/// An operator or a bracket. Most are a single byte, which is faster than to look them up.
fn punctuator(text: &str) -> Lexeme {
    use Symbol as S;
    Lexeme::Symbol(match text.as_bytes() {
        b"(" => S::LeftParenthesis,
        b")" => S::RightParenthesis,
        b"," => S::Comma,
        b"." => S::Dot,
        b";" => S::Semicolon,
        b"*" => S::Star,
        b"=" => S::Assign,
        b"+" => S::Plus,
        b"-" => S::Minus,
        b"/" => S::Slash,
        b"{" => S::LeftBrace,
        b"}" => S::RightBrace,
        b"[" => S::LeftBracket,
        b"]" => S::RightBracket,
        _ => match KNOWN.get(hash(text), text) {
            Some(Known::Lexeme(symbol)) => return symbol,
            _ => return Lexeme::Refused,
        },
    })
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
pub(super) fn blame(token: &Token<'_>, diagnostic: Diagnostic) -> Diagnostic {
    token.blame(diagnostic)
}

/// Points a diagnostic at what should follow a token.
pub(super) fn blame_behind(token: &Token<'_>, diagnostic: Diagnostic) -> Diagnostic {
    diagnostic.at(Span {
        start: token.span.end,
        ..token.span
    })
}

/// A token's spelling, as messages quote it.
pub(super) fn quoted(token: &Token<'_>) -> String {
    const MOST: usize = 40;
    match token.text.char_indices().nth(MOST) {
        Some((end, _)) => format!("`{}…`", &token.text[..end]),
        None => format!("`{}`", token.text),
    }
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
