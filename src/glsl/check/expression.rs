//! Expressions, §5: names, literals, members and elements. Operators have their own file.

use super::{Checker, Detail, Typed};
use crate::glsl::arena::Id;
use crate::glsl::builtins::constants;
use crate::glsl::hir::{self, ExprKind, GlobalKind, Swizzle, Value};
use crate::glsl::names::Name;
use crate::glsl::syntax::ast::{self, Callee, Extent};
use crate::glsl::types::{Base, Field, Scalar, Struct, Type};

use super::scope::Symbol;

/// A variable or constant.
const LEAF: Detail = Detail {
    height: 0,
    has_effects: false,
};

impl Checker<'_> {
    /// Checks an expression. `None` when it is wrong, which has been reported then.
    pub(super) fn expression(&mut self, id: Id<ast::Expr>) -> Option<Typed> {
        let ast = self.ast;
        let expr = &ast.exprs[id];
        let extent = expr.extent;
        match &expr.kind {
            ast::ExprKind::Name(name) => self.variable(*name, extent),
            ast::ExprKind::Bool(value) => {
                Some(self.constant(Type::BOOL, &[Value::Bool(*value)], extent))
            }
            ast::ExprKind::Int(value) => {
                Some(self.constant(Type::INT, &[Value::Int(*value)], extent))
            }
            ast::ExprKind::Uint(value) => {
                Some(self.constant(Type::UINT, &[Value::Uint(*value)], extent))
            }
            ast::ExprKind::Float(value) => {
                let value = self.options.precision.round(*value);
                Some(self.constant(Type::FLOAT, &[Value::Float(value)], extent))
            }
            ast::ExprKind::Unary(op, operand) => self.unary(*op, *operand, expr),
            ast::ExprKind::Increment {
                place,
                down,
                prefix,
            } => self.increment(*place, *down, *prefix, expr),
            ast::ExprKind::Binary(op, left, right) => self.binary(*op, *left, *right, expr),
            ast::ExprKind::Assign(op, place, value) => self.assign(*op, *place, *value, expr),
            ast::ExprKind::Ternary(condition, yes, no) => self.ternary(*condition, *yes, *no, expr),
            ast::ExprKind::Comma(left, right) => self.comma(*left, *right, expr),
            ast::ExprKind::Index(base, index) => self.index(*base, *index, expr),
            ast::ExprKind::Member(base, name) => self.member(*base, *name, expr),
            ast::ExprKind::Call(Callee::Name(name), arguments) => {
                self.call(*name, ast.arguments.get(*arguments), expr)
            }
            ast::ExprKind::Call(Callee::Type(ty), arguments) => {
                self.construct_written(&ast.types[*ty], ast.arguments.get(*arguments), expr)
            }
            ast::ExprKind::Call(Callee::Method(base, name), arguments) => {
                self.method(*base, *name, ast.arguments.get(*arguments), expr)
            }
        }
    }

    fn variable(&mut self, name: Name, extent: Extent) -> Option<Typed> {
        match self.scopes.find(name) {
            Some(Symbol::Local(local)) => {
                let ty = self.function.locals[local].ty;
                self.named.insert(local);
                Some(self.add(ExprKind::Local(local), ty, extent, LEAF))
            }
            Some(Symbol::Global(global)) => self.global(global, extent),
            Some(Symbol::BlockMember(global, field)) => {
                let block = self.global(global, extent)?;
                Some(self.field(block, field, extent))
            }
            Some(Symbol::Constant(ty, id)) => Some(self.constant_of(ty, id, extent)),
            Some(Symbol::Wrong) => None,
            Some(Symbol::Struct(_) | Symbol::Block) => {
                let message = format!("`{}` is a type, a value is expected here", self.text(name));
                self.error("syntax", message, extent);
                None
            }
            Some(Symbol::Function) => {
                let message = format!("`{0}` is a function: call it, `{0}(…)`", self.text(name));
                self.error("unknown-variable", message, extent);
                None
            }
            None => self.builtin_variable(name, extent),
        }
    }

    fn global(&mut self, id: Id<hir::Global>, extent: Extent) -> Option<Typed> {
        let global = &self.hir.globals[id];
        let ty = global.ty;
        if global.kind == GlobalKind::Input {
            let name = self.text(global.name).to_owned();
            self.error_with_hint(
                "unlinked-input",
                format!("the input `{name}` is read, but no vertex shader writes it"),
                extent,
                "a full-screen pass has no inputs but the position: use `gl_FragCoord`",
            );
            return None;
        }
        Some(self.add(ExprKind::Global(id), ty, extent, LEAF))
    }

    /// `gl_FragCoord` and its like, declared when they are first used.
    fn builtin_variable(&mut self, name: Name, extent: Extent) -> Option<Typed> {
        let text = self.text(name);
        if let Some(value) = constants::constant(text) {
            return Some(self.constant(Type::INT, &[Value::Int(value)], extent));
        }
        if text == "gl_DepthRange" {
            return Some(self.depth_range(extent));
        }
        let Some((ty, kind)) = constants::Variable::find(text).map(|found| (found.ty, found.kind))
        else {
            let message = format!("`{text}` is not declared");
            let hint = match (old_name(text), self.similar_name(name)) {
                (Some(hint), _) => Some(hint.to_owned()),
                (None, Some(similar)) => Some(format!("did you mean `{similar}`?")),
                (None, None) => None,
            };
            match hint {
                Some(hint) => self.error_with_hint("unknown-variable", message, extent, hint),
                None => self.error("unknown-variable", message, extent),
            }
            return None;
        };
        let known = self
            .hir
            .globals
            .iter()
            .find(|(_, global)| global.kind == kind);
        let id = match known {
            Some((id, _)) => id,
            None => self.hir.globals.add(hir::Global {
                name,
                ty,
                kind,
                at: None,
                written: false,
            }),
        };
        Some(self.add(ExprKind::Global(id), ty, extent, LEAF))
    }

    /// `gl_DepthRange`, which no host here ever sets, §7.4.
    fn depth_range(&mut self, extent: Extent) -> Typed {
        let (name, members) = constants::DEPTH_RANGE;
        let name = self.hir.names.intern(name);
        let known = self
            .hir
            .structs
            .iter()
            .find(|(_, found)| found.name == Some(name));
        let id = match known {
            Some((id, _)) => id,
            None => {
                let fields = members.map(|(member, _)| Field {
                    name: self.hir.names.intern(member),
                    ty: Type::FLOAT,
                });
                let structure = Struct::new(Some(name), fields.into(), &self.hir.structs);
                self.hir.structs.add(structure)
            }
        };
        let values = members.map(|(_, value)| Value::Float(value));
        self.constant(Type::of(Base::Struct(id)), &values, extent)
    }

    fn field(&mut self, base: Typed, index: u32, extent: Extent) -> Typed {
        let Base::Struct(id) = base.ty.base else {
            unreachable!("only structures have members");
        };
        let ty = self.hir.structs[id].fields[index as usize].ty;
        match base.value {
            Some(value) => {
                let before = self.hir.structs[id].fields[..index as usize].iter();
                let start = before.map(|field| self.hir.value_count(field.ty)).sum();
                let len = self.hir.value_count(ty);
                let part = self.hir.constants.part(value, start, len);
                self.constant_of(ty, part, extent)
            }
            None => {
                let kind = ExprKind::Member(base.id, index);
                self.add_over(kind, ty, extent, &[base], false)
            }
        }
    }

    fn member(&mut self, base: Id<ast::Expr>, name: Name, expr: &ast::Expr) -> Option<Typed> {
        let base = self.expression(base)?;
        let at = Extent::of(expr.at);
        if base.ty.is_array() {
            let spelled = self.text(name);
            let message = format!("an array has no member `{spelled}`");
            let hint = "its number of elements is `.length()`; members of an element need an index";
            self.error_with_hint("unknown-field", message, at, hint);
            return None;
        }
        match base.ty.base {
            Base::Vector(scalar, size) => {
                let swizzle = match read_swizzle(self.text(name), size) {
                    Ok(swizzle) => swizzle,
                    Err((message, "")) => {
                        self.error("unknown-field", message, at);
                        return None;
                    }
                    Err((message, hint)) => {
                        self.error_with_hint("unknown-field", message, at, hint);
                        return None;
                    }
                };
                let ty = Type::vector(scalar, swizzle.len);
                Some(self.swizzled(base, swizzle, ty, expr.extent))
            }
            Base::Struct(id) => match self.hir.structs[id].field(name) {
                Some((index, _)) => Some(self.field(base, index, expr.extent)),
                None => {
                    let (ty, spelled) = (self.spell(base.ty), self.text(name));
                    let message = format!("the structure `{ty}` has no member `{spelled}`");
                    let fields = self.hir.structs[id].fields.iter();
                    let names: Vec<&str> = fields.map(|field| self.text(field.name)).collect();
                    let hint = format!("it has {}", list(&names));
                    self.error_with_hint("unknown-field", message, at, hint);
                    None
                }
            },
            _ => {
                let (ty, spelled) = (self.spell_one(base.ty), self.text(name));
                let message = format!("{ty} has no member `{spelled}`");
                let hint = "only vectors and structures have members";
                self.error_with_hint("unknown-field", message, at, hint);
                None
            }
        }
    }

    fn swizzled(&mut self, base: Typed, swizzle: Swizzle, ty: Type, extent: Extent) -> Typed {
        if let Some(operand) = self.operand(base) {
            let values: Vec<Value> = swizzle
                .as_slice()
                .iter()
                .map(|&component| operand.values[usize::from(component)])
                .collect();
            return self.constant(ty, &values, extent);
        }
        // A swizzle of a swizzle is one swizzle.
        let (id, swizzle) = match self.function.exprs[base.id].kind {
            ExprKind::Swizzle(inner, before) if !self.repeats(before) => {
                let mut composed = swizzle;
                for component in &mut composed.components[..usize::from(swizzle.len)] {
                    *component = before.components[usize::from(*component)];
                }
                (inner, composed)
            }
            _ => (base.id, swizzle),
        };
        let inner = Typed { id, ..base };
        self.add_over(ExprKind::Swizzle(id, swizzle), ty, extent, &[inner], false)
    }

    /// Whether a swizzle has a component twice, and so cannot be assigned to.
    pub(super) fn repeats(&self, swizzle: Swizzle) -> bool {
        let all = swizzle.as_slice();
        (1..all.len()).any(|i| all[..i].contains(&all[i]))
    }

    fn index(
        &mut self,
        base: Id<ast::Expr>,
        index: Id<ast::Expr>,
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let base = self.expression(base);
        let index_extent = self.ast.exprs[index].extent;
        let index = self.expression(index);
        let (base, index) = (base?, index?);
        let length = match (base.ty.array, base.ty.base) {
            (Some(length), _) => length.get(),
            (None, Base::Vector(_, size)) => u32::from(size),
            (None, Base::Matrix { columns, .. }) => u32::from(columns),
            _ => {
                let message = format!("{} has no elements to choose from", self.spell_one(base.ty));
                self.error("not-indexable", message, expr.extent);
                return None;
            }
        };
        let ty = match (base.ty.array, base.ty.base) {
            (None, Base::Vector(scalar, _)) => Type::vector(scalar, 1),
            (None, Base::Matrix { rows, .. }) => Type::vector(Scalar::Float, rows),
            _ => base.ty.element(),
        };
        if index.ty != Type::INT && index.ty != Type::UINT {
            let message = format!(
                "an index must be `int` or `uint`, not `{}`",
                self.spell(index.ty)
            );
            self.error("bad-index", message, index_extent);
            return None;
        }
        let last = self.last_of_comma(index);
        if let Some(number) = self.integer(last) {
            // As the specification's signed numbers: a huge `uint` is a negative index.
            let number = number as i32;
            if number < 0 || number.unsigned_abs() >= length {
                let message = format!("the index {number} is out of range: there are {length}");
                let hint = format!("0 to {} are there", length - 1);
                self.error_with_hint("index-out-of-range", message, index_extent, hint);
                return None;
            }
        }
        let Some(number) = self.integer(index).map(|number| number as u32) else {
            if self.holds_sampler(base.ty) && base.ty.is_array() {
                self.error_with_hint(
                    "bad-index",
                    "samplers in an array can only be chosen by a constant index",
                    index_extent,
                    "use `if` or `switch` with a constant index in each branch",
                );
                return None;
            }
            let kind = ExprKind::Index(base.id, index.id);
            return Some(self.add_over(kind, ty, expr.extent, &[base, index], false));
        };
        if let Some(value) = base.value {
            let len = self.hir.value_count(ty);
            let part = self.hir.constants.part(value, number * len, len);
            return Some(self.constant_of(ty, part, expr.extent));
        }
        let kind = ExprKind::Index(base.id, index.id);
        Some(self.add_over(kind, ty, expr.extent, &[base, index], false))
    }

    /// The value that a comma expression ends with.
    fn last_of_comma(&self, mut of: Typed) -> Typed {
        while let ExprKind::Comma(_, right) = self.function.exprs[of.id].kind {
            let value = match self.function.exprs[right].kind {
                ExprKind::Constant(value) => Some(value),
                _ => None,
            };
            of = Typed {
                id: right,
                ty: of.ty,
                value,
            };
        }
        of
    }

    /// `.length()`, the only method there is.
    fn method(
        &mut self,
        base: Id<ast::Expr>,
        name: Name,
        arguments: &[Id<ast::Expr>],
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let base = self.expression(base)?;
        let at = Extent::of(expr.at);
        if self.text(name) != "length" {
            let message = format!("there is no method `{}`", self.text(name));
            self.error_with_hint(
                "unknown-method",
                message,
                at,
                "`.length()` of arrays is all",
            );
            return None;
        }
        if !arguments.is_empty() {
            self.error(
                "unknown-method",
                "`.length()` takes no arguments",
                expr.extent,
            );
            return None;
        }
        let Some(length) = base.ty.array else {
            let message = format!("{} has no `.length()`", self.spell_one(base.ty));
            let hint = "only arrays have; the length of a vector in space is `length(v)`";
            self.error_with_hint("unknown-method", message, at, hint);
            return None;
        };
        let value = Value::Int(length.get() as i32);
        if !self.has_effects(base) {
            return Some(self.constant(Type::INT, &[value], expr.extent));
        }
        let length = self.constant(Type::INT, &[value], expr.extent);
        let kind = ExprKind::Comma(base.id, length.id);
        Some(self.add_over(kind, Type::INT, expr.extent, &[base, length], true))
    }
}

/// Reads a swizzle's letters; else what is wrong with them, and a hint if there is one.
fn read_swizzle(letters: &str, size: u8) -> Result<Swizzle, (String, &'static str)> {
    let mut swizzle = Swizzle {
        len: letters.len() as u8,
        components: [0; 4],
    };
    let mut alphabet = None;
    for (i, letter) in letters.bytes().enumerate() {
        let found = ["xyzw", "rgba", "stpq"]
            .iter()
            .enumerate()
            .find_map(|(set, all)| Some((set, all.bytes().position(|known| known == letter)?)));
        let Some((set, component)) = found.filter(|_| letters.len() <= 4) else {
            let message = format!("a vector has no component `{letters}`");
            return Err((message, "up to four letters of `xyzw`, `rgba` or `stpq`"));
        };
        if alphabet.is_some_and(|known| known != set) {
            let hint = "write all letters from `xyzw`, or all from `rgba`, or all from `stpq`";
            return Err((format!("`{letters}` mixes two alphabets"), hint));
        }
        alphabet = Some(set);
        if component >= usize::from(size) {
            let message = match letters.len() {
                1 => format!("the vector has no component `{letters}`: it has {size}"),
                _ => format!("the vector has {size} components, `{letters}` names another"),
            };
            return Err((message, ""));
        }
        swizzle.components[i] = component as u8;
    }
    Ok(swizzle)
}

/// What to write instead of names that are not of this language.
fn old_name(name: &str) -> Option<&'static str> {
    Some(match name {
        "iGlobalTime" => "its name is `iTime` now",
        "gl_FragColor" => {
            "in GLSL ES 3.00 the colour is what `mainImage` sets as its first parameter"
        }
        _ => return None,
    })
}

/// `a`, `b` and `c`, as prose has it.
pub(super) fn list(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.as_slice() {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
    }
}
