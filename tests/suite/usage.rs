//! The commands as such: what they print where, and what they do without a scene.

use serde_json::Value;

use crate::support::{Folder, scene_folders, vitrine};

const GOOD: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(iTime); }\n";

#[test]
fn help_names_every_command_and_its_defaults() {
    let help = vitrine("--help").run().exits(0).text();
    for command in ["check", "translate", "inspect"] {
        assert!(help.contains(command), "{help}");
        let text = vitrine(command).arg("--help").run().exits(0).text();
        assert!(text.contains("or `-` for standard input"), "{text}");
    }
}

#[cfg(feature = "gpu")]
#[test]
fn help_names_the_defaults_of_an_export() {
    let text = vitrine("export --help").run().exits(0).text();
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let defaults = [
        "[default: the scene's own, or 1280x720]",
        "[default: 60]",
        "[default: frame 0 alone]",
    ];
    for words in defaults.iter().chain(&["--overwrite", "--adapter", "A..B"]) {
        assert!(text.contains(words), "{words} in {text}");
    }
}

#[test]
fn a_command_that_is_none_exits_with_2() {
    let outcome = vitrine("frobnicate").run();
    outcome
        .exits(2)
        .says("unrecognized subcommand 'frobnicate'");
    vitrine("").run().exits(2).says("Usage: vitrine <COMMAND>");
    vitrine("check").run().exits(2).says("Usage: vitrine check");
}

#[test]
fn check_finds_nothing_wrong_with_the_scenes() {
    for (name, folder) in scene_folders() {
        let outcome = vitrine("check").arg(&folder).run();
        outcome.exits(0).says(": fine");
        // The seeds' code counts on `smoothstep` with reversed edges here and there.
        let mut others = outcome
            .stderr
            .lines()
            .filter(|line| line.starts_with("warning"));
        assert!(
            others.all(|line| line.contains("reversed-smoothstep")),
            "{name}"
        );
        let outcome = vitrine("check --format json").arg(&folder).run();
        let line: Value = serde_json::from_str(&outcome.exits(0).text()).expect("one object");
        assert_eq!(line["verdict"], "accept", "{name}");
    }
}

#[test]
fn a_warning_is_shown_and_the_scene_is_fine() {
    let text = "// iChannel0 is the sea.\n\
                void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n";
    let folder = Folder::with("a.glsl", text);
    folder
        .run("check a.glsl")
        .exits(0)
        .says("warning[unbound-channel]: `iChannel0` is read but nothing is bound to it")
        .says("a.glsl:2:53")
        .says("help: bind it in a scene folder's scene.toml")
        .says("a.glsl: fine");
    let json = folder.run("check a.glsl --format json").exits(0).text();
    let line: Value = serde_json::from_str(&json).expect("one object");
    assert_eq!(line["verdict"], "accept");
    let warning = &line["passes"][0]["diagnostics"][0];
    assert_eq!(warning["severity"], "warning");
}

#[test]
fn json_has_a_line_a_file_with_every_key() {
    let text = "float f() {\n    return lost;\n}\nvoid mainImage(out vec4 c, in vec2 p) {}\n";
    let folder = Folder::with("a.glsl", text);
    folder.write("empty/notes.txt", "");
    let text = folder
        .run("check a.glsl empty --format json")
        .exits(1)
        .text();
    let lines = text.lines().map(serde_json::from_str);
    let lines: Vec<Value> = lines.collect::<Result<_, _>>().expect("an object a line");
    assert_eq!(lines.len(), 2, "{text}");
    assert_eq!(lines[0]["file"], "a.glsl");
    assert_eq!(lines[1]["file"], "empty");
    let pass = &lines[0]["passes"][0];
    assert_eq!(pass["name"], "Image");
    let (in_pass, in_scene) = (&pass["diagnostics"][0], &lines[1]["diagnostics"][0]);
    for found in [in_pass, in_scene] {
        for key in ["file", "line", "column", "end_line", "end_column"] {
            assert!(found.get(key).is_some(), "no {key} in {found}");
        }
        for key in ["message", "pass", "code", "hint"] {
            assert!(found.get(key).is_some(), "no {key} in {found}");
        }
        assert_eq!(found["severity"], "error");
    }
    for line in [pass, &lines[0], &lines[1]] {
        assert_eq!(line["verdict"], "refuse");
    }
    let place = |key: &str| in_pass[key].as_u64();
    assert_eq!(in_pass["file"], "a.glsl");
    assert_eq!((place("line"), place("column")), (Some(2), Some(12)));
    assert_eq!(
        (place("end_line"), place("end_column")),
        (Some(2), Some(16))
    );
    assert_eq!(in_pass["pass"], "Image");
    assert_eq!(in_pass["code"], "unknown-variable");
    // A folder without a scene has no file to point into.
    assert_eq!(in_scene["file"], Value::Null);
}

#[test]
fn a_scene_comes_from_a_file_a_folder_or_standard_input() {
    let folder = Folder::with("a.glsl", GOOD);
    folder.write("b.frag", GOOD);
    folder.write("c/image.glsl", GOOD);
    for scene in ["a.glsl", "b.frag", "c"] {
        folder.run(&format!("check {scene}")).exits(0);
    }
    vitrine("check -")
        .input(GOOD)
        .run()
        .exits(0)
        .says("-: fine");
}

#[test]
fn nothing_is_coloured_where_no_terminal_is() {
    let mut program = vitrine("check -").input("float f(");
    program.command.env_remove("NO_COLOR");
    let outcome = program.run();
    assert!(
        !outcome.exits(1).stderr.contains('\u{1b}'),
        "{:?}",
        outcome.stderr
    );
}

/// A file that takes nothing, as on a full disk.
#[cfg(target_os = "linux")]
fn full() -> std::fs::File {
    let mut options = std::fs::OpenOptions::new();
    options.write(true).open("/dev/full").expect("the device")
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_output_is_a_failure_not_a_panic() {
    let folder = Folder::with("a.glsl", GOOD);
    folder.write("bad.glsl", "float f(");
    for command in [
        "translate a.glsl --to wgsl",
        "inspect a.glsl",
        "inspect a.glsl --format json",
        "check bad.glsl --format json",
    ] {
        let mut program = vitrine(command).within(folder.path());
        let output = program
            .command
            .stdout(full())
            .output()
            .expect("the program starts");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{command}: {stderr}");
        assert!(!stderr.contains("panicked"), "{stderr}");
    }
}

#[cfg(all(target_os = "linux", feature = "gpu"))]
#[test]
fn a_full_standard_error_does_not_stop_an_export() {
    let Some(_) = crate::support::gpu() else {
        return;
    };
    // It has a warning to say, and a frame to announce.
    let text = "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n";
    let folder = Folder::with("a.glsl", text);
    let mut program = vitrine("export a.glsl --out a.png --size 8x8").within(folder.path());
    let status = program
        .command
        .stderr(full())
        .status()
        .expect("the program starts");
    assert_eq!(status.code(), Some(0));
    assert_eq!(folder.files(), ["a.glsl", "a.png"]);
}

#[cfg(all(target_os = "linux", feature = "window"))]
#[test]
fn without_a_display_a_window_is_refused_with_a_way_out() {
    let folder = Folder::with("a.glsl", GOOD);
    let mut program = vitrine("run a.glsl").within(folder.path());
    for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        program.command.env_remove(variable);
    }
    let outcome = program.run();
    outcome
        .exits(2)
        .says("error: no window can be opened")
        .says("`vitrine export`");
    assert!(
        !outcome.stderr.contains(".rs:"),
        "a place in the source:\n{}",
        outcome.stderr
    );
}
