//! From a case to what is asked of the front end about a fragment shader.
//!
//! As in `modules/glshared/glsShaderLibraryCase.cpp` of VK-GL-CTS, but that inputs are uniforms:
//! there is no vertex shader to give them. The shader compares what it computes and draws white.

use std::fmt::Write;

use super::format::{Case, Expectation, Scalar, Shaders, Type, Value, Values};

/// What is asked about a case.
#[derive(Debug)]
pub enum Task {
    /// Nothing, for this reason.
    Skip(&'static str),
    /// Whether this text is refused.
    Refuse(String),
    /// Whether this program compiles, down to the graphics driver.
    Build(Program),
    /// Whether this program draws white with every set of values.
    Draw(Program),
}

/// A fragment shader, and the uniforms to draw it with.
#[derive(Debug)]
pub struct Program {
    /// The text, without `#version`.
    pub text: String,
    /// The uniforms. The program need not name them all.
    pub uniforms: Vec<Value>,
    /// With how many sets of values to draw.
    pub sets: usize,
}

/// What a program shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Show {
    /// White if everything is as expected.
    Verdict,
    /// What it computed: the first four components of all outputs in set 0, then in set 1 and so on,
    /// then the next four.
    Results,
}

/// What Khronos expects to compile, and WebGL2 refuses.
const REFUSED_BY_WEBGL2: &[&str] = &[
    // ANGLE reserves these words in WebGL alone.
    "keywords/allowed_keywords/image1DShadow",
    "keywords/allowed_keywords/image2DShadow",
    "keywords/allowed_keywords/image1DArrayShadow",
    "keywords/allowed_keywords/image2DArrayShadow",
    // ANGLE refuses in WebGL that macros expand to `defined`.
    "preprocessor/conditional_inclusion/basic_2",
    "preprocessor/conditional_inclusion/defined_macro_defined_test",
    "preprocessor/conditional_inclusion/defined_macro_undef",
    // ANGLE never lets `defined` be a macro.
    "preprocessor/conditional_inclusion/define_defined",
    "preprocessor/conditional_inclusion/define_defined_outside_if",
    // ANGLE lets nothing but directives stand before these lines, and a host has something there.
    "preprocessor/extensions/basic",
    "preprocessor/extensions/macro_exp",
];

/// Says what to ask about a case.
pub fn task(case: &Case, show: Show) -> Task {
    if !case.is_es300 {
        return Task::Skip("another version of the language");
    }
    let is_refused = matches!(
        case.expectation,
        Expectation::CompileFail | Expectation::CompileOrLinkFail
    );
    if let (true, Shaders::Halves { fragment, .. }) = (is_refused, &case.shaders)
        && is_about_vertex_shader(&case.path, fragment)
    {
        return Task::Skip("only the vertex shader is at fault");
    }
    let program = specialise(case, show);
    if REFUSED_BY_WEBGL2.contains(&case.path.as_str()) {
        return Task::Refuse(program.text);
    }
    match case.expectation {
        Expectation::Pass => Task::Draw(program),
        // The shaders of what does not link or validate compile.
        Expectation::BuildSuccessful | Expectation::LinkFail | Expectation::ValidationFail => {
            Task::Build(program)
        }
        Expectation::CompileFail | Expectation::CompileOrLinkFail => Task::Refuse(program.text),
    }
}

/// Whether it is the vertex shader of the two that must be refused: by the case's name, or because
/// there is nothing in the fragment shader.
fn is_about_vertex_shader(path: &str, fragment: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or_default();
    let words = fragment.lines().filter(|line| {
        let line = line.trim_start();
        !["#version", "precision", "${FRAGMENT_DECLARATIONS}"]
            .iter()
            .any(|start| line.starts_with(start))
    });
    let bare: String = words.flat_map(str::split_whitespace).collect();
    name.contains("vertex") || bare == "voidmain(){${FRAG_COLOR}=vec4(1.0);}"
}

fn specialise(case: &Case, show: Show) -> Program {
    let mut uniforms = Vec::new();
    let mut setup = String::new();
    let mut declarations = compare_functions(&case.values);
    declarations.push_str("layout(location = 0) out mediump vec4 dEQP_FragColor;\n");
    let mut declare = |value: &Value, name: String, precision: &str| {
        let text = format!("uniform {precision}{} {name};\n", value.ty);
        uniforms.push(Value {
            name,
            ..value.clone()
        });
        text
    };
    for value in &case.values.inputs {
        let Value { name, ty, .. } = value;
        if ty.scalar == Scalar::Float {
            declarations += &declare(value, name.clone(), "");
        } else {
            // These are variables of the function that asks for them, as with Khronos.
            declarations += &declare(value, format!("v_{name}"), "");
            let _ = writeln!(setup, "{ty} {name} = {ty}(v_{name});");
        }
    }
    for value in &case.values.outputs {
        let Value { name, ty, .. } = value;
        declarations += &declare(value, format!("ref_{name}"), "");
        let _ = writeln!(declarations, "{ty} {name};");
    }
    let output = match show {
        Show::Verdict => verdict(&case.values),
        Show::Results => {
            declarations.push_str("uniform highp int dEQP_Part;\n");
            results(&case.values)
        }
    };

    let template = match &case.shaders {
        Shaders::Both(text) | Shaders::Halves { fragment: text, .. } => text,
    };
    let mut template = without_version(template);
    let mut members = Vec::new();
    for value in &case.values.uniforms {
        match value.name.split_once('.') {
            None => {
                let declaration = declare(value, value.name.clone(), "");
                // Khronos leaves it to templates for both shaders to declare their uniforms.
                if matches!(case.shaders, Shaders::Halves { .. }) {
                    declarations += &declaration;
                }
            }
            Some((root, _)) => {
                let name = format!("u_{}", value.name.replace('.', "_"));
                let precision = match value.ty.scalar {
                    Scalar::Bool => "",
                    _ => "highp ",
                };
                declarations += &declare(value, name.clone(), precision);
                members.push((root, format!("{} = {name};\n", value.name)));
            }
        }
    }
    set_structures(&mut template, &members);

    let mut sets = case.values.sets();
    if show == Show::Results {
        let parts = component_names(&case.values).len().div_ceil(4);
        uniforms.push(Value {
            name: "dEQP_Part".to_owned(),
            ty: Type::named("int").expect("a type"),
            words: (0..parts * sets).map(|i| (i / sets) as u32).collect(),
        });
        for value in &mut uniforms {
            let given: Vec<u32> = (0..sets).flat_map(|set| value.set(set).to_vec()).collect();
            if value.name != "dEQP_Part" {
                value.words = given.repeat(parts);
            }
        }
        sets *= parts;
    }
    Program {
        text: fill(&template, &declarations, &setup, &output),
        uniforms,
        sets,
    }
}

/// The template with nothing in the place of `#version 300 es`. What else there may be must be
/// refused, and is left for the front end to do so.
fn without_version(template: &str) -> String {
    const VERSION: &str = "#version 300 es";
    let start = template.len() - template.trim_start().len();
    match template[start..].strip_prefix(VERSION) {
        Some(rest)
            if rest
                .lines()
                .next()
                .is_none_or(|line| line.trim().is_empty()) =>
        {
            format!("{}{rest}", &template[..start])
        }
        _ => template.to_owned(),
    }
}

/// Turns uniforms of a structure into variables that `main` sets first: only uniforms that are
/// numbers can be given.
fn set_structures(template: &mut String, members: &[(&str, String)]) {
    let mut set = Vec::new();
    for (root, statement) in members {
        let declared = template.match_indices("uniform ").find(|(at, _)| {
            let declaration = template[*at..].split(';').next().unwrap_or_default();
            declaration.split_whitespace().collect::<Vec<_>>().len() == 3
                && declaration.ends_with(&format!(" {root}"))
        });
        if let Some((at, word)) = declared {
            template.replace_range(at..at + word.len(), "");
            set.push(*root);
        }
        if set.contains(root)
            && let Some(main) = template.find("void main")
            && let Some(brace) = template[main..].find('{')
        {
            template.insert_str(main + brace + 1, statement);
        }
    }
}

/// Replaces `${…}`.
fn fill(template: &str, declarations: &str, setup: &str, output: &str) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, behind)) = rest.split_once("${") {
        text.push_str(before);
        let Some((parameter, behind)) = behind.split_once('}') else {
            break;
        };
        let (name, flag) = parameter.split_once(':').unwrap_or((parameter, ""));
        let value = match name {
            "DECLARATIONS" | "FRAGMENT_DECLARATIONS" => declarations,
            "SETUP" => setup,
            "OUTPUT" | "FRAGMENT_OUTPUT" => output,
            "POSITION_FRAG_COLOR" | "FRAG_COLOR" => "dEQP_FragColor",
            _ => "",
        };
        match flag {
            "single-line" => text.push_str(&value.replace('\n', " ")),
            _ => text.push_str(value),
        }
        rest = behind;
    }
    text + rest
}

/// `isOk` for the types of the outputs.
fn compare_functions(values: &Values) -> String {
    let mut types: Vec<Type> = values.outputs.iter().map(|value| value.ty).collect();
    types.dedup();
    let mut text = String::new();
    for (i, ty) in types.iter().enumerate() {
        if types[..i].contains(ty) {
            continue;
        }
        let _ = match (ty.scalar, ty.columns, ty.rows) {
            (Scalar::Float, 1, 1) => writeln!(
                text,
                "bool isOk (float a, float b, float eps) \
                 {{ return (abs(a-b) <= (eps*abs(b) + eps)); }}"
            ),
            (Scalar::Float, 1, _) => writeln!(
                text,
                "bool isOk ({ty} a, {ty} b, float eps) \
                 {{ return all(lessThanEqual(abs(a-b), (eps*abs(b) + eps))); }}"
            ),
            (Scalar::Float, columns, rows) => {
                let distances = (1..columns).fold("abs(a[0]-b[0])".to_owned(), |sum, i| {
                    format!("max({sum}, abs(a[{i}]-b[{i}]))")
                });
                writeln!(
                    text,
                    "bool isOk ({ty} a, {ty} b, float eps) \
                     {{ return all(lessThanEqual({distances}, vec{rows}(eps))); }}"
                )
            }
            _ => writeln!(text, "bool isOk ({ty} a, {ty} b) {{ return (a == b); }}"),
        };
    }
    text
}

/// Draws white if all outputs are as expected.
fn verdict(values: &Values) -> String {
    let mut text = String::new();
    for (i, Value { name, ty, .. }) in values.outputs.iter().enumerate() {
        text.push_str(if i == 0 {
            "bool RES = "
        } else {
            "RES = RES && "
        });
        let _ = match ty.scalar {
            Scalar::Float => writeln!(text, "isOk({name}, ref_{name}, 0.05);"),
            _ => writeln!(text, "isOk({name}, ref_{name});"),
        };
    }
    text.push_str(match values.outputs.is_empty() {
        true => "dEQP_FragColor = vec4(1.0);\n",
        false => "dEQP_FragColor = vec4(RES, RES, RES, 1.0);\n",
    });
    text
}

/// Draws four components of the outputs.
fn results(values: &Values) -> String {
    let mut text = String::new();
    for (part, names) in component_names(values).chunks(4).enumerate() {
        let mut components: Vec<_> = names.iter().map(|name| format!("float({name})")).collect();
        components.resize(4, "0.0".to_owned());
        let components = components.join(", ");
        let _ = writeln!(
            text,
            "if (dEQP_Part == {part}) dEQP_FragColor = vec4({components});"
        );
    }
    text
}

/// All components of all outputs.
pub fn component_names(values: &Values) -> Vec<String> {
    let mut names = Vec::new();
    for Value { name, ty, .. } in &values.outputs {
        for column in 0..ty.columns {
            for row in 0..ty.rows {
                names.push(match (ty.columns, ty.rows) {
                    (1, 1) => name.clone(),
                    (1, _) => format!("{name}[{row}]"),
                    _ => format!("{name}[{column}][{row}]"),
                });
            }
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn float(name: &str, words: &[f32]) -> Value {
        Value {
            name: name.to_owned(),
            ty: Type::named("float").expect("a type"),
            words: words.iter().map(|word| word.to_bits()).collect(),
        }
    }

    fn case(shaders: Shaders, values: Values) -> Case {
        Case {
            path: "group/name".to_owned(),
            expectation: Expectation::Pass,
            is_es300: true,
            values,
            shaders,
        }
    }

    fn program(case: &Case, show: Show) -> Program {
        match task(case, show) {
            Task::Draw(program) => program,
            other => panic!("a program to draw, not {other:?}"),
        }
    }

    #[test]
    fn a_template_is_filled() {
        let template = "#version 300 es\nprecision mediump float;\n${DECLARATIONS:single-line}\n\
                        void main() { ${SETUP} out0 = in0; ${OUTPUT} }";
        let values = Values {
            inputs: vec![
                float("in0", &[1.0, 2.0]),
                Value {
                    name: "in1".to_owned(),
                    ty: Type::named("bvec2").expect("a type"),
                    words: vec![0, 1, 1, 1],
                },
            ],
            outputs: vec![float("out0", &[1.0, 2.0])],
            uniforms: Vec::new(),
        };
        let case = case(Shaders::Both(template.to_owned()), values);
        let Program {
            text,
            uniforms,
            sets,
        } = program(&case, Show::Verdict);
        assert_eq!(sets, 2);
        let names: Vec<_> = uniforms.iter().map(|value| value.name.as_str()).collect();
        assert_eq!(names, ["in0", "v_in1", "ref_out0"]);
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[..2], ["", "precision mediump float;"]);
        assert!(lines[2].contains("uniform bvec2 v_in1; uniform float ref_out0; float out0;"));
        assert!(text.contains("bvec2 in1 = bvec2(v_in1);"));
        assert!(text.contains("bool RES = isOk(out0, ref_out0, 0.05);"));
    }

    #[test]
    fn results_are_drawn_in_parts() {
        let vec3 = Value {
            name: "out1".to_owned(),
            ty: Type::named("vec3").expect("a type"),
            words: vec![0; 6],
        };
        let values = Values {
            outputs: vec![float("out0", &[1.0, 2.0]), vec3.clone(), vec3],
            ..Values::default()
        };
        let case = case(Shaders::Both("${OUTPUT}".to_owned()), values);
        let Program {
            text,
            uniforms,
            sets,
        } = program(&case, Show::Results);
        assert_eq!(sets, 4);
        let part = uniforms.last().expect("the number of the part");
        assert_eq!(part.words, [0, 0, 1, 1]);
        let reference = &uniforms[0];
        assert_eq!(reference.words, [1.0_f32, 2.0, 1.0, 2.0].map(f32::to_bits));
        assert!(text.contains("vec4(float(out0), float(out1[0]), float(out1[1]), float(out1[2]))"));
    }

    #[test]
    fn members_of_structures_are_set_by_main() {
        let fragment = "struct S { float a; }; uniform S s; void main() { }";
        let shaders = Shaders::Halves {
            vertex: String::new(),
            fragment: fragment.to_owned(),
        };
        let values = Values {
            uniforms: vec![float("s.a", &[1.0])],
            ..Values::default()
        };
        let program = program(&case(shaders, values), Show::Verdict);
        let expected = "struct S { float a; }; S s; void main() {s.a = u_s_a;\n }";
        assert_eq!(program.text, expected);
        assert_eq!(program.uniforms[0].name, "u_s_a");
    }

    #[test]
    fn only_the_right_version_is_taken_away() {
        assert_eq!(without_version("\n #version 300 es \nx"), "\n  \nx");
        for text in [
            "#version 300 es.0\n",
            "#version 300\n",
            "x\n#version 300 es\n",
        ] {
            assert_eq!(without_version(text), text);
        }
    }

    #[test]
    fn vertex_shaders_are_not_asked_about() {
        let bare = "#version 300 es\n${FRAGMENT_DECLARATIONS}\n\
                    void main()\n{\n ${FRAG_COLOR} = vec4(1.0);\n}\n";
        assert!(is_about_vertex_shader("group/name", bare));
        let more = format!("in vec4 a;{bare}");
        assert!(!is_about_vertex_shader("vertex/name", &more));
        assert!(is_about_vertex_shader("group/in_vertex", &more));
    }
}
