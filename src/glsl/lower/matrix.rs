//! Matrices. naga's know products, sums and differences; the rest goes column by column.

use naga::{BinaryOperator, MathFunction};

use super::expression::Typed;
use super::function::{Builder, H};
use crate::glsl::Arithmetic;
use crate::glsl::arena::Id;
use crate::glsl::hir::{BinaryOp, Expr, ExprKind};
use crate::glsl::types::{Base, Scalar, Type};

impl Builder<'_, '_> {
    /// A vector under a product of matrices: it is transformed by one after the other, as Mesa's compiler of GLSL has it
    /// (`opt_algebraic`). That costs less than multiplying the matrices, and rounds differently.
    pub(super) fn transformed(&mut self, id: Id<Expr>) -> Option<H> {
        let ExprKind::Binary(BinaryOp::Multiply, product, vector) = self.source.exprs[id].kind
        else {
            return None;
        };
        let is_expanded = self.context.options.arithmetic == Arithmetic::Expanded;
        if !is_expanded || !self.source.exprs[vector].ty.is_vector() {
            return None;
        }
        let matrices = self.factors(product);
        if matrices.len() < 2 || self.has_effect(id) {
            return None;
        }
        let vector = self.typed(vector);
        let transformed = matrices.into_iter().rev().fold(vector, |vector, matrix| {
            let matrix = self.typed(matrix);
            let (_, rows) = sides(matrix.ty);
            Typed {
                value: self.matrix_product(matrix, vector),
                ty: Type::vector(Scalar::Float, rows),
            }
        });
        Some(transformed.value)
    }

    /// The matrices that a product is of, from left to right.
    fn factors(&self, product: Id<Expr>) -> Vec<Id<Expr>> {
        let (mut open, mut found) = (vec![product], Vec::new());
        while let Some(id) = open.pop() {
            let Expr { kind, ty, .. } = self.source.exprs[id];
            match kind {
                ExprKind::Binary(BinaryOp::Multiply, left, right)
                    if [left, right]
                        .iter()
                        .all(|&side| self.source.exprs[side].ty.is_matrix()) =>
                {
                    open.extend([right, left]);
                }
                _ if ty.is_matrix() => found.push(id),
                _ => {}
            }
        }
        found
    }

    /// Arithmetic in which one operand at least is a matrix.
    pub(super) fn matrix_arithmetic(&mut self, op: BinaryOperator, left: Typed, right: Typed) -> H {
        let both = left.ty.is_matrix() && right.ty.is_matrix();
        if op == BinaryOperator::Multiply && !left.ty.is_scalar() && !right.ty.is_scalar() {
            return self.matrix_product(left, right);
        }
        let direct = match op {
            BinaryOperator::Multiply => true,
            BinaryOperator::Add | BinaryOperator::Subtract => both,
            _ => false,
        };
        if direct {
            return self.binary(op, left.value, right.value);
        }
        let ty = if left.ty.is_matrix() {
            left.ty
        } else {
            right.ty
        };
        let (columns, rows) = sides(ty);
        let [left, right] = [left, right].map(|operand| {
            if operand.ty.is_matrix() {
                self.components(operand.value, columns)
            } else {
                vec![self.splat(operand.value, rows); columns.into()]
            }
        });
        let columns = left.into_iter().zip(right);
        let columns = columns.map(|(left, right)| self.binary(op, left, right));
        let columns = columns.collect();
        self.compose(ty, columns)
    }

    /// A product of linear algebra. Drivers add the terms of SPIR-V's in another order than compilers
    /// of GLSL do.
    fn matrix_product(&mut self, left: Typed, right: Typed) -> H {
        if !self.is_expanded() {
            return self.binary(BinaryOperator::Multiply, left.value, right.value);
        }
        match (left.ty.base, right.ty.base) {
            (_, Base::Vector(_, size)) => {
                let columns = self.components(left.value, size);
                self.combine(&columns, right.value)
            }
            (Base::Vector(scalar, _), _) => {
                let (columns, rows) = sides(right.ty);
                let columns = self.components(right.value, columns);
                let dots = columns
                    .into_iter()
                    .map(|column| self.dot(left.value, column, rows));
                let dots: Vec<H> = dots.collect();
                self.compose(Type::vector(scalar, dots.len() as u8), dots)
            }
            _ => {
                let (inner, rows) = sides(left.ty);
                let (columns, _) = sides(right.ty);
                let own = self.components(left.value, inner);
                let others = self.components(right.value, columns);
                let products = others.into_iter().map(|column| self.combine(&own, column));
                let products = products.collect();
                self.compose(Type::matrix(columns, rows), products)
            }
        }
    }

    /// Vectors, each times its component of `factors`, in a sum.
    fn combine(&mut self, vectors: &[H], factors: H) -> H {
        let mut sum = None;
        for (i, &vector) in vectors.iter().enumerate() {
            let factor = self.part(factors, i as u32);
            let term = self.scale(vector, factor);
            sum = Some(match sum {
                Some(sum) => self.sum(sum, term),
                None => term,
            });
        }
        sum.expect("a matrix has columns")
    }

    /// `matrixCompMult`
    pub(super) fn component_product(&mut self, left: H, right: H, ty: Type) -> H {
        let (columns, _) = sides(ty);
        let columns = (0..u32::from(columns))
            .map(|i| {
                let [left, right] = [left, right].map(|matrix| self.part(matrix, i));
                self.product(left, right)
            })
            .collect();
        self.compose(ty, columns)
    }

    /// `outerProduct`
    pub(super) fn outer_product(&mut self, column: H, row: H, ty: Type) -> H {
        let (columns, _) = sides(ty);
        let columns = (0..u32::from(columns))
            .map(|i| {
                let factor = self.part(row, i);
                self.scale(column, factor)
            })
            .collect();
        self.compose(ty, columns)
    }

    /// `inverse`, by the adjugate. Two of naga's writers have none.
    pub(super) fn inverse(&mut self, matrix: H, ty: Type) -> H {
        let (size, _) = sides(ty);
        let columns = self.components(matrix, size);
        match *columns {
            [a, b] => self.inverse2(a, b),
            [a, b, c] => self.inverse3(a, b, c),
            [a, b, c, d] => self.inverse4([a, b, c, d]),
            _ => unreachable!("matrices have two to four columns"),
        }
    }

    fn inverse2(&mut self, a: H, b: H) -> H {
        let vec2 = Type::vector(Scalar::Float, 2);
        let [ax, ay, bx, by] = [(a, 0), (a, 1), (b, 0), (b, 1)].map(|(v, i)| self.part(v, i));
        let determinant = self.minor([ax, by], [bx, ay]);
        let [minus_ay, minus_bx] = [ay, bx].map(|value| self.negate(value));
        let first = self.compose(vec2, vec![by, minus_ay]);
        let second = self.compose(vec2, vec![minus_bx, ax]);
        self.divided([first, second], determinant)
    }

    /// In the order of Mesa's `inverse`, so that it rounds in the same way.
    fn inverse3(&mut self, a: H, b: H, c: H) -> H {
        let [a, b, c] = [a, b, c].map(|column| [0, 1, 2].map(|row| self.part(column, row)));
        let entries = [
            [
                self.minor([b[1], c[2]], [c[1], b[2]]),
                self.minor([a[1], c[2]], [a[2], c[1]]),
                self.minor([a[1], b[2]], [a[2], b[1]]),
            ],
            [
                self.minor([b[0], c[2]], [c[0], b[2]]),
                self.minor([a[0], c[2]], [a[2], c[0]]),
                self.minor([a[0], b[2]], [a[2], b[0]]),
            ],
            [
                self.minor([b[0], c[1]], [c[0], b[1]]),
                self.minor([a[0], c[1]], [a[1], c[0]]),
                self.minor([a[0], b[1]], [a[1], b[0]]),
            ],
        ];
        let [first, second, third] =
            [0, 1, 2].map(|column| self.product(a[column], entries[column][0]));
        let determinant = self.difference(first, second);
        let determinant = self.sum(determinant, third);
        let columns = [0, 1, 2].map(|column| {
            let signed = [0, 1, 2].map(|row| match (column + row) % 2 {
                0 => entries[column][row],
                _ => self.negate(entries[column][row]),
            });
            self.compose(Type::vector(Scalar::Float, 3), signed.to_vec())
        });
        self.divided(columns, determinant)
    }

    /// The difference of two products.
    fn minor(&mut self, first: [H; 2], second: [H; 2]) -> H {
        let [first, second] = [first, second].map(|[x, y]| self.product(x, y));
        self.difference(first, second)
    }

    /// A square matrix of these columns, divided by a number.
    fn divided<const N: usize>(&mut self, columns: [H; N], divisor: H) -> H {
        let size = N as u8;
        let divisor = self.splat(divisor, size);
        let columns = columns.map(|column| self.quotient(column, divisor));
        self.compose(Type::matrix(size, size), columns.to_vec())
    }

    /// After Lengyel, Foundations of Game Engine Development 1, §1.7.5: the minors of the upper three
    /// rows come from four vectors.
    fn inverse4(&mut self, columns: [H; 4]) -> H {
        let [a, b, c, d] = columns.map(|column| self.swizzle(column, &[0, 1, 2]));
        let [x, y, z, w] = columns.map(|column| self.part(column, 3));
        let [s, t] = [(a, b), (c, d)].map(|(p, q)| self.cross(p, q));
        let [u, v] = [(a, y, b, x), (c, w, d, z)].map(|(p, k, q, l)| {
            let [p, q] = [(p, k), (q, l)].map(|(vector, factor)| self.scale(vector, factor));
            self.difference(p, q)
        });
        let [sv, tu] = [(s, v), (t, u)].map(|(p, q)| self.dot(p, q, 3));
        let determinant = self.sum(sv, tu);
        let factor = self.reciprocal(determinant);
        let [s, t, u, v] = [s, t, u, v].map(|vector| self.scale(vector, factor));
        let parts = [
            (b, v, t, y, true),
            (v, a, t, x, false),
            (d, u, s, w, true),
            (u, c, s, z, false),
        ];
        let ends = [(b, t, true), (a, t, false), (d, s, true), (c, s, false)];
        let mut rows = Vec::new();
        for ((p, q, r, k, plus), (e, f, minus)) in parts.into_iter().zip(ends) {
            let cross = self.cross(p, q);
            let scaled = self.scale(r, k);
            let row = if plus {
                self.sum(cross, scaled)
            } else {
                self.difference(cross, scaled)
            };
            let end = self.dot(e, f, 3);
            let end = if minus { self.negate(end) } else { end };
            rows.push(self.compose(Type::vector(Scalar::Float, 4), vec![row, end]));
        }
        let rows = self.compose(Type::matrix(4, 4), rows);
        self.math(MathFunction::Transpose, &[rows])
    }

    fn cross(&mut self, left: H, right: H) -> H {
        self.math(MathFunction::Cross, &[left, right])
    }

    fn reciprocal(&mut self, value: H) -> H {
        let one = self.float(1.0);
        self.quotient(one, value)
    }
}

/// The numbers of columns and rows.
pub(super) fn sides(ty: Type) -> (u8, u8) {
    match ty.base {
        Base::Matrix { columns, rows } => (columns, rows),
        _ => unreachable!("it is no matrix"),
    }
}
