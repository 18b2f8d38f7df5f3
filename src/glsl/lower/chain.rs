//! Sums and products of several operands of which more than one is constant. Mesa's compiler of GLSL brings the constants
//! together first of all (`opt_algebraic`), which rounds differently: `x + 2.0 + y + 3.0` is `(5.0 + y) + x`.

use super::expression::Typed;
use super::function::{Builder, H};
use crate::glsl::Arithmetic;
use crate::glsl::arena::Id;
use crate::glsl::hir::{BinaryOp, Expr, ExprKind, Extent};
use crate::glsl::types::Scalar;

/// The most operands of a chain that is looked at.
const MOST: usize = 64;

/// Operands under one operator.
enum Tree {
    Leaf(Id<Expr>),
    Constant(Id<Expr>),
    Node(Box<[Tree; 2]>),
}

impl Tree {
    fn is_constant(&self) -> bool {
        match self {
            Tree::Leaf(_) => false,
            Tree::Constant(_) => true,
            Tree::Node(sides) => sides.iter().all(Tree::is_constant),
        }
    }

    /// Brings constants together, the innermost first; whether anything moved.
    fn gather(&mut self) -> bool {
        let Tree::Node(sides) = self else {
            return false;
        };
        let [left, right] = &mut **sides;
        let mut moved = left.gather() | right.gather();
        moved |= match (left.is_constant(), right.is_constant()) {
            (true, false) => right.take_in(left),
            (false, true) => left.take_in(right),
            _ => false,
        };
        moved
    }

    /// Exchanges a constant for what stands beside another one.
    fn take_in(&mut self, constant: &mut Tree) -> bool {
        let Tree::Node(sides) = self else {
            return false;
        };
        let [left, right] = &mut **sides;
        match (left.is_constant(), right.is_constant()) {
            (true, true) => return false,
            (true, false) => std::mem::swap(right, constant),
            (false, true) => std::mem::swap(left, constant),
            (false, false) => return left.take_in(constant) || right.take_in(constant),
        }
        true
    }
}

impl Builder<'_, '_> {
    /// A sum or a product whose constants are brought together; `None` if there is nothing to bring.
    pub(super) fn chain(&mut self, id: Id<Expr>) -> Option<H> {
        let Expr { kind, extent, .. } = self.source.exprs[id];
        let ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Multiply), left, right) = kind else {
            return None;
        };
        let is_constant =
            |side: Id<Expr>| matches!(self.source.exprs[side].kind, ExprKind::Constant(_));
        let is_expanded = self.context.options.arithmetic == Arithmetic::Expanded;
        // What has no constant of its own is looked at operand by operand.
        if !is_expanded || is_constant(left) == is_constant(right) {
            return None;
        }
        let mut room = MOST;
        let mut tree = self.tree(id, op, &mut room)?;
        if !tree.gather() || self.has_effect(id) {
            return None;
        }
        Some(self.evaluate_tree(&tree, op, extent).value)
    }

    /// The operands below an operator; `None` if they are too many.
    fn tree(&self, id: Id<Expr>, op: BinaryOp, room: &mut usize) -> Option<Tree> {
        let Expr { kind, ty, .. } = self.source.exprs[id];
        Some(match kind {
            ExprKind::Binary(own, left, right)
                if own == op && ty.scalar() == Some(Scalar::Float) && !self.has_matrix(id) =>
            {
                *room = room.checked_sub(1)?;
                let sides = [self.tree(left, op, room)?, self.tree(right, op, room)?];
                Tree::Node(Box::new(sides))
            }
            ExprKind::Constant(_) => Tree::Constant(id),
            _ => Tree::Leaf(id),
        })
    }

    fn has_matrix(&self, id: Id<Expr>) -> bool {
        let mut any = false;
        self.source.for_each_operand(id, |operand| {
            any |= self.source.exprs[operand].ty.is_matrix();
        });
        any
    }

    fn evaluate_tree(&mut self, tree: &Tree, op: BinaryOp, at: Extent) -> Typed {
        let sides = match tree {
            Tree::Leaf(id) | Tree::Constant(id) => return self.typed(*id),
            Tree::Node(sides) => sides,
        };
        let [left, right] = [0, 1].map(|side| self.evaluate_tree(&sides[side], op, at));
        let ty = if left.ty.is_scalar() {
            right.ty
        } else {
            left.ty
        };
        let value = match (op, self.known(left.value), self.known(right.value)) {
            (BinaryOp::Add, Some(a), Some(b)) if ty.is_scalar() => self.rounded(a + b),
            (BinaryOp::Multiply, Some(a), Some(b)) if ty.is_scalar() => self.rounded(a * b),
            _ => self.operate(op, left, right, at),
        };
        Typed { value, ty }
    }

    fn rounded(&mut self, value: f64) -> H {
        self.float(self.context.options.precision.round(value))
    }
}
