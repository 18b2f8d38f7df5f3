//! Pictures from files: textures, and the faces of cubemaps.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use image::{DynamicImage, ImageReader, Limits};

use super::{Format, MediaError, Texels};

/// The most texels each way.
const MAX_SIDE: u32 = 16_384;

/// The most memory that decoding a picture takes.
const MAX_MEMORY: u64 = 1 << 30;

/// Decodes a picture: PNG, JPEG, WebP, the first frame of a GIF, HDR or EXR. Colours are taken as they are, and so is alpha.
/// A picture of one grey channel becomes four channels, unless `format` asks for one.
pub(super) fn read(
    path: &Path,
    bytes: &[u8],
    format: Option<Format>,
) -> Result<Texels, MediaError> {
    let picture = decode(path, bytes)?;
    let size = [picture.width(), picture.height(), 1];
    let is_float = matches!(
        picture,
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_)
    );
    Ok(match (is_float, format) {
        (true, _) => Texels {
            size,
            format: Format::Rgba32Float,
            bytes: picture
                .into_rgba32f()
                .into_raw()
                .into_iter()
                .flat_map(f32::to_le_bytes)
                .collect(),
        },
        // The site hands coloured pictures to a texture of one channel as well: red remains.
        (false, Some(Format::R8)) => Texels {
            size,
            format: Format::R8,
            bytes: picture
                .into_rgba8()
                .pixels()
                .map(|pixel| pixel[0])
                .collect(),
        },
        (false, _) => Texels {
            size,
            format: Format::Rgba8,
            bytes: picture.into_rgba8().into_raw(),
        },
    })
}

fn decode(path: &Path, bytes: &[u8]) -> Result<DynamicImage, MediaError> {
    let not_a_picture = |words: String| MediaError::NotA {
        path: path.to_owned(),
        what: "picture",
        words,
    };
    let reader = || {
        ImageReader::new(Cursor::new(bytes))
            .with_guessed_format()
            .map_err(|error| not_a_picture(error.to_string()))
    };
    if reader()?.format().is_none() {
        return Err(not_a_picture(
            "its beginning is that of no known form".to_owned(),
        ));
    }
    // The header is read alone first, so that nothing is allocated for what it only claims.
    let (width, height) = reader()?
        .into_dimensions()
        .map_err(|error| not_a_picture(error.to_string()))?;
    if width.max(height) > MAX_SIDE || width.min(height) == 0 {
        return Err(MediaError::TooLarge {
            path: path.to_owned(),
            size: [width, height, 1],
            limit: MAX_SIDE,
        });
    }
    let mut reader = reader()?;
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_MEMORY);
    reader.limits(limits);
    reader.decode().map_err(|error| match error {
        image::ImageError::Limits(_) => not_a_picture(format!(
            "decoding it takes more than {} MiB",
            MAX_MEMORY >> 20
        )),
        error => not_a_picture(error.to_string()),
    })
}

/// Puts the six faces of a cubemap one behind the other.
pub(super) fn faces(paths: &[PathBuf], faces: Vec<Texels>) -> Result<Texels, MediaError> {
    let refuse = |at: usize, words: String| MediaError::NotA {
        path: paths[at.min(paths.len() - 1)].clone(),
        what: "cubemap",
        words,
    };
    let [width, height, _] = faces[0].size;
    let format = faces[0].format;
    if width != height {
        return Err(refuse(
            0,
            format!("a face of {width} × {height} texels is not square"),
        ));
    }
    let mut bytes = Vec::with_capacity(6 * faces[0].bytes.len());
    for (at, face) in faces.iter().enumerate() {
        if face.size != faces[0].size || face.format != format {
            let [w, h, _] = face.size;
            return Err(refuse(
                at,
                format!("its face {at} has {w} × {h} texels, the first one {width} × {height}"),
            ));
        }
        bytes.extend_from_slice(&face.bytes);
    }
    Ok(Texels {
        size: [width, height, 6],
        format,
        bytes,
    })
}

/// Where the faces +X, −X, +Y, −Y, +Z, −Z lie in one picture, in columns and rows of faces: the horizontal cross, the vertical
/// one, whose last face stands on its head, a row, a column.
const LAYOUTS: [([u32; 2], [[u32; 2]; 6]); 4] = [
    ([4, 3], [[2, 1], [0, 1], [1, 0], [1, 2], [1, 1], [3, 1]]),
    ([3, 4], [[2, 1], [0, 1], [1, 0], [1, 2], [1, 1], [1, 3]]),
    ([6, 1], [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]]),
    ([1, 6], [[0, 0], [0, 1], [0, 2], [0, 3], [0, 4], [0, 5]]),
];

/// Cuts the six faces of a cubemap out of one picture.
pub(super) fn cut_faces(path: &Path, picture: &Texels) -> Result<Texels, MediaError> {
    let [width, height, _] = picture.size;
    let layout = LAYOUTS.iter().find(|([columns, rows], _)| {
        u64::from(width) * u64::from(*rows) == u64::from(height) * u64::from(*columns)
            && width.is_multiple_of(*columns)
    });
    let Some((columns_and_rows, places)) = layout else {
        return Err(MediaError::NotA {
            path: path.to_owned(),
            what: "cubemap",
            words: format!(
                "{width} × {height} texels are neither a cross (4:3 or 3:4) nor a strip (6:1 or 1:6)"
            ),
        });
    };
    let side = width / columns_and_rows[0];
    let stands_on_its_head = |face: usize| *columns_and_rows == [3, 4] && face == 5;
    let texel = picture.format.bytes();
    let row_bytes = side as usize * texel;
    let mut bytes = Vec::with_capacity(6 * row_bytes * side as usize);
    for (face, [column, row]) in places.iter().enumerate() {
        for y in 0..side {
            let y = if stands_on_its_head(face) {
                side - 1 - y
            } else {
                y
            };
            let start =
                ((row * side + y) as usize * width as usize + (column * side) as usize) * texel;
            let line = &picture.bytes[start..start + row_bytes];
            match stands_on_its_head(face) {
                true => line
                    .chunks(texel)
                    .rev()
                    .for_each(|texel| bytes.extend_from_slice(texel)),
                false => bytes.extend_from_slice(line),
            }
        }
    }
    Ok(Texels {
        size: [side, side, 6],
        format: picture.format,
        bytes,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture whose texels are their numbers.
    fn numbered(width: u32, height: u32) -> Texels {
        Texels {
            size: [width, height, 1],
            format: Format::R8,
            bytes: (0..(width * height) as u8).collect(),
        }
    }

    #[test]
    fn faces_are_cut_from_crosses_and_strips() {
        let cut = |width, height| {
            cut_faces(Path::new("sky.png"), &numbered(width, height)).map(|cube| cube.bytes)
        };
        assert_eq!(cut(4, 3).expect("a cross"), [6, 4, 1, 9, 5, 7]);
        assert_eq!(cut(3, 4).expect("a cross"), [5, 3, 1, 7, 4, 10]);
        assert_eq!(cut(6, 1).expect("a strip"), [0, 1, 2, 3, 4, 5]);
        assert!(
            cut(5, 4)
                .expect_err("neither")
                .to_string()
                .contains("neither a cross")
        );
        // The last face of the vertical cross stands on its head.
        assert_eq!(cut(6, 8).expect("a cross")[20..], [45, 44, 39, 38]);
    }

    #[test]
    fn a_header_that_claims_a_huge_picture_is_refused_before_anything_is_allocated() {
        let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec();
        png.extend(100_000_u32.to_be_bytes());
        png.extend(100_000_u32.to_be_bytes());
        png.extend([8, 6, 0, 0, 0]);
        png.extend(0x1f_86_19_b8_u32.to_be_bytes());
        let error = read(Path::new("huge.png"), &png, None).expect_err("too large");
        assert!(
            matches!(error, MediaError::TooLarge { .. } | MediaError::NotA { .. }),
            "{error}"
        );
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        for bytes in [&b""[..], b"hello", b"\x89PNG\r\n\x1a\n", b"GIF89a\x01\0"] {
            assert!(read(Path::new("a.png"), bytes, None).is_err());
        }
    }
}
