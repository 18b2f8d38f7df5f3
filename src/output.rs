//! Files that appear whole or not at all: pictures and sounds.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder as _};
use tempfile::NamedTempFile;

use crate::frame::FrameImage;

mod sound;

pub use sound::{Samples, WavSink};

/// Writes PNG files that appear whole or not at all.
#[derive(Debug, Default)]
pub struct PngSink {
    /// The encoded file; kept for its memory.
    encoded: Vec<u8>,
}

/// Why a picture or a sound is not on disk.
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

/// An EXR file with named channels of 32-bit floats, top row first, compressed without loss.
#[cfg(feature = "gpu")]
pub fn exr(size: glam::UVec2, channels: Vec<(String, Vec<f32>)>) -> io::Result<Vec<u8>> {
    use exr::prelude::WritableImage as _;
    use exr::prelude::{
        AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes,
    };
    let channels = channels
        .into_iter()
        .map(|(name, values)| AnyChannel::new(name.as_str(), FlatSamples::F32(values)));
    let layer = Layer::new(
        (size.x as usize, size.y as usize),
        LayerAttributes::default(),
        Encoding::SMALL_FAST_LOSSLESS,
        AnyChannels::sort(channels.collect()),
    );
    let mut bytes = io::Cursor::new(Vec::new());
    (Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut bytes))
    .map_err(io::Error::other)?;
    Ok(bytes.into_inner())
}

/// Writes a folder of files, which appears whole or not at all. One that is there and holds something is refused, but
/// with `overwrite`: then these files are written into it, all of them before the first takes its place, and others stay.
pub fn folder(path: &Path, files: &[(String, Vec<u8>)], overwrite: bool) -> io::Result<()> {
    let is_empty = match fs::read_dir(path) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) if error.kind() == io::ErrorKind::NotFound => true,
        Err(error) => return Err(error),
    };
    if !is_empty {
        return match overwrite {
            true => replace_in(path, files),
            false => Err(io::ErrorKind::DirectoryNotEmpty.into()),
        };
    }
    let parent = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    fs::create_dir_all(parent)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".vitrine-").suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o777));
    let aside = builder.tempdir_in(parent)?;
    for (name, bytes) in files {
        fs::write(aside.path().join(name), bytes)?;
    }
    // An empty folder stands in the way on some systems.
    if path.exists() {
        fs::remove_dir(path)?;
    }
    fs::rename(aside.path(), path)?;
    // It has another name now.
    let _ = aside.keep();
    Ok(())
}

fn replace_in(path: &Path, files: &[(String, Vec<u8>)]) -> io::Result<()> {
    let mut whole = Vec::new();
    for (name, bytes) in files {
        let mut builder = tempfile::Builder::new();
        builder.prefix(".vitrine-").suffix(".part");
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut file = builder.tempfile_in(path)?;
        file.write_all(bytes)?;
        whole.push((file, path.join(name)));
    }
    for (file, place) in whole {
        file.persist(place).map_err(|error| error.error)?;
    }
    Ok(())
}

/// Writes a file under another name beside its place and renames it when it is whole.
pub fn place(path: &Path, bytes: &[u8], overwrite: bool) -> io::Result<()> {
    let mut file = part(path)?;
    file.write_all(bytes)?;
    persist(file, path, overwrite)
}

/// A file under another name beside the place of `path`, which vanishes unless it is put there. The folder is created if it
/// is missing.
fn part(path: &Path) -> io::Result<NamedTempFile> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".vitrine-").suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    match builder.tempfile_in(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            fs::create_dir_all(folder)?;
            builder.tempfile_in(folder)
        }
        other => other,
    }
}

/// Gives a whole file its name.
fn persist(file: NamedTempFile, path: &Path, overwrite: bool) -> io::Result<()> {
    let placed = match overwrite {
        true => file.persist(path),
        false => file.persist_noclobber(path),
    };
    placed.map(drop).map_err(|error| error.error)
}
