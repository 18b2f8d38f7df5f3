//! Every scene is written in every language, and what can be read back here is.

use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

use naga::valid::{Capabilities, ValidationFlags, Validator};
use vitrine::scene::{self, Source};
use vitrine::translate::{Language, Options, translate, write};

use crate::support::{Folder, cases, on_every_core, pasted, scene_folders, vitrine};

/// What every language's text of a scene contains.
const LANGUAGES: [(Language, &str); 5] = [
    (Language::Wgsl, "@fragment"),
    (Language::Spirv, "\u{3}\u{2}#\u{7}"),
    (Language::Glsl, "#version 310 es"),
    (Language::Hlsl, "SV_Target"),
    (Language::Msl, "#include <metal_stdlib>"),
];

fn written(source: &Source, language: Language) -> Vec<u8> {
    let scene = scene::load(source).expect("a scene");
    let programs = translate(&scene, &Options::default()).expect("programs");
    write(&programs[0], language).unwrap_or_else(|problem| panic!("{}", problem.message))
}

#[test]
fn every_scene_can_be_written_in_every_language() {
    for (name, folder) in scene_folders() {
        for (language, sign) in LANGUAGES {
            let bytes = written(&Source::Path(folder.clone()), language);
            let text = String::from_utf8_lossy(&bytes);
            assert!(text.contains(sign), "{name} in {language:?}: {text:.200}");
            if language == Language::Wgsl {
                assert_is_wgsl(&name, &text);
            }
        }
    }
}

fn assert_is_wgsl(name: &str, text: &str) {
    let module = naga::front::wgsl::parse_str(text)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(text)));
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{name}: {error:?}"));
}

#[test]
fn spirv_val_accepts_every_scene() {
    let folder = Folder::new();
    for (name, scene) in scene_folders() {
        let binary = written(&Source::Path(scene), Language::Spirv);
        let file = folder.write(&format!("{name}.spv"), binary);
        if let Some(complaint) = spirv_val(&file) {
            panic!("{name}: {complaint}");
        }
    }
}

/// What `spirv-val` has against a file; nothing where there is no such program.
fn spirv_val(file: &Path) -> Option<String> {
    let verdict = Command::new("spirv-val")
        .args(["--target-env", "vulkan1.1"])
        .arg(file)
        .output();
    match verdict {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            assert!(
                std::env::var_os("REQUIRE_GPU").is_none(),
                "there is no spirv-val (Debian's package spirv-tools)"
            );
            None
        }
        other => {
            let output = other.expect("spirv-val runs");
            let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
            (!output.status.success()).then_some(complaint)
        }
    }
}

/// naga's validator lets through what its writers and drivers cannot take.
#[test]
fn whatever_is_accepted_can_be_written() {
    let folder = Folder::new();
    let cases: Vec<_> = cases("tests/glsl/accept")
        .into_iter()
        .chain(cases("tests/glsl/lenient"))
        .collect();
    let problems = on_every_core(&cases, |case| {
        let (_, programs) = case.translated(false).expect("it is accepted");
        let mut problems = String::new();
        for (language, _) in LANGUAGES {
            match write(&programs[0], language) {
                Err(problem) => problems += &format!("{}: {}\n", case.name, problem.message),
                Ok(binary) if language == Language::Spirv => {
                    let file = folder.write(&format!("{}.spv", case.name), binary);
                    problems
                        .extend(spirv_val(&file).map(|words| format!("{}: {words}", case.name)));
                }
                Ok(_) => {}
            }
        }
        problems
    });
    let problems: String = problems.concat();
    assert!(problems.is_empty(), "\n{problems}");
}

const TRIVIAL: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(iTime); }";

#[test]
fn the_command_writes_to_standard_output_or_a_file() {
    for (name, language) in [
        ("wgsl", Language::Wgsl),
        ("spirv", Language::Spirv),
        ("glsl", Language::Glsl),
        ("hlsl", Language::Hlsl),
        ("msl", Language::Msl),
    ] {
        let expected = written(&pasted(TRIVIAL), language);
        let outcome = vitrine("translate - --to").arg(name).input(TRIVIAL).run();
        assert!(
            outcome.exits(0).stdout == expected,
            "{name} on standard output"
        );
        let folder = Folder::new();
        vitrine("translate - --out a.out --pass image --to")
            .arg(name)
            .input(TRIVIAL)
            .within(folder.path())
            .run()
            .exits(0);
        assert!(folder.read("a.out") == expected, "{name} in a file");
    }
}

#[test]
fn a_pass_that_is_not_there_is_named_with_those_that_are() {
    vitrine("translate - --to wgsl --pass")
        .arg("Buffer A")
        .input(TRIVIAL)
        .run()
        .exits(2)
        .says("error: the scene has no pass `Buffer A`")
        .says("help: it has: Image");
}
