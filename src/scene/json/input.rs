//! What is bound to a pass's channels.

use serde::Deserialize;

use super::super::{BufferLetter, CHANNELS, Channel, Filter, Input, Media, Sampling, Wrap};
use super::pass::buffer_of_id;
use super::{Loose, Reader};
use crate::source::Diagnostic;

/// The site's name of what the cubemap pass draws, among the cubemaps.
const CUBE_A: &str = "4dX3Rr";

/// An entry of `inputs`, with the keys of both dialects.
#[derive(Deserialize)]
struct Entry {
    id: Option<Loose>,
    #[serde(rename = "type")]
    kind: Option<Loose>,
    ctype: Option<Loose>,
    filepath: Option<Loose>,
    src: Option<Loose>,
    channel: Loose,
    sampler: Option<Settings>,
}

#[derive(Default, Deserialize)]
struct Settings {
    filter: Option<Loose>,
    wrap: Option<Loose>,
    vflip: Option<Loose>,
}

/// Reads one input. An inner error is a warning: the channel then stays unbound, as on the site.
pub(super) fn channel<'a>(
    reader: &Reader<'a>,
    part: &'a str,
) -> Result<Result<(usize, Channel), Diagnostic>, Diagnostic> {
    let entry: Entry = reader.parse(part)?;
    let text = |value: Option<Loose>| value.map_or_else(String::new, |value| value.0);
    let warning = |words: String| {
        Ok(Err(
            Diagnostic::warning("unknown-input", words).at(reader.start(part))
        ))
    };
    let Some(index) = (0..CHANNELS).find(|index| entry.channel.0 == index.to_string()) else {
        return warning(format!(
            "there is no channel `{}`: this input is left out",
            entry.channel.0
        ));
    };
    let kind = text(entry.kind.or(entry.ctype));
    let (id, path) = (text(entry.id), text(entry.filepath.or(entry.src)));
    let Some(input) = input(&kind, id, path) else {
        return warning(format!(
            "iChannel{index} has an input of the unknown type `{kind}`: it is left unbound"
        ));
    };
    let sampling = sampling(&input, &entry.sampler.unwrap_or_default());
    Ok(Ok((index, Channel { input, sampling })))
}

fn input(kind: &str, id: String, path: String) -> Option<Input> {
    let is_cube_a = id == CUBE_A || path.contains("cubemap00");
    // Names are no help: authors change them.
    let buffer = || buffer_of_id(&id).or_else(|| buffer_of_path(&path));
    Some(match kind {
        "buffer" => Input::Buffer(buffer()?),
        "cubemap" if is_cube_a => Input::CubeBuffer,
        "keyboard" => Input::Keyboard,
        "mic" => Input::Mic,
        "webcam" => Input::Webcam,
        _ => file(kind, Media::Site { id, path })?,
    })
}

/// An input whose texels or sounds lie in a file.
fn file(kind: &str, media: Media) -> Option<Input> {
    Some(match kind {
        "texture" => Input::Texture(media),
        "cubemap" => Input::Cubemap(media),
        "volume" => Input::Volume(media),
        "music" => Input::Music(media),
        "musicstream" => Input::MusicStream(media),
        "video" => Input::Video(media),
        _ => return None,
    })
}

fn buffer_of_path(path: &str) -> Option<BufferLetter> {
    let (_, number) = path.rsplit_once("buffer0")?;
    let at = ["0", "1", "2", "3"]
        .iter()
        .position(|digit| number.starts_with(digit))?;
    Some(BufferLetter::ALL[at])
}

/// What is not said has the site's default for a new input of that kind; what is said has the
/// meaning that the site's own code gives it.
fn sampling(input: &Input, settings: &Settings) -> Sampling {
    let (filter, wrap, vflip) = match input {
        // The site reads the keyboard like this whatever the JSON says.
        Input::Keyboard => {
            return Sampling {
                filter: Filter::Nearest,
                wrap: Wrap::Clamp,
                vflip: true,
            };
        }
        Input::Noise | Input::Texture(_) | Input::Volume(_) => (Filter::Mipmap, Wrap::Repeat, true),
        Input::Cubemap(_) | Input::CubeBuffer => (Filter::Mipmap, Wrap::Clamp, false),
        _ => (Filter::Linear, Wrap::Clamp, true),
    };
    let said = |value: &Option<Loose>| value.as_ref().map(|value| value.0.clone());
    Sampling {
        filter: match said(&settings.filter).as_deref() {
            None => filter,
            Some("mipmap") => Filter::Mipmap,
            Some("linear") => Filter::Linear,
            Some(_) => Filter::Nearest,
        },
        wrap: match said(&settings.wrap).as_deref() {
            None => wrap,
            Some("clamp") => Wrap::Clamp,
            Some(_) => Wrap::Repeat,
        },
        vflip: said(&settings.vflip).map_or(vflip, |value| value == "true"),
    }
}
