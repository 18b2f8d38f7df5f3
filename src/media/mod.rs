//! What stands behind the inputs of a scene: pictures, cubemaps, volumes, sounds and films, from the user's files or from
//! stand-ins for the site's.

pub mod site;
pub mod stand_in;
mod texels;

pub use texels::{Format, Texels};
