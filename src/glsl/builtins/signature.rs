//! Signatures that stand for many: `genType` is a `float` or a vector of floats, `gsampler2D` one of
//! three samplers. The specification writes its tables in these terms.

use crate::glsl::types::{Base, Sampler, Scalar, Shape, Type};

/// What a parameter takes, or what a function returns.
#[derive(Clone, Copy, Debug)]
pub(super) enum Slot {
    /// This very type.
    Exact(Type),
    /// `genType` and its like: a scalar or a vector. All in a signature have the same size.
    Any(Scalar),
    /// `vec` and its like: a vector. All in a signature have the same size.
    Vector(Scalar),
    /// `mat`: a matrix. All in a signature are the same.
    Matrix,
    /// A matrix with as many columns as rows.
    Square,
    /// The matrix with columns and rows exchanged.
    Transposed,
    /// A `vec` with as many components as the product has rows.
    Rows,
    /// A `vec` with as many components as the product has columns.
    Columns,
    /// A sampler of this shape that does not compare.
    Sampler(Shape),
    /// A sampler of this shape that compares.
    Shadow(Shape),
    /// `gvec4`: a vector of the sampler's texels.
    Texel,
}

/// One line of the specification's tables.
#[derive(Debug)]
pub(super) struct Signature {
    /// What the function returns.
    pub(super) result: Slot,
    /// What it takes.
    pub(super) parameters: &'static [Slot],
}

/// What the arguments seen so far say about the generic types; zero is unknown.
struct Bound {
    size: u8,
    columns: u8,
    rows: u8,
    texel: Scalar,
}

impl Bound {
    /// Whether an argument fits a parameter.
    fn accept(&mut self, slot: Slot, argument: Type) -> bool {
        if argument.is_array() {
            return false;
        }
        match (slot, argument.base) {
            (Slot::Exact(ty), _) => argument == ty,
            (Slot::Any(scalar), Base::Scalar(given)) => given == scalar && same(&mut self.size, 1),
            (Slot::Any(scalar) | Slot::Vector(scalar), Base::Vector(given, size)) => {
                given == scalar && same(&mut self.size, size)
            }
            (Slot::Matrix, Base::Matrix { columns, rows }) => {
                same(&mut self.columns, columns) && same(&mut self.rows, rows)
            }
            (Slot::Square, Base::Matrix { columns, rows }) => {
                columns == rows && same(&mut self.columns, columns) && same(&mut self.rows, rows)
            }
            (Slot::Rows, Base::Vector(Scalar::Float, size)) => same(&mut self.rows, size),
            (Slot::Columns, Base::Vector(Scalar::Float, size)) => same(&mut self.columns, size),
            (Slot::Sampler(shape), Base::Sampler(sampler)) => {
                self.texel = sampler.texel;
                sampler.shape == shape && !sampler.shadow
            }
            (Slot::Shadow(shape), Base::Sampler(sampler)) => {
                sampler.shape == shape && sampler.shadow
            }
            _ => false,
        }
    }

    /// The type that the function returns.
    fn result(&self, slot: Slot) -> Type {
        match slot {
            Slot::Exact(ty) => ty,
            Slot::Any(scalar) | Slot::Vector(scalar) => Type::vector(scalar, self.size),
            Slot::Transposed => Type::matrix(self.rows, self.columns),
            Slot::Texel => Type::vector(self.texel, 4),
            Slot::Matrix
            | Slot::Square
            | Slot::Rows
            | Slot::Columns
            | Slot::Sampler(_)
            | Slot::Shadow(_) => Type::matrix(self.columns, self.rows),
        }
    }
}

/// Whether a size is still unknown, or known to be this.
fn same(known: &mut u8, size: u8) -> bool {
    let fits = *known == 0 || *known == size;
    *known = size;
    fits
}

impl Signature {
    /// What a call with these arguments returns, if they fit.
    pub(super) fn result(&self, arguments: &[Type]) -> Option<Type> {
        if arguments.len() != self.parameters.len() {
            return None;
        }
        let mut bound = Bound {
            size: 0,
            columns: 0,
            rows: 0,
            texel: Scalar::Float,
        };
        let mut pairs = self.parameters.iter().zip(arguments);
        pairs
            .all(|(&slot, &argument)| bound.accept(slot, argument))
            .then(|| bound.result(self.result))
    }

    /// The signature with a name in it; one parameter may be an `out`.
    pub(super) fn spell(&self, name: &str, out: Option<usize>) -> String {
        let mut text = format!("{} {name}(", self.result.spell());
        for (index, slot) in self.parameters.iter().enumerate() {
            if index > 0 {
                text.push_str(", ");
            }
            if out == Some(index) {
                text.push_str("out ");
            }
            text.push_str(slot.spell());
        }
        text.push(')');
        text
    }
}

impl Slot {
    /// As the specification has it.
    fn spell(self) -> &'static str {
        match self {
            Slot::Exact(ty) => ty.base.keyword().unwrap_or_default(),
            Slot::Any(Scalar::Float) => "genType",
            Slot::Any(Scalar::Int) => "genIType",
            Slot::Any(Scalar::Uint) => "genUType",
            Slot::Any(Scalar::Bool) => "genBType",
            Slot::Vector(Scalar::Float) | Slot::Rows | Slot::Columns => "vec",
            Slot::Vector(Scalar::Int) => "ivec",
            Slot::Vector(Scalar::Uint) => "uvec",
            Slot::Vector(Scalar::Bool) => "bvec",
            Slot::Matrix | Slot::Square | Slot::Transposed => "mat",
            Slot::Sampler(Shape::Plane) => "gsampler2D",
            Slot::Sampler(Shape::Volume) => "gsampler3D",
            Slot::Sampler(Shape::Cube) => "gsamplerCube",
            Slot::Sampler(Shape::Layers) => "gsampler2DArray",
            Slot::Shadow(shape) => Sampler {
                texel: Scalar::Float,
                shape,
                shadow: true,
            }
            .keyword(),
            Slot::Texel => "gvec4",
        }
    }
}
