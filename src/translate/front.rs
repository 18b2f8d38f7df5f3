//! naga's GLSL front end and validator.

use naga::front::glsl::{Frontend, Options};
use naga::proc::Layouter;
use naga::valid::{Capabilities, ModuleInfo, ValidationError, ValidationFlags, Validator};
use naga::{
    AddressSpace, Binding, Block, BuiltIn, Expression, Function, Module, ShaderStage, Statement,
    TypeInner, WithSpan,
};

use super::assemble::Assembly;
use super::refusal;
use crate::source::Diagnostic;

/// Statement blocks nested deeper than this are refused: validator and writers recurse on them, and
/// the device's own run of the validator has no more stack than the calling thread.
const MAX_BLOCK_DEPTH: usize = 300;

/// Bytes of variables in all functions together. Drivers give a pixel far less, and some of them die
/// on more instead of refusing it.
const MAX_VARIABLES: u32 = 1 << 20;

/// Parses and validates a pass.
pub(super) fn parse(assembly: &Assembly<'_>) -> Result<Module, Vec<Diagnostic>> {
    let module = Frontend::default()
        .parse(&Options::from(ShaderStage::Fragment), &assembly.text)
        .map_err(|errors| refusal::of_parser(assembly, &errors.errors))?;
    validate(&module).map_err(|error| vec![refusal::of_validator(assembly, &error)])?;
    Ok(module)
}

/// Runs naga's validator with the capabilities that every device here is asked for.
pub(super) fn validate(module: &Module) -> Result<ModuleInfo, Box<WithSpan<ValidationError>>> {
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(module)
        .map_err(Box::new)
}

/// Refuses inputs and outputs beside those that the preamble declares.
pub(super) fn require_own_interface(
    assembly: &Assembly<'_>,
    module: &Module,
) -> Result<(), Diagnostic> {
    for (handle, variable) in module.global_variables.iter() {
        let place = assembly.locate_naga(module.global_variables.get_span(handle));
        if place.is_some() && variable.space != AddressSpace::Private {
            return Err(refusal::foreign_interface("uniforms or buffers of your own").at(place));
        }
    }
    let interface = module.entry_points.iter().flat_map(|entry| {
        let arguments = entry
            .function
            .arguments
            .iter()
            .map(|a| (&a.name, &a.binding));
        arguments.chain(results(module, &entry.function))
    });
    for (name, binding) in interface {
        let name = name.as_deref().unwrap_or_default();
        let is_ours = match binding {
            Some(Binding::BuiltIn(BuiltIn::Position { .. } | BuiltIn::FrontFacing)) => true,
            Some(Binding::Location { .. }) => name == "vitrine_color",
            _ => false,
        };
        if !is_ours {
            let place = assembly.find(name).unwrap_or(assembly.end());
            return Err(refusal::foreign_interface(&format!("`{name}`")).at(place));
        }
    }
    Ok(())
}

/// The members of what an entry point returns.
fn results<'a>(
    module: &'a Module,
    function: &Function,
) -> impl Iterator<Item = (&'a Option<String>, &'a Option<Binding>)> {
    let ty = function
        .result
        .as_ref()
        .map(|result| &module.types[result.ty].inner);
    let members = match ty {
        Some(TypeInner::Struct { members, .. }) => members.as_slice(),
        _ => &[],
    };
    members.iter().map(|member| (&member.name, &member.binding))
}

/// Refuses what is valid and then defeats naga's writers or the stack.
pub(super) fn require_writable(assembly: &Assembly<'_>, module: &Module) -> Result<(), Diagnostic> {
    require_small_variables(assembly, module)?;
    for (_, function) in module.functions.iter() {
        for (block, depth) in blocks(&function.body) {
            for (statement, span) in block.span_iter() {
                let place = assembly.locate_naga(*span).unwrap_or(assembly.end());
                if depth > MAX_BLOCK_DEPTH {
                    return Err(too_deep().at(place));
                }
                if passes_part_of_a_variable(module, function, statement) {
                    return Err(refusal::part_as_argument().at(place));
                }
            }
        }
    }
    Ok(())
}

fn require_small_variables(assembly: &Assembly<'_>, module: &Module) -> Result<(), Diagnostic> {
    let mut layouter = Layouter::default();
    let sizes = layouter.update(module.to_ctx());
    sizes.map_err(|error| refusal::internal(&error.to_string()))?;
    let mut total = 0_u32;
    let mut add = |ty, place: naga::Span| {
        total = total.saturating_add(layouter[ty].size);
        match total > MAX_VARIABLES {
            true => Err(refusal::too_many_variables(MAX_VARIABLES)
                .at(assembly.locate_naga(place).unwrap_or(assembly.end()))),
            false => Ok(()),
        }
    };
    for (handle, variable) in module.global_variables.iter() {
        if variable.space == AddressSpace::Private {
            add(variable.ty, module.global_variables.get_span(handle))?;
        }
    }
    for (_, function) in module.functions.iter() {
        for (handle, variable) in function.local_variables.iter() {
            add(variable.ty, function.local_variables.get_span(handle))?;
        }
    }
    Ok(())
}

fn too_deep() -> Diagnostic {
    Diagnostic::error(
        "too-deep",
        format!("statements are nested more than {MAX_BLOCK_DEPTH} deep"),
    )
    .hint("every `else if` nests once; use a `switch`, a loop or functions")
}

/// The blocks of a function with their depth, from 1.
fn blocks(body: &Block) -> impl Iterator<Item = (&Block, usize)> {
    let mut open = vec![(body, 1)];
    std::iter::from_fn(move || {
        let (block, depth) = open.pop()?;
        let mut nested = |inner| open.push((inner, depth + 1));
        for statement in block {
            match statement {
                Statement::Block(inner) => nested(inner),
                Statement::If { accept, reject, .. } => {
                    nested(accept);
                    nested(reject);
                }
                Statement::Loop {
                    body, continuing, ..
                } => {
                    nested(body);
                    nested(continuing);
                }
                Statement::Switch { cases, .. } => cases.iter().for_each(|case| nested(&case.body)),
                _ => {}
            }
        }
        Some((block, depth))
    })
}

/// Whether a call hands on a pointer into a variable, as for `inout` parameters. The SPIR-V writer
/// knows pointers to whole variables only.
fn passes_part_of_a_variable(module: &Module, function: &Function, statement: &Statement) -> bool {
    let Statement::Call {
        function: callee,
        arguments,
        ..
    } = statement
    else {
        return false;
    };
    let parameters = &module.functions[*callee].arguments;
    parameters
        .iter()
        .zip(arguments)
        .any(|(parameter, argument)| {
            let takes_pointer = matches!(
                module.types[parameter.ty].inner,
                TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. }
            );
            let is_part = matches!(
                function.expressions[*argument],
                Expression::Access { .. } | Expression::AccessIndex { .. }
            );
            takes_pointer && is_part
        })
}
