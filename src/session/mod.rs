//! The live triple of scene, programs and renderer: the same in window, export and tests.

mod findings;
mod floats;

pub use findings::Findings;
pub use floats::{Drawn, Moment, Subject};

use std::path::PathBuf;
use std::time::{Duration, Instant};

use crate::render::{Format, Gpu, GpuError, Renderer};
use crate::scene::{self, Input, LoadError, LoadErrorKind, Pass, PassKind, Scene, Source};
use crate::source::{Diagnostic, Report, Span};
use crate::translate::{self, Arithmetic, Checks, Program};

/// How many rounds loops that are not known to end may make in a pixel: some tenths of a second on a
/// GPU, and hundreds of times what any picture needs that is drawn while someone watches.
pub const ROUND_BUDGET: u32 = 1 << 22;

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
    /// How it was translated, and is when it is reloaded.
    pub options: translate::Options,
    /// The format of the targets that it is for.
    pub format: Format,
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
    pub fn open(
        gpu: &Gpu,
        source: &Source,
        options: &translate::Options,
    ) -> Result<Self, OpenError> {
        Session::open_for(gpu, source, options, Format::Bytes)
    }

    /// The same for targets of this format.
    pub fn open_for(
        gpu: &Gpu,
        source: &Source,
        options: &translate::Options,
        format: Format,
    ) -> Result<Self, OpenError> {
        let start = Instant::now();
        let mut scene = scene::load(source)?;
        let loaded = Instant::now();
        let read = scene.read.clone();
        let in_scene = |report| OpenError::Scene {
            report,
            read: read.clone(),
        };
        require_drawable(&scene).map_err(in_scene)?;
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
        let mut programs = translate::translate(&scene, &options).map_err(in_scene)?;
        let diagnostics = warnings(&scene, &programs);
        leave_out(&mut scene, &mut programs);
        let translated = Instant::now();
        let renderer = Renderer::new(gpu, &scene, &programs, format)?;
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
            options,
            format,
            timing,
        })
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

    /// Opens the scene anew, with the options of the first time, and, if that succeeds, becomes the
    /// new one. On failure nothing changes:
    /// what was drawn before can go on.
    pub fn reload(&mut self, gpu: &Gpu, source: &Source) -> Result<(), OpenError> {
        *self = Session::open_for(gpu, source, &self.options, self.format)?;
        Ok(())
    }
}

fn warnings(scene: &Scene, programs: &[Program]) -> Vec<Diagnostic> {
    let of_programs = programs.iter().flat_map(|program| &program.warnings);
    scene.warnings.iter().chain(of_programs).cloned().collect()
}

/// Refuses a scene that needs what the renderer cannot do yet.
pub fn require_drawable(scene: &Scene) -> Result<(), Report> {
    let mut diagnostics = Vec::new();
    for pass in &scene.passes {
        let name = pass.kind.name();
        let own = pass.sources.last().map(|&file| {
            let whole = scene.files.whole(file);
            Span {
                end: whole.start,
                ..whole
            }
        });
        let mut refuse = |what: String| {
            diagnostics.push(Diagnostic {
                pass: Some(name.to_owned()),
                ..Diagnostic::error("not-drawable-yet", format!("{what} cannot be drawn yet"))
                    .at(own)
                    .hint("`vitrine check` and `vitrine translate` know all passes and inputs")
            });
        };
        if !matches!(pass.kind, PassKind::Image | PassKind::Buffer(_)) {
            refuse(format!("the pass {name}"));
            continue;
        }
        for (index, channel) in pass.channels.iter().enumerate() {
            match channel.as_ref().map(|channel| &channel.input) {
                None | Some(Input::Noise | Input::Buffer(_) | Input::Keyboard) => {}
                Some(input) => refuse(format!("what iChannel{index} reads, {},", input.name())),
            }
        }
    }
    if diagnostics.is_empty() {
        return Ok(());
    }
    Err(Report {
        files: scene.files.clone(),
        diagnostics,
    })
}

/// Leaves out the passes that the picture needs nothing of.
fn leave_out(scene: &mut Scene, programs: &mut Vec<Program>) {
    let mut needed: Vec<bool> = scene
        .passes
        .iter()
        .map(|pass| pass.kind == PassKind::Image)
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
                let Some(Input::Buffer(letter)) = channel.as_ref().map(|channel| &channel.input)
                else {
                    continue;
                };
                let is_read =
                    |other: &Pass| usage.texture && other.kind == PassKind::Buffer(*letter);
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
    let mut keep = needed.iter();
    scene
        .passes
        .retain(|_| *keep.next().expect("one for each pass"));
    let mut keep = needed.iter();
    programs.retain(|_| *keep.next().expect("one for each pass"));
}
