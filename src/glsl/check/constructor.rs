//! Constructors, §5.4.

use std::cell::LazyCell;

use super::{Checker, Typed};
use crate::glsl::arena::Id;
use crate::glsl::fold;
use crate::glsl::hir::ExprKind;
use crate::glsl::syntax::ast::{self, Extent, TypeSpecifier};
use crate::glsl::types::{Base, Type};

use super::specifier::Length;

impl Checker<'_> {
    /// A constructor whose type is written out: `vec3(…)`, `float[](…)`.
    pub(super) fn construct_written(
        &mut self,
        ty: &TypeSpecifier,
        arguments: &[Id<ast::Expr>],
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let resolved = self.resolve(ty);
        let arguments = self.arguments(arguments);
        let (base, length) = resolved?;
        let arguments = arguments?;
        let ty = match length {
            Length::None => Type::of(base),
            Length::Of(length) => Type::of(base).array_of(length),
            Length::Open if arguments.is_empty() => {
                let message = "an array without a size needs at least one element";
                self.error("constructor", message, expr.extent);
                return None;
            }
            Length::Open => Type::of(base).array_of(arguments.len() as u32),
        };
        self.construct(ty, &arguments, expr.extent)
    }

    pub(super) fn construct(
        &mut self,
        ty: Type,
        arguments: &[Typed],
        extent: Extent,
    ) -> Option<Typed> {
        if matches!(ty.base, Base::Void | Base::Sampler(_)) {
            let message = format!("{} cannot be constructed", self.spell_one(ty));
            self.error("constructor", message, extent);
            return None;
        }
        if let Err((message, hint)) = self.constructor_problem(ty, arguments) {
            match hint {
                "" => self.error("constructor", message, extent),
                hint => self.error_with_hint("constructor", message, extent, hint),
            }
            return None;
        }
        let precision = self.options.precision;
        let folded = self
            .constant_operands(arguments)
            .map(|constants| fold::construct(&self.hir.structs, ty, &constants, precision));
        if let Some(values) = folded {
            return Some(self.constant(ty, &values, extent));
        }
        let operands = self.operands(arguments);
        let kind = ExprKind::Construct(operands);
        Some(self.add_over(kind, ty, extent, arguments, false))
    }

    fn constructor_problem(
        &self,
        ty: Type,
        arguments: &[Typed],
    ) -> Result<(), (String, &'static str)> {
        // Most calls are right and need no message.
        let spelled = LazyCell::new(|| self.spell(ty));
        let fail = |message: String, hint| Err((message, hint));
        if arguments.is_empty() {
            return fail(format!("`{}()` needs arguments", *spelled), "");
        }
        if let Some(bad) = arguments
            .iter()
            .find(|argument| argument.ty.base == Base::Void || self.holds_sampler(argument.ty))
        {
            let bad = self.spell_one(bad.ty);
            let message = format!("{bad} cannot be part of a `{}`", *spelled);
            return fail(message, "");
        }
        if let Some(length) = ty.array {
            let length = length.get() as usize;
            if arguments.len() != length {
                let message = format!(
                    "a `{}` has {length} elements but {} are given",
                    *spelled,
                    arguments.len()
                );
                return fail(message, "");
            }
            let element = ty.element();
            return match arguments.iter().find(|argument| argument.ty != element) {
                Some(bad) => fail(
                    format!(
                        "{} cannot be an element of `{}`",
                        self.spell_one(bad.ty),
                        *spelled
                    ),
                    "the elements of an array are not converted",
                ),
                None => Ok(()),
            };
        }
        if let Base::Struct(id) = ty.base {
            let fields = &self.hir.structs[id].fields;
            if fields.len() != arguments.len() {
                let message = format!(
                    "the structure `{}` has {} members but {} are given",
                    *spelled,
                    fields.len(),
                    arguments.len()
                );
                return fail(message, "");
            }
            let mut pairs = fields.iter().zip(arguments);
            return match pairs.find(|(field, argument)| field.ty != argument.ty) {
                Some((field, argument)) => fail(
                    format!(
                        "the member `{}` of `{}` is a `{}`, this is a `{}`",
                        self.text(field.name),
                        *spelled,
                        self.spell(field.ty),
                        self.spell(argument.ty)
                    ),
                    "the members of a structure are not converted",
                ),
                None => Ok(()),
            };
        }
        self.component_problem(ty, arguments)
    }

    /// What is wrong with the arguments of a scalar, vector or matrix.
    fn component_problem(
        &self,
        ty: Type,
        arguments: &[Typed],
    ) -> Result<(), (String, &'static str)> {
        let spelled = LazyCell::new(|| self.spell(ty));
        if let Some(bad) = arguments
            .iter()
            .find(|argument| argument.ty.scalar().is_none())
        {
            let bad = self.spell_one(bad.ty);
            let message = format!("{bad} cannot be part of a `{}`", *spelled);
            return Err((message, "choose a member or an element of it"));
        }
        let wanted = self.hir.value_count(ty);
        if ty.is_matrix() && arguments.iter().any(|argument| argument.ty.is_matrix()) {
            return match arguments {
                [_] => Ok(()),
                _ => Err((
                    format!(
                        "a `{}` is made of one matrix, or of scalars and vectors",
                        *spelled
                    ),
                    "",
                )),
            };
        }
        let mut given = 0;
        for argument in arguments {
            if given >= wanted {
                let message = format!(
                    "`{}` has {wanted} components, which the first arguments fill already",
                    *spelled
                );
                return Err((message, "remove the arguments that are too many"));
            }
            given += self.hir.value_count(argument.ty);
        }
        if given != 1 && given < wanted {
            let message = format!(
                "`{}` has {wanted} components but {given} are given",
                *spelled
            );
            return Err((
                message,
                "give all components, or a single scalar for all of them",
            ));
        }
        Ok(())
    }
}
