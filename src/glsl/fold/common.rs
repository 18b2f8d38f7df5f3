//! Common functions, §8.3.

use super::call::Call;
use super::truth;
use crate::glsl::Precision;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Value;

/// The value of a call; `None` if the function is of another section, or `modf`.
pub(super) fn fold(function: Builtin, call: &Call) -> Option<Vec<Value>> {
    let real = call.real;
    Some(match function {
        Builtin::Abs => call.each(|i| match call.value(0, i) {
            Value::Float(x) => Value::Float(x.abs()),
            Value::Int(x) => Value::Int(x.wrapping_abs()),
            other => other,
        }),
        Builtin::Sign => call.each(|i| match call.value(0, i) {
            Value::Float(x) => Value::Float(f64::from(i8::from(x > 0.0) - i8::from(x < 0.0))),
            Value::Int(x) => Value::Int(x.signum()),
            other => other,
        }),
        Builtin::Floor => call.map(f64::floor),
        Builtin::Trunc => call.map(f64::trunc),
        // Half goes away from zero, as WebGL2 chooses.
        Builtin::Round => call.map(f64::round),
        Builtin::RoundEven => call.map(f64::round_ties_even),
        Builtin::Ceil => call.map(f64::ceil),
        Builtin::Fract => call.map(|x| x - x.floor()),
        Builtin::Mod => call.map2(|x, y| x - real.multiply(y, real.divide(x, y).floor())),
        Builtin::Min => call.each(|i| smaller(call.value(0, i), call.value(1, i))),
        Builtin::Max => call.each(|i| larger(call.value(0, i), call.value(1, i))),
        Builtin::Clamp => call.each(|i| {
            let [x, low, high] = [0, 1, 2].map(|argument| call.value(argument, i));
            clamp(x, low, high, real.0)
        }),
        Builtin::Mix => match call.argument(2).values {
            [Value::Bool(_), ..] => {
                call.each(|i| call.value(usize::from(truth(call.value(2, i))), i))
            }
            _ => call.map3(|x, y, a| real.multiply(x, real.subtract(1.0, a)) + real.multiply(y, a)),
        },
        Builtin::Step => call.map2(|edge, x| if x < edge { 0.0 } else { 1.0 }),
        Builtin::SmoothStep => call.map3(|low, high, x| {
            let along = real.divide(real.subtract(x, low), real.subtract(high, low));
            let t = between(along, 0.0, 1.0);
            let slope = real.subtract(3.0, real.multiply(2.0, t));
            real.unless(low >= high, real.multiply(real.multiply(t, t), slope))
        }),
        Builtin::IsNan => call.each(|i| Value::Bool(call.float(0, i).is_nan())),
        Builtin::IsInf => call.each(|i| Value::Bool(call.float(0, i).is_infinite())),
        // Bits are those of 32, in double precision too.
        Builtin::FloatBitsToInt => {
            call.each(|i| Value::Int((call.float(0, i) as f32).to_bits() as i32))
        }
        Builtin::FloatBitsToUint => call.each(|i| Value::Uint((call.float(0, i) as f32).to_bits())),
        Builtin::IntBitsToFloat | Builtin::UintBitsToFloat => {
            call.each_float(|i| match call.value(0, i) {
                Value::Int(bits) => f32::from_bits(bits as u32).into(),
                Value::Uint(bits) => f32::from_bits(bits).into(),
                Value::Float(_) | Value::Bool(_) => f64::NAN,
            })
        }
        _ => return None,
    })
}

/// The second if it is less than the first, §8.3: so NaN stays only if it is the first.
fn smaller(a: Value, b: Value) -> Value {
    match less(b, a) {
        true => b,
        false => a,
    }
}

/// The second if the first is less.
fn larger(a: Value, b: Value) -> Value {
    match less(a, b) {
        true => b,
        false => a,
    }
}

fn less(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Float(a), Value::Float(b)) => a < b,
        (Value::Int(a), Value::Int(b)) => a < b,
        (Value::Uint(a), Value::Uint(b)) => a < b,
        _ => false,
    }
}

/// The nearest number within limits; NaN becomes the lower one.
fn between(x: f64, low: f64, high: f64) -> f64 {
    if x > low {
        if x > high { high } else { x }
    } else {
        low
    }
}

/// Limits in the wrong order are undefined, and make 0 in WebGL2.
fn clamp(x: Value, low: Value, high: Value, precision: Precision) -> Value {
    let reversed = less(high, low);
    match (x, low, high) {
        (Value::Float(_), ..) if reversed && precision == Precision::Single => Value::Float(0.0),
        (Value::Float(_), ..) if reversed => smaller(larger(x, low), high),
        (Value::Float(x), Value::Float(low), Value::Float(high)) => {
            Value::Float(between(x, low, high))
        }
        (Value::Int(_), ..) if reversed => Value::Int(0),
        (Value::Uint(_), ..) if reversed => Value::Uint(0),
        _ => smaller(larger(x, low), high),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::check;

    #[test]
    fn numbers_are_rounded_and_compared() {
        check(
            "abs -1.5 2 = 1.5 2
            abs -3i -2147483648i = 3i -2147483648i
            sign -3 0 nan = -1 0 0
            sign -3i 7i = -1i 1i
            floor -2.3 2.7 = -3 2
            trunc -2.7 2.7 = -2 2
            round 2.5 -2.5 0.4 = 3 -3 0
            roundEven 2.5 3.5 -0.5 = 2 4 -0
            ceil -2.3 2.1 = -2 3
            fract -0.25 1.75 -0.0000000001 = 0.75 0.75 1
            mod -1 5.5, 4 = 3 1.5
            mod 1, 0 = nan
            mod 7.5 -7.5, -2 4 = -0.5 0.5
            min 2 3 nan, 3 2 1 = 2 2 nan
            min 1, nan = 1
            max -2i 5i, 3i = 3i 5i
            max 4000000000u, 1u = 4000000000u
            clamp 7 -1 0.5, 0, 1 = 1 0 0.5
            clamp nan, 2, 3 = 2
            clamp 9i, 1i, 7i = 7i
            clamp 9, 5, 1 = 0
            clamp 9i, 5i, 1i = 0i
            clamp 9u, 5u, 1u = 0u
            double clamp 9, 5, 1 = 1",
        );
    }

    #[test]
    fn numbers_are_blended() {
        check(
            "mix 2 0, 6 1, 0.25 = 3 0.25
            mix 1 2, 3 4, t f = 3 2
            step 1, 0.5 1 2 = 0 1 1
            step 1 2, 2 1 = 1 0
            smoothstep 0, 4, 1 = 0.15625
            smoothstep 0, 1, -5 2 0.5 = 0 1 0.5
            smoothstep 1, 0, 0.25 = 0
            smoothstep 1, 1, 2 = 0
            double smoothstep 1, 0, 0.25 = 0.84375",
        );
    }

    #[test]
    fn bits_are_those_of_32() {
        check(
            "isnan nan 1 inf = t f f
            isinf nan -inf inf = f t t
            floatBitsToInt 1 -0 = 1065353216i -2147483648i
            floatBitsToUint 4 -2 = 1082130432u 3221225472u
            intBitsToFloat 1065353216i 2139095040i = 1 inf
            uintBitsToFloat 1048576000u 2143289344u = 0.25 nan
            double floatBitsToInt 0.1 = 1036831949i",
        );
    }
}
