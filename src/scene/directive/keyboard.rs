//! `#iKeyboard`: functions that tell which keys are held, for a texture of the keyboard in one of the channels.

use std::fmt::Write as _;

/// Rows of the texture. Nothing knows of keys that were let go.
const FUNCTIONS: &str = "\
bool isKeyDown(int key) { return texelFetch(iKeyboard, ivec2(key, 0), 0).x > 0.0; }
bool isKeyPressed(int key) { return texelFetch(iKeyboard, ivec2(key, 1), 0).x > 0.0; }
bool isKeyToggled(int key) { return texelFetch(iKeyboard, ivec2(key, 2), 0).x > 0.0; }
bool isKeyReleased(int key) { return false; }
";

/// Keys by their names, with the extension's spelling.
#[rustfmt::skip]
const KEYS: &[(&str, u32)] = &[
    ("Backspace", 8), ("Tab", 9), ("Enter", 13), ("Shift", 16), ("Ctrl", 17), ("Alt", 18), ("Pause", 19), ("Caps", 20),
    ("Escape", 27), ("PageUp", 33), ("PageDown", 34), ("End", 35), ("Home", 36), ("LeftArrow", 37), ("UpArrow", 38),
    ("RightArrow", 39), ("DownArrow", 40), ("Insert", 45), ("Delete", 46), ("LeftWindow", 91), ("RightWindows", 92),
    ("Select", 93), ("NumpadMultiply", 106), ("NumpadAdd", 107), ("NumpadSubtract", 109), ("NumpadPeriod", 110),
    ("NumpadDivide", 111), ("NumLock", 144), ("ScrollLock", 145), ("SemiColon", 186), ("Equal", 187), ("Comma", 188),
    ("Dash", 189), ("Period", 190), ("ForwardSlash", 191), ("GraveAccent", 192), ("OpenBracket", 219),
    ("BackSlash", 220), ("CloseBraket", 221), ("SingleQuote", 222),
];

/// The text ahead of one that asks for the keyboard. Of the keys it names those that the texts mention.
pub(super) fn text(channel: usize, mentions: impl Fn(&str) -> bool) -> String {
    let letters = (b'A'..=b'Z').map(|key| (char::from(key).to_string(), u32::from(key)));
    let digits = (b'0'..=b'9').map(|key| (char::from(key).to_string(), u32::from(key)));
    let pad = (0..10).map(|digit| (format!("Numpad{digit}"), 96 + digit));
    let functions = (1..=12).map(|number| (format!("F{number}"), 111 + number));
    let named = KEYS.iter().map(|&(name, code)| (name.to_owned(), code));
    let keys = letters
        .chain(digits)
        .chain(pad)
        .chain(functions)
        .chain(named);
    let mut text = format!("#define iKeyboard iChannel{channel}\n{FUNCTIONS}");
    for (name, code) in keys.filter(|(name, _)| mentions(&format!("Key_{name}"))) {
        writeln!(text, "const int Key_{name} = {code};").expect("strings take all text");
    }
    text
}
