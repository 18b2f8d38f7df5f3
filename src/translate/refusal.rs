//! The refusals of naga's front end and validator, in the author's terms.

use std::error::Error as _;

use naga::WithSpan;
use naga::front::glsl::{Error, ErrorKind, ExpectedToken, TokenValue};
use naga::valid::ValidationError;

use super::assemble::Assembly;
use crate::source::Diagnostic;

/// One diagnostic for each place; the front end repeats itself where it stumbles on.
pub(super) fn of_parser(assembly: &Assembly<'_>, errors: &[Error]) -> Vec<Diagnostic> {
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    for error in errors {
        let place = error
            .meta
            .to_range()
            .and_then(|range| assembly.locate(range));
        let diagnostic = match place {
            Some(span) => refusal(&error.kind, assembly.written(span)).at(span),
            // It is only a consequence if something else is wrong.
            None if !diagnostics.is_empty() => continue,
            None => at_the_end(assembly, &error.kind).at(assembly.end()),
        };
        if diagnostics
            .iter()
            .all(|known| known.span != diagnostic.span)
        {
            diagnostics.push(diagnostic);
        }
    }
    diagnostics
}

/// A text without a function `mainImage`.
pub(super) fn no_main_image(assembly: &Assembly<'_>) -> Diagnostic {
    let hint = if assembly.find("mainSound").is_some() {
        "this looks like the text of a Sound tab; paste the Image tab"
    } else if assembly.find("main").is_some() {
        "this looks like a plain fragment shader: ShaderToy code draws in `void mainImage(out vec4 \
         fragColor, in vec2 fragCoord)` instead of `main` and `gl_FragColor`"
    } else {
        "ShaderToy code draws in `void mainImage(out vec4 fragColor, in vec2 fragCoord)`"
    };
    Diagnostic::error(
        "no-main-image",
        "there is no `mainImage(out vec4, in vec2)`",
    )
    .at(assembly.end())
    .hint(hint)
}

/// An error without a place, or in the text that follows the author's, comes from what theirs lacks.
fn at_the_end(assembly: &Assembly<'_>, kind: &ErrorKind) -> Diagnostic {
    match kind {
        ErrorKind::SemanticError(message) if message.contains("function 'mainImage'") => {
            no_main_image(assembly)
        }
        ErrorKind::SemanticError(message) if message == "Function already defined" => {
            Diagnostic::error("redeclared", "there is a function `main`")
                .hint("ShaderToy code has a `mainImage` instead; the host brings `main`")
        }
        ErrorKind::EndOfFile | ErrorKind::InvalidToken(..) => too_early(),
        kind => refusal(kind, ""),
    }
}

fn too_early() -> Diagnostic {
    Diagnostic::error("syntax", "the text ends too early")
        .hint("a `}`, a `)` or a `;` is missing somewhere above")
}

/// `found` is what the author wrote at the place of the error.
fn refusal(kind: &ErrorKind, found: &str) -> Diagnostic {
    match kind {
        ErrorKind::EndOfFile => too_early(),
        ErrorKind::InvalidToken(TokenValue::Identifier(name), _) if name.starts_with("sampler") => {
            Diagnostic::error("unsupported", format!("`{name}` cannot be used here yet"))
                .hint("sampler parameters are not supported yet: read `iChannel0` … directly")
        }
        ErrorKind::InvalidToken(_, expected) => unexpected(expected, found),
        ErrorKind::NotImplemented(what) => {
            Diagnostic::error("unsupported", format!("not supported yet: {what}"))
        }
        ErrorKind::UnknownVariable(name) => {
            let diagnostic =
                Diagnostic::error("unknown-variable", format!("`{name}` is not declared"));
            match name.as_str() {
                "iGlobalTime" => diagnostic.hint("the site renamed it to `iTime`"),
                "gl_FragColor" => {
                    diagnostic.hint("write to the `out vec4` parameter of `mainImage`")
                }
                _ => diagnostic,
            }
        }
        ErrorKind::UnknownType(name) => {
            Diagnostic::error("unknown-type", format!("there is no type `{name}`"))
        }
        ErrorKind::UnknownField(name) => {
            Diagnostic::error("unknown-field", format!("there is no field `{name}`"))
        }
        ErrorKind::VariableAlreadyDeclared(name) => Diagnostic::error(
            "redeclared",
            format!("`{name}` is already declared in this scope"),
        ),
        // Nothing is left to naga's own preprocessor to find fault with.
        ErrorKind::PreprocessorError(error) => internal(&format!("{error:?}")),
        ErrorKind::SemanticError(message) => semantic(message, found),
        ErrorKind::InvalidVersion(_)
        | ErrorKind::InvalidProfile(_)
        | ErrorKind::UnknownLayoutQualifier(_)
        | ErrorKind::UnsupportedMatrixWithTwoRowsInStd140 { .. }
        | ErrorKind::UnsupportedF16MatrixInStd140 { .. } => {
            Diagnostic::error("unsupported", kind.to_string())
        }
        ErrorKind::InternalError(message) => internal(message),
    }
}

fn unexpected(expected: &[ExpectedToken], found: &str) -> Diagnostic {
    if let [ExpectedToken::Eof] = expected {
        // Between functions only declarations can stand, and they begin with a type.
        return match found {
            "}" => Diagnostic::error("syntax", "there is one `}` too many"),
            name => {
                let message = format!("expected a declaration, found `{name}`");
                let diagnostic = Diagnostic::error("syntax", message);
                match other_name(name) {
                    Some(glsl) => diagnostic.hint(format!("GLSL calls it `{glsl}`")),
                    None => diagnostic.hint("is it a type that is spelled differently?"),
                }
            }
        };
    }
    let tokens: Vec<String> = expected.iter().map(expectation).collect();
    let message = format!("expected {}, found `{found}`", list(&tokens));
    let diagnostic = Diagnostic::error("syntax", message);
    match expected.contains(&ExpectedToken::Token(TokenValue::Semicolon)) {
        true => diagnostic.hint("is a `;` missing before it?"),
        false => diagnostic,
    }
}

/// What GLSL ES 3.00 calls a type or function of HLSL or of older GLSL.
fn other_name(name: &str) -> Option<&'static str> {
    Some(match name {
        "float2" => "vec2",
        "float3" => "vec3",
        "float4" => "vec4",
        "int2" => "ivec2",
        "int3" => "ivec3",
        "int4" => "ivec4",
        "float2x2" => "mat2",
        "float3x3" => "mat3",
        "float4x4" => "mat4",
        "half" => "float",
        "lerp" => "mix",
        "frac" => "fract",
        "fmod" => "mod",
        "rsqrt" => "inversesqrt",
        "ddx" => "dFdx",
        "ddy" => "dFdy",
        "tex2D" | "texture2D" | "textureCube" => "texture",
        "texture2DLod" | "textureCubeLod" => "textureLod",
        _ => return None,
    })
}

fn semantic(message: &str, found: &str) -> Diagnostic {
    // Vulkan's GLSL knows these words as types, so naga takes them for constructors.
    let old = ["texture2D", "textureCube"].iter().find(|name| {
        found
            .strip_prefix(**name)
            .is_some_and(|rest| rest.trim_start().starts_with('('))
    });
    if let Some(name) = old {
        return unknown_function(name);
    }
    if let Some(name) = message.strip_prefix("Unknown function ") {
        let name = name.trim_matches('\'');
        return unknown_function(name);
    }
    if let Some(name) = message.strip_prefix("Ambiguous best function for ") {
        let name = name.trim_matches('\'');
        return Diagnostic::error(
            "ambiguous-call",
            format!("several functions `{name}` fit these arguments"),
        )
        .hint("convert the arguments to the types of the one you mean");
    }
    if message.starts_with("Invalid swizzle") {
        let field = message.split('"').nth(1).unwrap_or_default();
        let message = format!("the vector has no component `{field}`");
        return Diagnostic::error("unknown-field", message);
    }
    if message.contains("LHS position") || message.contains("left hand side") {
        return Diagnostic::error("not-assignable", format!("`{found}` cannot be assigned to"))
            .hint("constants, uniforms and results of functions keep their values");
    }
    limitation(message)
        .unwrap_or_else(|| Diagnostic::error("semantic", sentence(message)).hint(MAYBE_LIMIT))
}

fn unknown_function(name: &str) -> Diagnostic {
    let diagnostic = Diagnostic::error(
        "unknown-function",
        format!("there is no function `{name}` for these arguments"),
    );
    match other_name(name) {
        Some(glsl) => diagnostic.hint(format!("GLSL ES 3.00 calls it `{glsl}`")),
        None => diagnostic.hint(
            "is it spelled right, defined above (no function can call itself), and given arguments \
             of its types?",
        ),
    }
}

/// Inputs and outputs that no ShaderToy pass has.
pub(super) fn foreign_interface(what: &str) -> Diagnostic {
    Diagnostic::error(
        "unsupported",
        format!("{what} cannot be declared or used here"),
    )
    .hint("a pass has ShaderToy's uniforms and channels, and draws one colour")
}

/// More than any driver gives a pixel.
pub(super) fn too_many_variables(limit: u32) -> Diagnostic {
    let limit = limit >> 10;
    Diagnostic::error(
        "too-large",
        format!("variables here take more than {limit} KiB a pixel"),
    )
    .hint("use smaller arrays, or compute their values where they are needed")
}

/// What `inout` and `out` parameters cannot be given yet.
pub(super) fn part_as_argument() -> Diagnostic {
    Diagnostic::error(
        "unsupported",
        "part of a variable cannot be passed to an `inout` or `out` parameter yet",
    )
    .hint("copy it into a variable of its own, pass that, and copy it back")
}

/// A failure of the translator, not of the shader.
pub(super) fn internal(message: &str) -> Diagnostic {
    Diagnostic::error("internal", format!("the translator failed: {message}"))
        .hint("this is a fault of the translator; a smaller or plainer piece of code may pass")
}

pub(super) fn of_validator(
    assembly: &Assembly<'_>,
    error: &WithSpan<ValidationError>,
) -> Diagnostic {
    // From the outermost (a whole function) to the innermost; the innermost is what to look at.
    let place = error
        .spans()
        .filter_map(|(span, _)| assembly.locate_naga(*span))
        .last()
        .unwrap_or(assembly.end());
    let mut message = error.as_inner().to_string();
    let mut cause = error.as_inner().source();
    while let Some(inner) = cause {
        message = inner.to_string();
        cause = inner.source();
    }
    limitation(&message)
        .unwrap_or_else(|| {
            Diagnostic::error("invalid", without_handles(&message)).hint(MAYBE_LIMIT)
        })
        .at(place)
}

/// For what naga says in its own terms, and what WebGL2 may well accept.
const MAYBE_LIMIT: &str = "if the site accepts this, it is a limit of this version's translator";

fn type_mismatch(message: &str) -> Diagnostic {
    Diagnostic::error("type-mismatch", message)
        .hint("GLSL ES converts nothing by itself: write `float(…)`, `vec3(…)` and so on")
}

/// What naga's commonest complaints mean to an author.
fn limitation(message: &str) -> Option<Diagnostic> {
    let has = |part: &str| message.contains(part);
    let unsupported = |what: &str, way_out: &str| {
        Some(Diagnostic::error("unsupported", what.to_owned()).hint(way_out.to_owned()))
    };
    if has("doesn't match the type stored in") || has("nitializer doesn't match") {
        return Some(type_mismatch(
            "the value's type is not the type of what it is assigned to",
        ));
    }
    if has("`return` expression Some") {
        return Some(type_mismatch(
            "the value returned is not of the function's type",
        ));
    }
    if has("IncompatibleOperands") || has("can't work with") {
        return Some(type_mismatch(
            "this operator does not work on these two types",
        ));
    }
    if let Some(counts) = message.strip_prefix("Composing expects ") {
        return Some(
            Diagnostic::error(
                "constructor",
                format!("this constructor expects {}", without_handles(counts)),
            )
            .hint("give as many components as the type has, or a single number for all of them"),
        );
    }
    if has("`return` expression None") {
        return unsupported(
            "this function can end without returning a value",
            "add a `return` at its end",
        );
    }
    if has("has not been processed yet") {
        return unsupported(
            "this function calls one that is defined further down",
            "move the function that is called above this one; a prototype is not enough yet",
        );
    }
    if has("composing") || has("Composing") {
        return unsupported(
            "this constructor takes arguments of types or sizes that are not supported yet",
            "spell out the components, as in `mat2(v.x, v.y, v.z, v.w)`",
        );
    }
    if has("not constructible") || has("CONSTRUCTIBLE") || has("stored in a local variable") {
        return unsupported(
            "an array without a size is not supported here yet",
            "write the size: `float a[3]` instead of `float[] a`",
        );
    }
    if has("require layout(binding") {
        return unsupported(
            "uniforms of your own are not supported",
            "ShaderToy sets only its own, like `iTime`, which need no declaration: remove the line",
        );
    }
    if has("literal is infinite") || has("literal is NaN") || has("out of valid range") {
        return unsupported(
            "this constant expression has no finite value",
            "compute it from a variable, or write a large number such as `1e30`",
        );
    }
    if has("BuiltinArgumentsInvalid") {
        let name = message
            .split('"')
            .nth(1)
            .unwrap_or("function")
            .to_lowercase();
        return unsupported(
            &format!("`{name}` does not take these arguments yet"),
            "use vectors of two or more components, all of one type",
        );
    }
    None
}

/// Drops naga's internal numbers, `[12]`, which mean nothing to an author.
fn without_handles(message: &str) -> String {
    let mut rest = message;
    let mut plain = String::new();
    while let Some(open) = rest.find('[') {
        let (before, bracket) = rest.split_at(open);
        plain.push_str(before);
        match bracket.find(']') {
            Some(close) if bracket[1..close].bytes().all(|b| b.is_ascii_digit()) => {
                rest = bracket[close + 1..].trim_start();
            }
            _ => {
                plain.push('[');
                rest = &bracket[1..];
            }
        }
    }
    plain.push_str(rest);
    sentence(&plain)
}

/// Messages begin in lower case and end without a full stop.
fn sentence(message: &str) -> String {
    let message = message.trim_end_matches('.');
    let mut letters = message.chars();
    match letters.next() {
        Some(first) if !letters.as_str().starts_with(char::is_uppercase) => {
            first.to_lowercase().chain(letters).collect()
        }
        _ => message.to_owned(),
    }
}

fn list(items: &[String]) -> String {
    match items {
        [] => "something else".to_owned(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

fn expectation(expected: &ExpectedToken) -> String {
    match expected {
        ExpectedToken::Token(token) => match symbol(token) {
            Some(symbol) => format!("`{symbol}`"),
            None => format!("`{}`", format!("{token:?}").to_lowercase()),
        },
        ExpectedToken::TypeName => "a type".to_owned(),
        ExpectedToken::Identifier => "a name".to_owned(),
        ExpectedToken::IntLiteral => "a whole number".to_owned(),
        ExpectedToken::FloatLiteral => "a number".to_owned(),
        ExpectedToken::BoolLiteral => "`true` or `false`".to_owned(),
        ExpectedToken::Eof => "the end of the text".to_owned(),
    }
}

fn symbol(token: &TokenValue) -> Option<&'static str> {
    Some(match token {
        TokenValue::Assign => "=",
        TokenValue::LeftBrace => "{",
        TokenValue::RightBrace => "}",
        TokenValue::LeftParen => "(",
        TokenValue::RightParen => ")",
        TokenValue::LeftBracket => "[",
        TokenValue::RightBracket => "]",
        TokenValue::Comma => ",",
        TokenValue::Semicolon => ";",
        TokenValue::Colon => ":",
        TokenValue::Dot => ".",
        TokenValue::Question => "?",
        _ => return None,
    })
}
