//! Directives that ask something of the compiler: `#pragma`, `#extension` and `#version`.

use super::condition::wrong;
use super::directive::Directives;
use super::token::{Kind, Token};
use crate::glsl::words::Symbol;
use crate::source::Diagnostic;

/// `#pragma name` and `#pragma name(value)`. What nobody knows is overlooked.
pub(super) fn pragma(source: &mut Directives<'_>, rest: &[Token]) {
    let is_spelled = |token: &Token, expected: &str| source.names.text(token.spelling) == expected;
    let (is_standard, rest) = match rest {
        [first, rest @ ..] if is_spelled(first, "STDGL") => (true, rest),
        _ => (false, rest),
    };
    let is_word = |token: &Token| token.kind == Kind::Identifier;
    let (name, value) = match rest {
        [name] if is_word(name) => (name, None),
        [name, open, value, close]
            if is_word(name)
                && open.is(Symbol::LeftParenthesis)
                && is_word(value)
                && close.is(Symbol::RightParenthesis) =>
        {
            (name, Some(value))
        }
        _ => return,
    };
    let is_value = |expected: &str| value.is_some_and(|value| is_spelled(value, expected));
    let problem = match (is_standard, source.names.text(name.spelling)) {
        (true, "invariant") if is_value("all") => wrong(
            name.span,
            "a fragment shader cannot ask for `invariant(all)`",
        ),
        (false, "optimize" | "debug") if !is_value("on") && !is_value("off") => {
            let message = format!("`{}` wants `(on)` or `(off)`", source.quoted(name));
            wrong(value.unwrap_or(name).span, message)
        }
        _ => return,
    };
    source.report(problem.hint("remove the line"));
}

/// `#extension name : behaviour`. It may stand only before everything else, and the host's text is
/// always there first.
pub(super) fn extension(source: &mut Directives<'_>, directive: &Token, rest: &[Token]) {
    let is_word = |token: &Token| token.kind == Kind::Identifier;
    let is_shaped = matches!(rest, [name, colon, behaviour]
        if is_word(name) && colon.is(Symbol::Colon) && is_word(behaviour));
    if !is_shaped {
        let message = "`#extension` wants a name, `:` and what to do with it";
        return source.report(wrong(directive.span, message).hint("remove the line"));
    }
    let problem = refused(source, "extension", "WebGL2 refuses `#extension` lines");
    let hint = "remove the line: GLSL ES 3.00 needs no extension for derivatives";
    source.report(problem.at(directive.span).hint(hint));
}

/// `#version`, which may stand only on the first line, and that is the host's.
pub(super) fn version(source: &mut Directives<'_>, directive: &Token, rest: &[Token]) {
    let is_spelled = |token: &Token, expected: &str| source.names.text(token.spelling) == expected;
    let is_ours = matches!(rest, [number, es] if is_spelled(number, "300")
        && is_spelled(es, "es"));
    let (problem, hint) = match is_ours {
        true => (
            refused(source, "version", "WebGL2 refuses a `#version` line here"),
            "remove the line: the text is GLSL ES 3.00 already",
        ),
        false => (
            Diagnostic::error("version", "the text is GLSL ES 3.00, and no other version"),
            "remove the line",
        ),
    };
    source.report(problem.at(directive.span).hint(hint));
}

/// What a browser refuses although its meaning is clear.
fn refused(source: &Directives<'_>, code: &'static str, message: &str) -> Diagnostic {
    match source.options.strict {
        true => Diagnostic::error(code, message),
        false => Diagnostic::warning(code, message),
    }
}
