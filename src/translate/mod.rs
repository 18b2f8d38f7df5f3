//! From a [`Scene`] to [`Program`]s: ShaderToy's conventions on top of the GLSL front end.
//!
//! The author's text is never touched: a generated preamble stands before it, as on the site. What
//! comes out is validated naga IR that reads exactly the uniforms and channels in its
//! [`Program::uniforms`] and [`Program::channels`], bound as [`bindings`] says. Every complaint points
//! into the author's own files. No text, however hostile, makes this panic or run for ever.

use std::collections::HashSet;

pub mod bindings;
mod bundle;
mod finding;
mod guard;
mod plain;
mod preamble;
mod probe;
mod program;
mod refusal;
mod text;
mod write;

pub use crate::glsl::lower::{Checks, Hazard, OPERAND_WORDS};
pub use crate::glsl::{Arithmetic, Precision};
pub use finding::{Finding, Site};
#[cfg(feature = "gpu")]
pub(crate) use guard::caught;
pub use probe::{Output, Probe};
pub use program::{ChannelUse, Functions, Guards, Program, Tables, UniformBlock};
use text::translate_text;
pub use write::{Language, write};

use crate::scene::{Pass, PassKind, Scene};
use crate::source::{Diagnostic, Report, Span};

/// How to translate.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Whether everything that WebGL2 refuses is an error.
    pub strict: bool,
    /// Macros whose values win over the text's own, by name.
    pub overrides: Vec<(String, String)>,
    /// What the program computes in.
    pub precision: Precision,
    /// How arithmetic is written.
    pub arithmetic: Arithmetic,
    /// What the program gives for a pixel.
    pub output: Output,
    /// How many rounds all loops that are not known to end may make in a pixel together; behind that
    /// they end at once. Without it the renderer asks for guards instead, which end no loop soon.
    pub round_budget: Option<u32>,
    /// How many rounds one run of such a loop may make at most.
    pub round_limit: Option<u32>,
    /// Whether texels, and what is computed of them and constants alone, are rounded to 16 bits: samplers are `lowp`
    /// unless the text says otherwise. A text with a sampler of `highp` is left alone, and so is double precision.
    pub low_samplers: bool,
    /// What the program looks for while it runs.
    pub checks: Checks,
}

/// Translates every pass of a scene, in the scene's order.
///
/// On failure the report holds everything that is wrong with any pass. Warnings of a scene that
/// runs are in [`Program::warnings`].
pub fn translate(scene: &Scene, options: &Options) -> Result<Vec<Program>, Report> {
    let mut programs = Vec::new();
    let mut diagnostics = Vec::new();
    for pass in &scene.passes {
        // What is asked for instead of the colour concerns the picture.
        let own = Options {
            output: match pass.kind {
                PassKind::Image => options.output.clone(),
                _ => Output::Colour,
            },
            ..options.clone()
        };
        match translate_pass(scene, pass, &own) {
            Ok(program) => programs.push(program),
            Err(found) => diagnostics.extend(found),
        }
    }
    if diagnostics.is_empty() {
        warn_about_overrides(scene, &mut programs);
        return Ok(programs);
    }
    Err(Report {
        files: scene.files.clone(),
        diagnostics,
    })
}

/// Warns, once for the scene, about overrides of what no pass mentions.
fn warn_about_overrides(scene: &Scene, programs: &mut [Program]) {
    let Some((last, others)) = programs.split_last_mut() else {
        return;
    };
    let is_unused = |name: &&String| others.iter().all(|one| one.unused_overrides.contains(name));
    for name in last.unused_overrides.iter().filter(is_unused) {
        last.warnings.push(
            Diagnostic::warning(
                "unused-override",
                format!("the scene never mentions `{name}`, which `-D` sets"),
            )
            .at(beginning(scene, scene.image()))
            .hint("is it spelled as in the text?"),
        );
    }
}

/// Translates one pass of a scene. What is wrong with it, or worth a warning, is named with the pass.
pub fn translate_pass(
    scene: &Scene,
    pass: &Pass,
    options: &Options,
) -> Result<Program, Vec<Diagnostic>> {
    let (files, own, options) = (scene.files.clone(), pass.clone(), options.clone());
    let result = guard::guarded(move || translate_text(files, &own, &options))
        .unwrap_or_else(|failure| Err(vec![failure.diagnostic().at(beginning(scene, pass))]));
    match result {
        Ok(program) => Ok(Program {
            warnings: in_pass(pass, program.warnings),
            ..program
        }),
        Err(found) => Err(in_pass(pass, found)),
    }
}

/// Names the pass; what is wrong twice with the tokens of one macro at one place is told once.
fn in_pass(pass: &Pass, found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut told = HashSet::new();
    found
        .into_iter()
        .filter(|one| told.insert((one.code, one.message.clone(), one.span)))
        .map(|diagnostic| Diagnostic {
            pass: Some(pass.kind.name().to_owned()),
            ..diagnostic
        })
        .collect()
}

/// The beginning of the pass's own text, for what has no better place.
fn beginning(scene: &Scene, pass: &Pass) -> Option<Span> {
    let whole = scene.files.whole(*pass.sources.last()?);
    Some(Span {
        end: whole.start,
        ..whole
    })
}
