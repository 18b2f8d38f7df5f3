//! What values an integer may have, as far as it is plain to see: whether an index needs a check.

use rustc_hash::FxHashMap;

use super::function::Builder;
use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::{
    BinaryOp, Direction, Expr, ExprKind, Local, Loop, Stmt, StmtKind, UnaryOp, Value,
};
use crate::glsl::prune;
use crate::glsl::types::{Base, Scalar, Type};

/// The least and the greatest value.
type Range = (i64, i64);

/// How deep expressions are looked into.
const DEPTH: u32 = 16;

/// What is known of local variables.
#[derive(Default)]
pub(super) struct Ranges {
    known: FxHashMap<Id<Local>, Range>,
}

impl Ranges {
    /// Notes what is known of a variable, and returns what was.
    pub fn set(&mut self, local: Id<Local>, range: Option<Range>) -> Option<Range> {
        match range {
            Some(range) => self.known.insert(local, range),
            None => self.known.remove(&local),
        }
    }
}

impl Builder<'_, '_> {
    /// Whether an index is certain to be in range.
    pub(super) fn is_below(&self, index: Id<Expr>, count: u32) -> bool {
        matches!(self.range(index, DEPTH), Some((low, high)) if low >= 0 && high < i64::from(count))
    }

    /// Notes what is known of a variable that keeps its first value.
    pub(super) fn note_range(&mut self, local: Id<Local>, value: Id<Expr>) {
        if let Some(range) = self.range(value, DEPTH) {
            self.ranges.set(local, Some(range));
        }
    }

    fn range(&self, id: Id<Expr>, depth: u32) -> Option<Range> {
        let depth = depth.checked_sub(1)?;
        let Expr { kind, ty, .. } = self.source.exprs[id];
        let Base::Scalar(scalar @ (Scalar::Int | Scalar::Uint)) = ty.base else {
            return None;
        };
        if ty.is_array() {
            return None;
        }
        let of = |id| self.range(id, depth);
        let (low, high) = match kind {
            ExprKind::Constant(constant) => match *self.context.hir.constants.get(constant) {
                [Value::Int(value)] => (value.into(), value.into()),
                [Value::Uint(value)] => (value.into(), value.into()),
                _ => return None,
            },
            ExprKind::Local(local) => *self.ranges.known.get(&local)?,
            ExprKind::Unary(UnaryOp::Negate, operand) => {
                let (low, high) = of(operand)?;
                (-high, -low)
            }
            ExprKind::Binary(BinaryOp::BitAnd, left, right) => {
                let limit = |id| of(id).filter(|(low, _)| *low >= 0).map(|(_, high)| high);
                match (limit(left), limit(right)) {
                    (Some(a), Some(b)) => (0, a.min(b)),
                    (Some(limit), None) | (None, Some(limit)) => (0, limit),
                    (None, None) => return None,
                }
            }
            ExprKind::Binary(BinaryOp::Remainder, left, right) => {
                let (divisor, limit) = of(right)?;
                if divisor <= 0 {
                    return None;
                }
                let is_positive =
                    scalar == Scalar::Uint || of(left).is_some_and(|(low, _)| low >= 0);
                (if is_positive { 0 } else { 1 - limit }, limit - 1)
            }
            ExprKind::Binary(op, left, right) => binary_range(op, of(left)?, of(right)?)?,
            ExprKind::Ternary(_, accept, reject) => union(of(accept)?, of(reject)?),
            ExprKind::Comma(_, value) => of(value)?,
            ExprKind::Construct(operands) => match self.source.operands.get(operands) {
                [operand] if self.source.exprs[*operand].ty == Type::BOOL => (0, 1),
                [operand] => of(*operand)?,
                _ => return None,
            },
            ExprKind::Builtin(builtin, operands) => {
                let operands = self.source.operands.get(operands);
                match (builtin, operands) {
                    (Builtin::Clamp, &[_, low, high]) => {
                        let (low, high) = (of(low)?, of(high)?);
                        if low.1 > high.0 {
                            return None;
                        }
                        (low.0, high.1)
                    }
                    (Builtin::Min | Builtin::Max, &[a, b]) => {
                        let full = full(scalar);
                        let (a, b) = (of(a).unwrap_or(full), of(b).unwrap_or(full));
                        match builtin {
                            Builtin::Min => (a.0.min(b.0), a.1.min(b.1)),
                            _ => (a.0.max(b.0), a.1.max(b.1)),
                        }
                    }
                    (Builtin::Abs, &[a]) => {
                        let (low, high) = of(a)?;
                        (0, low.abs().max(high.abs()))
                    }
                    _ => return None,
                }
            }
            _ => return None,
        };
        // What overflows may be anything.
        let (least, greatest) = full(scalar);
        (least <= low && high <= greatest).then_some((low, high))
    }

    /// A loop's counter and what it may be within the body: one that is declared right before the
    /// loop, changes in its step only, and is asked for a limit in its condition.
    pub(super) fn counter(&self, source: &Loop, before: &[Stmt]) -> Option<(Id<Local>, Range)> {
        let declarations = before.iter().enumerate().rev();
        let (i, local, first, step) = declarations
            .map_while(|(i, stmt)| match stmt.kind {
                StmtKind::Declare(local, first) => Some((i, local, first)),
                _ => None,
            })
            .find_map(|(i, local, first)| {
                let step = self.step(source.step?, local)?;
                Some((i, local, first?, step))
            })?;
        if self.is_written_in(&before[i + 1..], local) {
            return None;
        }
        let (low, high) = self.range(first, DEPTH)?;
        let condition = source.condition.filter(|_| !source.tests_last)?;
        let limit = self.limit(condition, local, step > 0)?;
        let full = full(self.source.locals[local].ty.scalar()?);
        let range = if step > 0 {
            (low, limit)
        } else {
            (limit, high)
        };
        // The step must not lead around from one end of all numbers to the other.
        let is_safe = (full.0..=full.1).contains(&(limit + step));
        (is_safe && !self.is_written_in(&source.body, local)).then_some((local, range))
    }

    fn step(&self, id: Id<Expr>, local: Id<Local>) -> Option<i64> {
        let is_local = |id: Id<Expr>| matches!(self.source.exprs[id].kind, ExprKind::Local(other) if other == local);
        match self.source.exprs[id].kind {
            ExprKind::Increment { place, down, .. } if is_local(place) => {
                Some(if down { -1 } else { 1 })
            }
            ExprKind::Compound(op, place, by) if is_local(place) => {
                let (low, high) = self.range(by, DEPTH)?;
                match op {
                    BinaryOp::Add if low == high && low != 0 => Some(low),
                    BinaryOp::Subtract if low == high && low != 0 => Some(-low),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The last value that a condition lets a counter have.
    fn limit(&self, id: Id<Expr>, local: Id<Local>, upward: bool) -> Option<i64> {
        match self.source.exprs[id].kind {
            ExprKind::And(left, right) => {
                let left = self.limit(left, local, upward);
                left.or_else(|| self.limit(right, local, upward))
            }
            ExprKind::Binary(op, left, right) if matches!(self.source.exprs[left].kind, ExprKind::Local(l) if l == local) =>
            {
                let (low, high) = self.range(right, DEPTH)?;
                match op {
                    BinaryOp::Less if upward => Some(high - 1),
                    BinaryOp::LessEqual if upward => Some(high),
                    BinaryOp::Greater if !upward => Some(low + 1),
                    BinaryOp::GreaterEqual if !upward => Some(low),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    fn is_written_in(&self, body: &[Stmt], local: Id<Local>) -> bool {
        let is_root = |place: Id<Expr>| {
            let root = prune::root(self.source, place);
            matches!(self.source.exprs[root].kind, ExprKind::Local(other) if other == local)
        };
        prune::expressions_in(self.source, body)
            .into_iter()
            .any(|id| match self.source.exprs[id].kind {
                ExprKind::Assign(place, _)
                | ExprKind::Compound(_, place, _)
                | ExprKind::Increment { place, .. } => is_root(place),
                ExprKind::Call(callee, operands) => {
                    let directions = &self.context.hir.functions[callee].parameters;
                    let operands = self.source.operands.get(operands);
                    operands
                        .iter()
                        .zip(directions)
                        .any(|(&operand, direction)| {
                            *direction != Direction::In && is_root(operand)
                        })
                }
                _ => false,
            })
    }
}

fn binary_range(op: BinaryOp, left: Range, right: Range) -> Option<Range> {
    let ((a, b), (c, d)) = (left, right);
    Some(match op {
        BinaryOp::Add => (a + c, b + d),
        BinaryOp::Subtract => (a - d, b - c),
        BinaryOp::Multiply => {
            let corners = [(a, c), (a, d), (b, c), (b, d)].map(|(x, y)| x.saturating_mul(y));
            let low = corners.into_iter().min()?;
            (low, corners.into_iter().max()?)
        }
        BinaryOp::Divide if a >= 0 && c > 0 => (a / d, b / c),
        BinaryOp::ShiftRight if a >= 0 && c == d && (0..32).contains(&c) => (a >> c, b >> c),
        _ => return None,
    })
}

fn union(a: Range, b: Range) -> Range {
    (a.0.min(b.0), a.1.max(b.1))
}

/// All values of a type.
fn full(scalar: Scalar) -> Range {
    match scalar {
        Scalar::Int => (i32::MIN.into(), i32::MAX.into()),
        _ => (0, u32::MAX.into()),
    }
}
