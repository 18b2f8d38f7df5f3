//! What numbers mean (GLSL ES 3.00, §4.1.3 and §4.1.4).

/// The value of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number {
    /// A signed integer, as its 32 bits: `4294967295` is -1.
    Int(u32),
    /// An unsigned integer.
    Uint(u32),
    /// A float, rounded to 64 bits; infinite if it is too large even for them.
    Float(f64),
}

/// Why a token that begins like a number is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberError {
    /// It is not spelled like a number.
    Malformed,
    /// It is an integer of more than 32 bits.
    Overflow,
}

/// Evaluates the spelling of a number.
pub fn parse(text: &str) -> Result<Number, NumberError> {
    match text.as_bytes() {
        // Most integers by far are a single digit.
        [digit @ b'0'..=b'9'] => Ok(Number::Int(u32::from(digit - b'0'))),
        bytes if let Some(value) = short_float(bytes) => Ok(Number::Float(value)),
        _ if is_float(text) => {
            let digits = text.strip_suffix(['f', 'F']).unwrap_or(text);
            digits
                .parse()
                .map(Number::Float)
                .map_err(|_| NumberError::Malformed)
        }
        _ => integer(text),
    }
}

/// Whether a token that begins like a number is one: an integer of at most 32 bits or a float.
pub fn is_well_formed(text: &str) -> bool {
    is_float(text) || integer(text).is_ok()
}

fn integer(text: &str) -> Result<Number, NumberError> {
    let unsigned = text.strip_suffix(['u', 'U']);
    let digits = unsigned.unwrap_or(text);
    let (digits, radix) = match digits.as_bytes() {
        [b'0', b'x' | b'X', ..] => (&digits[2..], 16),
        [b'0', _, ..] => (&digits[1..], 8),
        _ => (digits, 10),
    };
    let is_digit = |byte: u8| char::from(byte).is_digit(radix);
    if digits.is_empty() || !digits.bytes().all(is_digit) {
        return Err(NumberError::Malformed);
    }
    let bits = u32::from_str_radix(digits, radix).map_err(|_| NumberError::Overflow)?;
    Ok(match unsigned {
        Some(_) => Number::Uint(bits),
        None => Number::Int(bits),
    })
}

/// The value of a float of a few digits and a point, as most are. Whole numbers and powers of ten up
/// to 10¹⁵ are exact in 64 bits, so that the quotient is as near as can be.
fn short_float(text: &[u8]) -> Option<f64> {
    const POWERS: [f64; 16] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
    ];
    if !(2..=POWERS.len()).contains(&text.len()) {
        return None;
    }
    let mut whole = 0_u64;
    let mut point = None;
    for (at, byte) in text.iter().enumerate() {
        match byte {
            b'0'..=b'9' => whole = whole * 10 + u64::from(byte - b'0'),
            b'.' if point.is_none() => point = Some(at),
            _ => return None,
        }
    }
    let decimals = text.len() - 1 - point?;
    Some(whole as f64 / POWERS[decimals])
}

fn is_float(text: &str) -> bool {
    let number = text.strip_suffix(['f', 'F']).unwrap_or(text);
    let (mantissa, exponent) = match number.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (number, None),
    };
    let all_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let is_mantissa = match mantissa.split_once('.') {
        Some((whole, part)) => all_digits(whole) && all_digits(part) && mantissa.len() > 1,
        None => exponent.is_some() && all_digits(mantissa) && !mantissa.is_empty(),
    };
    let is_exponent = exponent.is_none_or(|exponent| {
        let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        all_digits(digits) && !digits.is_empty()
    });
    is_mantissa && is_exponent
}

#[cfg(test)]
mod tests {
    use super::Number::{Float, Int, Uint};
    use super::NumberError::{Malformed, Overflow};
    use super::{is_well_formed, parse};

    #[test]
    fn numbers() {
        for (text, value) in [
            ("0", Int(0)),
            ("7", Int(7)),
            ("42u", Uint(42)),
            ("0x1F", Int(31)),
            ("0XffU", Uint(255)),
            ("0u", Uint(0)),
            ("017", Int(15)),
            ("2147483648", Int(1 << 31)),
            ("4294967295", Int(u32::MAX)),
            ("0xFFFFFFFFu", Uint(u32::MAX)),
            ("037777777777", Int(u32::MAX)),
            ("1.", Float(1.0)),
            (".5", Float(0.5)),
            ("1.5f", Float(1.5)),
            ("1e3", Float(1000.0)),
            ("1.e-3F", Float(0.001)),
            (".5e1", Float(5.0)),
            ("08.5", Float(8.5)),
            ("00.", Float(0.0)),
            ("1E+9f", Float(1e9)),
            ("1e9999", Float(f64::INFINITY)),
            ("1e-9999", Float(0.0)),
        ] {
            assert_eq!(parse(text), Ok(value), "{text}");
            assert!(is_well_formed(text), "{text}");
        }
        for (text, error) in [
            ("08", Malformed),
            ("0189", Malformed),
            ("0x", Malformed),
            ("0xg", Malformed),
            ("0xu", Malformed),
            ("1f", Malformed),
            ("1abc", Malformed),
            ("1e", Malformed),
            ("1e+", Malformed),
            ("1.2.3", Malformed),
            ("1.0lf", Malformed),
            ("1u.0", Malformed),
            ("1uu", Malformed),
            ("1.0u", Malformed),
            ("0x1.0", Malformed),
            ("0b101", Malformed),
            ("1__0", Malformed),
            ("1.x", Malformed),
            ("0+1", Malformed),
            ("+1", Malformed),
            (".", Malformed),
            ("u", Malformed),
            ("", Malformed),
            ("4294967296", Overflow),
            ("4294967296u", Overflow),
            ("0x100000000", Overflow),
            ("040000000000", Overflow),
            ("99999999999999999999999999", Overflow),
        ] {
            assert_eq!(parse(text), Err(error), "{text}");
            assert!(!is_well_formed(text), "{text}");
        }
    }
}
