//! The expressions of `#if` and `#elif`.

use super::directive::{Directives, number};
use super::expand::Expansion;
use super::lexer::{Kind, Token};
use crate::source::{Diagnostic, Span};

/// Brackets and unary operators within each other; each is a level of recursion here.
const MAX_DEPTH: usize = 200;

/// Whether the condition behind `directive` holds. What is wrong with it is reported, and does not
/// hold.
pub(super) fn holds<'a>(
    source: &mut Directives<'a>,
    directive: &Token<'a>,
    line: Vec<Token<'a>>,
) -> bool {
    match resolve_defined(source, directive, line).and_then(|line| value(source, directive, line)) {
        Ok(value) => value != 0,
        Err(problem) => {
            source.report(problem);
            false
        }
    }
}

/// The value of a constant expression, macros expanded.
pub(super) fn value<'a>(
    source: &mut Directives<'a>,
    directive: &Token<'a>,
    line: Vec<Token<'a>>,
) -> Result<i32, Diagnostic> {
    let line = Expansion::of_list(line, source);
    let mut parser = Parser {
        tokens: &line,
        at: 0,
        end: directive.span,
        depth: 0,
    };
    let value = parser.binary(0, true)?;
    match parser.peek() {
        Some(extra) => {
            let message = format!("`{}` does not belong here", extra.text);
            Err(wrong(extra.span, message))
        }
        None => Ok(value),
    }
}

fn wrong(at: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error("preprocessor", message).at(at)
}

/// Replaces `defined X` and `defined(X)` by 1 or 0, before macros are expanded.
fn resolve_defined<'a>(
    source: &Directives<'a>,
    directive: &Token<'a>,
    line: Vec<Token<'a>>,
) -> Result<Vec<Token<'a>>, Diagnostic> {
    let mut resolved = Vec::new();
    let mut tokens = line.into_iter();
    while let Some(token) = tokens.next() {
        if !token.is("defined") {
            resolved.push(token);
            continue;
        }
        let missing = || wrong(directive.span, "`defined` wants a name");
        let mut name = tokens.next().ok_or_else(missing)?;
        let in_brackets = name.is("(");
        if in_brackets {
            name = tokens.next().ok_or_else(missing)?;
        }
        if name.kind != Kind::Identifier {
            return Err(wrong(name.span, "`defined` wants a name"));
        }
        if in_brackets && !tokens.next().is_some_and(|close| close.is(")")) {
            return Err(wrong(name.span, "a `)` is missing behind this"));
        }
        let value = if source.is_defined(&name.text) {
            "1"
        } else {
            "0"
        };
        resolved.push(number(value, name.span));
    }
    Ok(resolved)
}

/// Binary operators, loosest first.
const LEVELS: [&[&str]; 10] = [
    &["||"],
    &["&&"],
    &["|"],
    &["^"],
    &["&"],
    &["==", "!="],
    &["<", ">", "<=", ">="],
    &["<<", ">>"],
    &["+", "-"],
    &["*", "/", "%"],
];

struct Parser<'t, 'a> {
    tokens: &'t [Token<'a>],
    at: usize,
    /// The place of what is missing at the end.
    end: Span,
    depth: usize,
}

impl<'t, 'a> Parser<'t, 'a> {
    fn peek(&self) -> Option<&'t Token<'a>> {
        self.tokens.get(self.at)
    }

    /// An expression of operators from `level` on. Where it is not `live`, because `&&` or `||` has
    /// decided already, names need no value and zero may divide.
    fn binary(&mut self, level: usize, live: bool) -> Result<i32, Diagnostic> {
        let Some(operators) = LEVELS.get(level) else {
            return self.unary(live);
        };
        let mut left = self.binary(level + 1, live)?;
        while let Some(token) = self.peek()
            && operators.contains(&&*token.text)
        {
            self.at += 1;
            let decided = match &*token.text {
                "&&" => left == 0,
                "||" => left != 0,
                _ => false,
            };
            let live = live && !decided;
            let right = self.binary(level + 1, live)?;
            left = match apply(&token.text, left, right) {
                Some(value) => value,
                None if !live => 0,
                None => return Err(wrong(token.span, "division by zero")),
            };
        }
        Ok(left)
    }

    fn unary(&mut self, live: bool) -> Result<i32, Diagnostic> {
        let Some(token) = self.peek() else {
            return Err(wrong(self.end, "the condition ends too early"));
        };
        self.at += 1;
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(wrong(token.span, "the condition is nested too deeply"));
        }
        let value = match &*token.text {
            "+" => self.unary(live)?,
            "-" => self.unary(live)?.wrapping_neg(),
            "~" => !self.unary(live)?,
            "!" => i32::from(self.unary(live)? == 0),
            "(" => {
                let value = self.binary(0, live)?;
                if !self.peek().is_some_and(|close| close.is(")")) {
                    return Err(wrong(token.span, "this `(` is never closed"));
                }
                self.at += 1;
                value
            }
            text if token.kind == Kind::Number => integer(text)
                .ok_or_else(|| wrong(token.span, format!("`{text}` is not a whole number")))?,
            _ if token.kind == Kind::Identifier && !live => 0,
            name if token.kind == Kind::Identifier => {
                return Err(wrong(token.span, format!("`{name}` is not a macro"))
                    .hint("test it with `defined(…)` first"));
            }
            other => return Err(wrong(token.span, format!("`{other}` does not belong here"))),
        };
        self.depth -= 1;
        Ok(value)
    }
}

/// A decimal, octal or hexadecimal number of 32 bits.
fn integer(text: &str) -> Option<i32> {
    let digits = text.strip_suffix(['u', 'U']).unwrap_or(text);
    let value = match digits
        .strip_prefix("0x")
        .or_else(|| digits.strip_prefix("0X"))
    {
        Some(digits) => u32::from_str_radix(digits, 16),
        None if digits.len() > 1 && digits.starts_with('0') => u32::from_str_radix(digits, 8),
        None => digits.parse(),
    };
    value.ok().map(u32::cast_signed)
}

/// `None` for what has no value.
fn apply(operator: &str, a: i32, b: i32) -> Option<i32> {
    let truth = |holds: bool| Some(i32::from(holds));
    match operator {
        "||" => truth(a != 0 || b != 0),
        "&&" => truth(a != 0 && b != 0),
        "|" => Some(a | b),
        "^" => Some(a ^ b),
        "&" => Some(a & b),
        "==" => truth(a == b),
        "!=" => truth(a != b),
        "<" => truth(a < b),
        ">" => truth(a > b),
        "<=" => truth(a <= b),
        ">=" => truth(a >= b),
        "<<" => Some(a.wrapping_shl(b as u32)),
        ">>" => Some(a.wrapping_shr(b as u32)),
        "+" => Some(a.wrapping_add(b)),
        "-" => Some(a.wrapping_sub(b)),
        "*" => Some(a.wrapping_mul(b)),
        "/" => (b != 0).then(|| a.wrapping_div(b)),
        "%" => (b != 0).then(|| a.wrapping_rem(b)),
        _ => None,
    }
}
