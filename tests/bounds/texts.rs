//! Texts that ask for more than any shader does, each in its own way.

use std::fmt::Write as _;

/// A hostile text and what it is about.
pub struct Text {
    pub name: &'static str,
    pub text: String,
}

const MAIN: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n";

/// Puts statements into `mainImage`. `f` is a `float` that is not known before the program runs, `a` an
/// array, and `i` an `int`.
fn in_main(statements: &str) -> String {
    format!(
        "void mainImage(out vec4 c, in vec2 p) {{\
         \nfloat f = p.x; int i = int(p.y); int a[4]; {statements}\nc = vec4(f) + float(a[0] + i); }}"
    )
}

/// Lines made of their numbers.
fn lines(count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).fold(String::new(), |mut text, i| {
        let _ = writeln!(text, "{}", line(i));
        text
    })
}

fn nested(open: &str, count: usize, inner: &str, close: &str) -> String {
    open.repeat(count) + inner + &close.repeat(count)
}

pub fn all() -> Vec<Text> {
    const MANY: usize = 100_000;
    let nested_in = |open: &str, inner: &str, close: &str| {
        in_main(&format!("f = {};", nested(open, MANY, inner, close)))
    };
    let texts = [
        ("macros that double", doubling_macros()),
        ("macros with arguments that double", doubling_arguments()),
        ("a macro call in its own argument", nested_macro_calls(MANY)),
        (
            "definitions",
            lines(MANY, |i| format!("#define A{i} A{}", i + 1)) + MAIN,
        ),
        (
            "a chain of macros",
            lines(MANY, |i| format!("#define A{i} A{}", i + 1)) + &in_main("f = A0;"),
        ),
        (
            "conditions in conditions",
            nested("#if 1\n", MANY, MAIN, "#endif\n"),
        ),
        (
            "brackets in a condition",
            format!("#if {}\n#endif\n{MAIN}", nested("(", MANY, "1", ")")),
        ),
        ("brackets", nested_in("(", "f", ")")),
        ("open brackets", nested_in("(", "f", "")),
        (
            "indices",
            in_main(&format!("i = {};", nested("a[", MANY, "i", "]"))),
        ),
        ("calls", nested_in("sin(", "f", ")")),
        ("constructors", nested_in("float(", "f", ")")),
        ("signs", nested_in("- ", "f", "")),
        ("a sum", nested_in("f + ", "f", "")),
        ("a sum of constants", nested_in("1. + ", "f", "")),
        ("choices", nested_in("f > 1. ? f : ", "f", "")),
        ("choices in choices", nested_in("f > 1. ? ", "f", " : f")),
        ("assignments", nested_in("f = ", "f", "")),
        ("commas", nested_in("f = f * f, ", "f", "")),
        (
            "swizzles",
            in_main(&format!("c = c{};", ".xyzw".repeat(MANY))),
        ),
        ("braces", in_main(&nested("{", MANY, "f++;", "}"))),
        ("open braces", in_main(&"{".repeat(MANY))),
        (
            "branches in branches",
            in_main(&nested("if (f > 1.) {", MANY, "f++;", "}")),
        ),
        (
            "an else-if ladder",
            in_main(&("if (f > 1.) f++; else ".repeat(MANY) + "f++;")),
        ),
        (
            "loops in loops",
            in_main(&nested("for (int j = 0; j < 2; j++) {", MANY, "f++;", "}")),
        ),
        (
            "cases",
            in_main(&format!(
                "switch (i) {{ {} }}",
                lines(MANY, |i| format!("case {i}: f++; break;"))
            )),
        ),
        ("statements", in_main(&"f = f * f + 1.;\n".repeat(MANY))),
        (
            "a line of a million bytes",
            in_main(&"f = f*f+1.;".repeat(MANY)),
        ),
        (
            "variables",
            in_main(&lines(MANY, |i| format!("float v{i} = f; f += v{i};"))),
        ),
        (
            "variables that hide each other",
            in_main(&nested("{ float f = f + 1.;", MANY, "f++;", "}")),
        ),
        (
            "functions",
            lines(10_000, |i| {
                format!("float g{i}(float x) {{ return x * {i}.; }}")
            }) + MAIN,
        ),
        ("functions that are called", many_functions()),
        ("a chain of calls", chain_of_calls(10_000)),
        ("calls that double", doubling_calls()),
        ("overloads", overloads()),
        ("prototypes", "float g(float x);\n".repeat(MANY) + MAIN),
        ("samplers in every order", permuted_samplers()),
        ("continues with a long step", long_steps()),
        (
            "members",
            format!(
                "struct S {{ {} }};\n{MAIN}",
                lines(MANY, |i| format!("float m{i};"))
            ),
        ),
        ("structures that double", doubling_structures()),
        ("structures that are compared", compared_structures()),
        ("an array of constants", constants(MANY)),
        (
            "a huge array",
            in_main("float b[1000000000]; b[i] = f; f = b[0];"),
        ),
        ("large arrays that are copied", copied_arrays()),
        (
            "uniforms",
            lines(MANY, |i| format!("uniform float u{i};")) + MAIN,
        ),
        (
            "a long name",
            format!("float {} = 1.;\n{MAIN}", "n".repeat(1_000_000)),
        ),
        (
            "a long number",
            in_main(&format!("f = {}.;", "1".repeat(1_000_000))),
        ),
        (
            "a long comment",
            format!("/*{}*/{MAIN}", "*".repeat(1_000_000)),
        ),
        ("joined lines", format!("{}{MAIN}", "\\\n".repeat(MANY))),
        (
            "unknown names",
            in_main(&lines(MANY, |i| format!("f += x{i};"))),
        ),
        ("wrong types", in_main(&"f += 1;\n".repeat(MANY))),
        ("unknown characters", in_main(&"§ ".repeat(MANY))),
        ("unknown directives", "#nothing\n".repeat(MANY) + MAIN),
        ("a shader of 2.4 million bytes", large()),
        (
            "a plain fragment shader in a line of a million bytes",
            format!(
                "uniform float {}; void main() {{}}",
                "uTime, ".repeat(140_000) + "other"
            ),
        ),
    ];
    let texts = texts.into_iter();
    texts.map(|(name, text)| Text { name, text }).collect()
}

fn doubling_macros() -> String {
    let chain = lines(40, |i| format!("#define A{} A{i} + A{i}", i + 1));
    format!("#define A0 1.\n{chain}{}", in_main("f = A40;"))
}

fn doubling_arguments() -> String {
    let calls = nested("D(", 40, "f", ")");
    format!("#define D(x) x + x\n{}", in_main(&format!("f = {calls};")))
}

fn nested_macro_calls(count: usize) -> String {
    let calls = nested("I(", count, "f", ")");
    format!("#define I(x) x\n{}", in_main(&format!("f = {calls};")))
}

fn many_functions() -> String {
    let functions = lines(10_000, |i| {
        format!("float g{i}(float x) {{ return x * {i}.; }}")
    });
    let calls = lines(10_000, |i| format!("f += g{i}(f);"));
    functions + &in_main(&calls)
}

fn chain_of_calls(count: usize) -> String {
    let chain = lines(count, |i| {
        format!("float g{}(float x) {{ return g{i}(x) + 1.; }}", i + 1)
    });
    format!(
        "float g0(float x) {{ return x; }}\n{chain}{}",
        in_main(&format!("f = g{count}(f);"))
    )
}

fn doubling_calls() -> String {
    let chain = lines(200, |i| {
        format!(
            "float g{}(float x) {{ return g{i}(x) + g{i}(x + 1.); }}",
            i + 1
        )
    });
    format!(
        "float g0(float x) {{ return x; }}\n{chain}{}",
        in_main("f = g200(f);")
    )
}

/// Functions of one name, told apart by what they take.
fn overloads() -> String {
    let types = [
        "int", "float", "vec2", "vec3", "vec4", "bool", "uint", "mat2",
    ];
    let functions = lines(4_000, |i| {
        let parameters: Vec<_> = (0..4).map(|k| types[(i >> (3 * k)) & 7]).collect();
        format!("float g({}) {{ return 1.; }}", parameters.join(", "))
    });
    functions + &in_main("f = g(1, 1, 1, 1);")
}

/// Each function hands its samplers on in two orders. Some of them have no texture, so that each order
/// is a function of its own.
fn permuted_samplers() -> String {
    const COUNT: usize = 16;
    let names: Vec<_> = (0..COUNT).map(|i| format!("s{i}")).collect();
    let parameters: Vec<_> = names
        .iter()
        .map(|name| format!("sampler2D {name}"))
        .collect();
    let parameters = parameters.join(", ");
    let turned = [&names[1..], &names[..1]].concat().join(", ");
    let mut swapped = names.clone();
    swapped.swap(0, 1);
    let swapped = swapped.join(", ");
    let mut text = format!(
        "uniform sampler2D none;\nvec4 g0({parameters}) {{ return texture(s0, vec2(0)); }}\n"
    );
    for i in 0..40 {
        let _ = writeln!(
            text,
            "vec4 g{}({parameters}) {{ return g{i}({turned}) + g{i}({swapped}); }}",
            i + 1
        );
    }
    let given: Vec<_> = (0..COUNT).map(|i| ["iChannel0", "none"][i % 2]).collect();
    text + &in_main(&format!("c = g40({}); f = c.x;", given.join(", ")))
}

fn long_steps() -> String {
    let step = vec!["f += sin(f)"; 1_000].join(", ");
    let body = "if (f > 2.) continue;\n".repeat(2_000);
    in_main(&format!("for (int j = 0; j < 9; j++, {step}) {{ {body} }}"))
}

fn doubling_structures() -> String {
    let chain = lines(60, |i| format!("struct S{} {{ S{i} a, b; }};", i + 1));
    format!(
        "struct S0 {{ float x; }};\n{chain}{}",
        in_main("S60 s; f = 1.;")
    )
}

fn compared_structures() -> String {
    let members = lines(1_000, |i| format!("vec4 m{i}[16];"));
    format!(
        "struct S {{ {members} }};\n{}",
        in_main("S s; S t; f = s == t ? 1. : 2.;")
    )
}

fn constants(count: usize) -> String {
    let values: Vec<_> = (0..count).map(|i| format!("{i}.")).collect();
    let values = values.join(",");
    format!(
        "const float t[] = float[]({values});\n{}",
        in_main("f = t[i];")
    )
}

fn copied_arrays() -> String {
    let copies = lines(200, |i| {
        format!("float b{i}[16000] = b; b{i}[i] = f; f = b{i}[0];")
    });
    in_main(&format!("float b[16000]; b[i] = f; {copies}"))
}

/// As large as the largest shader that was ever published, and ordinary.
fn large() -> String {
    let functions = lines(9_000, |i| {
        format!(
            "// The shape number {i} of a long list of shapes, as tools write them.\n\
             float shape{i}(vec3 p) {{\n\
             \x20   vec3 q = abs(p - vec3({i}.5, 0.25, -1.0)) - vec3(0.5);\n\
             \x20   return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);\n}}"
        )
    });
    let calls = lines(9_000, |i| format!("f = min(f, shape{i}(vec3(p, f)));"));
    functions + &in_main(&calls)
}
