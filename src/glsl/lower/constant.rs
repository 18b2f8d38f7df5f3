//! Constants: as literals where they are used, as variables where an index picks from them.

use naga::{AddressSpace, Expression, Handle, Literal, Span};

use super::context::Context;
use super::function::{Builder, H};
use crate::glsl::Precision;
use crate::glsl::arena::Id;
use crate::glsl::hir::{Constant, Value, value_count};
use crate::glsl::types::{Base, Type};

/// More components than this do not go into the code: drivers take seconds for 256 of them and
/// minutes for 1,024.
pub(super) const TABLE_SIZE: u32 = 64;

/// A constant from some value on; how many belong to it, its type tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Part {
    pub constant: Id<Constant>,
    pub start: u32,
}

impl Part {
    pub fn whole(constant: Id<Constant>) -> Self {
        Part { constant, start: 0 }
    }

    /// The part that begins so many values later.
    pub fn from(self, start: u32) -> Self {
        Part {
            start: self.start + start,
            ..self
        }
    }
}

impl<'a> Context<'a> {
    pub fn values(&self, part: Part, ty: Type) -> &'a [Value] {
        let hir = self.hir;
        let count = value_count(&hir.structs, ty) as usize;
        &hir.constants.get(part.constant)[part.start as usize..][..count]
    }

    /// Whether a constant array is read from the buffer when an index picks from it.
    pub fn needs_table(&self, part: Part, ty: Type) -> bool {
        let values = self.values(part, ty);
        values.len() > TABLE_SIZE as usize || !values.iter().all(|&value| self.is_finite(value))
    }

    fn is_finite(&self, value: Value) -> bool {
        match (value, self.options.precision) {
            (Value::Float(value), Precision::Single) => (value as f32).is_finite(),
            (Value::Float(value), Precision::Double) => value.is_finite(),
            _ => true,
        }
    }

    /// A constant array as a variable that no one changes.
    pub fn constant_array(&mut self, part: Part, ty: Type) -> Handle<naga::GlobalVariable> {
        if let Some(&known) = self.arrays.get(&(part, ty)) {
            return known;
        }
        let variable = naga::GlobalVariable {
            name: Some("constants".to_owned()),
            space: AddressSpace::Private,
            binding: None,
            ty: self.ty(ty),
            init: self.global_expression(part, ty),
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let variable = self
            .module
            .global_variables
            .append(variable, Span::UNDEFINED);
        self.arrays.insert((part, ty), variable);
        variable
    }

    /// A constant as what a global variable begins with, if naga and drivers can bear it.
    pub fn global_expression(&mut self, part: Part, ty: Type) -> Option<Handle<Expression>> {
        if self.needs_table(part, ty) {
            return None;
        }
        let mut values = self.values(part, ty);
        Some(self.add_global_expression(&mut values, ty))
    }

    fn add_global_expression(&mut self, values: &mut &[Value], ty: Type) -> Handle<Expression> {
        let mut components = Vec::new();
        for part in parts(self, ty) {
            components.push(self.add_global_expression(values, part));
        }
        let expression = if components.is_empty() {
            let (first, rest) = values.split_first().expect("a constant has all its values");
            *values = rest;
            Expression::Literal(self.literal(*first))
        } else {
            let ty = self.ty(ty);
            Expression::Compose { ty, components }
        };
        let expressions = &mut self.module.global_expressions;
        expressions.append(expression, Span::UNDEFINED)
    }

    fn literal(&self, value: Value) -> Literal {
        match (value, self.options.precision) {
            (Value::Float(value), Precision::Single) => Literal::F32(value as f32),
            (Value::Float(value), Precision::Double) => Literal::F64(value),
            (Value::Int(value), _) => Literal::I32(value),
            (Value::Uint(value), _) => Literal::U32(value),
            (Value::Bool(value), _) => Literal::Bool(value),
        }
    }
}

/// What a value of some type is composed of; nothing for a scalar.
pub(super) fn parts(context: &Context<'_>, ty: Type) -> Vec<Type> {
    match (ty.array, ty.base) {
        (Some(length), _) => vec![ty.element(); length.get() as usize],
        (None, Base::Struct(id)) => {
            let fields = context.hir.structs[id].fields.iter();
            fields.map(|field| field.ty).collect()
        }
        (None, Base::Scalar(_)) => Vec::new(),
        (None, _) => vec![super::place::element_type(ty); super::place::count(ty) as usize],
    }
}

impl Builder<'_, '_> {
    /// A constant's value.
    pub(super) fn constant(&mut self, part: Part, ty: Type) -> H {
        if ty.is_array() {
            if self.context.needs_table(part, ty) {
                let copy = self.acquire(ty);
                self.store_constant(copy, part, ty);
                let value = self.load(copy);
                self.release(ty, copy);
                return value;
            }
            let array = self.context.constant_array(part, ty);
            let array = self.global(array);
            return self.load(array);
        }
        let values = self.context.values(part, ty);
        if !ty.is_scalar() && values.iter().all(|&value| is_zero(value)) {
            return self.zero(ty);
        }
        match ty.base {
            Base::Scalar(_) => self.constant_scalar(values[0]),
            Base::Vector(_, size) if values.iter().all(|&value| is_same(value, values[0])) => {
                let value = self.constant_scalar(values[0]);
                self.splat(value, size)
            }
            _ => {
                let mut components = Vec::new();
                let mut start = 0;
                for component in parts(self.context, ty) {
                    components.push(self.constant(part.from(start), component));
                    start += value_count(&self.context.hir.structs, component);
                }
                self.compose(ty, components)
            }
        }
    }

    fn constant_scalar(&mut self, value: Value) -> H {
        match value {
            Value::Float(value) => self.float(value),
            Value::Int(value) => self.int(value),
            Value::Uint(value) => self.uint(value),
            Value::Bool(value) => self.bool(value),
        }
    }

    /// Sets a variable to a constant.
    pub(super) fn store_constant(&mut self, pointer: H, part: Part, ty: Type) {
        if ty.is_array() && self.context.needs_table(part, ty) {
            let element = ty.element();
            let start = self.context.table(part, ty);
            let step = self.context.words(element);
            self.fill(pointer, ty, |builder, index| {
                let step = builder.uint(step);
                let at = builder.product(index, step);
                builder.load_table(at, start, element)
            });
        } else {
            let value = self.constant(part, ty);
            self.store(pointer, value);
        }
    }
}

fn is_zero(value: Value) -> bool {
    match value {
        Value::Float(value) => value.to_bits() == 0,
        Value::Int(value) => value == 0,
        Value::Uint(value) => value == 0,
        Value::Bool(value) => !value,
    }
}

fn is_same(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Float(a), Value::Float(b)) => a.to_bits() == b.to_bits(),
        (Value::Int(a), Value::Int(b)) => a == b,
        (Value::Uint(a), Value::Uint(b)) => a == b,
        (Value::Bool(a), Value::Bool(b)) => a == b,
        _ => false,
    }
}
