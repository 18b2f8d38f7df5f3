//! Operators, indices and conversions that can go wrong.

use naga::{BinaryOperator, Literal, RelationalFunction, ScalarKind};

use super::{Form, Hazard};
use crate::glsl::hir::{BinaryOp, Extent};
use crate::glsl::lower::expression::Typed;
use crate::glsl::lower::function::{Builder, H};
use crate::glsl::types::{Base, Scalar, Type};

impl Builder<'_, '_> {
    /// Looks at what an operator is given; whether it goes wrong, if that is known.
    pub fn check_operands(&mut self, op: BinaryOp, left: Typed, right: Typed) -> Option<H> {
        if !self.is_sanitized() {
            return None;
        }
        let scalar = left.ty.scalar()?;
        let hazard = match (op, scalar) {
            (BinaryOp::Divide, Scalar::Float) => Hazard::DivisionByZero,
            (BinaryOp::Divide | BinaryOp::Remainder, _) => Hazard::IntegerDivision,
            (BinaryOp::ShiftLeft | BinaryOp::ShiftRight, _) => Hazard::Shift,
            _ => return None,
        };
        if self.is_harmless(hazard, right) {
            return None;
        }
        let here = self.site(hazard, Form::Operator(op), &[left.ty, right.ty]);
        let condition = match hazard {
            Hazard::DivisionByZero => self.is_zero(right),
            Hazard::IntegerDivision => self.divides_badly(left, right, scalar),
            _ => self.shifts_too_far(right),
        };
        self.note(here, here.number, condition, &[left, right]);
        Some(condition)
    }

    /// Whether a right operand is a constant that nothing goes wrong with.
    fn is_harmless(&self, hazard: Hazard, right: Typed) -> bool {
        let size = match right.ty.base {
            Base::Scalar(_) => 1,
            Base::Vector(_, size) => size,
            _ => return false,
        };
        let Some(literals) = self.literals(right.value, size) else {
            return false;
        };
        literals.iter().all(|literal| match *literal {
            Literal::F32(value) => value != 0.0,
            Literal::I32(value) if hazard == Hazard::Shift => (0..32).contains(&value),
            Literal::U32(value) if hazard == Hazard::Shift => value < 32,
            Literal::I32(value) => value != 0 && value != -1,
            Literal::U32(value) => value != 0,
            _ => false,
        })
    }

    /// Whether any component is zero.
    pub(super) fn is_zero(&mut self, operand: Typed) -> H {
        let Typed { value, ty } = operand;
        if let Base::Matrix { columns, rows } = ty.base {
            let ty = Type::vector(Scalar::Float, rows);
            let columns = self.components(value, columns);
            let zeros: Vec<H> = columns
                .into_iter()
                .map(|value| self.is_zero(Typed { value, ty }))
                .collect();
            let any = zeros
                .into_iter()
                .reduce(|a, b| self.binary(BinaryOperator::LogicalOr, a, b));
            return any.expect("matrices have columns");
        }
        let zero = self.zero(ty);
        let is_zero = self.binary(BinaryOperator::Equal, value, zero);
        self.any(is_zero, ty.vector_size().unwrap_or(1))
    }

    fn divides_badly(&mut self, left: Typed, right: Typed, scalar: Scalar) -> H {
        let by_zero = self.is_zero(right);
        if scalar == Scalar::Uint {
            return by_zero;
        }
        let sizes = [left.ty, right.ty].map(|ty| ty.vector_size().unwrap_or(1));
        let size = sizes[0].max(sizes[1]);
        let [left, right] = [left, right].map(|operand| self.broadcast(operand, size));
        let [lowest, minus_one] = [i32::MIN, -1].map(|value| {
            let value = self.int(value);
            self.splat(value, size)
        });
        let is_lowest = self.binary(BinaryOperator::Equal, left, lowest);
        let is_minus_one = self.binary(BinaryOperator::Equal, right, minus_one);
        let overflows = self.binary(BinaryOperator::And, is_lowest, is_minus_one);
        let overflows = self.any(overflows, size);
        self.binary(BinaryOperator::LogicalOr, by_zero, overflows)
    }

    fn shifts_too_far(&mut self, amount: Typed) -> H {
        // A negative number is a large one without its sign.
        self.is_beyond(amount, 32)
    }

    /// Whether any component of an integer is negative, or not below a limit.
    fn is_beyond(&mut self, operand: Typed, limit: u32) -> H {
        let size = operand.ty.vector_size().unwrap_or(1);
        let bits = match operand.ty.scalar() {
            Some(Scalar::Int) => self.cast(operand.value, ScalarKind::Uint, None),
            _ => operand.value,
        };
        let limit = self.uint(limit);
        let limit = self.splat(limit, size);
        let is_beyond = self.binary(BinaryOperator::GreaterEqual, bits, limit);
        self.any(is_beyond, size)
    }

    /// Whether a condition holds for any component.
    pub(super) fn any(&mut self, condition: H, size: u8) -> H {
        match size {
            1 => condition,
            _ => self.relational(RelationalFunction::Any, condition),
        }
    }

    /// Looks at an index that is not known to be in range.
    pub fn check_index(&mut self, index: Typed, count: u32, at: Extent) {
        if self.is_sanitized() {
            let here = self.site_at(at, Hazard::Index, Form::Index(count), &[index.ty]);
            let is_beyond = self.is_beyond(index, count);
            self.note(here, here.number, is_beyond, &[index]);
        }
    }

    /// Looks at the place of a texel, in a level of a texture whose size is given.
    pub fn check_texel(&mut self, at: Typed, size: H) {
        if self.is_sanitized() {
            let here = self.site(Hazard::Index, Form::Texel, &[at.ty]);
            let bits = self.cast(at.value, ScalarKind::Uint, None);
            let is_beyond = self.binary(BinaryOperator::GreaterEqual, bits, size);
            let is_beyond = self.any(is_beyond, at.ty.vector_size().unwrap_or(1));
            self.note(here, here.number, is_beyond, &[at]);
        }
    }

    /// Looks at a conversion to an integer: §5.4.1 leaves open what comes of a number that does not fit, and
    /// of a negative one for `uint`.
    pub fn check_conversion(&mut self, operand: Typed, to: Scalar) {
        if !self.is_sanitized() || operand.ty.scalar() != Some(Scalar::Float) {
            return;
        }
        let (least, end) = match to {
            Scalar::Int => (f64::from(i32::MIN), -f64::from(i32::MIN)),
            Scalar::Uint => (0.0, f64::from(u32::MAX) + 1.0),
            _ => return,
        };
        if let Some(known) = self.known(operand.value)
            && (least..end).contains(&known)
        {
            return;
        }
        let here = self.site(Hazard::Conversion, Form::Conversion(to), &[operand.ty]);
        let size = operand.ty.vector_size().unwrap_or(1);
        let [least, end] = [least, end].map(|limit| self.constant_of(limit, operand.ty));
        let reaches = self.binary(BinaryOperator::GreaterEqual, operand.value, least);
        let is_below = self.binary(BinaryOperator::Less, operand.value, end);
        let fits = self.binary(BinaryOperator::And, reaches, is_below);
        // What is no number does not fit either.
        let exceeds = self.not(fits);
        let exceeds = self.any(exceeds, size);
        self.note(here, here.number, exceeds, &[operand]);
    }
}
