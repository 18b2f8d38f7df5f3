//! The vocabulary of the language: its operators and brackets, its words, and what each of them is.

use std::fmt;

use super::types::{Base, Sampler, Scalar, Shape};

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
spelled! {
    /// An operator or a bracket.
    Symbol {
        LeftParenthesis = "(",
        RightParenthesis = ")",
        LeftBracket = "[",
        RightBracket = "]",
        LeftBrace = "{",
        RightBrace = "}",
        Dot = ".",
        Comma = ",",
        Colon = ":",
        Semicolon = ";",
        Question = "?",
        Assign = "=",
        Not = "!",
        Complement = "~",
        Plus = "+",
        Minus = "-",
        Star = "*",
        Slash = "/",
        Percent = "%",
        Less = "<",
        Greater = ">",
        Or = "|",
        Xor = "^",
        And = "&",
        Increment = "++",
        Decrement = "--",
        LessEqual = "<=",
        GreaterEqual = ">=",
        Equal = "==",
        NotEqual = "!=",
        AndAnd = "&&",
        OrOr = "||",
        XorXor = "^^",
        ShiftLeft = "<<",
        ShiftRight = ">>",
        PlusAssign = "+=",
        MinusAssign = "-=",
        StarAssign = "*=",
        SlashAssign = "/=",
        PercentAssign = "%=",
        AndAssign = "&=",
        OrAssign = "|=",
        XorAssign = "^=",
        ShiftLeftAssign = "<<=",
        ShiftRightAssign = ">>=",
    }
}

impl Symbol {
    /// Whether it may follow a variable's name at the beginning of a statement.
    pub fn follows_place(self) -> bool {
        use Symbol::*;
        matches!(
            self,
            LeftParenthesis
                | Dot
                | Increment
                | Decrement
                | Assign
                | PlusAssign
                | MinusAssign
                | StarAssign
                | SlashAssign
                | PercentAssign
                | AndAssign
                | OrAssign
                | XorAssign
                | ShiftLeftAssign
                | ShiftRightAssign
        )
    }
}

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

/// What is in the vocabulary.
#[derive(Clone, Copy, Debug)]
pub(super) enum Item {
    /// An operator or a bracket.
    Symbol(Symbol),
    /// A keyword.
    Word(Word),
    /// The keyword of a type.
    Type(Base),
    /// `true` or `false`.
    Bool(bool),
    /// A word that WebGL2 keeps back.
    Reserved,
}

/// How large the vocabulary is.
pub(super) const COUNT: usize =
    Symbol::ALL.len() + Word::ALL.len() + TYPES.len() + TRUTHS.len() + RESERVED.len();

/// The vocabulary, each with its spelling. The symbols come first, in their order.
pub(super) fn vocabulary() -> impl Iterator<Item = (&'static str, Item)> {
    let symbols = Symbol::ALL.iter().map(|&it| (it.text(), Item::Symbol(it)));
    let words = Word::ALL.iter().map(|&it| (it.text(), Item::Word(it)));
    let types = TYPES.iter().map(|&(text, base)| (text, Item::Type(base)));
    let truths = TRUTHS
        .iter()
        .map(|&(text, value)| (text, Item::Bool(value)));
    let reserved = RESERVED.iter().map(|&text| (text, Item::Reserved));
    symbols
        .chain(words)
        .chain(types)
        .chain(truths)
        .chain(reserved)
}

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

const TRUTHS: &[(&str, bool)] = &[("true", true), ("false", false)];

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
