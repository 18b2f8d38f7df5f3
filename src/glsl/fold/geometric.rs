//! Geometric functions, §8.5, of scalars too.

use super::call::Call;
use super::real::Real;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Value;

/// The value of a call; `None` if the function is of another section.
pub(super) fn fold(function: Builtin, call: &Call) -> Option<Vec<Value>> {
    let real = call.real;
    let dot = |a, b| real.dot(call.floats(a).zip(call.floats(b)));
    Some(match function {
        Builtin::Length => call.one(length(call.floats(0), real)),
        Builtin::Distance => {
            let pairs = call.floats(0).zip(call.floats(1));
            call.one(length(pairs.map(|(a, b)| real.subtract(a, b)), real))
        }
        Builtin::Dot => call.one(dot(0, 1)),
        Builtin::Cross => call.each_float(|i| {
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            let product = |a, b| real.multiply(call.float(0, a), call.float(1, b));
            product(j, k) - product(k, j)
        }),
        Builtin::Normalize => {
            let length = length(call.floats(0), real);
            call.map(|x| real.unless(length == 0.0, x / length))
        }
        Builtin::FaceForward => {
            let sign = if dot(2, 1) < 0.0 { 1.0 } else { -1.0 };
            call.map(|x| sign * x)
        }
        Builtin::Reflect => {
            let twice = real.multiply(2.0, dot(1, 0));
            call.map2(|incident, normal| incident - real.multiply(twice, normal))
        }
        Builtin::Refract => {
            let eta = call.float(2, 0);
            let along = dot(1, 0);
            let rest = real.subtract(1.0, real.multiply(along, along));
            let k = real.subtract(1.0, real.multiply(real.multiply(eta, eta), rest));
            if k < 0.0 {
                return Some(call.each_float(|_| 0.0));
            }
            let bend = real.add(real.multiply(eta, along), real.sqrt(k));
            call.map2(|incident, normal| real.multiply(eta, incident) - real.multiply(bend, normal))
        }
        _ => return None,
    })
}

/// The length of a vector.
fn length(vector: impl Iterator<Item = f64> + Clone, real: Real) -> f64 {
    real.sqrt(real.dot(vector.clone().zip(vector)))
}

#[cfg(test)]
mod tests {
    use super::super::tests::check;

    #[test]
    fn vectors_have_lengths_and_directions() {
        check(
            "length 3 4 = 5
            length -2 = 2
            length 1e20 1e20 = inf
            distance 1 2, 4 6 = 5
            distance 3, 5 = 2
            dot 1 2 3 4, 5 6 7 8 = 70
            cross 1 2 3, 7 5 6 = -3 15 -9
            normalize 0 3 4 = 0 0.6 0.8
            normalize -7 = -1
            normalize 0 0 = 0 0
            double normalize 0 0 = nan nan
            faceforward 1 2, 1 0, 1 1 = -1 -2
            faceforward 1 2, -1 0, 1 1 = 1 2
            reflect 3 4, 0 1 = 3 -4
            refract 0.6 -0.8, 0 1, 0.75 = 0.45000002 -0.89302856
            refract 1 0, 0 1, 2 = 0 0",
        );
    }
}
