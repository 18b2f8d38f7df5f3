//! The one place that asks the front end.

use vitrine::glsl::check::{self, check};
use vitrine::glsl::lower::{self, Interface, Lowered, lower, verify::verify};
use vitrine::glsl::names::Names;
use vitrine::glsl::places::Places;
use vitrine::glsl::preprocess::{self, preprocess};
use vitrine::glsl::prune::Reachable;
use vitrine::glsl::{Arithmetic, Precision, double, finite, syntax};
use vitrine::source::{Diagnostic, SourceMap};

/// The bind group of everything.
pub const GROUP: u32 = 0;
/// The binding of the uniform block.
pub const BLOCK: u32 = 0;
/// The binding of the constant tables.
pub const TABLES: u32 = 1;

/// Why there is no program.
#[derive(Debug)]
pub enum Refusal {
    /// The text is refused, with this complaint.
    Text(String),
    /// The text is refused for nothing but that it reads what a vertex shader would write.
    Varyings,
    /// The front end has made something that naga cannot take.
    Internal(String),
}

/// Compiles a fragment shader whose block holds these uniforms.
pub fn compile(text: &str, uniforms: Vec<String>) -> Result<Lowered, Refusal> {
    let strict = true;
    let precision = Precision::Single;
    let mut files = SourceMap::default();
    let file = files.add("case", text);
    let options = preprocess::Options {
        strict,
        ..Default::default()
    };
    let preprocessed = preprocess(&files, &[file], &options, Names::default());
    let mut found = preprocessed.diagnostics;
    require_none(&files, &found)?;
    let tokens = &preprocessed.tokens;
    let mut parsed = syntax::parse(tokens, preprocessed.names, strict);
    found.append(&mut parsed.diagnostics);
    require_none(&files, &found)?;
    let options = check::Options {
        strict,
        precision,
        ..Default::default()
    };
    let mut checked = check(&mut parsed.ast, Places::new(tokens), options);
    found.append(&mut checked.diagnostics);
    require_none(&files, &found)?;

    finite::mark_finite_loops(&mut checked.hir);
    let double_functions = double::Functions::default();
    let reachable = Reachable::new(&checked.hir, &double_functions);
    let options = lower::Options {
        precision,
        // As it is when it is drawn.
        arithmetic: Arithmetic::Expanded,
        output: lower::Output::Colour,
        round_budget: None,
        round_limit: None,
        low_samplers: false,
        checks: lower::Checks::None,
        unit_0: None,
        interface: &Interface {
            group: GROUP,
            block: BLOCK,
            uniforms,
            block_size: 1 << 14,
            samplers: Vec::new(),
            tables: TABLES,
            findings: 10,
        },
        double_functions: &double_functions,
    };
    let lowered = lower(&checked.hir, &reachable, &options);
    verify(&lowered.module).map_err(|fault| Refusal::Internal(fault.to_string()))?;
    Ok(lowered)
}

/// Fails with the errors among what was found.
fn require_none(files: &SourceMap, found: &[Diagnostic]) -> Result<(), Refusal> {
    let errors: Vec<_> = found.iter().filter(|found| found.is_error()).collect();
    let Some(first) = errors.first() else {
        return Ok(());
    };
    if errors.iter().all(|error| error.code == "unlinked-input") {
        return Err(Refusal::Varyings);
    }
    let first = errors
        .iter()
        .find(|error| error.code != "unlinked-input")
        .unwrap_or(first);
    let line = match first.span {
        Some(span) => files.get(span.file).location(span.start).line.to_string(),
        None => "?".to_owned(),
    };
    Err(Refusal::Text(format!(
        "{}: {} (line {line})",
        first.code, first.message
    )))
}
