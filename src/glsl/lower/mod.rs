//! From the checked program to naga IR.
//!
//! naga has no conversions between its operands, no swizzled stores, no short circuits and no
//! sampler objects of its own, and its validator trusts more than its writers can bear. What GLSL
//! leaves to the compiler is spelled out here; [`verify`] holds the result against what the writers
//! need.

mod arithmetic;
mod builtin;
mod call;
mod chain;
mod constant;
mod construct;
mod context;
mod discard;
mod double;
mod emit;
mod entry;
mod expression;
mod function;
mod interface;
mod lowp;
mod matrix;
mod mix;
mod operator;
mod output;
mod place;
mod range;
mod sanitize;
mod statement;
mod switch;
mod table;
#[cfg(test)]
mod tests;
mod texture;
mod types;
mod uniform;
pub mod verify;

use super::double::Functions;
use super::hir::{Extent, Hir};
use super::prune::Reachable;
use super::types::Shape;
use super::{Arithmetic, Precision};

pub use interface::{HostSampler, Interface, Tables, UniformBlock, UniformMember};
pub use output::{Output, Watched, can_be_watched};
pub use sanitize::{Checks, Form, Hazard, OPERAND_WORDS, Site};

/// How to lower a program.
#[derive(Clone, Debug)]
pub struct Options<'a> {
    /// How many bits a `float` has.
    pub precision: Precision,
    /// How arithmetic is written.
    pub arithmetic: Arithmetic,
    /// What the program gives for a pixel.
    pub output: Output,
    /// How many rounds all loops that are not known to end may make in a pixel together; behind that
    /// each of them ends at once. Without it a loop may go on for ever.
    pub round_budget: Option<u32>,
    /// How many rounds one run of such a loop may make at most. Some drivers end it there without a word;
    /// with this it is noted.
    pub round_limit: Option<u32>,
    /// Whether texels, and what is computed of them and constants alone, are rounded to 16 bits (see `lowp.rs`).
    pub low_samplers: bool,
    /// What the program looks for while it runs.
    pub checks: Checks,
    /// What the host binds.
    pub interface: &'a Interface,
    /// The shape of the first of the host's samplers, if there is a texture behind it. Samplers of this shape that the
    /// host does not know read it too: in GL, who sets no texture unit gets unit 0.
    pub unit_0: Option<Shape>,
    /// In double precision, the functions to compute built-in functions with that graphics drivers
    /// have for 32 bits only. Where there is none, 32 bits must do.
    pub double_functions: &'a Functions,
}

/// A program as the graphics libraries take it.
#[derive(Clone, Debug)]
pub struct Lowered {
    /// The module. Its one entry point is the fragment shader `main`; what that does not need may
    /// still be there, until `naga::compact` removes it.
    pub module: naga::Module,
    /// The block of the host's uniforms, if the program names any.
    pub uniforms: Option<UniformBlock>,
    /// The constant tables that the host must bind, if there are any.
    pub tables: Option<Tables>,
    /// What is not known to be harmless without run-time checks.
    pub unguarded: Unguarded,
    /// Every loop of the functions that are needed, in the order of the text.
    pub loops: Vec<Extent>,
    /// Every place that [`Options::checks`] looks at, by its number.
    pub sites: Vec<Site>,
    /// How many words the host's buffer of findings must have, if there is one.
    pub findings: Option<u32>,
    /// Why the module is good for nothing, if it is.
    pub excess: Option<Excess>,
}

/// A program that is beyond what graphics libraries bear, and the statement where that was found.
#[derive(Clone, Copy, Debug)]
pub enum Excess {
    /// Blocks within blocks: naga's validator and writers recurse on them, on whatever stack the
    /// caller has.
    Depth(Extent),
    /// Operations, those counted that GLSL expresses in one and naga in many.
    Size(Extent),
    /// Functions, of which there is one for each choice of samplers without texture.
    Functions(Extent),
}

/// How deep blocks may nest. A stack of 2 MiB bears more than twice as much.
pub const MAX_BLOCKS: usize = 500;

/// How many operations a program may have. The largest of some 141,000 published shaders has a
/// seventh of it.
pub const MAX_OPERATIONS: usize = 1_500_000;

/// How many functions a program may have: the graphics library takes long over each.
pub const MAX_FUNCTIONS: usize = 20_000;

/// What is not known to be harmless without run-time checks, as far as the lowered functions go.
#[derive(Clone, Debug, Default)]
pub struct Unguarded {
    /// Loops that may not end.
    pub loops: Vec<Extent>,
    /// Elements picked by an index that may be out of range.
    pub accesses: Vec<Extent>,
    /// Integer divisions whose divisor may be zero, or −1.
    pub divisions: Vec<Extent>,
}

impl Unguarded {
    /// Whether nothing needs a check.
    pub fn is_empty(&self) -> bool {
        self.loops.is_empty() && self.accesses.is_empty() && self.divisions.is_empty()
    }
}

/// Lowers the reachable part of a program.
///
/// # Panics
/// When the program is not what the checker lets through; debug builds also when the result is
/// malformed.
pub fn lower(hir: &Hir, reachable: &Reachable, options: &Options<'_>) -> Lowered {
    let mut context = context::Context::new(hir, reachable, options);
    context.add_functions();
    context.add_entry_point();
    let lowered = context.finish();
    #[cfg(debug_assertions)]
    if lowered.excess.is_none()
        && let Err(fault) = verify::verify(&lowered.module)
    {
        panic!("lowered to malformed IR: {fault}");
    }
    lowered
}
