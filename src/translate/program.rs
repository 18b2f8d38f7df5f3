use std::collections::BTreeSet;
use std::error::Error as _;

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Expression, Function, GlobalVariable, Handle, Module, TypeInner};

use super::bindings::{self, Uniform};
use super::finding::Site;
use crate::glsl::Precision;
use crate::glsl::lower::Lowered;
pub use crate::glsl::lower::Tables;
use crate::scene::{CHANNELS, PassKind};
use crate::source::{Diagnostic, Span};

/// One pass, ready for the GPU: all that is not reachable from its entry point is gone.
#[derive(Clone, Debug)]
pub struct Program {
    /// Which pass this is.
    pub kind: PassKind,
    /// What it computes in. Not every device can do so in double precision.
    pub precision: Precision,
    /// The validated module. Its one entry point is the fragment shader [`Program::ENTRY_POINT`].
    pub module: Module,
    /// The validator's findings about `module`.
    pub info: ModuleInfo,
    /// The uniform block, if the pass reads any uniform.
    pub uniforms: Option<UniformBlock>,
    /// What the pass reads of each channel.
    pub channels: [ChannelUse; CHANNELS],
    /// The values of large constant arrays, which the renderer binds as a buffer.
    pub tables: Option<Tables>,
    /// The author's functions.
    pub functions: Functions,
    /// What is checked while the pass runs, because it is not known to be harmless.
    pub guards: Guards,
    /// Every loop of the functions that are used, by its number; `None` where it is none of the
    /// author's.
    pub loops: Vec<Option<Span>>,
    /// Every place that [`Options::checks`](super::Options::checks) looks at.
    pub sites: Vec<Site>,
    /// How many words the buffer must have that it notes its findings in, if it does.
    pub findings: Option<u32>,
    /// How many components of what it gives for a pixel mean something: all four, but for a probe.
    pub components: u8,
    /// The rounds that loops not known to end may make in a pixel, see
    /// [`Options::round_budget`](super::Options::round_budget).
    pub round_budget: Option<u32>,
    /// Macros that the user overrides, and that the pass never mentions.
    pub unused_overrides: Vec<String>,
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

/// Places that are not known to be harmless, and are therefore checked at run time. Where a kind has
/// none, the renderer asks for no checks of it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Guards {
    /// Loops that may not end.
    pub loops: Vec<Span>,
    /// Elements and texels picked by an index that may be out of range.
    pub accesses: Vec<Span>,
    /// Integer divisions whose divisor may be zero or −1.
    pub divisions: Vec<Span>,
}

impl Program {
    /// The name of the entry point in [`Program::module`].
    pub const ENTRY_POINT: &'static str = "main";

    /// Whether it needs a device that computes in 64-bit floats.
    pub fn is_double(&self) -> bool {
        self.precision == Precision::Double
    }

    /// Whether the pass reads this uniform.
    pub fn reads(&self, uniform: Uniform) -> bool {
        self.uniforms
            .as_ref()
            .is_some_and(|block| block.members.iter().any(|(member, _)| *member == uniform))
    }

    /// Whether the pass asks how large what a channel reads is, or how far it has played.
    pub fn reads_about_channels(&self) -> bool {
        self.reads(Uniform::ChannelResolution) || self.reads(Uniform::ChannelTime)
    }

    /// Validates a lowered pass and keeps what its entry point needs.
    pub(super) fn new(
        kind: PassKind,
        precision: Precision,
        lowered: Lowered,
        functions: Functions,
        guards: Guards,
        loops: Vec<Option<Span>>,
        round_budget: Option<u32>,
    ) -> Result<Self, String> {
        let mut module = lowered.module;
        naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
        let info = validate(&module, precision)?;
        let mut program = Program {
            kind,
            precision,
            uniforms: None,
            channels: [ChannelUse::default(); CHANNELS],
            tables: lowered.tables,
            functions,
            guards,
            loops,
            round_budget,
            sites: Vec::new(),
            findings: lowered.findings,
            components: 4,
            unused_overrides: Vec::new(),
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
            if binding.binding == bindings::UNIFORMS {
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
        // The author's own are in it too, and stay zero.
        .filter_map(|index| {
            let member = &members[index];
            let mut all = Uniform::ALL.into_iter().chain(Uniform::GENERATED);
            let uniform = all.find(|uniform| member.name.as_deref() == Some(uniform.name()))?;
            Some((uniform, member.offset))
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

/// Runs naga's validator with the capabilities that every device here is asked for.
fn validate(module: &Module, precision: Precision) -> Result<ModuleInfo, String> {
    // Halves in 32 bits are what `packHalf2x16` makes; every device has them.
    let mut capabilities = Capabilities::default() | Capabilities::SHADER_FLOAT16_IN_FLOAT32;
    capabilities.set(Capabilities::FLOAT64, precision == Precision::Double);
    Validator::new(ValidationFlags::all(), capabilities)
        .validate(module)
        .map_err(|error| {
            let mut message = error.as_inner().to_string();
            let mut cause = error.as_inner().source();
            while let Some(inner) = cause {
                message += &format!(": {inner}");
                cause = inner.source();
            }
            message
        })
}
