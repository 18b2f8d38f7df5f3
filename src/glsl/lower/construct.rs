//! Constructors, §5.4.

use smallvec::{SmallVec, smallvec};

use super::expression::Typed;
use super::function::{Builder, H};
use super::matrix::sides;
use super::sanitize::Here;
use crate::glsl::hir::Operands;
use crate::glsl::types::{Base, Scalar, Type};

impl Builder<'_, '_> {
    /// A value of the given type, made of the operands.
    pub(super) fn construct(&mut self, operands: Operands, ty: Type, tree: Option<Here>) -> H {
        let operands = self.source.operands.get(operands);
        // Components hand on what is not finite.
        let tree = tree.filter(|_| ty.scalar() == Some(Scalar::Float));
        let values: SmallVec<[Typed; 4]> = operands
            .iter()
            .map(|&id| {
                self.tree = tree;
                self.typed(id)
            })
            .collect();
        match (ty.array, ty.base) {
            (Some(_), _) | (None, Base::Struct(_)) => {
                let components = values.iter().map(|operand| operand.value).collect();
                self.compose(ty, components)
            }
            (None, Base::Scalar(scalar)) => {
                let first = self.first_component(values[0]);
                self.convert_typed(first, scalar)
            }
            (None, Base::Vector(scalar, size)) => self.construct_vector(&values, scalar, size),
            (None, Base::Matrix { .. }) => self.construct_matrix(&values, ty),
            _ => unreachable!("such values are not constructed"),
        }
    }

    fn first_component(&mut self, operand: Typed) -> Typed {
        let scalar = operand.ty.scalar().expect("operands are numbers");
        let mut value = operand.value;
        if operand.ty.is_matrix() {
            value = self.part(value, 0);
        }
        if !operand.ty.is_scalar() {
            value = self.part(value, 0);
        }
        Typed {
            value,
            ty: Type::vector(scalar, 1),
        }
    }

    fn convert_typed(&mut self, operand: Typed, to: Scalar) -> H {
        let from = operand.ty.scalar().expect("operands are numbers");
        self.check_conversion(operand, to);
        self.convert(operand.value, from, to)
    }

    fn construct_vector(&mut self, operands: &[Typed], scalar: Scalar, size: u8) -> H {
        if let [operand] = operands
            && operand.ty.is_scalar()
        {
            let value = self.convert_typed(*operand, scalar);
            return self.splat(value, size);
        }
        let mut components = Vec::with_capacity(operands.len());
        let mut missing = size;
        for operand in operands {
            for part in self.vectors(*operand) {
                if missing == 0 {
                    break;
                }
                let own = part.ty.vector_size().expect("these are vectors");
                let mut value = self.convert_typed(part, scalar);
                if own > missing {
                    value = self.swizzle(value, &[0, 1, 2, 3][..usize::from(missing)]);
                }
                missing -= own.min(missing);
                components.push(value);
            }
        }
        match *components {
            [only] => only,
            _ => self.compose(Type::vector(scalar, size), components),
        }
    }

    /// An operand as scalars and vectors.
    fn vectors(&mut self, operand: Typed) -> SmallVec<[Typed; 4]> {
        if !operand.ty.is_matrix() {
            return smallvec![operand];
        }
        let (columns, rows) = sides(operand.ty);
        let columns = self.components(operand.value, columns);
        let ty = Type::vector(Scalar::Float, rows);
        let columns = columns.into_iter();
        columns.map(|value| Typed { value, ty }).collect()
    }

    fn construct_matrix(&mut self, operands: &[Typed], ty: Type) -> H {
        let (columns, rows) = sides(ty);
        let column = Type::vector(Scalar::Float, rows);
        if let [operand] = operands {
            if operand.ty == ty {
                return operand.value;
            }
            if operand.ty.is_scalar() {
                let value = self.convert_typed(*operand, Scalar::Float);
                let zero = self.float(0.0);
                let columns = (0..columns)
                    .map(|c| {
                        let components = (0..rows).map(|r| if r == c { value } else { zero });
                        self.compose(column, components.collect())
                    })
                    .collect();
                return self.compose(ty, columns);
            }
            if operand.ty.is_matrix() {
                let columns = (0..columns)
                    .map(|c| self.resized_column(*operand, c, rows))
                    .collect();
                return self.compose(ty, columns);
            }
        }
        let whole = operands.iter().all(|operand| operand.ty == column);
        let mut parts = Vec::new();
        if whole {
            parts.extend(operands.iter().map(|operand| operand.value));
        } else {
            let mut components = Vec::new();
            for operand in operands {
                for part in self.vectors(*operand) {
                    let size = part.ty.vector_size().expect("these are vectors");
                    let value = self.convert_typed(part, Scalar::Float);
                    components.extend(self.components(value, size));
                }
            }
            for components in components.chunks_exact(rows.into()) {
                parts.push(self.compose(column, components.to_vec()));
            }
        }
        parts.truncate(columns.into());
        self.compose(ty, parts)
    }

    /// A column of a matrix, cut off or extended by that of an identity matrix.
    fn resized_column(&mut self, matrix: Typed, column: u8, rows: u8) -> H {
        let (own_columns, own_rows) = sides(matrix.ty);
        let ty = Type::vector(Scalar::Float, rows);
        let mut components = Vec::new();
        let mut known = 0;
        if column < own_columns {
            let value = self.part(matrix.value, column.into());
            if own_rows == rows {
                return value;
            }
            known = own_rows.min(rows);
            if own_rows > rows {
                return self.swizzle(value, &[0, 1, 2, 3][..usize::from(rows)]);
            }
            components.push(value);
        }
        for row in known..rows {
            components.push(self.float(f64::from(u8::from(row == column))));
        }
        self.compose(ty, components)
    }
}
