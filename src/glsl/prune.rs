//! Finds what a program needs: from `main`, over its calls, to functions and global variables.
//! Helpers that are pasted along but never called shall cost nothing and demand nothing.

use super::arena::{Id, IdSet};
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
    /// The expressions in the body of each, operands behind what uses them.
    pub expressions: Vec<Vec<Id<Expr>>>,
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

struct Search<'a> {
    hir: &'a Hir,
    built_in: &'a double::Functions,
    seen: IdSet<Function>,
    functions: Vec<Id<Function>>,
    expressions: Vec<Vec<Id<Expr>>>,
    used: IdSet<Global>,
    written: IdSet<Global>,
    initialised: bool,
}

/// A function of which not all callees have been added yet.
struct Visit {
    function: Id<Function>,
    expressions: Vec<Id<Expr>>,
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
            expressions: Vec::new(),
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
                    self.expressions
                        .push(std::mem::take(&mut visit.expressions));
                    open.pop();
                }
            }
        }
    }

    /// Notes the globals of a function and finds what it calls.
    fn visit(&mut self, id: Id<Function>) -> Visit {
        let function = &self.hir.functions[id];
        let mut callees = Vec::new();
        let expressions = expressions_in(function, &function.body);
        for &id in &expressions {
            match function.exprs[id].kind {
                ExprKind::Global(global) => {
                    self.used.insert(global);
                }
                ExprKind::Assign(place, _)
                | ExprKind::Compound(_, place, _)
                | ExprKind::Increment { place, .. } => self.write(function, place),
                ExprKind::Call(callee, operands) => {
                    callees.push(callee);
                    let directions = &self.hir.functions[callee].parameters;
                    let operands = function.operands.get(operands);
                    for (&operand, direction) in operands.iter().zip(directions) {
                        if *direction != Direction::In {
                            self.write(function, operand);
                        }
                    }
                }
                ExprKind::Builtin(builtin, operands) => {
                    let operands = function.operands.get(operands);
                    if builtin == Builtin::Modf {
                        self.write(function, operands[1]);
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
            expressions,
            callees,
        }
    }

    fn write(&mut self, function: &Function, place: Id<Expr>) {
        if let ExprKind::Global(global) = function.exprs[root(function, place)].kind {
            self.written.insert(global);
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
    let mut roots = Vec::new();
    statement_roots(body, &mut roots);
    let mut found = Vec::with_capacity(roots.len() * 8);
    roots.reverse();
    while let Some(id) = roots.pop() {
        found.push(id);
        let first = roots.len();
        function.for_each_operand(id, |operand| roots.push(operand));
        roots[first..].reverse();
    }
    found
}

/// The expressions that statements hold, in the order of the text but for loops' parts.
fn statement_roots(body: &[Stmt], roots: &mut Vec<Id<Expr>>) {
    let mut open: Vec<&Stmt> = body.iter().rev().collect();
    while let Some(stmt) = open.pop() {
        match &stmt.kind {
            StmtKind::Expression(id) => roots.push(*id),
            StmtKind::Declare(_, value) | StmtKind::Return(value) => roots.extend(*value),
            StmtKind::Block(body) => open.extend(body.iter().rev()),
            StmtKind::If(condition, accept, reject) => {
                roots.push(*condition);
                open.extend(reject.iter().rev());
                open.extend(accept.iter().rev());
            }
            StmtKind::Loop(Loop {
                condition,
                step,
                body,
                ..
            }) => {
                roots.extend(*condition);
                roots.extend(*step);
                open.extend(body.iter().rev());
            }
            StmtKind::Switch(Switch { selector, arms }) => {
                roots.push(*selector);
                for arm in arms.iter().rev() {
                    open.extend(arm.body.iter().rev());
                }
            }
            StmtKind::Break | StmtKind::Continue | StmtKind::Discard => {}
        }
    }
}
