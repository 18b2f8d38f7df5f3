//! Frames that are drawn band by band: the same pictures, and an end to those that have none.

use std::time::{Duration, Instant};

use glam::UVec2;
use vitrine::frame::{Clock, FrameImage};
use vitrine::render::{Extras, Gpu, Pace, ReadBack};
use vitrine::session::Session;
use vitrine::translate::{Checks, Options};

use crate::support::{Folder, gpu, pasted, vitrine};

/// Derivatives, a texture read by them, what is discarded, and a finding in each column.
const TEXT: &str = "void mainImage(out vec4 c, in vec2 p) {
    vec2 uv = p / iResolution.xy;
    float wave = sin(40. * uv.x * uv.y + iTime);
    if (mod(floor(p.y), 7.) == 3. && uv.x > .8) discard;
    c = vec4(fwidth(wave) * 9., dFdx(wave * wave) + .5, dFdy(wave) * 5. + .5, 1. / (floor(p.y) - 5.));
}";

/// A frame, and what it found.
fn drawn(gpu: &Gpu, session: &Session, size: UVec2, pace: Option<Pace>) -> (FrameImage, Vec<u32>) {
    let mut canvas = session.renderer.canvas(gpu, size).expect("a canvas");
    let extras = Extras {
        timed_passes: session.renderer.pass_count(),
        finding_words: session.renderer.finding_words(),
    };
    let mut ring = ReadBack::new(gpu, &canvas.target, 1, extras).expect("a slot");
    let slot = &mut ring.slots[0];
    let input = Clock::fixed(60.0).at_time(1.0, size);
    let renderer = &session.renderer;
    match pace {
        None => renderer.render(gpu, &input, &mut canvas, Some(slot)),
        Some(mut pace) => {
            let mut bands = 0;
            let mut between = || {
                bands += 1;
                true
            };
            let is_drawn = renderer.render_in_bands(
                gpu,
                &input,
                &mut canvas,
                Some(slot),
                &mut pace,
                &mut between,
            );
            assert!(is_drawn.expect("the device works"));
            assert!(bands > 0, "there is one band only");
        }
    }
    while !slot.is_ready(gpu).expect("the device works") {}
    let mut image = FrameImage::default();
    let transferred = slot.take(gpu, &mut image).expect("a picture");
    assert!(transferred.gpu_seconds.is_none_or(|seconds| seconds > 0.0));
    (image, transferred.findings)
}

#[test]
fn a_picture_in_bands_is_the_same() {
    let Some(gpu) = gpu() else { return };
    let options = Options {
        checks: Checks::All,
        ..Options::default()
    };
    let session = Session::open(gpu, &pasted(TEXT), &options.into()).expect("a good scene");
    for size in [UVec2::new(320, 181), UVec2::new(33, 1200)] {
        let whole = drawn(gpu, &session, size, None);
        let mut slow = Pace::new(gpu, size);
        slow.took(2, Duration::from_secs(9));
        assert!(whole == drawn(gpu, &session, size, Some(slow)), "{size}");
    }
}

/// The second `castRay` of a seed: its step is a hundredth of a distance that begins at zero.
const ENDLESS: &str = "float castRay(vec3 ro, vec3 rd) {
    float dt = 0.1;
    for (float t = 0.0; t < 100.0; t += dt) {
        vec3 p = ro + rd * t;
        if (p.y < sin(p.x) * sin(p.z) - 50.0) return t;
        dt = 0.01 * t;
    }
    return 0.0;
}
void mainImage(out vec4 c, in vec2 p) {
    vec2 uv = (p - 0.5 * iResolution.xy) / iResolution.y;
    c = vec4(castRay(vec3(0, 3, iTime), normalize(vec3(uv, 1))));
}";

#[test]
fn a_frame_that_never_ends_is_given_up_and_its_loop_named() {
    if gpu().is_none() {
        return;
    }
    let folder = Folder::with("endless.glsl", ENDLESS);
    let began = Instant::now();
    let outcome = vitrine("export endless.glsl --out a.png --size 4096x4096 --frame-timeout 1")
        .within(folder.path())
        .run();
    let text = &outcome.stderr;
    assert_eq!(outcome.code, Some(2), "{text}");
    assert!(text.contains("this loop does not end"), "{text}");
    assert!(text.contains("endless.glsl:3:5"), "{text}");
    assert!(text.contains("a frame was not finished after"), "{text}");
    assert!(!folder.path().join("a.png").exists(), "nothing half-done");
    // The machine may be busy with other things, but not for minutes.
    assert!(began.elapsed() < Duration::from_secs(60));
}

#[test]
fn a_loop_that_is_cut_off_is_told_without_being_asked() {
    if gpu().is_none() {
        return;
    }
    let folder = Folder::with("endless.glsl", ENDLESS);
    let outcome = vitrine("export endless.glsl --out a.png --size 8x8")
        .within(folder.path())
        .run();
    let text = &outcome.stderr;
    assert_eq!(outcome.code, Some(0), "{text}");
    assert!(
        text.contains("this loop does not end in 64 pixels"),
        "{text}"
    );
}
