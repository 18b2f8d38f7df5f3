//! Pixels that are discarded. "Control flow exits the shader" (GLSL ES 3.00, §6.4), yet a graphics library may let such a
//! pixel go on as its neighbours' helper, for their derivatives, through all the rounds that a loop has left. So it leaves
//! each loop once the round is done. Compilers of GLSL read that sentence so (Mesa, `lower_discard_flow.cpp`), and where a
//! discarded pixel ends at once, compilers drop the question.

use naga::Statement;

use super::context::Context;
use super::function::Builder;
use crate::glsl::hir::StmtKind;
use crate::glsl::types::Type;

impl Context<'_> {
    /// Makes room to know a discarded pixel by, if there are loops that it must leave.
    pub fn add_discarded(&mut self) {
        let mut statements = self.reachable.statements(self.hir);
        let discards = statements.any(|stmt| matches!(stmt.kind, StmtKind::Discard));
        if discards && !self.loops.is_empty() {
            self.discarded = Some(self.add_private("discarded", Type::BOOL));
        }
    }
}

impl Builder<'_, '_> {
    pub fn discard(&mut self) {
        if let Some(variable) = self.context.discarded {
            let (pointer, yes) = (self.global(variable), self.bool(true));
            self.store(pointer, yes);
        }
        self.flush_findings();
        self.push(Statement::Kill);
    }

    /// Ends a loop behind a round in which, or before which, the pixel was discarded.
    pub fn leave_if_discarded(&mut self) {
        if let Some(variable) = self.context.discarded {
            let pointer = self.global(variable);
            let is_discarded = self.load(pointer);
            self.branch(is_discarded, |b| b.push(Statement::Break), |_| {});
        }
    }
}
