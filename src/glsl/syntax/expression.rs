//! Expressions, §5.

use super::ast::{
    ArraySize, BinaryOp, Callee, Expr, ExprKind, TokenIndex, TypeKind, TypeSpecifier, UnaryOp,
};
use super::lexeme::Lexeme;
use super::parser::{Parse, Parser};
use crate::glsl::arena::Id;
use crate::glsl::types::Base;
use crate::glsl::words::Symbol;

/// An operator and its left operand. They wait for the right operand, which may hold operators that
/// bind tighter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pending {
    left: Id<Expr>,
    op: BinaryOp,
    binding: u8,
    at: TokenIndex,
}

/// An operator between two operands, and how tight it binds.
fn binary_operator(lexeme: Lexeme) -> Option<(BinaryOp, u8)> {
    let Lexeme::Symbol(symbol) = lexeme else {
        return None;
    };
    Some(match symbol {
        Symbol::OrOr => (BinaryOp::LogicalOr, 1),
        Symbol::XorXor => (BinaryOp::LogicalXor, 2),
        Symbol::AndAnd => (BinaryOp::LogicalAnd, 3),
        Symbol::Or => (BinaryOp::BitOr, 4),
        Symbol::Xor => (BinaryOp::BitXor, 5),
        Symbol::And => (BinaryOp::BitAnd, 6),
        Symbol::Equal => (BinaryOp::Equal, 7),
        Symbol::NotEqual => (BinaryOp::NotEqual, 7),
        Symbol::Less => (BinaryOp::Less, 8),
        Symbol::Greater => (BinaryOp::Greater, 8),
        Symbol::LessEqual => (BinaryOp::LessEqual, 8),
        Symbol::GreaterEqual => (BinaryOp::GreaterEqual, 8),
        Symbol::ShiftLeft => (BinaryOp::ShiftLeft, 9),
        Symbol::ShiftRight => (BinaryOp::ShiftRight, 9),
        Symbol::Plus => (BinaryOp::Add, 10),
        Symbol::Minus => (BinaryOp::Subtract, 10),
        Symbol::Star => (BinaryOp::Multiply, 11),
        Symbol::Slash => (BinaryOp::Divide, 11),
        Symbol::Percent => (BinaryOp::Remainder, 11),
        _ => return None,
    })
}

/// `=` or an operator with it.
fn assignment_operator(lexeme: Lexeme) -> Option<Option<BinaryOp>> {
    let Lexeme::Symbol(symbol) = lexeme else {
        return None;
    };
    Some(match symbol {
        Symbol::Assign => None,
        Symbol::PlusAssign => Some(BinaryOp::Add),
        Symbol::MinusAssign => Some(BinaryOp::Subtract),
        Symbol::StarAssign => Some(BinaryOp::Multiply),
        Symbol::SlashAssign => Some(BinaryOp::Divide),
        Symbol::PercentAssign => Some(BinaryOp::Remainder),
        Symbol::AndAssign => Some(BinaryOp::BitAnd),
        Symbol::OrAssign => Some(BinaryOp::BitOr),
        Symbol::XorAssign => Some(BinaryOp::BitXor),
        Symbol::ShiftLeftAssign => Some(BinaryOp::ShiftLeft),
        Symbol::ShiftRightAssign => Some(BinaryOp::ShiftRight),
        _ => return None,
    })
}

/// An operator before its operand.
#[derive(Clone, Copy)]
enum Prefix {
    Unary(UnaryOp),
    Increment { down: bool },
}

fn prefix_operator(lexeme: Lexeme) -> Option<Prefix> {
    let Lexeme::Symbol(symbol) = lexeme else {
        return None;
    };
    Some(match symbol {
        Symbol::Plus => Prefix::Unary(UnaryOp::Plus),
        Symbol::Minus => Prefix::Unary(UnaryOp::Negate),
        Symbol::Not => Prefix::Unary(UnaryOp::Not),
        Symbol::Complement => Prefix::Unary(UnaryOp::Complement),
        Symbol::Increment => Prefix::Increment { down: false },
        Symbol::Decrement => Prefix::Increment { down: true },
        _ => return None,
    })
}

impl Parser<'_> {
    /// Any expression, commas included.
    pub fn expression(&mut self) -> Parse<Id<Expr>> {
        let mut left = self.assignment()?;
        while self.is(Symbol::Comma) {
            let at = self.advance();
            let right = self.assignment()?;
            left = self.add(ExprKind::Comma(left, right), at, self.first_of(left))?;
        }
        Ok(left)
    }

    /// An expression without a comma: an argument or an initialiser.
    pub fn assignment(&mut self) -> Parse<Id<Expr>> {
        self.enter()?;
        let left = self.unary()?;
        let expr = match assignment_operator(self.peek()) {
            Some(op) => {
                let at = self.advance();
                let right = self.assignment()?;
                self.add(ExprKind::Assign(op, left, right), at, self.first_of(left))
            }
            None => self.conditional_from(left),
        };
        self.leave();
        expr
    }

    /// An expression without a comma or an assignment: a size or a label.
    pub fn conditional(&mut self) -> Parse<Id<Expr>> {
        self.enter()?;
        let left = self.unary()?;
        let expr = self.conditional_from(left);
        self.leave();
        expr
    }

    /// Continues behind the first operand.
    fn conditional_from(&mut self, left: Id<Expr>) -> Parse<Id<Expr>> {
        let condition = self.binary_from(left)?;
        if !self.is(Symbol::Question) {
            return Ok(condition);
        }
        let at = self.advance();
        let yes = self.expression()?;
        if !self.accept(Symbol::Colon) {
            return Err(self.unexpected_but("`:`", Some("a `?` has two values: `a ? b : c`")));
        }
        let no = self.assignment()?;
        let kind = ExprKind::Ternary(condition, yes, no);
        self.add(kind, at, self.first_of(condition))
    }

    /// Operands with operators between them, without recursion for each level of precedence.
    fn binary_from(&mut self, left: Id<Expr>) -> Parse<Id<Expr>> {
        let base = self.pending.len();
        let mut last = left;
        while let Some((op, binding)) = binary_operator(self.peek()) {
            last = self.reduce(last, base, binding)?;
            self.pending.push(Pending {
                left: last,
                op,
                binding,
                at: self.here(),
            });
            self.advance();
            last = self.unary()?;
        }
        self.reduce(last, base, 0)
    }

    /// Gives their right operand to the operators that bind at least as tight as `binding`.
    fn reduce(&mut self, mut right: Id<Expr>, base: usize, binding: u8) -> Parse<Id<Expr>> {
        while let Some(&top) = self.pending[base..].last() {
            if top.binding < binding {
                break;
            }
            self.pending.pop();
            let kind = ExprKind::Binary(top.op, top.left, right);
            right = self.add(kind, top.at, self.first_of(top.left))?;
        }
        Ok(right)
    }

    fn unary(&mut self) -> Parse<Id<Expr>> {
        let first = self.here();
        while prefix_operator(self.peek()).is_some() {
            self.advance();
        }
        let behind = self.here();
        let mut operand = self.postfix()?;
        for at in (first..behind).rev() {
            let kind = match prefix_operator(self.lexeme(at)) {
                Some(Prefix::Unary(op)) => ExprKind::Unary(op, operand),
                Some(Prefix::Increment { down }) => ExprKind::Increment {
                    place: operand,
                    down,
                    prefix: true,
                },
                None => break,
            };
            operand = self.add(kind, at, at)?;
        }
        Ok(operand)
    }

    fn postfix(&mut self) -> Parse<Id<Expr>> {
        let first = self.here();
        let mut may_be_type = false;
        let mut expr = match self.peek() {
            Lexeme::Name(name) => {
                let at = self.advance();
                match self.is(Symbol::LeftParenthesis) {
                    true => self.call(Callee::Name(name), at, first)?,
                    false => {
                        may_be_type = true;
                        self.add(ExprKind::Name(name), at, first)?
                    }
                }
            }
            _ => self.primary()?,
        };
        loop {
            let Lexeme::Symbol(symbol) = self.peek() else {
                return Ok(expr);
            };
            expr = match symbol {
                Symbol::LeftBracket if may_be_type && self.is_unsized_constructor() => {
                    may_be_type = false;
                    self.array_of_named(expr)?
                }
                Symbol::LeftBracket => {
                    let at = self.advance();
                    let index = self.expression()?;
                    self.close(at, Symbol::RightBracket, "`]`")?;
                    self.add(ExprKind::Index(expr, index), at, first)?
                }
                Symbol::LeftParenthesis if may_be_type => {
                    may_be_type = false;
                    self.array_of_named(expr)?
                }
                Symbol::Dot => {
                    may_be_type = false;
                    self.advance();
                    let (member, at) = self.name("a member")?;
                    match self.is(Symbol::LeftParenthesis) {
                        true => self.call(Callee::Method(expr, member), at, first)?,
                        false => self.add(ExprKind::Member(expr, member), at, first)?,
                    }
                }
                Symbol::Increment | Symbol::Decrement => {
                    may_be_type = false;
                    let at = self.advance();
                    let kind = ExprKind::Increment {
                        place: expr,
                        down: symbol == Symbol::Decrement,
                        prefix: false,
                    };
                    self.add(kind, at, first)?
                }
                _ => return Ok(expr),
            };
        }
    }

    fn primary(&mut self) -> Parse<Id<Expr>> {
        let first = self.here();
        let kind = match self.peek() {
            Lexeme::Int(value) => ExprKind::Int(value),
            Lexeme::Uint(value) => ExprKind::Uint(value),
            Lexeme::Float(value) => ExprKind::Float(value),
            Lexeme::Bool(value) => ExprKind::Bool(value),
            Lexeme::Type(_) => {
                let ty = self.type_specifier()?;
                return self.construct(ty);
            }
            Lexeme::Symbol(Symbol::LeftParenthesis) => {
                self.advance();
                let inner = self.expression()?;
                self.close(first, Symbol::RightParenthesis, "`)`")?;
                // Parentheses leave no trace but that they belong to what is in them.
                self.ast.exprs[inner].extent = self.extent_from(first);
                return Ok(inner);
            }
            Lexeme::Symbol(Symbol::LeftBrace) => {
                let hint = "write `float[](…)`, `vec3(…)` or the structure's name with `(…)`";
                let message = "a list in braces is no value in GLSL ES 3.00";
                return Err(self.wrong(first as usize, message, Some(hint)));
            }
            found => {
                let before = first.checked_sub(1).map(|before| self.lexeme(before));
                let hint = match (before, found) {
                    (Some(Lexeme::Symbol(Symbol::Minus)), Lexeme::Symbol(Symbol::Greater)) => {
                        Some("members are named with a `.`")
                    }
                    (_, Lexeme::Symbol(Symbol::And)) => Some("GLSL has no pointers"),
                    (_, Lexeme::Symbol(Symbol::Star)) => {
                        Some("GLSL has no pointers, and `pow(x, y)` is its power")
                    }
                    (_, Lexeme::Symbol(Symbol::LeftBracket)) => Some("GLSL has no attributes"),
                    (_, Lexeme::Word(word)) if word.begins_declaration() => {
                        Some("qualifiers and structures stand in declarations only")
                    }
                    _ => None,
                };
                return Err(self.unexpected_but("an expression", hint));
            }
        };
        self.advance();
        self.add(kind, first, first)
    }

    /// Whether `[](` or `[][` is at hand.
    fn is_unsized_constructor(&self) -> bool {
        use Symbol::{LeftBracket, LeftParenthesis, RightBracket};
        self.peek_at(1) == Lexeme::Symbol(RightBracket)
            && matches!(
                self.peek_at(2),
                Lexeme::Symbol(LeftParenthesis | LeftBracket)
            )
    }

    /// A constructor's arguments, behind its type.
    fn construct(&mut self, ty: TypeSpecifier) -> Parse<Id<Expr>> {
        let first = ty.extent.first;
        if self.is(Symbol::LeftParenthesis) {
            let ty = self.ast.types.add(ty);
            return self.call(Callee::Type(ty), first, first);
        }
        let hint = match self.peek() {
            Lexeme::Name(_) => "a variable is declared in a statement of its own",
            _ => "a type makes a value with its arguments, as in `float(x)` or `vec3(0.0)`",
        };
        Err(self.unexpected_but("`(`", Some(hint)))
    }

    /// Takes `S[2]`, which has been read as an element of a variable, for the type of a constructor.
    fn array_of_named(&mut self, expr: Id<Expr>) -> Parse<Id<Expr>> {
        let mut sizes = Vec::new();
        let mut base = expr;
        while let ExprKind::Index(array, size) = self.ast.exprs[base].kind {
            let at = self.ast.exprs[base].at;
            sizes.push(ArraySize {
                size: Some(size),
                at,
            });
            base = array;
        }
        sizes.reverse();
        let first = self.first_of(base);
        let ExprKind::Name(name) = self.ast.exprs[base].kind else {
            return Err(self.unexpected("`;`"));
        };
        self.more_sizes(&mut sizes)?;
        let sizes = self.ast.sizes.add(&sizes);
        self.construct(TypeSpecifier {
            kind: TypeKind::Named(name),
            sizes,
            extent: self.extent_from(first),
        })
    }

    /// The arguments of a call, from the `(` at hand.
    fn call(&mut self, callee: Callee, at: TokenIndex, first: TokenIndex) -> Parse<Id<Expr>> {
        let base = self.arguments.len();
        let open = self.advance();
        let is_void = self.peek() == Lexeme::Type(Base::Void)
            && self.peek_at(1) == Lexeme::Symbol(Symbol::RightParenthesis);
        if is_void {
            self.advance();
        } else if !self.is(Symbol::RightParenthesis) {
            loop {
                let argument = self.assignment()?;
                self.arguments.push(argument);
                if !self.accept(Symbol::Comma) {
                    break;
                }
            }
        }
        self.close(open, Symbol::RightParenthesis, "`,` or `)`")?;
        let arguments = self.ast.arguments.add(&self.arguments[base..]);
        self.arguments.truncate(base);
        self.add(ExprKind::Call(callee, arguments), at, first)
    }
}
