//! The site's JSON, taken apart into the files of a scene folder.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::value::RawValue;

use super::object::{Object, list, raw};
use super::{FILE_KEY, SIDECAR, canonical, known_item, site_input};
use crate::scene::folder::{MANIFEST, file_of};
use crate::scene::json::{self, Parsed, Tab};
use crate::scene::load::{self, Failure, LoadError, Loading};
use crate::scene::{BufferLetter, Channel, Input, Media, PassKind, Sampling, Source};
use crate::source::{Diagnostic, FileId, Report};

/// The files of a scene folder.
#[derive(Clone, Debug)]
pub struct Imported {
    /// Names and contents.
    pub files: Vec<(String, Vec<u8>)>,
    /// What the author should know.
    pub warnings: Report,
}

/// Takes a shader in ShaderToy's JSON apart into the files of a scene folder.
pub fn import(source: &Source) -> Result<Imported, LoadError> {
    let (files, loading) = load::attempt(source, |loading| {
        let file = match source {
            Source::Path(path) => loading.read(path)?,
            Source::Text { name, bytes } => loading.accept(name, bytes)?,
            Source::Embedded => loading.read(Path::new(MANIFEST))?,
        };
        take_apart(loading, file)
    })?;
    Ok(Imported {
        files,
        warnings: Report {
            files: loading.files,
            diagnostics: loading.warnings,
        },
    })
}

/// The most passes that are taken apart. The site's shaders have up to 11.
const MAX_PASSES: usize = 100;

fn take_apart(loading: &mut Loading, file: FileId) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let text = loading.files.get(file).text.clone();
    if !json::is_json(&text) {
        let message = "only a shader in ShaderToy's JSON can be imported";
        return Err(Diagnostic::error("json", message)
            .at(loading.files.whole(file))
            .hint("a text of GLSL is a scene already; name a file that the site exported")
            .into());
    }
    let shader = json::read(file, &text, &mut loading.warnings)?;
    let tabs = shader.tabs;
    let parsed = serde_json::from_str::<Object>(shader.object).ok();
    let passes = parsed
        .as_ref()
        .and_then(|object| list(object.get("renderpass")));
    let (Some(mut object), Some(passes)) = (parsed, passes) else {
        // What was read as a shader is an object with passes.
        let message = "the shader is no object with a list of passes";
        return Err(Diagnostic::error("json", message)
            .at(loading.files.whole(file))
            .into());
    };
    if tabs.len() > MAX_PASSES {
        let message = format!("the shader has more than {MAX_PASSES} passes");
        return Err(Diagnostic::error("json", message)
            .at(loading.files.whole(file))
            .hint("each would become a file")
            .into());
    }
    let names = file_names(&tabs);
    let mut files = Vec::new();
    let mut entries = Vec::new();
    for ((tab, pass), name) in tabs.iter().zip(&passes).zip(&names) {
        let mut entry: Object = serde_json::from_str(pass.get()).unwrap_or_default();
        entry.replace("code", FILE_KEY, name);
        site_input::in_exports_dialect(&mut entry, tab.kind, &tab.channels);
        entries.push(raw(&entry));
        files.push((name.clone(), tab.code.clone().into_bytes()));
    }
    object.set("renderpass", &entries);
    let manifest = manifest(&object, &tabs, &names);
    files.push((MANIFEST.to_owned(), manifest.into_bytes()));
    files.push((SIDECAR.to_owned(), in_lines(&object, &entries).into_bytes()));
    Ok(files)
}

/// A file for each pass. Of several passes of a kind, the last has the customary name: it is the one that counts.
fn file_names(tabs: &[Parsed]) -> Vec<String> {
    let mut names = Vec::new();
    for (index, tab) in tabs.iter().enumerate() {
        let before = tabs[..index]
            .iter()
            .filter(|other| other.kind == tab.kind)
            .count();
        let behind = tabs[index + 1..]
            .iter()
            .filter(|other| other.kind == tab.kind)
            .count();
        let (name, number) = match tab.kind {
            Tab::Common => ("common.glsl", before),
            Tab::Pass(kind) => (file_of(kind), behind),
        };
        names.push(match number {
            0 => name.to_owned(),
            _ => format!("{}_{}.glsl", name.trim_end_matches(".glsl"), number + 1),
        });
    }
    names
}

/// The object with a pass a line, so that changes can be seen.
fn in_lines(object: &Object, passes: &[Box<RawValue>]) -> String {
    let mut text = String::from("{\n");
    for (index, (key, value)) in object.0.iter().enumerate() {
        let comma = if index + 1 < object.0.len() { "," } else { "" };
        let key = raw(key);
        if key.get() == "\"renderpass\"" {
            let passes: Vec<&str> = passes.iter().map(|pass| pass.get()).collect();
            let passes = passes.join(",\n    ");
            text += &format!("  {}: [\n    {passes}\n  ]{comma}\n", key.get());
        } else {
            text += &format!("  {}: {}{comma}\n", key.get(), value.get());
        }
    }
    text + "}\n"
}

fn manifest(object: &Object, tabs: &[Parsed], names: &[String]) -> String {
    let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
    let info = object.get("info");
    let info: Object = info
        .and_then(|info| serde_json::from_str(info.get()).ok())
        .unwrap_or_default();
    let mut text = String::new();
    for key in ["name", "description"] {
        if let Some(value) = info.text(key).filter(|value| !value.trim().is_empty()) {
            writeln!(text, "{key} = {}", quoted(&value)).expect("strings take all text");
        }
    }
    let all = || tabs.iter().zip(names);
    let commons = all().filter(|(tab, _)| tab.kind == Tab::Common);
    let commons: Vec<String> = commons.map(|(_, name)| quoted(name)).collect();
    if !commons.is_empty() {
        writeln!(text, "common = [{}]", commons.join(", ")).expect("strings take all text");
    }
    // The one of each kind that counts.
    let passes: Vec<(PassKind, &Parsed, &String)> = all()
        .filter_map(|(tab, name)| match tab.kind {
            Tab::Pass(kind) if name == file_of(kind) => Some((kind, tab, name)),
            _ => None,
        })
        .collect();
    let letters = passes
        .iter()
        .filter_map(|(kind, ..)| site_input::letter(*kind));
    let order: Vec<BufferLetter> = letters.collect();
    if !order.is_sorted() {
        let order = order.iter().map(|letter| quoted(&letter.pass_name()[7..]));
        let order: Vec<String> = order.collect();
        writeln!(text, "order = [{}]", order.join(", ")).expect("strings take all text");
    }
    for (kind, tab, name) in passes {
        let table = file_of(kind).trim_end_matches(".glsl");
        let gap = if text.is_empty() { "" } else { "\n" };
        write!(text, "{gap}[{table}]\nsource = {}\n", quoted(name)).expect("strings take all text");
        for (index, channel) in tab.channels.iter().enumerate() {
            if let Some(channel) = channel {
                let entry = channel_entry(&canonical(channel.clone()), quoted);
                writeln!(text, "iChannel{index} = {entry}").expect("strings take all text");
            }
        }
    }
    text
}

/// A channel in a manifest, with the settings that are not the usual ones.
fn channel_entry(channel: &Channel, quoted: impl Fn(&str) -> String) -> String {
    let media = |media: &Media| match (known_item(&channel.input), media) {
        (Some(item), _) => quoted(item.name),
        (None, Media::Site { id, path }) => {
            format!("{{ id = {}, path = {} }}", quoted(id), quoted(path))
        }
        (None, Media::Files(_)) => quoted(""),
    };
    let mut text = match &channel.input {
        Input::Noise => "{ procedural = \"noise\"".to_owned(),
        Input::Buffer(letter) => format!("{{ buffer = \"{}\"", &letter.pass_name()[7..]),
        Input::CubeBuffer => "{ cube = true".to_owned(),
        Input::Keyboard | Input::Mic | Input::Webcam => {
            format!("{{ {} = true", channel.input.name())
        }
        Input::Texture(name)
        | Input::Cubemap(name)
        | Input::Volume(name)
        | Input::Music(name)
        | Input::MusicStream(name)
        | Input::Video(name) => format!("{{ {} = {}", channel.input.name(), media(name)),
    };
    let (own, usual) = (channel.sampling, Sampling::usual(&channel.input));
    if own.filter != usual.filter {
        text += &format!(", filter = \"{}\"", own.filter.name());
    }
    if own.wrap != usual.wrap {
        text += &format!(", wrap = \"{}\"", own.wrap.name());
    }
    if own.vflip != usual.vflip {
        text += &format!(", vflip = {}", own.vflip);
    }
    text + " }"
}
