//! Every uniform arrives, and an export's clock gives each frame the same values on any day.

use glam::Vec4;
use vitrine::frame::Clock;

use crate::support::{Folder, assert_claims, claims, draw, gpu, open, pasted, read_png};

/// Exports a claims shader and holds each of the named files against it.
fn assert_exported(these: &[&str], arguments: &str, files: &[&str]) {
    let Some(_) = gpu() else { return };
    let folder = Folder::with("claims.glsl", claims(these));
    let size = format!("{}x1", these.len());
    let command = format!("export claims.glsl --out %d.png --size {size} {arguments}");
    folder.run(&command).exits(0);
    let mut expected: Vec<_> = files.to_vec();
    expected.push("claims.glsl");
    assert_eq!(folder.files(), expected);
    for file in files {
        assert_claims(these, &read_png(&folder.path().join(file)));
    }
}

#[test]
fn a_frame_is_drawn_with_the_values_of_its_number() {
    assert_exported(
        &[
            "iTime == 0.4",
            "iTimeDelta == 0.1",
            "iFrameRate == 10.0",
            "iFrame == 4",
            "iMouse == vec4(0.0)",
            "iDate.xyz == vec3(2024.0, 0.0, 1.0)",
            "iDate.w == 43200.0",
            "iSampleRate == 44100.0",
            "iResolution == vec3(9.0, 1.0, 1.0)",
        ],
        "--frames 4..5 --fps 10",
        &["4.png"],
    );
}

#[test]
fn a_range_leaves_its_end_out() {
    assert_exported(
        &["iFrame >= 3 && iFrame < 6", "iTime == float(iFrame) / 10.0"],
        "--frames 3..6 --fps 10",
        &["3.png", "4.png", "5.png"],
    );
}

#[test]
fn frames_of_a_range_differ_by_their_number() {
    let Some(_) = gpu() else { return };
    let text = "void mainImage(out vec4 c, in vec2 p) { c = vec4(float(iFrame), iTime * 60.0, 0.0, 0.0) / 255.0; }";
    let folder = Folder::with("a.glsl", text);
    folder
        .run("export a.glsl --out %03d.png --frames 7..27 --size 1x1")
        .exits(0);
    for frame in 7..27_u8 {
        let file = folder.path().join(format!("{frame:03}.png"));
        assert_eq!(read_png(&file).pixel(0, 0), [frame, frame, 0]);
    }
}

#[test]
fn a_single_time_has_the_nearest_frame_number() {
    assert_exported(
        &[
            "iTime == 1.01",
            "iFrame == 61",
            "iTimeDelta == 1.0 / 60.0",
            "iFrameRate == 60.0",
        ],
        "--time 1.01",
        &["61.png"],
    );
}

#[test]
fn without_a_choice_it_is_frame_0() {
    assert_exported(&["iTime == 0.0 && iFrame == 0"], "", &["0.png"]);
}

#[test]
fn what_a_window_hands_over_arrives() {
    let Some(gpu) = gpu() else { return };
    let these = [
        "iTime == 12.5",
        "iTimeDelta == 0.25",
        "iFrameRate == 59.5",
        "iFrame == 2147483647",
        "iMouse == vec4(10.0, 20.0, -30.0, -40.0)",
        "iDate == vec4(2025.0, 11.0, 31.0, 86399.5)",
    ];
    let mut input = Clock::fixed(60.0).at(0, glam::UVec2::new(these.len() as u32, 1));
    input.time = 12.5;
    input.time_delta = 0.25;
    input.frame_rate = 59.5;
    input.frame = i32::MAX;
    input.mouse = Vec4::new(10.0, 20.0, -30.0, -40.0);
    input.date = Vec4::new(2025.0, 11.0, 31.0, 86_399.5);
    let session = open(gpu, &pasted(&claims(&these)));
    assert_claims(&these, &draw(gpu, &session, &input));
}

#[test]
fn uniforms_can_be_read_in_any_combination() {
    let Some(gpu) = gpu() else { return };
    // The block holds what is used only, so that every combination has places of its own.
    for these in [
        &["iFrame == 3", "iChannelTime[3] == 0.0"][..],
        &["iDate.x == 2024.0", "iTime == 0.05"],
        &[
            "iChannelResolution[2].z == 0.0",
            "iFrameRate == 60.0",
            "iFrame == 3",
        ],
        &["iSampleRate == 44100.0"],
    ] {
        let input = Clock::fixed(60.0).at(3, glam::UVec2::new(these.len() as u32, 1));
        let session = open(gpu, &pasted(&claims(these)));
        assert_claims(these, &draw(gpu, &session, &input));
    }
}
