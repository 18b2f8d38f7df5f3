//! `#iUniform`: a value that a person may set. It becomes a constant, unless `-D` gives another value.

use super::line::Line;
use crate::source::{Diagnostic, Span};

/// A value that a person may set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Uniform {
    pub name: String,
    /// How it is declared in GLSL.
    pub declaration: String,
    pub place: Span,
}

/// The types, as written and in GLSL, with the number of their components.
const TYPES: [(&str, &str, usize); 9] = [
    ("float", "float", 1),
    ("int", "int", 1),
    ("vec2", "vec2", 2),
    ("vec3", "vec3", 3),
    ("vec4", "vec4", 4),
    ("ivec2", "ivec2", 2),
    ("ivec3", "ivec3", 3),
    ("ivec4", "ivec4", 4),
    ("color3", "vec3", 3),
];

/// Values nest no deeper than lists of vectors.
const MAX_NESTING: usize = 4;

/// Reads what follows `#iUniform`: `float x = 1.0 in { 0.0, 2.0 } step 0.1`.
pub(super) fn parse(line: &mut Line<'_>) -> Result<Uniform, Diagnostic> {
    let written = line.word("the type of the uniform")?;
    let Some((_, ty, components)) = TYPES.iter().find(|(name, ..)| *name == written.text) else {
        let names: Vec<_> = TYPES.iter().map(|(name, ..)| *name).collect();
        let message = format!("`{}` is no type of `#iUniform`", written.text);
        return Err(Diagnostic::error("directive", message)
            .at(written.place)
            .hint(format!("the types are {}", names.join(", "))));
    };
    let name = line.word("the name of the uniform")?;
    let mut default = None;
    if line.take("=") {
        default = Some(value(line, 0)?);
    }
    if line.take("in") {
        let closing = match (line.take("{"), line.take("[")) {
            (true, _) => "}",
            (_, true) => "]",
            _ => return Err(line.expected("`{`")),
        };
        let least = value(line, 0)?;
        if !line.take(",") {
            return Err(line.expected("`,` and the largest value"));
        }
        value(line, 0)?;
        if !line.take(closing) {
            return Err(line.expected(&format!("`{closing}`")));
        }
        default.get_or_insert(least);
    }
    if line.take("step") {
        value(line, 0)?;
    }
    let Some(default) = default else {
        return Err(line
            .expected("a value")
            .hint("give it one, as in `#iUniform float speed = 1.0`, or a range"));
    };
    line.end()?;
    if default.len() != 1 && default.len() != *components {
        let message = format!(
            "`{}` has {components} components, and its value {}",
            name.text,
            default.len()
        );
        return Err(Diagnostic::error("directive", message)
            .at(name.place)
            .hint("give one number for all, or as many as there are components"));
    }
    let is_integer = ty.starts_with('i');
    let mut numbers = Vec::new();
    for number in default {
        if is_integer && number.contains(['.', 'e', 'E']) {
            let message = format!("`{number}` is no whole number, but `{}` is one", name.text);
            return Err(Diagnostic::error("directive", message).at(name.place));
        }
        let is_whole = !number.contains(['.', 'e', 'E']);
        let fraction = if is_whole && !is_integer { ".0" } else { "" };
        numbers.push(number + fraction);
    }
    let (name, value) = (name, numbers.join(", "));
    Ok(Uniform {
        name: name.text.to_owned(),
        declaration: format!("const {ty} {} = {ty}({value});", name.text),
        place: name.place,
    })
}

/// The numbers of a value: one, or those of a vector.
fn value(line: &mut Line<'_>, nesting: usize) -> Result<Vec<String>, Diagnostic> {
    if let Some(number) = line.number() {
        return Ok(vec![number.trim_start_matches('+').to_owned()]);
    }
    let closing = if line.take("{") {
        "}"
    } else if line.take("[") {
        "]"
    } else {
        let ty = line.word("a number")?;
        let is_type = TYPES.iter().any(|(name, ..)| *name == ty.text);
        if !is_type || !line.take("(") {
            let message = format!("`{}` is no number", ty.text);
            return Err(Diagnostic::error("directive", message).at(ty.place));
        }
        ")"
    };
    if nesting == MAX_NESTING {
        return Err(line.expected("a number"));
    }
    let mut numbers = value(line, nesting + 1)?;
    while line.take(",") {
        numbers.extend(value(line, nesting + 1)?);
    }
    match line.take(closing) {
        true => Ok(numbers),
        false => Err(line.expected(&format!("`{closing}`"))),
    }
}
