//! What a scene that is none gets: its cause, the way out, exit code 1 if its author can mend it and
//! 2 if not, and no file.

use crate::support::{Folder, gpu, vitrine};

pub const GOOD: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n";

/// Checks and exports `scene`, a path within the folder, and expects both to refuse it alike.
#[track_caller]
pub fn refused(folder: &Folder, scene: &str, code: i32, words: &[&str]) {
    let before = folder.files();
    let mut commands = vec![format!("check {scene}")];
    if gpu().is_some() {
        commands.push(format!("export {scene} --out out/%d.png --size 8x8"));
    }
    for command in commands {
        let outcome = folder.run(&command);
        outcome.exits(code);
        for words in words {
            outcome.says(words);
        }
        assert!(outcome.stdout.is_empty(), "complaints go to standard error");
        assert_eq!(folder.files(), before, "nothing is written");
    }
}

/// Expects this text to be refused as a scene, with a place in it.
#[track_caller]
fn text_refused(text: impl AsRef<[u8]>, words: &[&str]) {
    let folder = Folder::with("a.glsl", text);
    refused(
        &folder,
        "a.glsl",
        1,
        &[words, &["error", "a.glsl:"]].concat(),
    );
}

#[test]
fn an_empty_file() {
    for text in ["", "\n \t\r\n", "\u{feff}\n"] {
        text_refused(text, &["error[empty]: the file is empty", "a.glsl:1:1"]);
        text_refused(text, &["help: paste a ShaderToy shader into it"]);
    }
}

#[test]
fn a_binary_file() {
    let message = "error[binary]: this is a binary file, not GLSL text";
    text_refused(b"\x7fELF\x02\x01\x01\0\0\0", &[message, "help: "]);
    text_refused(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", &[message, "help: "]);
}

#[test]
fn text_in_another_encoding() {
    let latin_1 = [b"// gr\xfc\xdfe\n", GOOD.as_bytes()].concat();
    let message = "error[not-utf8]: the text is not UTF-8: byte 0xfc";
    text_refused(
        latin_1,
        &[message, "a.glsl:1:6", "help: save the file again as UTF-8"],
    );

    let text = format!("\u{feff}{GOOD}");
    let utf_16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    text_refused(utf_16, &["help: "]);
}

#[test]
fn a_text_without_main_image() {
    let message = "error[no-main-image]: there is no `mainImage";
    let hint = "void mainImage(out vec4 fragColor, in vec2 fragCoord)";
    text_refused("float f() { return 1.0; }\n", &[message, hint]);
}

#[test]
fn a_syntax_error() {
    let text = "void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(1.0)\n}\n";
    text_refused(text, &["error[syntax]", "a.glsl:2:18", "`;`"]);
}

#[test]
fn an_unknown_function() {
    let text = "void mainImage(out vec4 c, in vec2 p) {\n    c = nois(p);\n}\n";
    text_refused(text, &["error[unknown-function]", "`nois`", "a.glsl:2:9"]);
}

#[test]
fn declarations_that_only_other_hosts_understand() {
    for declaration in [
        "layout(set = 0, binding = 0) uniform Knobs { float x; };",
        "layout(set = 3, binding = 0) uniform Knobs { float x; };",
        "layout(set = 0, binding = 1) buffer Knobs { float x; };",
        "layout(location = 9) in float x;",
        "shared float x;",
    ] {
        let body = "void mainImage(out vec4 c, in vec2 p) { c = vec4(x); }";
        text_refused(format!("{declaration}\n{body}\n"), &["a.glsl:1:"]);
    }
}

#[test]
fn an_array_beyond_any_driver() {
    // Drivers take such a stack frame for granted, and die.
    let text = "void mainImage(out vec4 c, in vec2 p) {
        float a[100000000]; a[int(p.x)] = 1.0; c = vec4(a[1]); }";
    text_refused(text, &[]);
}

#[test]
fn a_file_beyond_all_shaders() {
    let filler = "// filler\n".repeat((vitrine::scene::MAX_BYTES / 10) as usize);
    text_refused(GOOD.to_owned() + &filler, &["text is larger than 8 MiB"]);
}

#[test]
fn a_missing_file() {
    let words = ["error: cannot read `gone.glsl`", "help: a scene is a file"];
    refused(&Folder::new(), "gone.glsl", 2, &words);
}

#[test]
fn standard_input_that_is_empty() {
    let outcome = vitrine("check -").run();
    outcome
        .exits(1)
        .says("error[empty]: the file is empty")
        .says("<stdin>:1:1");
}

#[test]
fn one_bad_scene_among_good_ones() {
    let folder = Folder::with("good.glsl", GOOD);
    folder.write("bad.glsl", "float f(\n");
    folder
        .run("check good.glsl good.glsl")
        .exits(0)
        .says("good.glsl: fine");
    let outcome = folder.run("check bad.glsl good.glsl");
    outcome.exits(1).says("bad.glsl:1:").says("good.glsl: fine");
    let outcome = folder.run("check gone.glsl bad.glsl good.glsl");
    outcome.exits(2).says("cannot read `gone.glsl`");
    outcome.says("bad.glsl:1:").says("good.glsl: fine");
}
