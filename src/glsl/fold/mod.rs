//! The value of operators, constructors and built-in functions whose operands are constants.
//!
//! In single precision every step is rounded to 32 bits, and what the specification leaves undefined
//! has the value that WebGL2 gives it, since that is what authors see: it folds in the same places,
//! and mostly puts 0 where a GPU would make NaN. In double precision floats follow IEEE 754.

mod call;
mod common;
mod construct;
mod geometric;
mod matrix;
mod operator;
mod pack;
mod real;
mod relational;
mod transcendental;

use self::call::Call;
use self::real::Real;
use super::Precision;
use super::builtins::Builtin;
use super::hir::Value;
use super::types::Type;

pub use self::construct::construct;
pub use self::operator::{binary, unary};

/// A constant with its type.
#[derive(Clone, Copy, Debug)]
pub struct Operand<'a> {
    /// Its type.
    pub ty: Type,
    /// Its components, as [`Constant`](super::hir::Constant) has them.
    pub values: &'a [Value],
}

/// What a call of a built-in function with constant arguments returns, of the type that
/// [`Builtin::result`] gives; `None` if calls are never constant: textures, derivatives and `modf`.
pub fn builtin(
    function: Builtin,
    arguments: &[Operand],
    result: Type,
    precision: Precision,
) -> Option<Vec<Value>> {
    let call = Call::new(arguments, result, Real(precision));
    match function.section() {
        "8.1" | "8.2" => transcendental::fold(function, &call),
        "8.3" => common::fold(function, &call),
        "8.4" => pack::fold(function, &call),
        "8.5" => geometric::fold(function, &call),
        "8.6" => matrix::fold(function, &call),
        "8.7" => relational::fold(function, &call),
        _ => None,
    }
}

/// The number in a component that is known to be a `float`.
fn float(value: Value) -> f64 {
    match value {
        Value::Float(x) => x,
        Value::Int(_) | Value::Uint(_) | Value::Bool(_) => {
            debug_assert!(false, "{value:?} is no float");
            f64::NAN
        }
    }
}

/// The truth in a component that is known to be a `bool`.
fn truth(value: Value) -> bool {
    debug_assert!(matches!(value, Value::Bool(_)), "{value:?} is no bool");
    matches!(value, Value::Bool(true))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glsl::types::Scalar;

    /// Values written as `1.5 -2`, `1i`, `1u`, `t`, `f`, with the type that they have together.
    pub fn values(text: &str) -> (Type, Vec<Value>) {
        let values: Vec<_> = text.split_whitespace().map(value).collect();
        let scalar = match values[0] {
            Value::Float(_) => Scalar::Float,
            Value::Int(_) => Scalar::Int,
            Value::Uint(_) => Scalar::Uint,
            Value::Bool(_) => Scalar::Bool,
        };
        (Type::vector(scalar, values.len() as u8), values)
    }

    fn value(word: &str) -> Value {
        match word {
            "t" => Value::Bool(true),
            "f" => Value::Bool(false),
            "inf" => Value::Float(f64::INFINITY),
            "-inf" => Value::Float(f64::NEG_INFINITY),
            "nan" => Value::Float(f64::NAN),
            _ => match (word.strip_suffix('i'), word.strip_suffix('u')) {
                (Some(int), _) => Value::Int(int.parse().expect(word)),
                (_, Some(uint)) => Value::Uint(uint.parse().expect(word)),
                _ => Value::Float(f64::from(word.parse::<f32>().expect(word))),
            },
        }
    }

    /// Values as [`values`] reads them, floats with the shortest digits of 32 bits.
    pub fn show(values: &[Value]) -> String {
        let words = values.iter().map(|value| match *value {
            Value::Float(x) if x.is_nan() => "nan".to_owned(),
            Value::Float(x) => format!("{}", x as f32),
            Value::Int(x) => format!("{x}i"),
            Value::Uint(x) => format!("{x}u"),
            Value::Bool(true) => "t".to_owned(),
            Value::Bool(false) => "f".to_owned(),
        });
        words.collect::<Vec<_>>().join(" ")
    }

    /// Checks lines of `function argument, argument = result`, where a single word stands for a
    /// function of single precision or, behind `double`, of double.
    pub fn check(lines: &str) {
        for line in lines.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let (call, expected) = line.split_once('=').expect("an equals sign");
            let (precision, call) = match call.strip_prefix("double ") {
                Some(rest) => (Precision::Double, rest),
                None => (Precision::Single, call),
            };
            let (name, arguments) = call.split_once(' ').expect("arguments");
            let arguments: Vec<_> = arguments.split(',').map(values).collect();
            let operands: Vec<_> = arguments
                .iter()
                .map(|(ty, values)| Operand { ty: *ty, values })
                .collect();
            let types: Vec<_> = operands.iter().map(|operand| operand.ty).collect();
            let function = Builtin::find(name).expect(line);
            let result = function.result(&types).expect(line);
            let folded = builtin(function, &operands, result, precision).expect(line);
            assert_eq!(show(&folded), expected.trim(), "{line}");
            assert_eq!(values(expected).0, result, "{line}");
        }
    }

    #[test]
    fn every_pure_function_of_constants_folds() {
        for function in Builtin::ALL {
            // Some signature of scalars or small vectors fits every function that takes no sampler.
            let sizes = [1, 2, 3].into_iter();
            let scalars = [Scalar::Float, Scalar::Int, Scalar::Uint, Scalar::Bool];
            let single = sizes.flat_map(|size| scalars.map(|scalar| Type::vector(scalar, size)));
            let types = single.chain([Type::matrix(2, 2)]).flat_map(|ty| {
                let all = (1..=3).map(move |count| vec![ty; count]);
                all.chain([vec![ty, ty, Type::FLOAT]])
            });
            let mut folded = 0;
            for types in types {
                let Some(result) = function.result(&types) else {
                    continue;
                };
                let values: Vec<_> = types.iter().map(|ty| zeros(*ty)).collect();
                let operands: Vec<_> = types
                    .iter()
                    .zip(&values)
                    .map(|(&ty, values)| Operand { ty, values })
                    .collect();
                for precision in [Precision::Single, Precision::Double] {
                    let values = builtin(function, &operands, result, precision);
                    assert_eq!(values.is_some(), function.is_constant_expression());
                    if let Some(values) = values {
                        assert_eq!(values.len(), zeros(result).len(), "{function:?} {types:?}");
                    }
                }
                folded += 1;
            }
            assert_eq!(folded == 0, function.is_texture_function(), "{function:?}");
        }
    }

    fn zeros(ty: Type) -> Vec<Value> {
        let count = crate::glsl::hir::value_count(&Default::default(), ty);
        let zero = match ty.scalar() {
            Some(Scalar::Int) => Value::Int(0),
            Some(Scalar::Uint) => Value::Uint(0),
            Some(Scalar::Bool) => Value::Bool(false),
            _ => Value::Float(0.0),
        };
        vec![zero; count as usize]
    }
}
