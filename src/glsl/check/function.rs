//! Functions, §6.1: their headers, bodies, and who calls whom.

use rustc_hash::FxHashMap;

use super::flow::Flow;
use super::qualifier::Storage;
use super::scope::Symbol;
use super::specifier::Length;
use super::{Checker, Types, no_operands};
use crate::glsl::arena::{Arena, Id};
use crate::glsl::hir::{self, Direction};
use crate::glsl::names::Name;
use crate::glsl::syntax::ast::{self, Extent, Header, StmtKind, TokenIndex, TypeKind};
use crate::glsl::types::{Base, Type};

/// How many parameters WebGL2 and SPIR-V let a function have.
const MAX_PARAMETERS: usize = 255;

/// How deep WebGL2 lets calls go.
const MAX_CALL_DEPTH: u32 = 256;

/// How many functions of a circle of calls are named.
const LONGEST_CHAIN: usize = 8;

/// A function as its declarations have it.
#[derive(Clone, Debug)]
pub(super) struct Signature {
    pub name: Name,
    pub at: TokenIndex,
    pub id: Id<hir::Function>,
    pub result: Type,
    parameters: Vec<Parameter>,
    is_defined: bool,
}

#[derive(Clone, Copy, Debug)]
struct Parameter {
    ty: Type,
    direction: Direction,
    is_const: bool,
    name: Option<Name>,
    at: TokenIndex,
}

impl Signature {
    /// How a parameter is passed.
    pub fn direction(&self, parameter: usize) -> Direction {
        self.parameters[parameter].direction
    }
}

/// A function that does nothing yet.
pub(super) fn empty() -> hir::Function {
    hir::Function {
        name: Name::default(),
        at: 0,
        result: Type::VOID,
        parameters: Vec::new(),
        locals: Arena::default(),
        exprs: Arena::default(),
        operands: no_operands(),
        body: Vec::new(),
    }
}

impl Checker<'_> {
    /// A function as the author would declare it.
    pub(super) fn spell_signature(&self, signature: &Signature) -> String {
        let parameters: Vec<String> = signature
            .parameters
            .iter()
            .map(|parameter| {
                let direction = match parameter.direction {
                    Direction::In => "",
                    Direction::Out => "out ",
                    Direction::InOut => "inout ",
                };
                format!("{direction}{}", self.spell(parameter.ty))
            })
            .collect();
        let (result, name) = (self.spell(signature.result), self.text(signature.name));
        format!("{result} {name}({})", parameters.join(", "))
    }

    /// Declares a function by its header.
    pub(super) fn function_header(&mut self, header: &Header) -> Option<usize> {
        let at = Extent::of(header.at);
        let result = self.result_type(header);
        let parameters: Vec<Option<Parameter>> = header
            .parameters
            .iter()
            .map(|parameter| self.parameter(parameter))
            .collect();
        self.check_name(header.name, at);
        if let Some(builtin) = self.builtin(header.name)
            && !builtin.can_be_overloaded_by_user()
        {
            let message = format!("`{}` is a function of the language", builtin.name());
            self.error_with_hint("redeclared", message, at, "choose another name");
        }
        match self.scopes.find(header.name) {
            Some(Symbol::Function | Symbol::Wrong) => {}
            None => self
                .scopes
                .declare(header.name, Symbol::Function, header.at),
            Some(_) => self.redeclared(header.name, at),
        }
        let result = result?;
        let parameters: Option<Vec<Parameter>> = parameters.into_iter().collect();
        let parameters = parameters?;
        let is_main = self.text(header.name) == "main";
        if is_main && !parameters.is_empty() {
            self.error("main", "`main` takes no parameters", at);
        }
        if is_main && result != Type::VOID {
            self.error("main", "`main` returns nothing", at);
        }
        let types: Types = parameters.iter().map(|parameter| parameter.ty).collect();
        let key = (header.name, types);
        if let Some(&index) = self.overloads.get(&key) {
            self.check_redeclaration(index, result, &parameters, at);
            self.signatures[index].parameters = parameters;
            return Some(index);
        }
        let id = self.hir.functions.add(hir::Function {
            name: header.name,
            at: header.at,
            ..empty()
        });
        if is_main {
            self.hir.main = Some(id);
        }
        let index = self.signatures.len();
        self.overloads.insert(key, index);
        self.signatures.push(Signature {
            name: header.name,
            at: header.at,
            id,
            result,
            parameters,
            is_defined: false,
        });
        Some(index)
    }

    fn result_type(&mut self, header: &Header) -> Option<Type> {
        let at = Extent::of(header.at);
        let qualifiers = self.variable_qualifiers(header.result.qualifiers);
        if qualifiers.storage != Storage::Plain || !qualifiers.layout.is_empty() {
            let message = "the result of a function has no qualifiers but a precision";
            self.error("qualifier", message, at);
        }
        let (base, length) = self.resolve(&header.result.ty)?;
        self.check_precision(qualifiers.precision, base, header.result.ty.extent);
        if self.holds_sampler(base.into()) {
            self.error("sampler", "a function cannot return a sampler", at);
            return None;
        }
        match (base, length) {
            (Base::Void, Length::Of(_)) => {
                self.error("void", "there are no arrays of `void`", at);
                None
            }
            (_, Length::Open) => {
                self.error("array-size", "a returned array needs a size", at);
                None
            }
            (base, length) => Self::closed(base, length, None),
        }
    }

    fn parameter(&mut self, parameter: &ast::Parameter) -> Option<Parameter> {
        let at = Extent::of(parameter.at);
        let (storage, is_const, precision) = self.parameter_qualifiers(parameter.ty.qualifiers);
        if let Some(name) = parameter.name {
            self.check_name(name, at);
        }
        if matches!(parameter.ty.ty.kind, TypeKind::Struct(_)) {
            let message = "a structure cannot be defined in a parameter";
            self.error_with_hint("struct", message, at, "define it above");
            return None;
        }
        let (base, length) = self.resolve(&parameter.ty.ty)?;
        self.check_precision(precision, base, parameter.ty.ty.extent);
        let length = self.length(parameter.sizes, length)?;
        if base == Base::Void {
            self.error("void", "a parameter cannot be `void`", at);
            return None;
        }
        let direction = match storage {
            Storage::Out => Direction::Out,
            Storage::InOut => Direction::InOut,
            _ => Direction::In,
        };
        if direction != Direction::In && matches!(base, Base::Sampler(_)) {
            self.error("sampler", "a sampler cannot be an `out` parameter", at);
            return None;
        }
        let Some(ty) = Self::closed(base, length, None) else {
            self.error(
                "array-size",
                "a parameter that is an array needs a size",
                at,
            );
            return None;
        };
        Some(Parameter {
            ty,
            direction,
            is_const: is_const && !matches!(base, Base::Sampler(_)),
            name: parameter.name,
            at: parameter.at,
        })
    }

    fn check_redeclaration(
        &mut self,
        index: usize,
        result: Type,
        parameters: &[Parameter],
        at: Extent,
    ) {
        let known = &self.signatures[index];
        let mut pairs = known.parameters.iter().zip(parameters);
        let differs = pairs.any(|(a, b)| (a.direction, a.is_const) != (b.direction, b.is_const));
        let has_other_result = known.result != result;
        let spelled = self.spell_signature(known);
        if has_other_result {
            let message = format!("the function was declared before as `{spelled}`");
            self.error("redeclared", message, at);
        } else if differs {
            let message =
                format!("the function was declared before as `{spelled}`, with other qualifiers");
            let hint = "`in`, `out`, `inout` and `const` must be the same in all declarations";
            self.error_with_hint("redeclared", message, at, hint);
        }
    }

    /// Checks a function with its body.
    pub(super) fn function_definition(&mut self, header: &Header, body: Id<ast::Stmt>) {
        let index = self.function_header(header);
        let at = Extent::of(header.at);
        if let Some(index) = index {
            let signature = &mut self.signatures[index];
            if std::mem::replace(&mut signature.is_defined, true) {
                let name = self.text(header.name).to_owned();
                let message = format!("the function `{name}` has a body already");
                self.error("redeclared", message, at);
            }
            self.signatures[index].at = header.at;
        }
        let parameters = index.map_or(Vec::new(), |index| {
            self.signatures[index].parameters.clone()
        });
        let result = index.map_or(Type::VOID, |index| self.signatures[index].result);
        let outer = std::mem::replace(
            &mut self.function,
            hir::Function {
                name: header.name,
                at: header.at,
                result,
                parameters: parameters.iter().map(|one| one.direction).collect(),
                ..empty()
            },
        );
        self.first_detail = self.details.len();
        // A function with a wrong header is checked for the sake of its body's errors.
        self.current = Some(index.unwrap_or(usize::MAX));
        self.returns_value = index.is_none();
        let outer_flow = std::mem::replace(&mut self.flow, Flow::of_function());
        self.constant_parameters.clear();
        self.named.clear();
        self.initialised.clear();
        self.scopes.open();
        for parameter in &parameters {
            self.declare_parameter(parameter);
        }
        if index.is_none() {
            for parameter in &header.parameters {
                if let Some(name) = parameter.name {
                    self.scopes.declare(name, Symbol::Wrong, parameter.at);
                }
            }
        }
        if parameters.len() > MAX_PARAMETERS {
            let message = format!("a function has more than {MAX_PARAMETERS} parameters");
            self.error_with_hint("too-large", message, at, "put some into a structure");
        }
        let mut block = Vec::new();
        if let StmtKind::Block(statements) = self.ast.stmts[body].kind {
            let statements = self.ast.bodies.get(statements);
            block.reserve(statements.len());
            // An expression has two tokens or so.
            let Extent { first, last } = self.ast.stmts[body].extent;
            let expressions = (last - first).min(1 << 16) as usize / 2;
            self.function.exprs.reserve(expressions);
            self.details.reserve(expressions);
            for &statement in statements {
                self.statement(statement, &mut block);
            }
        }
        self.close_scope();
        if result != Type::VOID && !self.returns_value {
            let message = format!("the function `{}` returns nothing", self.text(header.name));
            let hint = format!("it needs a `return` with {}", self.spell_one(result));
            self.error_with_hint("missing-return", message, at, hint);
        } else if result != Type::VOID && self.errors == 0 {
            // Where something is wrong, a `return` may be missing for that alone.
            self.warn_about_missing_returns(&block, at);
        }
        self.warn_about_unset_variables(parameters.len());
        self.check_pending_loops();
        self.check_complexity(at);
        self.current = None;
        self.flow = outer_flow;
        self.details.truncate(self.first_detail);
        self.first_detail = 0;
        let mut function = std::mem::replace(&mut self.function, outer);
        function.body = block;
        if let Some(index) = index {
            let id = self.signatures[index].id;
            self.hir.functions[id] = function;
        }
    }

    /// Warns about variables that are read although nothing sets them.
    fn warn_about_unset_variables(&mut self, parameters: usize) {
        let unset: Vec<_> = self
            .function
            .locals
            .iter()
            .skip(parameters)
            .filter(|(id, local)| {
                !local.written && self.named.contains(*id) && !self.initialised.contains(*id)
            })
            .filter_map(|(_, local)| Some((local.name?, local.at)))
            .collect();
        for (name, at) in unset {
            let message = format!("nothing ever sets the variable `{}`", self.text(name));
            let hint = "it is zero here and in browsers, but anything elsewhere";
            self.warn("unset-variable", message, Extent::of(at), hint);
        }
    }

    fn declare_parameter(&mut self, parameter: &Parameter) {
        let id = self.function.locals.add(hir::Local {
            name: parameter.name,
            ty: parameter.ty,
            written: false,
            at: parameter.at,
        });
        if parameter.is_const {
            self.constant_parameters.insert(id);
        }
        self.check_size(parameter.ty, Extent::of(parameter.at));
        if let Some(name) = parameter.name {
            match self.scopes.find_here(name) {
                None => self.scopes.declare(name, Symbol::Local(id), parameter.at),
                Some(_) => self.redeclared(name, Extent::of(parameter.at)),
            }
        }
    }

    /// Ends the function that sets globals.
    pub(super) fn finish_globals(&mut self) {
        self.check_pending_loops();
        let mut function = std::mem::replace(&mut self.function, empty());
        if !function.body.is_empty() {
            function.name = self.hir.names.intern("initialise_globals");
            self.hir.initialisers = Some(self.hir.functions.add(function));
        }
    }

    /// Reports recursion, calls of functions without a body, and calls that go too deep.
    pub(super) fn check_calls(&mut self) {
        let mut callees: Vec<Vec<usize>> = vec![Vec::new(); self.signatures.len()];
        let mut calls: Vec<_> = self.calls.iter().map(|(&call, &at)| (call, at)).collect();
        calls.sort_unstable_by_key(|&(_, at)| at.first);
        let global_calls = std::mem::take(&mut self.global_calls);
        let undefined = calls
            .iter()
            .map(|&((_, callee), at)| (callee, at))
            .chain(global_calls);
        for (callee, at) in undefined.collect::<Vec<_>>() {
            if !self.signatures[callee].is_defined {
                let name = self.text(self.signatures[callee].name).to_owned();
                let message = format!("the function `{name}` is declared but has no body");
                self.error("no-body", message, at);
            }
        }
        for &((caller, callee), _) in &calls {
            if let Some(list) = callees.get_mut(caller) {
                list.push(callee);
            }
        }
        self.check_recursion(&callees);
    }

    fn check_recursion(&mut self, callees: &[Vec<usize>]) {
        #[derive(Clone, Copy, PartialEq)]
        enum State {
            New,
            Open,
            Done,
        }
        let mut state = vec![State::New; callees.len()];
        let mut depth = vec![0_u32; callees.len()];
        let mut reported: FxHashMap<usize, ()> = FxHashMap::default();
        for root in 0..callees.len() {
            let mut stack = vec![(root, 0)];
            if state[root] != State::New {
                continue;
            }
            state[root] = State::Open;
            while let Some(top) = stack.last_mut() {
                let (function, next) = (top.0, top.1);
                top.1 += 1;
                let Some(&callee) = callees[function].get(next) else {
                    state[function] = State::Done;
                    stack.pop();
                    let deepest = callees[function].iter().map(|&callee| depth[callee]).max();
                    depth[function] = deepest.map_or(1, |deepest| deepest + 1);
                    if depth[function] == MAX_CALL_DEPTH + 1 {
                        let at = Extent::of(self.signatures[function].at);
                        let message = format!("calls go more than {MAX_CALL_DEPTH} deep");
                        self.refused_by_webgl("webgl-limit", message, at, "join some functions");
                    }
                    continue;
                };
                match state[callee] {
                    State::New => {
                        state[callee] = State::Open;
                        stack.push((callee, 0));
                    }
                    State::Open if reported.insert(callee, ()).is_none() => {
                        self.recursion(function, callee, &stack);
                    }
                    _ => {}
                }
            }
        }
    }

    fn recursion(&mut self, caller: usize, callee: usize, stack: &[(usize, usize)]) {
        let name = |index: usize| self.text(self.signatures[index].name);
        let begin = stack.iter().position(|&(function, _)| function == callee);
        let chain = stack[begin.unwrap_or(0)..].iter().map(|&(one, _)| one);
        let mut chain: Vec<&str> = match chain.len() {
            ..=LONGEST_CHAIN => chain.map(name).collect(),
            _ => chain.take(LONGEST_CHAIN).map(name).chain(["…"]).collect(),
        };
        chain.push(name(callee));
        let message = match chain.len() {
            2 => format!("the function `{}` calls itself", name(callee)),
            _ => format!(
                "the function `{}` calls itself: {}",
                name(callee),
                chain.join(" → ")
            ),
        };
        let at = self.calls[&(caller, callee)];
        self.error_with_hint(
            "recursion",
            message,
            at,
            "use a loop; GLSL has no recursion",
        );
    }
}
