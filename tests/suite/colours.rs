//! What a shader's numbers become: bytes as they are, opaque, and 0 where nothing was said.

use glam::UVec2;
use vitrine::frame::Clock;

use crate::support::{Folder, draw, gpu, open, pasted, still, vitrine};

/// The colour of a flat picture of this `mainImage` body.
fn colour(body: &str) -> Option<[u8; 3]> {
    let gpu = gpu()?;
    let text = format!("void mainImage(out vec4 color, in vec2 p) {{ {body} }}");
    let picture = still(gpu, &text, 2, 2);
    let first = picture.pixel(0, 0);
    assert!(
        picture.rgb.chunks(3).all(|pixel| pixel == first),
        "it is flat"
    );
    Some(first)
}

#[test]
fn nothing_is_encoded_as_srgb() {
    let Some([r, g, b]) = colour("color = vec4(0.5, 0.25, 0.75, 1.0);") else {
        return;
    };
    for (byte, exact) in [(r, 127.5), (g, 63.75), (b, 191.25)] {
        assert!(
            (f64::from(byte) - exact).abs() <= 0.75,
            "{byte} for {exact}"
        );
    }
}

#[test]
fn alpha_changes_nothing() {
    let Some(transparent) = colour("color = vec4(1.0, 0.5, 0.25, 0.0);") else {
        return;
    };
    assert_eq!(
        Some(transparent),
        colour("color = vec4(1.0, 0.5, 0.25, 1.0);")
    );
}

#[test]
fn colours_are_clamped() {
    let Some(clamped) = colour("color = vec4(-3.0, 7.0, 1.0, 9.0);") else {
        return;
    };
    assert_eq!(clamped, [0, 255, 255]);
}

#[test]
fn the_colour_starts_at_0() {
    let Some(nothing) = colour("") else { return };
    assert_eq!(nothing, [0, 0, 0]);
    assert_eq!(colour("color.r += 1.0;"), Some([255, 0, 0]));
}

#[test]
fn discarding_leaves_black() {
    let Some(nothing) = colour("color = vec4(1.0); if (p.x > 0.0) discard;") else {
        return;
    };
    assert_eq!(nothing, [0, 0, 0]);
}

#[test]
fn variables_start_at_0() {
    let body = "float a; vec3 b; mat2 m; int i; float list[3];
        bool clean = a == 0.0 && b == vec3(0.0) && m[1] == vec2(0.0) && i == 0 && list[2] == 0.0;
        color = clean ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);";
    let Some(verdict) = colour(body) else { return };
    assert_eq!(verdict, [0, 255, 0]);
}

#[test]
fn the_same_command_gives_the_same_bytes() {
    let Some(_) = gpu() else { return };
    let scene = crate::support::repository("shadertoy/template");
    let folder = Folder::new();
    for out in ["a/%d.png", "b/%d.png"] {
        vitrine("export --frames 58..61 --size 64x36 --out")
            .arg(out)
            .arg(&scene)
            .within(folder.path())
            .run()
            .exits(0);
    }
    for frame in 58..61 {
        let file = |run| folder.read(&format!("{run}/{frame}.png"));
        assert_eq!(file("a"), file("b"), "frame {frame}");
    }
    assert_ne!(folder.read("a/58.png"), folder.read("a/60.png"));
}

#[test]
fn a_frame_does_not_depend_on_those_before_it() {
    let Some(gpu) = gpu() else { return };
    let text =
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(iTime + p.xyx * 0.1), 1.0); }";
    let clock = Clock::fixed(7.0);
    let size = UVec2::new(8, 8);
    let fresh = draw(gpu, &open(gpu, &pasted(text)), &clock.at(5, size));
    let session = open(gpu, &pasted(text));
    for frame in [0, 9, 3] {
        draw(gpu, &session, &clock.at(frame, size));
    }
    assert!(draw(gpu, &session, &clock.at(5, size)) == fresh);
}
