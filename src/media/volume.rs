//! The site's files of volumes.

use std::path::Path;

use super::{Format, MediaError, Texels};

/// The most texels each way.
const MAX_SIDE: u32 = 512;

/// Bytes before the texels: `BIN` and a zero; width, height and depth; channels, layout (both 8 bits) and format (16 bits).
const HEADER: usize = 20;

/// Reads a file in the form of the site's volumes.
pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Texels, MediaError> {
    let refuse = |words: &str| MediaError::NotA {
        path: path.to_owned(),
        what: "volume",
        words: words.to_owned(),
    };
    let header = bytes
        .get(..HEADER)
        .ok_or_else(|| refuse("it has no header of 20 bytes"))?;
    if &header[..4] != b"BIN\0" {
        return Err(refuse("it does not begin with `BIN`"));
    }
    let number = |at: usize| u32::from_le_bytes(header[at..at + 4].try_into().expect("four bytes"));
    let size = [number(4), number(8), number(12)];
    if size.contains(&0) {
        return Err(refuse("a side is 0"));
    }
    if size.iter().any(|&side| side > MAX_SIDE) {
        return Err(MediaError::TooLarge {
            path: path.to_owned(),
            size,
            limit: MAX_SIDE,
        });
    }
    let format = match (header[16], u16::from_le_bytes([header[18], header[19]])) {
        (1, 0) => Format::R8,
        (4, 0) => Format::Rgba8,
        (1, 10) => Format::R32Float,
        (4, 10) => Format::Rgba32Float,
        (channels, format) => {
            return Err(refuse(&format!(
                "it has {channels} channels in the format {format}; 1 or 4 channels in the format 0 (bytes) or 10 (floats) are known"
            )));
        }
    };
    let length = size.iter().map(|&side| side as usize).product::<usize>() * format.bytes();
    match bytes[HEADER..].get(..length) {
        Some(texels) => Ok(Texels {
            size,
            format,
            bytes: texels.to_vec(),
        }),
        None => Err(MediaError::CutShort {
            path: path.to_owned(),
            words: format!(
                "it has {} of {length} bytes of texels",
                bytes.len() - HEADER
            ),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(size: [u32; 3], channels: u8, format: u16, texels: &[u8]) -> Vec<u8> {
        let mut bytes = b"BIN\0".to_vec();
        size.iter()
            .for_each(|side| bytes.extend(side.to_le_bytes()));
        bytes.extend([channels, 0]);
        bytes.extend(format.to_le_bytes());
        bytes.extend(texels);
        bytes
    }

    #[test]
    fn a_file_of_bytes_and_one_of_floats() {
        let path = Path::new("v.bin");
        let bytes = read(path, &file([2, 1, 2], 1, 0, &[1, 2, 3, 4])).expect("a volume");
        assert_eq!(
            (bytes.size, bytes.format, &*bytes.bytes),
            ([2, 1, 2], Format::R8, &[1, 2, 3, 4][..])
        );
        let floats = read(path, &file([1, 1, 1], 4, 10, &[0; 16])).expect("a volume");
        assert_eq!(floats.format, Format::Rgba32Float);
    }

    #[test]
    fn what_is_wrong_with_a_file_is_said() {
        let words = |bytes: &[u8]| {
            read(Path::new("v.bin"), bytes)
                .expect_err("no volume")
                .to_string()
        };
        assert!(words(b"BI").contains("no header"));
        assert!(words(&[0; 40]).contains("does not begin with `BIN`"));
        assert!(words(&file([2, 2, 2], 1, 0, &[0; 7])).contains("7 of 8 bytes"));
        assert!(
            words(&file([1 << 31, 1 << 31, 1 << 31], 4, 10, &[])).contains("at most 512 a side")
        );
        assert!(words(&file([2, 0, 2], 1, 0, &[])).contains("a side is 0"));
        assert!(words(&file([1, 1, 1], 3, 0, &[0; 3])).contains("3 channels"));
    }
}
