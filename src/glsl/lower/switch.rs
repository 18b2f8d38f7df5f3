//! `switch`. naga's arms do not fall through in all its writers.

use naga::{BinaryOperator, Statement, SwitchCase, SwitchValue};

use super::function::{Builder, H};
use crate::glsl::hir::{Arm, Stmt, StmtKind, Switch};
use crate::glsl::types::{Scalar, Type};

impl<'a> Builder<'_, 'a> {
    /// Appends a `switch`; whether control never gets behind it.
    pub(super) fn switch(&mut self, source: &'a Switch) -> bool {
        let selector = self.value(source.selector);
        let is_uint = self.source.exprs[source.selector].ty.scalar() == Some(Scalar::Uint);
        let arms = merged(&source.arms);
        let falls = arms.iter().rev().skip(1).any(|(_, body)| !ends(body));
        let span = self.span;
        if !falls {
            let mut cases = Vec::new();
            for (labels, body) in &arms {
                self.open();
                self.arm(without_break(body));
                let block = self.close();
                add_cases(&mut cases, labels, block, is_uint);
            }
            self.span = span;
            complete(&mut cases, naga::Block::new());
            self.push(Statement::Switch { selector, cases });
            return false;
        }
        self.switch_by_stage(selector, is_uint, &arms);
        self.span = span;
        false
    }

    /// An arm runs if its own label or one before it was met, and none that lie between left the
    /// switch: the first switch only finds the arm to begin with, the second is there to be left.
    fn switch_by_stage(
        &mut self,
        selector: H,
        is_uint: bool,
        arms: &[(Vec<Option<i32>>, &'a [Stmt])],
    ) {
        let stage = self.acquire(Type::INT);
        let mut cases = Vec::new();
        for (i, (labels, _)) in arms.iter().enumerate() {
            self.open();
            let number = self.int(i as i32);
            self.store(stage, number);
            let block = self.close();
            add_cases(&mut cases, labels, block, is_uint);
        }
        self.open();
        let none = self.int(arms.len() as i32);
        self.store(stage, none);
        let none = self.close();
        complete(&mut cases, none);
        self.push(Statement::Switch { selector, cases });
        let first = self.load(stage);
        self.release(Type::INT, stage);
        self.open();
        for (i, (_, body)) in arms.iter().enumerate() {
            let number = self.int(i as i32);
            let condition = self.binary(BinaryOperator::LessEqual, first, number);
            self.branch(condition, |b| b.arm(body), |_| {});
        }
        let body = self.close();
        let cases = vec![SwitchCase {
            value: SwitchValue::Default,
            body,
            fall_through: false,
        }];
        let selector = self.int(0);
        self.push(Statement::Switch { selector, cases });
    }

    /// The statements of an arm. What they declare is also seen by later ones.
    fn arm(&mut self, body: &'a [Stmt]) {
        let in_arm = std::mem::replace(&mut self.in_arm, true);
        self.statements(body);
        self.in_arm = in_arm;
    }
}

/// The arms, with those that have no statements joined to the next.
fn merged(arms: &[Arm]) -> Vec<(Vec<Option<i32>>, &[Stmt])> {
    let mut merged = Vec::new();
    let mut labels = Vec::new();
    for (i, arm) in arms.iter().enumerate() {
        labels.extend(&arm.labels);
        if !arm.body.is_empty() || i + 1 == arms.len() {
            merged.push((std::mem::take(&mut labels), &*arm.body));
        }
    }
    merged
}

/// Whether control never gets to the end of these statements.
fn ends(body: &[Stmt]) -> bool {
    body.iter().any(|stmt| match &stmt.kind {
        StmtKind::Break | StmtKind::Continue | StmtKind::Return(_) | StmtKind::Discard => true,
        StmtKind::Block(body) => ends(body),
        StmtKind::If(_, accept, reject) => ends(accept) && ends(reject),
        _ => false,
    })
}

/// The statements without a `break` at their end, which naga's arms do by themselves.
fn without_break(body: &[Stmt]) -> &[Stmt] {
    match body {
        [rest @ .., last] if matches!(last.kind, StmtKind::Break) => rest,
        _ => body,
    }
}

/// Adds a case for each label; the last has the statements.
fn add_cases(
    cases: &mut Vec<SwitchCase>,
    labels: &[Option<i32>],
    body: naga::Block,
    is_uint: bool,
) {
    let first = cases.len();
    cases.extend(labels.iter().map(|label| SwitchCase {
        value: match *label {
            None => SwitchValue::Default,
            Some(bits) if is_uint => SwitchValue::U32(bits as u32),
            Some(value) => SwitchValue::I32(value),
        },
        body: naga::Block::new(),
        fall_through: true,
    }));
    if let Some(last) = cases[first..].last_mut() {
        last.body = body;
        last.fall_through = false;
    }
}

/// Adds the default that naga requires, if the author wrote none.
fn complete(cases: &mut Vec<SwitchCase>, body: naga::Block) {
    if !cases.iter().any(|case| case.value == SwitchValue::Default) {
        cases.push(SwitchCase {
            value: SwitchValue::Default,
            body,
            fall_through: false,
        });
    }
}
