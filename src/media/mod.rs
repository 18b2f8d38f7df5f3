//! What stands behind the inputs of a scene: pictures, cubemaps, volumes, sounds and films, from the user's files or from
//! stand-ins for the site's.

mod error;
mod feed;
pub mod film;
mod inputs;
mod library;
mod picture;
pub mod sound;
pub mod stand_in;
mod texels;
mod volume;

pub use crate::scene::site::{self, Format};
pub use error::MediaError;
pub use feed::Feed;
pub use inputs::{Content, Inputs};
pub use library::{Entry, Library, Origin, StandIns};
pub use texels::Texels;
