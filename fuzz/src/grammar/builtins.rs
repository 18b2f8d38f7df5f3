//! Built-in functions by what they give.

use super::types::{FLOAT, INT, Scalar, Type};

/// A built-in function and what it takes, for a result of one type.
pub fn of(result: &Type) -> Vec<(&'static str, Vec<Type>)> {
    let vec = |size| Type::Vector(Scalar::Float, size);
    let mut found = Vec::new();
    let mut add = |names: &[&'static str], operands: &[Type]| {
        found.extend(names.iter().map(|&name| (name, operands.to_vec())));
    };
    let t = result.clone();
    match *result {
        Type::Vector(Scalar::Float, size) => {
            let names = [
                "sin",
                "cos",
                "tan",
                "asin",
                "acos",
                "atan",
                "sinh",
                "exp",
                "log",
                "exp2",
                "log2",
                "sqrt",
                "inversesqrt",
                "abs",
                "sign",
                "floor",
                "ceil",
                "fract",
                "round",
                "roundEven",
                "trunc",
                "dFdx",
                "fwidth",
                "radians",
                "normalize",
            ];
            add(&names, &[t.clone()]);
            add(
                &["pow", "mod", "min", "max", "step", "atan", "reflect"],
                &[t.clone(), t.clone()],
            );
            add(
                &["clamp", "mix", "smoothstep", "faceforward"],
                &[t.clone(), t.clone(), t.clone()],
            );
            add(&["mod", "min", "max"], &[t.clone(), FLOAT]);
            add(&["refract", "mix"], &[t.clone(), t.clone(), FLOAT]);
            add(
                &["mix"],
                &[t.clone(), t.clone(), Type::Vector(Scalar::Bool, size)],
            );
            add(&["intBitsToFloat"], &[Type::Vector(Scalar::Int, size)]);
            add(&["uintBitsToFloat"], &[Type::Vector(Scalar::Uint, size)]);
            if size == 1 {
                add(&["length"], &[vec(3)]);
                add(&["dot", "distance"], &[vec(2), vec(2)]);
                add(&["determinant"], &[Type::Matrix(3, 3)]);
            }
            if size == 2 {
                let word = [Type::Vector(Scalar::Uint, 1)];
                add(
                    &["unpackHalf2x16", "unpackSnorm2x16", "unpackUnorm2x16"],
                    &word,
                );
            }
            if size == 3 {
                add(&["cross"], &[vec(3), vec(3)]);
            }
        }
        Type::Vector(Scalar::Int, size) => {
            add(&["abs", "sign"], &[t.clone()]);
            add(&["min", "max"], &[t.clone(), t.clone()]);
            add(&["clamp"], &[t.clone(), t.clone(), t.clone()]);
            add(&["min", "max"], &[t.clone(), INT]);
            add(&["floatBitsToInt"], &[vec(size)]);
        }
        Type::Vector(Scalar::Uint, size) => {
            add(&["min", "max"], &[t.clone(), t.clone()]);
            add(&["clamp"], &[t.clone(), t.clone(), t.clone()]);
            add(&["floatBitsToUint"], &[vec(size)]);
            if size == 1 {
                add(
                    &["packHalf2x16", "packSnorm2x16", "packUnorm2x16"],
                    &[vec(2)],
                );
            }
        }
        Type::Vector(Scalar::Bool, size) => {
            add(&["isnan", "isinf"], &[vec(size)]);
            if size == 1 {
                add(&["any", "all"], &[Type::Vector(Scalar::Bool, 3)]);
            } else {
                let names = ["lessThan", "greaterThanEqual", "equal", "notEqual"];
                add(&names, &[vec(size), vec(size)]);
                let int = Type::Vector(Scalar::Int, size);
                add(&names, &[int.clone(), int]);
                add(&["not"], &[t.clone()]);
                add(&["equal"], &[t.clone(), t.clone()]);
            }
        }
        Type::Matrix(columns, rows) => {
            add(&["matrixCompMult"], &[t.clone(), t.clone()]);
            add(&["transpose"], &[Type::Matrix(rows, columns)]);
            add(&["outerProduct"], &[vec(rows), vec(columns)]);
            if columns == rows {
                add(&["inverse"], &[t.clone()]);
            }
        }
        _ => {}
    }
    found
}
