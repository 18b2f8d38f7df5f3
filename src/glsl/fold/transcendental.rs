//! Angles, trigonometry, exponentials and roots, §8.1 and §8.2. They are computed in 64 bits and then
//! rounded.

use std::f64::consts::{LN_2, PI};

use super::call::Call;
use crate::glsl::Precision;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Value;

/// The value of a call; `None` if the function is of another section.
pub(super) fn fold(function: Builtin, call: &Call) -> Option<Vec<Value>> {
    let real = call.real;
    Some(match function {
        Builtin::Radians => {
            let factor = real.divide(real.round(PI), 180.0);
            call.map(|x| factor * x)
        }
        Builtin::Degrees => {
            let factor = real.divide(180.0, real.round(PI));
            call.map(|x| factor * x)
        }
        Builtin::Sin => call.map(f64::sin),
        Builtin::Cos => call.map(f64::cos),
        Builtin::Tan => call.map(f64::tan),
        Builtin::Asin => call.map(|x| real.unless(x.abs() > 1.0, x.asin())),
        Builtin::Acos => call.map(|x| real.unless(x.abs() > 1.0, x.acos())),
        Builtin::Atan if call.count() == 2 => {
            call.map2(|y, x| real.unless(x == 0.0 && y == 0.0, y.atan2(x)))
        }
        Builtin::Atan => call.map(f64::atan),
        Builtin::Sinh => call.map(f64::sinh),
        Builtin::Cosh => call.map(f64::cosh),
        Builtin::Tanh => call.map(f64::tanh),
        Builtin::Asinh => call.map(f64::asinh),
        Builtin::Acosh => call.map(|x| real.unless(x < 1.0, x.acosh())),
        Builtin::Atanh => call.map(|x| real.unless(x.abs() >= 1.0, x.atanh())),
        Builtin::Pow => call.map2(|x, y| real.unless(x < 0.0 || (x == 0.0 && y <= 0.0), x.powf(y))),
        Builtin::Exp => call.map(f64::exp),
        Builtin::Exp2 => call.map(f64::exp2),
        Builtin::Log => call.map(|x| real.unless(x <= 0.0, x.ln())),
        Builtin::Log2 => call.map(|x| {
            real.unless(
                x <= 0.0,
                match real.0 {
                    // WebGL2 divides two natural logarithms of 32 bits.
                    Precision::Single => real.round(x.ln()) / real.round(LN_2),
                    Precision::Double => x.log2(),
                },
            )
        }),
        Builtin::Sqrt => call.map(|x| real.unless(x < 0.0, x.sqrt())),
        Builtin::InverseSqrt => call.map(|x| real.unless(x <= 0.0, 1.0 / real.sqrt(x))),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::check;
    use super::super::{Operand, builtin};
    use super::*;
    use crate::glsl::types::Type;

    #[test]
    fn values_are_those_of_the_functions() {
        check(
            "radians 180 90 = 3.1415927 1.5707964
            degrees 3.1415927 = 180
            sin 0 1 = 0 0.84147096
            cos 0 1 = 1 0.5403023
            tan 1 = 1.5574077
            asin 1 0.5 = 1.5707964 0.5235988
            acos 1 -1 = 0 3.1415927
            atan 1 = 0.7853982
            atan 1 0, -1 1 = 2.3561945 0
            sinh 1 = 1.1752012
            cosh 1 = 1.5430807
            tanh 0.5 100 = 0.46211717 1
            asinh 1 = 0.8813736
            acosh 1 2 = 0 1.316958
            atanh 0.5 = 0.54930615
            pow 2 9 0, 10 0.5 2 = 1024 3 0
            exp 1 100 = 2.7182817 inf
            exp2 -1 3 = 0.5 8
            log 2.7182817 = 0.99999994
            log2 8 2 0.5 = 3 1 -1
            sqrt 2 16 = 1.4142135 4
            inversesqrt 4 = 0.5",
        );
    }

    #[test]
    fn what_is_undefined_is_zero_in_single_precision() {
        check(
            "asin 2 = 0
            acos -1.5 = 0
            atan 0, 0 = 0
            acosh 0.5 = 0
            atanh 1 = 0
            pow -1 0 0, 2 0 -1 = 0 0 0
            log 0 -1 = 0 0
            log2 0 = 0
            sqrt -1 = 0
            inversesqrt 0 -1 = 0 0
            sqrt nan = nan
            double sqrt -1 = nan
            double log 0 = -inf
            double pow 0 0, 0 -1 = 1 inf
            double inversesqrt 0 = inf
            double asin 2 = nan",
        );
    }

    type Function = fn(f64) -> f64;

    #[test]
    fn double_precision_keeps_all_digits() {
        let argument = [Value::Float(0.7)];
        let operand = Operand {
            ty: Type::FLOAT,
            values: &argument,
        };
        let functions: [(Builtin, Function); 18] = [
            (Builtin::Radians, f64::to_radians),
            (Builtin::Degrees, f64::to_degrees),
            (Builtin::Sin, f64::sin),
            (Builtin::Cos, f64::cos),
            (Builtin::Tan, f64::tan),
            (Builtin::Asin, f64::asin),
            (Builtin::Acos, f64::acos),
            (Builtin::Atan, f64::atan),
            (Builtin::Sinh, f64::sinh),
            (Builtin::Cosh, f64::cosh),
            (Builtin::Tanh, f64::tanh),
            (Builtin::Asinh, f64::asinh),
            (Builtin::Atanh, f64::atanh),
            (Builtin::Exp, f64::exp),
            (Builtin::Log, f64::ln),
            (Builtin::Exp2, f64::exp2),
            (Builtin::Log2, f64::log2),
            (Builtin::Sqrt, f64::sqrt),
        ];
        for (function, expected) in functions {
            let fold = |precision| {
                let values = builtin(function, &[operand], Type::FLOAT, precision);
                values.map(|values| super::super::float(values[0]))
            };
            let double = fold(Precision::Double).expect("a value");
            assert!((double - expected(0.7)).abs() < 1e-14, "{function:?}");
            let single = fold(Precision::Single).expect("a value");
            let error = (single - expected(0.7)).abs() / expected(0.7).abs();
            assert!(error < 3e-7, "{function:?}: {single}");
            assert_eq!(single, f64::from(single as f32), "{function:?}");
        }
    }
}
