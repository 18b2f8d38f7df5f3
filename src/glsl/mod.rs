//! The GLSL ES 3.00 front end: from text to naga IR, phase by phase.
//!
//! ```text
//! text ─preprocess─► tokens ─parse─► AST ─check─► HIR ─prune─► HIR ─lower─► naga::Module
//! ```
//!
//! It knows GLSL and nothing of ShaderToy, of GPUs or of the file system. Where the specification
//! leaves room, ANGLE decides, because WebGL2 is what authors know.

pub mod arena;
pub mod builtins;
pub mod check;
pub mod double;
pub mod finite;
pub mod fold;
pub mod hir;
pub mod lower;
pub mod names;
pub mod places;
pub mod preprocess;
pub mod prune;
pub mod syntax;
pub mod types;
mod words;

/// How many bits a `float` has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Precision {
    /// 32, as WebGL2 computes.
    #[default]
    Single,
    /// 64 throughout, for measuring what 32 lose.
    Double,
}

/// How arithmetic is written in naga's operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// In the largest that there are, which read best.
    #[default]
    Compact,
    /// In the steps that compilers of GLSL take before they optimise, and in their order. Optimisers
    /// move constants and join operations by what they see, and rounding shows that wherever large
    /// numbers make noise: pictures agree with WebGL2's only where they see the same.
    Expanded,
}

impl Precision {
    /// A number as a `float` of this precision holds it.
    pub fn round(self, value: f64) -> f64 {
        match self {
            Precision::Single => f64::from(value as f32),
            Precision::Double => value,
        }
    }
}
