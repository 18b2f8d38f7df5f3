//! The host's uniforms: a block laid out like std140, of which the program's types may differ.
//!
//! What WGSL cannot lay out that way is kept in longer vectors: elements of fewer than three
//! components, and a matrix is an array of its columns. A `bool` is a `uint`.

use std::num::NonZeroU32;

use naga::{AddressSpace, BinaryOperator, Handle, Span, StructMember, TypeInner};

use super::context::{Binding, Context};
use super::function::{Builder, H};
use super::interface::{UniformBlock, UniformMember};
use super::place::is_padded;
use super::types::size;
use crate::glsl::arena::Id;
use crate::glsl::hir::{Global, GlobalKind};
use crate::glsl::types::{Base, Scalar, Type};

impl Context<'_> {
    /// Declares the block, if the program names a uniform that can be in it.
    pub fn add_uniforms(&mut self) {
        let of_host = self.uniforms_of_host();
        let mut members = Vec::new();
        let mut ids = Vec::new();
        let mut end = 0;
        for &id in of_host.iter().chain(&self.uniforms_of_program(&of_host)) {
            let ty = self.hir.globals[id].ty;
            // No component takes more, so that what is too large is known before it is laid out.
            let most = 16 * u64::from(self.hir.value_count(ty));
            if u64::from(end) + 16 + most > self.options.interface.block_size.into() {
                continue;
            }
            let stored = self.stored(ty, false);
            let layout = self.layout(stored);
            let alignment = match (ty.array, ty.base) {
                (None, Base::Scalar(_) | Base::Vector(..)) => layout.alignment.round_up(1),
                _ => 16,
            };
            let offset = u32::next_multiple_of(end, alignment);
            end = offset + layout.size;
            members.push(StructMember {
                name: Some(self.hir.names.text(self.hir.globals[id].name).to_owned()),
                ty: stored,
                binding: None,
                offset,
            });
            ids.push(id);
        }
        if members.is_empty() {
            return;
        }
        let span = end.next_multiple_of(16);
        let known = ids.iter().zip(&members);
        let known = known.filter(|(id, _)| of_host.contains(id));
        self.uniforms = Some(UniformBlock {
            size: span,
            members: known
                .map(|(_, member)| UniformMember {
                    name: member.name.clone().unwrap_or_default(),
                    offset: member.offset,
                })
                .collect(),
        });
        let ty = naga::Type {
            name: Some("Uniforms".to_owned()),
            inner: TypeInner::Struct { members, span },
        };
        let ty = self.module.types.insert(ty, Span::UNDEFINED);
        let block = naga::GlobalVariable {
            name: Some("uniforms".to_owned()),
            space: AddressSpace::Uniform,
            binding: Some(self.resource(self.options.interface.block)),
            ty,
            init: None,
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let block = self.module.global_variables.append(block, Span::UNDEFINED);
        for (i, id) in ids.into_iter().enumerate() {
            self.globals.insert(id, Binding::Uniform(block, i as u32));
        }
    }

    /// The host's uniforms among those that the program names, in the host's order.
    fn uniforms_of_host(&self) -> Vec<Id<Global>> {
        let names = self.options.interface.uniforms.iter();
        let find = |name: &String| {
            let mut storable = self.storable_uniforms();
            storable.find(|&id| self.hir.names.text(self.hir.globals[id].name) == name)
        };
        names.filter_map(find).collect()
    }

    /// The others, which nobody sets.
    fn uniforms_of_program(&self, of_host: &[Id<Global>]) -> Vec<Id<Global>> {
        let storable = self.storable_uniforms();
        storable.filter(|id| !of_host.contains(id)).collect()
    }

    fn storable_uniforms(&self) -> impl Iterator<Item = Id<Global>> {
        let named = self.reachable.globals.iter().copied();
        named.filter(|&id| {
            let global = &self.hir.globals[id];
            global.kind == GlobalKind::Uniform && is_storable(global.ty)
        })
    }

    /// The type of a uniform in the block, or of an element or a column of one.
    fn stored(&mut self, ty: Type, is_element: bool) -> Handle<naga::Type> {
        let (element, length) = match (ty.array, ty.base) {
            (Some(length), _) => (ty.element(), length.get()),
            (None, Base::Matrix { columns, rows }) => {
                (Type::vector(Scalar::Float, rows), columns.into())
            }
            (None, Base::Scalar(scalar)) => {
                let scalar = stored_scalar(scalar);
                return self.add_type(if is_element {
                    let size = naga::VectorSize::Quad;
                    TypeInner::Vector { size, scalar }
                } else {
                    TypeInner::Scalar(scalar)
                });
            }
            (None, Base::Vector(scalar, components)) => {
                let padded = is_element && is_padded(ty);
                let size = size(if padded { 4 } else { components });
                let scalar = stored_scalar(scalar);
                return self.add_type(TypeInner::Vector { size, scalar });
            }
            _ => unreachable!("uniforms are numbers"),
        };
        let base = self.stored(element, true);
        let stride = self.layout(base).to_stride();
        let length = NonZeroU32::new(length).expect("arrays and matrices have elements");
        self.add_type(TypeInner::Array {
            base,
            size: naga::ArraySize::Constant(length),
            stride,
        })
    }
}

/// Whether the block can hold a type.
fn is_storable(ty: Type) -> bool {
    matches!(
        ty.base,
        Base::Scalar(_) | Base::Vector(..) | Base::Matrix { .. }
    )
}

/// What a component is in the block, whatever the precision.
fn stored_scalar(scalar: Scalar) -> naga::Scalar {
    match scalar {
        Scalar::Float => naga::Scalar::F32,
        Scalar::Int => naga::Scalar::I32,
        Scalar::Uint | Scalar::Bool => naga::Scalar::U32,
    }
}

impl Builder<'_, '_> {
    /// Reads a uniform, or an element of one.
    pub(super) fn load_uniform(&mut self, pointer: H, padded: bool, ty: Type) -> H {
        let Some(size) = ty.vector_size() else {
            let part = match ty.array {
                Some(_) => ty.element(),
                None => super::place::element_type(ty),
            };
            let components = (0..super::place::count(ty))
                .map(|i| {
                    let pointer = self.part(pointer, i);
                    self.load_uniform(pointer, is_padded(part), part)
                })
                .collect();
            return self.compose(ty, components);
        };
        let mut value = self.load(pointer);
        if padded {
            value = self.swizzle(value, &[0, 1, 2, 3][..usize::from(size)]);
        }
        match ty.scalar() {
            Some(Scalar::Float) => self.widen(value),
            Some(Scalar::Bool) => {
                let zero = self.uint(0);
                let zero = self.splat(zero, size);
                self.binary(BinaryOperator::NotEqual, value, zero)
            }
            _ => value,
        }
    }
}
