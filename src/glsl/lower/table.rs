//! Large constant arrays, which live in a buffer of words. Drivers take seconds to minutes for them
//! as code.

use std::num::NonZeroU32;

use naga::{AddressSpace, BinaryOperator, Handle, Literal, ScalarKind, Span, Statement, TypeInner};
use rustc_hash::FxHashMap;

use super::constant::{Part, parts};
use super::context::Context;
use super::function::{Builder, H};
use super::interface::Tables;
use super::place::count;
use crate::glsl::Precision;
use crate::glsl::arena::Id;
use crate::glsl::hir::{Constant, Value};
use crate::glsl::types::{Base, Scalar, Type};

/// The words that fit into every device's uniform buffers.
const UNIFORM_WORDS: u64 = 64 * 1024 / 4;

/// The tables while they are gathered.
#[derive(Default)]
pub(super) struct TableBuilder {
    words: Vec<u32>,
    /// Where each table begins.
    starts: FxHashMap<(Part, Type), u32>,
    /// Where tables of the same words begin.
    known: FxHashMap<Vec<u32>, u32>,
    /// The constants that may become tables, and how many words there are of them at most.
    reserved: FxHashMap<Id<Constant>, u64>,
    variable: Option<Handle<naga::GlobalVariable>>,
}

impl Context<'_> {
    /// The number of words that a value takes in a table.
    pub fn words(&self, ty: Type) -> u32 {
        let one = match ty.base {
            Base::Void | Base::Sampler(_) => 0,
            Base::Scalar(scalar) => self.scalar_words(scalar),
            Base::Vector(scalar, size) => self.scalar_words(scalar) * u32::from(size),
            Base::Matrix { columns, rows } => {
                self.scalar_words(Scalar::Float) * u32::from(columns) * u32::from(rows)
            }
            Base::Struct(id) => {
                let fields = self.hir.structs[id].fields.iter();
                fields.map(|field| self.words(field.ty)).sum()
            }
        };
        one * ty.array.map_or(1, NonZeroU32::get)
    }

    /// A `float` of 64 bits is the sum of two of 32.
    fn scalar_words(&self, scalar: Scalar) -> u32 {
        match (scalar, self.options.precision) {
            (Scalar::Float, Precision::Double) => 2,
            _ => 1,
        }
    }

    /// Reckons with a constant that may become a table: the kind of buffer must be known before the
    /// first is read.
    pub fn reserve_table(&mut self, constant: Id<Constant>, ty: Type) {
        if (ty.is_array() || matches!(ty.base, Base::Struct(_)))
            && self.needs_table(Part::whole(constant), ty)
        {
            let words = self.words(ty).into();
            self.tables.reserved.insert(constant, words);
        }
    }

    fn tables_in_storage(&self) -> bool {
        self.tables.reserved.values().sum::<u64>() > UNIFORM_WORDS
    }

    /// The place of a constant array's first word.
    pub fn table(&mut self, part: Part, ty: Type) -> u32 {
        if let Some(&start) = self.tables.starts.get(&(part, ty)) {
            return start;
        }
        let mut words = Vec::new();
        for &value in self.values(part, ty) {
            match (value, self.options.precision) {
                (Value::Float(value), Precision::Single) => words.push((value as f32).to_bits()),
                (Value::Float(value), Precision::Double) => {
                    let high = value as f32;
                    let low = (value - f64::from(high)) as f32;
                    words.push(high.to_bits());
                    words.push(if high.is_finite() { low.to_bits() } else { 0 });
                }
                (Value::Int(value), _) => words.push(value as u32),
                (Value::Uint(value), _) => words.push(value),
                (Value::Bool(value), _) => words.push(value.into()),
            }
        }
        let end = self.tables.words.len() as u32;
        let start = *self.tables.known.entry(words).or_insert_with_key(|words| {
            self.tables.words.extend_from_slice(words);
            end
        });
        self.tables.starts.insert((part, ty), start);
        start
    }

    fn table_variable(&mut self) -> Handle<naga::GlobalVariable> {
        if let Some(known) = self.tables.variable {
            return known;
        }
        let space = if self.tables_in_storage() {
            AddressSpace::Storage {
                access: naga::StorageAccess::LOAD,
            }
        } else {
            AddressSpace::Uniform
        };
        let variable = naga::GlobalVariable {
            name: Some("tables".to_owned()),
            space,
            binding: Some(self.resource(self.options.interface.tables)),
            // Its type is known when all tables are.
            ty: self.ty(Type::UINT),
            init: None,
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let variable = self
            .module
            .global_variables
            .append(variable, Span::UNDEFINED);
        self.tables.variable = Some(variable);
        variable
    }

    /// Gives the buffer its type.
    pub fn finish_tables(&mut self) -> Option<Tables> {
        let variable = self.tables.variable?;
        let in_storage = self.tables_in_storage();
        let mut words = std::mem::take(&mut self.tables.words);
        words.resize(words.len().next_multiple_of(4).max(4), 0);
        let (element, stride) = if in_storage {
            (Type::UINT, 4)
        } else {
            (Type::vector(Scalar::Uint, 4), 16)
        };
        let base = self.ty(element);
        let length = words.len() as u32 * 4 / stride;
        let length = NonZeroU32::new(length).expect("there is a word at least");
        let ty = self.add_type(TypeInner::Array {
            base,
            size: naga::ArraySize::Constant(length),
            stride,
        });
        self.module.global_variables.get_mut(variable).ty = ty;
        Some(Tables { words, in_storage })
    }
}

impl Builder<'_, '_> {
    /// The words before an element that is picked at run time, which is brought into range.
    pub(super) fn table_index(&mut self, index: H, of: Type, length: u32, step: u32) -> H {
        let index = match of.scalar() {
            Some(Scalar::Uint) => index,
            _ => self.cast(index, ScalarKind::Uint, None),
        };
        let last = self.uint(length - 1);
        let index = self.math(naga::MathFunction::Min, &[index, last]);
        match step {
            1 => index,
            _ => {
                let step = self.uint(step);
                self.product(index, step)
            }
        }
    }

    /// Reads a value from a table.
    pub(super) fn load_table(&mut self, at: H, offset: u32, ty: Type) -> H {
        if let (None, Base::Scalar(scalar)) = (ty.array, ty.base) {
            let word = self.load_word(at, offset);
            return match (scalar, self.context.options.precision) {
                (Scalar::Float, Precision::Single) => self.cast(word, ScalarKind::Float, None),
                (Scalar::Float, Precision::Double) => {
                    let low = self.load_word(at, offset + 1);
                    let [high, low] = [word, low].map(|word| {
                        let float = self.cast(word, ScalarKind::Float, None);
                        self.widen(float)
                    });
                    self.sum(high, low)
                }
                (Scalar::Int, _) => self.cast(word, ScalarKind::Sint, None),
                (Scalar::Uint, _) => word,
                (Scalar::Bool, _) => {
                    let zero = self.uint(0);
                    self.binary(BinaryOperator::NotEqual, word, zero)
                }
            };
        }
        let mut components = Vec::new();
        let mut offset = offset;
        for part in parts(self.context, ty) {
            components.push(self.load_table(at, offset, part));
            offset += self.context.words(part);
        }
        self.compose(ty, components)
    }

    fn load_word(&mut self, at: H, offset: u32) -> H {
        let at = match offset {
            0 => at,
            _ => {
                let offset = self.uint(offset);
                self.sum(at, offset)
            }
        };
        let variable = self.context.table_variable();
        let in_storage = self.context.tables_in_storage();
        let tables = self.global(variable);
        let pointer = if in_storage {
            self.access(tables, at)
        } else {
            let two = self.uint(2);
            let row = self.binary(BinaryOperator::ShiftRight, at, two);
            let row = self.access(tables, row);
            let three = self.uint(3);
            let column = self.binary(BinaryOperator::And, at, three);
            self.access(row, column)
        };
        self.load(pointer)
    }

    /// Sets every element of an array in a loop. A statement for each would take drivers long.
    pub(super) fn fill(&mut self, pointer: H, ty: Type, element: impl FnOnce(&mut Self, H) -> H) {
        self.count_to(count(ty), |builder, index| {
            let value = element(builder, index);
            let to = builder.access(pointer, index);
            builder.store(to, value);
        });
    }

    /// Does something for every number below another, in a loop.
    pub(super) fn count_to(&mut self, end: u32, each: impl FnOnce(&mut Self, H)) {
        let counter = self.acquire(Type::UINT);
        let zero = self.literal(Literal::U32(0));
        self.store(counter, zero);
        self.open();
        let index = self.load(counter);
        let end = self.uint(end);
        let condition = self.binary(BinaryOperator::Less, index, end);
        self.open();
        let accept = self.close();
        self.open();
        self.push(Statement::Break);
        let reject = self.close();
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
        each(self, index);
        let body = self.close();
        self.open();
        let index = self.load(counter);
        let one = self.uint(1);
        let next = self.sum(index, one);
        self.store(counter, next);
        let continuing = self.close();
        self.push(Statement::Loop {
            body,
            continuing,
            break_if: None,
        });
        self.release(Type::UINT, counter);
    }
}
