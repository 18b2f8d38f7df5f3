//! Statements, §6.

use super::flow::{Frame, LoopFrame};
use super::{Checker, Typed};
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, Arm, Block, Loop, StmtKind};
use crate::glsl::syntax::ast::{self, Condition, Extent};
use crate::glsl::types::Type;

impl Checker<'_> {
    /// Checks a statement and adds what it does to `block`.
    pub(super) fn statement(&mut self, id: Id<ast::Stmt>, block: &mut Block) {
        let ast = self.ast;
        let statement = &ast.stmts[id];
        let extent = statement.extent;
        let kind = match &statement.kind {
            ast::StmtKind::Empty => return,
            ast::StmtKind::Expression(value) => {
                let Some(value) = self.expression(*value) else {
                    return;
                };
                self.note_height(value, 0);
                // What has no effect does nothing.
                if !self.has_effects(value) {
                    return;
                }
                StmtKind::Expression(value.id)
            }
            ast::StmtKind::Declaration(declaration) => {
                return self.declaration(&ast.declarations[*declaration], block);
            }
            ast::StmtKind::Block(statements) => {
                self.scopes.open();
                self.flow.open(Frame::Scope);
                self.flow.depth += 1;
                let statements = ast.bodies.get(*statements);
                let mut inner = Vec::with_capacity(statements.len());
                for &statement in statements {
                    self.statement(statement, &mut inner);
                }
                self.flow.note_height(0);
                self.flow.depth -= 1;
                self.leave();
                self.close_scope();
                StmtKind::Block(inner)
            }
            ast::StmtKind::If { .. } => return self.if_statement(id, block),
            ast::StmtKind::Switch { selector, body } => {
                match self.switch(*selector, ast.bodies.get(*body), extent) {
                    Some(kind) => kind,
                    None => return,
                }
            }
            ast::StmtKind::Label(_) => {
                let message = "`case` and `default` stand in a `switch` only, not in a block in it";
                return self.error("control-flow", message, extent);
            }
            ast::StmtKind::While { condition, body } => self.while_loop(condition, *body, extent),
            ast::StmtKind::DoWhile { body, condition } => self.do_loop(*body, *condition, extent),
            ast::StmtKind::For {
                init,
                condition,
                step,
                body,
            } => self.for_loop(*init, condition.as_ref(), *step, *body, extent),
            ast::StmtKind::Break => {
                if !self.flow.can_break() {
                    let message = "`break` stands in loops and `switch` only";
                    return self.error("control-flow", message, extent);
                }
                self.flow.note_break();
                StmtKind::Break
            }
            ast::StmtKind::Continue => {
                if !self.flow.is_in_loop() {
                    let message = "`continue` stands in loops only";
                    return self.error("control-flow", message, extent);
                }
                StmtKind::Continue
            }
            ast::StmtKind::Return(value) => match self.return_statement(*value, extent) {
                Some(kind) => kind,
                None => return,
            },
            ast::StmtKind::Discard => StmtKind::Discard,
        };
        block.push(hir::Stmt { kind, extent });
    }

    fn note_height(&mut self, of: Typed, above: u32) {
        let height = self.detail(of.id).height;
        self.flow.note_height(above + height);
    }

    /// A statement that has a scope of its own, as the branches of `if` do.
    fn scoped(&mut self, id: Id<ast::Stmt>) -> Block {
        self.scopes.open();
        self.flow.open(Frame::Scope);
        self.flow.depth += 2;
        let block = self.unscoped(id);
        self.flow.note_height(0);
        self.flow.depth -= 2;
        self.leave();
        self.close_scope();
        block
    }

    /// A statement whose braces, if it has any, open no scope: a loop's body.
    fn unscoped(&mut self, id: Id<ast::Stmt>) -> Block {
        let statements = match self.ast.stmts[id].kind {
            ast::StmtKind::Block(statements) => self.ast.bodies.get(statements),
            _ => &[id],
        };
        let mut block = Vec::with_capacity(statements.len());
        for &statement in statements {
            self.statement(statement, &mut block);
        }
        block
    }

    /// A body of a loop, which shares the scope of the loop's header.
    fn body(&mut self, id: Id<ast::Stmt>) -> Block {
        self.flow.depth += 2;
        let block = self.unscoped(id);
        self.flow.note_height(0);
        self.flow.depth -= 2;
        block
    }

    fn if_statement(&mut self, first: Id<ast::Stmt>, block: &mut Block) {
        // A ladder of `else if` leans to the right: it is walked without recursion.
        let mut arms = Vec::new();
        let mut next = Some(first);
        let depth = self.flow.depth;
        while let Some(id) = next {
            let ast::Stmt {
                kind:
                    ast::StmtKind::If {
                        condition,
                        then,
                        other,
                    },
                extent,
            } = self.ast.stmts[id]
            else {
                break;
            };
            let condition = self.expression(condition);
            if let Some(condition) = condition {
                self.note_height(condition, 1);
            }
            let condition = condition
                .and_then(|condition| self.require_bool(condition, "the condition of `if`"));
            self.flow.open(Frame::If);
            let then = self.scoped(then);
            arms.push((condition, then, extent));
            next = other;
            self.flow.depth += 2;
        }
        // Each further arm stands within the one before.
        self.flow.depth -= 2;
        let mut other = next.map_or(Vec::new(), |last| self.scoped(last));
        self.flow.depth = depth;
        for (condition, then, extent) in arms.into_iter().rev() {
            self.leave();
            if let Some(condition) = condition {
                let kind = StmtKind::If(condition.id, then, other);
                other = vec![hir::Stmt { kind, extent }];
            }
        }
        block.append(&mut other);
    }

    fn switch(
        &mut self,
        selector: Id<ast::Expr>,
        body: &[Id<ast::Stmt>],
        extent: Extent,
    ) -> Option<StmtKind> {
        let selector_extent = self.ast.exprs[selector].extent;
        let selector = self.expression(selector);
        let ty = selector.map(|selector| selector.ty);
        let is_whole = matches!(ty, Some(Type::INT | Type::UINT));
        if let (Some(ty), false) = (ty, is_whole) {
            let message = format!(
                "`switch` needs an `int` or `uint`, this is {}",
                self.spell_one(ty)
            );
            self.error("type-mismatch", message, selector_extent);
        }
        if let Some(selector) = selector {
            self.note_height(selector, 1);
        }
        self.flow.open(Frame::Switch {
            ty: ty.unwrap_or(Type::INT),
            labels: Default::default(),
        });
        self.scopes.open();
        self.flow.depth += 2;
        let mut arms: Vec<Arm> = Vec::new();
        let mut behind_label = false;
        for &id in body {
            let statement = &self.ast.stmts[id];
            if let ast::StmtKind::Label(value) = statement.kind {
                let label = self.label(value, statement.extent);
                let label = label.filter(|_| is_whole);
                match arms.last_mut() {
                    Some(arm) if behind_label => arm.labels.extend(label),
                    _ => arms.push(Arm {
                        labels: label.into_iter().collect(),
                        body: Vec::new(),
                    }),
                }
                behind_label = true;
                continue;
            }
            behind_label = false;
            match arms.last_mut() {
                Some(_) => {
                    let mut added = Vec::new();
                    self.statement(id, &mut added);
                    let arm = arms.last_mut().expect("an arm was begun");
                    arm.body.append(&mut added);
                }
                None => {
                    let message = "a statement stands before the first `case`";
                    self.error("control-flow", message, self.ast.stmts[id].extent);
                    return self.end_switch();
                }
            }
        }
        if behind_label {
            let message = "a statement is missing behind the last `case`";
            let hint = "write `break;` behind it";
            self.error_with_hint("control-flow", message, extent, hint);
        }
        self.flow.depth -= 2;
        self.close_scope();
        self.leave();
        let selector = selector.filter(|_| is_whole)?;
        if arms.is_empty() {
            return Some(StmtKind::Expression(selector.id));
        }
        Some(StmtKind::Switch(hir::Switch {
            selector: selector.id,
            arms,
        }))
    }

    fn end_switch(&mut self) -> Option<StmtKind> {
        self.flow.depth -= 2;
        self.close_scope();
        self.leave();
        None
    }

    /// A label's bits; `Some(None)` is `default`.
    fn label(&mut self, value: Option<Id<ast::Expr>>, extent: Extent) -> Option<Option<i32>> {
        let number = match value {
            None => None,
            Some(id) => {
                let extent = self.ast.exprs[id].extent;
                let value = self.expression(id)?;
                if !matches!(value.ty, Type::INT | Type::UINT) {
                    let message = format!(
                        "a label must be an `int` or `uint`, not `{}`",
                        self.spell(value.ty)
                    );
                    self.error("type-mismatch", message, extent);
                    return None;
                }
                let Some(number) = self.integer(value) else {
                    self.error(
                        "not-constant",
                        "a label must be a constant expression",
                        extent,
                    );
                    return None;
                };
                if let Some(Frame::Switch { ty, .. }) = self.flow.innermost()
                    && *ty != value.ty
                {
                    let ty = *ty;
                    let message = format!(
                        "the label is {}, the `switch` goes by {}",
                        self.spell_one(value.ty),
                        self.spell_one(ty)
                    );
                    self.error("type-mismatch", message, extent);
                    return None;
                }
                Some(number)
            }
        };
        if let Some(Frame::Switch { labels, .. }) = self.flow.innermost()
            && !labels.insert(number)
        {
            self.error(
                "control-flow",
                "this label stands in the `switch` already",
                extent,
            );
            return None;
        }
        Some(number.map(|number| number as i32))
    }

    fn return_statement(
        &mut self,
        value: Option<Id<ast::Expr>>,
        extent: Extent,
    ) -> Option<StmtKind> {
        let result = self.function.result;
        let Some(value) = value else {
            self.flow.note_return();
            if result != Type::VOID {
                let message = format!("{} must be returned", self.spell_one(result));
                self.error("missing-return", message, extent);
            }
            return Some(StmtKind::Return(None));
        };
        self.returns_value = true;
        self.flow.note_return();
        let value = self.expression(value)?;
        self.note_height(value, 1);
        if result == Type::VOID {
            let message = "the function returns nothing, so no value can stand here";
            self.error("type-mismatch", message, extent);
            return None;
        }
        if value.ty != result {
            let message = format!(
                "the function returns {}, this is {}",
                self.spell_one(result),
                self.spell_one(value.ty)
            );
            let hint = "GLSL ES converts nothing by itself: write `float(…)`, `vec3(…)` and so on";
            self.error_with_hint("type-mismatch", message, extent, hint);
            return None;
        }
        Some(StmtKind::Return(Some(value.id)))
    }

    /// The condition of `for` or `while`: a declared variable and the value.
    fn condition(&mut self, condition: &Condition) -> (Option<Id<hir::Local>>, Option<Typed>) {
        let what = "the condition of a loop";
        match condition {
            Condition::Expression(id) => {
                let value = self.expression(*id);
                if let Some(value) = value {
                    self.note_height(value, 1);
                }
                (None, value.and_then(|value| self.require_bool(value, what)))
            }
            Condition::Declaration(declaration) => {
                let mut block = Vec::new();
                let before = self.errors;
                let declaration = &self.ast.declarations[*declaration];
                self.declaration(declaration, &mut block);
                match block.pop().map(|statement| statement.kind) {
                    Some(StmtKind::Declare(local, Some(init))) => {
                        let ty = self.function.exprs[init].ty;
                        let value = Typed {
                            id: init,
                            ty,
                            value: None,
                        };
                        (Some(local), self.require_bool(value, what))
                    }
                    // A constant was declared: its value is the condition.
                    _ if self.errors == before => {
                        let init = self.only_initialiser(declaration);
                        let value = init.and_then(|init| self.expression(init));
                        (None, value.and_then(|value| self.require_bool(value, what)))
                    }
                    _ => (None, None),
                }
            }
        }
    }

    /// The initialiser of a declaration of one variable.
    fn only_initialiser(&self, declaration: &ast::Declaration) -> Option<Id<ast::Expr>> {
        let ast::Declaration::Variables { declarators, .. } = declaration else {
            return None;
        };
        self.ast.declarators.get(*declarators).first()?.init
    }

    fn while_loop(
        &mut self,
        condition: &Condition,
        body: Id<ast::Stmt>,
        extent: Extent,
    ) -> StmtKind {
        self.scopes.open();
        self.flow
            .open(Frame::Loop(LoopFrame::new(Extent::of(extent.first))));
        let (declared, value) = self.condition(condition);
        if let Some(value) = value {
            self.note_condition(Some(value));
        }
        let body = self.body(body);
        self.leave();
        self.close_scope();
        StmtKind::Loop(Loop {
            declared,
            condition: value.map(|value| value.id),
            tests_last: false,
            body,
            step: None,
            is_finite: false,
        })
    }

    fn do_loop(
        &mut self,
        body: Id<ast::Stmt>,
        condition: Id<ast::Expr>,
        extent: Extent,
    ) -> StmtKind {
        self.flow
            .open(Frame::Loop(LoopFrame::new(Extent::of(extent.first))));
        let body = self.scoped(body);
        self.leave();
        let value = self.expression(condition);
        if let Some(value) = value {
            self.note_height(value, 1);
        }
        let value = value.and_then(|value| self.require_bool(value, "the condition of a loop"));
        StmtKind::Loop(Loop {
            declared: None,
            condition: value.map(|value| value.id),
            tests_last: true,
            body,
            step: None,
            is_finite: false,
        })
    }

    fn for_loop(
        &mut self,
        init: Id<ast::Stmt>,
        condition: Option<&Condition>,
        step: Option<Id<ast::Expr>>,
        body: Id<ast::Stmt>,
        extent: Extent,
    ) -> StmtKind {
        self.scopes.open();
        let mut block = Vec::new();
        self.statement(init, &mut block);
        self.flow
            .open(Frame::Loop(LoopFrame::new(Extent::of(extent.first))));
        let (declared, value) = match condition {
            Some(condition) => self.condition(condition),
            None => (None, None),
        };
        if condition.is_none() || value.is_some() {
            self.note_condition(value);
        }
        let step = step.and_then(|step| self.expression(step));
        if let Some(step) = step {
            self.note_height(step, 1);
        }
        let body = self.body(body);
        self.leave();
        self.close_scope();
        let kind = StmtKind::Loop(Loop {
            declared,
            condition: value.map(|value| value.id),
            tests_last: false,
            body,
            step: step
                .filter(|&step| self.has_effects(step))
                .map(|step| step.id),
            is_finite: false,
        });
        block.push(hir::Stmt { kind, extent });
        StmtKind::Block(block)
    }
}
