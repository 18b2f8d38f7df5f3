//! ShaderToy's own JSON, in both dialects: what the site exports and keeps, and what its public
//! interface answers.
//!
//! The text is read in layers: each object's parts stay [`RawValue`]s, pieces of the text, until it is
//! their turn. So whatever is wrong with a part can be pointed at, and keys that do not matter here
//! may hold anything.

mod input;
mod pass;

use serde::Deserialize;
use serde_json::value::RawValue;

use super::load::{Failure, Loading, Parts};
use super::{Pass, PassKind};
use crate::source::{Diagnostic, FileId, SourceMap, Span};
pub(super) use pass::{Parsed, Tab};

/// How many lists and objects may stand around a shader: real files have one or two.
const MAX_WRAPPERS: usize = 4;

/// The most names of shaders that one message lists.
const MAX_NAMES: usize = 20;

/// What an object may be: a shader, something around shaders, or the site's refusal.
#[derive(Deserialize)]
struct Object<'a> {
    #[serde(rename = "Shader", borrow)]
    shader: Option<&'a RawValue>,
    /// The site's export of all shaders of one author.
    #[serde(borrow)]
    shaders: Option<&'a RawValue>,
    #[serde(rename = "Error")]
    error: Option<Loose>,
    #[serde(borrow)]
    info: Option<&'a RawValue>,
    #[serde(borrow)]
    renderpass: Option<Vec<&'a RawValue>>,
}

#[derive(Deserialize)]
struct Info {
    name: Option<Loose>,
}

/// Whether a text is JSON: GLSL never begins like this.
pub(super) fn is_json(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let begins = |open: char, inside: &[char]| {
        text.strip_prefix(open)
            .is_some_and(|rest| rest.trim_start().starts_with(inside))
    };
    begins('{', &['"', '}']) || begins('[', &['{', '[', ']'])
}

/// The one shader in a JSON text.
pub(super) struct Shader<'a> {
    /// Its object in the text.
    pub object: &'a str,
    /// What its author calls it.
    pub title: Option<String>,
    /// Its passes, in the text's order.
    pub tabs: Vec<Parsed>,
}

/// Finds the one shader in a JSON text, and reads its passes.
pub(super) fn read<'a>(
    file: FileId,
    text: &'a str,
    warnings: &mut Vec<Diagnostic>,
) -> Result<Shader<'a>, Diagnostic> {
    let reader = Reader { file, text };
    let whole = text.trim_start_matches('\u{feff}').trim();
    let (object, place) = reader.shader(whole, MAX_WRAPPERS)?;
    let raw_passes = object.renderpass.ok_or_else(|| {
        problem("missing field `renderpass`, the list of passes").at(reader.start(place))
    })?;
    let title = reader.name_of(object.info);
    let tabs = pass::tabs(&reader, &raw_passes, warnings)?;
    if !tabs
        .iter()
        .any(|tab| tab.kind == Tab::Pass(PassKind::Image))
    {
        return Err(Diagnostic::error(
            "no-image-pass",
            "the shader has no Image pass, so that there is nothing to show",
        )
        .at(reader.start(place))
        .hint("one entry of `renderpass` has the type `image`"));
    }
    Ok(Shader {
        object: place,
        title,
        tabs,
    })
}

/// Makes a scene of the one shader in a JSON text.
pub(super) fn load(loading: &mut Loading, stem: &str, file: FileId) -> Result<Parts, Failure> {
    // The text is borrowed while passes are added to the files beside it.
    let text = loading.files.get(file).text.clone();
    let Shader { title, tabs, .. } = read(file, &text, &mut loading.warnings)?;
    Ok(Parts {
        name: title.unwrap_or_else(|| stem.to_owned()),
        size: None,
        passes: passes(&mut loading.files, file, tabs),
    })
}

/// Adds the tabs' texts to the files. Every pass consists of the Common texts and its own.
fn passes(files: &mut SourceMap, file: FileId, tabs: Vec<Parsed>) -> Vec<Pass> {
    let json = files.get(file).name.clone();
    let mut common = Vec::new();
    let mut passes = Vec::new();
    for tab in tabs {
        match tab.kind {
            Tab::Common => common.push(files.add(format!("{json}: Common"), tab.code)),
            Tab::Pass(kind) => passes.push(Pass {
                kind,
                sources: vec![files.add(format!("{json}: {}", kind.name()), tab.code)],
                channels: tab.channels,
                splices: Vec::new(),
            }),
        }
    }
    for pass in &mut passes {
        pass.sources.splice(0..0, common.iter().copied());
    }
    // Buffers keep the file's order, which is the order in which the site draws them.
    passes.sort_by_key(|pass| match pass.kind {
        PassKind::Sound => 0,
        PassKind::Buffer(_) => 1,
        PassKind::Cube => 2,
        PassKind::Image => 3,
    });
    passes
}

/// The text of a JSON file, of which every part can be pointed at.
struct Reader<'a> {
    file: FileId,
    text: &'a str,
}

impl<'a> Reader<'a> {
    /// Reads a part of the text. `part` is a slice of [`Reader::text`].
    fn parse<T: Deserialize<'a>>(&self, part: &'a str) -> Result<T, Diagnostic> {
        serde_json::from_str(part).map_err(|error| self.refused(part, &error))
    }

    fn refused(&self, part: &str, error: &serde_json::Error) -> Diagnostic {
        let words = error.to_string();
        // The place is shown by other means.
        let words = match words.rsplit_once(" at line ") {
            _ if error.is_eof() => "the text ends in the middle of the shader",
            Some((words, _)) => words,
            None => &*words,
        };
        let line_start: usize = part
            .split_inclusive('\n')
            .take(error.line().saturating_sub(1))
            .map(str::len)
            .sum();
        // serde_json counts the bytes of a line from 1, and 0 stands for the line end before it.
        let mut at = (line_start + error.column().saturating_sub(1)).min(part.len());
        while !part.is_char_boundary(at) {
            at -= 1;
        }
        problem(words).at(self.point(self.offset(part) + at))
    }

    /// Where a part of the text begins in it.
    fn offset(&self, part: &str) -> usize {
        (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize)
    }

    /// The first character of a part.
    fn start(&self, part: &str) -> Span {
        self.point(self.offset(part))
    }

    fn point(&self, offset: usize) -> Span {
        let length = self.text[offset..].chars().next().map_or(0, char::len_utf8);
        let bytes = |offset: usize| u32::try_from(offset).unwrap_or(u32::MAX);
        Span {
            file: self.file,
            start: bytes(offset),
            end: bytes(offset + length),
        }
    }

    /// The one shader in `part`, and where it stands.
    fn shader(&self, part: &'a str, wrappers: usize) -> Result<(Object<'a>, &'a str), Diagnostic> {
        if part.starts_with('[') {
            let list: Vec<&RawValue> = self.parse(part)?;
            return self.only_shader(part, &list, wrappers);
        }
        let object: Object<'a> = self.parse(part)?;
        if let Some(error) = object.error {
            let words = format!("this is no shader but the site's answer \"{}\"", error.0);
            return Err(Diagnostic::error("site-error", words)
                .at(self.start(part))
                .hint("only shaders that their authors published as \"public + API\" can be asked for"));
        }
        if let Some(list) = object.shaders {
            let place = list.get();
            let list: Vec<&RawValue> = self.parse(place)?;
            return self.only_shader(place, &list, wrappers);
        }
        match object.shader {
            Some(inside) => self.unwrapped(inside.get(), wrappers),
            None => Ok((object, part)),
        }
    }

    fn unwrapped(
        &self,
        part: &'a str,
        wrappers: usize,
    ) -> Result<(Object<'a>, &'a str), Diagnostic> {
        match wrappers.checked_sub(1) {
            Some(left) => self.shader(part, left),
            None => Err(
                problem("too many lists and objects stand around the shader").at(self.start(part)),
            ),
        }
    }

    fn only_shader(
        &self,
        place: &str,
        list: &[&'a RawValue],
        wrappers: usize,
    ) -> Result<(Object<'a>, &'a str), Diagnostic> {
        match list {
            [] => Err(problem("the list holds no shader").at(self.start(place))),
            [only] => self.unwrapped(only.get(), wrappers),
            several => {
                let names = several.iter().take(MAX_NAMES).map(|part| self.title(part));
                let mut names = names.collect::<Vec<_>>().join(", ");
                if several.len() > MAX_NAMES {
                    names += &format!(" and {} more", several.len() - MAX_NAMES);
                }
                let words = format!("the file holds {} shaders: {names}", several.len());
                Err(Diagnostic::error("several-shaders", words)
                    .at(self.start(place))
                    .hint("put each into a file of its own"))
            }
        }
    }

    /// What to call one of several shaders.
    fn title(&self, part: &'a RawValue) -> String {
        let object = self.parse::<Object>(part.get()).ok();
        let object = object.and_then(|object| match object.shader {
            Some(inside) => self.parse::<Object>(inside.get()).ok(),
            None => Some(object),
        });
        let name = object.and_then(|object| self.name_of(object.info));
        name.map_or_else(
            || "one without a name".to_owned(),
            |name| format!("`{name}`"),
        )
    }

    /// A shader's name, if it says one.
    fn name_of(&self, info: Option<&'a RawValue>) -> Option<String> {
        let info: Info = self.parse(info?.get()).ok()?;
        info.name
            .map(|name| name.0)
            .filter(|name| !name.trim().is_empty())
    }
}

/// An error in the form of the JSON.
fn problem(words: impl Into<String>) -> Diagnostic {
    Diagnostic::error("json", words)
        .hint("a scene in JSON is one shader, as shadertoy.com exports it or its interface answers")
}

/// Text that one dialect writes as a string and the other as a number.
#[derive(Debug)]
pub(super) struct Loose(pub String);

impl<'de> Deserialize<'de> for Loose {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;

        impl serde::de::Visitor<'_> for Visitor {
            type Value = Loose;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a string or a number")
            }

            fn visit_str<E>(self, value: &str) -> Result<Loose, E> {
                Ok(Loose(value.to_owned()))
            }

            fn visit_bool<E>(self, value: bool) -> Result<Loose, E> {
                Ok(Loose(value.to_string()))
            }

            fn visit_i64<E>(self, value: i64) -> Result<Loose, E> {
                Ok(Loose(value.to_string()))
            }

            fn visit_u64<E>(self, value: u64) -> Result<Loose, E> {
                Ok(Loose(value.to_string()))
            }

            fn visit_f64<E>(self, value: f64) -> Result<Loose, E> {
                Ok(Loose(value.to_string()))
            }
        }

        deserializer.deserialize_any(Visitor)
    }
}

#[cfg(test)]
mod tests;
