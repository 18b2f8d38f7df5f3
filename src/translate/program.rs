use std::collections::BTreeSet;

use naga::valid::ModuleInfo;
use naga::{AddressSpace, Expression, Function, GlobalVariable, Handle, Module, TypeInner};

use super::bindings::{self, Uniform};
use crate::scene::{CHANNELS, PassKind};
use crate::source::Diagnostic;

/// One pass, ready for the GPU: all that is not reachable from its entry point is gone.
#[derive(Clone, Debug)]
pub struct Program {
    /// Which pass this is.
    pub kind: PassKind,
    /// The validated module. Its one entry point is the fragment shader [`Program::ENTRY_POINT`].
    pub module: Module,
    /// The validator's findings about `module`.
    pub info: ModuleInfo,
    /// The uniform block, if the pass reads any uniform.
    pub uniforms: Option<UniformBlock>,
    /// What the pass reads of each channel.
    pub channels: [ChannelUse; CHANNELS],
    /// The author's functions.
    pub functions: Functions,
    /// What the author should know although the pass runs.
    pub warnings: Vec<Diagnostic>,
}

/// Where the renderer writes each uniform.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UniformBlock {
    /// Size of the block in bytes, a multiple of 16.
    pub size: u32,
    /// The uniforms that the pass reads, with their byte offsets, ascending. Arrays have std140's
    /// stride of 16 bytes.
    pub members: Vec<(Uniform, u32)>,
}

/// Which parts of a channel a pass uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ChannelUse {
    /// Its texture, for sampling, fetching or asking its size.
    pub texture: bool,
    /// Its sampler.
    pub sampler: bool,
}

/// The author's functions by name, sorted; overloads of one name count once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Functions {
    /// Reachable from `mainImage`.
    pub used: Vec<String>,
    /// Never called, and therefore left out.
    pub unused: Vec<String>,
}

impl Program {
    /// The name of the entry point in [`Program::module`].
    pub const ENTRY_POINT: &'static str = "main";

    /// Whether the pass reads this uniform.
    pub fn reads(&self, uniform: Uniform) -> bool {
        self.uniforms
            .as_ref()
            .is_some_and(|block| block.members.iter().any(|(member, _)| *member == uniform))
    }

    /// Keeps of a validated module what its entry point needs.
    pub(super) fn new(kind: PassKind, mut module: Module) -> Result<Self, Diagnostic> {
        let all = function_names(&module);
        naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
        let info = super::front::validate(&module)
            .map_err(|error| super::refusal::internal(&error.as_inner().to_string()))?;
        let used = function_names(&module);
        let mut program = Program {
            kind,
            uniforms: None,
            channels: [ChannelUse::default(); CHANNELS],
            functions: Functions {
                unused: all.difference(&used).cloned().collect(),
                used: used.into_iter().collect(),
            },
            warnings: Vec::new(),
            module,
            info,
        };
        program.find_bindings();
        Ok(program)
    }

    fn find_bindings(&mut self) {
        for (handle, variable) in self.module.global_variables.iter() {
            let Some(binding) = &variable.binding else {
                continue;
            };
            debug_assert_eq!(binding.group, bindings::GROUP, "the preamble has one group");
            if variable.space == AddressSpace::Uniform {
                self.uniforms = Some(uniform_block(&self.module, handle, variable));
            }
            for (channel, usage) in self.channels.iter_mut().enumerate() {
                usage.texture |= binding.binding == bindings::texture(channel);
                usage.sampler |= binding.binding == bindings::sampler(channel);
            }
        }
    }
}

/// The block's members that some function really reads.
fn uniform_block(
    module: &Module,
    handle: Handle<GlobalVariable>,
    variable: &GlobalVariable,
) -> UniformBlock {
    let TypeInner::Struct { members, span } = &module.types[variable.ty].inner else {
        unreachable!("the preamble declares the uniforms as a block");
    };
    let mut read = BTreeSet::new();
    for function in functions(module) {
        for (_, expression) in function.expressions.iter() {
            if let Expression::AccessIndex { base, index } = expression
                && matches!(function.expressions[*base], Expression::GlobalVariable(global) if global == handle)
            {
                read.insert(*index as usize);
            }
        }
    }
    let members = read
        .into_iter()
        .map(|index| {
            let member = &members[index];
            let uniform = Uniform::ALL
                .into_iter()
                .find(|uniform| member.name.as_deref() == Some(uniform.name()))
                .expect("the preamble declares nothing else in the block");
            (uniform, member.offset)
        })
        .collect();
    UniformBlock {
        // Some devices want bindings of whole 16 bytes.
        size: span.next_multiple_of(16),
        members,
    }
}

fn functions(module: &Module) -> impl Iterator<Item = &Function> {
    let entry_points = module.entry_points.iter().map(|entry| &entry.function);
    module
        .functions
        .iter()
        .map(|(_, function)| function)
        .chain(entry_points)
}

fn function_names(module: &Module) -> BTreeSet<String> {
    module
        .functions
        .iter()
        .filter_map(|(_, function)| function.name.clone())
        .filter(|name| name != Program::ENTRY_POINT)
        .collect()
}
