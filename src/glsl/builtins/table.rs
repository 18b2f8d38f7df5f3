//! The functions, section by section as the specification lists them, with their signatures. A
//! texture lookup that takes a bias has that signature behind the others.

use super::Builtin;
use super::signature::{Signature, Slot};
use crate::glsl::types::{Scalar, Shape, Type};

/// A function of the specification.
#[derive(Debug)]
pub(super) struct Row {
    /// Which it is.
    pub(super) function: Builtin,
    /// How it is written.
    pub(super) name: &'static str,
    /// The section that has it.
    pub(super) section: &'static str,
    /// What it takes and returns.
    pub(super) signatures: &'static [Signature],
}

const FLOAT: Slot = Slot::Exact(Type::FLOAT);
const INT: Slot = Slot::Exact(Type::INT);
const UINT: Slot = Slot::Exact(Type::UINT);
const BOOL: Slot = Slot::Exact(Type::BOOL);
const VEC2: Slot = Slot::Exact(Type::vector(Scalar::Float, 2));
const VEC3: Slot = Slot::Exact(Type::vector(Scalar::Float, 3));
const VEC4: Slot = Slot::Exact(Type::vector(Scalar::Float, 4));
const IVEC2: Slot = Slot::Exact(Type::vector(Scalar::Int, 2));
const IVEC3: Slot = Slot::Exact(Type::vector(Scalar::Int, 3));
const GEN: Slot = Slot::Any(Scalar::Float);
const GENI: Slot = Slot::Any(Scalar::Int);
const GENU: Slot = Slot::Any(Scalar::Uint);
const GENB: Slot = Slot::Any(Scalar::Bool);
const VEC: Slot = Slot::Vector(Scalar::Float);
const IVEC: Slot = Slot::Vector(Scalar::Int);
const UVEC: Slot = Slot::Vector(Scalar::Uint);
const BVEC: Slot = Slot::Vector(Scalar::Bool);
const MAT: Slot = Slot::Matrix;
const SQUARE: Slot = Slot::Square;
const TRANSPOSED: Slot = Slot::Transposed;
const ROWVEC: Slot = Slot::Rows;
const COLUMNVEC: Slot = Slot::Columns;
const TEXEL: Slot = Slot::Texel;
const S2D: Slot = Slot::Sampler(Shape::Plane);
const S3D: Slot = Slot::Sampler(Shape::Volume);
const CUBE: Slot = Slot::Sampler(Shape::Cube);
const LAYERS: Slot = Slot::Sampler(Shape::Layers);
const S2DSHADOW: Slot = Slot::Shadow(Shape::Plane);
const CUBESHADOW: Slot = Slot::Shadow(Shape::Cube);
const LAYERSSHADOW: Slot = Slot::Shadow(Shape::Layers);

/// Writes the table with as little around the signatures as possible.
macro_rules! rows {
    ($($section:literal: {
        $($function:ident $name:literal $($result:ident($($parameter:ident),+))+;)+
    })+) => {
        /// Every function in order.
        pub(super) const ALL: [Builtin; Builtin::COUNT] = [$($(Builtin::$function,)+)+];

        /// Every function's name in order.
        pub(super) const NAMES: [&str; Builtin::COUNT] = [$($($name,)+)+];

        /// Every function, at the place that its number is.
        pub(super) static ROWS: [Row; Builtin::COUNT] = [$($(Row {
            function: Builtin::$function,
            name: $name,
            section: $section,
            signatures: &[$(Signature {
                result: $result,
                parameters: &[$($parameter),+],
            }),+],
        },)+)+];
    };
}

rows! {
    "8.1": {
        Radians "radians" GEN(GEN);
        Degrees "degrees" GEN(GEN);
        Sin "sin" GEN(GEN);
        Cos "cos" GEN(GEN);
        Tan "tan" GEN(GEN);
        Asin "asin" GEN(GEN);
        Acos "acos" GEN(GEN);
        Atan "atan" GEN(GEN, GEN) GEN(GEN);
        Sinh "sinh" GEN(GEN);
        Cosh "cosh" GEN(GEN);
        Tanh "tanh" GEN(GEN);
        Asinh "asinh" GEN(GEN);
        Acosh "acosh" GEN(GEN);
        Atanh "atanh" GEN(GEN);
    }
    "8.2": {
        Pow "pow" GEN(GEN, GEN);
        Exp "exp" GEN(GEN);
        Log "log" GEN(GEN);
        Exp2 "exp2" GEN(GEN);
        Log2 "log2" GEN(GEN);
        Sqrt "sqrt" GEN(GEN);
        InverseSqrt "inversesqrt" GEN(GEN);
    }
    "8.3": {
        Abs "abs" GEN(GEN) GENI(GENI);
        Sign "sign" GEN(GEN) GENI(GENI);
        Floor "floor" GEN(GEN);
        Trunc "trunc" GEN(GEN);
        Round "round" GEN(GEN);
        RoundEven "roundEven" GEN(GEN);
        Ceil "ceil" GEN(GEN);
        Fract "fract" GEN(GEN);
        Mod "mod" GEN(GEN, FLOAT) GEN(GEN, GEN);
        Modf "modf" GEN(GEN, GEN);
        Min "min"
            GEN(GEN, GEN) GEN(GEN, FLOAT)
            GENI(GENI, GENI) GENI(GENI, INT)
            GENU(GENU, GENU) GENU(GENU, UINT);
        Max "max"
            GEN(GEN, GEN) GEN(GEN, FLOAT)
            GENI(GENI, GENI) GENI(GENI, INT)
            GENU(GENU, GENU) GENU(GENU, UINT);
        Clamp "clamp"
            GEN(GEN, GEN, GEN) GEN(GEN, FLOAT, FLOAT)
            GENI(GENI, GENI, GENI) GENI(GENI, INT, INT)
            GENU(GENU, GENU, GENU) GENU(GENU, UINT, UINT);
        Mix "mix" GEN(GEN, GEN, GEN) GEN(GEN, GEN, FLOAT) GEN(GEN, GEN, GENB);
        Step "step" GEN(GEN, GEN) GEN(FLOAT, GEN);
        SmoothStep "smoothstep" GEN(GEN, GEN, GEN) GEN(FLOAT, FLOAT, GEN);
        IsNan "isnan" GENB(GEN);
        IsInf "isinf" GENB(GEN);
        FloatBitsToInt "floatBitsToInt" GENI(GEN);
        FloatBitsToUint "floatBitsToUint" GENU(GEN);
        IntBitsToFloat "intBitsToFloat" GEN(GENI);
        UintBitsToFloat "uintBitsToFloat" GEN(GENU);
    }
    "8.4": {
        PackSnorm2x16 "packSnorm2x16" UINT(VEC2);
        UnpackSnorm2x16 "unpackSnorm2x16" VEC2(UINT);
        PackUnorm2x16 "packUnorm2x16" UINT(VEC2);
        UnpackUnorm2x16 "unpackUnorm2x16" VEC2(UINT);
        PackHalf2x16 "packHalf2x16" UINT(VEC2);
        UnpackHalf2x16 "unpackHalf2x16" VEC2(UINT);
    }
    "8.5": {
        Length "length" FLOAT(GEN);
        Distance "distance" FLOAT(GEN, GEN);
        Dot "dot" FLOAT(GEN, GEN);
        Cross "cross" VEC3(VEC3, VEC3);
        Normalize "normalize" GEN(GEN);
        FaceForward "faceforward" GEN(GEN, GEN, GEN);
        Reflect "reflect" GEN(GEN, GEN);
        Refract "refract" GEN(GEN, GEN, FLOAT);
    }
    "8.6": {
        MatrixCompMult "matrixCompMult" MAT(MAT, MAT);
        OuterProduct "outerProduct" MAT(ROWVEC, COLUMNVEC);
        Transpose "transpose" TRANSPOSED(MAT);
        Determinant "determinant" FLOAT(SQUARE);
        Inverse "inverse" SQUARE(SQUARE);
    }
    "8.7": {
        LessThan "lessThan" BVEC(VEC, VEC) BVEC(IVEC, IVEC) BVEC(UVEC, UVEC);
        LessThanEqual "lessThanEqual" BVEC(VEC, VEC) BVEC(IVEC, IVEC) BVEC(UVEC, UVEC);
        GreaterThan "greaterThan" BVEC(VEC, VEC) BVEC(IVEC, IVEC) BVEC(UVEC, UVEC);
        GreaterThanEqual "greaterThanEqual" BVEC(VEC, VEC) BVEC(IVEC, IVEC) BVEC(UVEC, UVEC);
        Equal "equal" BVEC(VEC, VEC) BVEC(IVEC, IVEC) BVEC(UVEC, UVEC) BVEC(BVEC, BVEC);
        NotEqual "notEqual" BVEC(VEC, VEC) BVEC(IVEC, IVEC) BVEC(UVEC, UVEC) BVEC(BVEC, BVEC);
        Any "any" BOOL(BVEC);
        All "all" BOOL(BVEC);
        Not "not" BVEC(BVEC);
    }
    "8.8": {
        TextureSize "textureSize"
            IVEC2(S2D, INT) IVEC3(S3D, INT) IVEC2(CUBE, INT) IVEC3(LAYERS, INT)
            IVEC2(S2DSHADOW, INT) IVEC2(CUBESHADOW, INT) IVEC3(LAYERSSHADOW, INT);
        Texture "texture"
            TEXEL(S2D, VEC2) TEXEL(S3D, VEC3) TEXEL(CUBE, VEC3) TEXEL(LAYERS, VEC3)
            FLOAT(S2DSHADOW, VEC3) FLOAT(CUBESHADOW, VEC4) FLOAT(LAYERSSHADOW, VEC4)
            TEXEL(S2D, VEC2, FLOAT) TEXEL(S3D, VEC3, FLOAT) TEXEL(CUBE, VEC3, FLOAT)
            TEXEL(LAYERS, VEC3, FLOAT) FLOAT(S2DSHADOW, VEC3, FLOAT) FLOAT(CUBESHADOW, VEC4, FLOAT);
        TextureProj "textureProj"
            TEXEL(S2D, VEC3) TEXEL(S2D, VEC4) TEXEL(S3D, VEC4) FLOAT(S2DSHADOW, VEC4)
            TEXEL(S2D, VEC3, FLOAT) TEXEL(S2D, VEC4, FLOAT) TEXEL(S3D, VEC4, FLOAT)
            FLOAT(S2DSHADOW, VEC4, FLOAT);
        TextureLod "textureLod"
            TEXEL(S2D, VEC2, FLOAT) TEXEL(S3D, VEC3, FLOAT) TEXEL(CUBE, VEC3, FLOAT)
            TEXEL(LAYERS, VEC3, FLOAT) FLOAT(S2DSHADOW, VEC3, FLOAT);
        TextureOffset "textureOffset"
            TEXEL(S2D, VEC2, IVEC2) TEXEL(S3D, VEC3, IVEC3) FLOAT(S2DSHADOW, VEC3, IVEC2)
            TEXEL(LAYERS, VEC3, IVEC2)
            TEXEL(S2D, VEC2, IVEC2, FLOAT) TEXEL(S3D, VEC3, IVEC3, FLOAT)
            FLOAT(S2DSHADOW, VEC3, IVEC2, FLOAT) TEXEL(LAYERS, VEC3, IVEC2, FLOAT);
        TexelFetch "texelFetch"
            TEXEL(S2D, IVEC2, INT) TEXEL(S3D, IVEC3, INT) TEXEL(LAYERS, IVEC3, INT);
        TexelFetchOffset "texelFetchOffset"
            TEXEL(S2D, IVEC2, INT, IVEC2) TEXEL(S3D, IVEC3, INT, IVEC3)
            TEXEL(LAYERS, IVEC3, INT, IVEC2);
        TextureProjOffset "textureProjOffset"
            TEXEL(S2D, VEC3, IVEC2) TEXEL(S2D, VEC4, IVEC2) TEXEL(S3D, VEC4, IVEC3)
            FLOAT(S2DSHADOW, VEC4, IVEC2)
            TEXEL(S2D, VEC3, IVEC2, FLOAT) TEXEL(S2D, VEC4, IVEC2, FLOAT)
            TEXEL(S3D, VEC4, IVEC3, FLOAT) FLOAT(S2DSHADOW, VEC4, IVEC2, FLOAT);
        TextureLodOffset "textureLodOffset"
            TEXEL(S2D, VEC2, FLOAT, IVEC2) TEXEL(S3D, VEC3, FLOAT, IVEC3)
            FLOAT(S2DSHADOW, VEC3, FLOAT, IVEC2) TEXEL(LAYERS, VEC3, FLOAT, IVEC2);
        TextureProjLod "textureProjLod"
            TEXEL(S2D, VEC3, FLOAT) TEXEL(S2D, VEC4, FLOAT) TEXEL(S3D, VEC4, FLOAT)
            FLOAT(S2DSHADOW, VEC4, FLOAT);
        TextureProjLodOffset "textureProjLodOffset"
            TEXEL(S2D, VEC3, FLOAT, IVEC2) TEXEL(S2D, VEC4, FLOAT, IVEC2)
            TEXEL(S3D, VEC4, FLOAT, IVEC3) FLOAT(S2DSHADOW, VEC4, FLOAT, IVEC2);
        TextureGrad "textureGrad"
            TEXEL(S2D, VEC2, VEC2, VEC2) TEXEL(S3D, VEC3, VEC3, VEC3) TEXEL(CUBE, VEC3, VEC3, VEC3)
            FLOAT(S2DSHADOW, VEC3, VEC2, VEC2) FLOAT(CUBESHADOW, VEC4, VEC3, VEC3)
            TEXEL(LAYERS, VEC3, VEC2, VEC2) FLOAT(LAYERSSHADOW, VEC4, VEC2, VEC2);
        TextureGradOffset "textureGradOffset"
            TEXEL(S2D, VEC2, VEC2, VEC2, IVEC2) TEXEL(S3D, VEC3, VEC3, VEC3, IVEC3)
            FLOAT(S2DSHADOW, VEC3, VEC2, VEC2, IVEC2) TEXEL(LAYERS, VEC3, VEC2, VEC2, IVEC2)
            FLOAT(LAYERSSHADOW, VEC4, VEC2, VEC2, IVEC2);
        TextureProjGrad "textureProjGrad"
            TEXEL(S2D, VEC3, VEC2, VEC2) TEXEL(S2D, VEC4, VEC2, VEC2)
            TEXEL(S3D, VEC4, VEC3, VEC3) FLOAT(S2DSHADOW, VEC4, VEC2, VEC2);
        TextureProjGradOffset "textureProjGradOffset"
            TEXEL(S2D, VEC3, VEC2, VEC2, IVEC2) TEXEL(S2D, VEC4, VEC2, VEC2, IVEC2)
            TEXEL(S3D, VEC4, VEC3, VEC3, IVEC3) FLOAT(S2DSHADOW, VEC4, VEC2, VEC2, IVEC2);
    }
    "8.9": {
        DFdx "dFdx" GEN(GEN);
        DFdy "dFdy" GEN(GEN);
        Fwidth "fwidth" GEN(GEN);
    }
}
