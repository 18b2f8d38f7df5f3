//! Files that appear whole or not at all.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder as _};

use crate::frame::FrameImage;

/// Writes PNG files that appear whole or not at all.
#[derive(Debug, Default)]
pub struct PngSink {
    /// The encoded file; kept for its memory.
    encoded: Vec<u8>,
}

/// Why a picture is not on disk.
#[derive(Debug, thiserror::Error)]
#[error("cannot write `{}`: {error}", path.display())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// What the system said.
    pub error: io::Error,
}

impl PngSink {
    /// Writes one picture, creating the folder if it is missing. A file that is already there is
    /// replaced only with `overwrite`.
    pub fn write(
        &mut self,
        path: &Path,
        image: &FrameImage,
        overwrite: bool,
    ) -> Result<(), WriteError> {
        self.encode(image)
            .and_then(|()| place(path, &self.encoded, overwrite))
            .map_err(|error| WriteError {
                path: path.to_owned(),
                error,
            })
    }

    fn encode(&mut self, image: &FrameImage) -> io::Result<()> {
        self.encoded.clear();
        PngEncoder::new_with_quality(&mut self.encoded, CompressionType::Fast, FilterType::Up)
            .write_image(
                &image.rgb,
                image.size.x,
                image.size.y,
                ExtendedColorType::Rgb8,
            )
            .map_err(io::Error::other)
    }
}

/// Writes a file under another name beside its place and renames it when it is whole.
pub fn place(path: &Path, bytes: &[u8], overwrite: bool) -> io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".vitrine-").suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = match builder.tempfile_in(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            fs::create_dir_all(folder)?;
            builder.tempfile_in(folder)?
        }
        other => other?,
    };
    file.write_all(bytes)?;
    let placed = match overwrite {
        true => file.persist(path),
        false => file.persist_noclobber(path),
    };
    placed.map(drop).map_err(|error| error.error)
}
