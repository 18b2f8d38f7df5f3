/// Whether a token that begins like a number is one: an integer of at most 32 bits or a float, as
/// GLSL ES 3.00, §4.1.3 and §4.1.4, spells them.
pub(super) fn is_well_formed(text: &str) -> bool {
    is_integer(text) || is_float(text)
}

fn is_integer(text: &str) -> bool {
    let digits = text.strip_suffix(['u', 'U']).unwrap_or(text);
    let (digits, radix) = match digits.as_bytes() {
        [b'0', b'x' | b'X', ..] => (&digits[2..], 16),
        [b'0', _, ..] => (&digits[1..], 8),
        _ => (digits, 10),
    };
    // Rust would take a sign here.
    digits.starts_with(|c: char| c.is_ascii_hexdigit())
        && u32::from_str_radix(digits, radix).is_ok()
}

fn is_float(text: &str) -> bool {
    let number = text.strip_suffix(['f', 'F']).unwrap_or(text);
    let (mantissa, exponent) = match number.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (number, None),
    };
    let all_digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
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
    use super::is_well_formed;

    #[test]
    fn numbers() {
        for good in [
            "0",
            "7",
            "42u",
            "0x1F",
            "0XffU",
            "017",
            "4294967295",
            "1.",
            ".5",
            "1.5f",
            "1e3",
            "1.e-3F",
            "08.5",
            "00.",
            "1E+9f",
        ] {
            assert!(is_well_formed(good), "{good}");
        }
        for bad in [
            "08",
            "0x",
            "0xg",
            "1f",
            "1abc",
            "1e",
            "1e+",
            "1.2.3",
            "1.0lf",
            "1u.0",
            "4294967296",
            "0x100000000",
            "1.0u",
            "0x1.0",
            "1__0",
            "1.x",
            "0+1",
        ] {
            assert!(!is_well_formed(bad), "{bad}");
        }
    }
}
