//! Every scene is written in every language, and what can be read back here is.

use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

use naga::valid::{Capabilities, ValidationFlags, Validator};
use vitrine::scene::{self, Source};
use vitrine::translate::{Arithmetic, Language, Options, translate, write};

use crate::support::{Folder, cases, on_every_core, pasted, scene_folders, vitrine};

/// What every language's text of a scene contains.
const LANGUAGES: [(Language, &str); 5] = [
    (Language::Wgsl, "@fragment"),
    (Language::Spirv, "\u{3}\u{2}#\u{7}"),
    (Language::Glsl, "#version 310 es"),
    (Language::Hlsl, "SV_Target"),
    (Language::Msl, "#include <metal_stdlib>"),
];

/// As a program is translated to be read, and to be drawn.
const BOTH: [Arithmetic; 2] = [Arithmetic::Compact, Arithmetic::Expanded];

fn with(arithmetic: Arithmetic) -> Options {
    Options {
        arithmetic,
        ..Options::default()
    }
}

fn written(source: &Source, language: Language) -> Vec<u8> {
    written_with(source, language, Arithmetic::Compact)
}

fn written_with(source: &Source, language: Language, arithmetic: Arithmetic) -> Vec<u8> {
    let scene = scene::load(source).expect("a scene");
    let programs = translate(&scene, &with(arithmetic)).expect("programs");
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
        for arithmetic in BOTH {
            let source = Source::Path(scene.clone());
            let binary = written_with(&source, Language::Spirv, arithmetic);
            let file = folder.write(&format!("{name}.spv"), binary);
            if let Some(complaint) = spirv_val(&file) {
                panic!("{name}, {arithmetic:?}: {complaint}");
            }
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
    let problems =
        on_every_core(&cases, |case| {
            let mut problems = String::new();
            for (arithmetic, (language, _)) in BOTH
                .into_iter()
                .flat_map(|one| LANGUAGES.map(|language| (one, language)))
            {
                let translated = case.translated_with(&with(arithmetic));
                let (_, programs) = translated.expect("it is accepted");
                let problem = match write(&programs[0], language) {
                    Err(problem) => Some(problem.message),
                    Ok(binary) if language == Language::Spirv => {
                        spirv_val(&folder.write(&format!("{}.spv", case.name), binary))
                    }
                    Ok(_) => None,
                };
                problems.extend(problem.map(|words| {
                    format!("{} in {language:?}, {arithmetic:?}: {words}\n", case.name)
                }));
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
