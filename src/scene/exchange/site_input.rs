//! Inputs and outputs as the site writes them.

use serde_json::value::RawValue;

use super::object::{Object, list, raw, text};
use crate::scene::json::Tab;
use crate::scene::{BufferLetter, Channel, Input, Media, PassKind, Sampling};

/// The site's ids and pictures of the four buffers.
const BUFFERS: [(&str, &str); 4] = [
    ("4dXGR8", "/media/previz/buffer00.png"),
    ("XsXGR8", "/media/previz/buffer01.png"),
    ("4sXGR8", "/media/previz/buffer02.png"),
    ("XdfGR8", "/media/previz/buffer03.png"),
];

const CUBE_A: (&str, &str) = ("4dX3Rr", "/media/previz/cubemap00.png");
const KEYBOARD: (&str, &str) = ("4dXGRr", "/presets/tex00.jpg");
const MIC: (&str, &str) = ("XdXGRr", "/presets/mic.png");
const WEBCAM: (&str, &str) = ("4sf3zn", "/presets/webcam.png");
const SCREEN: &str = "4dfGRr";
const SOUND: &str = "XsfGRr";

/// Id and path of an input, if the site has such a thing.
fn reference(input: &Input) -> Option<(String, String)> {
    let (id, path) = match input {
        Input::Buffer(letter) => BUFFERS[letter.index()],
        Input::CubeBuffer => CUBE_A,
        Input::Keyboard => KEYBOARD,
        Input::Mic => MIC,
        Input::Webcam => WEBCAM,
        _ => match input.media()? {
            Media::Site { id, path } => return Some((id.clone(), path.clone())),
            Media::Files(_) => return None,
        },
    };
    Some((id.to_owned(), path.to_owned()))
}

/// The site's word for a kind of input.
fn kind(input: &Input) -> &'static str {
    match input {
        Input::Buffer(_) => "buffer",
        Input::CubeBuffer => "cubemap",
        other => other.name(),
    }
}

/// An entry of `inputs`; `None` for what the site cannot have.
pub(super) fn entry(index: usize, channel: &Channel) -> Option<Object> {
    let (id, path) = reference(&channel.input)?;
    let mut entry = Object::default();
    entry.set("id", id);
    entry.set("filepath", &path);
    entry.set(
        "previewfilepath",
        path.replacen("/media/a/", "/media/ap/", 1),
    );
    entry.set("type", kind(&channel.input));
    entry.set("channel", index);
    let mut sampler = Object::default();
    set_sampling(&mut sampler, channel.sampling);
    sampler.set("srgb", "false");
    sampler.set("internal", "byte");
    entry.set("sampler", sampler);
    entry.set("published", 1);
    Some(entry)
}

/// Writes how a channel is read into a `sampler`, and leaves its other keys alone.
pub(super) fn set_sampling(sampler: &mut Object, sampling: Sampling) {
    sampler.set("filter", sampling.filter.name());
    sampler.set("wrap", sampling.wrap.name());
    sampler.set("vflip", if sampling.vflip { "true" } else { "false" });
}

/// Name, type and outputs of a pass that the site has not seen.
pub(super) fn new_pass(tab: Tab) -> Object {
    let (ty, output) = match tab {
        Tab::Common => ("common", None),
        Tab::Pass(PassKind::Image) => ("image", Some(SCREEN)),
        Tab::Pass(PassKind::Buffer(letter)) => ("buffer", Some(BUFFERS[letter.index()].0)),
        Tab::Pass(PassKind::Cube) => ("cubemap", Some(CUBE_A.0)),
        Tab::Pass(PassKind::Sound) => ("sound", Some(SOUND)),
    };
    let mut pass = Object::default();
    pass.set("inputs", Vec::<u8>::new());
    let outputs: Vec<Object> = output.into_iter().map(output_entry).collect();
    pass.set("outputs", outputs);
    pass.set(super::FILE_KEY, "");
    pass.set("name", tab.name());
    pass.set("description", "");
    pass.set("type", ty);
    pass
}

fn output_entry(id: &str) -> Object {
    let mut entry = Object::default();
    entry.set("id", id);
    entry.set("channel", 0);
    entry
}

/// Writes a pass of the public interface as the site exports it: other keys, and ids that are text. What is written
/// like that already stays as it is.
pub(super) fn in_exports_dialect(pass: &mut Object, tab: Tab, channels: &[Option<Channel>]) {
    if let Some(inputs) = list(pass.get("inputs")) {
        let inputs = inputs.iter().map(|input| export_input(input, channels));
        pass.set("inputs", inputs.collect::<Vec<_>>());
    }
    if let Some(outputs) = list(pass.get("outputs")) {
        let outputs = outputs.iter().map(|output| export_output(output, tab));
        pass.set("outputs", outputs.collect::<Vec<_>>());
    }
}

fn export_input(input: &RawValue, channels: &[Option<Channel>]) -> Box<RawValue> {
    let Ok(mut entry) = serde_json::from_str::<Object>(input.get()) else {
        return input.to_owned();
    };
    let is_number = entry.get("id").is_some_and(is_number);
    if !is_number && entry.get("ctype").is_none() && entry.get("src").is_none() {
        return input.to_owned();
    }
    entry.rename("ctype", "type");
    entry.rename("src", "filepath");
    if is_number {
        let channel = entry.text("channel").and_then(|text| text.parse().ok());
        let channel = channel.and_then(|index: usize| channels.get(index)?.clone());
        let known = channel.map(super::canonical).filter(|channel| {
            // Of two inputs on one channel, the other may be meant.
            entry.text("type").as_deref() == Some(kind(&channel.input))
        });
        let id = known.and_then(|channel| reference(&channel.input));
        let own = entry.text("id").unwrap_or_default();
        entry.set("id", id.map_or(own, |(id, _)| id));
    }
    raw(&entry)
}

fn export_output(output: &RawValue, tab: Tab) -> Box<RawValue> {
    let Ok(mut entry) = serde_json::from_str::<Object>(output.get()) else {
        return output.to_owned();
    };
    if !entry.get("id").is_some_and(is_number) {
        return output.to_owned();
    }
    let of_pass = new_pass(tab);
    let first = list(of_pass.get("outputs")).and_then(|outputs| outputs.into_iter().next());
    let first = first.and_then(|first| serde_json::from_str::<Object>(first.get()).ok());
    let id = first.and_then(|first| first.text("id"));
    let own = entry.get("id").and_then(text).unwrap_or_default();
    entry.set("id", id.unwrap_or(own));
    raw(&entry)
}

fn is_number(value: &RawValue) -> bool {
    value
        .get()
        .starts_with(|c: char| c.is_ascii_digit() || c == '-')
}

/// The buffers, in the order of their letters.
pub(super) fn letter(kind: PassKind) -> Option<BufferLetter> {
    match kind {
        PassKind::Buffer(letter) => Some(letter),
        _ => None,
    }
}
