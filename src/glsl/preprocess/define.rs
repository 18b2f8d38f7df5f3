//! Definitions: those of the language, of the host and of the user, `#define` and `#undef`.

use std::collections::HashSet;
use std::rc::Rc;

use super::condition::wrong;
use super::directive::Directives;
use super::findings::Findings;
use super::lexer::Lexer;
use super::macros::{Macro, Maker};
use super::token::{Kind, Token};
use crate::glsl::builtins::Builtin;
use crate::glsl::names::Name;
use crate::glsl::words::Symbol;
use crate::source::{Diagnostic, Span};

/// Defines what is defined before the text begins, at `start`.
pub(super) fn predefine(source: &mut Directives<'_>, start: Span) {
    for (name, value) in [
        ("GL_ES", "1"),
        ("GL_FRAGMENT_PRECISION_HIGH", "1"),
        ("__VERSION__", "300"),
    ] {
        let value = source.names.intern(value);
        let value = Token::new(Kind::Number, value, start, false);
        source.define(name, vec![value], Maker::Language);
    }
    source.define("__LINE__", Vec::new(), Maker::Line);
    source.define("__FILE__", Vec::new(), Maker::File);
    for &(name, value) in source.options.defines {
        let body = tokens_of(name, value, start, source);
        source.define(name, body, Maker::Host);
    }
    for (name, value) in source.options.overrides {
        if let Some(problem) = unusable(source, name) {
            source.report(Diagnostic::error("override", problem).at(start));
            continue;
        }
        let maker = Maker::User {
            is_mentioned: false,
            has_place: false,
        };
        let body = tokens_of(name, value, start, source);
        source.define(name, body, maker);
    }
}

/// The names among the user's definitions that the text never mentions.
pub(super) fn unused_overrides<'a>(source: &Directives<'a>) -> Vec<&'a str> {
    let is_unused = |name: &&str| {
        let found = source
            .names
            .find(name)
            .and_then(|name| source.macros.find(name));
        found.is_some_and(|found| {
            let maker = source.macros.get(found).maker;
            matches!(
                maker,
                Maker::User {
                    is_mentioned: false,
                    ..
                }
            )
        })
    };
    let names = source.options.overrides.iter();
    names
        .map(|(name, _)| name.as_str())
        .filter(is_unused)
        .collect()
}

/// Why the user cannot define a macro of this name.
fn unusable(source: &Directives<'_>, name: &str) -> Option<String> {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    if name.is_empty() || name.as_bytes()[0].is_ascii_digit() || !name.bytes().all(is_word) {
        return Some(format!("`{name}` cannot be defined: it is no name"));
    }
    let found = source
        .names
        .find(name)
        .and_then(|name| source.macros.find(name));
    let is_predefined = found.is_some_and(|found| source.macros.get(found).is_predefined());
    (is_predefined || is_reserved(name))
        .then(|| format!("`{name}` cannot be defined: the name is reserved"))
}

fn is_reserved(name: &str) -> bool {
    name == "defined" || name.starts_with("GL_")
}

/// The tokens of a value that is in none of the author's files; `place` stands in for its place.
fn tokens_of(name: &str, value: &str, place: Span, source: &mut Directives<'_>) -> Vec<Token> {
    let mut own = Findings::default();
    let mut lexer = Lexer::new(place.file, value, false, &mut own);
    let mut tokens = Vec::new();
    while let Some(mut token) = lexer.next(&mut source.names, &mut own) {
        if token.kind != Kind::LineEnd {
            token.span = place;
            tokens.push(token);
        }
    }
    for problem in own.into_list() {
        let message = format!("in the value of `{name}`: {}", problem.message);
        source.report(Diagnostic { message, ..problem }.at(place));
    }
    tokens
}

/// `#define`.
pub(super) fn define<'a>(source: &mut Directives<'a>, directive: &Token, mut rest: Vec<Token>) {
    let Some(name) = macro_name(source, directive, &rest) else {
        return;
    };
    let old = source.macros.find(name.spelling);
    if old.is_some_and(|old| source.macros.get(old).is_predefined()) {
        let name_text = source.names.text(name.spelling);
        let message = format!("the macro `{name_text}` is already defined, by the language");
        return source.report(wrong(name.span, message));
    }
    if is_reserved(source.names.text(name.spelling)) {
        let message = format!(
            "`{}` cannot be a macro: the name is reserved",
            source.quoted(&name)
        );
        return source.report(wrong(name.span, message));
    }
    let is_function = rest
        .get(1)
        .is_some_and(|next| next.is(Symbol::LeftParenthesis) && !next.has_space());
    let parameters = match is_function {
        false => Ok((None, 1)),
        true => parameters(&name, &rest).map(|(names, length)| (Some(names), 1 + length)),
    };
    let (parameters, length) = match parameters {
        Ok(found) => found,
        Err(problem) => return source.report(problem),
    };
    rest.drain(..length);
    let body = rest;
    if !source.options.overrides.is_empty() {
        for token in body.iter().filter(|token| token.kind == Kind::Identifier) {
            source.macros.find_mentioned(token.spelling);
        }
    }
    let new = Macro::new(parameters, body, Maker::Text(name.span));
    match old {
        Some(old) if source.macros.get(old).is_users() => {
            source.macros.find_mentioned(name.spelling);
            give_place(source.macros.get_mut(old), name.span);
        }
        Some(old) if !source.macros.get(old).agrees_with(&new) => {
            let mut problem = wrong(
                name.span,
                format!(
                    "the macro `{}` is already defined, differently",
                    source.quoted(&name)
                ),
            )
            .hint("put an `#undef` before it, or choose another name");
            if let Some(place) = source.macros.get(old).place() {
                problem = problem.note(place, "it is defined here first");
            }
            source.report(problem);
        }
        Some(_) => {}
        None => {
            warn_about_hiding(source, &name);
            source.macros.define(name.spelling, new);
        }
    }
}

/// Warns about a macro that takes a name of the language away from the text behind it.
fn warn_about_hiding(source: &mut Directives<'_>, name: &Token) {
    let what = if Builtin::find(source.names.text(name.spelling)).is_some() {
        "a function"
    } else if name.spelling.is_word() {
        "a word"
    } else {
        return;
    };
    let message = format!(
        "the macro `{}` hides {what} of the language",
        source.quoted(name)
    );
    let warning = Diagnostic::warning("hiding-macro", message).at(name.span);
    source.report(warning.hint("a name of its own would be clearer; drivers differ here"));
}

/// Says that the user's definition stands in for one of the text at `place`.
fn give_place(users: &mut Macro, place: Span) {
    if let Maker::User { has_place, .. } = &mut users.maker
        && !std::mem::replace(has_place, true)
    {
        for token in Rc::make_mut(&mut users.body) {
            token.span = place;
        }
    }
}

/// The name that `#define` or `#undef` is about.
fn macro_name<'a>(source: &mut Directives<'a>, directive: &Token, rest: &[Token]) -> Option<Token> {
    let first = rest.first();
    let name = first.filter(|token| token.kind == Kind::Identifier);
    if name.is_none() {
        let place = first.unwrap_or(directive).span;
        source.report(wrong(place, "a macro's name is missing here"));
    }
    name.copied()
}

/// The names in `(a, b)` behind a macro's name, and how many tokens that takes. A comma may follow
/// the last.
fn parameters(name: &Token, line: &[Token]) -> Result<(Vec<Name>, usize), Diagnostic> {
    let mut names = Vec::new();
    let mut known = HashSet::new();
    let mut wants_name = true;
    for (index, token) in line.iter().enumerate().skip(2) {
        if token.is(Symbol::RightParenthesis) {
            return Ok((names, index));
        }
        if wants_name && token.kind == Kind::Identifier {
            if !known.insert(token.spelling) {
                let message = "two parameters of this macro have the same name";
                return Err(wrong(token.span, message));
            }
            names.push(token.spelling);
        } else if wants_name || !token.is(Symbol::Comma) {
            let message = "a macro's parameters are names with commas between them";
            return Err(wrong(token.span, message));
        }
        wants_name = !wants_name;
    }
    let message = "the macro's parameters are never closed with `)`";
    Err(wrong(name.span, message))
}

/// `#undef`.
pub(super) fn undefine<'a>(source: &mut Directives<'a>, directive: &Token, rest: &[Token]) {
    let Some(name) = macro_name(source, directive, rest) else {
        return;
    };
    source.require_end(&rest[1..]);
    let Some(found) = source.macros.find_mentioned(name.spelling) else {
        return;
    };
    let old = source.macros.get(found);
    let refusal = if old.is_predefined() {
        "this macro cannot be undefined: the language brings it"
    } else if old.uses > 0 {
        "this macro cannot be undefined amid a use of it"
    } else {
        if !old.is_users() {
            source.macros.undefine(name.spelling);
        }
        return;
    };
    source.report(wrong(name.span, refusal));
}
