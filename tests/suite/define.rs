//! Macros from the command line.

use crate::support::{Folder, vitrine};

const GOOD: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(iTime); }\n";

#[test]
fn every_command_that_translates_takes_them() {
    let folder = Folder::with("a.glsl", GOOD);
    for command in [
        "check a.glsl",
        "inspect a.glsl",
        "translate a.glsl --to wgsl",
    ] {
        for macros in ["-D STEPS=64", "-DSTEPS=64 -D FAST", "--define STEPS="] {
            folder.run(&format!("{command} {macros}")).exits(0);
        }
    }
}

#[test]
fn what_is_no_macro_is_refused_with_a_reason() {
    let folder = Folder::with("a.glsl", GOOD);
    for command in [
        "check a.glsl",
        "inspect a.glsl",
        "translate a.glsl --to wgsl",
    ] {
        let outcome = folder.run(&format!("{command} -D 4ever=1"));
        outcome
            .exits(2)
            .says("invalid value '4ever=1' for '--define <NAME[=VALUE]>'")
            .says("`4ever` is no name of a macro");
    }
    let outcome = vitrine("check a.glsl --define").arg("F(x)=x").run();
    outcome.exits(2).says("`F(x)` is no name of a macro");
}

#[cfg(feature = "gpu")]
#[test]
fn an_export_takes_them() {
    if crate::support::gpu().is_none() {
        return;
    }
    let folder = Folder::with("a.glsl", GOOD);
    folder
        .run("export a.glsl -D STEPS=4 --size 8x8 --out a.png")
        .exits(0);
}
