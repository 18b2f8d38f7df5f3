//! Arithmetic of floats in the precision that the program is compiled for.

use crate::glsl::Precision;

/// Computes with floats that are held in 64 bits. Sums, products, quotients and roots of 32-bit
/// floats, computed in 64 bits and then rounded, are those that 32-bit arithmetic gives: twice as many
/// bits and two more make the second rounding harmless.
#[derive(Clone, Copy, Debug)]
pub(super) struct Real(pub(super) Precision);

impl Real {
    /// A number as the precision has it.
    pub(super) fn round(self, x: f64) -> f64 {
        match self.0 {
            Precision::Single => f64::from(x as f32),
            Precision::Double => x,
        }
    }

    pub(super) fn add(self, a: f64, b: f64) -> f64 {
        self.round(a + b)
    }

    pub(super) fn subtract(self, a: f64, b: f64) -> f64 {
        self.round(a - b)
    }

    pub(super) fn multiply(self, a: f64, b: f64) -> f64 {
        self.round(a * b)
    }

    pub(super) fn divide(self, a: f64, b: f64) -> f64 {
        self.round(a / b)
    }

    pub(super) fn sqrt(self, x: f64) -> f64 {
        self.round(x.sqrt())
    }

    /// A value where the specification may leave the operation undefined: WebGL2 makes that 0.
    pub(super) fn unless(self, undefined: bool, value: f64) -> f64 {
        match self.0 {
            Precision::Single if undefined => 0.0,
            _ => value,
        }
    }

    /// The sum of products, from left to right.
    pub(super) fn dot(self, pairs: impl Iterator<Item = (f64, f64)>) -> f64 {
        pairs.fold(0.0, |sum, (a, b)| self.add(sum, self.multiply(a, b)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_precision_is_that_of_32_bits() {
        let numbers = [
            0.1,
            1e-40,
            3e38,
            -7.25,
            1e-20,
            33_554_433.0,
            1.000_000_1,
            -0.3,
            1e-30,
        ];
        let single = Real(Precision::Single);
        for a in numbers.map(|x: f32| x) {
            assert_eq!(
                single.sqrt(a.into()).to_bits(),
                f64::from(a.sqrt()).to_bits()
            );
            for b in numbers {
                let [x, y] = [a, b].map(f64::from);
                assert_eq!(single.add(x, y), f64::from(a + b));
                assert_eq!(single.subtract(x, y), f64::from(a - b));
                assert_eq!(single.multiply(x, y), f64::from(a * b));
                assert_eq!(single.divide(x, y), f64::from(a / b));
            }
        }
        assert_eq!(Real(Precision::Double).add(1.0, 1e-12), 1.0 + 1e-12);
    }
}
