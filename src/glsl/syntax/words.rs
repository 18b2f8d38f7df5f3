//! The words of the language and what each is: a keyword, a type, or reserved for later.

use std::fmt;
use std::sync::LazyLock;

use hashbrown::HashTable;

use super::lexeme::{Lexeme, Symbol};
use crate::glsl::names;
use crate::glsl::types::{Base, Sampler, Scalar, Shape};

/// Defines an enum whose elements are spelled in one way each.
macro_rules! spelled {
    ($(#[$about:meta])* $enum:ident { $($element:ident = $text:literal,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum $enum {
            $($element,)*
        }

        impl $enum {
            /// Every element.
            pub const ALL: &[$enum] = &[$($enum::$element,)*];

            /// As it is written.
            pub const fn text(self) -> &'static str {
                match self {
                    $($enum::$element => $text,)*
                }
            }
        }
    };
}
pub(super) use spelled;

spelled! {
    /// A keyword that is neither a type nor a value.
    Word {
        Break = "break",
        Case = "case",
        Centroid = "centroid",
        Const = "const",
        Continue = "continue",
        Default = "default",
        Discard = "discard",
        Do = "do",
        Else = "else",
        Flat = "flat",
        For = "for",
        High = "highp",
        If = "if",
        In = "in",
        InOut = "inout",
        Invariant = "invariant",
        Layout = "layout",
        Low = "lowp",
        Medium = "mediump",
        Out = "out",
        Precision = "precision",
        Return = "return",
        Smooth = "smooth",
        Struct = "struct",
        Switch = "switch",
        Uniform = "uniform",
        While = "while",
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

impl Word {
    /// Whether a statement of its own begins with it, so that it can be no part of an expression.
    pub fn begins_statement(self) -> bool {
        use Word::*;
        matches!(
            self,
            Break | Case | Continue | Default | Discard | Do | For | If | Return | Switch | While
        )
    }

    /// Whether it stands only in declarations.
    pub fn begins_declaration(self) -> bool {
        !self.begins_statement() && self != Word::Else
    }
}

/// What a spelling is known for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Known {
    /// A part of the language.
    Lexeme(Lexeme),
    /// A word that WebGL2 keeps back.
    Reserved,
}

/// Spellings that are not just names, by their [`names::hash`].
#[derive(Debug)]
pub(super) struct Vocabulary {
    table: HashTable<(&'static str, Known)>,
    /// For each first byte, a bit for each length. Most names of a program are like no word in both.
    lengths: [u32; 256],
}

impl Vocabulary {
    /// What a spelling with this hash is known for.
    pub fn get(&self, hashed: u64, text: &str) -> Option<Known> {
        let first = *text.as_bytes().first()?;
        if self.lengths[usize::from(first)] & length_bit(text) == 0 {
            return None;
        }
        let found = self.table.find(hashed, |(known, _)| *known == text);
        found.map(|(_, known)| *known)
    }
}

/// A bit for a length; all that are too long for a bit of their own share one.
fn length_bit(text: &str) -> u32 {
    1 << text.len().min(31)
}

/// Every spelling that is not just a name.
pub(super) static KNOWN: LazyLock<Vocabulary> = LazyLock::new(|| {
    let symbols = Symbol::ALL
        .iter()
        .map(|&it| (it.text(), Lexeme::Symbol(it)));
    let words = Word::ALL.iter().map(|&it| (it.text(), Lexeme::Word(it)));
    let types = TYPES.iter().map(|&(text, base)| (text, Lexeme::Type(base)));
    let truths = [("true", Lexeme::Bool(true)), ("false", Lexeme::Bool(false))];
    let reserved = RESERVED.iter().map(|&text| (text, Known::Reserved));
    let lexemes = symbols.chain(words).chain(types).chain(truths);
    let lexemes = lexemes.map(|(text, lexeme)| (text, Known::Lexeme(lexeme)));
    let mut table = HashTable::new();
    let mut lengths = [0; 256];
    for known in lexemes.chain(reserved) {
        lengths[usize::from(known.0.as_bytes()[0])] |= length_bit(known.0);
        table.insert_unique(names::hash(known.0), known, |known| names::hash(known.0));
    }
    Vocabulary { table, lengths }
});

const fn scalar(scalar: Scalar) -> Base {
    Base::Scalar(scalar)
}

const fn vector(scalar: Scalar, size: u8) -> Base {
    Base::Vector(scalar, size)
}

const fn matrix(columns: u8, rows: u8) -> Base {
    Base::Matrix { columns, rows }
}

const fn sampler(texel: Scalar, shape: Shape) -> Base {
    Base::Sampler(Sampler {
        texel,
        shape,
        shadow: false,
    })
}

const fn shadow(shape: Shape) -> Base {
    Base::Sampler(Sampler {
        texel: Scalar::Float,
        shape,
        shadow: true,
    })
}

const TYPES: &[(&str, Base)] = &[
    ("void", Base::Void),
    ("float", scalar(Scalar::Float)),
    ("int", scalar(Scalar::Int)),
    ("uint", scalar(Scalar::Uint)),
    ("bool", scalar(Scalar::Bool)),
    ("vec2", vector(Scalar::Float, 2)),
    ("vec3", vector(Scalar::Float, 3)),
    ("vec4", vector(Scalar::Float, 4)),
    ("ivec2", vector(Scalar::Int, 2)),
    ("ivec3", vector(Scalar::Int, 3)),
    ("ivec4", vector(Scalar::Int, 4)),
    ("uvec2", vector(Scalar::Uint, 2)),
    ("uvec3", vector(Scalar::Uint, 3)),
    ("uvec4", vector(Scalar::Uint, 4)),
    ("bvec2", vector(Scalar::Bool, 2)),
    ("bvec3", vector(Scalar::Bool, 3)),
    ("bvec4", vector(Scalar::Bool, 4)),
    ("mat2", matrix(2, 2)),
    ("mat3", matrix(3, 3)),
    ("mat4", matrix(4, 4)),
    ("mat2x2", matrix(2, 2)),
    ("mat2x3", matrix(2, 3)),
    ("mat2x4", matrix(2, 4)),
    ("mat3x2", matrix(3, 2)),
    ("mat3x3", matrix(3, 3)),
    ("mat3x4", matrix(3, 4)),
    ("mat4x2", matrix(4, 2)),
    ("mat4x3", matrix(4, 3)),
    ("mat4x4", matrix(4, 4)),
    ("sampler2D", sampler(Scalar::Float, Shape::Plane)),
    ("sampler3D", sampler(Scalar::Float, Shape::Volume)),
    ("samplerCube", sampler(Scalar::Float, Shape::Cube)),
    ("sampler2DArray", sampler(Scalar::Float, Shape::Layers)),
    ("isampler2D", sampler(Scalar::Int, Shape::Plane)),
    ("isampler3D", sampler(Scalar::Int, Shape::Volume)),
    ("isamplerCube", sampler(Scalar::Int, Shape::Cube)),
    ("isampler2DArray", sampler(Scalar::Int, Shape::Layers)),
    ("usampler2D", sampler(Scalar::Uint, Shape::Plane)),
    ("usampler3D", sampler(Scalar::Uint, Shape::Volume)),
    ("usamplerCube", sampler(Scalar::Uint, Shape::Cube)),
    ("usampler2DArray", sampler(Scalar::Uint, Shape::Layers)),
    ("sampler2DShadow", shadow(Shape::Plane)),
    ("samplerCubeShadow", shadow(Shape::Cube)),
    ("sampler2DArrayShadow", shadow(Shape::Layers)),
];

/// What a browser takes neither for a name nor for anything else.
#[rustfmt::skip]
const RESERVED: &[&str] = &[
    "active", "asm", "atomic_uint", "attribute", "cast", "class", "coherent", "common", "double",
    "dvec2", "dvec3", "dvec4", "enum", "extern", "external", "filter", "fixed", "fvec2", "fvec3",
    "fvec4", "goto", "half", "hvec2", "hvec3", "hvec4", "iimage1D", "iimage1DArray", "iimage2D",
    "iimage2DArray", "iimage3D", "iimageBuffer", "iimageCube", "image1D", "image1DArray",
    "image1DArrayShadow", "image1DShadow", "image2D", "image2DArray", "image2DArrayShadow",
    "image2DShadow", "image3D", "imageBuffer", "imageCube", "inline", "input", "interface",
    "isampler1D", "isampler1DArray", "isampler2DMS", "isampler2DMSArray", "isampler2DRect",
    "isamplerBuffer", "long", "namespace", "noinline", "noperspective", "output", "partition",
    "patch", "public", "readonly", "resource", "restrict", "sample", "sampler1D", "sampler1DArray",
    "sampler1DArrayShadow", "sampler1DShadow", "sampler2DMS", "sampler2DMSArray", "sampler2DRect",
    "sampler2DRectShadow", "sampler3DRect", "samplerBuffer", "samplerExternalOES", "short",
    "sizeof", "static", "subroutine", "superp", "template", "this", "typedef", "uimage1D",
    "uimage1DArray", "uimage2D", "uimage2DArray", "uimage3D", "uimageBuffer", "uimageCube",
    "union", "unsigned", "usampler1D", "usampler1DArray", "usampler2DMS", "usampler2DMSArray",
    "usampler2DRect", "usamplerBuffer", "using", "varying", "volatile", "writeonly",
];

/// What to write instead of a reserved word.
pub(super) fn instead_of(reserved: &str) -> &'static str {
    match reserved {
        "static" | "inline" | "noinline" | "extern" | "external" | "public" | "volatile"
        | "restrict" | "coherent" | "superp" => "leave it out, or choose another name",
        "double" | "half" | "fixed" => "use `float`, or choose another name",
        "long" | "short" => "use `int`, or choose another name",
        "unsigned" => "use `uint`, or choose another name",
        "dvec2" | "hvec2" | "fvec2" => "use `vec2`, or choose another name",
        "dvec3" | "hvec3" | "fvec3" => "use `vec3`, or choose another name",
        "dvec4" | "hvec4" | "fvec4" => "use `vec4`, or choose another name",
        "attribute" | "varying" => "use `in` or `out`, or choose another name",
        "class" | "union" | "interface" => "use `struct`, or choose another name",
        "enum" => "use `const int`, or choose another name",
        "typedef" | "using" => "use `#define`, or choose another name",
        "goto" => "use a loop with `break`, or choose another name",
        _ => "choose another name",
    }
}
