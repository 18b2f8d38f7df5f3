//! The smallest steps: appending expressions and statements to a naga function.
//!
//! Most expressions must be introduced by an `Emit` statement before they are used; literals,
//! variables and arguments must not. Expressions gather in a pending range, which every other
//! statement closes first.

use naga::{
    Expression, Literal, MathFunction, ScalarKind, Statement, SwizzleComponent, UnaryOperator,
};

use super::function::{Builder, H};
use super::types::size;
use crate::glsl::Precision;
use crate::glsl::types::{Scalar, Type};

/// How many operations may stand within each other before they are split. Writers of text recurse on
/// them, on whatever stack the caller has.
const MAX_HEIGHT: u16 = 256;

impl Builder<'_, '_> {
    /// Appends an expression.
    pub(super) fn add(&mut self, expression: Expression) -> H {
        if expression.needs_pre_emit() || matches!(expression, Expression::CallResult(_)) {
            self.flush();
        } else {
            self.pending.get_or_insert(self.function.expressions.len());
        }
        self.context.operations += 1;
        let mut height = self.height_of_operands(&expression).saturating_add(1);
        // It may be a pointer, which has no name in most languages.
        let is_part = matches!(
            expression,
            Expression::Access { .. } | Expression::AccessIndex { .. }
        );
        let value = self.function.expressions.append(expression, self.span);
        if height > MAX_HEIGHT && !is_part {
            // What has a name is written as a statement of its own.
            let names = &mut self.function.named_expressions;
            names.entry(value).or_insert_with(|| "part".to_owned());
            height = 0;
        }
        self.room.heights.push(height);
        value
    }

    /// How many operations stand within each other below an operation.
    fn height_of_operands(&self, expression: &Expression) -> u16 {
        let height = |value: H| self.room.heights[value.index()];
        match *expression {
            Expression::Access { base, index } => height(base).max(height(index)),
            Expression::AccessIndex { base: value, .. }
            | Expression::Splat { value, .. }
            | Expression::Swizzle { vector: value, .. }
            | Expression::Load { pointer: value }
            | Expression::Unary { expr: value, .. }
            | Expression::Derivative { expr: value, .. }
            | Expression::Relational {
                argument: value, ..
            }
            | Expression::As { expr: value, .. } => height(value),
            Expression::Compose { ref components, .. } => {
                let heights = components.iter().map(|&component| height(component));
                heights.max().unwrap_or(0)
            }
            Expression::Binary { left, right, .. } => height(left).max(height(right)),
            Expression::Select {
                condition,
                accept,
                reject,
            } => height(condition).max(height(accept)).max(height(reject)),
            Expression::Math {
                arg,
                arg1,
                arg2,
                arg3,
                ..
            } => {
                let others = [arg1, arg2, arg3].into_iter().flatten().map(height);
                others.fold(height(arg), u16::max)
            }
            // The others have a statement of their own, or no operands.
            _ => 0,
        }
    }

    fn flush(&mut self) {
        if let Some(start) = self.pending.take() {
            let range = self.function.expressions.range_from(start);
            let span = self.span;
            self.block().push(Statement::Emit(range), span);
        }
    }

    fn block(&mut self) -> &mut naga::Block {
        self.blocks.last_mut().expect("a block is open")
    }

    /// Appends a statement.
    pub(super) fn push(&mut self, statement: Statement) {
        self.flush();
        let span = self.span;
        self.block().push(statement, span);
    }

    /// Begins a nested block.
    pub(super) fn open(&mut self) {
        self.flush();
        self.blocks.push(naga::Block::new());
        self.deepest = self.deepest.max(self.blocks.len());
    }

    /// Ends the innermost block.
    pub(super) fn close(&mut self) -> naga::Block {
        self.flush();
        self.blocks.pop().expect("a block is open")
    }

    /// An expression that is known everywhere, so that one of each kind is enough.
    fn shared(&mut self, key: Shared, expression: Expression) -> H {
        if let Some(&known) = self.room.shared.get(&key) {
            return known;
        }
        debug_assert!(
            expression.needs_pre_emit(),
            "others are known in their block"
        );
        let handle = self.add(expression);
        self.room.shared.insert(key, handle);
        handle
    }

    pub(super) fn literal(&mut self, literal: Literal) -> H {
        let key = match literal {
            Literal::F64(value) => Shared::Double(value.to_bits()),
            Literal::F32(value) => Shared::Float(value.to_bits()),
            Literal::I32(value) => Shared::Int(value),
            Literal::U32(value) => Shared::Uint(value),
            Literal::Bool(value) => Shared::Bool(value),
            _ => unreachable!("GLSL has no such literal"),
        };
        self.shared(key, Expression::Literal(literal))
    }

    /// A `float`. naga has no literals for infinity and for what is no number.
    pub(super) fn float(&mut self, value: f64) -> H {
        let single = value as f32;
        match self.context.options.precision {
            Precision::Single if single.is_finite() => self.literal(Literal::F32(single)),
            Precision::Double if value.is_finite() => self.literal(Literal::F64(value)),
            precision => {
                let bits = self.uint(single.to_bits());
                let float = self.cast(bits, ScalarKind::Float, None);
                match precision {
                    Precision::Single => float,
                    Precision::Double => self.cast(float, ScalarKind::Float, Some(8)),
                }
            }
        }
    }

    pub(super) fn int(&mut self, value: i32) -> H {
        self.literal(Literal::I32(value))
    }

    pub(super) fn uint(&mut self, value: u32) -> H {
        self.literal(Literal::U32(value))
    }

    pub(super) fn bool(&mut self, value: bool) -> H {
        self.literal(Literal::Bool(value))
    }

    /// A number of some scalar type.
    pub(super) fn number(&mut self, value: i32, scalar: Scalar) -> H {
        match scalar {
            Scalar::Float => self.float(f64::from(value)),
            Scalar::Int => self.int(value),
            Scalar::Uint => self.uint(value as u32),
            Scalar::Bool => self.bool(value != 0),
        }
    }

    /// The value of which every component is zero.
    pub(super) fn zero(&mut self, ty: Type) -> H {
        if let Some(scalar) = ty.scalar()
            && ty.is_scalar()
        {
            return self.number(0, scalar);
        }
        let ty = self.context.ty(ty);
        self.shared(Shared::Zero(ty), Expression::ZeroValue(ty))
    }

    pub(super) fn global(&mut self, variable: naga::Handle<naga::GlobalVariable>) -> H {
        self.shared(
            Shared::Global(variable),
            Expression::GlobalVariable(variable),
        )
    }

    pub(super) fn not(&mut self, expr: H) -> H {
        let op = UnaryOperator::LogicalNot;
        self.add(Expression::Unary { op, expr })
    }

    pub(super) fn math(&mut self, fun: MathFunction, operands: &[H]) -> H {
        if fun == MathFunction::InverseSqrt && self.is_low {
            return self.low_inverse_root(operands[0]);
        }
        let operand = |i| operands.get(i).copied();
        let value = self.add(Expression::Math {
            fun,
            arg: operands[0],
            arg1: operand(1),
            arg2: operand(2),
            arg3: operand(3),
        });
        self.rounded_if_low(value)
    }

    /// Converts to so many bytes, or takes the bits as they are.
    pub(super) fn cast(&mut self, expr: H, kind: ScalarKind, convert: Option<u8>) -> H {
        self.add(Expression::As {
            expr,
            kind,
            convert,
        })
    }

    /// A GLSL conversion of a scalar or vector.
    pub(super) fn convert(&mut self, expr: H, from: Scalar, to: Scalar) -> H {
        if from == to {
            return expr;
        }
        // As in `vec2(x, 0)`, which reads better converted.
        if to == Scalar::Float {
            match self.function.expressions[expr] {
                Expression::Literal(Literal::I32(value)) => return self.float(value.into()),
                Expression::Literal(Literal::U32(value)) => return self.float(value.into()),
                _ => {}
            }
        }
        let to = self.context.scalar(to);
        self.cast(expr, to.kind, Some(to.width))
    }

    /// A `float` in 32 bits, whatever the precision.
    pub(super) fn narrow(&mut self, expr: H) -> H {
        match self.context.options.precision {
            Precision::Single => expr,
            Precision::Double => self.cast(expr, ScalarKind::Float, Some(4)),
        }
    }

    /// A `float` from 32 bits, whatever the precision.
    pub(super) fn widen(&mut self, expr: H) -> H {
        match self.context.options.precision {
            Precision::Single => expr,
            Precision::Double => self.cast(expr, ScalarKind::Float, Some(8)),
        }
    }

    /// A vector of equal components; of one component, the scalar itself.
    pub(super) fn splat(&mut self, value: H, components: u8) -> H {
        match components {
            1 => value,
            _ => self.add(Expression::Splat {
                size: size(components),
                value,
            }),
        }
    }

    pub(super) fn compose(&mut self, ty: Type, mut components: Vec<H>) -> H {
        if ty.is_vector() {
            // Among constants naga's SPIR-V writer takes a zero vector for one component.
            while let Some((at, size)) = self.find_zero_vector(&components) {
                let scalar = ty.scalar().expect("vectors have components");
                let zero = self.number(0, scalar);
                components.splice(at..=at, std::iter::repeat_n(zero, size));
            }
        }
        let ty = self.context.ty(ty);
        self.add(Expression::Compose { ty, components })
    }

    /// Which of some values is a zero vector, and how many components it has.
    fn find_zero_vector(&self, values: &[H]) -> Option<(usize, usize)> {
        values.iter().enumerate().find_map(|(at, &value)| {
            let Expression::ZeroValue(ty) = self.function.expressions[value] else {
                return None;
            };
            match self.context.module.types[ty].inner {
                naga::TypeInner::Vector { size, .. } => Some((at, size as usize)),
                _ => None,
            }
        })
    }

    /// A part of a value, or the pointer to a part, whose place is known.
    pub(super) fn part(&mut self, base: H, index: u32) -> H {
        self.add(Expression::AccessIndex { base, index })
    }

    /// A part of a value, or the pointer to a part.
    pub(super) fn access(&mut self, base: H, index: H) -> H {
        self.add(Expression::Access { base, index })
    }

    /// The components of a vector, or a scalar as its only one.
    pub(super) fn components(&mut self, value: H, count: u8) -> Vec<H> {
        match count {
            1 => vec![value],
            _ => (0..count).map(|i| self.part(value, i.into())).collect(),
        }
    }

    pub(super) fn swizzle(&mut self, vector: H, components: &[u8]) -> H {
        if let [component] = components {
            return self.part(vector, u32::from(*component));
        }
        let mut pattern = [SwizzleComponent::X; 4];
        for (component, &index) in pattern.iter_mut().zip(components) {
            *component = SwizzleComponent::XYZW[usize::from(index)];
        }
        self.add(Expression::Swizzle {
            size: size(components.len() as u8),
            vector,
            pattern,
        })
    }

    pub(super) fn select(&mut self, condition: H, accept: H, reject: H) -> H {
        self.add(Expression::Select {
            condition,
            accept,
            reject,
        })
    }

    pub(super) fn load(&mut self, pointer: H) -> H {
        self.add(Expression::Load { pointer })
    }

    pub(super) fn store(&mut self, pointer: H, value: H) {
        self.push(Statement::Store { pointer, value });
    }

    /// A new variable.
    pub(super) fn variable(&mut self, ty: Type, name: Option<String>) -> H {
        let ty = self.context.ty(ty);
        let variable = naga::LocalVariable {
            name,
            ty,
            init: None,
        };
        let variable = self.function.local_variables.append(variable, self.span);
        self.add(Expression::LocalVariable(variable))
    }
}

/// Names an expression that is known everywhere in a function.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Shared {
    Double(u64),
    Float(u32),
    Int(i32),
    Uint(u32),
    Bool(bool),
    Zero(naga::Handle<naga::Type>),
    Global(naga::Handle<naga::GlobalVariable>),
}
