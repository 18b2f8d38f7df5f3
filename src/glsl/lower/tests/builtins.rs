//! Every signature of every built-in function, and every mixture of operands.

use super::program::{E, Program, set, stmt};
use super::{BOOL, FLOAT, INT, array, lowered, vec, write_all};
use crate::glsl::Precision;
use crate::glsl::builtins::Builtin as B;
use crate::glsl::hir::*;
use crate::glsl::types::{Base, Sampler, Scalar, Shape, Type};

/// A program of which every statement keeps one value, behind an `if` on its first component.
struct Uses {
    program: Program,
    body: Block,
}

impl Uses {
    fn new() -> Self {
        let mut program = Program::new();
        program.begin("main", Type::VOID);
        let body = Vec::new();
        Uses { program, body }
    }

    /// Some variable of a type.
    fn any(&mut self, ty: Type) -> E {
        let name = format!("v{}", self.program.hir.globals.len());
        let global = self.program.global(&name, ty, GlobalKind::Private(None));
        let place = self.program.get_global(global);
        let value = self.program.get_global(global);
        // What is assigned to is no constant.
        let again = self.program.assign(place, value);
        self.body.push(set(again));
        self.program.get_global(global)
    }

    fn keep(&mut self, value: E) {
        let ty = self.program.ty(value);
        let name = format!("r{}", self.program.hir.globals.len());
        let global = self.program.global(&name, ty, GlobalKind::Private(None));
        let place = self.program.get_global(global);
        let assigned = self.program.assign(place, value);
        self.body.push(set(assigned));
    }

    fn call(&mut self, builtin: B, operands: &[Type], result: Type) {
        let operands: Vec<_> = operands.iter().map(|ty| self.any(*ty)).collect();
        let value = self.program.builtin(builtin, &operands, result);
        self.keep(value);
    }

    fn finish(self, both: bool) {
        let hir = self.program.finish(self.body);
        let (single, info) = lowered(&hir, Precision::Single);
        write_all(&single.module, &info);
        if both {
            lowered(&hir, Precision::Double);
        }
    }
}

fn ivec(size: u8) -> Type {
    Type::vector(Scalar::Int, size)
}

fn uvec(size: u8) -> Type {
    Type::vector(Scalar::Uint, size)
}

fn bvec(size: u8) -> Type {
    Type::vector(Scalar::Bool, size)
}

#[test]
fn functions_of_components() {
    let mut uses = Uses::new();
    for size in 1..=4 {
        let v = vec(size);
        for builtin in [
            B::Radians,
            B::Degrees,
            B::Sin,
            B::Cos,
            B::Tan,
            B::Asin,
            B::Acos,
            B::Atan,
            B::Sinh,
            B::Cosh,
            B::Tanh,
            B::Asinh,
            B::Acosh,
            B::Atanh,
            B::Exp,
            B::Log,
            B::Exp2,
            B::Log2,
            B::Sqrt,
            B::InverseSqrt,
            B::Abs,
            B::Sign,
            B::Floor,
            B::Trunc,
            B::Round,
            B::RoundEven,
            B::Ceil,
            B::Fract,
            B::Normalize,
            B::DFdx,
            B::DFdy,
            B::Fwidth,
        ] {
            uses.call(builtin, &[v], v);
        }
        for builtin in [
            B::Atan,
            B::Pow,
            B::Mod,
            B::Min,
            B::Max,
            B::Step,
            B::Modf,
            B::Reflect,
        ] {
            uses.call(builtin, &[v, v], v);
        }
        for builtin in [B::Clamp, B::Mix, B::SmoothStep, B::FaceForward] {
            uses.call(builtin, &[v, v, v], v);
        }
        uses.call(B::Mod, &[v, FLOAT], v);
        uses.call(B::Min, &[v, FLOAT], v);
        uses.call(B::Max, &[v, FLOAT], v);
        uses.call(B::Step, &[FLOAT, v], v);
        uses.call(B::Clamp, &[v, FLOAT, FLOAT], v);
        uses.call(B::Mix, &[v, v, FLOAT], v);
        uses.call(B::Mix, &[v, v, bvec(size)], v);
        uses.call(B::SmoothStep, &[FLOAT, FLOAT, v], v);
        uses.call(B::Refract, &[v, v, FLOAT], v);
        uses.call(B::IsNan, &[v], bvec(size));
        uses.call(B::IsInf, &[v], bvec(size));
        uses.call(B::Length, &[v], FLOAT);
        uses.call(B::Distance, &[v, v], FLOAT);
        uses.call(B::Dot, &[v, v], FLOAT);
        uses.call(B::FloatBitsToInt, &[v], ivec(size));
        uses.call(B::FloatBitsToUint, &[v], uvec(size));
        uses.call(B::IntBitsToFloat, &[ivec(size)], v);
        uses.call(B::UintBitsToFloat, &[uvec(size)], v);
        for v in [ivec(size), uvec(size)] {
            let scalar = Type::vector(v.scalar().expect("a vector"), 1);
            uses.call(B::Min, &[v, v], v);
            uses.call(B::Max, &[v, scalar], v);
            uses.call(B::Clamp, &[v, scalar, scalar], v);
            uses.call(B::Clamp, &[v, v, v], v);
        }
        uses.call(B::Abs, &[ivec(size)], ivec(size));
        uses.call(B::Sign, &[ivec(size)], ivec(size));
    }
    uses.call(B::Cross, &[vec(3), vec(3)], vec(3));
    for builtin in [B::PackSnorm2x16, B::PackUnorm2x16, B::PackHalf2x16] {
        uses.call(builtin, &[vec(2)], uvec(1));
    }
    for builtin in [B::UnpackSnorm2x16, B::UnpackUnorm2x16, B::UnpackHalf2x16] {
        uses.call(builtin, &[uvec(1)], vec(2));
    }
    for size in 2..=4 {
        for v in [vec(size), ivec(size), uvec(size)] {
            for builtin in [
                B::LessThan,
                B::LessThanEqual,
                B::GreaterThan,
                B::GreaterThanEqual,
                B::Equal,
                B::NotEqual,
            ] {
                uses.call(builtin, &[v, v], bvec(size));
            }
        }
        let v = bvec(size);
        uses.call(B::Equal, &[v, v], v);
        uses.call(B::NotEqual, &[v, v], v);
        uses.call(B::Any, &[v], BOOL);
        uses.call(B::All, &[v], BOOL);
        uses.call(B::Not, &[v], v);
    }
    uses.finish(true);
}

#[test]
fn operators_in_every_mixture() {
    use BinaryOp as Op;
    let mut uses = Uses::new();
    let mut operate = |op, left: Type, right: Type, result: Type| {
        let [left, right] = [left, right].map(|ty| uses.any(ty));
        let value = uses.program.binary(op, left, right, result);
        uses.keep(value);
    };
    for size in 1..=4 {
        for scalar in [Scalar::Float, Scalar::Int, Scalar::Uint] {
            let (v, s) = (Type::vector(scalar, size), Type::vector(scalar, 1));
            let ops = match scalar {
                Scalar::Float => &[Op::Add, Op::Subtract, Op::Multiply, Op::Divide][..],
                _ => &[
                    Op::Add,
                    Op::Subtract,
                    Op::Multiply,
                    Op::Divide,
                    Op::Remainder,
                    Op::BitAnd,
                    Op::BitOr,
                    Op::BitXor,
                ],
            };
            for &op in ops {
                operate(op, v, v, v);
                operate(op, v, s, v);
                operate(op, s, v, v);
            }
            operate(Op::Equal, v, v, BOOL);
            operate(Op::NotEqual, v, v, BOOL);
        }
        for op in [Op::ShiftLeft, Op::ShiftRight] {
            operate(op, ivec(size), uvec(size), ivec(size));
            operate(op, uvec(size), ivec(1), uvec(size));
            operate(op, ivec(size), ivec(size), ivec(size));
        }
        operate(Op::Equal, bvec(size), bvec(size), BOOL);
        operate(Op::NotEqual, bvec(size), bvec(size), BOOL);
    }
    for op in [Op::Less, Op::Greater, Op::LessEqual, Op::GreaterEqual] {
        operate(op, FLOAT, FLOAT, BOOL);
        operate(op, INT, INT, BOOL);
    }
    operate(Op::LogicalXor, BOOL, BOOL, BOOL);
    for columns in 2..=4 {
        for rows in 2..=4 {
            let m = Type::matrix(columns, rows);
            for op in [Op::Add, Op::Subtract, Op::Divide] {
                operate(op, m, m, m);
                operate(op, m, FLOAT, m);
                operate(op, FLOAT, m, m);
            }
            operate(Op::Multiply, m, FLOAT, m);
            operate(Op::Multiply, FLOAT, m, m);
            operate(Op::Multiply, m, vec(columns), vec(rows));
            operate(Op::Multiply, vec(rows), m, vec(columns));
            operate(
                Op::Multiply,
                m,
                Type::matrix(rows, columns),
                Type::matrix(rows, rows),
            );
            operate(Op::Equal, m, m, BOOL);
            operate(Op::NotEqual, m, m, BOOL);
        }
    }
    let s = uses
        .program
        .structure("S", &[("a", vec(3)), ("b", array(Type::matrix(2, 2), 2))]);
    for ty in [s, array(s, 2)] {
        for op in [Op::Equal, Op::NotEqual] {
            let [left, right] = [ty, ty].map(|ty| uses.any(ty));
            let value = uses.program.binary(op, left, right, BOOL);
            uses.keep(value);
        }
    }
    for ty in [
        FLOAT,
        vec(3),
        ivec(1),
        ivec(2),
        uvec(1),
        uvec(4),
        Type::matrix(3, 2),
    ] {
        let operand = uses.any(ty);
        let value = uses
            .program
            .expr(ExprKind::Unary(UnaryOp::Negate, operand), ty);
        uses.keep(value);
        let place = uses.any(ty);
        let value = uses.program.increment(place);
        uses.keep(value);
    }
    for ty in [ivec(1), uvec(3)] {
        let operand = uses.any(ty);
        let value = uses
            .program
            .expr(ExprKind::Unary(UnaryOp::Complement, operand), ty);
        uses.keep(value);
    }
    uses.finish(true);
}

#[test]
fn constructors_of_every_form() {
    let mut uses = Uses::new();
    let mut construct = |ty: Type, operands: &[Type]| {
        let operands: Vec<_> = operands.iter().map(|ty| uses.any(*ty)).collect();
        let value = uses.program.construct(ty, &operands);
        uses.keep(value);
    };
    let scalars = [Scalar::Float, Scalar::Int, Scalar::Uint, Scalar::Bool];
    for to in scalars {
        for from in scalars {
            for size in 1..=4 {
                let v = Type::vector(to, size);
                construct(v, &[Type::vector(from, 1)]);
                construct(v, &[Type::vector(from, size)]);
                construct(v, &[Type::vector(from, 4)]);
            }
            construct(Type::vector(to, 3), &[Type::vector(from, 1), vec(2)]);
            construct(Type::vector(to, 3), &[Type::vector(from, 2), vec(4)]);
        }
        construct(Type::vector(to, 4), &[Type::matrix(2, 2)]);
        construct(Type::vector(to, 3), &[INT, Type::matrix(3, 3)]);
        construct(Type::vector(to, 1), &[Type::matrix(2, 4)]);
    }
    for columns in 2..=4 {
        for rows in 2..=4 {
            let m = Type::matrix(columns, rows);
            construct(m, &[FLOAT]);
            construct(m, &[INT]);
            construct(m, &vec![FLOAT; usize::from(columns * rows)]);
            construct(m, &vec![vec(rows); columns.into()]);
            for columns in 2..=4 {
                for rows in 2..=4 {
                    construct(m, &[Type::matrix(columns, rows)]);
                }
            }
        }
    }
    construct(Type::matrix(2, 2), &[vec(4)]);
    construct(Type::matrix(2, 2), &[vec(3), BOOL]);
    construct(Type::matrix(3, 3), &[vec(4), vec(4), INT]);
    construct(array(vec(2), 3), &[vec(2), vec(2), vec(2)]);
    let s = uses
        .program
        .structure("S", &[("a", INT), ("b", array(FLOAT, 2))]);
    let operands = [INT, array(FLOAT, 2)].map(|ty| uses.any(ty));
    let value = uses.program.construct(s, &operands);
    uses.keep(value);
    uses.finish(true);
}

#[test]
fn matrix_functions() {
    let mut uses = Uses::new();
    for columns in 2..=4 {
        for rows in 2..=4 {
            let m = Type::matrix(columns, rows);
            uses.call(B::MatrixCompMult, &[m, m], m);
            uses.call(B::OuterProduct, &[vec(rows), vec(columns)], m);
            uses.call(B::Transpose, &[m], Type::matrix(rows, columns));
        }
        let m = Type::matrix(columns, columns);
        uses.call(B::Determinant, &[m], FLOAT);
        uses.call(B::Inverse, &[m], m);
    }
    uses.finish(true);
}

fn sampler(shape: Shape) -> Type {
    Type::of(Base::Sampler(Sampler {
        texel: Scalar::Float,
        shape,
        shadow: false,
    }))
}

/// Calls every lookup that a shape has, on a sampler that may have no texture.
fn look_up(uses: &mut Uses, channel: &str, shape: Shape) {
    let global = uses
        .program
        .global(channel, sampler(shape), GlobalKind::Uniform);
    let p = if shape == Shape::Plane { 2 } else { 3 };
    let d = if shape == Shape::Layers { 2 } else { p };
    let size = if matches!(shape, Shape::Plane | Shape::Cube) {
        2
    } else {
        3
    };
    let mut call = |builtin, operands: &[Type], offset: Option<usize>, result| {
        let mut values = vec![uses.program.get_global(global)];
        values.extend(operands.iter().map(|ty| uses.any(*ty)));
        if let Some(at) = offset {
            let ones = vec![Value::Int(1); d.into()];
            values.insert(at, uses.program.constant(&ones, ivec(d)));
        }
        let value = uses.program.builtin(builtin, &values, result);
        uses.keep(value);
    };
    call(B::TextureSize, &[INT], None, ivec(size));
    call(B::Texture, &[vec(p)], None, vec(4));
    call(B::Texture, &[vec(p), FLOAT], None, vec(4));
    call(B::TextureLod, &[vec(p), FLOAT], None, vec(4));
    call(B::TextureGrad, &[vec(p), vec(d), vec(d)], None, vec(4));
    if shape == Shape::Cube {
        return;
    }
    call(B::TexelFetch, &[ivec(p), INT], None, vec(4));
    call(B::TexelFetchOffset, &[ivec(p), INT], Some(3), vec(4));
    call(B::TextureOffset, &[vec(p)], Some(2), vec(4));
    call(B::TextureOffset, &[vec(p), FLOAT], Some(2), vec(4));
    call(B::TextureLodOffset, &[vec(p), FLOAT], Some(3), vec(4));
    call(
        B::TextureGradOffset,
        &[vec(p), vec(d), vec(d)],
        Some(4),
        vec(4),
    );
    if shape == Shape::Layers {
        return;
    }
    for q in (p + 1)..=4 {
        call(B::TextureProj, &[vec(q)], None, vec(4));
        call(B::TextureProj, &[vec(q), FLOAT], None, vec(4));
        call(B::TextureProjOffset, &[vec(q), FLOAT], Some(2), vec(4));
        call(B::TextureProjLod, &[vec(q), FLOAT], None, vec(4));
        call(B::TextureProjLodOffset, &[vec(q), FLOAT], Some(3), vec(4));
        call(B::TextureProjGrad, &[vec(q), vec(d), vec(d)], None, vec(4));
        call(
            B::TextureProjGradOffset,
            &[vec(q), vec(d), vec(d)],
            Some(4),
            vec(4),
        );
    }
}

#[test]
fn lookups_with_and_without_a_texture() {
    let shapes = [Shape::Plane, Shape::Volume, Shape::Cube, Shape::Layers];
    for (i, shape) in shapes.into_iter().enumerate() {
        let mut uses = Uses::new();
        look_up(&mut uses, &format!("iChannel{}", i % 3), shape);
        look_up(&mut uses, "unknown", shape);
        uses.finish(true);
    }
}

#[test]
fn samplers_are_passed_with_what_they_need() {
    let mut program = Program::new();
    let plane = sampler(Shape::Plane);
    program.begin("size", Type::vector(Scalar::Int, 2));
    let s = program.parameter("s", plane, Direction::In);
    let (sampler, level) = (program.get(s), program.int(0));
    let size = program.builtin(B::TextureSize, &[sampler, level], ivec(2));
    let size = program.end(vec![stmt(StmtKind::Return(Some(size)))]);
    program.begin("look", vec(4));
    let a = program.parameter("a", plane, Direction::In);
    let b = program.parameter("b", plane, Direction::In);
    let at = program.parameter("at", vec(2), Direction::In);
    let (sampler, at) = (program.get(a), program.get(at));
    let texel = program.builtin(B::Texture, &[sampler, at], vec(4));
    let sampler = program.get(b);
    let two = program.call(size, &[sampler]);
    let two = program.construct(vec(2), &[two]);
    let zero = program.float(0.0);
    let two = program.construct(vec(4), &[two, zero, zero]);
    let both = program.binary(BinaryOp::Add, texel, two, vec(4));
    let look = program.end(vec![stmt(StmtKind::Return(Some(both)))]);
    let known = program.global("iChannel0", plane, GlobalKind::Uniform);
    let unknown = program.global("texture0", plane, GlobalKind::Uniform);
    let output = program.global("color", vec(4), GlobalKind::Output(0));
    program.begin("main", Type::VOID);
    let mut body = Vec::new();
    for (a, b) in [(known, known), (unknown, known), (known, unknown)] {
        let operands = [program.get_global(a), program.get_global(b)];
        let at = program.constant(&[Value::Float(0.5), Value::Float(0.5)], vec(2));
        let value = program.call(look, &[operands[0], operands[1], at]);
        let place = program.get_global(output);
        body.push(set(program.assign(place, value)));
    }
    let hir = program.finish(body);
    let text = super::wgsl(&hir);
    assert_eq!(
        text.matches("fn look").count(),
        3,
        "one copy for each pattern:\n{text}"
    );
    assert_eq!(text.matches("fn size").count(), 2, "{text}");
    let lines: Vec<_> = text
        .lines()
        .filter(|line| line.contains("fn size"))
        .collect();
    assert!(
        lines.iter().all(|line| !line.contains("s_sampler")),
        "a size needs no sampler: {lines:?}"
    );
}
