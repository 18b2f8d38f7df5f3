//! Pairs of numbers in the halves of a `uint`, §8.4; the first is in the lower half.

use super::call::Call;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Value;

/// The value of a call; `None` if the function is of another section.
pub(super) fn fold(function: Builtin, call: &Call) -> Option<Vec<Value>> {
    let real = call.real;
    let scaled = |x: f64, low: f64, limit: f64| {
        // NaN becomes the lower limit.
        let x = if x > low { x.min(1.0) } else { low };
        real.multiply(x, limit).round() as i32 as u16
    };
    Some(match function {
        Builtin::PackSnorm2x16 => pack(call, |x| scaled(x, -1.0, 32767.0)),
        Builtin::PackUnorm2x16 => pack(call, |x| scaled(x, 0.0, 65535.0)),
        Builtin::PackHalf2x16 => pack(call, |x| to_half(x as f32)),
        Builtin::UnpackSnorm2x16 => unpack(call, |half| {
            real.divide(f64::from(half as i16), 32767.0).max(-1.0)
        }),
        Builtin::UnpackUnorm2x16 => unpack(call, |half| f64::from(half) / 65535.0),
        Builtin::UnpackHalf2x16 => unpack(call, |half| from_half(half).into()),
        _ => return None,
    })
}

fn pack(call: &Call, half: impl Fn(f64) -> u16) -> Vec<Value> {
    let [low, high] = [0, 1].map(|i| u32::from(half(call.float(0, i))));
    vec![Value::Uint(high << 16 | low)]
}

fn unpack(call: &Call, number: impl Fn(u16) -> f64) -> Vec<Value> {
    let bits = match call.value(0, 0) {
        Value::Uint(bits) => bits,
        _ => 0,
    };
    call.each_float(|i| number((bits >> (16 * i)) as u16))
}

/// The nearest float of 16 bits, the even one of two; NaN is always the same.
fn to_half(x: f32) -> u16 {
    let sign = (x.to_bits() >> 16) as u16 & 0x8000;
    let bits = x.to_bits() & 0x7fff_ffff;
    // From half a step above the largest half, 65504, on.
    const INFINITE: u32 = 0x477f_f000;
    // The smallest half that has all digits.
    const NORMAL: u32 = 0x3880_0000;
    match bits {
        0x7f80_0001.. => 0x7fff,
        INFINITE.. => sign | 0x7c00,
        NORMAL.. => {
            let even = bits >> 13 & 1;
            sign | ((bits - (112 << 23) + 0xfff + even) >> 13) as u16
        }
        _ => sign | (f64::from(x.abs()) * f64::from(1 << 24)).round_ties_even() as u16,
    }
}

/// The number that a float of 16 bits is.
fn from_half(half: u16) -> f32 {
    let sign = u32::from(half & 0x8000) << 16;
    let bits = u32::from(half & 0x7fff);
    match bits >> 10 {
        0 => f32::from_bits(sign | (bits as f32 / (1 << 24) as f32).to_bits()),
        0x1f => f32::from_bits(sign | 0x7f80_0000 | bits << 13),
        _ => f32::from_bits(sign | ((bits << 13) + (112 << 23))),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::check;
    use super::*;

    #[test]
    fn pairs_are_packed_and_unpacked() {
        check(
            "packUnorm2x16 1 0 = 65535u
            packUnorm2x16 2 -3 = 65535u
            packUnorm2x16 0.5 nan = 32768u
            packSnorm2x16 1 -1 = 2147581951u
            packSnorm2x16 -0.5 0 = 49152u
            packHalf2x16 0.5 1 = 1006647296u
            packHalf2x16 1 -2 = 3221240832u
            unpackUnorm2x16 4294901760u = 0 1
            unpackSnorm2x16 32768u = -1 0
            unpackHalf2x16 1006647296u = 0.5 1",
        );
    }

    #[test]
    fn halves_are_the_nearest() {
        for (x, half) in [
            (0.0, 0),
            (-0.0, 0x8000),
            (1.0, 0x3c00),
            (65504.0, 0x7bff),
            (65519.99, 0x7bff),
            (65520.0, 0x7c00),
            (f32::NEG_INFINITY, 0xfc00),
            (f32::NAN, 0x7fff),
            (2049.0, 0x6800),
            (2051.0, 0x6802),
            (2f32.powi(-14), 0x0400),
            (2f32.powi(-24), 0x0001),
            (2f32.powi(-25), 0x0000),
            (2f32.powi(-25) * 1.01, 0x0001),
            (2f32.powi(-14) * 0.9999, 0x0400),
        ] {
            assert_eq!(to_half(x), half, "{x}");
        }
        for half in 0..=0xffff {
            let x = from_half(half);
            if x.is_nan() {
                assert_eq!(half & 0x7c00, 0x7c00);
            } else {
                assert_eq!(to_half(x), half, "{x}");
            }
        }
        assert_eq!(from_half(0x0001), 2f32.powi(-24));
        assert_eq!(from_half(0x3555), 0.333_251_95);
    }
}
