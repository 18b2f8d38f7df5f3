//! The live triple of scene, programs and renderer: the same in window, export and tests.

mod findings;
mod floats;
mod track;

pub use findings::Findings;
pub use floats::{Drawn, Moment, Subject};
pub use track::Track;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::media::{Content, Inputs, Library, MediaError};
use crate::render::{Format, Gpu, GpuError, Renderer};
use crate::scene::{
    self, Binding, Channel, Input, LoadError, LoadErrorKind, Pass, PassKind, Scene, Source,
};
use crate::source::{Diagnostic, Report, Span};
use crate::translate::{self, Arithmetic, Checks, Program};

/// How many rounds loops that are not known to end may make in a pixel: some tenths of a second on a
/// GPU, and hundreds of times what any picture needs that is drawn while someone watches.
pub const ROUND_BUDGET: u32 = 1 << 22;

/// How a scene is opened.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    /// How it is translated.
    pub options: translate::Options,
    /// The format of the pictures.
    pub format: Format,
    /// Where the files come from that its channels read.
    pub library: Arc<Library>,
    /// What its channels read in the place of what the scene says.
    pub bindings: Vec<Binding>,
    /// Whether it is opened for its sound. Else it is for its picture.
    pub for_sound: bool,
}

impl From<translate::Options> for Setup {
    fn from(options: translate::Options) -> Self {
        Setup {
            options,
            ..Setup::default()
        }
    }
}

/// A scene that can be drawn.
#[derive(Debug)]
pub struct Session {
    /// What was loaded.
    pub scene: Scene,
    /// Its translation, a program for each pass.
    pub programs: Vec<Program>,
    /// Its GPU objects.
    pub renderer: Renderer,
    /// What the author should know although the scene runs.
    pub warnings: Report,
    /// What its channels read.
    pub inputs: Inputs,
    /// The passes that were left out, because what is wanted needs nothing of them.
    pub left_out: Vec<PassKind>,
    /// How it was opened, and is when it is reloaded.
    pub setup: Setup,
    /// How long it took to get here.
    pub timing: Timing,
}

/// How long the steps of opening a scene took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// Reading files.
    pub load: Duration,
    /// From GLSL to programs.
    pub translate: Duration,
    /// From programs to pipelines, textures and buffers.
    pub build: Duration,
}

impl Timing {
    /// All of it.
    pub fn total(&self) -> Duration {
        self.load + self.translate + self.build
    }
}

/// Why a scene could not be opened.
#[derive(Debug)]
pub enum OpenError {
    /// Something is wrong with the scene; its author can mend it.
    Scene {
        /// What.
        report: Report,
        /// The files that the attempt looked at, if that is known.
        read: Vec<PathBuf>,
    },
    /// A file could not be read.
    Io {
        /// Which.
        path: PathBuf,
        /// What the system said.
        error: std::io::Error,
    },
    /// The driver failed.
    Gpu(GpuError),
}

impl From<LoadError> for OpenError {
    fn from(error: LoadError) -> Self {
        match error.kind {
            LoadErrorKind::Scene(report) => OpenError::Scene {
                report,
                read: error.read,
            },
            LoadErrorKind::Io { path, error } => OpenError::Io { path, error },
        }
    }
}

impl From<GpuError> for OpenError {
    fn from(error: GpuError) -> Self {
        OpenError::Gpu(error)
    }
}

impl Session {
    /// Loads, translates and builds a scene.
    pub fn open(gpu: &Gpu, source: &Source, setup: &Setup) -> Result<Self, OpenError> {
        let options = &setup.options;
        let start = Instant::now();
        let mut scene = scene::load(source)?;
        let loaded = Instant::now();
        let read = scene.read.clone();
        let in_scene = |report| OpenError::Scene {
            report,
            read: read.clone(),
        };
        // What is drawn shall look as it does in a browser.
        let options = translate::Options {
            arithmetic: Arithmetic::Expanded,
            // A loop that never ends must not take the machine with it.
            round_budget: Some(options.round_budget.unwrap_or(ROUND_BUDGET)),
            round_limit: options.round_limit.or(gpu.round_limit()),
            checks: match &options.checks {
                // Without it a loop that is cut off is merely not told of.
                Checks::Loops if !gpu.can_note_findings() => Checks::None,
                checks => checks.clone(),
            },
            ..options.clone()
        };
        scene.bind(&setup.bindings).map_err(in_scene)?;
        let mut programs = translate::translate(&scene, &options).map_err(in_scene)?;
        let mut diagnostics = warnings(&scene, &programs);
        diagnostics.extend(idle_bindings(&scene, &programs, &setup.bindings));
        let wanted = match setup.for_sound {
            true => PassKind::Sound,
            false => PassKind::Image,
        };
        let left_out = leave_out(&mut scene, &mut programs, wanted);
        let translated = Instant::now();
        let inputs = inputs(&scene, &programs, &setup.library).map_err(in_scene)?;
        let renderer = Renderer::new(gpu, &scene, &programs, &inputs, setup.format)?;
        let timing = Timing {
            load: loaded - start,
            translate: translated - loaded,
            build: translated.elapsed(),
        };
        let warnings = Report {
            files: scene.files.clone(),
            diagnostics,
        };
        Ok(Session {
            scene,
            programs,
            renderer,
            warnings,
            inputs,
            left_out,
            setup: Setup {
                options,
                ..setup.clone()
            },
            timing,
        })
    }

    /// Whether the scene has a Sound pass, for which it was not opened.
    pub fn has_sound(&self) -> bool {
        self.left_out.contains(&PassKind::Sound)
    }

    /// Music of which the user has a file, on channels that nothing reads: it is there to be heard.
    pub fn idle_music(&self) -> Vec<Input> {
        let mut found = Vec::new();
        for (place, pass) in self.scene.passes.iter().enumerate() {
            for (index, channel) in pass.channels.iter().enumerate() {
                if let Some(Channel { input, .. }) = channel
                    && matches!(input, Input::Music(_) | Input::MusicStream(_))
                    && self.inputs.of(place, index).is_none()
                    && !self.setup.library.is_missing(input)
                {
                    found.push(input.clone());
                }
            }
        }
        found
    }

    /// Whether some pass reads the keyboard.
    pub fn reads_keyboard(&self) -> bool {
        let passes = self.scene.passes.iter().zip(&self.programs);
        passes.into_iter().any(|(pass, program)| {
            let channels = pass.channels.iter().zip(&program.channels);
            channels.into_iter().any(|(channel, usage)| {
                let input = channel.as_ref().map(|channel| &channel.input);
                usage.texture && input == Some(&Input::Keyboard)
            })
        })
    }

    /// Opens the scene anew, in the way of the first time, and, if that succeeds, becomes the
    /// new one. On failure nothing changes:
    /// what was drawn before can go on.
    pub fn reload(&mut self, gpu: &Gpu, source: &Source) -> Result<(), OpenError> {
        *self = Session::open(gpu, source, &self.setup)?;
        Ok(())
    }
}

fn warnings(scene: &Scene, programs: &[Program]) -> Vec<Diagnostic> {
    let of_programs = programs.iter().flat_map(|program| &program.warnings);
    scene.warnings.iter().chain(of_programs).cloned().collect()
}

/// Warns about channels that were bound to something, and are not read.
fn idle_bindings(scene: &Scene, programs: &[Program], bindings: &[Binding]) -> Vec<Diagnostic> {
    let is_read = |binding: &&Binding| {
        let mut passes = scene.passes.iter().zip(programs);
        let found = passes.find(|(pass, _)| pass.kind == binding.pass);
        found.is_some_and(|(_, program)| program.channels[binding.channel].texture)
    };
    let idle = bindings.iter().filter(|binding| !is_read(binding));
    idle.map(
        |Binding {
             pass,
             channel,
             what,
         }| {
            let message = format!(
                "{}: nothing reads iChannel{channel}, which is bound to `{what}`",
                pass.name()
            );
            Diagnostic {
                pass: Some(pass.name().to_owned()),
                ..Diagnostic::warning("unused-binding", message)
            }
        },
    )
    .collect()
}

/// Loads what the channels of a scene's passes read, as far as their programs use it.
fn inputs(scene: &Scene, programs: &[Program], library: &Library) -> Result<Inputs, Report> {
    let mut diagnostics = Vec::new();
    let mut opened: Vec<(&Input, Option<Content>)> = Vec::new();
    let mut passes = Vec::new();
    for (pass, program) in scene.passes.iter().zip(programs) {
        passes.push(std::array::from_fn(|index| {
            let channel = pass.channels[index].as_ref()?;
            let is_still = matches!(
                channel.input,
                Input::Noise | Input::Texture(_) | Input::Volume(_)
            );
            // On the site, sounds read nothing else.
            if pass.kind == PassKind::Sound && !is_still {
                return None;
            }
            if !program.channels[index].texture && !program.reads_about_channels() {
                return None;
            }
            // What several channels read plays once.
            if let Some((_, content)) = opened.iter().find(|(input, _)| *input == &channel.input) {
                return Clone::clone(content);
            }
            let content = library.open(&channel.input).unwrap_or_else(|error| {
                diagnostics.push(unreadable(scene, pass, index, &error));
                None
            });
            opened.push((&channel.input, content.clone()));
            content
        }));
    }
    match diagnostics.is_empty() {
        true => Ok(Inputs::new(passes)),
        false => Err(Report {
            files: scene.files.clone(),
            diagnostics,
        }),
    }
}

/// That what a channel reads cannot be had.
fn unreadable(scene: &Scene, pass: &Pass, channel: usize, error: &MediaError) -> Diagnostic {
    let own = pass.sources.last().map(|&file| {
        let whole = scene.files.whole(file);
        Span {
            end: whole.start,
            ..whole
        }
    });
    Diagnostic {
        pass: Some(pass.kind.name().to_owned()),
        ..Diagnostic::error(
            "media",
            format!("iChannel{channel} of {}: {error}", pass.kind.name()),
        )
        .at(own)
        .hint(error.hint())
    }
}

/// Leaves out the passes that the wanted one needs nothing of, and says which.
fn leave_out(scene: &mut Scene, programs: &mut Vec<Program>, wanted: PassKind) -> Vec<PassKind> {
    let mut needed: Vec<bool> = scene
        .passes
        .iter()
        .map(|pass| pass.kind == wanted)
        .collect();
    loop {
        let mut found = needed.clone();
        for (place, pass) in scene
            .passes
            .iter()
            .enumerate()
            .filter(|(place, _)| needed[*place])
        {
            for (channel, usage) in pass.channels.iter().zip(&programs[place].channels) {
                let Some(kind) = channel.as_ref().and_then(|channel| channel.input.pass()) else {
                    continue;
                };
                let is_read = |other: &Pass| usage.texture && other.kind == kind;
                for (found, other) in found.iter_mut().zip(&scene.passes) {
                    *found |= is_read(other);
                }
            }
        }
        if found == needed {
            break;
        }
        needed = found;
    }
    let mut keep = needed.iter().copied();
    programs.retain(|_| keep.next().expect("one for each pass"));
    let (kept, left_out): (Vec<_>, Vec<_>) = std::mem::take(&mut scene.passes)
        .into_iter()
        .zip(needed)
        .partition(|(_, is_needed)| *is_needed);
    scene.passes = kept.into_iter().map(|(pass, _)| pass).collect();
    left_out.into_iter().map(|(pass, _)| pass.kind).collect()
}
