//! `#iChannel0 "…"`: what a channel reads, and how.

use std::path::{Path, PathBuf};

use super::line::Line;
use super::named_file;
use crate::scene::load::{Failure, Loading};
use crate::scene::{FileKind, Filter, Input, Media, Sampling, Wrap};
use crate::source::{Diagnostic, Span};

/// What is written behind `#iChannel0`.
pub(super) struct Binding {
    pub name: String,
    /// The folder of the text that says so.
    pub folder: Option<PathBuf>,
    pub place: Span,
}

/// What a channel reads.
pub(super) enum Target {
    Input(Input),
    /// The last frame of the same shader.
    Own,
    /// What another shader draws.
    Shader(PathBuf),
}

/// How names of shaders end.
const SHADERS: [&str; 6] = ["glsl", "frag", "fs", "fsh", "shader", "txt"];

/// What the files of a cubemap are called in the place of `{}`, in the order of the faces.
const DIRECTIONS: [[&str; 6]; 5] = [
    ["e", "w", "u", "d", "n", "s"],
    ["east", "west", "up", "down", "north", "south"],
    ["px", "nx", "py", "ny", "pz", "nz"],
    ["posx", "negx", "posy", "negy", "posz", "negz"],
    ["0", "1", "2", "3", "4", "5"],
];

/// Finds what a channel reads.
pub(super) fn target(
    loading: &mut Loading,
    root: Option<&Path>,
    folder: Option<&Path>,
    binding: &Binding,
    settings: &Settings,
) -> Result<Target, Failure> {
    let name = &*binding.name;
    match name {
        "self" => return Ok(Target::Own),
        "keyboard" => return Ok(Target::Input(Input::Keyboard)),
        _ => {}
    }
    let asked = settings.ty.map(|(kind, _)| kind);
    if name.contains("{}") || name.contains('*') {
        return cubemap(loading, root, folder, binding);
    }
    let path = named_file(loading, root, folder, name, binding.place)?;
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    if SHADERS.contains(&&*ending.to_ascii_lowercase()) {
        return Ok(Target::Shader(path));
    }
    let Some(kind) = asked.or_else(|| FileKind::of_file(&path)) else {
        let all: Vec<_> = SHADERS.into_iter().chain(FileKind::endings()).collect();
        let message = format!("`{name}` is of no kind that a channel can read");
        return Err(Diagnostic::error("directive", message)
            .at(binding.place)
            .hint(format!("files end in one of: {}", all.join(", ")))
            .into());
    };
    loading.depends_on(&path);
    Ok(Target::Input(kind.input(Media::Files(vec![path]))))
}

/// Six pictures, whose names differ in what stands for `{}`.
fn cubemap(
    loading: &mut Loading,
    root: Option<&Path>,
    folder: Option<&Path>,
    binding: &Binding,
) -> Result<Target, Failure> {
    let pattern = binding.name.replacen('*', "{}", 1);
    let mut problem = None;
    for directions in DIRECTIONS {
        let mut faces = Vec::new();
        for direction in directions {
            let name = pattern.replacen("{}", direction, 1);
            match named_file(loading, root, folder, &name, binding.place) {
                Ok(path) => faces.push(path),
                Err(found) => {
                    problem.get_or_insert(found);
                    break;
                }
            }
        }
        if faces.len() == directions.len() {
            faces.iter().for_each(|face| loading.depends_on(face));
            return Ok(Target::Input(Input::Cubemap(Media::Files(faces))));
        }
    }
    let sets = DIRECTIONS.map(|directions| directions.join(" "));
    let problem = problem.unwrap_or_else(|| Diagnostic::error("directive", "a face is missing"));
    let problem = problem.hint(format!(
        "`{{}}` stands for the six directions, in one of these spellings: {}",
        sets.join(", ")
    ));
    Err(problem.into())
}

/// How the extension reads an input that has no settings.
pub(super) fn usual(input: &Input) -> Sampling {
    let usual = Sampling::usual(input);
    match input {
        Input::Texture(_) => Sampling {
            filter: Filter::Linear,
            ..usual
        },
        _ => usual,
    }
}

/// A warning about settings of a channel that nothing is bound to.
pub(super) fn idle(index: usize, settings: &Settings) -> Option<Diagnostic> {
    let message = format!("this does nothing: nothing is bound to iChannel{index}");
    let warning = Diagnostic::warning("unbound-channel", message).at(settings.first?);
    Some(warning.hint(format!(
        "bind a file, as in `#iChannel{index} \"rock.png\"`"
    )))
}

/// One setting, with the place of its value.
pub(super) enum Setting {
    Min(Filter, Span),
    Mag(Filter, Span),
    Wrap(Wrap, Span),
    VFlip(bool, Span),
    Type(FileKind, Span),
}

/// Finds a value among those that a setting has.
fn choose<T: Copy>(
    line: &mut Line<'_>,
    key: &str,
    values: &[(&str, T)],
) -> Result<(T, Span), Diagnostic> {
    let value = line.string("a value in quotes")?;
    let found = values.iter().find(|(name, _)| *name == value.text);
    match found {
        Some((_, found)) => Ok((*found, value.place)),
        None => {
            let names: Vec<_> = values
                .iter()
                .map(|(name, _)| format!("\"{name}\""))
                .collect();
            let message = format!("`{key}` cannot be `{}`", value.text);
            Err(Diagnostic::error("directive", message)
                .at(value.place)
                .hint(format!("it is one of {}", names.join(", "))))
        }
    }
}

impl Setting {
    /// Reads what follows `::`.
    pub fn parse(line: &mut Line<'_>) -> Result<Self, Diagnostic> {
        let key = line.word("the name of a setting")?;
        Ok(match key.text {
            "MinFilter" => {
                let values = [
                    ("Nearest", Filter::Nearest),
                    ("Linear", Filter::Linear),
                    ("NearestMipMapNearest", Filter::Mipmap),
                    ("NearestMipMapLinear", Filter::Mipmap),
                    ("LinearMipMapNearest", Filter::Mipmap),
                    ("LinearMipMapLinear", Filter::Mipmap),
                ];
                let (filter, place) = choose(line, key.text, &values)?;
                Setting::Min(filter, place)
            }
            "MagFilter" => {
                let values = [("Nearest", Filter::Nearest), ("Linear", Filter::Linear)];
                let (filter, place) = choose(line, key.text, &values)?;
                Setting::Mag(filter, place)
            }
            "WrapMode" => {
                let values = [
                    ("Clamp", Wrap::Clamp),
                    ("Repeat", Wrap::Repeat),
                    ("Mirror", Wrap::Mirror),
                ];
                let (wrap, place) = choose(line, key.text, &values)?;
                Setting::Wrap(wrap, place)
            }
            "VFlip" => {
                let values = [("true", true), ("false", false)];
                let (vflip, place) = choose(line, key.text, &values)?;
                Setting::VFlip(vflip, place)
            }
            "Type" => {
                let values = [
                    ("Texture2D", FileKind::Texture),
                    ("CubeMap", FileKind::Cubemap),
                    ("Volume", FileKind::Volume),
                    ("Video", FileKind::Video),
                    ("Music", FileKind::Music),
                ];
                let (kind, place) = choose(line, key.text, &values)?;
                Setting::Type(kind, place)
            }
            other => {
                let message = format!("a channel has no setting `{other}`");
                return Err(Diagnostic::error("directive", message)
                    .at(key.place)
                    .hint("the settings are MinFilter, MagFilter, WrapMode, VFlip and Type"));
            }
        })
    }
}

/// All settings of a channel; the last one of each kind counts.
#[derive(Default)]
pub(super) struct Settings {
    min: Option<(Filter, Span)>,
    mag: Option<(Filter, Span)>,
    wrap: Option<(Wrap, Span)>,
    vflip: Option<bool>,
    pub ty: Option<(FileKind, Span)>,
    /// Where the first of them stands.
    first: Option<Span>,
}

impl Settings {
    pub fn set(&mut self, setting: Setting) {
        let place = match setting {
            Setting::Min(filter, place) => self.min.insert((filter, place)).1,
            Setting::Mag(filter, place) => self.mag.insert((filter, place)).1,
            Setting::Wrap(wrap, place) => self.wrap.insert((wrap, place)).1,
            Setting::Type(kind, place) => self.ty.insert((kind, place)).1,
            Setting::VFlip(vflip, place) => {
                self.vflip = Some(vflip);
                place
            }
        };
        self.first.get_or_insert(place);
    }

    /// How a channel is read that is usually read in this way.
    pub fn sampling(&self, usual: Sampling, warnings: &mut Vec<Diagnostic>) -> Sampling {
        let differs =
            |place, message: &str| Diagnostic::warning("directive-differs", message).at(place);
        let filter = match (self.min, self.mag) {
            (None, None) => usual.filter,
            (Some((Filter::Mipmap, _)), None | Some((Filter::Linear, _))) => Filter::Mipmap,
            (Some((filter, _)), None) => filter,
            (None, Some((filter, _))) => filter,
            (Some((min, _)), Some((mag, place))) => {
                if min != mag {
                    let message = format!(
                        "one filter serves both cases here: the texture is read with `{}`, also where it is shrunk",
                        mag.name()
                    );
                    warnings.push(differs(place, &message));
                }
                mag
            }
        };
        let wrap = self.wrap.map_or(usual.wrap, |(wrap, _)| wrap);
        Sampling {
            filter,
            wrap,
            vflip: self.vflip.unwrap_or(usual.vflip),
        }
    }
}
