//! Arithmetic on scalars and vectors, compact or expanded ([`Arithmetic`] says why there are two).

use naga::{BinaryOperator, Expression, Literal, MathFunction, ScalarKind, UnaryOperator};

use super::function::{Builder, H};
use crate::glsl::types::{Scalar, Type};
use crate::glsl::{Arithmetic, Precision};

impl Builder<'_, '_> {
    /// An operation on two operands of one size.
    pub(super) fn binary(&mut self, op: BinaryOperator, left: H, right: H) -> H {
        use BinaryOperator::{Add, Divide, Multiply, Subtract};
        if op == Divide
            && let Some(reciprocal) = self.reciprocal_of_zero(right)
        {
            return self.binary(Multiply, left, reciprocal);
        }
        if matches!(op, Add | Subtract | Multiply | Divide)
            && let Some(size) = self.expanded(left).or_else(|| self.expanded(right))
        {
            return self.binary_by_component(op, left, right, size);
        }
        let value = self.add(Expression::Binary { op, left, right });
        match op {
            Add | Subtract | Multiply | Divide => self.rounded_if_low(value),
            _ => value,
        }
    }

    /// An operation on two operands of floats, each of this size.
    pub(super) fn binary_of_floats(
        &mut self,
        op: BinaryOperator,
        left: H,
        right: H,
        size: u8,
    ) -> H {
        // To compilers of GLSL a scalar that is added to a vector is used once for each component, and they regroup only
        // what is used once.
        let is_spread =
            |value: H| matches!(self.function.expressions[value], Expression::Splat { .. });
        let is_sum = matches!(op, BinaryOperator::Add | BinaryOperator::Subtract);
        let is_expanded = self.context.options.arithmetic == Arithmetic::Expanded;
        if is_expanded && is_sum && size > 1 && (is_spread(left) || is_spread(right)) {
            return self.binary_by_component(op, left, right, size);
        }
        self.binary(op, left, right)
    }

    /// The other operand, if one is seen to change nothing: compilers drop these first of all, but not where they hide in
    /// a vector.
    fn neutral(&self, op: BinaryOperator, left: H, right: H) -> Option<H> {
        use BinaryOperator::{Add, Divide, Multiply, Subtract};
        let [first, second] = [left, right].map(|value| self.known(value));
        match (op, first, second) {
            (Multiply | Divide, _, Some(1.0)) | (Add | Subtract, _, Some(0.0)) => Some(left),
            (Multiply, Some(1.0), _) | (Add, Some(0.0), _) => Some(right),
            _ => None,
        }
    }

    fn binary_by_component(&mut self, op: BinaryOperator, left: H, right: H, size: u8) -> H {
        let components = (0..size).map(|i| {
            let [left, right] = [left, right].map(|value| self.component(value, i));
            self.neutral(op, left, right).unwrap_or_else(|| {
                let value = self.add(Expression::Binary { op, left, right });
                self.rounded_if_low(value)
            })
        });
        let components = components.collect();
        self.compose(Type::vector(Scalar::Float, size), components)
    }

    /// Infinity, if a divisor is a zero that compilers see. Some make anything of such a division, even
    /// something else in each run, but a product with infinity is what it should be.
    fn reciprocal_of_zero(&mut self, divisor: H) -> Option<H> {
        let (zero, size) = match self.function.expressions[divisor] {
            Expression::Splat { size, value } => (self.known(value)?, size as u8),
            Expression::ZeroValue(ty) => match self.context.module.types[ty].inner {
                naga::TypeInner::Vector { size, scalar } if scalar.kind == ScalarKind::Float => {
                    (0.0, size as u8)
                }
                _ => return None,
            },
            _ => (self.known(divisor)?, 1),
        };
        (zero == 0.0).then(|| {
            let infinity = self.float(f64::INFINITY.copysign(zero));
            self.splat(infinity, size)
        })
    }

    /// The number that all components of a value are seen to be.
    pub(super) fn known(&self, value: H) -> Option<f64> {
        match self.function.expressions[value] {
            Expression::Literal(Literal::F32(number)) => Some(number.into()),
            Expression::Literal(Literal::F64(number)) => Some(number),
            Expression::Splat { value, .. } => self.known(value),
            _ => None,
        }
    }

    /// Whether arithmetic is written in small steps. In double precision it is anyway: drivers have
    /// fewer functions there.
    pub(super) fn is_expanded(&self) -> bool {
        let options = self.context.options;
        options.arithmetic == Arithmetic::Expanded || options.precision == Precision::Double
    }

    /// The size of a constant vector with which to compute component by component: compilers of GLSL
    /// take vectors apart before they move constants about.
    pub(super) fn expanded(&self, value: H) -> Option<u8> {
        if self.context.options.arithmetic != Arithmetic::Expanded {
            return None;
        }
        let expressions = &self.function.expressions;
        let is_float = |value: &H| {
            use Literal::{F32, F64};
            matches!(expressions[*value], Expression::Literal(F32(_) | F64(_)))
        };
        match &expressions[value] {
            Expression::Splat { size, value } => is_float(value).then_some(*size as u8),
            Expression::Compose { ty, components } => match self.context.module.types[*ty].inner {
                naga::TypeInner::Vector { size, .. } => {
                    let are_floats = components.iter().all(is_float);
                    are_floats.then_some(size as u8)
                }
                _ => None,
            },
            _ => None,
        }
    }

    /// A component of a vector.
    fn component(&mut self, vector: H, index: u8) -> H {
        match &self.function.expressions[vector] {
            Expression::Splat { value, .. } => *value,
            Expression::Compose { components, .. } if self.expanded(vector).is_some() => {
                components[usize::from(index)]
            }
            _ => self.part(vector, index.into()),
        }
    }

    /// A scalar or vector times a scalar.
    pub(super) fn scale(&mut self, value: H, factor: H) -> H {
        match self.expanded(value) {
            Some(size) => {
                let factor = self.splat(factor, size);
                self.product(value, factor)
            }
            None => self.product(value, factor),
        }
    }

    pub(super) fn sum(&mut self, left: H, right: H) -> H {
        self.binary(BinaryOperator::Add, left, right)
    }

    pub(super) fn difference(&mut self, left: H, right: H) -> H {
        self.binary(BinaryOperator::Subtract, left, right)
    }

    pub(super) fn product(&mut self, left: H, right: H) -> H {
        self.binary(BinaryOperator::Multiply, left, right)
    }

    pub(super) fn quotient(&mut self, left: H, right: H) -> H {
        self.binary(BinaryOperator::Divide, left, right)
    }

    pub(super) fn negate(&mut self, expr: H) -> H {
        let op = UnaryOperator::Negate;
        self.add(Expression::Unary { op, expr })
    }

    /// A dot product. Compilers of GLSL add up its terms from the last to the first.
    pub(super) fn dot(&mut self, left: H, right: H, size: u8) -> H {
        if !self.is_expanded() {
            return self.math(MathFunction::Dot, &[left, right]);
        }
        // Compilers of GLSL see that terms are alike before they move a sign.
        for (negated, other) in [(left, right), (right, left)] {
            if let Expression::Unary { expr, .. } = self.function.expressions[negated] {
                let positive = self.dot(expr, other, size);
                return self.negate(positive);
            }
        }
        let terms = self.product(left, right);
        let last = self.part(terms, u32::from(size) - 1);
        (0..size - 1).rev().fold(last, |sum, i| {
            let term = self.part(terms, i.into());
            self.sum(sum, term)
        })
    }
}
