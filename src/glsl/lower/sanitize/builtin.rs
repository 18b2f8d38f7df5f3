//! Built-in functions that can go wrong, §8.1 to §8.4.

use naga::{BinaryOperator, MathFunction};

use super::{Form, Hazard};
use crate::glsl::builtins::Builtin as B;
use crate::glsl::lower::expression::Typed;
use crate::glsl::lower::function::{Builder, H};
use crate::glsl::types::{Scalar, Type};

use BinaryOperator::{Equal, Greater, GreaterEqual, Less, LessEqual};

impl Builder<'_, '_> {
    /// Looks at what a built-in function is asked for; whether it goes wrong, if that is known.
    pub fn check_arguments(&mut self, builtin: B, operands: &[Typed]) -> Option<H> {
        if !self.is_sanitized() {
            return None;
        }
        let hazard = match builtin {
            B::Mod => Hazard::DivisionByZero,
            B::Pow => Hazard::NegativeBase,
            B::Normalize => Hazard::ZeroVector,
            B::SmoothStep | B::Clamp => Hazard::Limits,
            B::Sqrt
            | B::InverseSqrt
            | B::Log
            | B::Log2
            | B::Asin
            | B::Acos
            | B::Acosh
            | B::Atanh => Hazard::Domain,
            B::Atan if operands.len() == 2 => Hazard::Domain,
            _ => return None,
        };
        if self.is_proper(builtin, operands) {
            return None;
        }
        let types: Vec<Type> = operands.iter().map(|operand| operand.ty).collect();
        let here = self.site(hazard, Form::Call(builtin), &types);
        let condition = self.goes_wrong(builtin, operands);
        self.note(here, here.number, condition, operands);
        Some(condition)
    }

    /// Whether constants among the operands show that nothing goes wrong.
    fn is_proper(&self, builtin: B, operands: &[Typed]) -> bool {
        let known = |index: usize| self.known(operands[index].value);
        match builtin {
            B::Mod => known(1).is_some_and(|divisor| divisor != 0.0),
            B::Clamp => matches!((known(1), known(2)), (Some(low), Some(high)) if low <= high),
            B::SmoothStep => matches!((known(0), known(1)), (Some(low), Some(high)) if low < high),
            _ => false,
        }
    }

    fn goes_wrong(&mut self, builtin: B, operands: &[Typed]) -> H {
        let sizes = operands
            .iter()
            .filter_map(|operand| operand.ty.vector_size());
        let size = sizes.max().unwrap_or(1);
        let first = operands[0];
        let scalar = first.ty.scalar().unwrap_or(Scalar::Float);
        let [zero, one] = [0, 1].map(|number| {
            let number = self.number(number, scalar);
            self.splat(number, size)
        });
        let values: Vec<H> = operands
            .iter()
            .map(|&operand| self.broadcast(operand, size))
            .collect();
        let x = values[0];
        let condition = match builtin {
            B::Mod => self.binary(Equal, values[1], zero),
            B::Sqrt => self.binary(Less, x, zero),
            B::InverseSqrt | B::Log | B::Log2 => self.binary(LessEqual, x, zero),
            B::Acosh => self.binary(Less, x, one),
            B::Asin | B::Acos | B::Atanh => {
                let magnitude = self.math(MathFunction::Abs, &[x]);
                let op = if builtin == B::Atanh {
                    GreaterEqual
                } else {
                    Greater
                };
                self.binary(op, magnitude, one)
            }
            B::Pow => {
                let is_negative = self.binary(Less, x, zero);
                let is_zero = self.binary(Equal, x, zero);
                let is_not_positive = self.binary(LessEqual, values[1], zero);
                let both = self.binary(BinaryOperator::And, is_zero, is_not_positive);
                self.binary(BinaryOperator::InclusiveOr, is_negative, both)
            }
            B::Atan => {
                let [y, x] = [x, values[1]].map(|value| self.binary(Equal, value, zero));
                self.binary(BinaryOperator::And, y, x)
            }
            B::SmoothStep => self.binary(GreaterEqual, x, values[1]),
            B::Clamp => self.binary(Greater, values[1], values[2]),
            B::Normalize => {
                let square = self.dot_of(x, x, first.ty);
                let zero = self.float(0.0);
                return self.binary(Equal, square, zero);
            }
            _ => unreachable!("{builtin:?} has no hazard"),
        };
        self.any(condition, size)
    }
}
