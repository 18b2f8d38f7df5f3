//! Relations between the components of vectors, §8.7.

use super::call::Call;
use super::truth;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Value;

/// The value of a call; `None` if the function is of another section.
pub(super) fn fold(function: Builtin, call: &Call) -> Option<Vec<Value>> {
    let compare = |holds: fn(f64, f64) -> bool| {
        call.each(|i| {
            let [a, b] = [0, 1].map(|argument| number(call.value(argument, i)));
            Value::Bool(holds(a, b))
        })
    };
    let mut truths = call.argument(0).values.iter().copied();
    Some(match function {
        Builtin::LessThan => compare(|a, b| a < b),
        Builtin::LessThanEqual => compare(|a, b| a <= b),
        Builtin::GreaterThan => compare(|a, b| a > b),
        Builtin::GreaterThanEqual => compare(|a, b| a >= b),
        Builtin::Equal => compare(|a, b| a == b),
        Builtin::NotEqual => compare(|a, b| a != b),
        Builtin::Any => vec![Value::Bool(truths.any(truth))],
        Builtin::All => vec![Value::Bool(truths.all(truth))],
        Builtin::Not => call.each(|i| Value::Bool(!truth(call.value(0, i)))),
        _ => return None,
    })
}

/// A component as a number: 64 bits hold every value of every type.
fn number(value: Value) -> f64 {
    match value {
        Value::Float(x) => x,
        Value::Int(x) => x.into(),
        Value::Uint(x) => x.into(),
        Value::Bool(x) => f64::from(u8::from(x)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::check;

    #[test]
    fn components_are_compared() {
        check(
            "lessThan 1 2 nan, 2 2 1 = t f f
            lessThanEqual -1i 2i, 1i 2i = t t
            greaterThan 4000000000u 1u, 1u 2u = t f
            greaterThanEqual 1 nan, 1 nan = t f
            equal 1 nan 0, 1 nan -0 = t f t
            equal t f, t t = t f
            notEqual 1i 2i, 1i 3i = f t
            notEqual nan 1, nan 1 = t f
            any f t = t
            any f f = f
            all t t = t
            all t f = f
            not t f = f t",
        );
    }
}
