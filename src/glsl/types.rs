//! The types of GLSL ES 3.00, §4.1, as the checked program has them.

use std::num::NonZeroU32;

use super::arena::{Arena, Id};
use super::names::{Name, Names};

/// A complete type. Arrays have one dimension: ES 3.00 knows no arrays of arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Type {
    /// The type, or an array's elements' type.
    pub base: Base,
    /// Number of elements, if it is an array.
    pub array: Option<NonZeroU32>,
}

/// A type that is not an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Base {
    /// No value.
    Void,
    /// One number or truth value.
    Scalar(Scalar),
    /// Two to four components.
    Vector(Scalar, u8),
    /// `columns` vectors of `rows` floats: `matCxR`.
    Matrix {
        /// Number of columns, 2 to 4.
        columns: u8,
        /// Number of rows, 2 to 4.
        rows: u8,
    },
    /// A structure.
    Struct(Id<Struct>),
    /// An opaque handle of a texture together with how it is sampled.
    Sampler(Sampler),
}

/// What a component may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Scalar {
    /// `float`
    Float,
    /// `int`
    Int,
    /// `uint`
    Uint,
    /// `bool`
    Bool,
}

/// A sampler type: `sampler2D`, `isampler3D`, `samplerCubeShadow`, ….
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sampler {
    /// What a texel's components are: `Float`, `Int` or `Uint`.
    pub texel: Scalar,
    /// The texture's shape.
    pub shape: Shape,
    /// Whether reads compare with a reference depth.
    pub shadow: bool,
}

/// The shape of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// `sampler2D`
    Plane,
    /// `sampler3D`
    Volume,
    /// `samplerCube`
    Cube,
    /// `sampler2DArray`
    Layers,
}

/// A structure type.
#[derive(Clone, Debug)]
pub struct Struct {
    /// Its name; `None` for an anonymous one.
    pub name: Option<Name>,
    /// Its members in order.
    pub fields: Vec<Field>,
    /// What its values consist of.
    pub content: Content,
}

/// What a value consists of, structures seen through. It is kept with every structure: to find it
/// anew would take time that doubles with each level of structures within structures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Content {
    /// The scalars; samplers count as none.
    pub values: u32,
    /// The members that are no structures, where an array counts as one element.
    pub members: u32,
    /// How many structures stand within each other.
    pub depth: u32,
    /// Whether there is a sampler.
    pub has_sampler: bool,
    /// Whether there is an array.
    pub has_array: bool,
}

impl Content {
    /// What a value of a type consists of.
    pub fn of(ty: Type, structs: &Arena<Struct>) -> Content {
        let one = match ty.base {
            Base::Struct(id) => structs[id].content,
            base => Content {
                values: match base {
                    Base::Scalar(_) => 1,
                    Base::Vector(_, size) => size.into(),
                    Base::Matrix { columns, rows } => u32::from(columns) * u32::from(rows),
                    _ => 0,
                },
                members: 1,
                has_sampler: matches!(base, Base::Sampler(_)),
                ..Content::default()
            },
        };
        let length = ty.array.map_or(1, NonZeroU32::get);
        Content {
            values: one.values.saturating_mul(length),
            has_array: one.has_array || ty.is_array(),
            ..one
        }
    }
}

/// A member of a structure.
#[derive(Clone, Debug)]
pub struct Field {
    /// Its name.
    pub name: Name,
    /// Its type.
    pub ty: Type,
}

impl From<Base> for Type {
    fn from(base: Base) -> Self {
        Type { base, array: None }
    }
}

impl Type {
    /// `void`
    pub const VOID: Type = Type::of(Base::Void);
    /// `bool`
    pub const BOOL: Type = Type::of(Base::Scalar(Scalar::Bool));
    /// `int`
    pub const INT: Type = Type::of(Base::Scalar(Scalar::Int));
    /// `uint`
    pub const UINT: Type = Type::of(Base::Scalar(Scalar::Uint));
    /// `float`
    pub const FLOAT: Type = Type::of(Base::Scalar(Scalar::Float));

    /// A type that is no array.
    pub const fn of(base: Base) -> Type {
        Type { base, array: None }
    }

    /// A scalar or vector type; one component is a scalar.
    pub const fn vector(scalar: Scalar, size: u8) -> Type {
        Type::of(match size {
            1 => Base::Scalar(scalar),
            _ => Base::Vector(scalar, size),
        })
    }

    /// A matrix type.
    pub const fn matrix(columns: u8, rows: u8) -> Type {
        Type::of(Base::Matrix { columns, rows })
    }

    /// An array of this type's base.
    pub fn array_of(self, length: u32) -> Type {
        Type {
            base: self.base,
            array: NonZeroU32::new(length),
        }
    }

    /// The type of an array's elements, the type itself otherwise.
    pub const fn element(self) -> Type {
        Type::of(self.base)
    }

    /// Whether it is an array.
    pub const fn is_array(self) -> bool {
        self.array.is_some()
    }

    /// Kind of component of a scalar, vector or matrix that is no array.
    pub const fn scalar(self) -> Option<Scalar> {
        match (self.array, self.base) {
            (None, Base::Scalar(scalar) | Base::Vector(scalar, _)) => Some(scalar),
            (None, Base::Matrix { .. }) => Some(Scalar::Float),
            _ => None,
        }
    }

    /// Number of components of a vector (1 for a scalar); `None` for all else.
    pub const fn vector_size(self) -> Option<u8> {
        match (self.array, self.base) {
            (None, Base::Scalar(_)) => Some(1),
            (None, Base::Vector(_, size)) => Some(size),
            _ => None,
        }
    }

    /// Whether it is a single number or truth value.
    pub const fn is_scalar(self) -> bool {
        matches!((self.array, self.base), (None, Base::Scalar(_)))
    }

    /// Whether it is a vector of two or more components.
    pub const fn is_vector(self) -> bool {
        matches!((self.array, self.base), (None, Base::Vector(..)))
    }

    /// Whether it is a matrix.
    pub const fn is_matrix(self) -> bool {
        matches!((self.array, self.base), (None, Base::Matrix { .. }))
    }

    /// The sampler type, if it is one and no array.
    pub const fn sampler(self) -> Option<Sampler> {
        match (self.array, self.base) {
            (None, Base::Sampler(sampler)) => Some(sampler),
            _ => None,
        }
    }
}

impl Struct {
    /// A structure of these members.
    pub fn new(name: Option<Name>, fields: Vec<Field>, structs: &Arena<Struct>) -> Self {
        let members = fields.iter().map(|field| Content::of(field.ty, structs));
        let content = members.fold(Content::default(), |all, one| Content {
            values: all.values.saturating_add(one.values),
            members: all.members.saturating_add(one.members),
            depth: all.depth.max(one.depth),
            has_sampler: all.has_sampler || one.has_sampler,
            has_array: all.has_array || one.has_array,
        });
        Struct {
            name,
            fields,
            content: Content {
                depth: content.depth + 1,
                ..content
            },
        }
    }

    /// The member of this name.
    pub fn field(&self, name: Name) -> Option<(u32, &Field)> {
        let index = self.fields.iter().position(|field| field.name == name)?;
        Some((index as u32, &self.fields[index]))
    }
}

impl Base {
    /// The type that a keyword names; structures have no keyword.
    pub fn from_keyword(word: &str) -> Option<Base> {
        Some(match word.as_bytes() {
            b"void" => Base::Void,
            b"float" => Base::Scalar(Scalar::Float),
            b"int" => Base::Scalar(Scalar::Int),
            b"uint" => Base::Scalar(Scalar::Uint),
            b"bool" => Base::Scalar(Scalar::Bool),
            [b'v', b'e', b'c', size @ b'2'..=b'4'] => Base::Vector(Scalar::Float, size - b'0'),
            [kind, b'v', b'e', b'c', size @ b'2'..=b'4'] => {
                let scalar = match kind {
                    b'i' => Scalar::Int,
                    b'u' => Scalar::Uint,
                    b'b' => Scalar::Bool,
                    _ => return None,
                };
                Base::Vector(scalar, size - b'0')
            }
            [b'm', b'a', b't', size @ b'2'..=b'4'] => Base::Matrix {
                columns: size - b'0',
                rows: size - b'0',
            },
            [
                b'm',
                b'a',
                b't',
                columns @ b'2'..=b'4',
                b'x',
                rows @ b'2'..=b'4',
            ] => Base::Matrix {
                columns: columns - b'0',
                rows: rows - b'0',
            },
            [b'i', rest @ ..] => Base::Sampler(Sampler::of_keyword(Scalar::Int, rest)?),
            [b'u', rest @ ..] => Base::Sampler(Sampler::of_keyword(Scalar::Uint, rest)?),
            all => Base::Sampler(Sampler::of_keyword(Scalar::Float, all)?),
        })
    }

    /// The keyword that names the type; `None` for a structure.
    pub const fn keyword(self) -> Option<&'static str> {
        const VECTORS: [[&str; 3]; 4] = [
            ["vec2", "vec3", "vec4"],
            ["ivec2", "ivec3", "ivec4"],
            ["uvec2", "uvec3", "uvec4"],
            ["bvec2", "bvec3", "bvec4"],
        ];
        const MATRICES: [[&str; 3]; 3] = [
            ["mat2", "mat2x3", "mat2x4"],
            ["mat3x2", "mat3", "mat3x4"],
            ["mat4x2", "mat4x3", "mat4"],
        ];
        Some(match self {
            Base::Void => "void",
            Base::Scalar(Scalar::Float) => "float",
            Base::Scalar(Scalar::Int) => "int",
            Base::Scalar(Scalar::Uint) => "uint",
            Base::Scalar(Scalar::Bool) => "bool",
            Base::Vector(scalar, size) => VECTORS[scalar as usize][size as usize - 2],
            Base::Matrix { columns, rows } => MATRICES[columns as usize - 2][rows as usize - 2],
            Base::Sampler(sampler) => sampler.keyword(),
            Base::Struct(_) => return None,
        })
    }
}

impl Sampler {
    /// The sampler with these texels that a keyword without its `i` or `u` names. Only textures of
    /// floats compare, §4.1.7.
    fn of_keyword(texel: Scalar, word: &[u8]) -> Option<Sampler> {
        let (shape, shadow) = match word {
            b"sampler2D" => (Shape::Plane, false),
            b"sampler3D" => (Shape::Volume, false),
            b"samplerCube" => (Shape::Cube, false),
            b"sampler2DArray" => (Shape::Layers, false),
            b"sampler2DShadow" => (Shape::Plane, true),
            b"samplerCubeShadow" => (Shape::Cube, true),
            b"sampler2DArrayShadow" => (Shape::Layers, true),
            _ => return None,
        };
        (!shadow || texel == Scalar::Float).then_some(Sampler {
            texel,
            shape,
            shadow,
        })
    }

    /// The keyword that names the type.
    pub const fn keyword(self) -> &'static str {
        match (self.shape, self.shadow, self.texel) {
            (Shape::Plane, true, _) => "sampler2DShadow",
            (Shape::Cube, true, _) => "samplerCubeShadow",
            (Shape::Layers, true, _) => "sampler2DArrayShadow",
            (Shape::Plane, _, Scalar::Int) => "isampler2D",
            (Shape::Plane, _, Scalar::Uint) => "usampler2D",
            (Shape::Plane, ..) => "sampler2D",
            (Shape::Volume, _, Scalar::Int) => "isampler3D",
            (Shape::Volume, _, Scalar::Uint) => "usampler3D",
            (Shape::Volume, ..) => "sampler3D",
            (Shape::Cube, _, Scalar::Int) => "isamplerCube",
            (Shape::Cube, _, Scalar::Uint) => "usamplerCube",
            (Shape::Cube, ..) => "samplerCube",
            (Shape::Layers, _, Scalar::Int) => "isampler2DArray",
            (Shape::Layers, _, Scalar::Uint) => "usampler2DArray",
            (Shape::Layers, ..) => "sampler2DArray",
        }
    }
}

/// A type as authors write it: `vec3`, `float[3]`, `mat2x3`, a structure by its name.
pub fn spell(ty: Type, structs: &Arena<Struct>, names: &Names) -> String {
    let base = match ty.base {
        Base::Struct(id) => structs[id].name.map_or("struct", |name| names.text(name)),
        other => other.keyword().unwrap_or_default(),
    };
    match ty.array {
        Some(length) => format!("{base}[{length}]"),
        None => base.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_name_every_type_and_back() {
        let words = "void float int uint bool vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 \
            bvec2 bvec3 bvec4 mat2 mat3 mat4 mat2x3 mat2x4 mat3x2 mat3x4 mat4x2 mat4x3 sampler2D \
            sampler3D samplerCube sampler2DArray isampler2D isampler3D isamplerCube \
            isampler2DArray usampler2D usampler3D usamplerCube usampler2DArray sampler2DShadow \
            samplerCubeShadow sampler2DArrayShadow";
        for word in words.split_whitespace() {
            let base = Base::from_keyword(word).unwrap_or_else(|| panic!("{word}"));
            assert_eq!(base.keyword(), Some(word));
        }
        assert_eq!(Base::from_keyword("mat3x3"), Base::from_keyword("mat3"));
        for word in [
            "",
            "vec",
            "vec1",
            "vec5",
            "dvec2",
            "mat",
            "mat5",
            "mat2x",
            "mat2x5",
            "isampler2DShadow",
            "sampler3DShadow",
            "sampler1D",
            "i",
            "u",
            "double",
            "half",
        ] {
            assert_eq!(Base::from_keyword(word), None, "{word}");
        }
    }

    #[test]
    fn types_are_spelled_as_written() {
        let mut names = Names::default();
        let mut structs = Arena::default();
        let ray = Struct::new(Some(names.intern("Ray")), Vec::new(), &structs);
        let named = structs.add(ray);
        let anonymous = structs.add(Struct::new(None, Vec::new(), &Arena::default()));
        for (ty, expected) in [
            (Type::FLOAT, "float"),
            (Type::FLOAT.array_of(3), "float[3]"),
            (Type::matrix(2, 3), "mat2x3"),
            (Type::vector(Scalar::Int, 2), "ivec2"),
            (Base::Struct(named).into(), "Ray"),
            (Type::of(Base::Struct(named)).array_of(2), "Ray[2]"),
            (Base::Struct(anonymous).into(), "struct"),
        ] {
            assert_eq!(spell(ty, &structs, &names), expected);
        }
    }
}
