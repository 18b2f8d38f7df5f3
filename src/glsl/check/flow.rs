//! What surrounds a statement, and loops that cannot end.

use rustc_hash::FxHashSet;

use super::{Checker, Typed};
use crate::glsl::arena::Id;
use crate::glsl::hir::{ExprKind, Global, Local, Value};
use crate::glsl::syntax::ast::Extent;
use crate::glsl::types::Type;

/// A construct around statements.
#[derive(Clone, Debug)]
pub(super) enum Frame {
    Loop(LoopFrame),
    Switch {
        ty: Type,
        /// The labels so far; `None` is `default`.
        labels: FxHashSet<Option<i64>>,
    },
    If,
    Scope,
}

#[derive(Clone, Debug)]
pub(super) struct LoopFrame {
    at: Extent,
    /// Whether its condition always holds.
    is_endless: bool,
    /// The variable that is its condition, if that began as `true`.
    condition: Option<Variable>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Variable {
    Local(Id<Local>),
    Global(Id<Global>),
}

#[derive(Clone, Debug)]
struct Level {
    frame: Frame,
    /// Whether a `break` leaves it.
    has_break: bool,
    /// Whether a `return` stands in it.
    has_return: bool,
}

/// What is open around the statement being checked.
#[derive(Clone, Debug, Default)]
pub(super) struct Flow {
    levels: Vec<Level>,
    /// Variables that began as `true`.
    begun_true: FxHashSet<Variable>,
    /// Loops that end only if their condition's variable is written somewhere.
    pending: Vec<(Variable, Extent)>,
    /// Nodes of the tree above the statement, as ANGLE counts.
    pub depth: u32,
    /// The most nodes above each other so far.
    pub highest: u32,
}

impl Flow {
    pub fn of_function() -> Self {
        Flow {
            depth: 3,
            ..Flow::default()
        }
    }

    pub fn open(&mut self, frame: Frame) {
        self.levels.push(Level {
            frame,
            has_break: false,
            has_return: false,
        });
    }

    pub fn innermost(&mut self) -> Option<&mut Frame> {
        self.levels.last_mut().map(|level| &mut level.frame)
    }

    pub fn is_in_loop(&self) -> bool {
        self.levels
            .iter()
            .any(|level| matches!(level.frame, Frame::Loop(_)))
    }

    pub fn can_break(&self) -> bool {
        let mut levels = self.levels.iter();
        levels.any(|level| matches!(level.frame, Frame::Loop(_) | Frame::Switch { .. }))
    }

    pub fn note_break(&mut self) {
        if let Some(level) = self.levels.last_mut() {
            level.has_break = true;
        }
    }

    pub fn note_return(&mut self) {
        if let Some(level) = self.levels.last_mut() {
            level.has_return = true;
        }
    }

    /// Notes the height of something `above` nodes below the statement.
    pub fn note_height(&mut self, above: u32) {
        self.highest = self.highest.max(self.depth + above);
    }
}

impl LoopFrame {
    pub fn new(at: Extent) -> Self {
        LoopFrame {
            at,
            is_endless: false,
            condition: None,
        }
    }
}

impl Checker<'_> {
    /// Ends a construct. A loop that cannot end is reported, as WebGL2 refuses it.
    pub(super) fn leave(&mut self) {
        let level = self.flow.levels.pop().expect("what is left was entered");
        if let Some(outer) = self.flow.levels.last_mut() {
            outer.has_return |= level.has_return;
            outer.has_break |= level.has_break && matches!(level.frame, Frame::If | Frame::Scope);
        }
        let Frame::Loop(frame) = level.frame else {
            return;
        };
        if level.has_break || level.has_return {
            return;
        }
        if frame.is_endless {
            self.endless(frame.at);
        } else if let Some(variable) = frame.condition {
            self.flow.pending.push((variable, frame.at));
        }
    }

    fn endless(&mut self, at: Extent) {
        self.error_with_hint(
            "endless-loop",
            "this loop cannot end: its condition always holds",
            at,
            "leave it with `break` or `return`, or give it a condition that changes",
        );
    }

    /// Notes the condition of the loop that was entered last.
    pub(super) fn note_condition(&mut self, condition: Option<Typed>) {
        let (is_endless, variable) = match condition {
            None => (true, None),
            Some(of) => match (of.value, self.function.exprs[of.id].kind) {
                (Some(value), _) => {
                    let value = self.hir.constants.get(value);
                    (matches!(value, [Value::Bool(true)]), None)
                }
                (None, ExprKind::Local(id)) => (false, Some(Variable::Local(id))),
                (None, ExprKind::Global(id)) => (false, Some(Variable::Global(id))),
                _ => (false, None),
            },
        };
        let variable = variable.filter(|variable| {
            self.flow.begun_true.contains(variable) || self.true_globals.contains(variable)
        });
        if let Some(Frame::Loop(frame)) = self.flow.innermost() {
            frame.is_endless = is_endless;
            frame.condition = variable;
        }
    }

    /// Notes a variable whose initialiser is the constant `true`.
    pub(super) fn note_begun_true(&mut self, variable: Variable) {
        match variable {
            Variable::Local(_) => self.flow.begun_true.insert(variable),
            Variable::Global(_) => self.true_globals.insert(variable),
        };
    }

    /// Reports loops whose condition is a variable that nothing sets, once that is known.
    pub(super) fn check_pending_loops(&mut self) {
        let pending = std::mem::take(&mut self.flow.pending);
        for (variable, at) in pending {
            match variable {
                Variable::Local(id) if self.function.locals[id].written => {}
                Variable::Local(_) => self.endless(at),
                Variable::Global(id) => self.pending_globals.push((id, at)),
            }
        }
    }

    /// The same for global variables, at the end of the program.
    pub(super) fn check_pending_global_loops(&mut self) {
        for (id, at) in std::mem::take(&mut self.pending_globals) {
            if !self.hir.globals[id].written {
                self.endless(at);
            }
        }
    }
}
