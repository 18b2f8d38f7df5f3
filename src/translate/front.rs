//! naga's GLSL front end, and its refusals in the author's terms.

use std::error::Error as _;
use std::ops::Range;

use naga::front::glsl::{Error, ErrorKind, ExpectedToken, Frontend, Options, TokenValue};
use naga::valid::{Capabilities, ModuleInfo, ValidationError, ValidationFlags, Validator};
use naga::{Module, ShaderStage, WithSpan};

use super::assemble::Assembly;
use crate::source::{Diagnostic, Span};

/// Statement blocks nested deeper than this are refused: validator and writers recurse on them, and
/// the device's own run of the validator has no more stack than the calling thread.
const MAX_BLOCK_DEPTH: usize = 300;

/// Parses and validates a pass.
pub(super) fn parse(assembly: &Assembly) -> Result<(Module, ModuleInfo), Vec<Diagnostic>> {
    let module = Frontend::default()
        .parse(&Options::from(ShaderStage::Fragment), &assembly.text)
        .map_err(|errors| refusals(assembly, &errors.errors))?;
    require_shallow_blocks(assembly, &module)?;
    let info = validate(&module).map_err(|error| vec![invalid(assembly, &error)])?;
    Ok((module, info))
}

/// Runs naga's validator with the capabilities that every device here is asked for.
pub(super) fn validate(module: &Module) -> Result<ModuleInfo, Box<WithSpan<ValidationError>>> {
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(module)
        .map_err(Box::new)
}

fn require_shallow_blocks(assembly: &Assembly, module: &Module) -> Result<(), Vec<Diagnostic>> {
    for (handle, function) in module.functions.iter() {
        if block_depth(&function.body) > MAX_BLOCK_DEPTH {
            let place = locate(assembly, module.functions.get_span(handle));
            return Err(vec![
                Diagnostic::error(
                    "too-deep",
                    format!("statements are nested more than {MAX_BLOCK_DEPTH} deep"),
                )
                .at(place.or(assembly.end()))
                .hint("every `else if` nests once; use a `switch`, a loop or functions"),
            ]);
        }
    }
    Ok(())
}

fn block_depth(body: &naga::Block) -> usize {
    let mut deepest = 0;
    let mut open = vec![(body, 1)];
    while let Some((block, depth)) = open.pop() {
        deepest = deepest.max(depth);
        let mut nested = |inner| open.push((inner, depth + 1));
        for statement in block {
            match statement {
                naga::Statement::Block(inner) => nested(inner),
                naga::Statement::If { accept, reject, .. } => {
                    nested(accept);
                    nested(reject);
                }
                naga::Statement::Loop {
                    body, continuing, ..
                } => {
                    nested(body);
                    nested(continuing);
                }
                naga::Statement::Switch { cases, .. } => {
                    cases.iter().for_each(|case| nested(&case.body));
                }
                _ => {}
            }
        }
    }
    deepest
}

fn locate(assembly: &Assembly, span: naga::Span) -> Option<Span> {
    assembly.locate(span.to_range()?)
}

/// One diagnostic for each place; the front end repeats itself where it stumbles on.
fn refusals(assembly: &Assembly, errors: &[Error]) -> Vec<Diagnostic> {
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    for error in errors {
        let range = error.meta.to_range();
        let diagnostic = match range.clone().and_then(|range| assembly.locate(range)) {
            Some(span) => refusal(assembly, &error.kind, range).at(span),
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

/// An error without a place, or in the text that follows the author's, comes from what theirs lacks.
fn at_the_end(assembly: &Assembly, kind: &ErrorKind) -> Diagnostic {
    match kind {
        ErrorKind::SemanticError(message) if message.contains("function 'mainImage'") => {
            let hint = if assembly.text.contains("mainSound") {
                "this looks like the text of a Sound tab; paste the Image tab"
            } else {
                "ShaderToy code draws in `void mainImage(out vec4 fragColor, in vec2 fragCoord)`"
            };
            Diagnostic::error(
                "no-main-image",
                "there is no `mainImage(out vec4, in vec2)`",
            )
            .hint(hint)
        }
        ErrorKind::SemanticError(message) if message == "Function already defined" => {
            Diagnostic::error("redeclared", "there is a function `main`")
                .hint("ShaderToy code has a `mainImage` instead; the host brings `main`")
        }
        ErrorKind::EndOfFile | ErrorKind::InvalidToken(..) => too_early(),
        kind => refusal(assembly, kind, None),
    }
}

fn too_early() -> Diagnostic {
    Diagnostic::error("syntax", "the text ends too early")
        .hint("a `}`, a `)` or a `;` is missing somewhere above")
}

fn refusal(assembly: &Assembly, kind: &ErrorKind, range: Option<Range<usize>>) -> Diagnostic {
    let found = range
        .and_then(|range| assembly.text.get(range))
        .unwrap_or_default();
    match kind {
        ErrorKind::EndOfFile => too_early(),
        ErrorKind::InvalidToken(TokenValue::Identifier(name), _) if name.starts_with("sampler") => {
            Diagnostic::error("unsupported", format!("`{name}` cannot be used here yet"))
                .hint("sampler parameters are not supported yet: read `iChannel0` … directly")
        }
        ErrorKind::InvalidToken(_, expected) => {
            let expected: Vec<String> = expected.iter().map(expectation).collect();
            Diagnostic::error(
                "syntax",
                format!("expected {}, found `{found}`", list(&expected)),
            )
        }
        ErrorKind::InvalidVersion(_) | ErrorKind::InvalidProfile(_) => version_refused(),
        ErrorKind::SemanticError(message) if message.starts_with("#version") => version_refused(),
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
        ErrorKind::PreprocessorError(error) => {
            Diagnostic::error("preprocessor", preprocessor(&format!("{error:?}")))
        }
        ErrorKind::SemanticError(message) => semantic(message),
        ErrorKind::UnknownLayoutQualifier(_)
        | ErrorKind::UnsupportedMatrixWithTwoRowsInStd140 { .. }
        | ErrorKind::UnsupportedF16MatrixInStd140 { .. } => {
            Diagnostic::error("unsupported", kind.to_string())
        }
        ErrorKind::InternalError(message) => internal(message),
    }
}

fn version_refused() -> Diagnostic {
    Diagnostic::error("version", "`#version` cannot be given here")
        .hint("remove the line: ShaderToy code is GLSL ES 3.00 already")
}

fn semantic(message: &str) -> Diagnostic {
    if let Some(name) = message.strip_prefix("Unknown function ") {
        let name = name.trim_matches('\'');
        let diagnostic = Diagnostic::error(
            "unknown-function",
            format!("there is no function `{name}` for these arguments"),
        );
        return match name {
            "texture2D" | "textureCube" | "texture2DLod" => {
                diagnostic.hint("GLSL ES 3.00 calls it `texture`, or `textureLod` with a level")
            }
            _ => diagnostic
                .hint("is it spelled right, defined above, and given arguments of its types?"),
        };
    }
    if let Some(name) = message.strip_prefix("Ambiguous best function for ") {
        let name = name.trim_matches('\'');
        return Diagnostic::error(
            "ambiguous-call",
            format!("several functions `{name}` fit these arguments"),
        )
        .hint("convert the arguments to the types of the one you mean");
    }
    Diagnostic::error("semantic", sentence(message))
}

/// A failure of the translator, not of the shader.
pub(super) fn internal(message: &str) -> Diagnostic {
    Diagnostic::error("internal", format!("the translator failed: {message}"))
        .hint("this is a fault of the translator; a smaller or plainer piece of code may pass")
}

fn invalid(assembly: &Assembly, error: &WithSpan<ValidationError>) -> Diagnostic {
    // From the outermost (a whole function) to the innermost; the innermost is what to look at.
    let place = error
        .spans()
        .filter_map(|(span, _)| locate(assembly, *span))
        .last()
        .or(assembly.end());
    let mut message = error.as_inner().to_string();
    let mut cause = error.as_inner().source();
    while let Some(inner) = cause {
        message = inner.to_string();
        cause = inner.source();
    }
    if message.contains("doesn't match the type stored in") {
        message = "the value's type is not the type of what it is assigned to".to_owned();
    }
    Diagnostic::error("invalid", without_handles(&message)).at(place)
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

/// The preprocessor crate names its errors by variant only.
fn preprocessor(variant: &str) -> String {
    match variant {
        "UnfinishedBlock" => "this `#if` has no `#endif`",
        "ElifOutsideOfBlock" => "this `#elif` has no `#if`",
        "ElseOutsideOfBlock" => "this `#else` has no `#if`",
        "EndifOutsideOfBlock" => "this `#endif` has no `#if`",
        "ElifAfterElse" => "`#elif` after `#else`",
        "MoreThanOneElse" => "a second `#else` for the same `#if`",
        "UnexpectedCharacter" => "there is a character that GLSL does not know",
        "UnexpectedHash" => "a `#` that begins no directive",
        "UnknownDirective" => "there is no such directive",
        "ErrorDirective" => "the text stops here itself, with `#error`",
        "DefineRedefined" => "this macro is already defined, differently",
        "DuplicateParameter" => "two parameters of this macro have the same name",
        "TooFewDefineArguments" => "this macro wants more arguments",
        "TooManyDefineArguments" => "this macro wants fewer arguments",
        "MacroNotDefined" => "this macro is not defined",
        "RecursionLimitReached" => "macros expand too deeply here",
        "DivisionByZero" | "RemainderByZero" => "division by zero in a directive",
        "IntegerOverflow" => "this number does not fit in 32 bits",
        "FloatParsingError" => "this is not a number",
        "UnexpectedEndOfInput" | "UnexpectedNewLine" => {
            "the directive or macro call ends too early"
        }
        other => return format!("the preprocessor refuses this: {other}"),
    }
    .to_owned()
}
