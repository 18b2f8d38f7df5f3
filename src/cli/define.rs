//! Macros given on the command line.

/// Reads `NAME=VALUE`; a name alone means 1, as with C compilers.
pub(super) fn define(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').unwrap_or((text, "1"));
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if name.is_empty() {
        return Err("write it as NAME=VALUE, as in STEPS=64".to_owned());
    }
    if !name.chars().all(is_word) || name.starts_with(|c: char| c.is_ascii_digit()) {
        return Err(format!(
            "`{name}` is no name of a macro: it has letters, digits and `_`, no digit first"
        ));
    }
    if name == "defined" || name.starts_with("GL_") || name.contains("__") {
        return Err(format!("GLSL keeps the name `{name}` for itself"));
    }
    if value.contains(['\n', '\r']) {
        return Err("a macro's value is one line".to_owned());
    }
    Ok((name.to_owned(), value.to_owned()))
}

/// Reads `NAME=A,B,C`.
#[cfg(feature = "gpu")]
pub(super) fn vary(text: &str) -> Result<(String, Vec<String>), String> {
    let (name, values) = define(text)?;
    let values: Vec<String> = values
        .split(',')
        .map(|value| value.trim().to_owned())
        .collect();
    match values.iter().any(String::is_empty) {
        true => Err("write it as NAME=A,B,C, as in STEPS=16,32,64".to_owned()),
        false => Ok((name, values)),
    }
}

#[cfg(test)]
mod tests {
    use super::define;

    #[test]
    fn names_and_values() {
        let read = |text| define(text).expect("a definition");
        let pair = |name: &str, value: &str| (name.to_owned(), value.to_owned());
        assert_eq!(read("STEPS=64"), pair("STEPS", "64"));
        assert_eq!(read("_a1=x == y"), pair("_a1", "x == y"));
        assert_eq!(read("EMPTY="), pair("EMPTY", ""));
        assert_eq!(read("DEBUG"), pair("DEBUG", "1"));
    }

    #[test]
    fn what_is_no_definition() {
        for (text, words) in [
            ("", "write it as NAME=VALUE"),
            ("=1", "write it as NAME=VALUE"),
            ("1A=2", "no name"),
            ("A B=2", "no name"),
            ("F(x)=x", "no name"),
            ("\u{e4}=2", "no name"),
            ("GL_ES=0", "for itself"),
            ("defined=1", "for itself"),
            ("a__b", "for itself"),
            ("A=1\n#error", "one line"),
        ] {
            let message = define(text).expect_err(text);
            assert!(message.contains(words), "{text}: {message}");
        }
    }
}
