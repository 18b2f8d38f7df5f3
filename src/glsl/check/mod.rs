//! From the syntax tree to the checked program: names are resolved, types computed, constants folded,
//! and everything that GLSL ES 3.00 or WebGL2 refuses is reported.
//!
//! The rules are those of the specification as ANGLE applies them, because that is what runs in every
//! browser. A few things that WebGL2 refuses although their meaning is clear are warnings unless
//! [`Options::strict`] is set.

mod call;
mod constructor;
mod declaration;
mod ending;
mod expression;
mod flow;
mod function;
mod operator;
mod place;
mod qualifier;
mod scope;
mod size;
mod specifier;
mod statement;
mod structure;
mod suggestion;

use rustc_hash::{FxHashMap, FxHashSet};
use smallvec::SmallVec;

use super::Precision;
use super::arena::{Id, IdSet, Pool};
use super::builtins::Builtin;
use super::fold;
use super::hir::{self, Constant, ExprKind, Hir, Value};
use super::names::Name;
use super::places::Places;
use super::syntax::ast::{self, Ast, Extent};
use super::types::{Base, Content, Type, spell};
use crate::source::Diagnostic;
use flow::Flow;
use function::Signature;
use scope::Scopes;

/// More errors or warnings than this are no help.
const MOST: usize = 100;

/// How to judge.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Whether what only WebGL2 refuses is an error and no warning.
    pub strict: bool,
    /// What constants are computed in.
    pub precision: Precision,
    /// How many of the tokens, from the first, are the host's, which may declare reserved names.
    pub host_tokens: usize,
}

/// The outcome of checking.
#[derive(Debug)]
pub struct Checked {
    /// The program; not to be relied on if any diagnostic is an error.
    pub hir: Hir,
    /// What is wrong, in the order in which it was found.
    pub diagnostics: Vec<Diagnostic>,
}

/// Checks a program.
pub fn check(ast: &mut Ast, places: Places<'_>, options: Options) -> Checked {
    let names = std::mem::take(&mut ast.names);
    let mut checker = Checker {
        ast,
        places,
        options,
        builtins: vec![None; names.count()],
        scopes: Scopes::new(names.count()),
        hir: Hir {
            names,
            ..Hir::default()
        },
        diagnostics: Vec::new(),
        errors: 0,
        warnings: 0,
        function: function::empty(),
        details: Vec::new(),
        first_detail: 0,
        named: IdSet::default(),
        initialised: IdSet::default(),
        constant_parameters: IdSet::default(),
        signatures: Vec::new(),
        overloads: FxHashMap::default(),
        current: None,
        returns_value: false,
        flow: Flow::default(),
        calls: FxHashMap::default(),
        global_calls: Vec::new(),
        private_bytes: 0,
        true_globals: FxHashSet::default(),
        pending_globals: Vec::new(),
        outputs: Vec::new(),
        default_precisions: Vec::new(),
        in_structure: false,
    };
    checker.default_precisions = qualifier::initial_precisions();
    checker.program();
    Checked {
        hir: checker.hir,
        diagnostics: checker.diagnostics,
    }
}

/// The state of checking. What is declared is in `scopes`, what is being built in `hir`.
struct Checker<'a> {
    ast: &'a Ast,
    places: Places<'a>,
    options: Options,
    hir: Hir,
    diagnostics: Vec<Diagnostic>,
    /// How many errors were found, and how many warnings, those not reported included.
    errors: usize,
    warnings: usize,
    /// What each name means as a built-in function, as far as it was asked.
    builtins: Vec<Option<Option<Builtin>>>,
    scopes: Scopes,
    /// The function whose body is being checked; at global scope, the one that sets globals.
    function: hir::Function,
    /// About each expression of `function`, behind what is about globals.
    details: Vec<Detail>,
    /// Where the function's begin.
    first_detail: usize,
    /// Variables of `function` that are named anywhere, and those that begin with a value.
    named: IdSet<hir::Local>,
    initialised: IdSet<hir::Local>,
    /// Parameters of `function` that are `const`.
    constant_parameters: IdSet<hir::Local>,
    /// Every function that was declared.
    signatures: Vec<Signature>,
    /// Functions by name and parameters.
    overloads: FxHashMap<(Name, Types), usize>,
    /// The function whose body is being checked; `None` at global scope.
    current: Option<usize>,
    /// Whether a `return` with a value was seen in it.
    returns_value: bool,
    flow: Flow,
    /// Which function calls which, with the place of the first call.
    calls: FxHashMap<(usize, usize), Extent>,
    /// The calls in initialisers of globals.
    global_calls: Vec<(usize, Extent)>,
    /// Memory of all variables, as WebGL2 adds it up.
    private_bytes: u64,
    /// Global variables that began as `true`, and loops that end only if theirs is written.
    true_globals: FxHashSet<flow::Variable>,
    pending_globals: Vec<(Id<hir::Global>, Extent)>,
    /// The outputs with their locations.
    outputs: Vec<(Id<hir::Global>, Option<u32>)>,
    /// Types with a default precision, and the depth of the scope that gave it.
    default_precisions: Vec<(Base, usize)>,
    /// Whether a structure's members are being checked.
    in_structure: bool,
}

/// Arguments of a call; mostly there are few.
type Arguments = SmallVec<[Typed; 4]>;

/// Their values.
type Operands<'a> = SmallVec<[fold::Operand<'a>; 4]>;

/// Their types.
type Types = SmallVec<[Type; 4]>;

/// What is known about an expression beyond what the [`Hir`] holds.
#[derive(Clone, Copy, Debug)]
struct Detail {
    /// Height of its tree; variables and constants have none, as ANGLE counts.
    height: u32,
    /// Whether evaluating it may change something.
    has_effects: bool,
}

/// A checked expression.
#[derive(Clone, Copy, Debug)]
struct Typed {
    id: Id<hir::Expr>,
    ty: Type,
    /// Its value, if it is a constant expression.
    value: Option<Id<Constant>>,
}

impl<'a> Checker<'a> {
    fn program(&mut self) {
        let ast = self.ast;
        for item in &ast.items {
            match item {
                ast::Item::Function(header, body) => self.function_definition(header, *body),
                ast::Item::Declaration(declaration) => self.global_declaration(declaration),
                ast::Item::Empty(at) => self.refused_by_webgl(
                    "stray-semicolon",
                    "a `;` by itself is not allowed outside of functions".to_owned(),
                    Extent::of(*at),
                    "remove it",
                ),
            }
        }
        self.finish_globals();
        self.check_pending_global_loops();
        self.check_calls();
        self.check_outputs();
        self.check_total_size();
    }

    /// Reports an error.
    fn error(&mut self, code: &'static str, message: impl Into<String>, extent: Extent) {
        let diagnostic = Diagnostic::error(code, message);
        self.report(diagnostic, extent);
    }

    /// Reports a diagnostic, unless there are enough of its kind.
    fn report(&mut self, diagnostic: Diagnostic, extent: Extent) {
        let count = match diagnostic.is_error() {
            true => &mut self.errors,
            false => &mut self.warnings,
        };
        *count += 1;
        if *count <= MOST {
            self.diagnostics.push(self.places.point(diagnostic, extent));
        }
    }

    /// Whether another error would not be reported, so that no effort needs to be made for it.
    fn has_enough_errors(&self) -> bool {
        self.errors >= MOST
    }

    /// Reports an error with a way out.
    fn error_with_hint(
        &mut self,
        code: &'static str,
        message: impl Into<String>,
        extent: Extent,
        hint: impl Into<String>,
    ) {
        let diagnostic = Diagnostic::error(code, message).hint(hint);
        self.report(diagnostic, extent);
    }

    /// Reports something that runs but deserves a look.
    fn warn(
        &mut self,
        code: &'static str,
        message: impl Into<String>,
        extent: Extent,
        hint: impl Into<String>,
    ) {
        let diagnostic = Diagnostic::warning(code, message).hint(hint);
        self.report(diagnostic, extent);
    }

    /// Reports what WebGL2 refuses although its meaning is clear.
    fn refused_by_webgl(
        &mut self,
        code: &'static str,
        message: String,
        extent: Extent,
        hint: &str,
    ) {
        let diagnostic = if self.options.strict {
            Diagnostic::error(code, message).hint(hint)
        } else {
            Diagnostic::warning(code, format!("WebGL2 refuses this: {message}")).hint(hint)
        };
        self.report(diagnostic, extent);
    }

    /// A type as the author would write it.
    fn spell(&self, ty: Type) -> String {
        spell(ty, &self.hir.structs, &self.hir.names)
    }

    /// The same with its article.
    fn spell_one(&self, ty: Type) -> String {
        let spelled = self.spell(ty);
        match spelled.starts_with('i') {
            true => format!("an `{spelled}`"),
            false => format!("a `{spelled}`"),
        }
    }

    fn text(&self, name: Name) -> &str {
        self.hir.names.text(name)
    }

    /// The built-in function of a name.
    fn builtin(&mut self, name: Name) -> Option<Builtin> {
        let known = &mut self.builtins[name.index()];
        *known.get_or_insert_with(|| Builtin::find(self.hir.names.text(name)))
    }

    fn detail(&self, of: Id<hir::Expr>) -> &Detail {
        &self.details[self.first_detail + of.index()]
    }

    /// Whether no function is being checked.
    fn is_global(&self) -> bool {
        self.current.is_none()
    }

    /// Adds an expression to the function.
    fn add(&mut self, kind: ExprKind, ty: Type, extent: Extent, detail: Detail) -> Typed {
        let id = self.function.exprs.add(hir::Expr { kind, ty, extent });
        self.details.push(detail);
        Typed {
            id,
            ty,
            value: None,
        }
    }

    /// An expression of these operands.
    fn add_over(
        &mut self,
        kind: ExprKind,
        ty: Type,
        extent: Extent,
        operands: &[Typed],
        has_effects: bool,
    ) -> Typed {
        let detail = self.detail_over(operands, has_effects);
        self.add(kind, ty, extent, detail)
    }

    fn detail_over(&self, operands: &[Typed], has_effects: bool) -> Detail {
        let details = operands.iter().map(|operand| self.detail(operand.id));
        details.fold(
            Detail {
                height: 1,
                has_effects,
            },
            |sum, one| Detail {
                height: sum.height.max(one.height + 1),
                has_effects: sum.has_effects || one.has_effects,
            },
        )
    }

    /// A constant expression.
    fn constant(&mut self, ty: Type, values: &[Value], extent: Extent) -> Typed {
        let id = self.hir.constants.add(values);
        self.constant_of(ty, id, extent)
    }

    fn constant_of(&mut self, ty: Type, id: Id<Constant>, extent: Extent) -> Typed {
        let leaf = Detail {
            height: 0,
            has_effects: false,
        };
        Typed {
            value: Some(id),
            ..self.add(ExprKind::Constant(id), ty, extent, leaf)
        }
    }

    /// The values of a constant expression, for folding.
    fn operand(&self, of: Typed) -> Option<fold::Operand<'_>> {
        let values = self.hir.constants.get(of.value?);
        Some(fold::Operand { ty: of.ty, values })
    }

    /// A constant `int` or `uint` as a number.
    fn integer(&self, of: Typed) -> Option<i64> {
        match self.hir.constants.get(of.value?) {
            [Value::Int(value)] => Some(i64::from(*value)),
            [Value::Uint(value)] => Some(i64::from(*value)),
            _ => None,
        }
    }

    /// The same of several; `None` unless all are constant.
    fn constant_operands(&self, of: &[Typed]) -> Option<Operands<'_>> {
        // Asked first, so that nothing is collected in vain.
        let all = of.iter().all(|one| one.value.is_some());
        all.then(|| of.iter().filter_map(|&one| self.operand(one)).collect())
    }

    fn has_effects(&self, of: Typed) -> bool {
        self.detail(of.id).has_effects
    }

    fn operands(&mut self, of: &[Typed]) -> hir::Operands {
        self.function.operands.extend(of.iter().map(|one| one.id))
    }

    /// Whether a sampler is or is in a value of this type.
    fn holds_sampler(&self, ty: Type) -> bool {
        Content::of(ty, &self.hir.structs).has_sampler
    }

    /// Whether it is, or is a structure with, an array.
    fn holds_array(&self, ty: Type) -> bool {
        Content::of(ty, &self.hir.structs).has_array
    }
}

/// An empty pool of operands.
fn no_operands() -> Pool<Id<hir::Expr>> {
    Pool::default()
}
