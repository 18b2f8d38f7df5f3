//! Comparison with what was accepted before.

use std::fs;
use std::path::{Path, PathBuf};

use super::repository;

/// Whether this run accepts what it makes.
fn blessing() -> bool {
    std::env::var_os("BLESS").is_some_and(|value| value != "0")
}

/// Where what was made is kept for a look when it is not what was expected.
fn beside(path: &Path) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("actual");
    fs::create_dir_all(&folder).expect("a folder for what was made");
    folder.join(path.file_name().expect("a golden file has a name"))
}

/// The command that accepts what the running test makes.
fn bless_command() -> String {
    let test = std::thread::current().name().unwrap_or_default().to_owned();
    format!("BLESS=1 cargo test --test suite -- {test}")
}

/// Compares a text with the file `golden`, a path in the repository. On a difference the result says
/// what it is and how to accept it.
pub fn golden_text(golden: &str, actual: &str) -> Result<(), String> {
    let path = repository(golden);
    if blessing() {
        fs::write(&path, actual).expect("a golden text can be written");
        return Ok(());
    }
    // Git may have checked it out with the line ends of another system.
    let expected = fs::read_to_string(&path).unwrap_or_default();
    if expected.replace("\r\n", "\n") == actual {
        return Ok(());
    }
    let made = beside(&path);
    fs::write(&made, actual).expect("the actual text can be written");
    Err(format!(
        "{golden} differs.\n--- expected ---\n{expected}--- actual, {} ---\n{actual}---\n\
         If it is right: {}\n",
        made.display(),
        bless_command()
    ))
}

/// How near a picture must be to its golden one.
#[cfg(feature = "gpu")]
#[derive(Clone, Copy)]
pub struct Tolerance {
    /// A pixel counts as equal if no channel differs by more than this, of 255.
    pub levels: u8,
    /// The share of pixels that must be equal.
    pub share: f64,
}

/// Compares a picture with `tests/goldens/NAME.png`. On a difference the result says how large it is
/// and how to accept it.
#[cfg(feature = "gpu")]
pub fn golden_picture(
    name: &str,
    actual: &vitrine::frame::FrameImage,
    tolerance: Tolerance,
) -> Result<(), String> {
    let path = repository("tests/goldens").join(format!("{name}.png"));
    if blessing() {
        super::picture::write_png(&path, actual);
        return Ok(());
    }
    let verdict = match path.exists() {
        false => Err("there is no golden picture yet".to_owned()),
        true => compare(actual, &super::read_png(&path), tolerance),
    };
    verdict.map_err(|difference| {
        let made = beside(&path);
        super::picture::write_png(&made, actual);
        format!(
            "{name}: {difference}\n  golden: {}\n  actual: {}\n  if it is right: {}\n",
            path.display(),
            made.display(),
            bless_command()
        )
    })
}

#[cfg(feature = "gpu")]
fn compare(
    actual: &vitrine::frame::FrameImage,
    golden: &vitrine::frame::FrameImage,
    tolerance: Tolerance,
) -> Result<(), String> {
    if actual.size != golden.size {
        return Err(format!("it is {} instead of {}", actual.size, golden.size));
    }
    let distances = super::picture::distances(actual, golden);
    let near = distances.iter().filter(|&&d| d <= tolerance.levels).count();
    let share = near as f64 / distances.len() as f64;
    if share >= tolerance.share {
        return Ok(());
    }
    Err(format!(
        "{:.2} % of the pixels are within {}/255 of the golden picture, {:.2} % are wanted; \
         the worst is {} off",
        100.0 * share,
        tolerance.levels,
        100.0 * tolerance.share,
        distances.iter().max().unwrap_or(&0),
    ))
}
