//! Stand-ins for the site's media: pictures of the same nature, made from nothing.
//!
//! The site's files are not ours to hand on. What shaders compute from noise, dither and letters is
//! right with these; photographs have the same kind of content, colours and contrast. `docs/media.md` tells how like
//! each is. No pixel comes from the originals.

mod abstracts;
mod basilica;
mod bayer;
mod blue_noise;
mod cubemap;
mod field;
mod font;
mod forest;
mod gallery;
mod hash;
mod london;
mod nyancat;
mod organics;
mod painting;
mod pebbles;
mod shape;
mod stars;
mod stones;
mod surfaces;
mod symbols;
mod white_noise;

use super::Texels;
use super::site::{Item, Kind};

/// Counts the changes to what [`make`] makes. Who keeps results has to make them anew when it differs.
pub const VERSION: u32 = 1;

/// The stand-in for one of the site's pictures, cubemaps or volumes: the same on every machine. `None` of films and music.
///
/// Functions like the sine may differ in the last bit between machines, and with them a byte here and there by one.
pub fn make(item: &Item) -> Option<Texels> {
    let (size, format) = match item.kind {
        Kind::Texture {
            size: [x, y],
            format,
        } => ([x, y, 1], format),
        Kind::Cubemap { size } => ([size, size, 6], super::Format::Rgba8),
        Kind::Volume { size, format } => ([size; 3], format),
        Kind::Video | Kind::Music => return None,
    };
    let bytes = bytes(item.name, size.map(|extent| extent as usize))?;
    let texels = size.iter().product::<u32>() as usize;
    assert_eq!(
        bytes.len(),
        texels * format.bytes(),
        "{} has its size",
        item.name
    );
    Some(Texels {
        size,
        format,
        bytes,
    })
}

/// What is to be made of the thing with that name in that size. `None` if there is no such thing.
fn bytes(name: &str, [width, height, depth]: [usize; 3]) -> Option<Vec<u8>> {
    let size = [width, height];
    let count = width * height * depth;
    Some(match name {
        "Abstract 1" => abstracts::glass(size).rgba(),
        "Abstract 2" => abstracts::straw(size).rgba(),
        "Abstract 3" => abstracts::smears(size).rgba(),
        "Bayer" => bayer::bytes(),
        "Blue Noise" => blue_noise::rgba(width, 11),
        "Font 1" => font::rgba(width),
        "Gray Noise Medium" => white_noise::gray(count, 21),
        "Gray Noise Small" => white_noise::gray(count, 22),
        "Lichen" => stones::lichen(size).rgba(),
        "London" => london::street(size).rgba(),
        "Nyancat" => nyancat::rgba(size),
        "Organic 1" => organics::bark(size).rgba(),
        "Organic 2" => organics::rust(size).rgba(),
        "Organic 3" => organics::granite(size).rgba(),
        "Organic 4" => organics::marble(size).rgba(),
        "Pebbles" => pebbles::heights(size).red(),
        "RGBA Noise Medium" => white_noise::rgba_medium(),
        "RGBA Noise Small" => white_noise::rgba_small(width, 23),
        "Rock Tiles" => stones::tiles(size).rgba(),
        "Rusty Metal" => surfaces::metal(size).rgba(),
        "Stars" => stars::cluster(size).rgba(),
        "Wood" => surfaces::wood(size).rgba(),
        "Forest" => cubemap::sharp(width, forest::TONE, forest::light),
        "Forest Blurred" => cubemap::blurred(width, &forest::BLUR, forest::light),
        "St. Peter's Basilica" => cubemap::sharp(width, basilica::TONE, basilica::light),
        "St. Peter's Basilica Blurred" => cubemap::blurred(width, &basilica::BLUR, basilica::light),
        "Uffizi Gallery" => cubemap::sharp(width, gallery::TONE, gallery::light),
        "Uffizi Gallery Blurred" => cubemap::blurred(width, &gallery::BLUR, gallery::light),
        "Grey Noise 3D" => white_noise::gray(count, 24),
        "RGBA Noise 3D" => white_noise::rgba(count, 25),
        _ => return None,
    })
}

#[cfg(test)]
mod tests;
