//! Places, calls, constants, uniforms and tables.

use super::program::{E, Program, set, stmt};
use super::{BOOL, FLOAT, INT, array, lowered, vec, wgsl, write_all};
use crate::glsl::Precision;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::*;
use crate::glsl::types::{Scalar, Type};

fn output(program: &mut Program) -> Id {
    program.global("color", vec(4), GlobalKind::Output(0))
}

type Id = crate::glsl::arena::Id<Global>;

/// `color = vec4(value)`
fn show(program: &mut Program, output: Id, value: E) -> Stmt {
    let ty = program.ty(value);
    let value = if ty == vec(4) {
        value
    } else {
        program.construct(vec(4), &[value])
    };
    let place = program.get_global(output);
    set(program.assign(place, value))
}

#[test]
fn places_of_every_kind() {
    let mut program = Program::new();
    let s = program.structure("S", &[("m", Type::matrix(3, 3)), ("v", array(vec(4), 3))]);
    let color = output(&mut program);
    program.begin("main", Type::VOID);
    let i = program.local("i", INT, true);
    let a = program.local("a", array(s, 2), true);
    let mut body = vec![
        stmt(StmtKind::Declare(i, None)),
        stmt(StmtKind::Declare(a, None)),
    ];
    let element = |program: &mut Program| {
        let (base, at) = (program.get(a), program.get(i));
        program.index(base, at)
    };
    // a[i].m[i].zx = vec2(1.0, 2.0);
    let base = element(&mut program);
    let base = program.member(base, 0);
    let at = program.get(i);
    let base = program.index(base, at);
    let place = program.swizzle(base, &[2, 0]);
    let value = program.constant(&[Value::Float(1.0), Value::Float(2.0)], vec(2));
    body.push(set(program.assign(place, value)));
    // a[i].v[i].wzy.yx[i] += 3.0;
    let base = element(&mut program);
    let base = program.member(base, 1);
    let at = program.get(i);
    let base = program.index(base, at);
    let base = program.swizzle(base, &[3, 2, 1]);
    let base = program.swizzle(base, &[1, 0]);
    let at = program.get(i);
    let place = program.index(base, at);
    let value = program.float(3.0);
    let add = program.expr(ExprKind::Compound(BinaryOp::Add, place, value), FLOAT);
    body.push(set(add));
    // a[i++].v[2].xw *= 2.0;
    let (base, at) = (program.get(a), program.get(i));
    let at = program.increment(at);
    let base = program.index(base, at);
    let base = program.member(base, 1);
    let two = program.int(2);
    let base = program.index(base, two);
    let place = program.swizzle(base, &[0, 3]);
    let value = program.float(2.0);
    let kind = ExprKind::Compound(BinaryOp::Multiply, place, value);
    body.push(set(program.expr(kind, vec(2))));
    let base = element(&mut program);
    let base = program.member(base, 1);
    let zero = program.int(0);
    let value = program.index(base, zero);
    body.push(show(&mut program, color, value));
    let hir = program.finish(body);
    let text = wgsl(&hir);
    assert_eq!(
        text.matches("+ 1i").count(),
        1,
        "an index is evaluated once:\n{text}"
    );
    lowered(&hir, Precision::Double);
}

#[test]
fn what_is_passed_out_is_copied_where_it_must_be() {
    let mut program = Program::new();
    let color = output(&mut program);
    program.begin("swap", Type::VOID);
    let a = program.parameter("a", FLOAT, Direction::InOut);
    let b = program.parameter("b", FLOAT, Direction::InOut);
    let old = program.local("old", FLOAT, false);
    let value = program.get(a);
    let mut body = vec![stmt(StmtKind::Declare(old, Some(value)))];
    let (place, value) = (program.get(a), program.get(b));
    body.push(set(program.assign(place, value)));
    let (place, value) = (program.get(b), program.get(old));
    body.push(set(program.assign(place, value)));
    let swap = program.end(body);
    program.begin("pass", Type::VOID);
    let a = program.parameter("a", FLOAT, Direction::InOut);
    let b = program.parameter("b", FLOAT, Direction::Out);
    let operands = [program.get(a), program.get(b)];
    let call = program.call(swap, &operands);
    let pass = program.end(vec![set(call)]);
    program.begin("main", Type::VOID);
    let x = program.local("x", FLOAT, true);
    let v = program.local("v", vec(4), true);
    let value = program.float(1.0);
    let mut body = vec![
        stmt(StmtKind::Declare(x, Some(value))),
        stmt(StmtKind::Declare(v, None)),
    ];
    // pass(x, v.y); pass(v.x, v.z); swap(x, x);
    let base = program.get(v);
    let operands = [program.get(x), program.swizzle(base, &[1])];
    body.push(set(program.call(pass, &operands)));
    let bases = [program.get(v), program.get(v)];
    let operands = [
        program.swizzle(bases[0], &[0]),
        program.swizzle(bases[1], &[2]),
    ];
    body.push(set(program.call(pass, &operands)));
    let operands = [program.get(x), program.get(x)];
    body.push(set(program.call(swap, &operands)));
    let value = program.get(v);
    body.push(show(&mut program, color, value));
    let text = wgsl(&program.finish(body));
    assert!(
        text.contains("swap(a_1, b_1)"),
        "parameters are passed on:\n{text}"
    );
    assert!(
        text.contains("pass_((&x), (&"),
        "variables are passed:\n{text}"
    );
    assert!(!text.contains("((&x), (&x))"), "but not twice:\n{text}");
}

#[test]
fn constants_that_are_no_literals() {
    let mut program = Program::new();
    let color = output(&mut program);
    program.begin("main", Type::VOID);
    let values = [f64::INFINITY, f64::NAN, -0.0, 1e300].map(Value::Float);
    let value = program.constant(&values, vec(4));
    let mut body = vec![show(&mut program, color, value)];
    let i = program.local("i", INT, true);
    body.push(stmt(StmtKind::Declare(i, None)));
    // A divisor that is zero.
    let (left, right) = (program.get(i), program.int(0));
    let value = program.binary(BinaryOp::Divide, left, right, INT);
    body.push(show(&mut program, color, value));
    let two = Type::vector(Scalar::Int, 2);
    let left = program.get(i);
    let left = program.construct(two, &[left]);
    let right = program.constant(&[Value::Int(0), Value::Int(3)], two);
    let value = program.binary(BinaryOp::Remainder, left, right, two);
    let value = program.swizzle(value, &[0, 0, 1, 1]);
    body.push(show(&mut program, color, value));
    // A shift by more than there is.
    let (left, right) = (program.get(i), program.int(35));
    let value = program.binary(BinaryOp::ShiftLeft, left, right, INT);
    body.push(show(&mut program, color, value));
    let hir = program.finish(body);
    wgsl(&hir);
    lowered(&hir, Precision::Double);
}

/// A program that picks an element of a constant array.
fn pick(length: u32, element: Type) -> Hir {
    let mut program = Program::new();
    let color = output(&mut program);
    program.begin("main", Type::VOID);
    let i = program.local("i", INT, true);
    let values: Vec<_> = (0..length * program.hir.value_count(element))
        .map(|i| Value::Float(f64::from(i) / 3.0))
        .collect();
    let ty = array(element, length);
    let table = program.constant(&values, ty);
    let at = program.get(i);
    let at = program.increment(at);
    let mut value = program.index(table, at);
    if element.is_matrix() {
        let at = program.get(i);
        value = program.index(value, at);
    }
    let mut body = vec![stmt(StmtKind::Declare(i, None))];
    body.push(show(&mut program, color, value));
    // A variable that begins as the table.
    let local = program.local("local", ty, true);
    let table = program.constant(&values, ty);
    body.push(stmt(StmtKind::Declare(local, Some(table))));
    let (base, at) = (program.get(local), program.get(i));
    let place = program.index(base, at);
    let same = {
        let (base, at) = (program.get(local), program.get(i));
        program.index(base, at)
    };
    body.push(set(program.assign(place, same)));
    program.finish(body)
}

#[test]
fn large_tables_are_in_a_buffer() {
    for element in [FLOAT, vec(4), Type::matrix(4, 4)] {
        let count = Program::new().hir.value_count(element);
        for length in [64 / count, 128, 40_000 / count] {
            let hir = pick(length, element);
            for precision in [Precision::Single, Precision::Double] {
                let (lowered, info) = lowered(&hir, precision);
                let words = length * count * if precision == Precision::Single { 1 } else { 2 };
                match &lowered.tables {
                    None => assert!(length * count <= 64),
                    Some(tables) => {
                        assert!(length * count > 64);
                        assert_eq!(tables.words.len(), words as usize, "the same table once");
                        assert_eq!(tables.in_storage, words * 2 > 16_384);
                    }
                }
                if precision == Precision::Single {
                    write_all(&lowered.module, &info);
                }
            }
        }
    }
}

#[test]
fn uniforms_are_laid_out_like_std140() {
    let mut program = Program::new();
    let color = output(&mut program);
    let known = [
        ("iOn", BOOL),
        ("iTime", FLOAT),
        ("iResolution", vec(3)),
        ("iMatrix", Type::matrix(3, 2)),
        ("iChannelTime", array(FLOAT, 4)),
        ("other", vec(4)),
        ("large", array(vec(4), 64)),
    ];
    let globals = known.map(|(name, ty)| program.global(name, ty, GlobalKind::Uniform));
    program.begin("main", Type::VOID);
    let i = program.local("i", INT, true);
    let mut body = vec![stmt(StmtKind::Declare(i, None))];
    for global in globals {
        let mut value = program.get_global(global);
        let ty = program.ty(value);
        if ty.is_matrix() || ty.is_array() {
            // Once whole, once a part.
            let whole = program.local("whole", ty, false);
            body.push(stmt(StmtKind::Declare(whole, Some(value))));
            let place = program.get_global(global);
            let at = program.get(i);
            value = program.index(place, at);
        }
        let ty = program.ty(value);
        if ty.is_vector() {
            value = program.swizzle(value, &[0, 1, 0, 1]);
        }
        body.push(show(&mut program, color, value));
    }
    let hir = program.finish(body);
    let text = wgsl(&hir);
    let (lowered, _) = lowered(&hir, Precision::Double);
    let block = lowered.uniforms.expect("there are uniforms");
    let members: Vec<_> = block.members.iter().map(|m| (&*m.name, m.offset)).collect();
    let expected = [
        ("iResolution", 0),
        ("iTime", 12),
        ("iChannelTime", 16),
        ("iMatrix", 80),
        ("iOn", 128),
    ];
    assert_eq!(members, expected, "{text}");
    // The program's own come last, and need not be known to the host.
    assert_eq!(block.size, 160);
    assert!(text.contains("uniforms.other"), "{text}");
    assert!(
        !text.contains("large"),
        "what there is no room for is zero:\n{text}"
    );
}

#[test]
fn a_choice_evaluates_what_it_must() {
    let mut program = Program::new();
    let color = output(&mut program);
    program.begin("f", BOOL);
    let value = program.constant(&[Value::Bool(true)], BOOL);
    let f = program.end(vec![stmt(StmtKind::Return(Some(value)))]);
    program.begin("main", Type::VOID);
    let mut calls = || program.call(f, &[]);
    let [a, b, c] = [calls(), calls(), calls()];
    let and = program.expr(ExprKind::And(a, b), BOOL);
    let condition = program.expr(ExprKind::Or(and, c), BOOL);
    let [yes, no] = [1.0, 2.0].map(|value| program.float(value));
    let value = program.expr(ExprKind::Ternary(condition, yes, no), FLOAT);
    let mut body = vec![show(&mut program, color, value)];
    // A structure cannot be selected.
    let s = program.structure("S", &[("a", FLOAT), ("b", FLOAT)]);
    let pair = [Value::Float(1.0), Value::Float(2.0)];
    let [yes, no] = [0, 1].map(|_| program.constant(&pair, s));
    let condition = program.call(f, &[]);
    let value = program.expr(ExprKind::Ternary(condition, yes, no), s);
    let value = program.member(value, 1);
    body.push(show(&mut program, color, value));
    let text = wgsl(&program.finish(body));
    assert_eq!(text.matches("select").count(), 1, "{text}");
    assert!(text.matches("if ").count() >= 3, "{text}");
}

#[test]
fn globals_begin_before_main() {
    let mut program = Program::new();
    let color = output(&mut program);
    let time = program.global("iTime", FLOAT, GlobalKind::Uniform);
    let one = program.hir.constants.add(&[Value::Float(1.0)]);
    let a = program.global("a", FLOAT, GlobalKind::Private(Some(one)));
    let b = program.global("b", FLOAT, GlobalKind::Private(None));
    let position = program.global("gl_FragCoord", vec(4), GlobalKind::FragCoord);
    program.begin("globals", Type::VOID);
    let (place, value) = (program.get_global(b), program.get_global(time));
    let set_b = program.assign(place, value);
    let initialisers = program.end(vec![set(set_b)]);
    program.hir.initialisers = Some(initialisers);
    program.begin("f", FLOAT);
    let value = program.get_global(position);
    let x = program.swizzle(value, &[0]);
    let sum = {
        let value = program.get_global(a);
        program.binary(BinaryOp::Add, x, value, FLOAT)
    };
    let f = program.end(vec![stmt(StmtKind::Return(Some(sum)))]);
    program.begin("main", Type::VOID);
    let place = program.get_global(a);
    let mut body = vec![set(program.increment(place))];
    let value = program.call(f, &[]);
    body.push(show(&mut program, color, value));
    let unneeded = wgsl(&program.hir_with_main(body.clone()));
    assert!(!unneeded.contains("globals"), "{unneeded}");
    let value = program.get_global(b);
    body.push(show(&mut program, color, value));
    let position = program.get_global(position);
    let derivative = program.builtin(Builtin::DFdx, &[position], vec(4));
    body.push(show(&mut program, color, derivative));
    let hir = program.finish(body);
    let text = wgsl(&hir);
    assert!(text.contains("globals();"), "{text}");
    assert!(text.contains("gl_FragCoord = position"), "{text}");
    lowered(&hir, Precision::Double);
}
