//! What the tests share: scenes, pictures, goldens, and the program itself.

mod folder;
mod glsl;
mod golden;
mod program;
mod snapshots;

#[cfg(feature = "gpu")]
mod expected;
#[cfg(feature = "gpu")]
mod gpu;
#[cfg(feature = "gpu")]
mod picture;

pub use folder::{Folder, repository, scene_folders};
pub use glsl::{Case, cases, on_every_core};
pub use golden::golden_text;
pub use program::vitrine;
pub use snapshots::{left_over, unfit_for_people};

#[cfg(feature = "web")]
pub use program::Outcome;

#[cfg(feature = "gpu")]
pub use expected::Drawing;
#[cfg(feature = "gpu")]
pub use golden::{Tolerance, golden_picture};
#[cfg(feature = "gpu")]
pub use gpu::{draw, draw_with, gpu, open, still};
#[cfg(feature = "gpu")]
pub use picture::{assert_claims, claims, differing, distances, read_png};

use vitrine::scene::Source;
use vitrine::source::Report;

/// No device: the program is built without.
#[cfg(not(feature = "gpu"))]
pub fn gpu() -> Option<()> {
    None
}

/// A text as it would be pasted.
pub fn pasted(text: &str) -> Source {
    Source::Text {
        name: "pasted".to_owned(),
        bytes: text.into(),
    }
}

/// What a report says, without the colours.
pub fn plain(report: &Report) -> String {
    let coloured = vitrine::report::human(report);
    let mut text = String::new();
    let mut rest = coloured.as_str();
    while let Some((before, code)) = rest.split_once("\u{1b}[") {
        text.push_str(before);
        rest = code.split_once('m').map_or("", |(_, behind)| behind);
    }
    text + rest
}
