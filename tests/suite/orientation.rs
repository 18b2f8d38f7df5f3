//! Up is up: `fragCoord` grows to the right and upward, in every way of asking.

use crate::support::{Folder, assert_claims, claims, gpu, read_png, still};

const CORNERS: &str = "
void mainImage(out vec4 color, in vec2 p) {
    vec2 side = step(iResolution.xy * 0.5, p);
    vec3 bottom = mix(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), side.x);
    vec3 top = mix(vec3(0.0, 0.0, 1.0), vec3(1.0, 1.0, 0.0), side.x);
    color = vec4(mix(bottom, top, side.y), 1.0);
}";

/// Top left, top right, bottom left and bottom right of [`CORNERS`].
const COLOURS: [[u8; 3]; 4] = [[0, 0, 255], [255, 255, 0], [255, 0, 0], [0, 255, 0]];

fn corners(picture: &vitrine::frame::FrameImage) -> [[u8; 3]; 4] {
    let (right, bottom) = (picture.size.x - 1, picture.size.y - 1);
    [(0, 0), (right, 0), (0, bottom), (right, bottom)].map(|(x, y)| picture.pixel(x, y))
}

#[test]
fn each_corner_has_its_colour() {
    let Some(gpu) = gpu() else { return };
    assert_eq!(corners(&still(gpu, CORNERS, 30, 20)), COLOURS);
    // A width whose rows are padded on their way back.
    assert_eq!(corners(&still(gpu, CORNERS, 67, 3)), COLOURS);
}

#[test]
fn each_corner_has_its_colour_in_a_file() {
    let Some(_) = gpu() else { return };
    let folder = Folder::with("corners.glsl", CORNERS);
    folder
        .run("export corners.glsl --out a.png --size 31x17")
        .exits(0);
    assert_eq!(corners(&read_png(&folder.path().join("a.png"))), COLOURS);
}

#[test]
fn derivatives_point_right_and_up() {
    let Some(gpu) = gpu() else { return };
    let text = "
    void mainImage(out vec4 color, in vec2 p) {
        color = vec4(dFdx(p.x), dFdy(p.y), 0.5 + dFdy(p.x) + dFdx(p.y), 1.0);
    }";
    let picture = still(gpu, text, 8, 8);
    for pixel in picture.rgb.chunks(3) {
        assert_eq!(pixel[..2], [255, 255], "each step is one pixel");
        assert!(
            (127..=128).contains(&pixel[2]),
            "and sideways nothing: {}",
            pixel[2]
        );
    }
}

#[test]
fn coordinates_are_pixel_centres_from_the_bottom_left() {
    let Some(gpu) = gpu() else { return };
    let these = [
        "p == vec2(float(i) + 0.5, 0.5)",
        "gl_FragCoord.xy == p",
        "iResolution == vec3(3.0, 1.0, 1.0)",
    ];
    assert_claims(&these, &still(gpu, &claims(&these), 3, 1));

    let rows = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.y / 255.0); }";
    let picture = still(gpu, rows, 1, 100);
    // Half a level is rounded either way.
    assert!(picture.pixel(0, 99)[0] <= 1, "the lowest row");
    assert!(
        (99..=100).contains(&picture.pixel(0, 0)[0]),
        "the highest row"
    );
}
