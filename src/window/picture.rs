//! Saves what the window shows.

use std::path::PathBuf;

use crate::frame::FrameImage;
use crate::output::PngSink;
use crate::render::{Extras, Gpu, GpuError, ReadBack, Target};

/// Writes the picture in `target` to the current folder, under a name made of the scene's and the
/// time in seconds, and returns the file's name. Existing files stay.
pub(super) fn save(gpu: &Gpu, target: &Target, name: &str, time: f32) -> Result<PathBuf, String> {
    let image = read(gpu, target).map_err(|error| error.to_string())?;
    for attempt in 1..1000 {
        let path = file_name(name, time, attempt);
        if path.exists() {
            continue;
        }
        return match PngSink::default().write(&path, &image, false) {
            Ok(()) => Ok(path),
            Err(error) => Err(error.to_string()),
        };
    }
    Err("there are a thousand pictures of this moment already".to_owned())
}

fn read(gpu: &Gpu, target: &Target) -> Result<FrameImage, GpuError> {
    let mut read_back = ReadBack::new(gpu, target, 1, Extras::default())?;
    let slot = &mut read_back.slots[0];
    slot.copy_of(gpu, target);
    while !slot.is_ready(gpu)? {}
    let mut image = FrameImage::default();
    slot.take(gpu, &mut image)?;
    Ok(image)
}

/// A name without anything that a file system or shell would trip over.
fn file_name(name: &str, time: f32, attempt: u32) -> PathBuf {
    let plain: String = name
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || c == '-' {
                c
            } else {
                '_'
            }
        })
        .take(80)
        .collect();
    let again = match attempt {
        1 => String::new(),
        n => format!("-{n}"),
    };
    format!("{plain}-{time:07.2}s{again}.png").into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_plain_and_sort_by_time() {
        let name = |name, time, attempt| file_name(name, time, attempt).display().to_string();
        assert_eq!(name("Sea & sky", 1.5, 1), "Sea___sky-0001.50s.png");
        assert_eq!(name("../x", 12.0, 2), "___x-0012.00s-2.png");
    }
}
