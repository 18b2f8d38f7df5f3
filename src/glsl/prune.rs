//! Finds what a program needs: from `main`, over its calls, to functions and global variables.
//! Helpers that are pasted along but never called shall cost nothing and demand nothing.

use super::arena::{Id, IdSet, Pool, Range};
use super::builtins::Builtin;
use super::double;
use super::hir::{
    Direction, Expr, ExprKind, Function, Global, GlobalKind, Hir, Loop, Stmt, StmtKind, Switch,
};

/// What is needed of a program.
#[derive(Clone, Debug, Default)]
pub struct Reachable {
    /// The functions, each behind those that it calls; `main` is the last.
    pub functions: Vec<Id<Function>>,
    /// The expressions in the body of each.
    rows: Vec<Range<Id<Expr>>>,
    expressions: Pool<Id<Expr>>,
    /// The global variables that they name, in order of declaration.
    pub globals: Vec<Id<Global>>,
    /// Those of the global variables that they may assign to.
    pub written: IdSet<Global>,
    /// Whether [`Hir::initialisers`] sets any of them, and hence must be called.
    pub initialised: bool,
}

impl Reachable {
    /// What `main` needs, if some functions stand for built-in ones.
    ///
    /// # Panics
    /// When the program has no `main`.
    pub fn new(hir: &Hir, built_in: &double::Functions) -> Self {
        let main = hir.main.expect("a checked program has a main");
        let mut search = Search::new(hir, built_in);
        if let Some(initialisers) = hir.initialisers {
            // Its calls may do anything, so it is needed whole or not at all.
            let mut before = Search::new(hir, built_in);
            before.add(initialisers);
            search.add(main);
            if before.written.meets(&search.used) {
                before.add(main);
                before.initialised = true;
                search = before;
            }
        } else {
            search.add(main);
        }
        search.finish()
    }
}

impl Reachable {
    /// Each of the functions with the expressions in its body, operands behind what uses them.
    pub fn bodies(&self) -> impl Iterator<Item = (Id<Function>, &[Id<Expr>])> {
        let rows = self.rows.iter().map(|&row| self.expressions.get(row));
        self.functions.iter().copied().zip(rows)
    }

    /// Every statement of the functions and of [`Hir::initialisers`], in no order.
    pub fn statements<'a>(&self, hir: &'a Hir) -> impl Iterator<Item = &'a Stmt> + use<'a> {
        let functions = self.functions.iter().chain(&hir.initialisers);
        let bodies = functions.flat_map(|&id| &hir.functions[id].body);
        let mut open: Vec<&Stmt> = bodies.collect();
        std::iter::from_fn(move || {
            let stmt = open.pop()?;
            match &stmt.kind {
                StmtKind::Block(body) => open.extend(body),
                StmtKind::If(_, accept, reject) => open.extend(accept.iter().chain(reject)),
                StmtKind::Switch(switch) => {
                    open.extend(switch.arms.iter().flat_map(|arm| &arm.body));
                }
                StmtKind::Loop(inner) => open.extend(&inner.body),
                _ => {}
            }
            Some(stmt)
        })
    }
}

struct Search<'a> {
    hir: &'a Hir,
    built_in: &'a double::Functions,
    seen: IdSet<Function>,
    functions: Vec<Id<Function>>,
    rows: Vec<Range<Id<Expr>>>,
    expressions: Pool<Id<Expr>>,
    walk: Walk<'a>,
    used: IdSet<Global>,
    written: IdSet<Global>,
    initialised: bool,
}

/// A function of which not all callees have been added yet.
struct Visit {
    function: Id<Function>,
    expressions: Range<Id<Expr>>,
    /// What it calls and what is still to be added, the last first.
    callees: Vec<Id<Function>>,
}

impl<'a> Search<'a> {
    fn new(hir: &'a Hir, built_in: &'a double::Functions) -> Self {
        Search {
            hir,
            built_in,
            seen: IdSet::default(),
            functions: Vec::new(),
            rows: Vec::new(),
            expressions: Pool::default(),
            walk: Walk::default(),
            used: IdSet::default(),
            written: IdSet::default(),
            initialised: false,
        }
    }

    /// Adds a function behind all that it calls. The stack is a list: call chains may be long.
    fn add(&mut self, root: Id<Function>) {
        let mut open = Vec::new();
        if self.seen.insert(root) {
            open.push(self.visit(root));
        }
        while let Some(visit) = open.last_mut() {
            match visit.callees.pop() {
                Some(callee) => {
                    if self.seen.insert(callee) {
                        open.push(self.visit(callee));
                    }
                }
                None => {
                    self.functions.push(visit.function);
                    self.rows.push(visit.expressions);
                    open.pop();
                }
            }
        }
    }

    /// Notes the globals of a function and finds what it calls.
    fn visit(&mut self, id: Id<Function>) -> Visit {
        let function = &self.hir.functions[id];
        let mut callees = Vec::new();
        let Search {
            walk,
            expressions,
            used,
            written,
            ..
        } = self;
        let mut write = |place| {
            if let ExprKind::Global(global) = function.exprs[root(function, place)].kind {
                written.insert(global);
            }
        };
        walk.roots(&function.body);
        let row = expressions.extend(std::iter::from_fn(|| walk.next(function)));
        for &id in expressions.get(row) {
            match function.exprs[id].kind {
                ExprKind::Global(global) => {
                    used.insert(global);
                }
                ExprKind::Assign(place, _)
                | ExprKind::Compound(_, place, _)
                | ExprKind::Increment { place, .. } => write(place),
                ExprKind::Call(callee, operands) => {
                    callees.push(callee);
                    let directions = &self.hir.functions[callee].parameters;
                    let operands = function.operands.get(operands);
                    for (&operand, direction) in operands.iter().zip(directions) {
                        if *direction != Direction::In {
                            write(operand);
                        }
                    }
                }
                ExprKind::Builtin(builtin, operands) => {
                    let operands = function.operands.get(operands);
                    if builtin == Builtin::Modf {
                        write(operands[1]);
                    }
                    callees.extend(self.built_in.get(builtin, operands.len()));
                }
                _ => {}
            }
        }
        // The first call in the text comes first in the list.
        callees.reverse();
        Visit {
            function: id,
            expressions: row,
            callees,
        }
    }

    fn finish(mut self) -> Reachable {
        // The colour is what all this is for, even if no one sets it.
        for (id, global) in self.hir.globals.iter() {
            if global.kind == GlobalKind::Output(0) {
                self.used.insert(id);
                self.written.insert(id);
            }
        }
        Reachable {
            functions: self.functions,
            rows: self.rows,
            expressions: self.expressions,
            globals: self.used.iter().collect(),
            written: self.written,
            initialised: self.initialised,
        }
    }
}

/// The variable that a place is a part of, or whatever else a chain of members and indices begins with.
pub fn root(function: &Function, mut id: Id<Expr>) -> Id<Expr> {
    while let ExprKind::Index(base, _) | ExprKind::Member(base, _) | ExprKind::Swizzle(base, _) =
        function.exprs[id].kind
    {
        id = base;
    }
    id
}

/// Every expression that some of a function's statements contain, operands behind what uses them.
pub fn expressions_in(function: &Function, body: &[Stmt]) -> Vec<Id<Expr>> {
    let mut walk = Walk::default();
    walk.roots(body);
    std::iter::from_fn(|| walk.next(function)).collect()
}

/// A walk over expressions, with room for what is still to come.
#[derive(Default)]
struct Walk<'a> {
    /// Expressions, the last first.
    open: Vec<Id<Expr>>,
    /// Statements, likewise.
    statements: Vec<&'a Stmt>,
}

impl<'a> Walk<'a> {
    /// Begins with the expressions that statements hold, in the order of the text but for loops'
    /// parts.
    fn roots(&mut self, body: &'a [Stmt]) {
        let Walk { open, statements } = self;
        statements.extend(body.iter().rev());
        while let Some(stmt) = statements.pop() {
            match &stmt.kind {
                StmtKind::Expression(id) => open.push(*id),
                StmtKind::Declare(_, value) | StmtKind::Return(value) => open.extend(*value),
                StmtKind::Block(body) => statements.extend(body.iter().rev()),
                StmtKind::If(condition, accept, reject) => {
                    open.push(*condition);
                    statements.extend(reject.iter().rev());
                    statements.extend(accept.iter().rev());
                }
                StmtKind::Loop(Loop {
                    condition,
                    step,
                    body,
                    ..
                }) => {
                    open.extend(*condition);
                    open.extend(*step);
                    statements.extend(body.iter().rev());
                }
                StmtKind::Switch(Switch { selector, arms }) => {
                    open.push(*selector);
                    for arm in arms.iter().rev() {
                        statements.extend(arm.body.iter().rev());
                    }
                }
                StmtKind::Break | StmtKind::Continue | StmtKind::Discard => {}
            }
        }
        open.reverse();
    }

    fn next(&mut self, function: &Function) -> Option<Id<Expr>> {
        let id = self.open.pop()?;
        let first = self.open.len();
        function.for_each_operand(id, |operand| self.open.push(operand));
        self.open[first..].reverse();
        Some(id)
    }
}
