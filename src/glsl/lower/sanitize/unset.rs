//! Variables that are read before they are set. WebGL2 begins them as zero, and so does this program, but
//! GLSL leaves open what they hold.
//!
//! A variable that is declared without a value has a word of marks beside it: a bit for each component of a
//! scalar or vector, one bit for anything else, which any part sets.

use naga::BinaryOperator;
use smallvec::SmallVec;

use super::{Form, Hazard};
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, ExprKind, GlobalKind, Value};
use crate::glsl::lower::context::Context;
use crate::glsl::lower::function::{Builder, H};
use crate::glsl::names::Name;
use crate::glsl::types::Type;

/// A variable, and the marks of what an expression names of it.
struct Named {
    /// Where its marks are kept.
    marks: H,
    name: Name,
    /// Which of its marks, in the order of the expression's components.
    bits: SmallVec<[u8; 4]>,
    /// Whether any of them is enough, because it is not known which component is meant.
    any: bool,
}

impl Context<'_> {
    /// Makes room for the marks of global variables.
    pub(super) fn add_global_marks(&mut self) {
        for &id in &self.reachable.globals {
            if self.hir.globals[id].kind == GlobalKind::Private(None) {
                let marks = self.add_private("is_set", Type::UINT);
                self.sanitizer.globals.insert(id, marks);
            }
        }
    }
}

impl Builder<'_, '_> {
    /// A variable begins without a value.
    pub fn begin_unset(&mut self, id: Id<hir::Local>) {
        if !self.is_sanitized() || self.source.locals[id].name.is_none() {
            return;
        }
        let marks = match self.marks.get(&id) {
            Some(&known) => known,
            None => self.variable(Type::UINT, Some("is_set".to_owned())),
        };
        self.marks.insert(id, marks);
        let none = self.uint(0);
        self.store(marks, none);
    }

    /// A place is set.
    pub fn mark_set(&mut self, place: Id<hir::Expr>) {
        let Some(named) = self.named(place) else {
            return;
        };
        let before = self.load(named.marks);
        let bits = self.uint(named.mask());
        let after = self.binary(BinaryOperator::InclusiveOr, before, bits);
        self.store(named.marks, after);
    }

    /// Looks whether what is about to be read has been set.
    pub fn check_set(&mut self, place: Id<hir::Expr>) {
        let Some(named) = self.named(place) else {
            return;
        };
        let extent = self.source.exprs[place].extent;
        let here = self.site_at(extent, Hazard::Unset, Form::Variable(named.name), &[]);
        let own = self.load(named.marks);
        let needed = self.uint(named.mask());
        let set = self.binary(BinaryOperator::And, own, needed);
        let is_set = if named.any {
            let none = self.uint(0);
            self.binary(BinaryOperator::NotEqual, set, none)
        } else {
            self.binary(BinaryOperator::Equal, set, needed)
        };
        let is_unset = self.not(is_set);
        self.note(here, here.number, is_unset, &[]);
    }

    /// The variable that an expression names, or parts of, if it has marks.
    fn named(&mut self, place: Id<hir::Expr>) -> Option<Named> {
        if !self.is_sanitized() {
            return None;
        }
        let hir::Expr { kind, ty, .. } = self.source.exprs[place];
        match kind {
            ExprKind::Local(id) => {
                let &marks = self.marks.get(&id)?;
                let name = self.source.locals[id].name?;
                Some(Named::whole(marks, name, ty))
            }
            ExprKind::Global(id) => {
                let &marks = self.context.sanitizer.globals.get(&id)?;
                let name = self.context.hir.globals[id].name;
                let marks = self.global(marks);
                Some(Named::whole(marks, name, ty))
            }
            ExprKind::Member(base, _) => self.named(base),
            ExprKind::Swizzle(base, swizzle) => {
                Some(self.named(base)?.components(swizzle.as_slice()))
            }
            ExprKind::Index(base, index) => {
                let whole = self.named(base)?;
                Some(match self.known_component(index) {
                    Some(component) => whole.components(&[component]),
                    None => Named { any: true, ..whole },
                })
            }
            _ => None,
        }
    }

    fn known_component(&self, index: Id<hir::Expr>) -> Option<u8> {
        let ExprKind::Constant(constant) = self.source.exprs[index].kind else {
            return None;
        };
        match *self.context.hir.constants.get(constant) {
            [Value::Int(index)] => u8::try_from(index).ok(),
            [Value::Uint(index)] => u8::try_from(index).ok(),
            _ => None,
        }
    }
}

impl Named {
    fn whole(marks: H, name: Name, ty: Type) -> Self {
        let size = if ty.is_array() {
            None
        } else {
            ty.vector_size()
        };
        Named {
            marks,
            name,
            bits: (0..size.unwrap_or(1)).collect(),
            any: false,
        }
    }

    /// Only some of its components, if each has a mark.
    fn components(mut self, components: &[u8]) -> Self {
        if self.bits.len() > 1 {
            let own = self.bits;
            let chosen = components
                .iter()
                .map(|&i| own[usize::from(i).min(own.len() - 1)]);
            self.bits = chosen.collect();
        }
        self
    }

    fn mask(&self) -> u32 {
        self.bits.iter().fold(0, |mask, bit| mask | 1 << bit)
    }
}
