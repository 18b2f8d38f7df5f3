//! Functions that may end without a `return`, although they have a result: WebGL2 takes them, and what
//! they give then is undefined, §6.1.

use super::Checker;
use crate::glsl::arena::Id;
use crate::glsl::hir::{Block, Constants, Expr, ExprKind, Function, Loop, Stmt, StmtKind, Value};
use crate::glsl::syntax::ast::Extent;

impl Checker<'_> {
    /// Warns if control may get to the end of a body in which a result is returned elsewhere.
    pub(super) fn warn_about_missing_returns(&mut self, body: &Block, at: Extent) {
        let paths = Paths {
            function: &self.function,
            constants: &self.hir.constants,
        };
        if paths.lead_past(body) {
            let name = self.text(self.function.name);
            let message = format!("the function `{name}` may end without returning anything");
            let hint = "it returns zero then here and in browsers, but anything elsewhere: write a \
                        `return` at its end";
            self.warn("partial-return", message, at, hint);
        }
    }
}

/// Where control may go, as far as constants tell.
struct Paths<'a> {
    function: &'a Function,
    constants: &'a Constants,
}

impl Paths<'_> {
    /// Whether control may get behind the last of some statements.
    fn lead_past(&self, block: &[Stmt]) -> bool {
        block.iter().all(|stmt| self.leads_past(&stmt.kind))
    }

    fn leads_past(&self, kind: &StmtKind) -> bool {
        match kind {
            StmtKind::Expression(_) | StmtKind::Declare(..) => true,
            StmtKind::Return(_) | StmtKind::Discard | StmtKind::Break | StmtKind::Continue => false,
            StmtKind::Block(body) => self.lead_past(body),
            StmtKind::If(condition, accept, reject) => match self.known(*condition) {
                Some(true) => self.lead_past(accept),
                Some(false) => self.lead_past(reject),
                None => self.lead_past(accept) || self.lead_past(reject),
            },
            StmtKind::Loop(found) => self.loop_leads_past(found),
            StmtKind::Switch(switch) => {
                let has_default = switch.arms.iter().any(|arm| arm.labels.contains(&None));
                let last = switch.arms.last();
                !has_default
                    || last.is_none_or(|arm| self.lead_past(&arm.body))
                    || switch.arms.iter().any(|arm| leaves(&arm.body, Jump::Break))
            }
        }
    }

    fn loop_leads_past(&self, found: &Loop) -> bool {
        let holds = found.condition.map_or(Some(true), |id| self.known(id));
        let may_end = holds != Some(true);
        // What a `do` loop goes by is only asked if its body gets there.
        let is_asked =
            !found.tests_last || self.lead_past(&found.body) || leaves(&found.body, Jump::Continue);
        may_end && is_asked || leaves(&found.body, Jump::Break)
    }

    /// The value of a condition that is constant.
    fn known(&self, id: Id<Expr>) -> Option<bool> {
        let ExprKind::Constant(constant) = self.function.exprs[id].kind else {
            return None;
        };
        match self.constants.get(constant) {
            [Value::Bool(value)] => Some(*value),
            _ => None,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Jump {
    Break,
    Continue,
}

/// Whether some statements jump out of themselves, as part of a loop or a `switch`.
fn leaves(block: &[Stmt], jump: Jump) -> bool {
    block.iter().any(|stmt| match &stmt.kind {
        StmtKind::Break => jump == Jump::Break,
        StmtKind::Continue => jump == Jump::Continue,
        StmtKind::Block(body) => leaves(body, jump),
        StmtKind::If(_, accept, reject) => leaves(accept, jump) || leaves(reject, jump),
        // A `break` in it is its own.
        StmtKind::Switch(switch) => {
            jump == Jump::Continue && switch.arms.iter().any(|arm| leaves(&arm.body, jump))
        }
        _ => false,
    })
}
