//! What is wrong with a pass as a whole.

use super::preamble;
use crate::scene::PassKind;
use crate::source::Diagnostic;

/// A text without the function that its pass begins in.
pub(super) fn no_entry_point(kind: PassKind, text: &str) -> Diagnostic {
    let (name, header) = preamble::entry_point(kind);
    let has = |word: &str| words(text).any(|found| found == word);
    let hint = if name == "mainImage" && has("mainSound") {
        "this looks like the text of a Sound tab; paste the Image tab".to_owned()
    } else if has("main") {
        format!(
            "this looks like a plain fragment shader: ShaderToy code draws in `{header}` instead of \
             `main` and `gl_FragColor`"
        )
    } else if has(name) {
        format!("the function `{name}` must be `{header}`")
    } else {
        format!("ShaderToy code begins in `{header}`")
    };
    let code = match kind {
        PassKind::Image | PassKind::Buffer(_) => "no-main-image",
        PassKind::Cube => "no-main-cubemap",
        PassKind::Sound => "no-main-sound",
    };
    let parameters = &header[header.find('(').unwrap_or(0)..];
    Diagnostic::error(code, format!("there is no `{name}{parameters}`")).hint(hint)
}

/// The names in a text, comments not excepted.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
}

/// A fault of this program, not of the author's.
pub(super) fn internal(message: &str) -> Diagnostic {
    let message = message.replace('\n', " ");
    Diagnostic::error("internal", format!("the translator failed: {message}"))
        .hint("this is a fault of Vitrine: please report it with the shader")
}
