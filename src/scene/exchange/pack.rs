//! A scene folder, put together into the site's JSON.

use std::path::{Path, PathBuf};

use serde_json::value::RawValue;

use super::object::{Object, list, raw};
use super::{FILE_KEY, SIDECAR, canonical, site_input};
use crate::scene::folder::{self, Plan, Planned, within};
use crate::scene::json::{self, Parsed, Tab};
use crate::scene::load::{self, Failure, LoadError, Loading};
use crate::scene::{BufferLetter, CHANNELS, Channel, Input, Media, PassKind, Source, Wrap};
use crate::source::{Diagnostic, FileId, Report};

/// A shader as the site exports it.
#[derive(Clone, Debug)]
pub struct Packed {
    /// The JSON, on one line.
    pub text: String,
    /// What the author should know.
    pub warnings: Report,
}

/// Puts a scene folder together into ShaderToy's JSON.
pub fn pack(folder: &Path) -> Result<Packed, LoadError> {
    let source = Source::Path(folder.to_owned());
    let (text, loading) = load::attempt(&source, |loading| put_together(loading, folder))?;
    Ok(Packed {
        text,
        warnings: Report {
            files: loading.files,
            diagnostics: loading.warnings,
        },
    })
}

/// A pass of the JSON under way.
struct Entry {
    tab: Tab,
    object: Object,
    /// The file with its text, if that is there.
    code: Option<PathBuf>,
    /// What the site knows of its channels.
    channels: [Option<Channel>; CHANNELS],
}

fn put_together(loading: &mut Loading, folder: &Path) -> Result<String, Failure> {
    let plan = folder::plan(loading, folder)?;
    refuse_what_the_site_lacks(&plan)?;
    let (mut object, entries) = kept(loading, folder, &plan.folder_name)?;
    let mut entries = with_plan(entries, &plan);
    in_order(&mut entries, &plan);
    let mut passes = Vec::new();
    for mut entry in entries {
        if let Tab::Pass(kind) = entry.tab
            && let Some(planned) = plan.passes.iter().find(|planned| planned.kind == kind)
            && entry.code.as_ref() == Some(&planned.source)
        {
            set_inputs(&mut entry, planned);
        }
        let Some(code) = &entry.code else {
            let name = entry.object.text(FILE_KEY).unwrap_or_default();
            let message = format!("there is no file `{name}`, which `{SIDECAR}` names for a pass");
            return Err(Diagnostic::error("json", message)
                .hint("its files lie in the scene folder or in a folder beside it")
                .into());
        };
        let code = loading.read_code(code)?;
        entry.object.replace(FILE_KEY, "code", code);
        passes.push(raw(&entry.object));
    }
    object.set("renderpass", passes);
    set_info(&mut object, &plan);
    Ok(raw(&object).get().to_owned() + "\n")
}

/// The site has its own media, and no others.
fn refuse_what_the_site_lacks(plan: &Plan) -> Result<(), Diagnostic> {
    let mut missing = Vec::new();
    for planned in &plan.passes {
        for (index, channel) in planned.channels.iter().enumerate() {
            let Some(Channel { input, sampling }) = channel else {
                continue;
            };
            let what = match (input, input.media()) {
                (Input::Noise, _) => "generated noise".to_owned(),
                (_, Some(media @ Media::Files(_))) => format!("`{media}`"),
                _ if sampling.wrap == Wrap::Mirror => "a mirrored wrap".to_owned(),
                _ => continue,
            };
            missing.push(format!("{what} ({}, iChannel{index})", planned.kind.name()));
        }
    }
    if missing.is_empty() {
        return Ok(());
    }
    let message = format!("the site cannot have: {}", missing.join(", "));
    Err(Diagnostic::error("not-on-site", message)
        .hint("name one of the site's media instead, as in `texture = \"RGBA Noise Medium\"`"))
}

/// What an import kept of the site's JSON: the shader without its passes, and those. Without it the shader is a new one
/// of this name.
fn kept(loading: &mut Loading, folder: &Path, name: &str) -> Result<(Object, Vec<Entry>), Failure> {
    let path = folder.join(SIDECAR);
    if !loading.is_file(&path) {
        loading.depends_on(&path);
        return Ok((new_shader(name), Vec::new()));
    }
    let file = loading.read(&path)?;
    let text = loading.files.get(file).text.clone();
    let wrong = |loading: &Loading, message: &str| {
        Diagnostic::error("json", message)
            .at(loading.files.whole(file))
            .hint("delete the file to have a new one made of scene.toml")
    };
    let object = serde_json::from_str::<Object>(&text);
    let object = object.map_err(|error| wrong(loading, &error.to_string()))?;
    let passes = list(object.get("renderpass"))
        .ok_or_else(|| wrong(loading, "`renderpass` is no list of passes"))?;
    let mut objects = Vec::new();
    let mut with_code = Vec::new();
    let mut files = Vec::new();
    for pass in &passes {
        let pass: Object =
            serde_json::from_str(pass.get()).map_err(|_| wrong(loading, "a pass is no object"))?;
        let code = pass.text(FILE_KEY);
        let code = code.ok_or_else(|| {
            wrong(
                loading,
                "a pass does not name the file of its text as `code-file`",
            )
        })?;
        // The reader of JSON wants a text; which one is no matter here.
        let mut as_read = pass.clone();
        as_read.replace(FILE_KEY, "code", "");
        with_code.push(raw(&as_read));
        objects.push(pass);
        files.push(code);
    }
    let tabs = tabs(file, &with_code).map_err(|problem| wrong(loading, &problem.message))?;
    let mut entries = Vec::new();
    for ((tab, object), name) in tabs.into_iter().zip(objects).zip(files) {
        entries.push(Entry {
            tab: tab.kind,
            object,
            code: within(loading, folder, &name, folder).ok(),
            channels: tab.channels,
        });
    }
    Ok((object, entries))
}

fn tabs(file: FileId, passes: &[Box<RawValue>]) -> Result<Vec<Parsed>, Diagnostic> {
    let mut shader = Object::default();
    shader.set("renderpass", passes);
    let text = raw(&shader);
    json::read(file, text.get(), &mut Vec::new()).map(|shader| shader.tabs)
}

/// A shader that the site has not seen.
fn new_shader(name: &str) -> Object {
    let mut info = Object::default();
    info.set("id", "");
    info.set("date", "0");
    info.set("viewed", 0);
    info.set("name", name);
    info.set("username", "");
    info.set("description", "");
    info.set("likes", 0);
    info.set("published", 0);
    info.set("flags", 0);
    info.set("usePreview", 0);
    info.set("tags", Vec::<String>::new());
    info.set("hasliked", 0);
    let mut shader = Object::default();
    shader.set("ver", "0.1");
    shader.set("info", info);
    shader.set("renderpass", Vec::<u8>::new());
    shader
}

/// Leaves away what the plan does not have, adds what is new, and gives each pass the plan's file.
fn with_plan(entries: Vec<Entry>, plan: &Plan) -> Vec<Entry> {
    let count = |tab: Tab| entries.iter().filter(|entry| entry.tab == tab).count();
    let planned = |tab: Tab| plan.passes.iter().find(|one| Tab::Pass(one.kind) == tab);
    let new = |tab: Tab, code: &Path| Entry {
        tab,
        object: site_input::new_pass(tab),
        code: Some(code.to_owned()),
        channels: Default::default(),
    };
    let commons = count(Tab::Common);
    let mut added = Vec::new();
    for path in plan.common.iter().skip(commons) {
        added.push(new(Tab::Common, path));
    }
    for one in &plan.passes {
        let tab = Tab::Pass(one.kind);
        if count(tab) == 0 {
            added.push(new(tab, &one.source));
        }
    }
    let mut common = plan.common.iter();
    let lasts: Vec<bool> = entries
        .iter()
        .enumerate()
        .map(|(index, entry)| {
            entries[index + 1..]
                .iter()
                .all(|other| other.tab != entry.tab)
        })
        .collect();
    let mut all = Vec::new();
    for (mut entry, is_last) in entries.into_iter().zip(lasts) {
        match entry.tab {
            Tab::Common => match common.next() {
                Some(path) => entry.code = Some(path.clone()),
                None => continue,
            },
            tab => match planned(tab) {
                // Of several passes of a kind, the manifest has the last.
                Some(one) if is_last => entry.code = Some(one.source.clone()),
                Some(_) => {}
                None => continue,
            },
        }
        all.push(entry);
    }
    all.extend(added);
    all
}

/// Puts the buffers in the plan's order, if it is another one.
fn in_order(entries: &mut [Entry], plan: &Plan) {
    let letters = |entries: &[Entry]| -> Vec<(usize, BufferLetter)> {
        let mut last: Vec<(usize, BufferLetter)> = Vec::new();
        for (index, entry) in entries.iter().enumerate() {
            let Tab::Pass(PassKind::Buffer(letter)) = entry.tab else {
                continue;
            };
            last.retain(|(_, other)| *other != letter);
            last.push((index, letter));
        }
        last
    };
    let wanted = plan
        .passes
        .iter()
        .filter_map(|one| site_input::letter(one.kind));
    for (place, wanted) in wanted.enumerate() {
        let now = letters(entries);
        let from = now.iter().position(|(_, letter)| *letter == wanted);
        if let Some(from) = from.filter(|&from| from != place && place < now.len()) {
            entries.swap(now[place].0, now[from].0);
        }
    }
}

/// Writes what the plan's channels read, and leaves alone what the site has already.
fn set_inputs(entry: &mut Entry, planned: &Planned) {
    let known = entry.channels.clone().map(|channel| channel.map(canonical));
    if known == planned.channels {
        return;
    }
    let inputs = list(entry.object.get("inputs")).unwrap_or_default();
    let mut written = Vec::new();
    let mut done = [false; CHANNELS];
    for input in inputs {
        let object = serde_json::from_str::<Object>(input.get()).unwrap_or_default();
        let index = object
            .text("channel")
            .and_then(|text| text.parse::<usize>().ok());
        let Some(index) = index.filter(|&index| index < CHANNELS) else {
            written.push(input);
            continue;
        };
        match (&known[index], &planned.channels[index]) {
            (old, new) if old == new => written.push(input),
            (Some(old), Some(new)) if old.input == new.input => {
                let mut object = object;
                let sampler = object.get("sampler");
                let sampler = sampler.and_then(|value| serde_json::from_str(value.get()).ok());
                let mut sampler: Object = sampler.unwrap_or_default();
                site_input::set_sampling(&mut sampler, new.sampling);
                object.set("sampler", sampler);
                written.push(raw(&object));
            }
            (_, Some(new)) if !done[index] => {
                written.extend(site_input::entry(index, new).map(|entry| raw(&entry)));
            }
            _ => {}
        }
        done[index] = true;
    }
    for (index, channel) in planned.channels.iter().enumerate() {
        if let Some(channel) = channel.as_ref().filter(|_| !done[index]) {
            written.extend(site_input::entry(index, channel).map(|entry| raw(&entry)));
        }
    }
    entry.object.set("inputs", written);
}

/// Name and description are the manifest's, where it has them.
fn set_info(object: &mut Object, plan: &Plan) {
    let info = object.get("info");
    let parsed = info.and_then(|info| serde_json::from_str::<Object>(info.get()).ok());
    let mut info = parsed.unwrap_or_default();
    let mut is_changed = false;
    for (key, value) in [("name", &plan.name), ("description", &plan.description)] {
        if let Some(value) = value
            && info.text(key).as_ref() != Some(value)
        {
            info.set(key, value);
            is_changed = true;
        }
    }
    if is_changed {
        object.set("info", info);
    }
}
