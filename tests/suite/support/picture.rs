use std::fmt::Write as _;
use std::path::Path;

use glam::UVec2;
use image::RgbImage;
use vitrine::frame::FrameImage;

pub fn read_png(path: &Path) -> FrameImage {
    let picture = image::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let picture = picture.into_rgb8();
    FrameImage {
        size: UVec2::new(picture.width(), picture.height()),
        rgb: picture.into_raw(),
    }
}

pub fn write_png(path: &Path, picture: &FrameImage) {
    RgbImage::from_raw(picture.size.x, picture.size.y, picture.rgb.clone())
        .expect("the picture is complete")
        .save(path)
        .expect("the picture can be written");
}

/// How far apart two pictures of one size are in each pixel: the largest difference of a channel.
pub fn distances(a: &FrameImage, b: &FrameImage) -> Vec<u8> {
    assert_eq!(a.size, b.size);
    let pixels = a.rgb.chunks(3).zip(b.rgb.chunks(3));
    pixels
        .map(|(a, b)| (0..3).map(|i| a[i].abs_diff(b[i])).max().unwrap_or(0))
        .collect()
}

/// How many pixels are not the same in two pictures of one size.
pub fn differing(a: &FrameImage, b: &FrameImage) -> usize {
    distances(a, b).into_iter().filter(|&d| d > 0).count()
}

/// A shader that paints one pixel for each claim, a GLSL expression of type bool: green where it
/// holds, red where it does not. Draw it `claims.len()` pixels wide and one high.
pub fn claims(claims: &[&str]) -> String {
    let mut body = String::new();
    for (index, claim) in claims.iter().enumerate() {
        writeln!(body, "    if (i == {index}) holds = ({claim});").expect("strings take all text");
    }
    format!(
        "void mainImage(out vec4 color, in vec2 p) {{\n    \
         int i = int(p.x);\n    bool holds = false;\n{body}    \
         color = holds ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);\n}}\n"
    )
}

/// Reads the picture of a [`claims`] shader.
#[track_caller]
pub fn assert_claims(claims: &[&str], picture: &FrameImage) {
    assert_eq!(picture.size.x as usize, claims.len(), "a pixel for each");
    let wrong: Vec<_> = (0..)
        .zip(claims)
        .filter(|(x, _)| picture.pixel(*x, 0) != [0, 255, 0])
        .map(|(_, claim)| *claim)
        .collect();
    assert!(wrong.is_empty(), "these do not hold: {wrong:#?}");
}
