//! naga's GLSL front end and validator.

use naga::front::glsl::{Frontend, Options};
use naga::valid::{Capabilities, ModuleInfo, ValidationError, ValidationFlags, Validator};
use naga::{Module, ShaderStage, WithSpan};

use super::assemble::Assembly;
use super::refusal;
use crate::source::Diagnostic;

/// Statement blocks nested deeper than this are refused: validator and writers recurse on them, and
/// the device's own run of the validator has no more stack than the calling thread.
const MAX_BLOCK_DEPTH: usize = 300;

/// Parses and validates a pass.
pub(super) fn parse(assembly: &Assembly) -> Result<(Module, ModuleInfo), Vec<Diagnostic>> {
    let module = Frontend::default()
        .parse(&Options::from(ShaderStage::Fragment), &assembly.text)
        .map_err(|errors| refusal::of_parser(assembly, &errors.errors))?;
    require_shallow_blocks(assembly, &module)?;
    let info = validate(&module).map_err(|error| vec![refusal::of_validator(assembly, &error)])?;
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
            let place = assembly.locate_naga(module.functions.get_span(handle));
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
