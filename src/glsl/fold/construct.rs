//! Constructors, §5.4.

use super::real::Real;
use super::{Operand, matrix};
use crate::glsl::Precision;
use crate::glsl::arena::Arena;
use crate::glsl::hir::{Value, value_count};
use crate::glsl::types::{Base, Scalar, Struct, Type};

/// The value of a constructor. The arguments are as many and as large as the type asks for; of the
/// last one, components may be left over.
pub fn construct(
    structs: &Arena<Struct>,
    target: Type,
    arguments: &[Operand],
    precision: Precision,
) -> Vec<Value> {
    let count = value_count(structs, target) as usize;
    let given = arguments.iter().flat_map(|argument| argument.values);
    let Some(scalar) = target.scalar() else {
        // Members and elements have the types that they are for.
        return given.copied().collect();
    };
    let real = Real(precision);
    match (target.base, arguments) {
        (Base::Matrix { rows, .. }, [Operand { values: [only], .. }]) => {
            let diagonal = convert(*only, scalar, real);
            identity(count, rows, diagonal)
        }
        (Base::Matrix { rows, .. }, [argument]) if argument.ty.is_matrix() => {
            let mut result = identity(count, rows, Value::Float(1.0));
            let (_, height) = matrix::shape(*argument);
            let columns = result.chunks_mut(rows.into());
            for (into, from) in columns.zip(argument.values.chunks(height)) {
                for (into, from) in into.iter_mut().zip(from) {
                    *into = *from;
                }
            }
            result
        }
        (_, [Operand { values: [only], .. }]) => vec![convert(*only, scalar, real); count],
        _ => given
            .take(count)
            .map(|&value| convert(value, scalar, real))
            .collect(),
    }
}

/// The columns of a matrix with one value on the diagonal and 0 elsewhere.
fn identity(count: usize, rows: u8, diagonal: Value) -> Vec<Value> {
    let rows = usize::from(rows);
    let at = |i| match i / rows == i % rows {
        true => diagonal,
        false => Value::Float(0.0),
    };
    (0..count).map(at).collect()
}

/// A component as another type, §5.4.1. A `float` that no integer of the type is near to is undefined:
/// it becomes what the processors make of it on which WebGL2 mostly compiles.
fn convert(value: Value, scalar: Scalar, real: Real) -> Value {
    match scalar {
        Scalar::Float => Value::Float(match value {
            Value::Float(x) => x,
            Value::Int(x) => real.round(x.into()),
            Value::Uint(x) => real.round(x.into()),
            Value::Bool(x) => f64::from(u8::from(x)),
        }),
        Scalar::Int => Value::Int(match value {
            Value::Float(x) => to_int(x),
            Value::Int(x) => x,
            Value::Uint(x) => x as i32,
            Value::Bool(x) => x.into(),
        }),
        Scalar::Uint => Value::Uint(match value {
            Value::Float(x) if x < 0.0 => to_int(x) as u32,
            // A conversion to 64 bits whose lower half is taken.
            Value::Float(x) if x < 2f64.powi(63) => x as i64 as u32,
            Value::Float(_) => 0,
            Value::Int(x) => x as u32,
            Value::Uint(x) => x,
            Value::Bool(x) => x.into(),
        }),
        Scalar::Bool => Value::Bool(match value {
            Value::Float(x) => x != 0.0,
            Value::Int(x) => x != 0,
            Value::Uint(x) => x != 0,
            Value::Bool(x) => x,
        }),
    }
}

/// Towards zero; out of range it is the least `int`.
fn to_int(x: f64) -> i32 {
    let range = -2_147_483_649.0..2_147_483_648.0;
    if x > range.start && x < range.end {
        x as i32
    } else {
        i32::MIN
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{show, values};
    use super::*;
    use crate::glsl::names::Names;
    use crate::glsl::types::Field;

    /// What a constructor makes of arguments that are divided by commas. An argument of four floats
    /// behind `m` is a `mat2`, one of six a `mat2x3`.
    fn make(target: Type, arguments: &str) -> String {
        let read: Vec<_> = arguments
            .split(',')
            .map(|text| match text.trim().strip_prefix('m') {
                Some(rest) => {
                    let each = rest.split_whitespace().flat_map(|word| values(word).1);
                    let values: Vec<_> = each.collect();
                    (Type::matrix(2, values.len() as u8 / 2), values)
                }
                None => values(text),
            })
            .collect();
        let operands: Vec<_> = read
            .iter()
            .map(|(ty, values)| Operand { ty: *ty, values })
            .collect();
        show(&construct(
            &Arena::default(),
            target,
            &operands,
            Precision::Single,
        ))
    }

    fn ty(word: &str) -> Type {
        Base::from_keyword(word).expect(word).into()
    }

    #[test]
    fn components_are_taken_and_converted() {
        for (target, arguments, expected) in [
            ("float", "3i", "3"),
            ("float", "2.5 7", "2.5"),
            ("float", "16777217i", "16777216"),
            ("float", "t", "1"),
            ("int", "-2.7", "-2i"),
            ("int", "4294967295u", "-1i"),
            ("int", "f", "0i"),
            ("uint", "-1i", "4294967295u"),
            ("uint", "4294967040", "4294967040u"),
            ("bool", "0.5", "t"),
            ("bool", "-0", "f"),
            ("bool", "nan", "t"),
            ("bool", "2i", "t"),
            ("vec3", "1i", "1 1 1"),
            ("vec3", "1, 2 3", "1 2 3"),
            ("vec2", "1 2 3", "1 2"),
            ("vec3", "1i, 2u, t", "1 2 1"),
            ("vec4", "1, 2 3 4 5", "1 2 3 4"),
            ("vec4", "m1 2 3 4", "1 2 3 4"),
            ("ivec2", "1.9 -1.9", "1i -1i"),
            ("bvec2", "0 3", "f t"),
            ("mat2", "3i", "3 0 0 3"),
            ("mat3x2", "2", "2 0 0 2 0 0"),
            ("mat2", "1, 2 3, 4i", "1 2 3 4"),
            ("mat3", "m1 2 3 4", "1 2 0 3 4 0 0 0 1"),
            ("mat2", "m1 2 3 4 5 6", "1 2 4 5"),
            ("mat3x2", "m1 2 3 4 5 6", "1 2 4 5 0 0"),
        ] {
            assert_eq!(
                make(ty(target), arguments),
                expected,
                "{target} {arguments}"
            );
        }
    }

    #[test]
    fn numbers_out_of_range_have_definite_values() {
        for (target, arguments, expected) in [
            ("int", "3000000000", "-2147483648i"),
            ("int", "-inf", "-2147483648i"),
            ("int", "nan", "-2147483648i"),
            ("int", "-2147483648", "-2147483648i"),
            ("uint", "-1.5", "4294967295u"),
            ("uint", "-inf", "2147483648u"),
            ("uint", "4294967296", "0u"),
            ("uint", "inf", "0u"),
            ("uint", "nan", "0u"),
        ] {
            assert_eq!(
                make(ty(target), arguments),
                expected,
                "{target} {arguments}"
            );
        }
    }

    #[test]
    fn arrays_and_structures_are_flat() {
        assert_eq!(make(ty("vec2").array_of(2), "1 2, 3 4"), "1 2 3 4");
        assert_eq!(make(Type::FLOAT.array_of(1), "7"), "7");
        let mut names = Names::default();
        let mut structs = Arena::default();
        let fields = [("a", ty("float")), ("b", ty("ivec2"))];
        let fields = fields.map(|(name, ty)| Field {
            name: names.intern(name),
            ty,
        });
        let structure = Struct::new(None, fields.into(), &structs);
        let id = structs.add(structure);
        let read = ["1.5", "2i 3i"].map(values);
        let operands = read
            .each_ref()
            .map(|(ty, values)| Operand { ty: *ty, values });
        let target = Base::Struct(id).into();
        let made = construct(&structs, target, &operands, Precision::Single);
        assert_eq!(show(&made), "1.5 2i 3i");
    }
}
