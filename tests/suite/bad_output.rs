//! An export that cannot succeed says why and leaves nothing half-written.

use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use crate::support::{Folder, gpu, vitrine};

/// Noise, which no compression makes small.
const GOOD: &str = "void mainImage(out vec4 c, in vec2 p) {
    c = vec4(fract(sin(p.xyx * p.yyx * 99.0) * 9999.0), 1.0);
}\n";

/// Expects an export of a good scene to be refused with exit code 2, and to write nothing.
#[track_caller]
fn refused(arguments: &str, words: &[&str]) {
    let folder = Folder::with("a.glsl", GOOD);
    let outcome = folder.run(&format!("export a.glsl {arguments}"));
    outcome.exits(2);
    for words in words {
        outcome.says(words);
    }
    assert_eq!(folder.files(), ["a.glsl"], "nothing is written");
}

#[test]
fn a_picture_without_pixels() {
    for size in ["0x5", "5x0", "0x0"] {
        let message = "a picture has at least one pixel each way";
        refused(&format!("--out a.png --size {size}"), &[message]);
    }
    refused(
        "--out a.png --size 640",
        &["write it as WxH, as in 640x360"],
    );
}

#[test]
fn a_picture_beyond_the_device() {
    let Some(gpu) = gpu() else { return };
    let limit = gpu.max_size();
    for size in [format!("{}x5", limit + 1), format!("5x{}", u32::MAX)] {
        let message = format!("error: a picture of {size} is beyond this adapter");
        let limits = format!("to {limit}x{limit}");
        let hint = "help: choose a size within these limits with `--size WxH`";
        refused(
            &format!("--out a.png --size {size}"),
            &[&message, &limits, hint],
        );
    }
}

#[test]
fn several_frames_for_one_file() {
    let message = "error: 5 frames cannot all be written to one file";
    let hint = "help: put `%d` or `%05d` into `--out`";
    refused("--out a.png --frames 0..5", &[message, hint]);
}

#[test]
fn frames_that_run_backwards_or_are_none() {
    refused("--out %d.png --frames 5..2", &["did you mean 2..5?"]);
    refused(
        "--out %d.png --frames 5..5",
        &["5..5 holds no frame", "did you mean 5..6?"],
    );
    refused("--out %d.png --frames 5", &["write it as A..B"]);
    refused(
        "--out %d.png --frames 0..9 --time 1",
        &["cannot be used with"],
    );
}

#[test]
fn frames_per_second_that_are_no_number() {
    for fps in ["0", "-5", "nan", "inf", "fast"] {
        // With `=`, so that a minus sign is not taken for an option.
        refused(&format!("--out %d.png --fps={fps}"), &["--fps <N>"]);
    }
}

#[test]
fn a_name_that_is_no_pattern() {
    refused("--out=", &["error: `--out `: the output path is empty"]);
    refused(
        "--out %s.png",
        &[
            "`%` must be followed by `d`",
            "a plain percent sign is `%%`",
        ],
    );
    refused(
        "--out frames",
        &["the output path must end in `.png` or `.exr`"],
    );
}

#[test]
fn a_folder_that_is_a_file() {
    let Some(_) = gpu() else { return };
    refused(
        "--out a.glsl/%d.png",
        &["error: cannot write `a.glsl/0.png`", "help: "],
    );
}

#[cfg(unix)]
#[test]
fn a_disk_that_is_full() {
    let Some(_) = gpu() else { return };
    let folder = Folder::with("a.glsl", GOOD);
    // The system refuses files beyond a limit as it refuses them on a full disk.
    let mut program = vitrine("").within(folder.path());
    let mut shell = Command::new("sh");
    shell.args(["-c", "trap '' XFSZ; ulimit -f 8; exec \"$@\"", "sh"]);
    shell
        .arg(program.command.get_program())
        .args(["export", "a.glsl"]);
    shell
        .args(["--out", "%d.png", "--frames", "0..6"])
        .env("NO_COLOR", "1");
    program.command = shell;
    let outcome = program.within(folder.path()).run();
    outcome
        .exits(2)
        .says("error: cannot write `")
        .says("help: is there room on the disk");
    assert_eq!(folder.files(), ["a.glsl"], "no file that is not whole");
}

#[test]
fn a_file_that_is_in_the_way() {
    let Some(_) = gpu() else { return };
    let folder = Folder::with("a.glsl", GOOD);
    folder.write("3.png", "mine");
    let command = "export a.glsl --out %d.png --frames 0..5 --size 8x8";
    let outcome = folder.run(command);
    outcome
        .exits(2)
        .says("error: `3.png` exists already")
        .says("help: add `--overwrite`");
    assert_eq!(folder.files(), ["3.png", "a.glsl"], "nothing is written");
    assert_eq!(folder.read("3.png"), b"mine", "it is left alone");

    folder.run(&format!("{command} --overwrite")).exits(0);
    assert_ne!(folder.read("3.png"), b"mine");
    assert_eq!(folder.files().len(), 6);
}

#[test]
fn statistics_that_cannot_be_written() {
    let Some(_) = gpu() else { return };
    let folder = Folder::with("a.glsl", GOOD);
    let outcome = folder.run("export a.glsl --out a.png --size 8x8 --stats a.glsl/b.json");
    outcome.exits(2).says("error: cannot write `a.glsl/b.json`");
    assert!(!folder.files().iter().any(|name| name.contains(".part")));
}

#[test]
fn a_machine_without_an_adapter() {
    let folder = Folder::with("a.glsl", GOOD);
    let without_drivers = |arguments: &str| {
        let mut program = vitrine(arguments).within(folder.path());
        for variable in ["VK_ICD_FILENAMES", "VK_DRIVER_FILES"] {
            program.command.env(variable, "/nonexistent");
        }
        program.command.env("WGPU_BACKEND", "vulkan");
        program.run()
    };
    let outcome = without_drivers("export a.glsl --out a.png");
    outcome
        .exits(2)
        .says("error: no graphics adapter was found")
        .says("mesa-vulkan-drivers");
    let doctor = without_drivers("doctor");
    assert!(
        doctor
            .exits(2)
            .text()
            .contains("No graphics adapter was found")
    );
    assert_eq!(folder.files(), ["a.glsl"]);
    // What needs no adapter goes on working.
    without_drivers("check a.glsl").exits(0);
}

#[test]
fn an_adapter_that_is_not_there() {
    let Some(_) = gpu() else { return };
    let message = "error: no adapter matches `voodoo2`; there are: ";
    let hint = "help: `vitrine doctor` lists the adapters";
    refused("--out a.png --adapter voodoo2", &[message, hint]);
}

/// Exports a scene with two seconds for each frame on a driver that draws on the CPU, and expects it
/// to be given up. Without such a driver, or if it `may_succeed` and does, there is nothing to see.
#[track_caller]
fn given_up(text: &str, may_succeed: bool) {
    let Some(_) = gpu() else { return };
    let mut adapters = vitrine::render::adapters().into_iter();
    if !adapters.any(|adapter| adapter.kind == "CPU") {
        eprintln!("skipped, only a driver on the CPU is known to be slow enough");
        return;
    }
    let folder = Folder::with("a.glsl", text);
    let outcome =
        folder.run("export a.glsl --out a.png --size 2000x2000 --frame-timeout 2 --adapter cpu");
    if may_succeed && outcome.code == Some(0) {
        return;
    }
    outcome
        .exits(2)
        .says("error: ")
        .says("after 2 s")
        .says("`--frame-timeout SECONDS`");
    assert_eq!(folder.files(), ["a.glsl"], "nothing is written");
}

#[test]
fn a_frame_that_takes_too_long() {
    let text = "void mainImage(out vec4 c, in vec2 p) {
        float x = p.x; for (int i = 0; i < 60000; i++) x = sin(x + p.y); c = vec4(x); }";
    given_up(text, false);
}

#[test]
fn a_shader_that_takes_the_driver_too_long() {
    // Some drivers turn each access into a ladder of as many steps as there are elements.
    let text = "float list[40000];
        void mainImage(out vec4 c, in vec2 p) { list[int(p.x)] = 1.0; c = vec4(list[int(p.y)]); }";
    given_up(text, true);
}

#[test]
fn a_long_range_begins_at_once() {
    let Some(_) = gpu() else { return };
    let folder = Folder::with("a.glsl", GOOD);
    let mut program = vitrine("export a.glsl --out %d.png --frames 0..2000000000 --size 8x8")
        .within(folder.path());
    let mut child = program
        .command
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let first = folder.path().join("0.png");
    let begun = (0..200).any(|_| {
        thread::sleep(Duration::from_millis(50));
        first.exists()
    });
    child.kill().expect("it is running");
    child.wait().expect("it ends");
    assert!(begun, "no frame after ten seconds");
}
