//! The built-in functions of §8 but for textures. naga's want operands of one type, know scalars as
//! vectors only here and there, and have some of GLSL's in another sense.

use naga::{
    BinaryOperator, DerivativeAxis, DerivativeControl, Expression, MathFunction,
    RelationalFunction, ScalarKind,
};
use smallvec::SmallVec;

use super::expression::Typed;
use super::function::{Builder, H};
use super::sanitize::{Form, Here};
use crate::glsl::Precision;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Operands;
use crate::glsl::types::{Scalar, Type};

use Builtin as B;
use MathFunction as M;

impl Builder<'_, '_> {
    /// Calls a built-in function.
    pub(super) fn builtin(
        &mut self,
        builtin: Builtin,
        operands: Operands,
        ty: Type,
        tree: Option<Here>,
    ) -> H {
        let ids = self.source.operands.get(operands);
        if is_texture(builtin) {
            return self.texture(builtin, ids, ty);
        }
        if builtin == B::Modf {
            let value = self.value(ids[0]);
            let place = self.place(ids[1]);
            let whole = self.math(M::Trunc, &[value]);
            self.store_place(place, whole);
            self.mark_set(ids[1]);
            return self.difference(value, whole);
        }
        let types: SmallVec<[Type; 4]> = ids.iter().map(|&id| self.source.exprs[id].ty).collect();
        let suspect = self.suspect(Form::Call(builtin), &types, ty, tree);
        let mut operands: SmallVec<[Typed; 4]> = SmallVec::new();
        for (i, &id) in ids.iter().enumerate() {
            self.within(suspect, i);
            operands.push(self.typed(id));
        }
        let found = self.check_arguments(builtin, &operands);
        let value = self.of_values(builtin, &operands, ty);
        self.check_result(suspect, &operands, Typed { value, ty }, found);
        value
    }

    /// A function of values alone.
    fn of_values(&mut self, builtin: Builtin, operands: &[Typed], ty: Type) -> H {
        let values: SmallVec<[H; 4]> = operands.iter().map(|operand| operand.value).collect();
        let first = operands[0].ty;
        match builtin {
            B::MatrixCompMult => self.component_product(values[0], values[1], ty),
            B::OuterProduct => self.outer_product(values[0], values[1], ty),
            B::Transpose => self.math(M::Transpose, &values),
            B::Determinant => self.math(M::Determinant, &values),
            B::Inverse => self.inverse(values[0], ty),
            B::Length
            | B::Distance
            | B::Dot
            | B::Cross
            | B::Normalize
            | B::FaceForward
            | B::Reflect
            | B::Refract => self.geometric(builtin, &values, first),
            B::LessThan
            | B::LessThanEqual
            | B::GreaterThan
            | B::GreaterThanEqual
            | B::Equal
            | B::NotEqual => self.compare(builtin, values[0], values[1], first),
            B::Any => self.relational(RelationalFunction::Any, values[0]),
            B::All => self.relational(RelationalFunction::All, values[0]),
            B::Not => self.not(values[0]),
            B::IsNan | B::IsInf => self.classify(builtin, values[0], first),
            B::FloatBitsToInt | B::FloatBitsToUint => {
                let float = self.narrow(values[0]);
                let kind = if builtin == B::FloatBitsToInt {
                    ScalarKind::Sint
                } else {
                    ScalarKind::Uint
                };
                self.cast(float, kind, None)
            }
            B::IntBitsToFloat | B::UintBitsToFloat => {
                let float = self.cast(values[0], ScalarKind::Float, None);
                self.widen(float)
            }
            B::PackSnorm2x16 | B::PackUnorm2x16 | B::PackHalf2x16 => {
                let float = self.narrow(values[0]);
                self.math(packing(builtin), &[float])
            }
            B::UnpackSnorm2x16 | B::UnpackUnorm2x16 | B::UnpackHalf2x16 => {
                let float = self.math(packing(builtin), &values);
                self.widen(float)
            }
            B::DFdx | B::DFdy | B::Fwidth => {
                let expr = self.narrow(values[0]);
                let derivative = self.add(Expression::Derivative {
                    axis: match builtin {
                        B::DFdx => DerivativeAxis::X,
                        B::DFdy => DerivativeAxis::Y,
                        _ => DerivativeAxis::Width,
                    },
                    ctrl: DerivativeControl::None,
                    expr,
                });
                self.widen(derivative)
            }
            B::Mix if operands[2].ty.scalar() == Some(Scalar::Bool) => {
                self.select(values[2], values[1], values[0])
            }
            _ => {
                let size = ty.vector_size().expect("these are for scalars and vectors");
                let values: SmallVec<[H; 4]> = operands
                    .iter()
                    .map(|operand| self.broadcast(*operand, size))
                    .collect();
                self.by_component(builtin, &values, ty)
            }
        }
    }

    /// A scalar operand as a vector of equal components.
    pub(super) fn broadcast(&mut self, operand: Typed, size: u8) -> H {
        if operand.ty.is_scalar() {
            self.splat(operand.value, size)
        } else {
            operand.value
        }
    }

    /// The functions that work on each component; operands and result are of one size.
    fn by_component(&mut self, builtin: Builtin, values: &[H], ty: Type) -> H {
        let function = match builtin {
            B::Radians => return self.scaled(values[0], std::f64::consts::PI / 180.0, ty),
            B::Degrees => return self.scaled(values[0], 180.0 / std::f64::consts::PI, ty),
            B::Mod => {
                let quotient = self.quotient(values[0], values[1]);
                let whole = self.math(M::Floor, &[quotient]);
                let product = self.product(values[1], whole);
                return self.difference(values[0], product);
            }
            B::SmoothStep => return self.smooth_step(values, ty),
            B::Sqrt => M::Sqrt,
            B::InverseSqrt => M::InverseSqrt,
            B::Abs => M::Abs,
            B::Sign => M::Sign,
            B::Floor => M::Floor,
            B::Trunc => M::Trunc,
            B::Round | B::RoundEven => M::Round,
            B::Ceil => M::Ceil,
            B::Fract => M::Fract,
            B::Min => M::Min,
            B::Max => M::Max,
            B::Clamp => M::Clamp,
            B::Mix => return self.mix(values, ty),
            B::Step if self.is_expanded() => {
                // As it is defined: drivers take what is no number the other way.
                let reaches = BinaryOperator::GreaterEqual;
                let reaches = self.binary(reaches, values[1], values[0]);
                let [zero, one] = [0.0, 1.0].map(|value| self.constant_of(value, ty));
                return self.select(reaches, one, zero);
            }
            B::Step => M::Step,
            _ => return self.transcendental(builtin, values, ty),
        };
        self.math(function, values)
    }

    /// A number as a scalar or vector of that type.
    pub(super) fn constant_of(&mut self, value: f64, ty: Type) -> H {
        let size = ty.vector_size().expect("it is a scalar or a vector");
        let value = self.float(value);
        self.splat(value, size)
    }

    fn scaled(&mut self, value: H, factor: f64, ty: Type) -> H {
        let factor = self.constant_of(factor, ty);
        self.product(value, factor)
    }

    /// Spelled out, for edges in falling order work on all machines then.
    fn smooth_step(&mut self, values: &[H], ty: Type) -> H {
        let [low, high, x] = [values[0], values[1], values[2]];
        let above = self.difference(x, low);
        let width = match [low, high].map(|edge| self.known(edge)) {
            [Some(low), Some(high)] => {
                self.constant_of(self.context.options.precision.round(high - low), ty)
            }
            _ => self.difference(high, low),
        };
        let [zero, one] = [0.0, 1.0].map(|value| self.constant_of(value, ty));
        let mut t = self.quotient(above, width);
        // Between equal edges it is a step. Some drivers make anything of the division where they see the zero.
        let is_single = self.context.options.precision == Precision::Single;
        if is_single && self.is_expanded() && self.known(width).is_none() {
            let infinity = self.signed_infinity(width, ty);
            let far = self.product(above, infinity);
            let is_step = self.binary(BinaryOperator::Equal, width, zero);
            t = self.select(is_step, far, t);
        }
        let t = self.math(M::Clamp, &[t, zero, one]);
        let [two, three] = [2.0, 3.0].map(|value| self.constant_of(value, ty));
        let twice = self.product(two, t);
        let rest = self.difference(three, twice);
        let once = self.product(t, rest);
        self.product(t, once)
    }

    /// What one divided by a zero is: infinity with its sign.
    fn signed_infinity(&mut self, zero: H, ty: Type) -> H {
        let size = ty.vector_size().expect("it is a scalar or a vector");
        let [sign, infinity] = [0x8000_0000, 0x7f80_0000].map(|bits| {
            let bits = self.uint(bits);
            self.splat(bits, size)
        });
        let bits = self.cast(zero, ScalarKind::Uint, None);
        let sign = self.binary(BinaryOperator::And, bits, sign);
        let bits = self.binary(BinaryOperator::InclusiveOr, sign, infinity);
        self.cast(bits, ScalarKind::Float, None)
    }

    /// The functions that drivers have for 32 bits only.
    pub(super) fn transcendental_in_single(&mut self, builtin: Builtin, values: &[H]) -> H {
        let function = match builtin {
            B::Sin => M::Sin,
            B::Cos => M::Cos,
            B::Tan => M::Tan,
            B::Asin => M::Asin,
            B::Acos => M::Acos,
            B::Atan if values.len() == 2 => M::Atan2,
            B::Atan => M::Atan,
            B::Sinh => M::Sinh,
            B::Cosh => M::Cosh,
            B::Tanh => M::Tanh,
            B::Asinh => M::Asinh,
            B::Acosh => M::Acosh,
            B::Atanh => M::Atanh,
            B::Pow => M::Pow,
            B::Exp => M::Exp,
            B::Log => M::Log,
            B::Exp2 => M::Exp2,
            B::Log2 => M::Log2,
            _ => unreachable!("{builtin:?} is lowered otherwise"),
        };
        self.math(function, values)
    }

    /// `tanh`, which some drivers compute as a quotient of exponentials, in a range where these are
    /// finite; beyond it the result is one.
    pub(super) fn tanh_operand(&mut self, value: H, size: u8) -> H {
        let [low, high] = [-10.0_f32, 10.0].map(|limit| {
            let limit = self.literal(naga::Literal::F32(limit));
            self.splat(limit, size)
        });
        self.math(M::Clamp, &[value, low, high])
    }

    fn geometric(&mut self, builtin: Builtin, values: &[H], ty: Type) -> H {
        let is_scalar = ty.is_scalar();
        match builtin {
            B::Length if is_scalar => self.math(M::Abs, values),
            B::Length => self.length(values[0], ty),
            B::Distance if is_scalar => {
                let difference = self.difference(values[0], values[1]);
                self.math(M::Abs, &[difference])
            }
            B::Distance => {
                let difference = self.difference(values[0], values[1]);
                self.length(difference, ty)
            }
            B::Dot => self.dot_of(values[0], values[1], ty),
            B::Cross => self.math(M::Cross, values),
            B::Normalize if is_scalar => self.math(M::Sign, values),
            B::Normalize if !self.is_expanded() => self.math(M::Normalize, values),
            B::Normalize => {
                let square = self.dot_of(values[0], values[0], ty);
                let factor = self.math(M::InverseSqrt, &[square]);
                self.scale(values[0], factor)
            }
            B::FaceForward => {
                let dot = self.dot_of(values[2], values[1], ty);
                let zero = self.float(0.0);
                let condition = self.binary(BinaryOperator::Less, dot, zero);
                let turned = self.negate(values[0]);
                self.select(condition, values[0], turned)
            }
            B::Reflect if !is_scalar && !self.is_expanded() => self.math(M::Reflect, values),
            B::Reflect => {
                let dot = self.dot_of(values[1], values[0], ty);
                let two = self.float(2.0);
                let twice = self.product(two, dot);
                let along = self.scale(values[1], twice);
                self.difference(values[0], along)
            }
            B::Refract => self.refract(values, ty),
            _ => unreachable!("it is not geometric"),
        }
    }

    fn length(&mut self, vector: H, ty: Type) -> H {
        if !self.is_expanded() {
            return self.math(M::Length, &[vector]);
        }
        let square = self.dot_of(vector, vector, ty);
        self.math(M::Sqrt, &[square])
    }

    pub(super) fn dot_of(&mut self, left: H, right: H, ty: Type) -> H {
        match ty.vector_size() {
            Some(1) | None => self.product(left, right),
            Some(size) => self.dot(left, right, size),
        }
    }

    /// Spelled out: naga's is for vectors of 32 bits.
    fn refract(&mut self, values: &[H], ty: Type) -> H {
        let [incident, normal, eta] = [values[0], values[1], values[2]];
        let [zero, one] = [0.0, 1.0].map(|value| self.float(value));
        let dot = self.dot_of(normal, incident, ty);
        let square = self.product(dot, dot);
        let sine = self.difference(one, square);
        let eta_square = self.product(eta, eta);
        let sine = self.product(eta_square, sine);
        let k = self.difference(one, sine);
        let is_total = self.binary(BinaryOperator::Less, k, zero);
        let root = self.math(M::Max, &[k, zero]);
        let root = self.math(M::Sqrt, &[root]);
        let along = self.product(eta, dot);
        let along = self.sum(along, root);
        let [left, right] =
            [(eta, incident), (along, normal)].map(|(factor, v)| self.scale(v, factor));
        let refracted = self.difference(left, right);
        let nothing = self.zero(ty);
        self.select(is_total, nothing, refracted)
    }

    fn compare(&mut self, builtin: Builtin, left: H, right: H, ty: Type) -> H {
        let is_float = ty.scalar() == Some(Scalar::Float);
        let op = match builtin {
            B::LessThan => BinaryOperator::Less,
            B::LessThanEqual => BinaryOperator::LessEqual,
            B::GreaterThan => BinaryOperator::Greater,
            B::GreaterThanEqual => BinaryOperator::GreaterEqual,
            B::Equal => BinaryOperator::Equal,
            // naga's own is false for what is no number.
            B::NotEqual if is_float => {
                let equal = self.binary(BinaryOperator::Equal, left, right);
                return self.not(equal);
            }
            _ => BinaryOperator::NotEqual,
        };
        self.binary(op, left, right)
    }

    /// `isnan` and `isinf`, by the bits: compilers assume that floats are neither.
    fn classify(&mut self, builtin: Builtin, value: H, ty: Type) -> H {
        if self.context.options.precision == Precision::Double {
            return self.classify_double(builtin, value, ty);
        }
        let size = ty.vector_size().expect("it is a scalar or a vector");
        let op = match builtin {
            B::IsNan => BinaryOperator::Greater,
            _ => BinaryOperator::Equal,
        };
        self.compare_with_infinity(op, value, size)
    }

    /// How the bits of a float's magnitude, as a number, compare with those of infinity.
    pub(super) fn compare_with_infinity(&mut self, op: BinaryOperator, value: H, size: u8) -> H {
        let bits = self.cast(value, ScalarKind::Uint, None);
        let [mask, infinity] = [0x7fff_ffff, 0x7f80_0000].map(|bits| {
            let bits = self.uint(bits);
            self.splat(bits, size)
        });
        let magnitude = self.binary(BinaryOperator::And, bits, mask);
        self.binary(op, magnitude, infinity)
    }

    fn classify_double(&mut self, builtin: Builtin, value: H, ty: Type) -> H {
        if builtin == B::IsNan {
            let equal = self.binary(BinaryOperator::Equal, value, value);
            return self.not(equal);
        }
        let magnitude = self.math(M::Abs, &[value]);
        let largest = self.constant_of(f64::MAX, ty);
        self.binary(BinaryOperator::Greater, magnitude, largest)
    }
}

fn packing(builtin: Builtin) -> MathFunction {
    match builtin {
        B::PackSnorm2x16 => M::Pack2x16snorm,
        B::PackUnorm2x16 => M::Pack2x16unorm,
        B::PackHalf2x16 => M::Pack2x16float,
        B::UnpackSnorm2x16 => M::Unpack2x16snorm,
        B::UnpackUnorm2x16 => M::Unpack2x16unorm,
        B::UnpackHalf2x16 => M::Unpack2x16float,
        _ => unreachable!("it packs nothing"),
    }
}

fn is_texture(builtin: Builtin) -> bool {
    matches!(
        builtin,
        B::TextureSize
            | B::Texture
            | B::TextureProj
            | B::TextureLod
            | B::TextureOffset
            | B::TexelFetch
            | B::TexelFetchOffset
            | B::TextureProjOffset
            | B::TextureLodOffset
            | B::TextureProjLod
            | B::TextureProjLodOffset
            | B::TextureGrad
            | B::TextureGradOffset
            | B::TextureProjGrad
            | B::TextureProjGradOffset
    )
}
