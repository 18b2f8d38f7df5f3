//! GLSL's types as naga's.

use naga::proc::{Alignment, TypeLayout};
use naga::{ArraySize, Handle, StructMember, TypeInner, VectorSize};

use super::context::Context;
use crate::glsl::Precision;
use crate::glsl::arena::Id;
use crate::glsl::types::{Base, Scalar, Shape, Struct, Type};

/// The size of a vector, or of one side of a matrix.
pub(super) fn size(components: u8) -> VectorSize {
    match components {
        2 => VectorSize::Bi,
        3 => VectorSize::Tri,
        4 => VectorSize::Quad,
        _ => unreachable!("vectors have two to four components"),
    }
}

/// A sampler, or an array of samplers: what no variable of naga's can hold.
pub(super) fn is_opaque(ty: Type) -> bool {
    matches!(ty.base, Base::Sampler(_))
}

impl Context<'_> {
    /// The type of a component.
    pub(super) fn scalar(&self, scalar: Scalar) -> naga::Scalar {
        match (scalar, self.options.precision) {
            (Scalar::Float, Precision::Single) => naga::Scalar::F32,
            (Scalar::Float, Precision::Double) => naga::Scalar::F64,
            (Scalar::Int, _) => naga::Scalar::I32,
            (Scalar::Uint, _) => naga::Scalar::U32,
            (Scalar::Bool, _) => naga::Scalar::BOOL,
        }
    }

    /// A type without a name.
    pub(super) fn add_type(&mut self, inner: TypeInner) -> Handle<naga::Type> {
        let ty = naga::Type { name: None, inner };
        self.module.types.insert(ty, naga::Span::UNDEFINED)
    }

    /// The type of values and variables.
    pub(super) fn ty(&mut self, ty: Type) -> Handle<naga::Type> {
        if let Some(&known) = self.types.get(&ty) {
            return known;
        }
        let handle = if let Some(length) = ty.array {
            let base = self.ty(ty.element());
            let stride = self.layout(base).to_stride();
            self.add_type(TypeInner::Array {
                base,
                size: ArraySize::Constant(length),
                stride,
            })
        } else {
            match ty.base {
                Base::Scalar(scalar) => self.add_type(TypeInner::Scalar(self.scalar(scalar))),
                Base::Vector(scalar, components) => self.add_type(TypeInner::Vector {
                    size: size(components),
                    scalar: self.scalar(scalar),
                }),
                Base::Matrix { columns, rows } => self.add_type(TypeInner::Matrix {
                    columns: size(columns),
                    rows: size(rows),
                    scalar: self.scalar(Scalar::Float),
                }),
                Base::Struct(id) => self.add_struct(id),
                Base::Void | Base::Sampler(_) => unreachable!("values are neither void nor opaque"),
            }
        };
        self.types.insert(ty, handle);
        handle
    }

    /// Where a structure's member is in naga's structure, which lacks samplers.
    pub(super) fn member(&self, id: Id<Struct>, member: u32) -> Option<u32> {
        let fields = &self.hir.structs[id].fields[..=member as usize];
        let (last, before) = fields.split_last()?;
        (!is_opaque(last.ty))
            .then(|| before.iter().filter(|field| !is_opaque(field.ty)).count() as u32)
    }

    fn add_struct(&mut self, id: Id<Struct>) -> Handle<naga::Type> {
        let hir = self.hir;
        let mut members = Vec::new();
        let mut span = 0;
        let mut alignment = Alignment::ONE;
        let mut add = |context: &mut Self, name: &str, ty: Type| {
            let ty = context.ty(ty);
            let layout = context.layout(ty);
            let offset = layout.alignment.round_up(span);
            span = offset + layout.size;
            alignment = alignment.max(layout.alignment);
            members.push(StructMember {
                name: Some(name.to_owned()),
                ty,
                binding: None,
                offset,
            });
        };
        for field in &hir.structs[id].fields {
            if !is_opaque(field.ty) {
                add(self, hir.names.text(field.name), field.ty);
            }
        }
        if hir.structs[id]
            .fields
            .iter()
            .all(|field| is_opaque(field.ty))
        {
            // naga has no empty structures.
            add(self, "unused", Type::INT);
        }
        let name = hir.structs[id].name;
        let ty = naga::Type {
            name: name.map(|name| hir.names.text(name).to_owned()),
            inner: TypeInner::Struct {
                members,
                span: alignment.round_up(span),
            },
        };
        let ty = self.module.types.insert(ty, naga::Span::UNDEFINED);
        self.alignments.insert(ty, alignment);
        ty
    }

    /// What naga's layouter finds, which takes time for all types whenever there is a new one.
    pub(super) fn layout(&self, ty: Handle<naga::Type>) -> TypeLayout {
        let inner = &self.module.types[ty].inner;
        let alignment = match *inner {
            TypeInner::Vector { size, scalar } => {
                Alignment::from(size) * Alignment::from_width(scalar.width)
            }
            TypeInner::Matrix { rows, scalar, .. } => {
                Alignment::from(rows) * Alignment::from_width(scalar.width)
            }
            TypeInner::Array { base, .. } => self.layout(base).alignment,
            TypeInner::Struct { .. } => self.alignments[&ty],
            TypeInner::Scalar(scalar) => Alignment::from_width(scalar.width),
            _ => unreachable!("it has no place in memory"),
        };
        TypeLayout {
            size: inner.size(self.module.to_ctx()),
            alignment,
        }
    }

    /// The type of the texture in a sampler.
    pub(super) fn image_type(&mut self, shape: Shape) -> Handle<naga::Type> {
        self.add_type(TypeInner::Image {
            dim: match shape {
                Shape::Plane | Shape::Layers => naga::ImageDimension::D2,
                Shape::Volume => naga::ImageDimension::D3,
                Shape::Cube => naga::ImageDimension::Cube,
            },
            arrayed: shape == Shape::Layers,
            class: naga::ImageClass::Sampled {
                kind: naga::ScalarKind::Float,
                multi: false,
            },
        })
    }

    /// The type of what a texture is read through.
    pub(super) fn sampler_type(&mut self) -> Handle<naga::Type> {
        self.add_type(TypeInner::Sampler { comparison: false })
    }
}
