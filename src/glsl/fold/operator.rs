//! Operators, §5.9.

use super::real::Real;
use super::{Operand, float, matrix, truth};
use crate::glsl::Precision;
use crate::glsl::hir::{BinaryOp, UnaryOp, Value};

/// The value of an operator with one operand.
pub fn unary(op: UnaryOp, operand: Operand, _precision: Precision) -> Vec<Value> {
    let each = operand.values.iter().map(|&value| match (op, value) {
        (UnaryOp::Negate, Value::Float(x)) => Value::Float(-x),
        (UnaryOp::Negate, Value::Int(x)) => Value::Int(x.wrapping_neg()),
        (UnaryOp::Negate, Value::Uint(x)) => Value::Uint(x.wrapping_neg()),
        (UnaryOp::Not, Value::Bool(x)) => Value::Bool(!x),
        (UnaryOp::Complement, Value::Int(x)) => Value::Int(!x),
        (UnaryOp::Complement, Value::Uint(x)) => Value::Uint(!x),
        (_, other) => {
            debug_assert!(false, "{op:?} takes no {other:?}");
            other
        }
    });
    each.collect()
}

/// The value of an operator with two operands, whose types fit as the checker demands.
pub fn binary(op: BinaryOp, left: Operand, right: Operand, precision: Precision) -> Vec<Value> {
    let real = Real(precision);
    match op {
        BinaryOp::Multiply
            if left.ty.is_matrix() && !right.ty.is_scalar()
                || right.ty.is_matrix() && !left.ty.is_scalar() =>
        {
            product(left, right, real)
        }
        BinaryOp::Equal => vec![Value::Bool(equal(left, right))],
        BinaryOp::NotEqual => vec![Value::Bool(!equal(left, right))],
        _ => {
            let size = left.values.len().max(right.values.len());
            let at = |operand: Operand, i: usize| match operand.values {
                [only] => *only,
                values => values[i],
            };
            let each = (0..size).map(|i| component(op, at(left, i), at(right, i), real));
            each.collect()
        }
    }
}

/// The product of linear algebra. A vector is a row on the left and a column on the right.
fn product(left: Operand, right: Operand, real: Real) -> Vec<Value> {
    let (inner, rows) = match left.ty.is_matrix() {
        true => matrix::shape(left),
        false => (left.values.len(), 1),
    };
    let columns = right.values.len() / inner;
    let at = |i: usize| {
        let (column, row) = (i / rows, i % rows);
        let pairs = (0..inner).map(|k| {
            let a = float(left.values[k * rows + row]);
            (a, float(right.values[column * inner + k]))
        });
        Value::Float(real.dot(pairs))
    };
    (0..columns * rows).map(at).collect()
}

/// Whether two values of one type are equal in every component.
fn equal(left: Operand, right: Operand) -> bool {
    let mut pairs = left.values.iter().zip(right.values);
    pairs.all(|pair| match pair {
        (Value::Float(a), Value::Float(b)) => a == b,
        (Value::Int(a), Value::Int(b)) => a == b,
        (Value::Uint(a), Value::Uint(b)) => a == b,
        (Value::Bool(a), Value::Bool(b)) => a == b,
        _ => false,
    })
}

/// The value of an operator that treats every component by itself.
fn component(op: BinaryOp, left: Value, right: Value, real: Real) -> Value {
    match (op, left, right) {
        (BinaryOp::ShiftLeft | BinaryOp::ShiftRight, ..) => shift(op, left, right),
        (_, Value::Float(a), Value::Float(b)) => of_floats(op, a, b, real),
        (_, Value::Int(a), Value::Int(b)) => of_ints(op, a, b),
        (_, Value::Uint(a), Value::Uint(b)) => of_uints(op, a, b),
        _ => {
            let (a, b) = (truth(left), truth(right));
            Value::Bool(match op {
                BinaryOp::LogicalAnd => a && b,
                BinaryOp::LogicalOr => a || b,
                _ => a != b,
            })
        }
    }
}

fn of_floats(op: BinaryOp, a: f64, b: f64, real: Real) -> Value {
    // WebGL2 takes one of the two for the contrary of the other, which shows with NaN.
    let or_unordered = real.0 == Precision::Single && (a.is_nan() || b.is_nan());
    match op {
        BinaryOp::Add => Value::Float(real.add(a, b)),
        BinaryOp::Subtract => Value::Float(real.subtract(a, b)),
        BinaryOp::Multiply => Value::Float(real.multiply(a, b)),
        BinaryOp::Less => Value::Bool(a < b),
        BinaryOp::Greater => Value::Bool(a > b),
        BinaryOp::LessEqual => Value::Bool(a <= b || or_unordered),
        BinaryOp::GreaterEqual => Value::Bool(a >= b || or_unordered),
        _ => {
            debug_assert_eq!(op, BinaryOp::Divide, "floats have no bits");
            Value::Float(real.divide(a, b))
        }
    }
}

/// Dividing by zero gives the largest number, as does what would be one more than that; the remainder
/// with a negative operand is 0. All three are undefined, and what WebGL2 makes of them.
fn of_ints(op: BinaryOp, a: i32, b: i32) -> Value {
    Value::Int(match op {
        BinaryOp::Add => a.wrapping_add(b),
        BinaryOp::Subtract => a.wrapping_sub(b),
        BinaryOp::Multiply => a.wrapping_mul(b),
        BinaryOp::Divide => a.checked_div(b).unwrap_or(i32::MAX),
        BinaryOp::Remainder if b == 0 => i32::MAX,
        BinaryOp::Remainder if a < 0 || b < 0 => 0,
        BinaryOp::Remainder => a % b,
        BinaryOp::BitAnd => a & b,
        BinaryOp::BitOr => a | b,
        BinaryOp::BitXor => a ^ b,
        _ => return ordered(op, &a, &b),
    })
}

fn of_uints(op: BinaryOp, a: u32, b: u32) -> Value {
    Value::Uint(match op {
        BinaryOp::Add => a.wrapping_add(b),
        BinaryOp::Subtract => a.wrapping_sub(b),
        BinaryOp::Multiply => a.wrapping_mul(b),
        BinaryOp::Divide => a.checked_div(b).unwrap_or(u32::MAX),
        BinaryOp::Remainder => a.checked_rem(b).unwrap_or(u32::MAX),
        BinaryOp::BitAnd => a & b,
        BinaryOp::BitOr => a | b,
        BinaryOp::BitXor => a ^ b,
        _ => return ordered(op, &a, &b),
    })
}

fn ordered<T: Ord>(op: BinaryOp, a: &T, b: &T) -> Value {
    Value::Bool(match op {
        BinaryOp::Less => a < b,
        BinaryOp::Greater => a > b,
        BinaryOp::LessEqual => a <= b,
        _ => a >= b,
    })
}

/// A shift by a negative number or by 32 and more is undefined: 0 in WebGL2.
fn shift(op: BinaryOp, left: Value, right: Value) -> Value {
    let by = match right {
        Value::Int(by) => u32::try_from(by).unwrap_or(u32::MAX),
        Value::Uint(by) => by,
        Value::Float(_) | Value::Bool(_) => u32::MAX,
    };
    let to_left = op == BinaryOp::ShiftLeft;
    match left {
        Value::Int(x) if to_left => Value::Int(x.checked_shl(by).unwrap_or(0)),
        Value::Int(x) => Value::Int(x.checked_shr(by).unwrap_or(0)),
        Value::Uint(x) if to_left => Value::Uint(x.checked_shl(by).unwrap_or(0)),
        Value::Uint(x) => Value::Uint(x.checked_shr(by).unwrap_or(0)),
        Value::Float(_) | Value::Bool(_) => left,
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{show, values};
    use super::*;
    use crate::glsl::types::Type;

    /// Folds `a op b`, each of the types that the values have.
    fn fold(line: &str, precision: Precision) -> String {
        let words: Vec<_> = line.split_whitespace().collect();
        let all = all();
        let place = words
            .iter()
            .position(|word| all.iter().any(|op| op.symbol() == *word))
            .expect(line);
        let op = all.into_iter().find(|op| op.symbol() == words[place]);
        let (left, right) = (&words[..place], &words[place + 1..]);
        let [left, right] = [left, right].map(|side| values(&side.join(" ")));
        let operand = |side: &(Type, Vec<Value>)| (side.0, side.1.clone());
        let [(lt, lv), (rt, rv)] = [operand(&left), operand(&right)];
        let left = Operand {
            ty: lt,
            values: &lv,
        };
        let right = Operand {
            ty: rt,
            values: &rv,
        };
        show(&binary(op.expect(line), left, right, precision))
    }

    fn all() -> [BinaryOp; 19] {
        use BinaryOp::*;
        [
            Add,
            Subtract,
            Multiply,
            Divide,
            Remainder,
            ShiftLeft,
            ShiftRight,
            BitAnd,
            BitOr,
            BitXor,
            LogicalAnd,
            LogicalOr,
            LogicalXor,
            Equal,
            NotEqual,
            Less,
            Greater,
            LessEqual,
            GreaterEqual,
        ]
    }

    #[test]
    fn components_are_combined() {
        for (line, expected) in [
            ("0.1 + 0.2", "0.3"),
            ("1 2 - 0.5", "0.5 1.5"),
            ("2 * 1 2 3", "2 4 6"),
            ("1 2 / 4 8", "0.25 0.25"),
            ("16777216 + 1", "16777216"),
            ("3e38 * 10", "inf"),
            ("1 / 0", "inf"),
            ("-1 / 0", "-inf"),
            ("1 / -0", "-inf"),
            ("0 / 0", "nan"),
            ("inf - inf", "nan"),
            ("7i / 2i", "3i"),
            ("-7i / 2i", "-3i"),
            ("7i % 4i", "3i"),
            ("2147483647i + 1i", "-2147483648i"),
            ("65536i * 65536i", "0i"),
            ("0u - 1u", "4294967295u"),
            ("7u / 2u", "3u"),
            ("6i & 3i", "2i"),
            ("6u | 3u", "7u"),
            ("6i 1i ^ 3i", "5i 2i"),
            ("t && f", "f"),
            ("f || t", "t"),
            ("t ^^ t", "f"),
            ("1 < 2", "t"),
            ("2i >= 3i", "f"),
            ("4000000000u > 1u", "t"),
            ("1 2 == 1 2", "t"),
            ("1 2 == 1 3", "f"),
            ("1 2 != 1 3", "t"),
            ("nan == nan", "f"),
            ("0 == -0", "t"),
            ("t f == t f", "t"),
            ("1i 2i << 1i", "2i 4i"),
            ("-16i >> 2u", "-4i"),
            ("2147483648u >> 31i", "1u"),
            ("-1i << 31i", "-2147483648i"),
        ] {
            assert_eq!(fold(line, Precision::Single), expected, "{line}");
        }
        assert_eq!(fold("16777216 + 1", Precision::Double), "16777216");
        let sum = binary(
            BinaryOp::Add,
            Operand {
                ty: Type::FLOAT,
                values: &[Value::Float(0.1)],
            },
            Operand {
                ty: Type::FLOAT,
                values: &[Value::Float(0.2)],
            },
            Precision::Double,
        );
        assert_eq!(float(sum[0]), 0.1 + 0.2);
    }

    #[test]
    fn what_is_undefined_has_definite_values() {
        for (line, expected) in [
            ("1i / 0i", "2147483647i"),
            ("-1i / 0i", "2147483647i"),
            ("1i % 0i", "2147483647i"),
            ("1u / 0u", "4294967295u"),
            ("1u % 0u", "4294967295u"),
            ("-2147483648i / -1i", "2147483647i"),
            ("-2147483648i % -1i", "0i"),
            ("-7i % 3i", "0i"),
            ("7i % -3i", "0i"),
            ("1i << 32i", "0i"),
            ("1u << -1i", "0u"),
            ("-1i >> 32u", "0i"),
            ("nan <= 1", "t"),
            ("nan >= 1", "t"),
            ("nan < 1", "f"),
            ("nan > 1", "f"),
        ] {
            assert_eq!(fold(line, Precision::Single), expected, "{line}");
        }
        assert_eq!(fold("nan <= 1", Precision::Double), "f");
    }

    #[test]
    fn single_operands_are_turned() {
        let one = |op, text| {
            let (ty, values) = values(text);
            let operand = Operand {
                ty,
                values: &values,
            };
            show(&unary(op, operand, Precision::Single))
        };
        assert_eq!(one(UnaryOp::Negate, "1 -2 0"), "-1 2 -0");
        assert_eq!(one(UnaryOp::Negate, "5i -2147483648i"), "-5i -2147483648i");
        assert_eq!(one(UnaryOp::Negate, "1u"), "4294967295u");
        assert_eq!(one(UnaryOp::Not, "t"), "f");
        assert_eq!(one(UnaryOp::Complement, "0i 5i"), "-1i -6i");
        assert_eq!(one(UnaryOp::Complement, "0u"), "4294967295u");
    }

    #[test]
    fn matrices_are_multiplied_by_rows_and_columns() {
        let numbers = |text: &str| -> Vec<Value> {
            let words = text.split_whitespace();
            words.flat_map(|word| values(word).1).collect()
        };
        let square = (Type::matrix(2, 2), numbers("1 2 3 4"));
        let wide = (Type::matrix(3, 2), numbers("1 2 3 4 5 6"));
        let two = values("5 7");
        let three = values("1 10 100");
        let multiply = |left: &(Type, Vec<Value>), right: &(Type, Vec<Value>)| {
            let [left, right] = [left, right].map(|side| Operand {
                ty: side.0,
                values: &side.1,
            });
            show(&binary(BinaryOp::Multiply, left, right, Precision::Single))
        };
        assert_eq!(multiply(&square, &square), "7 10 15 22");
        assert_eq!(multiply(&square, &wide), "7 10 15 22 23 34");
        assert_eq!(multiply(&square, &two), "26 38");
        assert_eq!(multiply(&two, &square), "19 43");
        assert_eq!(multiply(&wide, &three), "531 642");
        assert_eq!(multiply(&two, &wide), "19 43 67");
        assert_eq!(multiply(&square, &values("2")), "2 4 6 8");
        assert_eq!(multiply(&values("2"), &square), "2 4 6 8");
    }
}
