//! What a program gives for a pixel: its colour, or something that is known only within it.

use naga::{AddressSpace, Expression, Handle, Span};
use rustc_hash::FxHashMap;

use super::context::Context;
use super::function::{Builder, H};
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, Extent, Hir, StmtKind};
use crate::glsl::prune::Reachable;
use crate::glsl::types::{Base, Scalar, Type};

/// What the entry point gives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Output {
    /// The colour.
    #[default]
    Colour,
    /// A value from within. Components that it lacks are 0, the fourth is 1.
    Value(Watched),
    /// How many rounds loops made: that with this number in [`Lowered::loops`](super::Lowered::loops),
    /// and the three behind it.
    Rounds(u32),
    /// How many rounds all loops made together, in every component.
    AllRounds,
    /// How many rounds counted against [`Options::round_budget`](super::Options::round_budget), in every
    /// component: more than it where the budget was used up.
    Spent,
}

/// A value within a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Watched {
    /// A number or vector: what this variable holds when its function is left, the last time that it is.
    /// The variable must be marked as [`hir::Local::written`].
    Local(Id<hir::Function>, Id<hir::Local>),
    /// What this function returned, the last time that it did: a number or a vector.
    Result(Id<hir::Function>),
}

impl Watched {
    /// The type of the value.
    pub fn ty(self, hir: &Hir) -> Type {
        match self {
            Watched::Local(function, local) => hir.functions[function].locals[local].ty,
            Watched::Result(function) => hir.functions[function].result,
        }
    }
}

impl Output {
    /// How many components of what is given mean something.
    pub fn components(self, hir: &Hir) -> u8 {
        match self {
            Output::Value(watched) => match watched.ty(hir).base {
                Base::Vector(_, size) => size,
                _ => 1,
            },
            _ => 4,
        }
    }
}

/// Whether a value can be given for a pixel.
pub fn can_be_watched(ty: Type) -> bool {
    !ty.is_array() && matches!(ty.base, Base::Scalar(_) | Base::Vector(..))
}

/// What keeps the value, and what is there to be counted.
#[derive(Debug, Default)]
pub(super) struct Record {
    variable: Option<(Handle<naga::GlobalVariable>, Type)>,
    /// The rounds that count against the budget.
    spent: Option<Handle<naga::GlobalVariable>>,
    /// The component that counts each loop.
    components: FxHashMap<(u32, u32), u32>,
}

/// The loops of the functions that are needed, in the order of the text, and whether each is known to end.
pub(super) fn loops(hir: &Hir, reachable: &Reachable) -> Vec<(Extent, bool)> {
    let mut found: Vec<_> = reachable
        .statements(hir)
        .filter_map(|stmt| match &stmt.kind {
            StmtKind::Loop(inner) => Some((stmt.extent, inner.is_finite)),
            _ => None,
        })
        .collect();
    found.sort_by_key(|(extent, _)| (extent.first, extent.last));
    found.dedup();
    found
}

impl Context<'_> {
    /// Makes room for what [`Output`] asks for.
    pub fn add_record(&mut self) {
        self.add_budget();
        let ty = match self.options.output {
            Output::Colour => return,
            Output::Value(watched) => watched.ty(self.hir),
            Output::Spent => Type::UINT,
            Output::Rounds(_) | Output::AllRounds => Type::vector(Scalar::Uint, 4),
        };
        if let Output::Rounds(first) = self.options.output {
            let counted = self.loops.iter().skip(first as usize).take(4);
            let keys = counted.map(|(extent, _)| (extent.first, extent.last));
            self.record.components = keys.zip(0..).collect();
        }
        let variable = match (self.options.output, self.record.spent) {
            (Output::Spent, Some(spent)) => spent,
            _ => self.add_private("record", ty),
        };
        self.record.variable = Some((variable, ty));
    }

    /// Makes room to count the rounds of loops that are not known to end.
    fn add_budget(&mut self) {
        if self.options.round_budget.is_some() {
            self.record.spent = Some(self.add_private("rounds", Type::UINT));
        }
    }

    pub fn add_private(&mut self, name: &str, ty: Type) -> Handle<naga::GlobalVariable> {
        let variable = naga::GlobalVariable {
            name: Some(name.to_owned()),
            space: AddressSpace::Private,
            binding: None,
            ty: self.ty(ty),
            init: None,
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let variables = &mut self.module.global_variables;
        variables.append(variable, Span::UNDEFINED)
    }
}

impl Builder<'_, '_> {
    /// What the entry point gives instead of the colour, if anything.
    pub fn recorded(&self) -> Option<(Handle<naga::GlobalVariable>, Type)> {
        self.context.record.variable
    }

    /// Keeps a value if the function is the one that is watched; `result` is what it returns.
    pub fn record_value(&mut self, result: Option<H>) {
        let (Output::Value(watched), Some((variable, _))) =
            (self.context.options.output, self.recorded())
        else {
            return;
        };
        let value = match watched {
            Watched::Local(function, local) if function == self.id => {
                let pointer = self.local_pointer(local);
                self.load(pointer)
            }
            Watched::Result(function) if function == self.id => match result {
                Some(value) => value,
                None => return,
            },
            _ => return,
        };
        let pointer = self.global(variable);
        self.store(pointer, value);
    }

    /// Ends a loop that is not known to end when the pixel's budget is used up.
    pub fn spend_round(&mut self) {
        let (Some(variable), Some(budget)) =
            (self.context.record.spent, self.context.options.round_budget)
        else {
            return;
        };
        let pointer = self.global(variable);
        let (before, one, most) = (self.load(pointer), self.uint(1), self.uint(budget));
        let binary = |op, left, right| Expression::Binary { op, left, right };
        let is_spent = self.add(binary(naga::BinaryOperator::Greater, before, most));
        self.branch(
            is_spent,
            |b| {
                // It was this loop that used it up, and not any other that then ends for want of it.
                let [last, over] = [1, 2].map(|rounds| b.uint(budget + rounds));
                let is_first = b.binary(naga::BinaryOperator::Equal, before, last);
                b.note_endless(is_first);
                b.store(pointer, over);
                b.push(naga::Statement::Break);
            },
            |_| {},
        );
        let after = self.add(binary(naga::BinaryOperator::Add, before, one));
        self.store(pointer, after);
    }

    /// A counter for the rounds of one run of a loop, if there is a limit.
    pub fn start_rounds(&mut self) -> Option<H> {
        self.context.options.round_limit?;
        let counter = self.acquire(Type::UINT);
        let zero = self.uint(0);
        self.store(counter, zero);
        Some(counter)
    }

    /// Ends a loop when it has made as many rounds as it may.
    pub fn limit_round(&mut self, counter: H) {
        let Some(limit) = self.context.options.round_limit else {
            return;
        };
        let (before, one, limit) = (self.load(counter), self.uint(1), self.uint(limit));
        let is_over = self.binary(naga::BinaryOperator::GreaterEqual, before, limit);
        self.branch(
            is_over,
            |b| {
                let yes = b.bool(true);
                b.note_endless(yes);
                b.push(naga::Statement::Break);
            },
            |_| {},
        );
        let after = self.sum(before, one);
        self.store(counter, after);
    }

    /// Counts a round of a loop, if it is one that is counted.
    pub fn record_round(&mut self, extent: Extent) {
        let Some((variable, _)) = self.recorded() else {
            return;
        };
        let pointer = match self.context.options.output {
            Output::AllRounds => self.global(variable),
            Output::Rounds(_) => {
                let key = (extent.first, extent.last);
                let Some(&component) = self.context.record.components.get(&key) else {
                    return;
                };
                let whole = self.global(variable);
                self.part(whole, component)
            }
            Output::Colour | Output::Value(_) | Output::Spent => return,
        };
        let mut one = self.uint(1);
        if self.context.options.output == Output::AllRounds {
            one = self.splat(one, 4);
        }
        let before = self.load(pointer);
        let op = naga::BinaryOperator::Add;
        let after = self.add(Expression::Binary {
            op,
            left: before,
            right: one,
        });
        self.store(pointer, after);
    }
}
