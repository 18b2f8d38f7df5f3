//! Calls of functions, §6.1: the author's own and the built-in ones.

use super::scope::Symbol;
use super::{Arguments, Checker, Typed, Types};
use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::fold;
use crate::glsl::hir::{Direction, ExprKind, Value};
use crate::glsl::names::Name;
use crate::glsl::syntax::ast::{self, Extent};
use crate::glsl::types::{Base, Type};

/// How far WebGL2 lets the offset of a texture lookup go, in texels.
const OFFSETS: std::ops::RangeInclusive<i32> = -8..=7;

impl Checker<'_> {
    /// Checks all arguments of a call, whether or not one is wrong.
    pub(super) fn arguments(&mut self, arguments: &[Id<ast::Expr>]) -> Option<Arguments> {
        let mut checked = Arguments::new();
        let mut are_fine = true;
        for &argument in arguments {
            match self.expression(argument) {
                Some(argument) => checked.push(argument),
                None => are_fine = false,
            }
        }
        are_fine.then_some(checked)
    }

    pub(super) fn call(
        &mut self,
        name: Name,
        arguments: &[Id<ast::Expr>],
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let arguments = self.arguments(arguments);
        let at = Extent::of(expr.at);
        let is_function = match self.scopes.find(name) {
            Some(Symbol::Struct(id)) => {
                return self.construct(Type::of(Base::Struct(id)), &arguments?, expr.extent);
            }
            Some(Symbol::Function) => true,
            None => false,
            Some(Symbol::Wrong) => return None,
            Some(_) => {
                let message = format!("`{}` is a variable here, no function", self.text(name));
                let hint = "the variable hides the function of that name: rename one of them";
                self.error_with_hint("not-a-function", message, at, hint);
                return None;
            }
        };
        let arguments = arguments?;
        let types: Types = arguments.iter().map(|argument| argument.ty).collect();
        if is_function {
            let key = (name, types);
            if let Some(&index) = self.overloads.get(&key) {
                return self.call_own(index, &arguments, expr);
            }
            return match self.builtin(name) {
                Some(builtin) => self.call_builtin(builtin, name, &key.1, &arguments, expr),
                None => {
                    self.no_overload(name, &key.1, expr.extent);
                    None
                }
            };
        }
        match self.builtin(name) {
            Some(builtin) => self.call_builtin(builtin, name, &types, &arguments, expr),
            None => self.call_legacy(name, &types, &arguments, expr),
        }
    }

    fn call_own(&mut self, index: usize, arguments: &[Typed], expr: &ast::Expr) -> Option<Typed> {
        let signature = &self.signatures[index];
        let (id, result) = (signature.id, signature.result);
        for (i, &argument) in arguments.iter().enumerate() {
            if self.signatures[index].direction(i) != Direction::In {
                let extent = self.function.exprs[argument.id].extent;
                self.require_place(argument, extent)?;
            }
        }
        if let Some(caller) = self.current {
            self.calls.entry((caller, index)).or_insert(expr.extent);
        } else {
            self.global_calls.push((index, expr.extent));
        }
        let operands = self.operands(arguments);
        let kind = ExprKind::Call(id, operands);
        Some(self.add_over(kind, result, expr.extent, arguments, true))
    }

    /// ES 1.00's names of the texture lookups, where the author has no function of that name.
    fn call_legacy(
        &mut self,
        name: Name,
        types: &[Type],
        arguments: &[Typed],
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let legacy = Builtin::find_legacy(self.text(name));
        let Some((builtin, result)) =
            legacy.and_then(|builtin| Some((builtin, builtin.result(types)?)))
        else {
            self.no_overload(name, types, expr.extent);
            return None;
        };
        let message = format!("`{}` is a name of GLSL ES 1.00", self.text(name));
        let hint = format!("its name is `{}` now", builtin.name());
        self.refused_by_webgl("old-texture-name", message, Extent::of(expr.at), &hint);
        if self.options.strict {
            return None;
        }
        self.finish_builtin(builtin, result, arguments, expr)
    }

    fn call_builtin(
        &mut self,
        builtin: Builtin,
        name: Name,
        types: &[Type],
        arguments: &[Typed],
        expr: &ast::Expr,
    ) -> Option<Typed> {
        let Some(result) = builtin.result(types) else {
            self.no_overload(name, types, expr.extent);
            return None;
        };
        self.finish_builtin(builtin, result, arguments, expr)
    }

    fn finish_builtin(
        &mut self,
        builtin: Builtin,
        result: Type,
        arguments: &[Typed],
        expr: &ast::Expr,
    ) -> Option<Typed> {
        if let Some(index) = builtin.writes() {
            let extent = self.function.exprs[arguments[index].id].extent;
            self.require_place(arguments[index], extent)?;
        }
        if let Some(index) = builtin.offset_argument() {
            self.check_offset(arguments[index])?;
        }
        self.warn_about_values(builtin, arguments, expr.extent);
        let precision = self.options.precision;
        let folded = self
            .constant_operands(arguments)
            .and_then(|constants| fold::builtin(builtin, &constants, result, precision));
        if let Some(values) = folded {
            return Some(self.constant(result, &values, expr.extent));
        }
        let operands = self.operands(arguments);
        let kind = ExprKind::Builtin(builtin, operands);
        let has_effects = builtin.writes().is_some();
        Some(self.add_over(kind, result, expr.extent, arguments, has_effects))
    }

    fn check_offset(&mut self, offset: Typed) -> Option<()> {
        let extent = self.function.exprs[offset.id].extent;
        let Some(value) = offset.value else {
            let message = "the offset of a texture lookup must be a constant expression";
            self.error("not-constant", message, extent);
            return None;
        };
        let values = self.hir.constants.get(value).iter();
        let out = values.copied().find_map(|value| match value {
            Value::Int(texels) if !OFFSETS.contains(&texels) => Some(texels),
            _ => None,
        });
        let Some(texels) = out else { return Some(()) };
        let message = format!("the offset {texels} of a texture lookup is out of range");
        let hint = format!(
            "{} to {} texels are allowed",
            OFFSETS.start(),
            OFFSETS.end()
        );
        self.error_with_hint("index-out-of-range", message, extent, hint);
        None
    }

    /// Warns about arguments for which the specification defines no result.
    fn warn_about_values(&mut self, builtin: Builtin, arguments: &[Typed], extent: Extent) {
        if builtin != Builtin::SmoothStep {
            return;
        }
        let edge = |of: Typed| match self.hir.constants.get(of.value?) {
            [Value::Float(edge), ..] => Some(*edge),
            _ => None,
        };
        if let (Some(low), Some(high)) = (edge(arguments[0]), edge(arguments[1]))
            && low >= high
        {
            // As the author wrote them, more or less.
            let [low, high] = [low, high].map(|edge| edge as f32);
            self.warn(
                "reversed-smoothstep",
                format!(
                    "`smoothstep` from {low} to {high}: the specification leaves this undefined"
                ),
                extent,
                "write `1. - smoothstep(low, high, x)`; here it is computed by the formula",
            );
        }
    }

    /// Reports a call that no function takes.
    fn no_overload(&mut self, name: Name, types: &[Type], extent: Extent) {
        let spelled = self.text(name).to_owned();
        if self.has_enough_errors() {
            return self.error("wrong-arguments", spelled, extent);
        }
        let given: Vec<String> = types.iter().map(|&ty| self.spell(ty)).collect();
        let (candidates, count) = self.candidates(name);
        if candidates.is_empty() {
            let message = format!("there is no function `{spelled}`");
            let hint = match (hint_for(&spelled), self.similar_function(name)) {
                (Some(hint), _) => hint.to_owned(),
                (None, Some(similar)) => format!("did you mean `{similar}`?"),
                (None, None) => {
                    "declare it above its first use, or give a prototype there".to_owned()
                }
            };
            self.error_with_hint("unknown-function", message, extent, hint);
            return;
        }
        let message = format!("no function `{spelled}` takes ({})", given.join(", "));
        let mut hint = format!("there is {}", candidates.join(", "));
        if count > candidates.len() {
            hint += &format!(" and {} more", count - candidates.len());
        }
        self.error_with_hint("wrong-arguments", message, extent, hint);
    }

    /// The first functions of a name, as the author would declare them, and how many there are.
    fn candidates(&self, name: Name) -> (Vec<String>, usize) {
        const SHOWN: usize = 6;
        let own = self.signatures.iter().filter(|one| one.name == name);
        let builtin = Builtin::find(self.text(name));
        let builtin: Vec<_> = builtin.into_iter().flat_map(Builtin::signatures).collect();
        let count = own.clone().count() + builtin.len();
        let own = own.map(|one| format!("`{}`", self.spell_signature(one)));
        let builtin = builtin.iter().map(|text| format!("`{text}`"));
        (own.chain(builtin).take(SHOWN).collect(), count)
    }
}

/// The way out of names that other languages have.
fn hint_for(name: &str) -> Option<&'static str> {
    Some(match name {
        "lerp" => "in GLSL its name is `mix`",
        "frac" => "in GLSL its name is `fract`",
        "saturate" => "write `clamp(x, 0., 1.)`",
        "mul" => "write `a * b`",
        "atan2" => "in GLSL it is `atan(y, x)`",
        "fmod" => "in GLSL there is `mod`, which rounds down",
        "rsqrt" => "in GLSL its name is `inversesqrt`",
        "ddx" => "in GLSL its name is `dFdx`",
        "ddy" => "in GLSL its name is `dFdy`",
        "tex2D" => "in GLSL its name is `texture`",
        "fma" => "GLSL ES 3.00 has none: write `a * b + c`",
        _ => return None,
    })
}
