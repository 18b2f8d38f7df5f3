//! Texels in 16 bits. Samplers are `lowp` in GLSL ES unless a text says otherwise, and so are texels and what is computed of
//! texels and constants alone (§4.5.2). GPUs of phones compute that in halves, and so does Mesa's driver on the CPU. What
//! becomes an integer has 16 bits then, too.

use naga::MathFunction;

use super::context::samples;
use super::function::{Builder, H};
use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::{BinaryOp, Expr, ExprKind};
use crate::glsl::types::{Scalar, Type};

/// The largest half.
const LARGEST: f64 = 65_504.0;

/// The smallest normal half, 2⁻¹⁴. Smaller ones are multiples of the smallest.
const LEAST_NORMAL: f64 = 6.103_515_625e-5;

/// How many of the smallest halves there are in one, 2²⁴.
const STEPS: f64 = 16_777_216.0;

/// The bit that makes a NaN quiet.
const QUIET: u32 = 0x0040_0000;

/// How precisely an expression must be computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Needs {
    /// As its surroundings.
    Nothing,
    Low,
    High,
}

impl Needs {
    fn and(self, other: Needs) -> Needs {
        match (self, other) {
            (Needs::High, _) | (_, Needs::High) => Needs::High,
            (Needs::Nothing, Needs::Nothing) => Needs::Nothing,
            _ => Needs::Low,
        }
    }
}

impl Builder<'_, '_> {
    /// Evaluates an expression, in 16 bits if that is enough and asked for.
    pub(super) fn value_in_precision(&mut self, id: Id<Expr>) -> H {
        if !self.context.options.low_samplers {
            return self.value_here(id);
        }
        let Expr { kind, ty, .. } = self.source.exprs[id];
        let outside = self.is_low;
        let own = match kind {
            // Constants are rounded before they are compared with something low.
            ExprKind::Binary(op, left, right) if is_comparison(op) => {
                self.needs(left).and(self.needs(right))
            }
            _ => self.needs(id),
        };
        let reads = is_read(kind);
        self.is_low = own == Needs::Low && !reads;
        let value = self.value_here(id);
        self.is_low = outside;
        let is_constant = matches!(kind, ExprKind::Constant(_)) && outside;
        let is_float = ty.scalar() == Some(Scalar::Float) && ty.vector_size().is_some();
        match is_float {
            true if own == Needs::Low && reads => {
                self.is_low = false;
                let value = self.cut(value, ty);
                self.is_low = outside;
                value
            }
            true if is_constant => self.halved(value),
            false if self.is_conversion_to_low_int(kind, ty) => self.within_16_bits(value, ty),
            _ => value,
        }
    }

    /// Whether integers are made of what is computed in 16 bits: they have 16 bits themselves.
    fn is_conversion_to_low_int(&mut self, kind: ExprKind, ty: Type) -> bool {
        let ExprKind::Construct(operands) = kind else {
            return false;
        };
        let source = self.source;
        ty.scalar() == Some(Scalar::Int)
            && matches!(source.operands.get(operands), &[only] if self.needs(only) == Needs::Low)
    }

    /// The nearest integer of 16 bits.
    fn within_16_bits(&mut self, value: H, ty: Type) -> H {
        let size = ty.vector_size().unwrap_or(1);
        let limits = [i16::MIN, i16::MAX];
        let [least, most] = limits.map(|limit| {
            let limit = self.int(limit.into());
            self.splat(limit, size)
        });
        self.math(MathFunction::Clamp, &[value, least, most])
    }

    /// The result of an operation on floats, rounded if that is due.
    pub(super) fn rounded_if_low(&mut self, value: H) -> H {
        match self.is_low {
            true => self.halved(value),
            false => value,
        }
    }

    /// A texel as a half, cut off towards zero as Mesa's driver does it. What is no number becomes a quiet one: texels hold
    /// the bits of integers sometimes.
    fn cut(&mut self, value: H, ty: Type) -> H {
        use naga::{BinaryOperator as Op, ScalarKind};
        let size = ty.vector_size().unwrap_or(1);
        let limits = [LARGEST, LEAST_NORMAL, STEPS, f64::from(f32::MAX)];
        let [most, least, steps, finite] = limits.map(|limit| self.constant_of(limit, ty));
        let less = self.negate(most);
        let within = self.math(MathFunction::Clamp, &[value, less, most]);
        let [mask, quiet] = [0xffff_e000, QUIET].map(|bits| {
            let bits = self.uint(bits);
            self.splat(bits, size)
        });
        let [normal, infinite] = [within, value].map(|value| {
            let bits = self.cast(value, ScalarKind::Uint, None);
            self.binary(Op::And, bits, mask)
        });
        let nan = self.binary(Op::InclusiveOr, infinite, quiet);
        let is_nan = self.compare_with_infinity(Op::Greater, value, size);
        let odd = self.select(is_nan, nan, infinite);
        let [normal, odd] = [normal, odd].map(|bits| self.cast(bits, ScalarKind::Float, None));
        let scaled = self.product(value, steps);
        let whole = self.math(MathFunction::Trunc, &[scaled]);
        let small = self.quotient(whole, steps);
        let far = self.math(MathFunction::Abs, &[value]);
        let is_small = self.binary(Op::Less, far, least);
        let is_finite = self.binary(Op::LessEqual, far, finite);
        let kept = self.select(is_small, small, normal);
        self.select(is_finite, kept, odd)
    }

    /// A number as a half, rounded to the nearest. What is too small to be a normal one is a multiple of the smallest:
    /// naga's operation makes it zero.
    fn halved(&mut self, value: H) -> H {
        use naga::{BinaryOperator as Op, Expression};
        let (outside, size) = (std::mem::take(&mut self.is_low), self.size_of(value));
        let ty = Type::vector(Scalar::Float, size);
        let math = |fun| Expression::Math {
            fun,
            arg: value,
            arg1: None,
            arg2: None,
            arg3: None,
        };
        let normal = self.add(math(MathFunction::QuantizeToF16));
        let far = self.add(math(MathFunction::Abs));
        let [least, steps] = [LEAST_NORMAL, STEPS].map(|limit| self.constant_of(limit, ty));
        let scaled = self.product(value, steps);
        let whole = self.math(MathFunction::Round, &[scaled]);
        let small = self.quotient(whole, steps);
        let is_small = self.binary(Op::Less, far, least);
        let rounded = self.select(is_small, small, normal);
        self.is_low = outside;
        rounded
    }

    /// One divided by a root, both rounded.
    pub(super) fn low_inverse_root(&mut self, value: H) -> H {
        let ty = Type::vector(Scalar::Float, self.size_of(value));
        let root = self.math(MathFunction::Sqrt, &[value]);
        let one = self.constant_of(1.0, ty);
        self.quotient(one, root)
    }

    /// How many components a number has that is computed of texels and constants.
    fn size_of(&self, value: H) -> u8 {
        use naga::{Expression as E, MathFunction as M, TypeInner};
        let of_type = |ty| match self.context.module.types[ty].inner {
            TypeInner::Vector { size, .. } => size as u8,
            _ => 1,
        };
        match &self.function.expressions[value] {
            E::Splat { size, .. } | E::Swizzle { size, .. } => *size as u8,
            E::Compose { ty, .. } | E::ZeroValue(ty) => of_type(*ty),
            E::Binary { left, right, .. } => self.size_of(*left).max(self.size_of(*right)),
            E::Unary { expr, .. } | E::As { expr, .. } => self.size_of(*expr),
            E::Select { accept, .. } => self.size_of(*accept),
            E::Math {
                fun: M::Dot | M::Length | M::Distance,
                ..
            } => 1,
            E::Math { arg, .. } => self.size_of(*arg),
            E::Load { pointer } => match self.function.expressions[*pointer] {
                E::LocalVariable(local) => of_type(self.function.local_variables[local].ty),
                _ => 1,
            },
            _ => 1,
        }
    }

    fn needs(&mut self, id: Id<Expr>) -> Needs {
        if let Some(known) = self.room.needs[id.index()] {
            return known;
        }
        let Expr { kind, ty, .. } = self.source.exprs[id];
        let is_float = ty.scalar() == Some(Scalar::Float) && !ty.is_matrix() && !ty.is_array();
        let found = match kind {
            ExprKind::Constant(_) => Needs::Nothing,
            _ if !is_float => Needs::High,
            ExprKind::Builtin(..) if is_read(kind) => Needs::Low,
            ExprKind::Builtin(
                Builtin::DFdx | Builtin::DFdy | Builtin::Fwidth | Builtin::Modf,
                _,
            ) => Needs::High,
            ExprKind::Swizzle(base, _) => self.needs(base),
            ExprKind::Index(base, _) if self.source.exprs[base].ty.is_vector() => self.needs(base),
            ExprKind::Unary(..)
            | ExprKind::Binary(
                BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide,
                ..,
            )
            | ExprKind::Construct(_)
            | ExprKind::Builtin(..) => {
                let mut all = Needs::Nothing;
                let source = self.source;
                source.for_each_operand(id, |operand| all = all.and(self.needs(operand)));
                all
            }
            ExprKind::Ternary(_, yes, no) => self.needs(yes).and(self.needs(no)),
            _ => Needs::High,
        };
        self.room.needs[id.index()] = Some(found);
        found
    }
}

fn is_comparison(op: BinaryOp) -> bool {
    use BinaryOp::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
    matches!(
        op,
        Less | Greater | LessEqual | GreaterEqual | Equal | NotEqual
    )
}

fn is_read(kind: ExprKind) -> bool {
    match kind {
        ExprKind::Builtin(builtin, _) => {
            samples(builtin) || matches!(builtin, Builtin::TexelFetch | Builtin::TexelFetchOffset)
        }
        _ => false,
    }
}
