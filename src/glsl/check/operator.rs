//! Operators, §5.7 to §5.9: which types they take and give.

use super::{Checker, Typed};
use crate::glsl::arena::Id;
use crate::glsl::fold;
use crate::glsl::hir::{self, ExprKind};
use crate::glsl::syntax::ast::{self, BinaryOp, Extent, UnaryOp};
use crate::glsl::types::{Base, Scalar, Type};

impl Checker<'_> {
    pub(super) fn unary(
        &mut self,
        op: UnaryOp,
        operand: Id<ast::Expr>,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let operand = self.expression(operand)?;
        let scalar = operand.ty.scalar();
        let fits = match op {
            UnaryOp::Not => operand.ty == Type::BOOL,
            UnaryOp::Complement => matches!(scalar, Some(Scalar::Int | Scalar::Uint)),
            UnaryOp::Plus | UnaryOp::Negate => {
                matches!(scalar, Some(Scalar::Float | Scalar::Int | Scalar::Uint))
            }
        };
        if !fits {
            let ty = self.spell_one(operand.ty);
            let message = format!("the operator `{}` does not work on {ty}", op.symbol());
            let hint = match op {
                UnaryOp::Not if scalar == Some(Scalar::Bool) => "for vectors there is `not(…)`",
                UnaryOp::Not => "it negates a `bool`; compare first, as in `x != 0.`",
                UnaryOp::Complement => "it works on `int`, `uint` and their vectors",
                UnaryOp::Plus | UnaryOp::Negate => "it works on numbers, vectors and matrices",
            };
            self.error_with_hint("type-mismatch", message, expr.extent, hint);
            return None;
        }
        let op = match op {
            UnaryOp::Plus if operand.value.is_some() => return Some(operand),
            UnaryOp::Plus => {
                // Nothing is done, but the result is a value and no place any more.
                let operands = self.operands(&[operand]);
                let kind = ExprKind::Construct(operands);
                return Some(self.add_over(kind, operand.ty, expr.extent, &[operand], false));
            }
            UnaryOp::Negate => hir::UnaryOp::Negate,
            UnaryOp::Not => hir::UnaryOp::Not,
            UnaryOp::Complement => hir::UnaryOp::Complement,
        };
        if let Some(constant) = self.operand(operand) {
            let values = fold::unary(op, constant, self.options.precision);
            return Some(self.constant(operand.ty, &values, expr.extent));
        }
        let kind = ExprKind::Unary(op, operand.id);
        Some(self.add_over(kind, operand.ty, expr.extent, &[operand], false))
    }

    pub(super) fn increment(
        &mut self,
        place: Id<ast::Expr>,
        down: bool,
        prefix: bool,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let place = self.expression(place)?;
        let symbol = if down { "--" } else { "++" };
        self.require_place(place, expr.extent)?;
        if !matches!(
            place.ty.scalar(),
            Some(Scalar::Float | Scalar::Int | Scalar::Uint)
        ) {
            let message = format!("`{symbol}` does not work on {}", self.spell_one(place.ty));
            self.error("type-mismatch", message, expr.extent);
            return None;
        }
        let kind = ExprKind::Increment {
            place: place.id,
            down,
            prefix,
        };
        Some(self.add_over(kind, place.ty, expr.extent, &[place], true))
    }

    pub(super) fn binary(
        &mut self,
        op: BinaryOp,
        left: Id<ast::Expr>,
        right: Id<ast::Expr>,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        // A chain of operators leans to the left: it is walked without recursion.
        let mut chain = vec![(op, right, expr)];
        let mut first = left;
        while let ast::ExprKind::Binary(op, left, right) = self.ast.exprs[first].kind {
            chain.push((op, right, &self.ast.exprs[first]));
            first = left;
        }
        let mut left = self.expression(first);
        for &(op, right, expr) in chain.iter().rev() {
            let right = self.expression(right);
            left = match (left, right) {
                (Some(left), Some(right)) => self.binary_of(op, left, right, expr),
                _ => None,
            };
        }
        left
    }

    fn binary_of(
        &mut self,
        op: BinaryOp,
        left: Typed,
        right: Typed,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let Some(ty) = self.operator_result(op, left.ty, right.ty) else {
            self.wrong_operands(op, left.ty, right.ty, expr);
            return None;
        };
        if let (Some(a), Some(b)) = (self.operand(left), self.operand(right)) {
            let values = fold::binary(op, a, b, self.options.precision);
            return Some(self.constant(ty, &values, expr.extent));
        }
        let kind = match op {
            BinaryOp::LogicalAnd => ExprKind::And(left.id, right.id),
            BinaryOp::LogicalOr => ExprKind::Or(left.id, right.id),
            op => ExprKind::Binary(op, left.id, right.id),
        };
        Some(self.add_over(kind, ty, expr.extent, &[left, right], false))
    }

    /// The type of what an operator makes of operands of these types, §5.9.
    fn operator_result(&self, op: BinaryOp, left: Type, right: Type) -> Option<Type> {
        use BinaryOp as Op;
        match op {
            Op::Equal | Op::NotEqual => {
                let comparable =
                    left == right && left.base != Base::Void && !self.holds_sampler(left);
                return comparable.then_some(Type::BOOL);
            }
            Op::LogicalAnd | Op::LogicalOr | Op::LogicalXor => {
                return (left == Type::BOOL && right == Type::BOOL).then_some(Type::BOOL);
            }
            _ => {}
        }
        let (a, b) = (left.scalar()?, right.scalar()?);
        let is_integer = |scalar| matches!(scalar, Scalar::Int | Scalar::Uint);
        match op {
            Op::Less | Op::Greater | Op::LessEqual | Op::GreaterEqual => {
                let fits = left == right && left.is_scalar() && a != Scalar::Bool;
                fits.then_some(Type::BOOL)
            }
            Op::ShiftLeft | Op::ShiftRight => {
                let sizes_fit = right.is_scalar() || left.vector_size() == right.vector_size();
                (is_integer(a) && is_integer(b) && sizes_fit).then_some(left)
            }
            Op::BitAnd | Op::BitOr | Op::BitXor | Op::Remainder => {
                (a == b && is_integer(a)).then(|| common_size(left, right))?
            }
            Op::Add | Op::Subtract | Op::Divide => {
                (a == b && a != Scalar::Bool).then(|| common_size(left, right))?
            }
            Op::Multiply => (a == b && a != Scalar::Bool).then(|| product(left, right))?,
            _ => None,
        }
    }

    fn wrong_operands(&mut self, op: BinaryOp, left: Type, right: Type, expr: &ast::Expr) {
        let (a, b) = (self.spell(left), self.spell(right));
        let message = format!(
            "the operator `{}` does not work on `{a}` and `{b}`",
            op.symbol()
        );
        let at = expr.extent;
        let kinds = (left.scalar(), right.scalar());
        let hint = match kinds {
            (Some(Scalar::Float), Some(Scalar::Int)) | (Some(Scalar::Int), Some(Scalar::Float)) => {
                "GLSL ES converts nothing by itself: write `1.` for `1`, or `float(…)`"
            }
            (Some(a), Some(b)) if a != b => {
                "GLSL ES converts nothing by itself: write `float(…)`, `int(…)` or `uint(…)`"
            }
            _ if matches!(op, BinaryOp::Less | BinaryOp::Greater) && left.is_vector() => {
                "vectors are compared by `lessThan(…)` and `greaterThan(…)`"
            }
            (Some(_), Some(_)) => "the sizes of the operands do not fit together",
            _ => "",
        };
        match hint {
            "" => self.error("type-mismatch", message, at),
            hint => self.error_with_hint("type-mismatch", message, at, hint),
        }
    }

    pub(super) fn assign(
        &mut self,
        op: Option<BinaryOp>,
        place: Id<ast::Expr>,
        value: Id<ast::Expr>,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let place = self.expression(place);
        let value = self.expression(value);
        let place = place?;
        self.require_place(place, expr.extent)?;
        let value = value?;
        let Some(op) = op else {
            if !self.can_hold(place.ty, value.ty) {
                self.wrong_value(place.ty, value.ty, expr.extent);
                return None;
            }
            let kind = ExprKind::Assign(place.id, value.id);
            return Some(self.add_over(kind, place.ty, expr.extent, &[place, value], true));
        };
        if self.operator_result(op, place.ty, value.ty) != Some(place.ty) {
            let (a, b) = (self.spell_one(place.ty), self.spell_one(value.ty));
            let message = format!("`{}=` cannot change {a} by {b}", op.symbol());
            let hint = "GLSL ES converts nothing by itself: write `float(…)`, `vec3(…)` and so on";
            self.error_with_hint("type-mismatch", message, expr.extent, hint);
            return None;
        }
        let kind = ExprKind::Compound(op, place.id, value.id);
        Some(self.add_over(kind, place.ty, expr.extent, &[place, value], true))
    }

    /// Whether a variable of one type can be set to a value of another.
    pub(super) fn can_hold(&self, place: Type, value: Type) -> bool {
        place == value && place.base != Base::Void && !self.holds_sampler(place)
    }

    pub(super) fn wrong_value(&mut self, place: Type, value: Type, extent: Extent) {
        let (a, b) = (self.spell_one(place), self.spell_one(value));
        let message = if place == value {
            format!("{a} cannot be assigned")
        } else {
            format!("{a} is expected, this is {b}")
        };
        let hint = match (place.scalar(), value.scalar()) {
            (Some(Scalar::Float), Some(Scalar::Int)) if place.is_scalar() && value.is_scalar() => {
                "GLSL ES converts nothing by itself: write `1.` for `1`, or `float(…)`".to_owned()
            }
            _ if place.array.is_some() || self.holds_sampler(place) => {
                self.error("type-mismatch", message, extent);
                return;
            }
            _ => "GLSL ES converts nothing by itself: write `float(…)`, `vec3(…)` and so on"
                .to_owned(),
        };
        self.error_with_hint("type-mismatch", message, extent, hint);
    }

    /// Requires a truth value.
    pub(super) fn require_bool(&mut self, of: Typed, what: &str) -> Option<Typed> {
        if of.ty == Type::BOOL {
            return Some(of);
        }
        let extent = self.function.exprs[of.id].extent;
        let message = format!("{what} must be a `bool`, this is {}", self.spell_one(of.ty));
        let hint = "compare it with something, as in `x > 0.`; nothing counts as true by itself";
        self.error_with_hint("type-mismatch", message, extent, hint);
        None
    }

    pub(super) fn ternary(
        &mut self,
        condition: Id<ast::Expr>,
        yes: Id<ast::Expr>,
        no: Id<ast::Expr>,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        // A chain of conditionals leans to the right: it is walked without recursion.
        let mut chain = vec![(condition, yes, expr)];
        let mut last = no;
        while let ast::ExprKind::Ternary(condition, yes, no) = self.ast.exprs[last].kind {
            chain.push((condition, yes, &self.ast.exprs[last]));
            last = no;
        }
        let mut sides = Vec::with_capacity(chain.len());
        for &(condition, yes, expr) in &chain {
            let condition = self.expression(condition);
            let condition = condition
                .and_then(|condition| self.require_bool(condition, "the condition of `?:`"));
            sides.push((condition, self.expression(yes), expr));
        }
        let mut no = self.expression(last);
        for &(condition, yes, expr) in sides.iter().rev() {
            no = match (condition, yes, no) {
                (Some(condition), Some(yes), Some(no)) => self.ternary_of(condition, yes, no, expr),
                _ => None,
            };
        }
        no
    }

    fn ternary_of(
        &mut self,
        condition: Typed,
        yes: Typed,
        no: Typed,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        if yes.ty != no.ty {
            let (a, b) = (self.spell(yes.ty), self.spell(no.ty));
            let message = format!("the two sides of `?:` differ: `{a}` and `{b}`");
            let hint = "GLSL ES converts nothing by itself: write `float(…)`, `vec3(…)` and so on";
            self.error_with_hint("type-mismatch", message, expr.extent, hint);
            return None;
        }
        if yes.ty.base == Base::Void || self.holds_sampler(yes.ty) {
            let message = format!("`?:` cannot choose {}", self.spell_one(yes.ty));
            self.error_with_hint("type-mismatch", message, expr.extent, "use `if`");
            return None;
        }
        if yes.ty.is_array() || matches!(yes.ty.base, Base::Struct(_)) {
            let what = if yes.ty.is_array() {
                "arrays"
            } else {
                "structures"
            };
            self.refused_by_webgl(
                "webgl-ternary",
                format!("`?:` cannot choose between {what}"),
                expr.extent,
                "use `if`",
            );
        }
        if let (Some(chosen), Some(a), Some(b)) = (condition.value, yes.value, no.value) {
            let holds = matches!(self.hir.constants.get(chosen), [hir::Value::Bool(true)]);
            return Some(self.constant_of(yes.ty, if holds { a } else { b }, expr.extent));
        }
        let kind = ExprKind::Ternary(condition.id, yes.id, no.id);
        Some(self.add_over(kind, yes.ty, expr.extent, &[condition, yes, no], false))
    }

    pub(super) fn comma(
        &mut self,
        left: Id<ast::Expr>,
        right: Id<ast::Expr>,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let mut chain = vec![(right, expr)];
        let mut first = left;
        while let ast::ExprKind::Comma(left, right) = self.ast.exprs[first].kind {
            chain.push((right, &self.ast.exprs[first]));
            first = left;
        }
        let mut left = self.expression(first);
        for &(right, expr) in chain.iter().rev() {
            let right = self.expression(right);
            left = match (left, right) {
                (Some(left), Some(right)) => self.comma_of(left, right, expr),
                _ => None,
            };
        }
        left
    }

    fn comma_of(&mut self, left: Typed, right: Typed, expr: &ast::Expr) -> Option<Typed> {
        if let Some(bad) = [left, right]
            .into_iter()
            .find(|side| side.ty.base == Base::Void || self.holds_array(side.ty))
        {
            let extent = self.function.exprs[bad.id].extent;
            let message = format!("`,` cannot join {}", self.spell_one(bad.ty));
            self.error_with_hint("type-mismatch", message, extent, "write two statements");
            return None;
        }
        // What has no effect is dropped, so that the right side of the two stays a place.
        if !self.has_effects(left) && right.value.is_none() && self.is_temporary(right) {
            return Some(right);
        }
        let kind = ExprKind::Comma(left.id, right.id);
        Some(self.add_over(kind, right.ty, expr.extent, &[left, right], false))
    }
}

/// The type of a component-wise operator, where a scalar stands for as many components as needed.
fn common_size(left: Type, right: Type) -> Option<Type> {
    if left == right || right.is_scalar() {
        Some(left)
    } else {
        left.is_scalar().then_some(right)
    }
}

/// The type of a product: linear algebra where a matrix takes part.
fn product(left: Type, right: Type) -> Option<Type> {
    match (left.base, right.base) {
        (
            Base::Matrix { columns, rows },
            Base::Matrix {
                columns: others,
                rows: inner,
            },
        ) => (columns == inner).then(|| Type::matrix(others, rows)),
        (Base::Matrix { columns, rows }, Base::Vector(scalar, size)) => {
            (columns == size).then(|| Type::vector(scalar, rows))
        }
        (Base::Vector(scalar, size), Base::Matrix { columns, rows }) => {
            (rows == size).then(|| Type::vector(scalar, columns))
        }
        _ => common_size(left, right),
    }
}
