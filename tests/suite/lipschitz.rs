//! The steepest slope that a scene relies on is the one that its heightfield has.

use std::fs;

use glam::UVec2;
use vitrine::frame::Clock;
use vitrine::scene::Source;

use crate::support::{Folder, draw, gpu, open, repository};

/// Each pixel holds the steepest of 144 slopes, for a HEIGHT of 1, of the 8 that a byte can hold.
const SLOPES: &str = "
void mainImage(out vec4 color, in vec2 p) {
    float steepest = 0.0;
    for (int i = 0; i < 144; i++) {
        vec2 at = 0.031 * (12.0 * floor(p) + vec2(i % 12, i / 12));
        vec2 e = vec2(0.004, 0.0);
        vec2 rise = vec2(h(at + e.xy) - h(at - e.xy), h(at + e.yx) - h(at - e.yx));
        steepest = max(steepest, length(rise) / (2.0 * e.x * HEIGHT));
    }
    color = vec4(steepest / 8.0, SLOPE / 8.0, 0.0, 1.0);
}";

#[test]
fn the_bound_holds_and_is_no_larger_than_it_must_be() {
    let Some(gpu) = gpu() else { return };
    let height = repository("shadertoy/lipschitz/height.glsl");
    let folder = Folder::with("common.glsl", fs::read(height).expect("the heightfield"));
    folder.write("image.glsl", SLOPES);
    let session = open(gpu, &Source::Path(folder.path().to_owned()));
    let picture = draw(gpu, &session, &Clock::fixed(60.0).at(0, UVec2::splat(256)));
    let level = 8.0 / 255.0;
    let steepest = picture.rgb.chunks(3).map(|pixel| pixel[0]).max();
    let steepest = f64::from(steepest.expect("there are pixels")) * level;
    let bound = f64::from(picture.pixel(0, 0)[1]) * level;
    assert!(
        (0.95 * bound..=bound + level).contains(&steepest),
        "the steepest slope is {steepest}, and the scene says {bound}"
    );
}
