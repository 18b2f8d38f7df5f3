//! Where findings are noted: bits in private memory, and the host's buffer.

use std::num::NonZeroU32;

use naga::{
    AddressSpace, ArraySize, AtomicFunction, BinaryOperator, Expression, Handle, ScalarKind, Span,
    Statement, StorageAccess, TypeInner,
};

use super::{Checks, Form, Hazard, Here, Memory, Site};
use crate::glsl::lower::context::Context;
use crate::glsl::lower::expression::Typed;
use crate::glsl::lower::function::{Builder, H};
use crate::glsl::lower::place::{count, element_type};
use crate::glsl::types::{Base, Scalar, Type};

/// Words of the buffer for the operands of one site: 0, or one more than the number of the site that they
/// belong to, which is this or one within it; then every component as its bits. There is room for two
/// matrices.
pub const OPERAND_WORDS: u32 = 33;

/// Words of the buffer for one site, when all are looked at: how many pixels, and the complement of the
/// first.
const SITE_WORDS: u32 = 2;

impl Context<'_> {
    /// Makes room for findings, and the function that puts them into the buffer.
    pub fn add_findings(&mut self) {
        let is_needed = match self.options.checks {
            Checks::None => false,
            Checks::Loops => {
                let may_be_endless = self.loops.iter().any(|(_, is_finite)| !is_finite);
                self.options.round_budget.is_some() && may_be_endless
            }
            Checks::All | Checks::Operands(_) => self.is_sanitized(),
        };
        if !is_needed {
            return;
        }
        let mut memory = Memory {
            // Their types are known when all sites are.
            seen: self.add_private("seen", Type::UINT),
            pixel: self.add_private("pixel", Type::UINT),
            tainted: self.add_private("tainted", Type::BOOL),
            findings: self.add_buffer(),
            flush: None,
        };
        if self.is_sanitized() {
            self.add_global_marks();
        }
        if !matches!(self.options.checks, Checks::Operands(_)) {
            // What it does is known when all sites are.
            let functions = &mut self.module.functions;
            let flush = functions.append(naga::Function::default(), Span::UNDEFINED);
            memory.flush = Some(flush);
        }
        self.sanitizer.memory = Some(memory);
    }

    fn add_buffer(&mut self) -> Handle<naga::GlobalVariable> {
        let variable = naga::GlobalVariable {
            name: Some("findings".to_owned()),
            space: AddressSpace::Storage {
                access: StorageAccess::LOAD | StorageAccess::STORE,
            },
            binding: Some(self.resource(self.options.interface.findings)),
            ty: self.ty(Type::UINT),
            init: None,
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let variables = &mut self.module.global_variables;
        variables.append(variable, Span::UNDEFINED)
    }

    /// A function that counts the pixel for every site whose bit is set.
    fn flush(&mut self, memory: Memory, words: u32) -> naga::Function {
        let main = self.hir.main.expect("a checked program has a main");
        let mut builder = Builder::new(self, main);
        builder.function.name = Some("flush".to_owned());
        // The array of bits itself is picked from by constants only, so that drivers keep it in registers.
        let ty = Type::UINT.array_of(words);
        let copy = builder.variable(ty, None);
        let seen = builder.global(memory.seen);
        for index in 0..words {
            let [from, to] = [seen, copy].map(|array| builder.part(array, index));
            let word = builder.load(from);
            builder.store(to, word);
        }
        builder.count_to(words, |b, index| {
            let pointer = b.access(copy, index);
            let word = b.load(pointer);
            b.flush_word(memory, word, index);
        });
        builder.push(Statement::Return { value: None });
        builder.finish()
    }

    /// Gives the memory its types. Returns the sites, and how many words the buffer has.
    pub fn finish_findings(&mut self) -> (Vec<Site>, Option<u32>) {
        let sites = std::mem::take(&mut self.sanitizer.sites);
        let Some(memory) = self.sanitizer.memory else {
            return (sites, None);
        };
        let words = (sites.len() as u32).div_ceil(u32::BITS).max(1);
        let word = self.ty(Type::UINT);
        self.set_array(memory.seen, word, words);
        let (length, element) = match &self.options.checks {
            Checks::Operands(wanted) => (wanted.len() as u32 * OPERAND_WORDS, word),
            _ => {
                let atomic = self.add_type(TypeInner::Atomic(naga::Scalar::U32));
                (words * u32::BITS * SITE_WORDS, atomic)
            }
        };
        self.set_array(memory.findings, element, length.max(1));
        if let Some(flush) = memory.flush {
            let function = self.flush(memory, words);
            *self.module.functions.get_mut(flush) = function;
        }
        (sites, Some(length.max(1)))
    }

    fn set_array(
        &mut self,
        variable: Handle<naga::GlobalVariable>,
        base: Handle<naga::Type>,
        length: u32,
    ) {
        let size = ArraySize::Constant(NonZeroU32::new(length).expect("there is an element"));
        let stride = 4;
        let ty = self.add_type(TypeInner::Array { base, size, stride });
        self.module.global_variables.get_mut(variable).ty = ty;
    }
}

impl Builder<'_, '_> {
    /// Notes which pixel it is.
    pub fn note_pixel(&mut self, position: H) {
        let Some(memory) = self.context.sanitizer.memory else {
            return;
        };
        let [x, y] = [0, 1].map(|axis| {
            let coordinate = self.part(position, axis);
            self.cast(coordinate, ScalarKind::Uint, Some(4))
        });
        let sixteen = self.uint(16);
        let row = self.binary(BinaryOperator::ShiftLeft, y, sixteen);
        let pixel = self.binary(BinaryOperator::InclusiveOr, row, x);
        let pointer = self.global(memory.pixel);
        self.store(pointer, pixel);
    }

    /// Adds the pixel's findings to the host's buffer, because it ends here.
    pub fn flush_findings(&mut self) {
        let memory = self.context.sanitizer.memory;
        if let Some(function) = memory.and_then(|memory| memory.flush) {
            self.push(Statement::Call {
                function,
                arguments: Vec::new(),
                result: None,
            });
        }
    }

    fn flush_word(&mut self, memory: Memory, word: H, index: H) {
        let zero = self.uint(0);
        let is_any = self.binary(BinaryOperator::NotEqual, word, zero);
        self.branch(
            is_any,
            |b| {
                b.count_to(u32::BITS, |b, bit| {
                    let [zero, one, bits] = [0, 1, u32::BITS].map(|n| b.uint(n));
                    let shifted = b.binary(BinaryOperator::ShiftRight, word, bit);
                    let lowest = b.binary(BinaryOperator::And, shifted, one);
                    let is_set = b.binary(BinaryOperator::NotEqual, lowest, zero);
                    let before = b.product(index, bits);
                    let site = b.sum(before, bit);
                    b.branch(is_set, |b| b.count_pixel(memory, site), |_| {});
                });
            },
            |_| {},
        );
    }

    fn count_pixel(&mut self, memory: Memory, site: H) {
        let findings = self.global(memory.findings);
        let [one, two] = [1, SITE_WORDS].map(|n| self.uint(n));
        let at = self.product(site, two);
        let count = self.access(findings, at);
        self.atomic(count, AtomicFunction::Add, one);
        let at = self.sum(at, one);
        let first = self.access(findings, at);
        let pixel = self.global(memory.pixel);
        let pixel = self.load(pixel);
        // Of the complement the largest is wanted, for which the host need only clear the buffer.
        let complement = self.add(Expression::Unary {
            op: naga::UnaryOperator::BitwiseNot,
            expr: pixel,
        });
        self.atomic(first, AtomicFunction::Max, complement);
    }

    fn atomic(&mut self, pointer: H, fun: AtomicFunction, value: H) {
        self.push(Statement::Atomic {
            pointer,
            fun,
            value,
            result: None,
        });
    }

    /// Notes that something goes wrong at a site, if the condition holds. `cause` is the site of the operation
    /// whose operands are given.
    pub(super) fn note(&mut self, here: Here, cause: u32, condition: H, operands: &[Typed]) {
        let Some(memory) = self.context.sanitizer.memory.filter(|_| here.is_wanted) else {
            return;
        };
        if let Checks::Operands(wanted) = &self.context.options.checks {
            let slot = wanted.iter().position(|(site, _)| *site == here.number);
            let slot = slot.expect("it is wanted");
            let [x, y] = wanted[slot].1.map(u32::from);
            let pixel = self.uint(y << 16 | x);
            let own = self.global(memory.pixel);
            let own = self.load(own);
            let is_here = self.binary(BinaryOperator::Equal, own, pixel);
            let both = self.binary(BinaryOperator::LogicalAnd, condition, is_here);
            let at = slot as u32 * OPERAND_WORDS;
            self.branch(
                both,
                |b| b.keep_operands(memory, at, cause, operands),
                |_| {},
            );
            return;
        }
        let seen = self.global(memory.seen);
        let word = self.part(seen, here.number / u32::BITS);
        let before = self.load(word);
        let [bit, zero] = [1 << (here.number % u32::BITS), 0].map(|n| self.uint(n));
        let bit = self.select(condition, bit, zero);
        let after = self.binary(BinaryOperator::InclusiveOr, before, bit);
        self.store(word, after);
    }

    /// Writes operands to the buffer, unless there are some already.
    fn keep_operands(&mut self, memory: Memory, at: u32, cause: u32, operands: &[Typed]) {
        let findings = self.global(memory.findings);
        let mark = self.part(findings, at);
        let before = self.load(mark);
        let zero = self.uint(0);
        let is_first = self.binary(BinaryOperator::Equal, before, zero);
        self.branch(
            is_first,
            |b| {
                let cause = b.uint(cause + 1);
                b.store(mark, cause);
                let mut words = Vec::new();
                for operand in operands {
                    b.words_of(*operand, &mut words);
                }
                for (word, place) in words.into_iter().zip(1..OPERAND_WORDS) {
                    let to = b.part(findings, at + place);
                    b.store(to, word);
                }
            },
            |_| {},
        );
    }

    /// The bits of every component.
    fn words_of(&mut self, operand: Typed, words: &mut Vec<H>) {
        let Typed { value, ty } = operand;
        match ty.base {
            Base::Scalar(Scalar::Uint) => words.push(value),
            Base::Scalar(Scalar::Bool) => {
                words.push(self.cast(value, ScalarKind::Uint, Some(4)));
            }
            Base::Scalar(_) => words.push(self.cast(value, ScalarKind::Uint, None)),
            Base::Vector(..) | Base::Matrix { .. } => {
                for index in 0..count(ty) {
                    let value = self.part(value, index);
                    let ty = element_type(ty);
                    self.words_of(Typed { value, ty }, words);
                }
            }
            _ => unreachable!("operands are numbers"),
        }
    }

    /// Notes a loop that is cut off, if the condition holds.
    pub fn note_endless(&mut self, condition: H) {
        if self.context.sanitizer.memory.is_some() {
            let here = self.site(Hazard::Endless, Form::Loop, &[]);
            self.note(here, here.number, condition, &[]);
        }
    }
}
