//! What is wrong with a pass as a whole.

use super::preamble;
use crate::glsl::lower::{Excess, MAX_BLOCKS, MAX_FUNCTIONS, MAX_OPERATIONS};
use crate::glsl::places::Places;
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
            "ShaderToy code draws in `{header}`; a plain fragment shader draws in `void main()` and \
             sets `gl_FragColor`"
        )
    } else if has(name) {
        format!("the function `{name}` must be `{header}`")
    } else {
        let plain = match name {
            "mainImage" => ", a plain fragment shader in `void main()`",
            _ => "",
        };
        format!("ShaderToy code begins in `{header}`{plain}")
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

/// A text of which more becomes than graphics libraries bear.
pub(super) fn excess(excess: Excess, places: Places<'_>) -> Diagnostic {
    let (diagnostic, at) = match excess {
        Excess::Depth(at) => {
            let message = format!("statements are nested more than {MAX_BLOCKS} deep before this");
            let diagnostic = Diagnostic::error("too-deep", message);
            let hint = "move part of them into a function; choices of `?:`, `&&` and `||` count";
            (diagnostic.hint(hint), at)
        }
        Excess::Size(at) => {
            let message = format!("the program has more than {MAX_OPERATIONS} operations");
            let diagnostic = Diagnostic::error("too-complex", message);
            let hint = "use loops and functions; values of large structures count by their members";
            (diagnostic.hint(hint), at)
        }
        Excess::Functions(at) => {
            let message = format!("more than {MAX_FUNCTIONS} functions are called");
            let diagnostic = Diagnostic::error("too-complex", message);
            (diagnostic.hint("join some, or use loops"), at)
        }
    };
    places.point(diagnostic, at)
}

/// A fault of this program, not of the author's.
pub(super) fn internal(message: &str) -> Diagnostic {
    let message = message.replace('\n', " ");
    Diagnostic::error("internal", format!("the translator failed: {message}"))
        .hint("this is a fault of Vitrine: please report it with the shader")
}
