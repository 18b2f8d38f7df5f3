//! Expressions in their order: what GLSL evaluates first is appended first, and what it may leave
//! out is inside an `If`.

use naga::{BinaryOperator, Statement};

use super::constant::Part;
use super::function::{Builder, H};
use super::place::{Place, Source};
use super::sanitize::{Form, Suspect};
use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::{BinaryOp, Expr, ExprKind, Extent, UnaryOp};
use crate::glsl::types::{Base, Scalar, Type};

/// What may be computed in vain to spare a branch, in operations.
const CHEAP: u32 = 24;

impl Builder<'_, '_> {
    /// Evaluates an expression that has a value.
    pub(super) fn value(&mut self, id: Id<Expr>) -> H {
        let before = self.span;
        let extent = self.source.exprs[id].extent;
        self.span = self.span_of(extent);
        let value = self.value_in_precision(id);
        self.span = before;
        value
    }

    pub(super) fn value_here(&mut self, id: Id<Expr>) -> H {
        let Expr { kind, ty, extent } = self.source.exprs[id];
        let tree = self.tree.take();
        match kind {
            ExprKind::Constant(constant) => self.constant(Part::whole(constant), ty),
            ExprKind::Local(_)
            | ExprKind::Global(_)
            | ExprKind::Index(..)
            | ExprKind::Member(..)
            | ExprKind::Swizzle(..) => {
                self.check_set(id);
                let place = self.place(id);
                self.load_place(place)
            }
            ExprKind::Unary(op, operand) => {
                let of = self.source.exprs[operand].ty;
                self.tree = tree;
                let operand = self.value(operand);
                self.unary(op, operand, of)
            }
            ExprKind::Binary(op, left, right) => {
                let form = Form::Operator(op);
                let types = [left, right].map(|operand| self.source.exprs[operand].ty);
                let suspect = self.suspect(form, &types, ty, tree);
                if suspect.is_none()
                    && let Some(value) = self.chain(id).or_else(|| self.transformed(id))
                {
                    return value;
                }
                self.within(suspect, 0);
                let left = self.typed(left);
                self.within(suspect, 1);
                let right = self.typed(right);
                self.operate_checked(op, [left, right], extent, ty, suspect)
            }
            ExprKind::And(..) | ExprKind::Or(..) | ExprKind::Ternary(..) => {
                if let Some(value) = self.without_branch(id) {
                    return value;
                }
                let result = self.acquire(ty);
                self.evaluate_into(id, result);
                let value = self.load(result);
                self.release(ty, result);
                value
            }
            ExprKind::Comma(first, second) => {
                self.effect(first);
                self.value(second)
            }
            ExprKind::Assign(target, value) => {
                let place = self.place(target);
                let value = self.value(value);
                self.store_place(place, value);
                self.mark_set(target);
                value
            }
            ExprKind::Compound(op, target, operand) => {
                let place = self.place(target);
                // The place is read last: so do all compilers of GLSL, and golfed code counts on it.
                let form = Form::Operator(op);
                let types = [target, operand].map(|operand| self.source.exprs[operand].ty);
                let suspect = self.suspect(form, &types, ty, tree);
                self.within(suspect, 1);
                let right = self.typed(operand);
                self.check_set(target);
                let left = Typed {
                    value: self.load_place(place),
                    ty: place.ty,
                };
                let value = self.operate_checked(op, [left, right], extent, ty, suspect);
                self.store_place(place, value);
                self.mark_set(target);
                value
            }
            ExprKind::Increment {
                place,
                down,
                prefix,
            } => {
                let (old, new) = self.increment(place, down, extent);
                if prefix { new } else { old }
            }
            ExprKind::Construct(operands) => self.construct(operands, ty, tree),
            ExprKind::Call(function, operands) => self
                .call(function, operands)
                .expect("what is void has no value"),
            ExprKind::Builtin(builtin, operands) => self.builtin(builtin, operands, ty, tree),
        }
    }

    /// Applies an operator but `&&` and `||`, and looks at what that does.
    fn operate_checked(
        &mut self,
        op: BinaryOp,
        operands: [Typed; 2],
        at: Extent,
        ty: Type,
        suspect: Option<Suspect>,
    ) -> H {
        let [left, right] = operands;
        let found = self.check_operands(op, left, right);
        let value = self.operate(op, left, right, at);
        self.check_result(suspect, &operands, Typed { value, ty }, found);
        value
    }

    /// A value together with its type.
    pub(super) fn typed(&mut self, id: Id<Expr>) -> Typed {
        Typed {
            value: self.value(id),
            ty: self.source.exprs[id].ty,
        }
    }

    /// Evaluates an expression for what it does.
    pub(super) fn effect(&mut self, id: Id<Expr>) {
        if !self.has_effect(id) {
            return;
        }
        let before = self.span;
        let Expr { kind, extent, .. } = self.source.exprs[id];
        self.span = self.span_of(extent);
        match kind {
            ExprKind::Call(function, operands) => {
                self.call(function, operands);
            }
            ExprKind::Comma(first, second) => {
                self.effect(first);
                self.effect(second);
            }
            ExprKind::And(left, right) => {
                let condition = self.value(left);
                self.branch(condition, |b| b.effect(right), |_| {});
            }
            ExprKind::Or(left, right) => {
                let condition = self.value(left);
                self.branch(condition, |_| {}, |b| b.effect(right));
            }
            ExprKind::Ternary(condition, accept, reject) => {
                let condition = self.value(condition);
                self.branch(condition, |b| b.effect(accept), |b| b.effect(reject));
            }
            _ => {
                self.value_here(id);
            }
        }
        self.span = before;
    }

    /// Evaluates an expression and stores it in a variable that it does not name itself. Chains of
    /// `?:` thereby share one.
    pub(super) fn evaluate_into(&mut self, id: Id<Expr>, pointer: H) {
        let before = self.span;
        let Expr { kind, ty, extent } = self.source.exprs[id];
        self.span = self.span_of(extent);
        if let Some(value) = self.without_branch(id) {
            self.store(pointer, value);
            self.span = before;
            return;
        }
        match kind {
            ExprKind::And(left, right) => {
                self.evaluate_into(left, pointer);
                let condition = self.load(pointer);
                self.branch(condition, |b| b.evaluate_into(right, pointer), |_| {});
            }
            ExprKind::Or(left, right) => {
                self.evaluate_into(left, pointer);
                let condition = self.load(pointer);
                self.branch(condition, |_| {}, |b| b.evaluate_into(right, pointer));
            }
            ExprKind::Ternary(condition, accept, reject) => {
                let condition = self.value(condition);
                self.branch(
                    condition,
                    |b| b.evaluate_into(accept, pointer),
                    |b| b.evaluate_into(reject, pointer),
                );
            }
            ExprKind::Comma(first, second) => {
                self.effect(first);
                self.evaluate_into(second, pointer);
            }
            ExprKind::Constant(constant) if !self.is_low => {
                self.store_constant(pointer, Part::whole(constant), ty);
            }
            _ => {
                let value = self.value_in_precision(id);
                self.store(pointer, value);
            }
        }
        self.span = before;
    }

    /// A choice of which both sides are evaluated, if that is harmless and cheap.
    fn without_branch(&mut self, id: Id<Expr>) -> Option<H> {
        if self.is_sanitized() {
            // What is computed in vain would be found fault with.
            return None;
        }
        let Expr { kind, ty, .. } = self.source.exprs[id];
        match kind {
            ExprKind::And(left, right) | ExprKind::Or(left, right) => {
                self.cost(right, CHEAP)?;
                let left = self.value(left);
                let right = self.value(right);
                let op = match kind {
                    ExprKind::And(..) => BinaryOperator::LogicalAnd,
                    _ => BinaryOperator::LogicalOr,
                };
                Some(self.binary(op, left, right))
            }
            ExprKind::Ternary(condition, accept, reject) => {
                ty.vector_size()?;
                let rest = self.cost(accept, CHEAP)?;
                self.cost(reject, rest)?;
                let condition = self.value(condition);
                let accept = self.value(accept);
                let reject = self.value(reject);
                Some(self.select(condition, accept, reject))
            }
            _ => None,
        }
    }

    /// What remains of a budget after an expression that may be computed in vain; `None` when it is
    /// used up, or when the expression does more than compute.
    fn cost(&self, id: Id<Expr>, budget: u32) -> Option<u32> {
        let Expr { kind, ty, .. } = self.source.exprs[id];
        let own = match kind {
            ExprKind::Constant(_) if ty.is_array() => return None,
            ExprKind::Constant(_) | ExprKind::Member(..) | ExprKind::Swizzle(..) => 0,
            ExprKind::Local(_) | ExprKind::Global(_) if ty.is_array() => 0,
            ExprKind::Unary(..) | ExprKind::Local(_) | ExprKind::Global(_) => 1,
            ExprKind::Construct(_) | ExprKind::Comma(..) => 1,
            ExprKind::Binary(BinaryOp::Divide | BinaryOp::Remainder, _, divisor)
                if ty.scalar() != Some(Scalar::Float) && !self.is_safe_divisor(divisor) =>
            {
                return None;
            }
            ExprKind::Binary(..) | ExprKind::And(..) | ExprKind::Or(..) | ExprKind::Ternary(..) => {
                if ty.is_matrix() {
                    8
                } else {
                    1
                }
            }
            ExprKind::Index(base, index) => {
                let of = self.source.exprs[base].ty;
                if !self.is_below(index, super::place::count(of)) {
                    return None;
                }
                1
            }
            ExprKind::Builtin(builtin, _) => builtin_cost(builtin)?,
            ExprKind::Assign(..)
            | ExprKind::Compound(..)
            | ExprKind::Increment { .. }
            | ExprKind::Call(..) => return None,
        };
        let mut rest = budget.checked_sub(own);
        self.source.for_each_operand(id, |operand| {
            if self.source.exprs[operand].ty.sampler().is_none() {
                rest = rest.and_then(|rest| self.cost(operand, rest));
            }
        });
        rest
    }

    /// Whether evaluating an expression changes anything.
    pub(super) fn has_effect(&mut self, id: Id<Expr>) -> bool {
        if let Some(known) = self.room.effects[id.index()] {
            return known;
        }
        let known = match self.source.exprs[id].kind {
            ExprKind::Assign(..)
            | ExprKind::Compound(..)
            | ExprKind::Increment { .. }
            | ExprKind::Call(..)
            | ExprKind::Builtin(Builtin::Modf, _) => true,
            _ => {
                let mut any = false;
                let source = self.source;
                source.for_each_operand(id, |operand| {
                    any = any || self.has_effect(operand);
                });
                any
            }
        };
        self.room.effects[id.index()] = Some(known);
        known
    }

    /// Appends an `If`.
    pub(super) fn branch(
        &mut self,
        condition: H,
        accept: impl FnOnce(&mut Self),
        reject: impl FnOnce(&mut Self),
    ) {
        self.open();
        accept(self);
        let accept = self.close();
        self.open();
        reject(self);
        let reject = self.close();
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
    }

    /// The values before and after `++` or `--`.
    fn increment(&mut self, target: Id<Expr>, down: bool, extent: Extent) -> (H, H) {
        self.check_set(target);
        let place = self.place(target);
        let Place { ty, .. } = place;
        let scalar = ty.scalar().expect("only numbers are counted");
        debug_assert!(
            !matches!(place.source, Source::Value(_)),
            "values do not change"
        );
        let old = self.load_place(place);
        let one = Typed {
            value: self.number(1, scalar),
            ty: Type::vector(scalar, 1),
        };
        let op = if down {
            BinaryOp::Subtract
        } else {
            BinaryOp::Add
        };
        let operands = [Typed { value: old, ty }, one];
        let suspect = self.suspect(Form::Operator(op), &[ty, one.ty], ty, None);
        let new = self.operate_checked(op, operands, extent, ty, suspect);
        self.store_place(place, new);
        self.mark_set(target);
        (old, new)
    }

    fn unary(&mut self, op: UnaryOp, operand: H, ty: Type) -> H {
        match (op, ty.base) {
            (UnaryOp::Not, _) => self.not(operand),
            (UnaryOp::Complement, _) => self.add(naga::Expression::Unary {
                op: naga::UnaryOperator::BitwiseNot,
                expr: operand,
            }),
            (UnaryOp::Negate, Base::Matrix { .. }) => {
                let minus_one = self.float(-1.0);
                self.product(operand, minus_one)
            }
            (UnaryOp::Negate, Base::Scalar(Scalar::Uint) | Base::Vector(Scalar::Uint, _)) => {
                let zero = self.zero(ty);
                self.difference(zero, operand)
            }
            (UnaryOp::Negate, _) => self.negate(operand),
        }
    }
}

/// A value of the function that is being built, and its type.
#[derive(Clone, Copy, Debug)]
pub(super) struct Typed {
    pub value: H,
    pub ty: Type,
}

/// What a built-in function costs to compute in vain.
fn builtin_cost(builtin: Builtin) -> Option<u32> {
    use Builtin as B;
    Some(match builtin {
        B::Modf | B::Inverse | B::Determinant => return None,
        // These compare neighbouring pixels, and must not stand where only some of them come by.
        B::Texture
        | B::TextureOffset
        | B::TextureProj
        | B::TextureProjOffset
        | B::DFdx
        | B::DFdy
        | B::Fwidth => 8,
        B::TextureLod
        | B::TexelFetch
        | B::TexelFetchOffset
        | B::TextureProjLod
        | B::TextureProjLodOffset
        | B::TextureLodOffset
        | B::TextureGrad
        | B::TextureGradOffset
        | B::TextureProjGrad
        | B::TextureProjGradOffset => 16,
        B::Abs | B::Sign | B::Floor | B::Trunc | B::Round | B::RoundEven | B::Ceil | B::Fract => 1,
        B::Min | B::Max | B::Step | B::Clamp | B::Mix | B::Mod | B::Dot | B::Sqrt => 2,
        _ => 4,
    })
}
