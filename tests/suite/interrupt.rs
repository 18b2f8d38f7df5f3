//! Ctrl+C during an export leaves whole files, and a way to go on.

use std::process::{Command, Stdio};
use std::time::Duration;

use crate::support::{Folder, gpu, read_png, vitrine};

const SCENE: &str =
    "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(p.xyx * 0.01 + iTime), 1.0); }";

/// Starts an export and interrupts it at its first file. `None` if it was finished already.
fn interrupted(folder: &Folder, frames: u32) -> Option<String> {
    let command = format!("export a.glsl --out out/%d.png --size 320x180 --frames 0..{frames}");
    let mut child = vitrine(&command)
        .within(folder.path())
        .command
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let first = folder.path().join("out/0.png");
    while !first.exists() && child.try_wait().expect("it can be asked").is_none() {
        std::thread::sleep(Duration::from_millis(2));
    }
    // The shell's own `kill`: a bare system has no other.
    let killed = Command::new("sh")
        .args(["-c", &format!("kill -INT {}", child.id())])
        .status();
    assert!(killed.expect("there is a shell").success());
    let output = child.wait_with_output().expect("the program ends");
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    match output.status.code() {
        Some(0) => None,
        code => {
            assert_eq!(code, Some(130), "{stderr}");
            Some(stderr)
        }
    }
}

#[test]
fn an_interrupted_export_can_be_completed() {
    let Some(_) = gpu() else { return };
    // A fast machine may be through with a short export before the signal arrives.
    for frames in [200, 2_000, 20_000] {
        let folder = Folder::with("a.glsl", SCENE);
        let Some(said) = interrupted(&folder, frames) else {
            continue;
        };

        let written = folder.files().len() - 1;
        assert!(
            said.contains(&format!("interrupted after {written} of {frames} frames")),
            "{said}"
        );
        let rest = format!("--frames {written}..{frames}");
        assert!(said.contains(&rest), "{said}");
        for frame in 0..written {
            read_png(&folder.path().join(format!("out/{frame}.png")));
        }
        // Without `--overwrite`, so that the ranges do not overlap either.
        let command = format!("export a.glsl --out out/%d.png --size 8x8 {rest}");
        folder.run(&command).exits(0);
        assert_eq!(folder.files().len() - 1, frames as usize);
        return;
    }
    panic!("no export was long enough to be interrupted");
}
