//! Looks while a program runs for what GLSL leaves undefined, and for what is suspicious.
//!
//! Every place where something can go wrong is a [`Site`]. A pixel keeps a bit for each in private
//! memory, which costs no branch, and when it ends adds itself to the counts of those that are set, in a
//! buffer of the host's. What the operands were, a second program tells that looks at a few sites only,
//! each in one pixel: to keep them for all would cost every operation a branch.

mod builtin;
mod finite;
mod operator;
mod record;
mod unset;

use naga::{GlobalVariable, Handle};
use rustc_hash::FxHashMap;

use super::context::Context;
use super::function::Builder;
use crate::glsl::Precision;
use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::{BinaryOp, Extent, Global};
use crate::glsl::names::Name;
use crate::glsl::types::{Scalar, Type};

pub(super) use finite::Suspect;
pub use record::OPERAND_WORDS;

/// What a program looks for while it runs, in single precision.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Checks {
    /// Nothing.
    #[default]
    None,
    /// Loops that use up [`Options::round_budget`](super::Options::round_budget).
    Loops,
    /// Every [`Hazard`].
    All,
    /// The operands at sites, by their number among [`Lowered::sites`](super::Lowered::sites), when
    /// something first goes wrong there in one pixel: column and row.
    Operands(Vec<(u32, [u16; 2])>),
}

/// What can go wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Hazard {
    /// A `float` is divided by zero.
    DivisionByZero,
    /// An integer is divided by zero, or the lowest `int` by −1.
    IntegerDivision,
    /// A built-in function is asked for what it has no value for.
    Domain,
    /// `pow` of a negative base, or of zero to what is not positive.
    NegativeBase,
    /// A vector without length is normalised.
    ZeroVector,
    /// The limits of `smoothstep` or `clamp` are in the wrong order.
    Limits,
    /// An index is out of range.
    Index,
    /// A `float` becomes an integer that cannot hold it.
    Conversion,
    /// A shift by a negative number of bits, or by more than there are.
    Shift,
    /// A variable is read before it is set.
    Unset,
    /// Finite operands give infinity or what is no number.
    NotFinite,
    /// A loop has used up the budget of rounds.
    Endless,
}

/// A place where something can go wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    /// What.
    pub hazard: Hazard,
    /// The operation.
    pub extent: Extent,
    /// How it is written.
    pub form: Form,
    /// The types of its operands.
    pub operands: Vec<Type>,
}

/// How an operation is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Between its operands.
    Operator(BinaryOp),
    /// In front of them.
    Call(Builtin),
    /// A conversion to this type.
    Conversion(Scalar),
    /// The choice of one of so many elements.
    Index(u32),
    /// A texel of a texture.
    Texel,
    /// A variable.
    Variable(Name),
    /// A loop.
    Loop,
}

/// What is known of the sites so far, and where they are noted.
#[derive(Debug, Default)]
pub(super) struct Sanitizer {
    sites: Vec<Site>,
    numbers: FxHashMap<(Extent, Hazard), u32>,
    memory: Option<Memory>,
    /// Which components of global variables are set.
    globals: FxHashMap<Id<Global>, Handle<GlobalVariable>>,
}

/// Where findings are noted.
#[derive(Clone, Copy, Debug)]
struct Memory {
    /// A private array of words: a bit for each site.
    seen: Handle<GlobalVariable>,
    /// Which pixel it is: the row in the upper half of the word, the column in the lower.
    pixel: Handle<GlobalVariable>,
    /// Whether anything in the pixel has not been finite.
    tainted: Handle<GlobalVariable>,
    /// The host's buffer.
    findings: Handle<GlobalVariable>,
    /// The function that adds a pixel's bits to the buffer.
    flush: Option<Handle<naga::Function>>,
}

/// A site where something is about to be lowered.
#[derive(Clone, Copy)]
pub(super) struct Here {
    number: u32,
    /// Whether what goes wrong is to be noted.
    is_wanted: bool,
}

impl Context<'_> {
    /// Whether operations are looked at.
    pub fn is_sanitized(&self) -> bool {
        let checks = &self.options.checks;
        self.options.precision == Precision::Single
            && matches!(checks, Checks::All | Checks::Operands(_))
    }
}

impl Builder<'_, '_> {
    pub fn is_sanitized(&self) -> bool {
        self.context.is_sanitized()
    }

    /// The site of the operation that is being lowered.
    fn site(&mut self, hazard: Hazard, form: Form, operands: &[Type]) -> Here {
        let tokens = self.span.to_range().unwrap_or_default();
        let extent = Extent {
            first: tokens.start as u32,
            last: tokens.end.saturating_sub(1) as u32,
        };
        self.site_at(extent, hazard, form, operands)
    }

    fn site_at(&mut self, extent: Extent, hazard: Hazard, form: Form, operands: &[Type]) -> Here {
        let Sanitizer { sites, numbers, .. } = &mut self.context.sanitizer;
        let number = *numbers.entry((extent, hazard)).or_insert_with(|| {
            sites.push(Site {
                hazard,
                extent,
                form,
                operands: operands.to_vec(),
            });
            sites.len() as u32 - 1
        });
        Here {
            number,
            is_wanted: match &self.context.options.checks {
                Checks::Operands(wanted) => wanted.iter().any(|(site, _)| *site == number),
                _ => true,
            },
        }
    }
}
