//! What can be assigned to, §5.8.

use super::{Checker, Typed};
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, ExprKind, GlobalKind};
use crate::glsl::syntax::ast::Extent;

/// Why something cannot be assigned to.
enum Refusal {
    NoPlace,
    Repeated,
    Named(String, &'static str),
    Sampler,
}

impl Checker<'_> {
    /// Requires that an expression names a variable or a part of one, and notes that it is written.
    pub(super) fn require_place(&mut self, place: Typed, extent: Extent) -> Option<()> {
        let Some(refusal) = self.place_refusal(place) else {
            return Some(());
        };
        let (message, hint) = match refusal {
            Refusal::NoPlace => (
                "this cannot be assigned to: it is a value, no variable".to_owned(),
                String::new(),
            ),
            Refusal::Repeated => (
                "a component stands twice in what is assigned to".to_owned(),
                "each component may be set once".to_owned(),
            ),
            Refusal::Named(name, why) => {
                (format!("`{name}` cannot be assigned to"), why.to_owned())
            }
            Refusal::Sampler => (
                "a variable with a sampler in it cannot be assigned to".to_owned(),
                String::new(),
            ),
        };
        match &*hint {
            "" => self.error("not-assignable", message, extent),
            _ => self.error_with_hint("not-assignable", message, extent, hint),
        }
        None
    }

    fn place_refusal(&mut self, place: Typed) -> Option<Refusal> {
        let mut at = place.id;
        loop {
            match self.function.exprs[at].kind {
                ExprKind::Swizzle(_, swizzle) if self.repeats(swizzle) => {
                    return Some(Refusal::Repeated);
                }
                ExprKind::Swizzle(base, _)
                | ExprKind::Member(base, _)
                | ExprKind::Index(base, _) => at = base,
                ExprKind::Local(id) => return self.local_refusal(id),
                ExprKind::Global(id) => return self.global_refusal(id),
                ExprKind::Constant(_) => {
                    let extent = self.function.exprs[at].extent;
                    let name = self.places.spelling(extent.first);
                    let name = name.map_or("", |name| self.text(name));
                    let is_name = extent.first == extent.last
                        && name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
                        && !matches!(name, "true" | "false");
                    return Some(match is_name {
                        true => Refusal::Named(name.to_owned(), "it is `const`"),
                        false => Refusal::NoPlace,
                    });
                }
                _ => return Some(Refusal::NoPlace),
            }
        }
    }

    fn local_refusal(&mut self, id: Id<hir::Local>) -> Option<Refusal> {
        let local = &self.function.locals[id];
        if self.constant_parameters.contains(id) {
            let name = local.name.map_or("", |name| self.text(name)).to_owned();
            return Some(Refusal::Named(name, "the parameter is `const`"));
        }
        if self.holds_sampler(local.ty) {
            return Some(Refusal::Sampler);
        }
        self.function.locals[id].written = true;
        None
    }

    fn global_refusal(&mut self, id: Id<hir::Global>) -> Option<Refusal> {
        let global = &self.hir.globals[id];
        let why = match global.kind {
            GlobalKind::Private(_) | GlobalKind::Output(_) | GlobalKind::FragDepth => {
                self.hir.globals[id].written = true;
                return None;
            }
            GlobalKind::Uniform => "it is a uniform: copy it into a variable and change that",
            GlobalKind::Input
            | GlobalKind::FragCoord
            | GlobalKind::FrontFacing
            | GlobalKind::PointCoord => "it is an input: copy it into a variable and change that",
        };
        Some(Refusal::Named(self.text(global.name).to_owned(), why))
    }

    /// Whether ANGLE would call an expression temporary: a local variable, or computed.
    pub(super) fn is_temporary(&self, of: Typed) -> bool {
        match self.function.exprs[of.id].kind {
            ExprKind::Local(id) => id.index() >= self.function.parameters.len(),
            ExprKind::Global(_) | ExprKind::Constant(_) => false,
            _ => true,
        }
    }
}
