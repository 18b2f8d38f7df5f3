//! How arithmetic is written, and what compilers may know of its operands.

use vitrine::scene;
use vitrine::translate::{Arithmetic, Language, Options, translate, write};

use crate::support::{pasted, plain};

const TEXT: &str = "
float hash(vec3 p) { return fract(dot(p, p.yzx + 19.19)); }
void mainImage(out vec4 color, in vec2 at) {
    vec2 uv = at * 2.0 + at.yx;
    color = vec4(mix(uv, normalize(uv), step(0.5, at.x)), hash(uv.xyx), length(uv));
}
";

/// The WGSL of a text.
fn wgsl(text: &str, arithmetic: Arithmetic) -> String {
    let Ok(scene) = scene::load(&pasted(text)) else {
        panic!("it is a scene");
    };
    let options = Options {
        arithmetic,
        ..Options::default()
    };
    let programs = match translate(&scene, &options) {
        Ok(programs) => programs,
        Err(report) => panic!("{}", plain(&report)),
    };
    let written = write(&programs[0], Language::Wgsl).expect("a program can be written");
    String::from_utf8(written).expect("WGSL is text")
}

#[test]
fn compact_arithmetic_is_written_as_the_author_did() {
    let text = wgsl(TEXT, Arithmetic::Compact);
    for expected in [
        "(at * 2f)",
        "dot(",
        "normalize(",
        "mix(",
        "step(",
        "length(",
    ] {
        assert!(text.contains(expected), "no `{expected}` in {text}");
    }
}

/// Vectors are taken apart where a constant meets them, and nowhere else; functions are spelled out.
#[test]
fn expanded_arithmetic_takes_the_steps_of_compilers_of_glsl() {
    let text = wgsl(TEXT, Arithmetic::Expanded);
    for expected in [
        "(at.x * 2f), (at.y * 2f)",
        "inverseSqrt(",
        "sqrt(",
        ">= 0.5f",
    ] {
        assert!(text.contains(expected), "no `{expected}` in {text}");
    }
    for function in ["dot(", "normalize(", "mix(", "step(", "length("] {
        assert!(!text.contains(function), "`{function}` in {text}");
    }
}

/// The forms round differently, and noise shows it.
#[test]
fn mix_has_the_forms_that_mesas_compiler_of_glsl_gives_it() {
    let written = |expression: &str| {
        let text = format!(
            "void mainImage(out vec4 c, in vec2 p) {{ c = vec4({expression}, 0.0, 0.0, 0.0); }}"
        );
        wgsl(&text, Arithmetic::Expanded)
    };
    for (expression, expected) in [
        ("mix(p.x, p.y, p.x)", "(p.x + (p.x * (p.y - p.x)))"),
        ("mix(p.x, p.y, 0.25)", "((p.x * 0.75f) + (p.y * 0.25f))"),
        ("mix(1.0, p.y, p.x)", "((1f * (1f - p.x)) + (p.y * p.x))"),
        ("mix(p.x, 0.0, p.y)", "vec4<f32>((p.x * (1f - p.y)), 0f"),
        ("mix(0.0, p.y, p.x)", "vec4<f32>((p.y * p.x), 0f"),
        ("mix(0.5, 0.75, p.x)", "(0.5f + (p.x * 0.25f))"),
        (
            "mix(p.x, p.y, step(0.5, p.x))",
            "select(p.x, p.y, (p.x >= 0.5f))",
        ),
        (
            "mix(vec2(0.5), p, p.x).x",
            "((0.5f * (1f - p.x)) + (p.x * p.x)), ((0.5f * (1f - p.x)) + (p.y * p.x))",
        ),
        ("mix(p, p.yx, p.x).x", "(p + (vec2(p.x) * (p.yx - p)))"),
    ] {
        let text = written(expression);
        let line = text
            .lines()
            .find(|line| line.contains("(*c) = vec4<f32>(") && line.contains("p.x"));
        let line = line.unwrap_or_else(|| panic!("no {expression} in {text}"));
        assert!(
            line.contains(expected),
            "no `{expected}` for {expression} in {line}"
        );
    }
}

#[test]
fn constants_of_a_chain_come_together_as_in_mesas_compiler_of_glsl() {
    for (expression, expected) in [
        ("p.x + 2.0 + p.y + 3.0", "((5f + p.y) + p.x)"),
        ("(p.x * 2.0) * p.y * 3.0", "((6f * p.y) * p.x)"),
        ("2.0 + (p.x + (p.y + 3.0))", "(p.y + (p.x + 5f))"),
        // What stands on its own stays, and so does what another operator parts.
        ("p.x + 2.0 + p.y", "((p.x + 2f) + p.y)"),
        ("(p.x + 2.0) * 3.0", "((p.x + 2f) * 3f)"),
    ] {
        let text = format!(
            "void mainImage(out vec4 c, in vec2 p) {{ c = vec4({expression}, 0.0, 0.0, 0.0); }}"
        );
        let expanded = wgsl(&text, Arithmetic::Expanded);
        assert!(expanded.contains(expected), "no `{expected}` in {expanded}");
        let compact = wgsl(&text, Arithmetic::Compact);
        assert_eq!(
            compact.contains(expected),
            expected.starts_with("((p.x"),
            "{compact}"
        );
    }
}

/// They are zero, but a compiler that knew would take a division by them for anything.
#[test]
fn uniforms_of_the_authors_own_are_read_at_run_time() {
    let text = wgsl(
        "uniform vec2 speed; uniform float unused; uniform mat4 huge[9999];
        void mainImage(out vec4 c, in vec2 p) {
            c = vec4(p / speed, huge[int(p.x)][0].x, iTime);
        }",
        Arithmetic::Compact,
    );
    assert!(text.contains("uniforms.speed"), "{text}");
    assert!(!text.contains("unused") && !text.contains("huge"), "{text}");
}

/// A product of matrices that a vector stands behind is never computed: that takes twice as many steps or more.
#[test]
fn a_vector_is_transformed_by_one_matrix_after_the_other() {
    let text = |product: &str| {
        format!(
            "void mainImage(out vec4 color, in vec2 at) {{
                mat4 a = mat4(at.x), b = mat4(at.y), c = mat4(at.xyxy, at.yxyx, at.xxyy, at.yyxx);
                color = {product};
            }}"
        )
    };
    let expanded = |product: &str| wgsl(&text(product), Arithmetic::Expanded);
    let expected = expanded("a * (b * (c * vec4(at, 0.1, 1.0)))");
    for product in [
        "a * b * c * vec4(at, 0.1, 1.0)",
        "a * (b * c) * vec4(at, 0.1, 1.0)",
    ] {
        assert_eq!(expanded(product), expected, "{product}");
    }
    assert_ne!(
        expanded("vec4(at, 0.1, 1.0) * (a * b)"),
        expanded("vec4(at, 0.1, 1.0) * a * b")
    );
}
