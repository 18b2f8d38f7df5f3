//! A call of a built-in function, component by component.

use super::real::Real;
use super::{Operand, float};
use crate::glsl::hir::Value;
use crate::glsl::types::{Base, Type};

/// A call whose arguments are constant.
pub(super) struct Call<'a> {
    arguments: &'a [Operand<'a>],
    size: usize,
    /// The arithmetic of floats.
    pub(super) real: Real,
}

impl<'a> Call<'a> {
    pub(super) fn new(arguments: &'a [Operand<'a>], result: Type, real: Real) -> Self {
        let size = match result.base {
            Base::Vector(_, size) => size.into(),
            Base::Matrix { columns, rows } => usize::from(columns) * usize::from(rows),
            Base::Void | Base::Scalar(_) | Base::Struct(_) | Base::Sampler(_) => 1,
        };
        Call {
            arguments,
            size,
            real,
        }
    }

    /// How many arguments there are.
    pub(super) fn count(&self) -> usize {
        self.arguments.len()
    }

    /// An argument.
    pub(super) fn argument(&self, argument: usize) -> Operand<'a> {
        self.arguments[argument]
    }

    /// A component of an argument; a scalar stands for all components.
    pub(super) fn value(&self, argument: usize, component: usize) -> Value {
        match self.arguments[argument].values {
            [only] => *only,
            values => values[component],
        }
    }

    /// A component that is a `float`.
    pub(super) fn float(&self, argument: usize, component: usize) -> f64 {
        float(self.value(argument, component))
    }

    /// The components of an argument that is a `float` or a vector of floats.
    pub(super) fn floats(&self, argument: usize) -> impl Iterator<Item = f64> + Clone + use<'a> {
        self.arguments[argument].values.iter().copied().map(float)
    }

    /// The result whose every component comes from the arguments' components at the same place.
    pub(super) fn each(&self, component: impl Fn(usize) -> Value) -> Vec<Value> {
        (0..self.size).map(component).collect()
    }

    /// The same for floats; the value is rounded.
    pub(super) fn each_float(&self, component: impl Fn(usize) -> f64) -> Vec<Value> {
        self.each(|i| Value::Float(self.real.round(component(i))))
    }

    /// A function of one `float`, for each component.
    pub(super) fn map(&self, function: impl Fn(f64) -> f64) -> Vec<Value> {
        self.each_float(|i| function(self.float(0, i)))
    }

    /// A function of two floats, for each component.
    pub(super) fn map2(&self, function: impl Fn(f64, f64) -> f64) -> Vec<Value> {
        self.each_float(|i| function(self.float(0, i), self.float(1, i)))
    }

    /// A function of three floats, for each component.
    pub(super) fn map3(&self, function: impl Fn(f64, f64, f64) -> f64) -> Vec<Value> {
        self.each_float(|i| function(self.float(0, i), self.float(1, i), self.float(2, i)))
    }

    /// A single `float`.
    pub(super) fn one(&self, value: f64) -> Vec<Value> {
        vec![Value::Float(self.real.round(value))]
    }
}
