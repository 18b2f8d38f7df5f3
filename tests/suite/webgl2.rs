//! The template against the picture that WebGL2 draws of it.
//!
//! `tests/webgl2/template.png` was drawn by Chromium (ANGLE on Mesa's llvmpipe) from the same text, at
//! 640×360 and `iTime` 1. Mesa's Vulkan driver for the CPU shares its arithmetic, so what differs there
//! differs by translation; other drivers round in other ways, and are not held against it.

use glam::UVec2;
use vitrine::frame::Clock;
use vitrine::scene::Source;

use crate::support::{distances, draw, gpu, open, read_png, repository};

#[test]
fn the_template_is_the_same_picture_as_in_webgl2() {
    let Some(gpu) = gpu() else { return };
    if !gpu.describe().contains("llvmpipe") {
        eprintln!(
            "not compared with WebGL2: {} has other arithmetic",
            gpu.describe()
        );
        return;
    }
    let size = UVec2::new(640, 360);
    let session = open(gpu, &Source::Path(repository("shadertoy/template")));
    let ours = draw(gpu, &session, &Clock::fixed(60.0).at_time(1.0, size));
    let webgl2 = read_png(&repository("tests/webgl2/template.png"));
    let distances = distances(&ours, &webgl2);
    let near = distances.iter().filter(|&&distance| distance <= 2).count();
    let share = near as f64 / distances.len() as f64;
    println!(
        "{:.3} % of the pixels are within 2/255 of WebGL2's",
        100.0 * share
    );
    assert!(
        share >= 0.999,
        "only {:.3} % of the pixels are within 2/255",
        100.0 * share
    );
}
