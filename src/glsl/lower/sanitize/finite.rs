//! Where infinity and what is no number come from.
//!
//! Most arithmetic hands on what is not finite, so that it is enough to look at the result of a whole tree of
//! operations: compilers take long enough for that. Which of them it was, the second program finds.

use naga::{BinaryOperator, Expression, Literal, ScalarKind};
use smallvec::SmallVec;

use super::{Checks, Form, Hazard, Here};
use crate::glsl::builtins::Builtin as B;
use crate::glsl::hir::BinaryOp;
use crate::glsl::lower::expression::Typed;
use crate::glsl::lower::function::{Builder, H};
use crate::glsl::types::{Base, Scalar, Type};

/// An operation whose result may not be finite.
#[derive(Clone, Copy)]
pub(in crate::glsl::lower) struct Suspect {
    own: Here,
    form: Form,
    /// The outermost operation that its result is handed on to: the site where that is noticed.
    root: Here,
}

impl Builder<'_, '_> {
    /// The operation that is about to be lowered, if its result may not be finite. `tree` is what was given
    /// to it by [`Builder::within`].
    pub fn suspect(
        &mut self,
        form: Form,
        operands: &[Type],
        result: Type,
        tree: Option<Here>,
    ) -> Option<Suspect> {
        let may_be = match form {
            Form::Operator(op) => is_arithmetic(op),
            Form::Call(builtin) => makes_infinity(builtin),
            _ => false,
        };
        if !self.is_sanitized() || !may_be || result.scalar() != Some(Scalar::Float) {
            return None;
        }
        let own = self.site(Hazard::NotFinite, form, operands);
        let root = tree.unwrap_or(own);
        Some(Suspect { own, form, root })
    }

    /// What is lowered next is an operand of this operation, the one with this number.
    pub fn within(&mut self, suspect: Option<Suspect>, operand: usize) {
        let hands_on = |suspect: &Suspect| match suspect.form {
            // What is divided by infinity is zero.
            Form::Operator(BinaryOp::Divide) => operand == 0,
            Form::Operator(_) => true,
            Form::Call(builtin) => hands_on(builtin, operand),
            _ => false,
        };
        self.tree = suspect.filter(hands_on).map(|suspect| suspect.root);
    }

    /// Looks whether an operation has made infinity, or what is no number. What another check of it finds is
    /// not told again.
    pub fn check_result(
        &mut self,
        suspect: Option<Suspect>,
        operands: &[Typed],
        result: Typed,
        found: Option<H>,
    ) {
        let Some(Suspect { own, root, .. }) = suspect else {
            return;
        };
        if !root.is_wanted {
            return;
        }
        let is_second_look = matches!(self.context.options.checks, Checks::Operands(_));
        let is_root = own.number == root.number;
        if !is_second_look && !is_root && found.is_none() {
            return;
        }
        let Some(bad) = self.not_finite(result.value, result.ty) else {
            return;
        };
        let mut excuses: SmallVec<[H; 4]> = found.into_iter().collect();
        if is_second_look {
            for operand in operands {
                if operand.ty.scalar() == Some(Scalar::Float) {
                    excuses.extend(self.not_finite(operand.value, operand.ty));
                }
            }
        } else {
            excuses.push(self.taint(bad));
            if !is_root {
                return;
            }
        }
        let condition = excuses.into_iter().fold(bad, |condition, excuse| {
            let is_new = self.not(excuse);
            self.binary(BinaryOperator::LogicalAnd, condition, is_new)
        });
        self.note(root, own.number, condition, operands);
    }

    /// Keeps in mind whether anything in the pixel has not been finite, for only the first is of interest;
    /// whether something was so before.
    fn taint(&mut self, bad: H) -> H {
        let memory = self.context.sanitizer.memory;
        let tainted = memory.expect("there is room for findings").tainted;
        let tainted = self.global(tainted);
        let before = self.load(tainted);
        let after = self.binary(BinaryOperator::LogicalOr, before, bad);
        self.store(tainted, after);
        before
    }

    /// Whether any component is infinite or no number, by its bits: compilers assume that floats are
    /// neither. `None` if it is plain to see that none is.
    fn not_finite(&mut self, value: H, ty: Type) -> Option<H> {
        if self.is_plainly_finite(value) {
            return None;
        }
        if let Base::Matrix { columns, rows } = ty.base {
            let column = Type::vector(Scalar::Float, rows);
            let columns = self.components(value, columns).into_iter();
            let columns: Vec<H> = columns
                .filter_map(|value| self.not_finite(value, column))
                .collect();
            let columns = columns.into_iter();
            return columns.reduce(|a, b| self.binary(BinaryOperator::LogicalOr, a, b));
        }
        let size = ty.vector_size().expect("floats have components");
        let bits = self.cast(value, ScalarKind::Uint, None);
        let exponent = self.uint(0x7f80_0000);
        let exponent = self.splat(exponent, size);
        let own = self.binary(BinaryOperator::And, bits, exponent);
        let is_full = self.binary(BinaryOperator::Equal, own, exponent);
        Some(self.any(is_full, size))
    }

    fn is_plainly_finite(&self, value: H) -> bool {
        match &self.function.expressions[value] {
            Expression::Literal(Literal::F32(value)) => value.is_finite(),
            Expression::ZeroValue(_) => true,
            Expression::Splat { value, .. } => self.is_plainly_finite(*value),
            Expression::Compose { components, .. } => components
                .iter()
                .all(|&value| self.is_plainly_finite(value)),
            _ => false,
        }
    }
}

fn is_arithmetic(op: BinaryOp) -> bool {
    matches!(
        op,
        BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide
    )
}

/// Whether a function of finite operands may be infinite, or no number.
fn makes_infinity(builtin: B) -> bool {
    matches!(
        builtin,
        B::Tan
            | B::Sinh
            | B::Cosh
            | B::Atanh
            | B::Acosh
            | B::Asin
            | B::Acos
            | B::Pow
            | B::Exp
            | B::Exp2
            | B::Log
            | B::Log2
            | B::Sqrt
            | B::InverseSqrt
            | B::Mod
            | B::Mix
            | B::SmoothStep
            | B::Length
            | B::Distance
            | B::Dot
            | B::Cross
            | B::Normalize
            | B::Reflect
            | B::Refract
            | B::MatrixCompMult
            | B::OuterProduct
            | B::Determinant
            | B::Inverse
    )
}

/// Whether a function's result is not finite if this operand is not.
fn hands_on(builtin: B, operand: usize) -> bool {
    match builtin {
        B::Mod => operand == 0,
        B::Sqrt
        | B::Mix
        | B::Length
        | B::Distance
        | B::Dot
        | B::Cross
        | B::Normalize
        | B::Reflect
        | B::MatrixCompMult
        | B::OuterProduct => true,
        _ => false,
    }
}
