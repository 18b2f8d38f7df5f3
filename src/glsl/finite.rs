//! Finds the loops that are known to end, so that they need no guard at run time.
//!
//! A loop counts when its condition compares a variable with a bound that does not change, the variable
//! is changed by one constant step and nowhere else, and the step leads to the bound without passing
//! the end of the numbers.

use smallvec::{SmallVec, smallvec};

use super::arena::{Id, IdSet};
use super::hir::{
    BinaryOp, Block, Constants, Expr, ExprKind, Function, Global, GlobalKind, Hir, Local, Loop,
    Operands, StmtKind, UnaryOp, Value,
};

/// Sets [`Loop::is_finite`] where it can be shown.
pub fn mark_finite_loops(hir: &mut Hir) {
    for id in hir.functions.ids() {
        let mut body = std::mem::take(&mut hir.functions[id].body);
        let finder = Finder {
            function: &hir.functions[id],
            uniforms: &|global: Id<Global>| hir.globals[global].kind == GlobalKind::Uniform,
            constants: &hir.constants,
        };
        finder.block(&mut body, None);
        hir.functions[id].body = body;
    }
}

struct Finder<'a> {
    function: &'a Function,
    uniforms: &'a dyn Fn(Id<Global>) -> bool,
    constants: &'a Constants,
}

/// The step of a loop's variable.
#[derive(Clone, Copy)]
struct Step {
    of: Id<Local>,
    by: f64,
}

impl Finder<'_> {
    /// Marks the loops of a block; within a loop, also adds the variables that the block writes to
    /// `written`.
    fn block(&self, block: &mut Block, mut written: Option<&mut IdSet<Local>>) {
        for index in 0..block.len() {
            let (before, rest) = block.split_at_mut(index);
            match &mut rest[0].kind {
                StmtKind::Expression(value) | StmtKind::Return(Some(value)) => {
                    self.writes(*value, written.as_deref_mut());
                }
                StmtKind::Declare(local, init) => {
                    if let Some(written) = written.as_deref_mut() {
                        written.insert(*local);
                    }
                    if let Some(init) = init {
                        self.writes(*init, written.as_deref_mut());
                    }
                }
                StmtKind::Block(inner) => self.block(inner, written.as_deref_mut()),
                StmtKind::If(condition, then, other) => {
                    self.writes(*condition, written.as_deref_mut());
                    self.block(then, written.as_deref_mut());
                    self.block(other, written.as_deref_mut());
                }
                StmtKind::Switch(switch) => {
                    self.writes(switch.selector, written.as_deref_mut());
                    for arm in &mut switch.arms {
                        self.block(&mut arm.body, written.as_deref_mut());
                    }
                }
                StmtKind::Loop(found) => {
                    let mut inside = IdSet::default();
                    self.block(&mut found.body, Some(&mut inside));
                    let begin = before.last().and_then(|last| match last.kind {
                        StmtKind::Declare(local, Some(init)) => Some((local, init)),
                        _ => None,
                    });
                    found.is_finite = self.is_finite(found, begin, &inside);
                    for value in found.condition.into_iter().chain(found.step) {
                        self.writes(value, Some(&mut inside));
                    }
                    inside.extend(found.declared);
                    if let Some(written) = written.as_deref_mut() {
                        written.extend(inside.iter());
                    }
                }
                StmtKind::Break | StmtKind::Continue | StmtKind::Discard => {}
                StmtKind::Return(None) => {}
            }
        }
    }

    fn expr(&self, id: Id<Expr>) -> ExprKind {
        self.function.exprs[id].kind
    }

    fn operands(&self, operands: Operands) -> &[Id<Expr>] {
        self.function.operands.get(operands)
    }

    /// Adds the variables that an expression may write.
    fn writes(&self, id: Id<Expr>, written: Option<&mut IdSet<Local>>) {
        let Some(written) = written else { return };
        let mut open: SmallVec<[Id<Expr>; 32]> = smallvec![id];
        while let Some(id) = open.pop() {
            match self.expr(id) {
                ExprKind::Assign(place, _)
                | ExprKind::Compound(_, place, _)
                | ExprKind::Increment { place, .. } => written.extend(self.root(place)),
                // Any argument may be an `out` parameter's.
                ExprKind::Call(_, all) | ExprKind::Builtin(_, all) => {
                    written.extend(self.operands(all).iter().filter_map(|&one| self.root(one)));
                }
                _ => {}
            }
            self.function
                .for_each_operand(id, |operand| open.push(operand));
        }
    }

    /// The variable that a place is a part of.
    fn root(&self, mut id: Id<Expr>) -> Option<Id<Local>> {
        loop {
            match self.expr(id) {
                ExprKind::Local(local) => return Some(local),
                ExprKind::Index(base, _)
                | ExprKind::Member(base, _)
                | ExprKind::Swizzle(base, _) => id = base,
                _ => return None,
            }
        }
    }

    fn number(&self, id: Id<Expr>) -> Option<f64> {
        match self.expr(id) {
            ExprKind::Constant(value) => match self.constants.get(value) {
                [Value::Int(value)] => Some(f64::from(*value)),
                [Value::Uint(value)] => Some(f64::from(*value)),
                [Value::Float(value)] => Some(*value),
                _ => None,
            },
            ExprKind::Unary(UnaryOp::Negate, of) => self.number(of).map(|value| -value),
            _ => None,
        }
    }

    /// `i++`, `i -= 2` and the like.
    fn step(&self, id: Id<Expr>) -> Option<Step> {
        let local = |place| match self.expr(place) {
            ExprKind::Local(local) => Some(local),
            _ => None,
        };
        let (place, by) = match self.expr(id) {
            ExprKind::Increment { place, down, .. } => (place, if down { -1.0 } else { 1.0 }),
            ExprKind::Compound(BinaryOp::Add, place, by) => (place, self.number(by)?),
            ExprKind::Compound(BinaryOp::Subtract, place, by) => (place, -self.number(by)?),
            ExprKind::Assign(place, value) => {
                let (ExprKind::Binary(BinaryOp::Add, base, by), Some(own)) =
                    (self.expr(value), local(place))
                else {
                    return None;
                };
                (local(base) == Some(own)).then_some(())?;
                (place, self.number(by)?)
            }
            _ => return None,
        };
        Some(Step {
            of: local(place)?,
            by,
        })
    }

    fn is_finite(
        &self,
        found: &Loop,
        begin: Option<(Id<Local>, Id<Expr>)>,
        inside: &IdSet<Local>,
    ) -> bool {
        let Some(condition) = found.condition else {
            return false;
        };
        let ExprKind::Binary(op, left, right) = self.expr(condition) else {
            return false;
        };
        // `i++ < n`: the condition itself makes the step.
        let (step, bound) = match (self.expr(left), found.step) {
            (ExprKind::Increment { .. }, None) => (self.step(left), right),
            (ExprKind::Local(local), Some(step)) => {
                (self.step(step).filter(|step| step.of == local), right)
            }
            _ => return false,
        };
        let Some(step) = step else { return false };
        let ty = self.function.locals[step.of].ty;
        let leads_there = match op {
            BinaryOp::Less | BinaryOp::LessEqual => step.by > 0.0,
            BinaryOp::Greater | BinaryOp::GreaterEqual => step.by < 0.0,
            _ => false,
        };
        if inside.contains(step.of) || !leads_there || ty.scalar().is_none() {
            return false;
        }
        let is_strict = matches!(op, BinaryOp::Less | BinaryOp::Greater);
        let (low, high) = match ty {
            super::types::Type::INT => (f64::from(i32::MIN), f64::from(i32::MAX)),
            super::types::Type::UINT => (0.0, f64::from(u32::MAX)),
            _ => return self.is_finite_float(step, bound, begin),
        };
        match self.number(bound) {
            // The step after the last must still be a number of the type.
            Some(bound) => (low..=high).contains(&(bound + step.by)),
            None => is_strict && step.by.abs() == 1.0 && self.is_unchanged(bound, step.of, inside),
        }
    }

    /// With floats a step must be large enough to change the variable up to the bound.
    fn is_finite_float(
        &self,
        step: Step,
        bound: Id<Expr>,
        begin: Option<(Id<Local>, Id<Expr>)>,
    ) -> bool {
        let Some(bound) = self.number(bound) else {
            return false;
        };
        let begin = begin.filter(|&(local, _)| local == step.of);
        // A variable that begins anywhere may lie where the step is nothing to it.
        let Some(begin) = begin.and_then(|(_, init)| self.number(init)) else {
            return false;
        };
        let largest = begin.abs().max(bound.abs()) + step.by.abs();
        largest.is_finite() && step.by.abs() > largest * f64::from(f32::EPSILON)
    }

    /// Whether an expression has the same value in each round of a loop that changes `stepped` and
    /// what is `inside`.
    fn is_unchanged(&self, id: Id<Expr>, stepped: Id<Local>, inside: &IdSet<Local>) -> bool {
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            let is_fine = match self.expr(id) {
                ExprKind::Local(local) => local != stepped && !inside.contains(local),
                ExprKind::Global(global) => (self.uniforms)(global),
                ExprKind::Assign(..)
                | ExprKind::Compound(..)
                | ExprKind::Increment { .. }
                | ExprKind::Call(..) => false,
                _ => true,
            };
            if !is_fine {
                return false;
            }
            self.function
                .for_each_operand(id, |operand| open.push(operand));
        }
        true
    }
}
