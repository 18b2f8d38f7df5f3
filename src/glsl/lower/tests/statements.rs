//! Loops, switches and what cannot be reached.

use super::program::{E, Program, set, stmt};
use super::{BOOL, FLOAT, INT, array, lowered, vec, wgsl};
use crate::glsl::Precision;
use crate::glsl::arena::Id;
use crate::glsl::hir::*;
use crate::glsl::types::Type;

fn less(program: &mut Program, local: Id<Local>, limit: i32) -> E {
    let (left, right) = (program.get(local), program.int(limit));
    program.binary(BinaryOp::Less, left, right, BOOL)
}

fn round(program: &mut Program, condition: E, body: Block, step: Option<E>) -> Stmt {
    let _ = program;
    stmt(StmtKind::Loop(Loop {
        declared: None,
        condition: Some(condition),
        tests_last: false,
        body,
        step,
        is_finite: true,
    }))
}

#[test]
fn loops_of_every_kind() {
    let mut program = Program::new();
    let color = program.global("color", vec(4), GlobalKind::Output(0));
    program.begin("next", BOOL);
    let i = program.parameter("i", INT, Direction::InOut);
    let place = program.get(i);
    let mut body = vec![set(program.increment(place))];
    let condition = less(&mut program, i, 9);
    body.push(stmt(StmtKind::Return(Some(condition))));
    let next = program.end(body);
    program.begin("main", Type::VOID);
    let i = program.local("i", INT, true);
    let a = program.local("a", array(FLOAT, 8), true);
    let x = program.local("x", FLOAT, true);
    let zero = program.int(0);
    let mut body = vec![
        stmt(StmtKind::Declare(a, None)),
        stmt(StmtKind::Declare(i, Some(zero))),
    ];
    // for (int i = 0; i < 8; i++) { float x; if (i < 3) continue; a[i] = x++; }
    let condition = less(&mut program, i, 8);
    let small = less(&mut program, i, 3);
    let (base, at, value) = (program.get(a), program.get(i), program.get(x));
    let place = program.index(base, at);
    let value = program.increment(value);
    let inner = vec![
        stmt(StmtKind::Declare(x, None)),
        stmt(StmtKind::If(small, vec![stmt(StmtKind::Continue)], vec![])),
        set(program.assign(place, value)),
    ];
    let step = program.get(i);
    let step = program.increment(step);
    body.push(round(&mut program, condition, inner, Some(step)));
    // while (bool more = next(i)) { if (more) break; }
    let more = program.local("more", BOOL, true);
    let operand = program.get(i);
    let condition = program.call(next, &[operand]);
    let asked = program.get(more);
    body.push(stmt(StmtKind::Loop(Loop {
        declared: Some(more),
        condition: Some(condition),
        tests_last: false,
        body: vec![stmt(StmtKind::If(
            asked,
            vec![stmt(StmtKind::Break)],
            vec![],
        ))],
        step: None,
        is_finite: false,
    })));
    // do { if (i < 3) continue; return; } while (next(i) && next(i));
    let small = less(&mut program, i, 3);
    let operands = [program.get(i), program.get(i)];
    let [left, right] = operands.map(|operand| program.call(next, &[operand]));
    let condition = program.expr(ExprKind::And(left, right), BOOL);
    body.push(stmt(StmtKind::Loop(Loop {
        declared: None,
        condition: Some(condition),
        tests_last: true,
        body: vec![
            stmt(StmtKind::If(small, vec![stmt(StmtKind::Continue)], vec![])),
            stmt(StmtKind::Return(None)),
            stmt(StmtKind::Discard),
        ],
        step: None,
        is_finite: true,
    })));
    let (base, at) = (program.get(a), program.get(i));
    let value = program.index(base, at);
    let value = program.construct(vec(4), &[value]);
    let place = program.get_global(color);
    body.push(set(program.assign(place, value)));
    let hir = program.finish(body);
    wgsl(&hir);
    let (lowered, _) = lowered(&hir, Precision::Double);
    assert_eq!(lowered.unguarded.loops.len(), 1);
    assert_eq!(
        lowered.unguarded.accesses.len(),
        1,
        "that by the counter is proven"
    );
}

#[test]
fn switches_of_every_kind() {
    let mut program = Program::new();
    let color = program.global("color", vec(4), GlobalKind::Output(0));
    program.begin("f", FLOAT);
    let n = program.parameter("n", INT, Direction::In);
    let x = program.local("x", FLOAT, true);
    let y = program.local("y", FLOAT, false);
    let count = |program: &mut Program| {
        let place = program.get(x);
        set(program.increment(place))
    };
    let mut switches = vec![stmt(StmtKind::Declare(x, None))];
    let i = program.local("i", INT, true);
    let condition = less(&mut program, i, 3);
    let mut body = Vec::new();
    for falls in [false, true] {
        let selector = program.get(n);
        let value = program.get(x);
        let condition = less(&mut program, n, 2);
        let mut first = vec![
            stmt(StmtKind::Declare(y, Some(value))),
            count(&mut program),
            stmt(StmtKind::If(
                condition,
                vec![stmt(StmtKind::Continue)],
                vec![],
            )),
        ];
        if !falls {
            first.push(stmt(StmtKind::Break));
        }
        let value = program.get(y);
        let arms = vec![
            Arm {
                labels: vec![Some(1), None],
                body: first,
            },
            Arm {
                labels: vec![Some(2)],
                body: vec![],
            },
            Arm {
                labels: vec![Some(3)],
                body: vec![stmt(StmtKind::Return(Some(value)))],
            },
            Arm {
                labels: vec![Some(4)],
                body: vec![],
            },
        ];
        body.push(stmt(StmtKind::Switch(Switch { selector, arms })));
    }
    let step = program.get(i);
    let step = program.increment(step);
    switches.push(stmt(StmtKind::Declare(i, None)));
    switches.push(round(&mut program, condition, body, Some(step)));
    let f = program.end(switches);
    program.begin("main", Type::VOID);
    let n = program.int(3);
    let value = program.call(f, &[n]);
    let value = program.construct(vec(4), &[value]);
    let place = program.get_global(color);
    let hir = {
        let body = vec![set(program.assign(place, value))];
        program.finish(body)
    };
    let text = wgsl(&hir);
    assert_eq!(text.matches("switch").count(), 3, "{text}");
    assert!(
        text.contains("return 0f;"),
        "what is not returned is zero:\n{text}"
    );
}
