//! What the directives of a text say, and those of all texts that it includes.

use std::path::{Path, PathBuf};

use super::channel::{Binding, Setting, Settings};
use super::line::Line;
use super::scan::{Found, scan};
use super::uniform::{self, Uniform};
use super::{folder_of, named_file, real};
use crate::scene::load::{Failure, Loading, MAX_BYTES};
use crate::scene::{CHANNELS, Splice};
use crate::source::{Diagnostic, FileId, Span};

/// Texts that include texts.
const MAX_DEPTH: usize = 16;

/// How often a text may include others, all of them counted as often as they come.
const MAX_INCLUDES: u64 = 1_000;

/// Values that a person may set.
const MAX_UNIFORMS: usize = 200;

/// A text with all that its directives say.
#[derive(Default)]
pub(super) struct Unit {
    pub channels: [Option<Binding>; CHANNELS],
    pub settings: [Settings; CHANNELS],
    pub uniforms: Vec<Uniform>,
    pub keyboard: Option<Span>,
    pub controls: Option<Span>,
    texts: Vec<Text>,
}

/// One of the texts that a unit consists of.
struct Text {
    file: FileId,
    /// Its name with links followed.
    real: Option<PathBuf>,
    splices: Vec<Splice>,
    /// What it comes to with all that it includes; nothing while that is being found out.
    extent: Option<Extent>,
}

#[derive(Clone, Copy)]
struct Extent {
    bytes: u64,
    includes: u64,
}

impl Unit {
    /// The places of all directives, in the order of files and places.
    pub fn splices(&self) -> Vec<Splice> {
        let all = self.texts.iter().flat_map(|text| text.splices.iter());
        let mut all: Vec<Splice> = all.copied().collect();
        all.sort_by_key(|splice| (splice.place.file, splice.place.start));
        all
    }
}

/// Reads a text's directives and includes.
pub(super) fn gather(
    loading: &mut Loading,
    root: Option<&Path>,
    own: FileId,
    path: Option<&Path>,
) -> Result<Unit, Failure> {
    let mut gathering = Gathering {
        loading,
        root,
        unit: Unit::default(),
    };
    gathering.text(own, path, 0)?;
    Ok(gathering.unit)
}

struct Gathering<'a> {
    loading: &'a mut Loading,
    root: Option<&'a Path>,
    unit: Unit,
}

impl Gathering<'_> {
    fn text(&mut self, file: FileId, path: Option<&Path>, depth: usize) -> Result<Extent, Failure> {
        // The text is borrowed while files are added beside it.
        let text = self.loading.files.get(file).text.clone();
        let number = self.unit.texts.len();
        self.unit.texts.push(Text {
            file,
            real: path.map(real),
            splices: Vec::new(),
            extent: None,
        });
        let mut extent = Extent {
            bytes: text.len() as u64,
            includes: 0,
        };
        for found in scan(&text) {
            let included = match found.name {
                "include" => {
                    let (included, inner) = self.include(file, path, &found, depth)?;
                    extent.bytes += inner.bytes;
                    extent.includes += inner.includes + 1;
                    if extent.bytes > MAX_BYTES || extent.includes > MAX_INCLUDES {
                        let message = "the text includes others too often";
                        let problem = Diagnostic::error("directive", message);
                        return Err(problem.at(place(file, &found)).into());
                    }
                    Some(included)
                }
                _ => {
                    self.obey(file, path, &found)?;
                    None
                }
            };
            self.unit.texts[number].splices.push(Splice {
                place: place(file, &found),
                text: included,
            });
        }
        self.unit.texts[number].extent = Some(extent);
        Ok(extent)
    }

    fn include(
        &mut self,
        file: FileId,
        path: Option<&Path>,
        found: &Found<'_>,
        depth: usize,
    ) -> Result<(FileId, Extent), Failure> {
        let mut line = Line::new(file, found);
        let name = line.string("the name of a file in quotes")?;
        line.end()?;
        let folder = path.map(folder_of);
        let plain = without_scheme(name.text);
        let path = named_file(
            self.loading,
            self.root,
            folder.as_deref(),
            plain,
            name.place,
        )?;
        let known = real(&path);
        let mut texts = self.unit.texts.iter();
        if let Some(text) = texts.find(|text| text.real.as_ref() == Some(&known)) {
            let Some(extent) = text.extent else {
                let message = format!("`{}` includes itself", path.display());
                let problem = Diagnostic::error("directive", message);
                return Err(problem.at(name.place).into());
            };
            return Ok((text.file, extent));
        }
        if depth == MAX_DEPTH {
            let message = format!("texts include texts more than {MAX_DEPTH} deep");
            let problem = Diagnostic::error("directive", message);
            return Err(problem.at(name.place).into());
        }
        let file = self.loading.read(&path)?;
        let extent = self.text(file, Some(&path), depth + 1)?;
        Ok((file, extent))
    }

    /// Keeps what a directive says that brings no text.
    fn obey(
        &mut self,
        file: FileId,
        path: Option<&Path>,
        found: &Found<'_>,
    ) -> Result<(), Diagnostic> {
        let mut line = Line::new(file, found);
        let whole = place(file, found);
        match found.name {
            "iUniform" => {
                let uniform = uniform::parse(&mut line)?;
                if self.unit.uniforms.len() == MAX_UNIFORMS {
                    let message = format!("there are more than {MAX_UNIFORMS} values to set");
                    return Err(Diagnostic::error("directive", message).at(uniform.place));
                }
                self.unit.uniforms.push(uniform);
                return Ok(());
            }
            "iKeyboard" => self.unit.keyboard = Some(whole),
            "iFirstPersonControls" => self.unit.controls = Some(whole),
            "StrictCompatibility" => {}
            "iVertex" => {
                let message = "there are no vertex shaders here";
                return Err(Diagnostic::error("directive", message)
                    .at(whole)
                    .hint("a pass is one fragment shader that covers the picture"));
            }
            _ => return self.channel(file, path, found, line),
        }
        line.end()
    }

    /// `#iChannel0 "…"` and `#iChannel0::Key "…"`.
    fn channel(
        &mut self,
        file: FileId,
        path: Option<&Path>,
        found: &Found<'_>,
        mut line: Line<'_>,
    ) -> Result<(), Diagnostic> {
        let number = found.name.trim_start_matches("iChannel");
        let Some(index) = (0..CHANNELS).find(|index| number == index.to_string()) else {
            let message = format!("there is no `{}`", found.name);
            return Err(Diagnostic::error("directive", message)
                .at(place(file, found))
                .hint("a pass has the channels iChannel0 to iChannel3"));
        };
        if line.take("::") {
            let setting = Setting::parse(&mut line)?;
            line.end()?;
            self.unit.settings[index].set(setting);
            return Ok(());
        }
        let name = line.string("a file in quotes, or `::` and a setting,")?;
        line.end()?;
        self.unit.channels[index] = Some(Binding {
            name: without_scheme(name.text).to_owned(),
            folder: path.map(folder_of),
            place: name.place,
        });
        Ok(())
    }
}

fn place(file: FileId, found: &Found<'_>) -> Span {
    let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
    Span {
        file,
        start: offset(found.start),
        end: offset(found.end()),
    }
}

/// A path as the extension writes it, without what says that it is one.
fn without_scheme(name: &str) -> &str {
    let name = name.strip_prefix("file://").unwrap_or(name);
    name.strip_prefix("buf://").unwrap_or(name)
}
