//! What is bound to a pass's channels.

use serde::Deserialize;
use serde_json::value::RawValue;

use super::super::site::Item;
use super::super::{BufferLetter, CHANNELS, Channel, Filter, Input, Media, Sampling, Wrap};
use super::pass::buffer_of_id;
use super::{Loose, Reader};
use crate::source::Diagnostic;

/// The site's name of what the cubemap pass draws, among the cubemaps.
const CUBE_A: &str = "4dX3Rr";

/// An entry of `inputs`, with the keys of both dialects.
#[derive(Deserialize)]
#[serde(expecting = "an object")]
struct Entry<'a> {
    id: Option<Loose>,
    #[serde(rename = "type")]
    kind: Option<Loose>,
    ctype: Option<Loose>,
    filepath: Option<Loose>,
    src: Option<Loose>,
    channel: Loose,
    #[serde(borrow)]
    sampler: Option<&'a RawValue>,
}

#[derive(Default, Deserialize)]
#[serde(expecting = "an object")]
struct Settings<'a> {
    #[serde(borrow)]
    filter: Option<&'a RawValue>,
    #[serde(borrow)]
    wrap: Option<&'a RawValue>,
    #[serde(borrow)]
    vflip: Option<&'a RawValue>,
}

/// What an entry binds; nothing where a warning says why.
#[derive(Default)]
pub(super) struct Bound {
    pub channel: Option<(usize, Channel)>,
    pub warnings: Vec<Diagnostic>,
}

/// Reads one input of a pass.
pub(super) fn channel<'a>(
    reader: &Reader<'a>,
    pass: &str,
    part: &'a str,
) -> Result<Bound, Diagnostic> {
    let entry: Entry = reader
        .parse(part)
        .map_err(|problem| problem.within(&format!("{pass}: an entry of `inputs`")))?;
    let text = |value: Option<Loose>| value.map_or_else(String::new, |value| value.0);
    let warning = |code, words: String| Diagnostic {
        pass: Some(pass.to_owned()),
        ..Diagnostic::warning(code, format!("{pass}: {words}")).at(reader.start(part))
    };
    let unbound = |words: String| {
        Ok(Bound {
            channel: None,
            warnings: vec![warning("unknown-input", words)],
        })
    };
    let Some(index) = (0..CHANNELS).find(|index| entry.channel.0 == index.to_string()) else {
        let words = format!(
            "`channel` is `{}`, but there are only 0 to 3: this input is left out",
            entry.channel.0
        );
        return unbound(words);
    };
    let kind = text(entry.kind.or(entry.ctype));
    let (id, path) = (text(entry.id), text(entry.filepath.or(entry.src)));
    let Some(input) = input(&kind, id.clone(), path) else {
        return unbound(match &*kind {
            "buffer" => format!(
                "iChannel{index} is a buffer, but its `id` `{id}` names none: it is left unbound"
            ),
            _ => format!(
                "iChannel{index} has an input of the unknown `type` `{kind}`: it is left unbound"
            ),
        });
    };
    let mut warnings = Vec::new();
    if let Some(Media::Site { id, path }) = input.media()
        && !matches!(input, Input::MusicStream(_))
        && Item::of_media(id, path).is_none_or(|item| item.kind.name() != input.name())
    {
        let words = format!(
            "iChannel{index} reads a {} with the `id` `{id}`, which the site does not have",
            input.name()
        );
        warnings.push(warning("unknown-media", words));
    }
    let settings = match entry.sampler {
        Some(sampler) => reader
            .parse(sampler.get())
            .map_err(|problem| problem.within(&format!("{pass}: iChannel{index}: `sampler`")))?,
        None => Settings::default(),
    };
    let mut unknown = |key: &str, value: &'a RawValue, read_as: &str| {
        let words = format!(
            "{pass}: iChannel{index} has the unknown `{key}` {}, which is read as {read_as}",
            shortened(value.get())
        );
        warnings.push(Diagnostic {
            pass: Some(pass.to_owned()),
            ..Diagnostic::warning("unknown-sampler", words).at(reader.start(value.get()))
        });
    };
    let sampling = sampling(reader, &input, &settings, &mut unknown)
        .map_err(|problem| problem.within(&format!("{pass}: iChannel{index}: `sampler`")))?;
    Ok(Bound {
        channel: Some((index, Channel { input, sampling })),
        warnings,
    })
}

/// As much of a value as a message has room for.
fn shortened(value: &str) -> String {
    const ROOM: usize = 40;
    match value.char_indices().nth(ROOM) {
        Some((end, _)) => format!("`{}…`", &value[..end]),
        None => format!("`{value}`"),
    }
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
fn sampling<'a>(
    reader: &Reader<'a>,
    input: &Input,
    settings: &Settings<'a>,
    unknown: &mut dyn FnMut(&str, &'a RawValue, &str),
) -> Result<Sampling, Diagnostic> {
    let mut sampling = Sampling::usual(input);
    // The site reads the keyboard like this whatever the JSON says.
    if *input == Input::Keyboard {
        return Ok(sampling);
    }
    if let Some(value) = settings.filter {
        sampling.filter = match &*reader.parse::<Loose>(value.get())?.0 {
            "mipmap" => Filter::Mipmap,
            "linear" => Filter::Linear,
            "nearest" => Filter::Nearest,
            _ => {
                unknown("filter", value, "`nearest`");
                Filter::Nearest
            }
        };
    }
    if let Some(value) = settings.wrap {
        sampling.wrap = match &*reader.parse::<Loose>(value.get())?.0 {
            "clamp" => Wrap::Clamp,
            "repeat" => Wrap::Repeat,
            _ => {
                unknown("wrap", value, "`repeat`");
                Wrap::Repeat
            }
        };
    }
    if let Some(value) = settings.vflip {
        sampling.vflip = match &*reader.parse::<Loose>(value.get())?.0 {
            "true" => true,
            "false" => false,
            _ => {
                unknown("vflip", value, "`false`");
                false
            }
        };
    }
    Ok(sampling)
}
