//! Declarations of variables, §4.2 to §4.5.

use super::flow::Variable;
use super::qualifier::{Qualifiers, Storage};
use super::scope::Symbol;
use super::specifier::Length;
use super::{Checker, Typed};
use crate::glsl::arena::{Id, Range};
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::{self, ExprKind, GlobalKind, StmtKind, Value};
use crate::glsl::names::Name;
use crate::glsl::syntax::ast::{
    Declaration, Declarator, Extent, LayoutItem, QualifiedType, Qualifier, QualifierKind,
    TokenIndex,
};
use crate::glsl::types::{Base, Scalar, Type};
use crate::source::Diagnostic;

impl Checker<'_> {
    pub(super) fn global_declaration(&mut self, declaration: &Declaration) {
        let mut block = std::mem::take(&mut self.function.body);
        self.declaration(declaration, &mut block);
        self.function.body = block;
    }

    /// A declaration at any place. What it does at run time is added to `block`.
    pub(super) fn declaration(&mut self, declaration: &Declaration, block: &mut hir::Block) {
        match declaration {
            Declaration::Precision { ty, at, .. } => {
                let resolved = self.resolve(ty);
                let is_array = resolved.is_some_and(|(_, length)| length != Length::None);
                let base = resolved.map(|(base, _)| base);
                self.set_precision(base, is_array, Extent::of(*at));
            }
            Declaration::Variables { ty, declarators } => {
                self.variables(ty, self.ast.declarators.get(*declarators), block);
            }
            Declaration::Prototype(header) if self.is_global() => {
                self.function_header(header);
            }
            Declaration::Prototype(header) => {
                let message = "a function can only be declared outside of functions";
                self.error("syntax", message, Extent::of(header.at));
            }
            Declaration::Block {
                qualifiers,
                name,
                at,
                members,
                instance,
            } => self.block(*qualifiers, *name, *at, members, instance.as_ref()),
            Declaration::Qualifiers { qualifiers, names } => {
                self.bare_qualifiers(*qualifiers, names);
            }
        }
    }

    /// `layout(std140) uniform;` or `invariant a;`
    fn bare_qualifiers(&mut self, row: Range<Qualifier>, names: &[(Name, TokenIndex)]) {
        let qualifiers = self.ast.qualifiers.get(row);
        let at = Extent::of(qualifiers.first().map_or(0, |first| first.at));
        if names.is_empty() {
            let found = self.variable_qualifiers(row);
            if found.storage != Storage::Uniform || found.layout.is_empty() {
                let message = "only `layout(…) uniform;` can stand without a variable";
                self.error("qualifier", message, at);
            }
            self.check_block_layout(&found.layout);
            return;
        }
        if let (
            [
                Qualifier {
                    kind: QualifierKind::Const,
                    ..
                },
            ],
            [(name, _)],
        ) = (qualifiers, names)
            && let Some(Symbol::Struct(_)) = self.scopes.find(*name)
        {
            // `const S;` declares nothing.
            return;
        }
        let is_invariant = matches!(
            qualifiers,
            [Qualifier {
                kind: QualifierKind::Invariant,
                ..
            }]
        );
        for &(name, at) in names {
            let at = Extent::of(at);
            let is_output = match self.scopes.find(name) {
                Some(Symbol::Global(id)) => {
                    matches!(self.hir.globals[id].kind, GlobalKind::Output(_))
                }
                _ => false,
            };
            if !is_invariant || !self.is_global() || !is_output {
                self.error("qualifier", "only outputs can be `invariant`", at);
            }
        }
    }

    /// Reports layouts that uniform blocks do not have.
    pub(super) fn check_block_layout(&mut self, layout: &[LayoutItem]) {
        for item in layout {
            let name = self.text(item.name).to_owned();
            let known = ["shared", "packed", "std140", "row_major", "column_major"];
            if !known.contains(&&*name) || item.value.is_some() {
                let message = format!("the layout `{name}` does not exist for uniforms");
                let hint = "there are `std140`, `shared`, `packed`, `row_major` and `column_major`";
                self.error_with_hint("qualifier", message, Extent::of(item.at), hint);
            }
        }
    }

    fn variables(
        &mut self,
        ty: &QualifiedType,
        declarators: &[Declarator],
        block: &mut hir::Block,
    ) {
        let qualifiers = self.variable_qualifiers(ty.qualifiers);
        let resolved = self.resolve(&ty.ty);
        if let Some((base, _)) = resolved {
            self.check_precision(qualifiers.precision, base, ty.ty.extent);
            self.check_interface(&qualifiers, base, ty.ty.extent);
        }
        if let Some((_, Length::Open)) = resolved
            && declarators.is_empty()
        {
            self.error(
                "array-size",
                "the size of the array is missing",
                ty.ty.extent,
            );
        }
        for declarator in declarators {
            self.variable_declaration(&qualifiers, resolved, declarator, block);
        }
    }

    /// Checks what may be an input or output, and which layouts there may be.
    fn check_interface(&mut self, qualifiers: &Qualifiers, base: Base, extent: Extent) {
        for item in &qualifiers.layout {
            let name = self.text(item.name).to_owned();
            let fits = qualifiers.storage == Storage::Out && name == "location";
            if !fits {
                let message = format!("the layout `{name}` cannot be given here");
                self.error("qualifier", message, Extent::of(item.at));
            }
        }
        if !matches!(qualifiers.storage, Storage::In | Storage::Out) {
            return;
        }
        let is_output = qualifiers.storage == Storage::Out;
        let what = if is_output { "output" } else { "input" };
        let refusal = match base {
            Base::Scalar(Scalar::Bool) | Base::Vector(Scalar::Bool, _) => Some("a `bool`"),
            Base::Matrix { .. } if is_output => Some("a matrix"),
            Base::Struct(_) if is_output => Some("a structure"),
            _ => None,
        };
        if let Some(refusal) = refusal {
            let message = format!("an {what} cannot be {refusal}");
            self.error("qualifier", message, extent);
        }
        let is_whole = |scalar| matches!(scalar, Scalar::Int | Scalar::Uint);
        if let Base::Scalar(scalar) | Base::Vector(scalar, _) = base
            && !is_output
            && is_whole(scalar)
            && !qualifiers.is_flat
        {
            let message = "an input of whole numbers cannot be interpolated";
            self.error_with_hint("qualifier", message, extent, "write `flat in`");
        }
    }

    fn variable_declaration(
        &mut self,
        qualifiers: &Qualifiers,
        resolved: Option<(Base, Length)>,
        declarator: &Declarator,
        block: &mut hir::Block,
    ) {
        let at = Extent::of(declarator.at);
        let length = resolved.and_then(|(_, inner)| self.length(declarator.sizes, inner));
        // The variable's scope begins behind its initialiser.
        let init = declarator.init.map(|init| self.expression(init));
        self.check_name(declarator.name, at);
        let wrong = matches!(init, Some(None));
        let init = init.flatten();
        let declared = resolved.zip(length).filter(|_| !wrong);
        let declared = declared.and_then(|((base, _), length)| {
            let ty = self.variable_type(qualifiers, base, length, init, declarator)?;
            self.declare_variable(qualifiers, ty, init, declarator, block)
        });
        if declared.is_none() && self.scopes.find_here(declarator.name).is_none() {
            self.scopes
                .declare(declarator.name, Symbol::Wrong, declarator.at);
        }
    }

    fn variable_type(
        &mut self,
        qualifiers: &Qualifiers,
        base: Base,
        length: Length,
        init: Option<Typed>,
        declarator: &Declarator,
    ) -> Option<Type> {
        let at = Extent::of(declarator.at);
        if base == Base::Void {
            self.error("void", "a variable cannot be `void`", at);
            return None;
        }
        if self.holds_sampler(base.into()) && qualifiers.storage != Storage::Uniform {
            let message = "a sampler can only be a uniform or a parameter";
            let hint = "pass `iChannel0` itself to functions that need it";
            self.error_with_hint("sampler", message, at, hint);
            return None;
        }
        match Self::closed(base, length, init.map(|init| init.ty)) {
            Some(ty) => Some(ty),
            None if init.is_some() => {
                let given = init.map_or(Type::VOID, |init| init.ty);
                let message = format!("an array is expected, this is {}", self.spell_one(given));
                self.error("type-mismatch", message, at);
                None
            }
            None => {
                let message = "the size of the array is missing";
                self.error("array-size", message, at);
                None
            }
        }
    }

    /// Declares a variable of a known type; `None` when it is wrong.
    fn declare_variable(
        &mut self,
        qualifiers: &Qualifiers,
        ty: Type,
        init: Option<Typed>,
        declarator: &Declarator,
        block: &mut hir::Block,
    ) -> Option<()> {
        let Declarator { name, at, .. } = *declarator;
        let extent = Extent::of(at);
        let is_owned = matches!(qualifiers.storage, Storage::Plain | Storage::Const);
        if let (Some(init), false) = (init, is_owned) {
            let extent = self.function.exprs[init.id].extent;
            let message = "a uniform, input or output cannot be initialised";
            self.error("qualifier", message, extent);
            return None;
        }
        if let Some(init) = init
            && !self.can_hold(ty, init.ty)
        {
            let whole = Extent {
                first: at,
                last: self.function.exprs[init.id].extent.last,
            };
            self.wrong_value(ty, init.ty, whole);
            return None;
        }
        if is_owned && !self.check_size(ty, extent) {
            return None;
        }
        if qualifiers.storage == Storage::In
            && let Some(message) = self.input_problem(ty, qualifiers.is_flat)
        {
            self.error("qualifier", message, extent);
            return None;
        }
        match qualifiers.storage {
            Storage::Const => self.declare_constant(ty, init, declarator),
            Storage::Plain if self.is_global() => self.declare_private(ty, init, declarator, block),
            Storage::Plain => {
                let id = self.function.locals.add(hir::Local {
                    name: Some(name),
                    ty,
                    written: false,
                    at,
                });
                self.declare_here(name, Symbol::Local(id), at)?;
                if init.is_some() {
                    self.initialised.insert(id);
                }
                if init.is_some_and(|init| self.is_true(init)) {
                    self.note_begun_true(Variable::Local(id));
                }
                let height = init.map_or(0, |init| self.detail(init.id).height);
                self.flow.note_height(2 + height);
                block.push(hir::Stmt {
                    kind: StmtKind::Declare(id, init.map(|init| init.id)),
                    extent,
                });
                Some(())
            }
            storage => {
                let location = qualifiers.layout.iter().find_map(|item| item.value);
                let id = self.hir.globals.add(hir::Global {
                    name,
                    ty,
                    kind: match storage {
                        Storage::Uniform => GlobalKind::Uniform,
                        Storage::Out => GlobalKind::Output(location.unwrap_or(0)),
                        _ => GlobalKind::Input,
                    },
                    at: Some(at),
                    written: false,
                });
                if storage == Storage::Out {
                    self.outputs.push((id, location));
                }
                self.declare_here(name, Symbol::Global(id), at)
            }
        }
    }

    /// What a structure cannot be or hold as an input, §4.3.4.
    fn input_problem(&self, ty: Type, is_flat: bool) -> Option<&'static str> {
        let Base::Struct(id) = ty.base else {
            return None;
        };
        if ty.is_array() {
            return Some("an input cannot be an array of structures");
        }
        self.hir.structs[id].fields.iter().find_map(|field| {
            let scalar = match field.ty.base {
                _ if field.ty.is_array() => return Some("an input cannot hold an array"),
                Base::Struct(_) => return Some("an input cannot hold a structure"),
                Base::Scalar(scalar) | Base::Vector(scalar, _) => scalar,
                _ => return None,
            };
            match scalar {
                Scalar::Bool => Some("an input cannot hold a `bool`"),
                Scalar::Int | Scalar::Uint if !is_flat => {
                    Some("an input with whole numbers cannot be interpolated: write `flat in`")
                }
                _ => None,
            }
        })
    }

    fn declare_constant(
        &mut self,
        ty: Type,
        init: Option<Typed>,
        declarator: &Declarator,
    ) -> Option<()> {
        let Declarator { name, at, .. } = *declarator;
        let extent = Extent::of(at);
        let Some(init) = init else {
            let message = format!("the constant `{}` has no value", self.text(name));
            let hint = "write `= …` behind it";
            self.error_with_hint("not-constant", message, extent, hint);
            return None;
        };
        let Some(value) = init.value else {
            let message = format!(
                "the value of the constant `{}` is not known before the program runs",
                self.text(name)
            );
            let extent = self.function.exprs[init.id].extent;
            self.error_with_hint("not-constant", message, extent, "leave `const` away");
            return None;
        };
        self.declare_here(name, Symbol::Constant(ty, value), at)
    }

    /// A global variable of the program's own.
    fn declare_private(
        &mut self,
        ty: Type,
        init: Option<Typed>,
        declarator: &Declarator,
        block: &mut hir::Block,
    ) -> Option<()> {
        let Declarator { name, at, .. } = *declarator;
        let extent = Extent::of(at);
        let id = self.hir.globals.add(hir::Global {
            name,
            ty,
            kind: GlobalKind::Private(init.and_then(|init| init.value)),
            at: Some(at),
            written: false,
        });
        if let Some(init) = init
            && init.value.is_none()
        {
            if !self.is_made_of_constants(init.id) {
                let message = format!(
                    "the initial value of the global `{}` is not a constant expression",
                    self.text(name)
                );
                let hint = "set it at the beginning of `mainImage`, or make it a `#define`";
                self.refused_by_webgl("webgl-global-initialiser", message, extent, hint);
            }
            let place = self.add_over(ExprKind::Global(id), ty, extent, &[], false);
            let kind = ExprKind::Assign(place.id, init.id);
            let assignment = self.add_over(kind, ty, extent, &[place, init], true);
            block.push(hir::Stmt {
                kind: StmtKind::Expression(assignment.id),
                extent,
            });
        }
        self.declare_here(name, Symbol::Global(id), at)?;
        if init.is_some_and(|init| self.is_true(init)) {
            self.note_begun_true(Variable::Global(id));
        }
        Some(())
    }

    fn is_true(&self, of: Typed) -> bool {
        let value = of.value.map(|value| self.hir.constants.get(value));
        matches!(value, Some([Value::Bool(true)]))
    }

    /// Whether only constants, operators and functions of mathematics take part. That is more than a
    /// constant expression, which has no comma in it, and enough for WebGL2.
    fn is_made_of_constants(&self, id: Id<hir::Expr>) -> bool {
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            match self.function.exprs[id].kind {
                ExprKind::Local(_)
                | ExprKind::Global(_)
                | ExprKind::Assign(..)
                | ExprKind::Compound(..)
                | ExprKind::Increment { .. }
                | ExprKind::Call(..)
                | ExprKind::Builtin(Builtin::DFdx | Builtin::DFdy | Builtin::Fwidth, _) => {
                    return false;
                }
                _ => self
                    .function
                    .for_each_operand(id, |operand| open.push(operand)),
            }
        }
        true
    }

    pub(super) fn declare_global(&mut self, name: Name, symbol: Symbol, at: TokenIndex) {
        self.declare_here(name, symbol, at);
    }

    /// Declares a name in the innermost scope, unless it is there already.
    fn declare_here(&mut self, name: Name, symbol: Symbol, at: TokenIndex) -> Option<()> {
        match self.scopes.find_here(name) {
            None => {
                self.scopes.declare(name, symbol, at);
                Some(())
            }
            Some(Symbol::Wrong) => None,
            Some(_) => {
                self.redeclared(name, Extent::of(at));
                None
            }
        }
    }

    pub(super) fn redeclared(&mut self, name: Name, at: Extent) {
        let message = format!("`{}` is already declared in this scope", self.text(name));
        let mut diagnostic = Diagnostic::error("redeclared", message);
        let first = self.scopes.declared_at(name);
        if let Some(span) = first.and_then(|first| self.places.span(Extent::of(first))) {
            diagnostic = diagnostic.note(span, "it is declared here first");
        }
        self.report(diagnostic, at);
    }

    /// Reports names that are reserved, §3.8.
    pub(super) fn check_name(&mut self, name: Name, at: Extent) {
        if (at.first as usize) < self.options.host_tokens {
            return;
        }
        let text = self.text(name);
        let reserved = ["gl_", "webgl_", "_webgl_"];
        let message = if let Some(prefix) = reserved.iter().find(|&&one| text.starts_with(one)) {
            format!("`{text}`: names that begin with `{prefix}` are reserved")
        } else if text.as_bytes().windows(2).any(|pair| pair == b"__") {
            format!("`{text}`: names with two underscores in a row are reserved")
        } else {
            return;
        };
        self.error_with_hint("reserved-name", message, at, "choose another name");
    }
}
