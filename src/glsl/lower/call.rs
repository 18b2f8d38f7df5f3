//! Calls of the program's functions. What is passed out is copied, in the order of the arguments,
//! as GLSL has it; naga's writers take pointers to whole variables only.

use naga::{Expression, Statement};
use smallvec::{SmallVec, smallvec};

use super::context::{Binding, Nulls, is_pointer};
use super::function::{Builder, H, Local};
use super::place::{Place, Source};
use super::types::is_opaque;
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, Direction, Expr, ExprKind, Function, Operands};
use crate::glsl::prune;
use crate::glsl::types::{Base, Type};

/// A sampler as far as it is known.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sampler {
    /// It has no texture.
    Null,
    /// Its texture, and what that is read through.
    Image(H, Option<H>),
}

impl Builder<'_, '_> {
    /// Calls a function; the value is its result, if it has one.
    pub(super) fn call(&mut self, id: Id<Function>, operands: Operands) -> Option<H> {
        let callee = &self.context.hir.functions[id];
        let operands = self.source.operands.get(operands);
        let has_effect = operands.iter().any(|&operand| self.has_effect(operand));
        // What is passed out, so that a variable which comes twice is copied in order.
        let outputs: SmallVec<[_; 4]> = operands
            .iter()
            .zip(&callee.parameters)
            .filter(|(_, direction)| is_pointer(**direction))
            .filter_map(|(&operand, _)| self.root_local(operand))
            .collect();
        let mut arguments = Vec::with_capacity(operands.len());
        let mut nulls = Nulls::new();
        let mut copies: Vec<(H, Place)> = Vec::new();
        let mut outputs_set: SmallVec<[Id<Expr>; 4]> = SmallVec::new();
        for (i, (&operand, &direction)) in operands.iter().zip(&callee.parameters).enumerate() {
            let parameter = Id::new(i);
            let ty = callee.locals[parameter].ty;
            let mut is_null = false;
            if is_opaque(ty) {
                match self.sampler(operand) {
                    Sampler::Null => is_null = true,
                    Sampler::Image(image, sampler) => {
                        arguments.push(image);
                        if self.context.sampled.contains(&(id, parameter)) {
                            arguments.push(sampler.expect("the analysis follows calls"));
                        }
                    }
                }
            } else if is_pointer(direction) {
                outputs_set.push(operand);
                let place = self.place(operand);
                match place.source {
                    Source::Pointer(pointer)
                        if !has_effect
                            && self.is_variable(pointer)
                            && is_once(&outputs, self.root_local(operand)) =>
                    {
                        arguments.push(pointer);
                    }
                    _ => {
                        let copy = self.acquire(ty);
                        if direction == Direction::InOut {
                            let value = self.load_place(place);
                            self.store(copy, value);
                        }
                        arguments.push(copy);
                        copies.push((copy, place));
                    }
                }
            } else {
                arguments.push(self.value(operand));
            }
            nulls.push(is_null);
        }
        let function = self.context.function(id, nulls);
        let result =
            (callee.result.base != Base::Void).then(|| self.add(Expression::CallResult(function)));
        self.push(Statement::Call {
            function,
            arguments,
            result,
        });
        for (copy, place) in copies {
            let value = self.load(copy);
            self.store_place(place, value);
            self.release(place.ty, copy);
        }
        for place in outputs_set {
            self.mark_set(place);
        }
        result
    }

    /// Applies a function of scalars to each component of its operands.
    pub(super) fn call_by_component(&mut self, id: Id<Function>, operands: &[H], ty: Type) -> H {
        let function = self.context.function(id, smallvec![false; operands.len()]);
        let size = ty.vector_size().expect("only vectors have components");
        let operands: Vec<_> = operands
            .iter()
            .map(|&operand| self.components(operand, size))
            .collect();
        let mut results = Vec::new();
        for i in 0..usize::from(size) {
            let arguments = operands.iter().map(|components| components[i]).collect();
            let result = self.add(Expression::CallResult(function));
            self.push(Statement::Call {
                function,
                arguments,
                result: Some(result),
            });
            results.push(result);
        }
        match *results {
            [only] => only,
            _ => self.compose(ty, results),
        }
    }

    fn root_local(&self, id: Id<Expr>) -> Option<Id<hir::Local>> {
        match self.source.exprs[prune::root(self.source, id)].kind {
            ExprKind::Local(local) => Some(local),
            _ => None,
        }
    }

    /// Whether a pointer is a whole variable, or one that the caller gave.
    fn is_variable(&self, pointer: H) -> bool {
        matches!(
            self.function.expressions[pointer],
            Expression::LocalVariable(_) | Expression::FunctionArgument(_)
        )
    }

    /// The sampler that an expression names. The host gives textures only to samplers that are no
    /// part of anything.
    pub(super) fn sampler(&mut self, id: Id<Expr>) -> Sampler {
        match self.source.exprs[id].kind {
            ExprKind::Global(global) => match self.context.globals[&global] {
                Binding::Image(image, sampler) => {
                    let image = self.global(image);
                    Sampler::Image(image, Some(self.global(sampler)))
                }
                _ => Sampler::Null,
            },
            ExprKind::Local(local) => match self.local(local) {
                Local::Image(image, sampler) => Sampler::Image(image, sampler),
                _ => Sampler::Null,
            },
            ExprKind::Comma(first, second) => {
                self.effect(first);
                self.sampler(second)
            }
            _ => Sampler::Null,
        }
    }
}

fn is_once(outputs: &[Id<hir::Local>], wanted: Option<Id<hir::Local>>) -> bool {
    let same = outputs.iter().filter(|&&output| Some(output) == wanted);
    same.count() == 1
}
