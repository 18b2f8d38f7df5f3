//! Variables and their parts: members, elements and components, to read and to write.
//!
//! A chain such as `a[i].s.xy` is followed to its end before anything is loaded, so that only what
//! is asked for is read, and an index is evaluated once however the place is used.

use naga::{Expression, MathFunction};

use super::constant::{Part, TABLE_SIZE};
use super::context::Binding;
use super::expression::Typed;
use super::function::{Builder, H, Local};
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, ExprKind, Swizzle, Value, value_count};
use crate::glsl::types::{Base, Scalar, Type};

/// Something that has parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub source: Source,
    pub ty: Type,
}

/// Where a value is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Source {
    /// Behind a pointer that can be loaded and stored.
    Pointer(H),
    /// In components of the vector behind a pointer.
    Components(H, u8, Swizzle),
    /// At hand.
    Value(H),
    /// In the uniform block, perhaps in the first components of a longer vector.
    Uniform(H, bool),
    /// In a constant table: so many words behind a word that is picked at run time.
    Table(H, u32),
    /// In a constant.
    Constant(Part),
    /// Nowhere: it is zero.
    Zero,
}

impl<'a> Builder<'_, 'a> {
    /// What an expression names, or else its value.
    pub(super) fn place(&mut self, id: Id<hir::Expr>) -> Place {
        let hir::Expr { kind, ty, extent } = self.source.exprs[id];
        let source = match kind {
            ExprKind::Local(local) => match self.local(local) {
                Local::Pointer(pointer) => Source::Pointer(pointer),
                Local::Value(value) => Source::Value(value),
                Local::Constant(constant) => Source::Constant(Part::whole(constant)),
                Local::Zero | Local::Null => Source::Zero,
                Local::Image(..) => unreachable!("samplers have no value"),
            },
            ExprKind::Global(global) => self.global_source(global),
            ExprKind::Constant(constant) => Source::Constant(Part::whole(constant)),
            ExprKind::Index(base, index) => {
                let base = self.place(base);
                return match self.constant_index(index) {
                    Some(index) => self.element(base, index),
                    None => {
                        let proven = self.is_below(index, count(base.ty));
                        let at = self.value(index);
                        if let Expression::Literal(literal) = self.function.expressions[at] {
                            return self.element(base, literal_index(literal));
                        }
                        let of = self.source.exprs[index].ty;
                        if proven || matches!(base.source, Source::Zero) {
                            return self.element_at(base, at, of);
                        }
                        self.context.unguarded.accesses.push(extent);
                        let index = Typed { value: at, ty: of };
                        self.check_index(index, count(base.ty), extent);
                        let at = self.not_negative(at, of);
                        self.element_at(base, at, of)
                    }
                };
            }
            ExprKind::Member(base, member) => {
                let base = self.place(base);
                return self.member(base, member, ty);
            }
            ExprKind::Swizzle(base, swizzle) => {
                let base = self.place(base);
                return self.swizzled(base, swizzle);
            }
            _ => Source::Value(self.value(id)),
        };
        Place { source, ty }
    }

    /// An index that may be out of range. WebGL2 takes the first element for a negative one, but
    /// checks at run time, which go by its bits, the last.
    fn not_negative(&mut self, index: H, ty: Type) -> H {
        if ty != Type::INT {
            return index;
        }
        let zero = self.int(0);
        self.math(MathFunction::Max, &[index, zero])
    }

    fn global_source(&mut self, id: Id<hir::Global>) -> Source {
        let hir = self.context.hir;
        if let Some(position) = self.position(hir.globals[id].kind) {
            return Source::Value(position);
        }
        match self.context.globals[&id] {
            Binding::Variable(variable) => Source::Pointer(self.global(variable)),
            Binding::Constant(constant) => Source::Constant(Part::whole(constant)),
            Binding::Zero => Source::Zero,
            Binding::True => Source::Value(self.bool(true)),
            Binding::Uniform(block, member) => {
                let block = self.global(block);
                Source::Uniform(self.part(block, member), false)
            }
            Binding::Image(..) => unreachable!("samplers have no value"),
        }
    }

    /// The number that an index is known to be.
    fn constant_index(&self, id: Id<hir::Expr>) -> Option<u32> {
        match self.source.exprs[id].kind {
            ExprKind::Constant(constant) => match self.context.hir.constants.get(constant) {
                [Value::Int(value)] => Some((*value).max(0) as u32),
                [Value::Uint(value)] => Some(*value),
                other => unreachable!("{other:?} is no index"),
            },
            _ => None,
        }
    }

    /// An element whose place is known.
    pub(super) fn element(&mut self, base: Place, index: u32) -> Place {
        let ty = element_type(base.ty);
        // An index that is only known to us may be out of range, which GLSL leaves open.
        let index = index.min(count(base.ty) - 1);
        let source = match base.source {
            Source::Pointer(pointer) => Source::Pointer(self.part(pointer, index)),
            Source::Components(pointer, _, swizzle) => {
                let component = swizzle.components[index as usize];
                Source::Pointer(self.part(pointer, component.into()))
            }
            Source::Value(value) => Source::Value(self.part(value, index)),
            Source::Uniform(pointer, padded) if base.ty.is_vector() => {
                let vector = self.load_uniform(pointer, padded, base.ty);
                Source::Value(self.part(vector, index))
            }
            Source::Uniform(pointer, _) => {
                Source::Uniform(self.part(pointer, index), is_padded(ty))
            }
            Source::Table(at, offset) => Source::Table(at, offset + index * self.context.words(ty)),
            Source::Constant(part) => {
                let start = index * value_count(&self.context.hir.structs, ty);
                Source::Constant(part.from(start))
            }
            Source::Zero => Source::Zero,
        };
        Place { source, ty }
    }

    /// An element that is picked at run time.
    fn element_at(&mut self, base: Place, index: H, of: Type) -> Place {
        let ty = element_type(base.ty);
        let source = match base.source {
            Source::Pointer(pointer) => Source::Pointer(self.access(pointer, index)),
            Source::Components(pointer, _, swizzle) => {
                let components = swizzle.as_slice();
                let numbers = components.iter().map(|&i| self.uint(i.into())).collect();
                let order = Type::vector(Scalar::Uint, swizzle.len);
                let order = self.compose(order, numbers);
                let component = self.access(order, index);
                Source::Pointer(self.access(pointer, component))
            }
            Source::Value(value) => Source::Value(self.access(value, index)),
            Source::Uniform(pointer, padded) if base.ty.is_vector() => {
                let vector = self.load_uniform(pointer, padded, base.ty);
                Source::Value(self.access(vector, index))
            }
            Source::Uniform(pointer, _) => {
                Source::Uniform(self.access(pointer, index), is_padded(ty))
            }
            Source::Table(at, offset) => {
                let step = self.context.words(ty);
                let relative = self.table_index(index, of, count(base.ty), step);
                Source::Table(self.sum(at, relative), offset)
            }
            Source::Constant(part) if base.ty.is_array() => {
                if self.context.needs_table(part, base.ty) {
                    let start = self.context.table(part, base.ty);
                    let step = self.context.words(ty);
                    Source::Table(self.table_index(index, of, count(base.ty), step), start)
                } else {
                    let array = self.context.constant_array(part, base.ty);
                    let array = self.global(array);
                    Source::Pointer(self.access(array, index))
                }
            }
            Source::Constant(part) => {
                let value = self.constant(part, base.ty);
                Source::Value(self.access(value, index))
            }
            Source::Zero => Source::Zero,
        };
        Place { source, ty }
    }

    /// A member of a structure.
    pub(super) fn member(&mut self, base: Place, member: u32, ty: Type) -> Place {
        let Base::Struct(id) = base.ty.base else {
            unreachable!("only structures have members");
        };
        let fields = &self.context.hir.structs[id].fields[..member as usize];
        let index = self.context.member(id, member);
        let source = match (base.source, index) {
            (Source::Zero, _) | (_, None) => Source::Zero,
            (Source::Pointer(pointer), Some(index)) => Source::Pointer(self.part(pointer, index)),
            (Source::Value(value), Some(index)) => Source::Value(self.part(value, index)),
            (Source::Table(at, offset), _) => {
                let before = fields.iter().map(|field| self.context.words(field.ty));
                Source::Table(at, offset + before.sum::<u32>())
            }
            (Source::Constant(part), _) => {
                let structs = &self.context.hir.structs;
                let before = fields.iter().map(|field| value_count(structs, field.ty));
                Source::Constant(part.from(before.sum()))
            }
            (Source::Components(..) | Source::Uniform(..), _) => {
                unreachable!("they are no structures")
            }
        };
        Place { source, ty }
    }

    fn swizzled(&mut self, base: Place, swizzle: Swizzle) -> Place {
        let scalar = base.ty.scalar().expect("only vectors have components");
        let ty = Type::vector(scalar, swizzle.len);
        let size = base.ty.vector_size().expect("only vectors have components");
        let source = match base.source {
            _ if swizzle.len == 1 && size > 1 => {
                return self.element(base, swizzle.components[0].into());
            }
            Source::Zero => Source::Zero,
            Source::Pointer(pointer) if size > 1 => Source::Components(pointer, size, swizzle),
            Source::Components(pointer, size, first) => {
                let components = swizzle.components.map(|i| first.components[usize::from(i)]);
                let len = swizzle.len;
                Source::Components(pointer, size, Swizzle { len, components })
            }
            _ => {
                let vector = self.load_place(base);
                Source::Value(match size {
                    1 => self.splat(vector, swizzle.len),
                    _ => self.swizzle(vector, swizzle.as_slice()),
                })
            }
        };
        Place { source, ty }
    }

    /// The value at a place.
    pub(super) fn load_place(&mut self, place: Place) -> H {
        let Place { source, ty } = place;
        match source {
            Source::Pointer(pointer) => self.load(pointer),
            Source::Components(pointer, _, swizzle) => {
                let vector = self.load(pointer);
                self.swizzle(vector, swizzle.as_slice())
            }
            Source::Value(value) => value,
            Source::Uniform(pointer, padded) => self.load_uniform(pointer, padded, ty),
            Source::Table(at, offset) => self.load_table(at, offset, ty),
            Source::Constant(part) => self.constant(part, ty),
            Source::Zero => self.zero(ty),
        }
    }

    /// Sets a place.
    pub(super) fn store_place(&mut self, place: Place, value: H) {
        match place.source {
            Source::Pointer(pointer) => self.store(pointer, value),
            Source::Components(pointer, _, swizzle) => {
                for (i, &component) in swizzle.as_slice().iter().enumerate() {
                    let to = self.part(pointer, component.into());
                    let value = self.part(value, i as u32);
                    self.store(to, value);
                }
            }
            other => unreachable!("{other:?} is no place to store at"),
        }
    }

    /// Sets what a pointer points to to zero.
    pub(super) fn store_zero(&mut self, pointer: H, ty: Type) {
        if ty.is_array() && value_count(&self.context.hir.structs, ty) > TABLE_SIZE {
            let element = ty.element();
            self.fill(pointer, ty, |builder, _| builder.zero(element));
        } else {
            let zero = self.zero(ty);
            self.store(pointer, zero);
        }
    }
}

/// The type of a part that is picked by an index.
pub(super) fn element_type(ty: Type) -> Type {
    match (ty.array, ty.base) {
        (Some(_), _) => ty.element(),
        (None, Base::Vector(scalar, _)) => Type::vector(scalar, 1),
        (None, Base::Matrix { rows, .. }) => Type::vector(Scalar::Float, rows),
        _ => unreachable!("it has no elements"),
    }
}

/// The number of parts that an index can pick.
pub(super) fn count(ty: Type) -> u32 {
    match (ty.array, ty.base) {
        (Some(length), _) => length.get(),
        (None, Base::Vector(_, size)) => size.into(),
        (None, Base::Matrix { columns, .. }) => columns.into(),
        _ => unreachable!("it has no elements"),
    }
}

/// Whether an element of an array or a matrix in the uniform block is kept in a longer vector.
pub(super) fn is_padded(ty: Type) -> bool {
    ty.vector_size().is_some_and(|size| size < 3)
}

fn literal_index(literal: naga::Literal) -> u32 {
    match literal {
        naga::Literal::I32(value) => value.max(0) as u32,
        naga::Literal::U32(value) => value,
        other => unreachable!("{other:?} is no index"),
    }
}
