//! Operators, §5.9. naga's want operands of one type, with few exceptions.

use naga::{BinaryOperator, Expression, Literal, RelationalFunction, ScalarKind};

use super::constant::TABLE_SIZE;
use super::expression::Typed;
use super::function::{Builder, H};
use super::place::{count, element_type};
use crate::glsl::Arithmetic;
use crate::glsl::arena::Id;
use crate::glsl::hir::{BinaryOp, Expr, ExprKind, Extent, Value, value_count};
use crate::glsl::types::{Base, Scalar, Type};

impl Builder<'_, '_> {
    /// Applies an operator but `&&` and `||`.
    pub(super) fn operate(&mut self, op: BinaryOp, left: Typed, right: Typed, at: Extent) -> H {
        match op {
            BinaryOp::Equal => self.equal(left.ty, left.value, right.value),
            BinaryOp::NotEqual => self.not_equal(left.ty, left.value, right.value),
            BinaryOp::Less => self.binary(BinaryOperator::Less, left.value, right.value),
            BinaryOp::Greater => self.binary(BinaryOperator::Greater, left.value, right.value),
            BinaryOp::LessEqual => self.binary(BinaryOperator::LessEqual, left.value, right.value),
            BinaryOp::GreaterEqual => {
                self.binary(BinaryOperator::GreaterEqual, left.value, right.value)
            }
            BinaryOp::LogicalXor => self.binary(BinaryOperator::NotEqual, left.value, right.value),
            BinaryOp::LogicalAnd => {
                self.binary(BinaryOperator::LogicalAnd, left.value, right.value)
            }
            BinaryOp::LogicalOr => self.binary(BinaryOperator::LogicalOr, left.value, right.value),
            BinaryOp::ShiftLeft | BinaryOp::ShiftRight => self.shift(op, left, right),
            BinaryOp::Add
            | BinaryOp::Subtract
            | BinaryOp::Multiply
            | BinaryOp::Divide
            | BinaryOp::Remainder
            | BinaryOp::BitAnd
            | BinaryOp::BitOr
            | BinaryOp::BitXor => {
                if left.ty.is_matrix() || right.ty.is_matrix() {
                    self.matrix_arithmetic(arithmetic(op), left, right)
                } else {
                    self.arithmetic(op, left, right, at)
                }
            }
        }
    }

    /// Arithmetic of scalars and vectors, in any mixture.
    fn arithmetic(&mut self, op: BinaryOp, left: Typed, right: Typed, at: Extent) -> H {
        let sizes = [left.ty, right.ty].map(|ty| ty.vector_size().expect("no matrices here"));
        let scalar = left.ty.scalar().expect("operands are numbers");
        let [mut left, mut right] = [left.value, right.value];
        let size = sizes[0].max(sizes[1]);
        let is_division = matches!(op, BinaryOp::Divide | BinaryOp::Remainder);
        let is_division = is_division && scalar != Scalar::Float;
        let may_be_zero = is_division && self.literals(right, sizes[1]).is_none();
        if is_division {
            right = self.divisor(right, scalar, sizes[1], at);
        }
        // A vector may be scaled as it is, which also reads better. SPIR-V has the vector first then, and compilers go by the
        // order of factors.
        let is_turned = self.context.options.arithmetic == Arithmetic::Expanded && sizes[0] < size;
        let scales = op == BinaryOp::Multiply && scalar == Scalar::Float && !is_turned;
        if !scales || self.meets_constant(left, right) {
            if sizes[0] < size {
                left = self.splat(left, size);
            }
            if sizes[1] < size {
                right = self.splat(right, size);
            }
        }
        match scalar {
            Scalar::Float => self.binary_of_floats(arithmetic(op), left, right, size),
            _ if may_be_zero => self.division(op, left, right, scalar, size),
            _ => self.binary(arithmetic(op), left, right),
        }
    }

    /// An integer division or its remainder. By zero, which GLSL leaves open, it gives what Mesa's drivers do and
    /// Direct3D demands of unsigned numbers: all bits, but 0 for a signed quotient.
    fn division(&mut self, op: BinaryOp, left: H, right: H, scalar: Scalar, size: u8) -> H {
        let result = self.binary(arithmetic(op), left, right);
        let [zero, other] = [0, 1].map(|part| {
            let value = match (part, op, scalar) {
                (1, _, Scalar::Uint) => Literal::U32(u32::MAX),
                (1, BinaryOp::Remainder, _) => Literal::I32(-1),
                (_, _, Scalar::Uint) => Literal::U32(0),
                _ => Literal::I32(0),
            };
            let value = self.literal(value);
            self.splat(value, size)
        });
        let is_zero = self.binary(BinaryOperator::Equal, right, zero);
        self.select(is_zero, other, result)
    }

    /// Whether a product is one with a constant that is to be computed component by component.
    fn meets_constant(&self, left: H, right: H) -> bool {
        let is_constant = |value: H| {
            let expression = &self.function.expressions[value];
            matches!(expression, Expression::Literal(_)) || self.expanded(value).is_some()
        };
        self.context.options.arithmetic == Arithmetic::Expanded
            && (is_constant(left) || is_constant(right))
    }

    /// An integer to divide by. A zero that naga can see would be refused, so it counts as one;
    /// others are for the run-time checks.
    fn divisor(&mut self, divisor: H, scalar: Scalar, size: u8, at: Extent) -> H {
        let Some(literals) = self.literals(divisor, size) else {
            self.context.unguarded.divisions.push(at);
            return divisor;
        };
        if literals.contains(&Literal::I32(-1)) {
            // The lowest number has no negative.
            self.context.unguarded.divisions.push(at);
        }
        if !literals.iter().any(|literal| is_zero(*literal)) {
            return divisor;
        }
        let components = literals
            .into_iter()
            .map(|literal| {
                if is_zero(literal) {
                    self.number(1, scalar)
                } else {
                    self.literal(literal)
                }
            })
            .collect::<Vec<_>>();
        match *components {
            [only] => only,
            _ => self.compose(Type::vector(scalar, size), components),
        }
    }

    /// The components of a value that naga can see are literals.
    pub(super) fn literals(&self, value: H, size: u8) -> Option<Vec<Literal>> {
        let expressions = &self.function.expressions;
        let literal = |value: H| match expressions[value] {
            Expression::Literal(literal) => Some(literal),
            _ => None,
        };
        match &expressions[value] {
            Expression::Literal(literal) => Some(vec![*literal]),
            Expression::ZeroValue(_) => Some(vec![Literal::I32(0); size.into()]),
            Expression::Splat { value, .. } => Some(vec![literal(*value)?; size.into()]),
            Expression::Compose { components, .. } => {
                components.iter().map(|&value| literal(value)).collect()
            }
            _ => None,
        }
    }

    /// Whether an integer division by this needs no check.
    pub(super) fn is_safe_divisor(&self, id: Id<Expr>) -> bool {
        match self.source.exprs[id].kind {
            ExprKind::Constant(constant) => {
                let values = self.context.hir.constants.get(constant);
                !values
                    .iter()
                    .any(|value| matches!(value, Value::Int(0 | -1) | Value::Uint(0)))
            }
            _ => false,
        }
    }

    /// A shift. By how much counts modulo 32, as all machines have it.
    fn shift(&mut self, op: BinaryOp, left: Typed, right: Typed) -> H {
        let size = left.ty.vector_size().expect("only integers are shifted");
        let own = right.ty.vector_size().expect("only by integers");
        let mut amount = match self.function.expressions[right.value] {
            Expression::Literal(Literal::I32(amount)) => self.uint(amount as u32 & 31),
            Expression::Literal(Literal::U32(amount)) => self.uint(amount & 31),
            _ => {
                let amount = match right.ty.scalar() {
                    Some(Scalar::Int) => self.cast(right.value, ScalarKind::Uint, None),
                    _ => right.value,
                };
                let mask = self.uint(31);
                let mask = self.splat(mask, own);
                self.binary(BinaryOperator::And, amount, mask)
            }
        };
        if own < size {
            amount = self.splat(amount, size);
        }
        let op = match op {
            BinaryOp::ShiftLeft => BinaryOperator::ShiftLeft,
            _ => BinaryOperator::ShiftRight,
        };
        self.binary(op, left.value, amount)
    }

    /// Whether all components are equal.
    fn equal(&mut self, ty: Type, left: H, right: H) -> H {
        match (ty.array, ty.base) {
            (None, Base::Scalar(_)) => self.binary(BinaryOperator::Equal, left, right),
            (None, Base::Vector(..)) => {
                let equal = self.binary(BinaryOperator::Equal, left, right);
                self.relational(RelationalFunction::All, equal)
            }
            (Some(_), _) if value_count(&self.context.hir.structs, ty) > TABLE_SIZE => {
                self.equal_elements(ty, left, right)
            }
            _ => {
                let parts = match (ty.array, ty.base) {
                    (None, Base::Struct(id)) => {
                        let fields = &self.context.hir.structs[id].fields;
                        fields.iter().map(|field| field.ty).collect()
                    }
                    (Some(_), _) => vec![ty.element(); count(ty) as usize],
                    (None, _) => vec![element_type(ty); count(ty) as usize],
                };
                let mut all: Option<H> = None;
                for (i, part) in parts.into_iter().enumerate() {
                    let [left, right] = [left, right].map(|value| self.part(value, i as u32));
                    let equal = self.equal(part, left, right);
                    all = Some(match all {
                        Some(all) => self.binary(BinaryOperator::LogicalAnd, all, equal),
                        None => equal,
                    });
                }
                all.expect("what is compared has parts")
            }
        }
    }

    /// Whether all elements of two arrays are equal, found in a loop.
    fn equal_elements(&mut self, ty: Type, left: H, right: H) -> H {
        let [left, right] = [left, right].map(|value| {
            let copy = self.acquire(ty);
            self.store(copy, value);
            copy
        });
        let all = self.acquire(Type::BOOL);
        let yes = self.bool(true);
        self.store(all, yes);
        self.count_to(count(ty), |builder, index| {
            let [left, right] = [left, right].map(|array| {
                let element = builder.access(array, index);
                builder.load(element)
            });
            let equal = builder.equal(ty.element(), left, right);
            let before = builder.load(all);
            let both = builder.binary(BinaryOperator::LogicalAnd, before, equal);
            builder.store(all, both);
        });
        let value = self.load(all);
        for copy in [left, right] {
            self.release(ty, copy);
        }
        self.release(Type::BOOL, all);
        value
    }

    /// Whether any component differs. naga's own operator is false for what is no number.
    fn not_equal(&mut self, ty: Type, left: H, right: H) -> H {
        match (ty.array, ty.base) {
            (None, Base::Scalar(scalar)) if scalar != Scalar::Float => {
                self.binary(BinaryOperator::NotEqual, left, right)
            }
            (None, Base::Vector(scalar, _)) if scalar != Scalar::Float => {
                let differs = self.binary(BinaryOperator::NotEqual, left, right);
                self.relational(RelationalFunction::Any, differs)
            }
            _ => {
                let equal = self.equal(ty, left, right);
                self.not(equal)
            }
        }
    }

    pub(super) fn relational(&mut self, fun: RelationalFunction, argument: H) -> H {
        self.add(Expression::Relational { fun, argument })
    }
}

fn arithmetic(op: BinaryOp) -> BinaryOperator {
    match op {
        BinaryOp::Add => BinaryOperator::Add,
        BinaryOp::Subtract => BinaryOperator::Subtract,
        BinaryOp::Multiply => BinaryOperator::Multiply,
        BinaryOp::Divide => BinaryOperator::Divide,
        BinaryOp::Remainder => BinaryOperator::Modulo,
        BinaryOp::BitAnd => BinaryOperator::And,
        BinaryOp::BitOr => BinaryOperator::InclusiveOr,
        BinaryOp::BitXor => BinaryOperator::ExclusiveOr,
        _ => unreachable!("it is no arithmetic"),
    }
}

fn is_zero(literal: Literal) -> bool {
    matches!(literal, Literal::I32(0) | Literal::U32(0))
}
