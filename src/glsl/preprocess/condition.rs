//! The expressions of `#if`, `#elif` and `#line`.

use super::directive::Directives;
use super::expand::Expansion;
use super::number::{self, Number, NumberError};
use super::token::{Kind, Token};
use crate::glsl::names::Names;
use crate::glsl::words::Symbol;
use crate::source::{Diagnostic, Span};

/// Whether the condition behind `directive` holds. What is wrong with it is reported, and does not
/// hold.
pub(super) fn holds<'a>(source: &mut Directives<'a>, directive: &Token, line: Vec<Token>) -> bool {
    let value = resolve_defined(source, directive, line).and_then(|line| {
        let line = Expansion::of_list(line, source);
        let (value, length) = evaluate(&line, directive.span, u32::MAX, &source.names)?;
        match line.get(length) {
            Some(extra) => Err(misplaced(extra, &source.names)),
            None => Ok(value),
        }
    });
    match value {
        Ok(value) => value != 0,
        Err(problem) => {
            source.report(problem);
            false
        }
    }
}

pub(super) fn wrong(at: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error("preprocessor", message).at(at)
}

pub(super) fn misplaced(token: &Token, names: &Names) -> Diagnostic {
    token.blame(Diagnostic::error(
        "preprocessor",
        format!("`{}` does not belong here", names.quoted(token.spelling)),
    ))
}

/// Replaces `defined X` and `defined(X)` by 1 or 0, before macros are expanded.
fn resolve_defined<'a>(
    source: &mut Directives<'a>,
    directive: &Token,
    line: Vec<Token>,
) -> Result<Vec<Token>, Diagnostic> {
    let mut resolved = Vec::with_capacity(line.len());
    let mut tokens = line.into_iter();
    while let Some(token) = tokens.next() {
        if source.names.text(token.spelling) != "defined" {
            resolved.push(token);
            continue;
        }
        let missing = || wrong(directive.span, "`defined` wants a name");
        let mut name = tokens.next().ok_or_else(missing)?;
        let in_brackets = name.is(Symbol::LeftParenthesis);
        if in_brackets {
            name = tokens.next().ok_or_else(missing)?;
        }
        if name.kind != Kind::Identifier {
            return Err(wrong(name.span, "`defined` wants a name"));
        }
        if in_brackets
            && !tokens
                .next()
                .is_some_and(|close| close.is(Symbol::RightParenthesis))
        {
            return Err(wrong(name.span, "a `)` is missing behind this"));
        }
        let is_defined = source.macros.find_mentioned(name.spelling).is_some();
        let value = source.names.intern(if is_defined { "1" } else { "0" });
        resolved.push(Token::new(Kind::Number, value, name.span, false));
    }
    Ok(resolved)
}

/// Binary operators, loosest first.
const LEVELS: [&[Symbol]; 10] = [
    &[Symbol::OrOr],
    &[Symbol::AndAnd],
    &[Symbol::Or],
    &[Symbol::Xor],
    &[Symbol::And],
    &[Symbol::Equal, Symbol::NotEqual],
    &[
        Symbol::Less,
        Symbol::Greater,
        Symbol::LessEqual,
        Symbol::GreaterEqual,
    ],
    &[Symbol::ShiftLeft, Symbol::ShiftRight],
    &[Symbol::Plus, Symbol::Minus],
    &[Symbol::Star, Symbol::Slash, Symbol::Percent],
];

/// What waits for its right operand, or for its `)`.
enum Waiting {
    /// A `(`, and its place.
    Bracket(Span),
    Unary(Symbol),
    Binary {
        operator: Symbol,
        place: Span,
        level: usize,
        /// Whether the left operand of `&&` or `||` has decided already: then the right one needs
        /// no value.
        is_decided: bool,
    },
}

/// The value of the longest constant expression that `tokens` begin with, and its length. Integers
/// may have bits up to those of `most`; `end` is the place of what is missing at the end.
pub(super) fn evaluate(
    tokens: &[Token],
    end: Span,
    most: u32,
    names: &Names,
) -> Result<(i32, usize), Diagnostic> {
    let mut stack = Stack {
        names,
        most,
        values: Vec::new(),
        waiting: Vec::new(),
        decided: 0,
    };
    let mut wants_operand = true;
    let mut length = 0;
    for token in tokens {
        let is_part = match wants_operand {
            true => {
                wants_operand = stack.operand(token)?;
                true
            }
            false if token.is(Symbol::RightParenthesis) => stack.close()?,
            false => {
                wants_operand = stack.operator(token)?;
                wants_operand
            }
        };
        if !is_part {
            break;
        }
        length += 1;
    }
    if wants_operand {
        return Err(wrong(end, "the expression ends too early"));
    }
    Ok((stack.finish()?, length))
}

/// An expression half read. It is no recursion, so that brackets may be as deep as they like.
struct Stack<'n> {
    names: &'n Names,
    /// The bits that an integer may have.
    most: u32,
    values: Vec<i32>,
    waiting: Vec<Waiting>,
    /// How many of those waiting have decided already.
    decided: usize,
}

impl Stack<'_> {
    /// Takes a token where an operand should be. Whether an operand is still wanted behind it.
    fn operand(&mut self, token: &Token) -> Result<bool, Diagnostic> {
        use Symbol::{Complement, LeftParenthesis, Minus, Not, Plus};
        match token.spelling.symbol() {
            Some(LeftParenthesis) => self.waiting.push(Waiting::Bracket(token.span)),
            Some(operator @ (Plus | Minus | Complement | Not)) => {
                self.waiting.push(Waiting::Unary(operator));
            }
            _ => {
                self.values.push(self.value(token)?);
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn value(&self, token: &Token) -> Result<i32, Diagnostic> {
        let quoted = self.names.quoted(token.spelling);
        let wrong = |message| Err(token.blame(Diagnostic::error("preprocessor", message)));
        match token.kind {
            Kind::Number => match number::parse(self.names.text(token.spelling)) {
                Ok(Number::Int(bits) | Number::Uint(bits)) if bits <= self.most => {
                    Ok(bits.cast_signed())
                }
                Ok(Number::Int(_) | Number::Uint(_)) | Err(NumberError::Overflow) => {
                    wrong(format!("`{quoted}` is too large"))
                }
                Ok(Number::Float(_)) | Err(NumberError::Malformed) => {
                    wrong(format!("`{quoted}` is not a whole number"))
                }
            },
            Kind::Identifier if self.decided > 0 => Ok(0),
            Kind::Identifier => wrong(format!("`{quoted}` is not a macro"))
                .map_err(|problem| problem.hint("test it with `defined(…)` first")),
            _ => Err(misplaced(token, self.names)),
        }
    }

    /// Takes a token where an operator may be. Whether it is one.
    fn operator(&mut self, token: &Token) -> Result<bool, Diagnostic> {
        let Some(operator) = token.spelling.symbol() else {
            return Ok(false);
        };
        let is_of = |level: &&[Symbol]| level.contains(&operator);
        let Some(level) = LEVELS.iter().position(is_of) else {
            return Ok(false);
        };
        self.reduce(level)?;
        let left = self.values.last().copied().unwrap_or(0);
        let is_decided = match operator {
            Symbol::AndAnd => left == 0,
            Symbol::OrOr => left != 0,
            _ => false,
        };
        self.decided += usize::from(is_decided);
        self.waiting.push(Waiting::Binary {
            operator,
            place: token.span,
            level,
            is_decided,
        });
        Ok(true)
    }

    /// Takes a `)`. Whether it belongs to the expression.
    fn close(&mut self) -> Result<bool, Diagnostic> {
        self.reduce(0)?;
        Ok(self.waiting.pop().is_some())
    }

    fn finish(mut self) -> Result<i32, Diagnostic> {
        self.reduce(0)?;
        match self.waiting.pop() {
            Some(Waiting::Bracket(open)) => Err(wrong(open, "this `(` is never closed")),
            _ => Ok(self.values.pop().unwrap_or(0)),
        }
    }

    /// Computes what binds at least as tightly as an operator of `level`, back to the last bracket.
    fn reduce(&mut self, level: usize) -> Result<(), Diagnostic> {
        while let Some(last) = self.waiting.pop() {
            match last {
                Waiting::Unary(operator) => {
                    let value = self.values.pop().unwrap_or(0);
                    self.values.push(match operator {
                        Symbol::Minus => value.wrapping_neg(),
                        Symbol::Complement => !value,
                        Symbol::Not => i32::from(value == 0),
                        _ => value,
                    });
                }
                Waiting::Binary {
                    operator,
                    place,
                    level: tightness,
                    is_decided,
                } if tightness >= level => {
                    let right = self.values.pop().unwrap_or(0);
                    let left = self.values.pop().unwrap_or(0);
                    self.values.push(match apply(operator, left, right) {
                        Ok(value) => value,
                        Err(_) if self.decided > 0 => 0,
                        Err(message) => return Err(wrong(place, message)),
                    });
                    self.decided -= usize::from(is_decided);
                }
                other => {
                    self.waiting.push(other);
                    break;
                }
            }
        }
        Ok(())
    }
}

fn apply(operator: Symbol, a: i32, b: i32) -> Result<i32, &'static str> {
    use Symbol as S;
    let shift = || match u32::try_from(b) {
        Ok(bits) if bits < 32 => Ok(bits),
        _ => Err("a shift by less than 0 or more than 31 bits"),
    };
    Ok(match operator {
        S::OrOr => i32::from(a != 0 || b != 0),
        S::AndAnd => i32::from(a != 0 && b != 0),
        S::Or => a | b,
        S::Xor => a ^ b,
        S::And => a & b,
        S::Equal => i32::from(a == b),
        S::NotEqual => i32::from(a != b),
        S::Less => i32::from(a < b),
        S::Greater => i32::from(a > b),
        S::LessEqual => i32::from(a <= b),
        S::GreaterEqual => i32::from(a >= b),
        S::ShiftLeft => a << shift()?,
        // ANGLE shifts zeros in, also for negative numbers.
        S::ShiftRight => (a.cast_unsigned() >> shift()?).cast_signed(),
        S::Plus => a.wrapping_add(b),
        S::Minus => a.wrapping_sub(b),
        S::Star => a.wrapping_mul(b),
        S::Slash | S::Percent if b == 0 => return Err("division by zero"),
        S::Slash => a.saturating_div(b),
        _ => a.wrapping_rem(b),
    })
}
