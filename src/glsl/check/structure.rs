//! Structures, §4.1.8, and interface blocks, §4.3.7.

use rustc_hash::FxHashSet;

use super::Checker;
use super::qualifier::Storage;
use super::scope::Symbol;
use super::specifier::Length;
use crate::glsl::arena::{Id, Range};
use crate::glsl::hir::{self, GlobalKind};
use crate::glsl::names::Name;
use crate::glsl::syntax::ast::{
    Declarator, Extent, Members, Qualifier, StructDefinition, TokenIndex,
};
use crate::glsl::types::{Base, Content, Field, Struct, Type};

/// How deep WebGL2 lets structures nest.
const MAX_NESTING: u32 = 4;

/// How deep structures nest at most.
const MAX_DEPTH: u32 = 64;

/// The most members of a structure that are no structures themselves: as many numbers are more than
/// WebGL2 lets a variable have.
const MAX_MEMBERS: u32 = 1 << 14;

/// The most numbers in a structure.
const MAX_VALUES: u32 = 1 << 18;

impl Checker<'_> {
    /// Declares a structure that is defined here.
    pub(super) fn structure(&mut self, definition: &StructDefinition) -> Option<Base> {
        let at = Extent::of(definition.at);
        if std::mem::replace(&mut self.in_structure, true) {
            let message = "a structure cannot be defined within another";
            self.error_with_hint("struct", message, at, "define it before");
        }
        let fields = self.fields(&definition.members, false);
        self.in_structure = false;
        let id = self.add_structure(definition.name, fields?, at)?;
        if let Some(name) = definition.name {
            self.check_name(name, at);
            match self.scopes.find_here(name) {
                None => self.scopes.declare(name, Symbol::Struct(id), definition.at),
                Some(Symbol::Wrong) => {}
                Some(_) => self.redeclared(name, at),
            }
        }
        Some(Base::Struct(id))
    }

    /// Adds a structure, unless it is so large that code for its members would be.
    fn add_structure(
        &mut self,
        name: Option<Name>,
        fields: Vec<Field>,
        at: Extent,
    ) -> Option<Id<Struct>> {
        let structure = Struct::new(name, fields, &self.hir.structs);
        let Content {
            values, members, ..
        } = structure.content;
        if members > MAX_MEMBERS || values > MAX_VALUES {
            let message = match members > MAX_MEMBERS {
                true => format!("the structure has more than {MAX_MEMBERS} members"),
                false => format!("the structure has more than {MAX_VALUES} components"),
            };
            let hint = "those of structures within it count too: use arrays of numbers instead";
            self.error_with_hint("too-large", message, at, hint);
            return None;
        }
        Some(self.hir.structs.add(structure))
    }

    /// The members of a structure or block.
    fn fields(&mut self, members: &[Members], is_block: bool) -> Option<Vec<Field>> {
        let mut fields = Vec::new();
        let mut seen = FxHashSet::default();
        let mut is_fine = true;
        for group in members {
            let qualifiers = self.member_qualifiers(group.ty.qualifiers, is_block);
            let resolved = self.resolve(&group.ty.ty);
            let Some((base, length)) = resolved else {
                is_fine = false;
                continue;
            };
            self.check_precision(qualifiers, base, group.ty.ty.extent);
            for declarator in self.ast.declarators.get(group.declarators) {
                match self.field_of(base, length, declarator) {
                    Some(field) => {
                        if !seen.insert(field.name) {
                            let name = self.text(field.name).to_owned();
                            let message = format!("there is another member `{name}`");
                            self.error("redeclared", message, Extent::of(declarator.at));
                        }
                        fields.push(field);
                    }
                    None => is_fine = false,
                }
            }
        }
        is_fine.then_some(fields)
    }

    fn field_of(&mut self, base: Base, length: Length, declarator: &Declarator) -> Option<Field> {
        let at = Extent::of(declarator.at);
        self.check_name(declarator.name, at);
        let length = self.length(declarator.sizes, length)?;
        if base == Base::Void {
            self.error("void", "a member cannot be `void`", at);
            return None;
        }
        let Some(ty) = Self::closed(base, length, None) else {
            self.error("array-size", "a member that is an array needs a size", at);
            return None;
        };
        let depth = Content::of(ty, &self.hir.structs).depth;
        if depth >= MAX_DEPTH {
            let message = format!("structures nest more than {MAX_DEPTH} deep");
            self.error_with_hint("too-deep", message, at, "move a member up");
            return None;
        }
        if depth >= MAX_NESTING {
            self.refused_by_webgl(
                "webgl-limit",
                format!("structures nest more than {MAX_NESTING} deep"),
                at,
                "move a member up",
            );
        }
        Some(Field {
            name: declarator.name,
            ty,
        })
    }

    /// `uniform Name { … } instance;`
    pub(super) fn block(
        &mut self,
        qualifiers: Range<Qualifier>,
        name: Name,
        at: TokenIndex,
        members: &[Members],
        instance: Option<&Declarator>,
    ) {
        let extent = Extent::of(at);
        let found = self.variable_qualifiers(qualifiers);
        self.check_name(name, extent);
        if found.storage != Storage::Uniform {
            self.error(
                "qualifier",
                "a block of variables must be `uniform`",
                extent,
            );
            return;
        }
        self.check_block_layout(&found.layout);
        let outer = std::mem::replace(&mut self.in_structure, true);
        let fields = self.fields(members, true);
        self.in_structure = outer;
        // The block's name is one of the global scope's, although nothing can be done with it.
        self.declare_global(name, Symbol::Block, at);
        let Some(fields) = fields else {
            return;
        };
        if fields.iter().any(|field| self.holds_sampler(field.ty)) {
            self.error("sampler", "a block cannot hold samplers", extent);
            return;
        }
        let names: Vec<(Name, TokenIndex)> = members
            .iter()
            .flat_map(|group| self.ast.declarators.get(group.declarators))
            .map(|one| (one.name, one.at))
            .collect();
        let Some(id) = self.add_structure(Some(name), fields, extent) else {
            return;
        };
        let mut ty = Type::of(Base::Struct(id));
        if let Some(instance) = instance
            && !instance.sizes.is_empty()
        {
            let Some(Length::Of(length)) = self.length(instance.sizes, Length::None) else {
                return;
            };
            ty = ty.array_of(length);
        }
        let (shown, shown_at) = instance.map_or((name, at), |one| (one.name, one.at));
        let global = self.hir.globals.add(hir::Global {
            name: shown,
            ty,
            kind: GlobalKind::Uniform,
            at: Some(shown_at),
            written: false,
        });
        match instance {
            Some(instance) => {
                self.check_name(instance.name, Extent::of(instance.at));
                self.declare_global(instance.name, Symbol::Global(global), instance.at);
            }
            None => {
                for (index, &(name, at)) in names.iter().enumerate() {
                    let member = Symbol::BlockMember(global, index as u32);
                    self.declare_global(name, member, at);
                }
            }
        }
    }
}
