//! The passes of a shader: which tab each is, and its text.

use serde::Deserialize;
use serde_json::value::RawValue;

use super::super::{BufferLetter, CHANNELS, Channel, Input, PassKind, Wrap, missing_pass};
use super::{Loose, Reader, input, problem};
use crate::source::Diagnostic;

/// What an entry of `renderpass` is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::scene) enum Tab {
    /// Text that every pass begins with.
    Common,
    Pass(PassKind),
}

impl Tab {
    pub fn name(self) -> &'static str {
        match self {
            Tab::Common => "Common",
            Tab::Pass(kind) => kind.name(),
        }
    }
}

/// An entry of `renderpass`.
pub(in crate::scene) struct Parsed {
    pub kind: Tab,
    pub code: String,
    pub channels: [Option<Channel>; CHANNELS],
}

#[derive(Deserialize)]
#[serde(expecting = "an object")]
struct RenderPass<'a> {
    #[serde(rename = "type")]
    kind: Loose,
    name: Option<Loose>,
    code: String,
    #[serde(borrow)]
    inputs: Option<Vec<&'a RawValue>>,
    /// Old entries have all sorts of things here.
    #[serde(borrow)]
    outputs: Option<&'a RawValue>,
}

#[derive(Deserialize)]
struct Output {
    id: Loose,
}

/// Reads all entries, in the file's order.
pub(super) fn tabs<'a>(
    reader: &Reader<'a>,
    entries: &[&'a RawValue],
    warnings: &mut Vec<Diagnostic>,
) -> Result<Vec<Parsed>, Diagnostic> {
    let mut passes = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let pass = reader.parse::<RenderPass>(entry.get());
        let place = || format!("entry {} of `renderpass`", index + 1);
        passes.push(pass.map_err(|problem| problem.within(&place()))?);
    }
    let letters = letters(reader, entries, &passes)?;
    let (mut tabs, mut reads) = (Vec::new(), Vec::new());
    for ((pass, entry), letter) in passes.into_iter().zip(entries).zip(letters) {
        let kind = match (&*pass.kind.0, letter) {
            ("common", _) => Tab::Common,
            ("image", _) => Tab::Pass(PassKind::Image),
            ("cubemap", _) => Tab::Pass(PassKind::Cube),
            ("sound", _) => Tab::Pass(PassKind::Sound),
            ("buffer", Some(letter)) => Tab::Pass(PassKind::Buffer(letter)),
            (other, _) => {
                return Err(problem(format!("a pass has the unknown type `{other}`"))
                    .at(reader.start(entry.get()))
                    .hint("passes are of type image, buffer, cubemap, sound or common"));
            }
        };
        let mut channels = [const { None }; CHANNELS];
        for part in pass.inputs.iter().flatten() {
            let bound = input::channel(reader, kind.name(), part.get())?;
            warnings.extend(bound.warnings);
            // Of two inputs on one channel, the site binds the later.
            if let Some((index, channel)) = bound.channel {
                reads.push((kind, index, channel.clone(), part.get()));
                channels[index] = Some(channel);
            }
        }
        tabs.push(Parsed {
            kind,
            code: pass.code,
            channels,
        });
    }
    let mut drawn: Vec<PassKind> = Vec::new();
    for tab in &tabs {
        match tab.kind {
            Tab::Pass(kind) if !drawn.contains(&kind) => drawn.push(kind),
            _ => {}
        }
    }
    let is_there = |kind| drawn.contains(&kind);
    for (tab, index, channel, part) in &reads {
        let Tab::Pass(kind) = *tab else { continue };
        let missing = missing_pass(kind, *index, &channel.input, is_there);
        warnings.extend(missing.map(|found| found.at(reader.start(part))));
    }
    for (tab, index, channel, part) in &reads {
        let wrap = wrap_on_site(
            &channel.input,
            reads.iter().map(|(_, _, channel, _)| channel),
        );
        let Some(wrap) = wrap.filter(|wrap| *wrap != channel.sampling.wrap) else {
            continue;
        };
        let message = format!(
            "{}: iChannel{index} reads {} with the wrap `{}`, but on the site a buffer has one wrap, and the last \
             input that reads it says `{}`: it is read so",
            tab.name(),
            channel.input.name(),
            channel.sampling.wrap.name(),
            wrap.name()
        );
        warnings.push(Diagnostic {
            pass: Some(tab.name().to_owned()),
            ..Diagnostic::warning("shared-wrap", message).at(reader.start(part))
        });
    }
    let channels = tabs.iter_mut().flat_map(|tab| &mut tab.channels);
    for channel in channels.flatten() {
        let wrap = wrap_on_site(
            &channel.input,
            reads.iter().map(|(_, _, channel, _)| channel),
        );
        channel.sampling.wrap = wrap.unwrap_or(channel.sampling.wrap);
    }
    Ok(tabs)
}

/// The wrap of a buffer, which the site keeps with the buffer: each input that is loaded sets it, so that the last one
/// decides for all. `None` for what is no buffer.
fn wrap_on_site<'a>(input: &Input, loaded: impl Iterator<Item = &'a Channel>) -> Option<Wrap> {
    if !matches!(input, Input::Buffer(_)) {
        return None;
    }
    let readers = loaded.filter(|channel| channel.input == *input);
    readers.last().map(|channel| channel.sampling.wrap)
}

/// Which buffer each pass of type `buffer` is: what its output says, else its name, else the first
/// letter that is left.
fn letters(
    reader: &Reader<'_>,
    entries: &[&RawValue],
    passes: &[RenderPass<'_>],
) -> Result<Vec<Option<BufferLetter>>, Diagnostic> {
    let is_buffer = |pass: &RenderPass<'_>| pass.kind.0 == "buffer";
    let mut letters: Vec<_> = passes
        .iter()
        .map(|pass| is_buffer(pass).then(|| named(pass)).flatten())
        .collect();
    for (index, pass) in passes.iter().enumerate() {
        if is_buffer(pass) && letters[index].is_none() {
            let mut all = BufferLetter::ALL.into_iter();
            let free = all.find(|&letter| !letters.contains(&Some(letter)));
            letters[index] = Some(free.ok_or_else(|| {
                problem("there are more buffers than four, and this one does not say which it is")
                    .at(reader.start(entries[index].get()))
            })?);
        }
    }
    Ok(letters)
}

fn named(pass: &RenderPass<'_>) -> Option<BufferLetter> {
    let from_output = pass
        .outputs
        .and_then(output_id)
        .and_then(|id| buffer_of_id(&id));
    from_output.or_else(|| {
        let name = &pass.name.as_ref()?.0;
        let letter = name.strip_prefix("Buf")?.trim_start_matches("fer");
        let at = ["A", "B", "C", "D"]
            .iter()
            .position(|l| *l == letter.trim());
        Some(BufferLetter::ALL[at?])
    })
}

/// The id of a pass's first output. The dialects write a list of objects, older files plain values.
fn output_id(outputs: &RawValue) -> Option<String> {
    let first = match serde_json::from_str::<Vec<&RawValue>>(outputs.get()) {
        Ok(list) => list.first()?.get(),
        Err(_) => outputs.get(),
    };
    let id = serde_json::from_str::<Output>(first).map(|output| output.id);
    let id = id.or_else(|_| serde_json::from_str::<Loose>(first));
    id.ok().map(|id| id.0)
}

/// The buffer that an id stands for: the site's own, or the public interface's number.
pub(super) fn buffer_of_id(id: &str) -> Option<BufferLetter> {
    let at = match id {
        "4dXGR8" | "257" => 0,
        "XsXGR8" | "258" => 1,
        "4sXGR8" | "259" => 2,
        "XdfGR8" | "260" => 3,
        _ => return None,
    };
    Some(BufferLetter::ALL[at])
}
