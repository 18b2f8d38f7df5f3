//! The built-in functions of GLSL ES 3.00, §8, and its built-in variables and constants, §7.

pub mod constants;
mod lookup;
mod signature;
mod table;
mod texture;

use self::table::ROWS;
use super::types::Type;

pub use self::texture::{Level, Lookup};

/// A built-in function; which of its signatures is meant, the types of the arguments tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each is the function of that name")]
pub enum Builtin {
    // §8.1 Angle and trigonometry
    Radians,
    Degrees,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    // §8.2 Exponential
    Pow,
    Exp,
    Log,
    Exp2,
    Log2,
    Sqrt,
    InverseSqrt,
    // §8.3 Common
    Abs,
    Sign,
    Floor,
    Trunc,
    Round,
    RoundEven,
    Ceil,
    Fract,
    Mod,
    Modf,
    Min,
    Max,
    Clamp,
    Mix,
    Step,
    SmoothStep,
    IsNan,
    IsInf,
    FloatBitsToInt,
    FloatBitsToUint,
    IntBitsToFloat,
    UintBitsToFloat,
    // §8.4 Floating-point pack and unpack
    PackSnorm2x16,
    UnpackSnorm2x16,
    PackUnorm2x16,
    UnpackUnorm2x16,
    PackHalf2x16,
    UnpackHalf2x16,
    // §8.5 Geometric
    Length,
    Distance,
    Dot,
    Cross,
    Normalize,
    FaceForward,
    Reflect,
    Refract,
    // §8.6 Matrix
    MatrixCompMult,
    OuterProduct,
    Transpose,
    Determinant,
    Inverse,
    // §8.7 Vector relational
    LessThan,
    LessThanEqual,
    GreaterThan,
    GreaterThanEqual,
    Equal,
    NotEqual,
    Any,
    All,
    Not,
    // §8.8 Texture lookup
    TextureSize,
    Texture,
    TextureProj,
    TextureLod,
    TextureOffset,
    TexelFetch,
    TexelFetchOffset,
    TextureProjOffset,
    TextureLodOffset,
    TextureProjLod,
    TextureProjLodOffset,
    TextureGrad,
    TextureGradOffset,
    TextureProjGrad,
    TextureProjGradOffset,
    // §8.9 Fragment processing
    DFdx,
    DFdy,
    Fwidth,
}

impl Builtin {
    /// How many there are.
    pub const COUNT: usize = Builtin::Fwidth as usize + 1;

    /// Every function, in the order of the specification.
    pub const ALL: [Builtin; Builtin::COUNT] = table::ALL;

    /// How it is written.
    pub fn name(self) -> &'static str {
        ROWS[self as usize].name
    }

    /// The section of the specification, such as `8.3`.
    pub fn section(self) -> &'static str {
        ROWS[self as usize].section
    }

    /// What a call with arguments of these types returns; `None` when there is no such signature.
    /// Types must be equal: nothing converts by itself, §6.1.
    pub fn result(self, arguments: &[Type]) -> Option<Type> {
        let mut signatures = ROWS[self as usize].signatures.iter();
        signatures.find_map(|signature| signature.result(arguments))
    }

    /// Every signature as the specification writes it, for people: `genType mod(genType, float)`.
    pub fn signatures(self) -> Vec<String> {
        let signatures = ROWS[self as usize].signatures.iter();
        signatures
            .map(|signature| signature.spell(self.name(), self.writes()))
            .collect()
    }

    /// The argument that a call sets, if there is one.
    pub const fn writes(self) -> Option<usize> {
        match self {
            Builtin::Modf => Some(1),
            _ => None,
        }
    }

    /// Whether a call's value depends on the neighbouring pixels: a call in one branch of several
    /// may have none, §8.8 and §8.9.
    pub fn needs_derivatives(self) -> bool {
        match self {
            Builtin::DFdx | Builtin::DFdy | Builtin::Fwidth => true,
            _ => self
                .lookup()
                .is_some_and(|lookup| lookup.level == Level::Implicit),
        }
    }

    /// Whether a call with constant arguments is a constant expression, §4.3.3. Texture lookups are
    /// none because samplers aren't, derivatives because WebGL2 says so, `modf` because it writes.
    pub fn is_constant_expression(self) -> bool {
        !matches!(
            self,
            Builtin::DFdx | Builtin::DFdy | Builtin::Fwidth | Builtin::Modf
        ) && !self.is_texture_function()
    }

    /// Whether the first argument is a sampler.
    pub fn is_texture_function(self) -> bool {
        self == Builtin::TextureSize || self.lookup().is_some()
    }

    /// Whether programs may declare functions of this name, even of the same signature. §6.1 says
    /// that none may; WebGL2 misses the names which also have signatures that an extension or a
    /// later version brings, because it remembers for a name only what its last signature needs.
    pub const fn can_be_overloaded_by_user(self) -> bool {
        matches!(
            self,
            Builtin::Mix
                | Builtin::Texture
                | Builtin::TextureLod
                | Builtin::TextureGrad
                | Builtin::TextureSize
                | Builtin::TexelFetch
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glsl::types::{Base, Scalar};

    /// The type that a word such as `vec3` names.
    fn ty(word: &str) -> Type {
        Base::from_keyword(word)
            .unwrap_or_else(|| panic!("{word} names no type"))
            .into()
    }

    #[test]
    fn each_row_stands_at_its_functions_place() {
        for (place, function) in Builtin::ALL.into_iter().enumerate() {
            assert_eq!(function as usize, place);
            assert_eq!(ROWS[place].function, function);
            assert!(function.section().starts_with("8."));
            assert!(!function.signatures().is_empty());
        }
    }

    #[test]
    fn calls_find_their_signature() {
        // Each line is a call, and what it returns if it has a signature.
        let calls = "
            sin float : float
            sin vec3 : vec3
            sin int :
            sin :
            sin float float :
            atan vec2 : vec2
            atan vec2 vec2 : vec2
            atan vec2 vec3 :
            pow vec4 vec4 : vec4
            pow vec4 float :
            abs ivec2 : ivec2
            abs uint :
            floor ivec2 :
            mod vec3 float : vec3
            mod float vec3 :
            mod int int :
            modf vec2 vec2 : vec2
            min uvec3 uint : uvec3
            min int int : int
            max ivec2 ivec2 : ivec2
            max ivec2 uint :
            clamp vec3 float float : vec3
            clamp vec3 vec3 float :
            clamp uint uint uint : uint
            mix vec2 vec2 float : vec2
            mix vec2 vec2 bvec2 : vec2
            mix float float bool : float
            mix vec2 vec2 bool :
            mix int int bool :
            step float vec3 : vec3
            step vec3 float :
            smoothstep float float vec4 : vec4
            smoothstep float vec4 vec4 :
            isnan vec3 : bvec3
            floatBitsToUint vec3 : uvec3
            uintBitsToFloat uint : float
            packHalf2x16 vec2 : uint
            unpackHalf2x16 uint : vec2
            unpackHalf2x16 int :
            length float : float
            length ivec2 :
            cross vec3 vec3 : vec3
            cross vec2 vec2 :
            refract vec3 vec3 float : vec3
            refract float float float : float
            matrixCompMult mat2x3 mat2x3 : mat2x3
            matrixCompMult mat2x3 mat3x2 :
            outerProduct vec2 vec3 : mat3x2
            outerProduct float vec3 :
            transpose mat2x3 : mat3x2
            determinant mat3 : float
            determinant mat2x3 :
            inverse mat4 : mat4
            lessThan uvec2 uvec2 : bvec2
            lessThan float float :
            lessThan bvec2 bvec2 :
            equal bvec4 bvec4 : bvec4
            any bvec2 : bool
            any bool :
            not bvec3 : bvec3
            textureSize samplerCube int : ivec2
            textureSize sampler2DArrayShadow int : ivec3
            textureSize sampler2D :
            texture sampler2D vec2 : vec4
            texture sampler2D vec2 float : vec4
            texture isampler3D vec3 : ivec4
            texture usamplerCube vec3 float : uvec4
            texture sampler2DShadow vec3 : float
            texture sampler2DArrayShadow vec4 : float
            texture sampler2DArrayShadow vec4 float :
            texture sampler2D vec3 :
            texture vec2 vec2 :
            textureLod sampler2DShadow vec3 float : float
            textureLod samplerCubeShadow vec4 float :
            texelFetch usampler2DArray ivec3 int : uvec4
            texelFetch samplerCube ivec3 int :
            textureGrad samplerCubeShadow vec4 vec3 vec3 : float
            textureProjGradOffset sampler3D vec4 vec3 vec3 ivec3 : vec4
            textureOffset sampler2D vec2 ivec2 float : vec4
            textureOffset samplerCube vec3 ivec3 :
            dFdx vec3 : vec3
            fwidth int :
        ";
        for line in calls.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let (call, result) = line.split_once(':').expect("a colon");
            let mut words = call.split_whitespace();
            let function = words.next().and_then(Builtin::find).expect(line);
            let arguments: Vec<_> = words.map(ty).collect();
            let expected = Some(result.trim()).filter(|word| !word.is_empty()).map(ty);
            assert_eq!(function.result(&arguments), expected, "{line}");
        }
        assert_eq!(Builtin::Sin.result(&[Type::FLOAT.array_of(1)]), None);
    }

    #[test]
    fn signatures_read_as_the_specification_has_them() {
        assert_eq!(
            Builtin::Mod.signatures(),
            [
                "genType mod(genType, float)",
                "genType mod(genType, genType)"
            ]
        );
        assert_eq!(
            Builtin::Modf.signatures(),
            ["genType modf(genType, out genType)"]
        );
        assert_eq!(
            Builtin::OuterProduct.signatures(),
            ["mat outerProduct(vec, vec)"]
        );
        assert_eq!(
            Builtin::TexelFetch.signatures()[0],
            "gvec4 texelFetch(gsampler2D, ivec2, int)"
        );
        assert_eq!(
            Builtin::TextureLod.signatures().last().map(String::as_str),
            Some("float textureLod(sampler2DShadow, vec3, float)")
        );
    }

    #[test]
    fn few_functions_are_special() {
        let which = |has: fn(Builtin) -> bool| {
            let names = Builtin::ALL.into_iter().filter(|&function| has(function));
            names.map(Builtin::name).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(which(|function| function.writes().is_some()), "modf");
        assert_eq!(
            which(Builtin::needs_derivatives),
            "texture textureProj textureOffset textureProjOffset dFdx dFdy fwidth"
        );
        assert_eq!(
            which(Builtin::can_be_overloaded_by_user),
            "mix textureSize texture textureLod texelFetch textureGrad"
        );
        assert_eq!(
            which(|function| !function.is_constant_expression() && !function.is_texture_function()),
            "modf dFdx dFdy fwidth"
        );
        assert_eq!(Type::vector(Scalar::Float, 4), ty("vec4"));
    }
}
