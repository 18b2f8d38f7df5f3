//! Types and how they are spelled.

use arbitrary::Result;

use super::Writer;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    Float,
    Int,
    Uint,
    Bool,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Type {
    Vector(Scalar, u8),
    Matrix(u8, u8),
    Struct(usize),
    Array(Box<Type>, u32),
}

#[derive(Clone, Debug)]
pub struct Structure {
    pub name: String,
    pub fields: Vec<(String, Type)>,
}

pub const FLOAT: Type = Type::Vector(Scalar::Float, 1);
pub const INT: Type = Type::Vector(Scalar::Int, 1);
pub const BOOL: Type = Type::Vector(Scalar::Bool, 1);

impl Type {
    pub fn spell(&self, structures: &[Structure]) -> String {
        match self {
            Type::Vector(scalar, 1) => match scalar {
                Scalar::Float => "float",
                Scalar::Int => "int",
                Scalar::Uint => "uint",
                Scalar::Bool => "bool",
            }
            .to_owned(),
            Type::Vector(scalar, size) => {
                let prefix = match scalar {
                    Scalar::Float => "",
                    Scalar::Int => "i",
                    Scalar::Uint => "u",
                    Scalar::Bool => "b",
                };
                format!("{prefix}vec{size}")
            }
            Type::Matrix(columns, rows) if columns == rows => format!("mat{columns}"),
            Type::Matrix(columns, rows) => format!("mat{columns}x{rows}"),
            Type::Struct(id) => structures[*id].name.clone(),
            Type::Array(element, length) => format!("{}[{length}]", element.spell(structures)),
        }
    }

    pub fn is_array(&self) -> bool {
        matches!(self, Type::Array(..))
    }
}

impl Writer<'_, '_> {
    pub fn scalar(&mut self) -> Result<Scalar> {
        use Scalar as S;
        self.pick(&[S::Float, S::Float, S::Int, S::Uint, S::Bool])
    }

    pub fn any_type(&mut self) -> Result<Type> {
        Ok(match self.below(12)? {
            0..=2 => FLOAT,
            3..=7 => Type::Vector(self.scalar()?, 1 + self.below(4)? as u8),
            8 | 9 => Type::Matrix(2 + self.below(3)? as u8, 2 + self.below(3)? as u8),
            10 if !self.structures.is_empty() => Type::Struct(self.below(self.structures.len())?),
            _ => {
                let element = match self.below(4)? {
                    0 if !self.structures.is_empty() => {
                        Type::Struct(self.below(self.structures.len())?)
                    }
                    1 => Type::Matrix(2 + self.below(3)? as u8, 2 + self.below(3)? as u8),
                    _ => Type::Vector(self.scalar()?, 1 + self.below(4)? as u8),
                };
                let length = match self.once_in(16)? {
                    true => 70,
                    false => 1 + self.below(5)? as u32,
                };
                Type::Array(Box::new(element), length)
            }
        })
    }

    pub fn spell(&self, ty: &Type) -> String {
        ty.spell(&self.structures)
    }
}
