//! `mix`, in the forms that Mesa's compiler of GLSL gives it before it optimises further (`nir_lower_flrp`, without fused
//! products). They round differently.

use naga::{Expression, Literal, MathFunction};

use super::function::{Builder, H};
use crate::glsl::Arithmetic;
use crate::glsl::types::{Scalar, Type};

/// A component of an operand.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Known(f64),
    /// A scalar, or a component of a vector.
    Of(H, Option<u8>),
}

/// Constants that are further apart, in powers of two, are not subtracted from each other.
const FAR: i32 = 11;

impl Builder<'_, '_> {
    /// From `values[0]` to `values[1]` by `values[2]`, all of one type.
    pub(super) fn mix(&mut self, values: &[H], ty: Type) -> H {
        if !self.is_expanded() {
            return self.math(MathFunction::Mix, values);
        }
        let size = ty.vector_size().expect("it is a scalar or a vector");
        let [from, to, share] = [0, 1, 2].map(|operand| {
            let part = |i| self.part_of(values[operand], (size > 1).then_some(i));
            (0..size).map(part).collect::<Vec<_>>()
        });
        let is_known = |part: &Part| matches!(part, Part::Known(_));
        let is_shared: Vec<bool> = (0..usize::from(size))
            .map(|i| {
                (0..usize::from(size)).any(|other| {
                    let same = |parts: &[Part]| parts[i] == parts[other];
                    other != i && same(&share) && (same(&from) || same(&to))
                })
            })
            .collect();
        let mut all = from.iter().chain(&to).chain(&share);
        let is_plain = !all.any(is_known)
            && !is_shared.contains(&true)
            && !share.iter().any(|&share| self.choice(share).is_some());
        if is_plain || self.context.options.arithmetic != Arithmetic::Expanded {
            return self.mix_fast(values[0], values[1], values[2]);
        }
        let components = (0..usize::from(size))
            .map(|i| self.mix_component(from[i], to[i], share[i], is_shared[i]))
            .collect::<Vec<_>>();
        match *components {
            [only] => only,
            _ => self.compose(Type::vector(Scalar::Float, size), components),
        }
    }

    /// With one product.
    fn mix_fast(&mut self, from: H, to: H, share: H) -> H {
        let way = self.difference(to, from);
        let part = self.product(share, way);
        self.sum(from, part)
    }

    fn mix_component(&mut self, from: Part, to: Part, share: Part, is_shared: bool) -> H {
        use Part::Known;
        let [x, y, t] = [from, to, share].map(|part| self.value_of(part));
        if let Some(condition) = self.choice(share) {
            return self.select(condition, y, x);
        }
        match (from, to, share) {
            (_, _, Known(0.0)) => return x,
            (_, _, Known(1.0)) => return y,
            (Known(0.0), ..) => return self.product(y, t),
            (Known(from), Known(to), _) if (exponent(from) - exponent(to)).abs() <= FAR => {
                let way = self.float(self.context.options.precision.round(to - from));
                let part = self.product(t, way);
                return self.sum(x, part);
            }
            _ => {}
        }
        let is_one = |part| matches!(part, Known(1.0 | -1.0));
        let is_strict = is_shared || is_one(from) || is_one(to);
        let rest = match share {
            Known(share) => self.float(self.context.options.precision.round(1.0 - share)),
            Part::Of(..) if is_strict || to == Known(0.0) => {
                let one = self.float(1.0);
                self.difference(one, t)
            }
            Part::Of(..) => return self.mix_fast(x, y, t),
        };
        let kept = self.product(x, rest);
        if to == Known(0.0) {
            return kept;
        }
        // With two products it gives the ends exactly.
        let part = self.product(y, t);
        self.sum(kept, part)
    }

    /// A component of a vector, or the only one of a scalar.
    fn part_of(&self, value: H, index: Option<u8>) -> Part {
        match (&self.function.expressions[value], index) {
            (Expression::Literal(Literal::F32(number)), _) => Part::Known(f64::from(*number)),
            (Expression::Literal(Literal::F64(number)), _) => Part::Known(*number),
            (Expression::ZeroValue(_), _) => Part::Known(0.0),
            (Expression::Splat { value, .. }, _) => self.part_of(*value, None),
            (Expression::Compose { ty, components }, Some(at)) => {
                match self.context.module.types[*ty].inner {
                    naga::TypeInner::Vector { size, .. } if components.len() == size as usize => {
                        self.part_of(components[usize::from(at)], None)
                    }
                    _ => Part::Of(value, index),
                }
            }
            _ => Part::Of(value, index),
        }
    }

    fn value_of(&mut self, part: Part) -> H {
        match part {
            Part::Known(number) => self.float(number),
            Part::Of(value, None) => value,
            Part::Of(vector, Some(index)) => self.part(vector, index.into()),
        }
    }

    /// The condition of a share that is one or zero, as `step` gives it.
    fn choice(&self, share: Part) -> Option<H> {
        let Part::Of(value, None) = share else {
            return None;
        };
        match self.function.expressions[value] {
            Expression::Select {
                condition,
                accept,
                reject,
            } if self.known(accept) == Some(1.0) && self.known(reject) == Some(0.0) => {
                Some(condition)
            }
            _ => None,
        }
    }
}

/// The power of two of a number, so that it is at least a half of that and less than all.
fn exponent(number: f64) -> i32 {
    match number == 0.0 {
        true => 0,
        false => number.abs().log2().floor() as i32 + 1,
    }
}
