//! Types as they are written, §4.1 and §4.1.9.

use super::Checker;
use super::scope::Symbol;
use crate::glsl::syntax::ast::{ArraySize, Extent, Sizes, TypeKind, TypeSpecifier};
use crate::glsl::types::{Base, Type};

/// The number of elements that a type is written with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Length {
    /// It is no array.
    None,
    /// `[]`
    Open,
    /// `[3]`
    Of(u32),
}

impl Checker<'_> {
    /// A written type. A structure that it defines is declared.
    pub(super) fn resolve(&mut self, ty: &TypeSpecifier) -> Option<(Base, Length)> {
        let base = match &ty.kind {
            TypeKind::Basic(base) => Some(*base),
            TypeKind::Struct(definition) => self.structure(definition),
            TypeKind::Named(name) => match self.scopes.find(*name) {
                Some(Symbol::Struct(id)) => Some(Base::Struct(id)),
                Some(Symbol::Wrong) => None,
                _ => {
                    let name = self.text(*name).to_owned();
                    let extent = Extent::of(ty.extent.first);
                    let message = format!("`{name}` is not a type");
                    match foreign_type(&name) {
                        Some(ours) => {
                            let hint = format!("in GLSL it is `{ours}`");
                            self.error_with_hint("unknown-type", message, extent, hint);
                        }
                        None => self.error("unknown-type", message, extent),
                    }
                    None
                }
            },
        };
        let length = self.length(ty.sizes, Length::None);
        Some((base?, length?))
    }

    /// The length that sizes give, behind a type or a name; `inner` is what the type has already.
    pub(super) fn length(&mut self, sizes: Sizes, inner: Length) -> Option<Length> {
        if sizes.is_empty() {
            return Some(inner);
        }
        let sizes = self.ast.sizes.get(sizes);
        let mut lengths = Vec::with_capacity(sizes.len());
        for size in sizes {
            lengths.push(match size.size {
                None => Some(Length::Open),
                Some(_) => self.array_size(size).map(Length::Of),
            });
        }
        let second = match inner {
            Length::None => sizes.get(1),
            _ => sizes.first(),
        };
        if let Some(second) = second {
            let message = "arrays of arrays do not exist in GLSL ES 3.00";
            let hint = "use one array and compute its index, or an array of structures";
            self.error_with_hint("array-of-arrays", message, Extent::of(second.at), hint);
            return None;
        }
        lengths.pop()?
    }

    fn array_size(&mut self, size: &ArraySize) -> Option<u32> {
        let id = size.size?;
        let extent = self.ast.exprs[id].extent;
        let value = self.expression(id)?;
        if value.value.is_none() || !matches!(value.ty, Type::INT | Type::UINT) {
            let message = "the size of an array must be a constant `int` or `uint`";
            self.error("not-constant", message, extent);
            return None;
        }
        let number = self.integer(value)?;
        match u32::try_from(number) {
            Ok(0) => {
                self.error("array-size", "an array has at least one element", extent);
                None
            }
            Ok(number) if number <= i32::MAX as u32 => Some(number),
            _ => {
                let message = format!("an array cannot have {number} elements");
                self.error("array-size", message, extent);
                None
            }
        }
    }

    /// The type of a variable, once its initialiser's type is known where sizes are open.
    pub(super) fn closed(base: Base, length: Length, init: Option<Type>) -> Option<Type> {
        match length {
            Length::None => Some(Type::of(base)),
            Length::Of(length) => Some(Type::of(base).array_of(length)),
            Length::Open => {
                let length = init?.array?;
                Some(Type::of(base).array_of(length.get()))
            }
        }
    }
}

/// What GLSL calls a type of other shading languages.
fn foreign_type(name: &str) -> Option<&'static str> {
    Some(match name {
        "float2" | "half2" | "fixed2" => "vec2",
        "float3" | "half3" | "fixed3" => "vec3",
        "float4" | "half4" | "fixed4" => "vec4",
        "int2" => "ivec2",
        "int3" => "ivec3",
        "int4" => "ivec4",
        "uint2" => "uvec2",
        "uint3" => "uvec3",
        "uint4" => "uvec4",
        "float2x2" => "mat2",
        "float3x3" => "mat3",
        "float4x4" => "mat4",
        _ => return None,
    })
}
