//! From a [`Scene`] to [`Program`]s: ShaderToy's conventions around a GLSL front end.
//!
//! The author's text is never touched: its tokens, macros expanded, stand between a generated preamble
//! and a `main`. What comes out is validated naga IR that reads exactly the uniforms and channels in
//! its [`Program::uniforms`] and [`Program::channels`], bound as [`bindings`] says. Every complaint
//! points into the author's own files. No text, however hostile, makes this panic or run for ever.
//!
//! Limits of this version: the GLSL is parsed by naga's own front end, which refuses parts of
//! GLSL ES 3.00 (sampler parameters above all) and accepts some things that WebGL2 refuses.

mod assemble;
pub mod bindings;
mod front;
mod guard;
mod limits;
mod program;
mod refusal;
mod write;

#[cfg(feature = "gpu")]
pub(crate) use guard::caught;
pub use program::{ChannelUse, Functions, Program, UniformBlock};
pub use write::{Language, write};

use assemble::Assembly;

use crate::glsl::preprocess::{Preprocessed, preprocess};
use crate::scene::{CHANNELS, Pass, PassKind, Scene};
use crate::source::{Diagnostic, Report, SourceMap, Span};

/// Translates every pass of a scene, in the scene's order.
///
/// On failure the report holds everything that is wrong with any pass. Warnings of a scene that
/// runs are in [`Program::warnings`].
pub fn translate(scene: &Scene) -> Result<Vec<Program>, Report> {
    let mut programs = Vec::new();
    let mut diagnostics = Vec::new();
    for pass in &scene.passes {
        match translate_pass(scene, pass) {
            Ok(program) => programs.push(program),
            Err(found) => diagnostics.extend(in_pass(pass, found)),
        }
    }
    if diagnostics.is_empty() {
        return Ok(programs);
    }
    Err(Report {
        files: scene.files.clone(),
        diagnostics,
    })
}

fn translate_pass(scene: &Scene, pass: &Pass) -> Result<Program, Vec<Diagnostic>> {
    let (files, own_pass) = (scene.files.clone(), pass.clone());
    let mut program = guard::guarded(move || translate_text(&files, &own_pass))
        .unwrap_or_else(|failure| Err(vec![failure.diagnostic().at(own_text(scene, pass))]))?;
    program.warnings = in_pass(pass, program.warnings).collect();
    Ok(program)
}

fn translate_text(files: &SourceMap, pass: &Pass) -> Result<Program, Vec<Diagnostic>> {
    let Preprocessed {
        tokens,
        mut diagnostics,
    } = preprocess(files, &pass.sources, &[("HW_PERFORMANCE", "1")]);
    if diagnostics.iter().any(Diagnostic::is_error) {
        return Err(diagnostics);
    }
    limits::require_shallow(&tokens).map_err(|problem| vec![problem])?;
    let assembly = Assembly::new(files, &tokens, end_of_text(files, pass));
    if assembly.find("mainImage").is_none() {
        return Err(vec![refusal::no_main_image(&assembly)]);
    }
    let module = front::parse(&assembly)?;
    let program = usable(pass.kind, module, &assembly).map_err(|problem| vec![problem])?;
    diagnostics.extend(unbound_channels(pass, &program, &assembly));
    Ok(Program {
        warnings: diagnostics,
        ..program
    })
}

/// Behind the last visible character of a pass.
fn end_of_text(files: &SourceMap, pass: &Pass) -> Span {
    let &own = pass.sources.last().expect("a pass has a text");
    let end = files.get(own).text.trim_end().len() as u32;
    Span {
        file: own,
        start: end,
        end,
    }
}

/// Keeps what the pass needs, and makes sure that drivers can be given it: naga's writers know limits
/// that its validator does not.
fn usable(
    kind: PassKind,
    module: naga::Module,
    assembly: &Assembly<'_>,
) -> Result<Program, Diagnostic> {
    front::require_own_interface(assembly, &module)?;
    let program = Program::new(kind, module)?;
    front::require_writable(assembly, &program.module)?;
    write::spirv(&program).map_err(|message| refusal::internal(&message))?;
    Ok(program)
}

fn in_pass(pass: &Pass, found: Vec<Diagnostic>) -> impl Iterator<Item = Diagnostic> {
    let name = pass.kind.name();
    found.into_iter().map(move |mut diagnostic| {
        diagnostic.pass = Some(name.to_owned());
        diagnostic
    })
}

/// The beginning of the pass's own text, for what has no better place.
fn own_text(scene: &Scene, pass: &Pass) -> Option<Span> {
    let start = scene.files.whole(*pass.sources.last()?);
    Some(Span {
        end: start.start,
        ..start
    })
}

fn unbound_channels(pass: &Pass, program: &Program, assembly: &Assembly<'_>) -> Vec<Diagnostic> {
    (0..CHANNELS)
        .filter(|&channel| program.channels[channel].texture && pass.channels[channel].is_none())
        .map(|channel| {
            let name = bindings::channel_name(channel);
            Diagnostic::warning(
                "unbound-channel",
                format!("`{name}` is read but nothing is bound to it: it reads (0, 0, 0, 1)"),
            )
            .at(assembly.find(name))
            .hint(format!(
                "bind it in a scene folder's scene.toml: {name} = {{ procedural = \"noise\" }}"
            ))
        })
        .collect()
}
