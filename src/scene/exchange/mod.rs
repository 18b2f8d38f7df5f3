//! Scene folders of the site's JSON, and the site's JSON of scene folders.
//!
//! A folder has the passes' texts as files and `scene.toml` for what a person changes. What else the site keeps of a
//! shader lies beside them in [`SIDECAR`]: the shader's own JSON, in which each pass names its file instead of having
//! its text. So nothing is lost on the way to a folder and back, not even keys that nobody knows.

mod import;
mod object;
mod pack;
mod site_input;

pub use import::{Imported, import};
pub use pack::{Packed, pack};

use super::site::Item;
use super::{Channel, Input, Media};

/// The file of a scene folder with what the site keeps of a shader beside texts and channels.
pub const SIDECAR: &str = "shadertoy.json";

/// The key of a pass in [`SIDECAR`] that names the file with its text.
const FILE_KEY: &str = "code-file";

/// A channel as a manifest would have it, which names the site's media by their entry in the list.
fn canonical(mut channel: Channel) -> Channel {
    if let Some(item) = known_item(&channel.input) {
        let (Input::Texture(media)
        | Input::Cubemap(media)
        | Input::Volume(media)
        | Input::Music(media)
        | Input::Video(media)) = &mut channel.input
        else {
            return channel;
        };
        *media = item.media();
    }
    channel
}

/// The site's item behind an input.
fn known_item(input: &Input) -> Option<&'static Item> {
    let Media::Site { id, path } = input.media()? else {
        return None;
    };
    Item::of_media(id, path).filter(|item| item.kind.name() == input.name())
}
