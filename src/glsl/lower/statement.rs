//! Statements. Nothing is appended behind one that control does not get past.

use naga::Statement;

use super::function::{Builder, H, Local};
use super::{Excess, MAX_BLOCKS, MAX_FUNCTIONS, MAX_OPERATIONS};
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, Expr, ExprKind, Extent, Loop, Stmt, StmtKind};
use crate::glsl::types::{Content, Type};

impl<'a> Builder<'_, 'a> {
    /// Appends statements; whether control never gets to their end.
    pub(super) fn statements(&mut self, body: &'a [Stmt]) -> bool {
        for (i, stmt) in body.iter().enumerate() {
            if self.statement(stmt, &body[..i]) {
                return true;
            }
        }
        false
    }

    /// Whether the program is more than graphics libraries bear, so that it is refused.
    pub(super) fn is_excessive(&mut self, at: Extent) -> bool {
        if self.context.excess.is_none() {
            self.context.excess = if self.deepest > MAX_BLOCKS {
                Some(Excess::Depth(at))
            } else if self.context.operations > MAX_OPERATIONS {
                Some(Excess::Size(at))
            } else if self.context.functions.len() > MAX_FUNCTIONS {
                Some(Excess::Functions(at))
            } else {
                None
            };
        }
        self.context.excess.is_some()
    }

    /// Statements of which the declarations are seen by no others.
    fn scope(&mut self, body: &'a [Stmt]) -> bool {
        let in_arm = std::mem::replace(&mut self.in_arm, false);
        let ends = self.statements(body);
        self.in_arm = in_arm;
        ends
    }

    fn scoped_block(&mut self, body: &'a [Stmt]) -> (naga::Block, bool) {
        self.open();
        let ends = self.scope(body);
        (self.close(), ends)
    }

    fn statement(&mut self, stmt: &'a Stmt, before: &'a [Stmt]) -> bool {
        self.span = self.span_of(stmt.extent);
        if self.is_excessive(stmt.extent) {
            return true;
        }
        match &stmt.kind {
            StmtKind::Expression(id) => self.effect(*id),
            StmtKind::Declare(local, value) => self.declare(*local, *value),
            StmtKind::Block(body) => return self.scope(body),
            StmtKind::If(condition, accept, reject) => {
                let condition = self.value(*condition);
                let span = self.span;
                let (accept, accept_ends) = self.scoped_block(accept);
                let (reject, reject_ends) = self.scoped_block(reject);
                self.span = span;
                self.push(Statement::If {
                    condition,
                    accept,
                    reject,
                });
                return accept_ends && reject_ends;
            }
            StmtKind::Loop(body) => {
                if !body.is_finite {
                    self.context.unguarded.loops.push(stmt.extent);
                }
                self.repeat(body, stmt.extent, before);
            }
            StmtKind::Switch(switch) => return self.switch(switch),
            StmtKind::Break => {
                self.push(Statement::Break);
                return true;
            }
            StmtKind::Continue => {
                let source = *self.loops.last().expect("it stands in a loop");
                self.finish_round(source);
                self.push(Statement::Continue);
                return true;
            }
            StmtKind::Return(value) => {
                let value = value.and_then(|value| {
                    if self.source.exprs[value].ty == Type::VOID {
                        self.effect(value);
                        return None;
                    }
                    Some(self.value(value))
                });
                self.leave(value);
                return true;
            }
            StmtKind::Discard => {
                self.discard();
                return true;
            }
        }
        false
    }

    /// A variable begins. One that keeps its first value needs no variable, unless that value would
    /// not be known wherever the name is.
    fn declare(&mut self, id: Id<hir::Local>, value: Option<Id<Expr>>) {
        let local = &self.source.locals[id];
        let ty = local.ty;
        if !local.written && self.room.locals[id.index()].is_none() {
            let constant = match value.map(|value| self.source.exprs[value].kind) {
                None => Some(Local::Zero),
                Some(ExprKind::Constant(constant)) => Some(Local::Constant(constant)),
                Some(_) => None,
            };
            if value.is_none() {
                self.begin_unset(id);
            }
            if !self.in_arm
                && let Some(value) = value
            {
                self.note_range(id, value);
            }
            let binding = match (constant, value) {
                (Some(Local::Zero), _) => Local::Zero,
                // Behind a label, the declaration may be jumped over.
                (Some(constant), _) if !self.in_arm => constant,
                (None, Some(value)) if !self.in_arm && !self.holds_array(ty) => {
                    let value = self.value(value);
                    self.name(value, id);
                    Local::Value(value)
                }
                _ => {
                    let pointer = self.local_pointer(id);
                    if let Some(value) = value {
                        self.evaluate_into(value, pointer);
                    }
                    return;
                }
            };
            self.room.locals[id.index()] = Some(binding);
            return;
        }
        let pointer = self.local_pointer(id);
        if value.is_none() {
            self.begin_unset(id);
        }
        match value {
            Some(value) => self.evaluate_into(value, pointer),
            // Without a loop around it, it is zero from the start.
            None if self.loops.is_empty() => {}
            None => self.store_zero(pointer, ty),
        }
    }

    /// Whether a value is better kept behind a pointer, for its elements are picked by an index.
    fn holds_array(&self, ty: Type) -> bool {
        Content::of(ty, &self.context.hir.structs).has_array
    }

    fn repeat(&mut self, source: &'a Loop, extent: Extent, before: &'a [Stmt]) {
        let counter = self.counter(source, before);
        let span = self.span;
        let rounds = match source.is_finite {
            true => None,
            false => self.start_rounds(),
        };
        self.loops.push(source);
        self.open();
        if !source.tests_last
            && let Some(condition) = self.condition(source)
        {
            self.branch(condition, |_| {}, |b| b.push(Statement::Break));
        }
        if !source.is_finite {
            self.spend_round();
        }
        if let Some(rounds) = rounds {
            self.limit_round(rounds);
        }
        self.record_round(extent);
        let outside = counter.map(|(local, range)| (local, self.ranges.set(local, Some(range))));
        if !self.scope(&source.body) {
            self.finish_round(source);
        }
        if let Some((local, range)) = outside {
            self.ranges.set(local, range);
        }
        let body = self.close();
        self.loops.pop();
        self.span = span;
        if let Some(rounds) = rounds {
            self.release(Type::UINT, rounds);
        }
        self.push(Statement::Loop {
            body,
            continuing: naga::Block::new(),
            break_if: None,
        });
    }

    /// What is done between two rounds of a loop. It stands before each `continue` anew, as compilers
    /// of GLSL have it: where SPIR-V has it apart, drivers take minutes to unroll some loops.
    fn finish_round(&mut self, source: &'a Loop) {
        if let Some(step) = source.step {
            self.effect(step);
        }
        if source.tests_last
            && let Some(condition) = self.condition(source)
        {
            self.branch(condition, |_| {}, |b| b.push(Statement::Break));
        }
        self.leave_if_discarded();
    }

    fn condition(&mut self, source: &Loop) -> Option<H> {
        let condition = source.condition?;
        let Some(local) = source.declared else {
            if let ExprKind::Constant(constant) = self.source.exprs[condition].kind
                && let [hir::Value::Bool(true)] = self.context.hir.constants.get(constant)
            {
                return None;
            }
            return Some(self.value(condition));
        };
        let pointer = self.local_pointer(local);
        self.evaluate_into(condition, pointer);
        Some(self.load(pointer))
    }
}
