//! The built-in variables and constants of a fragment shader, §7.2 and §7.3.

use crate::glsl::hir::GlobalKind;
use crate::glsl::types::{Scalar, Type};

/// A built-in variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variable {
    /// How it is written.
    pub name: &'static str,
    /// Its type.
    pub ty: Type,
    /// Which it is.
    pub kind: GlobalKind,
}

/// Every built-in variable but `gl_DepthRange`, which is a structure.
pub const VARIABLES: [Variable; 4] = [
    Variable {
        name: "gl_FragCoord",
        ty: Type::vector(Scalar::Float, 4),
        kind: GlobalKind::FragCoord,
    },
    Variable {
        name: "gl_FrontFacing",
        ty: Type::BOOL,
        kind: GlobalKind::FrontFacing,
    },
    Variable {
        name: "gl_PointCoord",
        ty: Type::vector(Scalar::Float, 2),
        kind: GlobalKind::PointCoord,
    },
    Variable {
        name: "gl_FragDepth",
        ty: Type::FLOAT,
        kind: GlobalKind::FragDepth,
    },
];

/// `gl_DepthRange`, §7.4: the name of its type, and its members with the values that a host has which
/// never sets a depth range.
pub const DEPTH_RANGE: (&str, [(&str, f64); 3]) = (
    "gl_DepthRangeParameters",
    [("near", 0.0), ("far", 1.0), ("diff", 1.0)],
);

impl Variable {
    /// The built-in variable of this name.
    pub fn find(name: &str) -> Option<Variable> {
        VARIABLES.into_iter().find(|variable| variable.name == name)
    }
}

/// The value of a built-in constant; each is an `int`. Limits are those that browsers report on most
/// desktop GPUs, so that arrays sized by them are as authors know them.
pub fn constant(name: &str) -> Option<i32> {
    Some(match name.strip_prefix("gl_M")? {
        "axVertexAttribs" => 16,
        "axVertexUniformVectors" => 4096,
        "axVertexOutputVectors" => 31,
        "axFragmentInputVectors" => 31,
        "axVertexTextureImageUnits" => 16,
        "axCombinedTextureImageUnits" => 32,
        "axTextureImageUnits" => 16,
        "axFragmentUniformVectors" => 1024,
        "axDrawBuffers" => 8,
        "inProgramTexelOffset" => -8,
        "axProgramTexelOffset" => 7,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_reach_the_specified_minimum() {
        for (name, least) in [
            ("gl_MaxVertexAttribs", 16),
            ("gl_MaxVertexUniformVectors", 256),
            ("gl_MaxVertexOutputVectors", 16),
            ("gl_MaxFragmentInputVectors", 15),
            ("gl_MaxVertexTextureImageUnits", 16),
            ("gl_MaxCombinedTextureImageUnits", 32),
            ("gl_MaxTextureImageUnits", 16),
            ("gl_MaxFragmentUniformVectors", 224),
            ("gl_MaxDrawBuffers", 4),
            ("gl_MaxProgramTexelOffset", 7),
        ] {
            assert!(constant(name).is_some_and(|value| value >= least), "{name}");
        }
        assert_eq!(constant("gl_MinProgramTexelOffset"), Some(-8));
        assert_eq!(constant("gl_MaxVaryingVectors"), None);
        assert_eq!(constant("gl_MaxImageUnits"), None);
    }

    #[test]
    fn variables_are_found_by_name() {
        let kind = |name| Variable::find(name).map(|variable| variable.kind);
        assert_eq!(kind("gl_FragCoord"), Some(GlobalKind::FragCoord));
        assert_eq!(kind("gl_FragDepth"), Some(GlobalKind::FragDepth));
        assert_eq!(kind("gl_FragColor"), None);
    }
}
