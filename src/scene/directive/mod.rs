//! Directives for the host, as the extension "Shader Toy" of Visual Studio Code has them: a single file says what its
//! channels read, which files it includes and which values a person may set. Other shaders that it reads become
//! buffers.
//!
//! The texts stay as they are: each directive becomes a [`Splice`](super::Splice), so that places and lines are the
//! author's.

mod channel;
mod gather;
mod keyboard;
mod line;
mod scan;
mod uniform;

use std::path::{Path, PathBuf};

use super::folder::{Refusal, within};
use super::load::{Failure, Loading, Parts};
use super::{BufferLetter, CHANNELS, Channel, Filter, Input, Pass, PassKind, Sampling, Wrap};
use crate::source::{Diagnostic, FileId, Span};
use channel::Target;
use gather::Unit;
use uniform::Uniform;

/// What shows a buffer, where the first text reads its own last frame and so must be one.
const SHOW: &str = "\
void mainImage(out vec4 color, in vec2 coord) {
    color = texelFetch(iChannel0, ivec2(coord), 0);
}
";

/// Whether a text has a directive for the host.
pub(super) fn has_directives(text: &str) -> bool {
    text.contains('#') && !scan::scan(text).is_empty()
}

/// Makes a scene of a text with directives. Files are looked for beside `path`, if it lies in a file.
pub(super) fn load(
    loading: &mut Loading,
    name: &str,
    file: FileId,
    path: Option<&Path>,
) -> Result<Parts, Failure> {
    let mut shaders = Shaders {
        loading,
        root: path.map(folder_of),
        drafts: Vec::new(),
        begun: Vec::new(),
    };
    shaders.shader(file, path.map(Path::to_owned), None)?;
    let Shaders { drafts, .. } = shaders;
    let passes = passes(loading, drafts)?;
    Ok(Parts {
        name: name.to_owned(),
        size: None,
        passes,
    })
}

/// The folder of a file, by a name that is not empty.
fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// The shaders of a scene, which read one another.
struct Shaders<'a> {
    loading: &'a mut Loading,
    /// The folder of the first one; `None` for a text that lies in no file.
    root: Option<PathBuf>,
    /// Those that are complete, each behind those that it reads: the order in which they are drawn.
    drafts: Vec<Draft>,
    /// Those that were begun, by the names of their files with links followed. A circle ends at one of them.
    begun: Vec<Option<PathBuf>>,
}

/// One shader, with its channels.
struct Draft {
    /// Its number in [`Shaders::begun`]; the first text is 0.
    number: usize,
    own: FileId,
    unit: Unit,
    channels: [Option<Bound>; CHANNELS],
}

/// What a channel of a draft reads.
struct Bound {
    source: Source,
    sampling: Sampling,
    place: Span,
}

enum Source {
    Input(Input),
    /// A shader, by its number.
    Shader(usize),
}

impl Shaders<'_> {
    /// Reads a shader and those that it reads, and says which number it has.
    fn shader(
        &mut self,
        own: FileId,
        path: Option<PathBuf>,
        reader: Option<Span>,
    ) -> Result<usize, Failure> {
        let number = self.begun.len();
        // The first text may be the Image pass, beside four buffers.
        if number > BufferLetter::ALL.len() {
            return Err(too_many(reader).into());
        }
        self.begun.push(path.as_deref().map(real));
        let unit = gather::gather(self.loading, self.root.as_deref(), own, path.as_deref())?;
        let mut channels = [const { None }; CHANNELS];
        for (index, binding) in unit.channels.iter().enumerate() {
            let Some(binding) = binding else {
                let idle = channel::idle(index, &unit.settings[index]);
                self.loading.warnings.extend(idle);
                continue;
            };
            let settings = &unit.settings[index];
            let place = binding.place;
            let folder = binding.folder.as_deref();
            let target = channel::target(
                self.loading,
                self.root.as_deref(),
                folder,
                binding,
                settings,
            )?;
            let source = match target {
                Target::Input(input) => Source::Input(input),
                Target::Own => Source::Shader(number),
                Target::Shader(path) => Source::Shader(self.other(path, place)?),
            };
            let usual = match &source {
                Source::Input(input) => channel::usual(input),
                Source::Shader(_) => Sampling::usual(&Input::Buffer(BufferLetter::A)),
            };
            let sampling = settings.sampling(usual, &mut self.loading.warnings);
            channels[index] = Some(Bound {
                source,
                sampling,
                place,
            });
        }
        self.drafts.push(Draft {
            number,
            own,
            unit,
            channels,
        });
        Ok(number)
    }

    /// Another file, which may have been begun.
    fn other(&mut self, path: PathBuf, place: Span) -> Result<usize, Failure> {
        let known = real(&path);
        let mut begun = self.begun.iter();
        if let Some(number) = begun.position(|one| one.as_ref() == Some(&known)) {
            return Ok(number);
        }
        let file = self.loading.read(&path)?;
        super::file::refuse_empty(&self.loading.files, file)?;
        self.shader(file, Some(path), Some(place))
    }
}

fn too_many(place: Option<Span>) -> Diagnostic {
    Diagnostic::error("directive", "the scene needs more than four buffers")
        .at(place)
        .hint("every other shader that is read is a buffer, and so is one that reads itself")
}

fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

/// Gives the drafts their letters.
fn passes(loading: &mut Loading, drafts: Vec<Draft>) -> Result<Vec<Pass>, Failure> {
    let reads = |number: usize| {
        let all = drafts
            .iter()
            .flat_map(|draft| draft.channels.iter().flatten());
        let mut all =
            all.filter(|bound| matches!(bound.source, Source::Shader(of) if of == number));
        all.next().map(|bound| bound.place)
    };
    // The picture is no buffer: where it is read, it is drawn as one and shown.
    let shown = reads(0);
    let buffers = drafts
        .iter()
        .filter(|draft| draft.number != 0 || shown.is_some());
    let numbers: Vec<usize> = buffers.map(|draft| draft.number).collect();
    if let Some(&excess) = numbers.get(BufferLetter::ALL.len()) {
        return Err(too_many(reads(excess)).into());
    }
    let letter = |number: usize| {
        let at = numbers.iter().position(|&one| one == number);
        at.map(|at| BufferLetter::ALL[at])
    };
    let uniforms: Vec<Uniform> = drafts
        .iter()
        .flat_map(|draft| draft.unit.uniforms.iter().cloned())
        .collect();
    let mut passes = Vec::new();
    for draft in &drafts {
        let kind = letter(draft.number).map_or(PassKind::Image, PassKind::Buffer);
        let mut channels = [const { None }; CHANNELS];
        for (channel, bound) in channels.iter_mut().zip(&draft.channels) {
            let Some(bound) = bound else { continue };
            let input = match &bound.source {
                Source::Input(input) => Some(input.clone()),
                Source::Shader(number) => letter(*number).map(Input::Buffer),
            };
            let sampling = bound.sampling;
            *channel = input.map(|input| Channel { input, sampling });
        }
        let mut pass = Pass {
            kind,
            sources: vec![draft.own],
            channels,
            splices: draft.unit.splices(),
        };
        let ahead = ahead(loading, &draft.unit, &mut pass, &uniforms)?;
        if !ahead.is_empty() {
            // The last line gives the author's lines their own numbers.
            let name = format!("{}: directives", loading.files.get(draft.own).name);
            let text = loading.files.add(name, ahead + "#line 1");
            pass.sources.insert(0, text);
        }
        passes.push(pass);
    }
    if let Some(letter) = letter(0) {
        let shown = Channel {
            input: Input::Buffer(letter),
            sampling: Sampling {
                filter: Filter::Nearest,
                wrap: Wrap::Clamp,
                vflip: true,
            },
        };
        passes.push(Pass {
            kind: PassKind::Image,
            sources: vec![loading.files.add("what shows the buffer", SHOW)],
            channels: [Some(shown), None, None, None],
            splices: Vec::new(),
        });
    }
    Ok(passes)
}

/// The text ahead of a pass: the values that it mentions, and the keyboard's functions, for which a channel is bound.
fn ahead(
    loading: &mut Loading,
    unit: &Unit,
    pass: &mut Pass,
    uniforms: &[Uniform],
) -> Result<String, Failure> {
    let texts = pass.texts(&loading.files).concat();
    let mut ahead = String::new();
    if texts.contains("iGlobalTime") {
        ahead += "#define iGlobalTime iTime\n";
    }
    if let Some(place) = unit.controls {
        ahead += "const mat4 iViewMatrix = mat4(1.0);\n";
        let message = "nothing moves the camera here: `iViewMatrix` stays the identity";
        let warning = Diagnostic::warning("directive-differs", message);
        loading.warnings.push(warning.at(place));
    }
    let mut declared: Vec<&str> = Vec::new();
    for uniform in uniforms {
        let name = &*uniform.name;
        let is_own = unit.uniforms.contains(uniform);
        if declared.contains(&name) || !(is_own || texts.contains(name)) {
            continue;
        }
        declared.push(name);
        ahead += &format!("#ifndef {name}\n{}\n#endif\n", uniform.declaration);
    }
    let Some(place) = unit.keyboard else {
        return Ok(ahead);
    };
    let is_keyboard = |bound: &Option<Channel>| matches!(bound, Some(channel) if channel.input == Input::Keyboard);
    let bound = pass.channels.iter().position(is_keyboard);
    let free = (0..CHANNELS)
        .rev()
        .find(|&index| pass.channels[index].is_none());
    let Some(index) = bound.or(free) else {
        let message = "the keyboard needs a channel, and all four are bound";
        return Err(Diagnostic::error("directive", message)
            .at(place)
            .hint("leave one of iChannel0 to iChannel3 free")
            .into());
    };
    let input = Input::Keyboard;
    let sampling = Sampling::usual(&input);
    pass.channels[index] = Some(Channel { input, sampling });
    if texts.contains("isKeyReleased") {
        let message = "`isKeyReleased` is never true: the keyboard's texture, as on ShaderToy, does not know of keys that were let go";
        let warning = Diagnostic::warning("directive-differs", message);
        loading.warnings.push(warning.at(place));
    }
    let mentions = |word: &str| texts.contains(word);
    Ok(ahead + &keyboard::text(index, mentions))
}

/// The file that a directive names, looked for beside its own file and beside the first one.
fn named_file(
    loading: &mut Loading,
    root: Option<&Path>,
    folder: Option<&Path>,
    name: &str,
    place: Span,
) -> Result<PathBuf, Diagnostic> {
    let error = |message: String| Diagnostic::error("directive", message).at(place);
    if name.starts_with("http://") || name.starts_with("https://") {
        return Err(error(format!(
            "`{name}` lies on the network, and nothing is loaded from there"
        ))
        .hint("save it beside the shader, and name the file"));
    }
    let Some((root, folder)) = root.zip(folder) else {
        return Err(error(format!("there is no folder to look for `{name}` in"))
            .hint("save the text in a file beside it, and open that"));
    };
    let plain = name.replace('\\', "/");
    let mut missing = None;
    for folder in [folder, root] {
        match within(loading, folder, &plain, root) {
            Ok(path) => return Ok(path),
            Err(Refusal::Missing(path)) => missing = missing.or(Some(path)),
            Err(Refusal::Outside) => {}
        }
    }
    Err(match missing {
        Some(path) => error(format!("there is no file `{}`", path.display()))
            .hint("paths are relative to the file that names them"),
        None => error(format!("`{name}` lies outside the shader's folder")).hint(
            "name a file in the shader's folder or in a folder beside it, by a relative path",
        ),
    })
}
