//! Functions of matrices, §8.6. Products are added in the order in which WebGL2 adds them, so that the
//! last bits agree.

use super::Operand;
use super::call::Call;
use super::float;
use super::real::Real;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Value;
use crate::glsl::types::Base;

/// The value of a call; `None` if the function is of another section.
pub(super) fn fold(function: Builtin, call: &Call) -> Option<Vec<Value>> {
    let real = call.real;
    Some(match function {
        Builtin::MatrixCompMult => call.map2(|a, b| a * b),
        Builtin::OuterProduct => {
            let rows = call.argument(0).values.len();
            call.each_float(|i| call.float(0, i % rows) * call.float(1, i / rows))
        }
        Builtin::Transpose => {
            let (columns, rows) = shape(call.argument(0));
            call.each(|i| call.value(0, i % columns * rows + i / columns))
        }
        Builtin::Determinant => call.one(Square::new(call.argument(0), real).determinant()),
        Builtin::Inverse => {
            let square = Square::new(call.argument(0), real);
            let determinant = square.determinant();
            call.each_float(|i| {
                let cofactor = square.cofactor(i / square.size, i % square.size);
                real.unless(determinant == 0.0, cofactor / determinant)
            })
        }
        _ => return None,
    })
}

/// Numbers of columns and rows.
pub(super) fn shape(matrix: Operand) -> (usize, usize) {
    match matrix.ty.base {
        Base::Matrix { columns, rows } => (columns.into(), rows.into()),
        _ => (1, matrix.values.len()),
    }
}

/// A matrix of up to four columns and as many rows.
struct Square {
    size: usize,
    columns: [[f64; 4]; 4],
    real: Real,
}

impl Square {
    fn new(matrix: Operand, real: Real) -> Self {
        let (size, _) = shape(matrix);
        let mut columns = [[0.0; 4]; 4];
        for (i, &value) in matrix.values.iter().enumerate() {
            columns[i / size][i % size] = float(value);
        }
        Square {
            size,
            columns,
            real,
        }
    }

    /// The matrix without a column and a row.
    fn without(&self, column: usize, row: usize) -> Square {
        let mut columns = [[0.0; 4]; 4];
        let kept = (0..self.size).filter(|&i| i != column);
        for (into, from) in columns.iter_mut().zip(kept) {
            let kept = (0..self.size).filter(|&i| i != row);
            for (into, from) in into.iter_mut().zip(kept.map(|i| self.columns[from][i])) {
                *into = from;
            }
        }
        Square {
            size: self.size - 1,
            columns,
            real: self.real,
        }
    }

    /// The first three of these products less the others.
    fn alternate(&self, products: [[f64; 3]; 6]) -> f64 {
        let real = self.real;
        let [a, b, c, d, e, f] = products.map(|[a, b, c]| real.multiply(real.multiply(a, b), c));
        let sum = real.add(real.add(a, b), c);
        real.subtract(real.subtract(real.subtract(sum, d), e), f)
    }

    fn determinant(&self) -> f64 {
        let real = self.real;
        let [a, b, c, d] = self.columns;
        match self.size {
            1 => a[0],
            2 => real.subtract(real.multiply(a[0], b[1]), real.multiply(b[0], a[1])),
            3 => self.alternate([
                [a[0], b[1], c[2]],
                [b[0], c[1], a[2]],
                [c[0], a[1], b[2]],
                [c[0], b[1], a[2]],
                [b[0], a[1], c[2]],
                [a[0], c[1], b[2]],
            ]),
            _ => {
                let term = |column: usize, first: f64| {
                    // A determinant is that of the transposed matrix; only rounding differs.
                    let minor = self.without(column, 0).transposed().determinant();
                    real.multiply(first, minor)
                };
                let [a, b, c, d] = [term(0, a[0]), term(1, b[0]), term(2, c[0]), term(3, d[0])];
                real.subtract(real.add(real.subtract(a, b), c), d)
            }
        }
    }

    fn transposed(&self) -> Square {
        let at = |column: usize| std::array::from_fn(|row| self.columns[row][column]);
        Square {
            columns: std::array::from_fn(at),
            ..*self
        }
    }

    /// What stands at a place of the adjugate matrix: the inverse, multiplied by the determinant.
    fn cofactor(&self, column: usize, row: usize) -> f64 {
        let minor = self.without(row, column);
        let [a, b, c, _] = minor.columns;
        let value = match minor.size {
            3 => self.alternate([
                [a[0], b[1], c[2]],
                [a[1], b[2], c[0]],
                [a[2], b[0], c[1]],
                [a[0], b[2], c[1]],
                [a[1], b[0], c[2]],
                [a[2], b[1], c[0]],
            ]),
            _ => minor.determinant(),
        };
        if (column + row).is_multiple_of(2) {
            value
        } else {
            -value
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{show, values};
    use super::super::{Operand, builtin};
    use super::*;
    use crate::glsl::Precision;
    use crate::glsl::types::Type;

    /// Folds a function of matrices whose numbers of columns and rows are given; one column is a
    /// vector.
    fn call(
        function: Builtin,
        arguments: &[(u8, u8, &str)],
        precision: Precision,
    ) -> (Type, Vec<Value>) {
        let read: Vec<_> = arguments
            .iter()
            .map(|(_, _, text)| {
                let words = text.split_whitespace();
                let each = words.flat_map(|word| values(word).1);
                each.collect::<Vec<_>>()
            })
            .collect();
        let operands: Vec<_> = arguments
            .iter()
            .zip(&read)
            .map(|(&(columns, rows, _), values)| Operand {
                ty: match columns {
                    1 => Type::vector(crate::glsl::types::Scalar::Float, rows),
                    _ => Type::matrix(columns, rows),
                },
                values,
            })
            .collect();
        let types: Vec<_> = operands.iter().map(|operand| operand.ty).collect();
        let result = function.result(&types).expect("a signature");
        let values = builtin(function, &operands, result, precision).expect("a value");
        (result, values)
    }

    fn single(function: Builtin, arguments: &[(u8, u8, &str)]) -> String {
        show(&call(function, arguments, Precision::Single).1)
    }

    #[test]
    fn matrices_are_multiplied_and_turned() {
        assert_eq!(
            single(
                Builtin::MatrixCompMult,
                &[(2, 2, "1 2 3 4"), (2, 2, "5 6 7 8")]
            ),
            "5 12 21 32"
        );
        assert_eq!(
            single(Builtin::OuterProduct, &[(1, 2, "1 2"), (1, 3, "3 4 5")]),
            "3 6 4 8 5 10"
        );
        assert_eq!(
            single(Builtin::Transpose, &[(2, 3, "1 2 3 4 5 6")]),
            "1 4 2 5 3 6"
        );
    }

    #[test]
    fn determinants_and_inverses() {
        let matrices = [
            (2, "1 2 3 4", "-2"),
            (3, "2 1 0 1 3 1 0 1 4", "18"),
            (4, "1 2 0 1 0 3 1 0 2 0 4 1 1 1 0 5", "65"),
        ];
        for (size, matrix, determinant) in matrices {
            let argument = [(size, size, matrix)];
            assert_eq!(single(Builtin::Determinant, &argument), determinant);
            let (_, inverse) = call(Builtin::Inverse, &argument, Precision::Double);
            let n = usize::from(size);
            let numbers: Vec<f64> = matrix
                .split_whitespace()
                .map(|word| word.parse().expect("a number"))
                .collect();
            for column in 0..n {
                for row in 0..n {
                    let sum: f64 = (0..n)
                        .map(|i| numbers[i * n + row] * float(inverse[column * n + i]))
                        .sum();
                    let expected = f64::from(u8::from(column == row));
                    assert!((sum - expected).abs() < 1e-14, "{size} {column} {row}");
                }
            }
        }
        assert_eq!(
            single(Builtin::Inverse, &[(2, 2, "1 2 3 4")]),
            "-2 1 1.5 -0.5"
        );
    }

    #[test]
    fn a_singular_matrix_has_the_inverse_zero() {
        let argument = [(2, 2, "1 2 2 4")];
        assert_eq!(single(Builtin::Inverse, &argument), "0 0 0 0");
        let (_, double) = call(Builtin::Inverse, &argument, Precision::Double);
        assert_eq!(show(&double), "inf -inf -inf inf");
    }
}
