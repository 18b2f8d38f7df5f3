//! One file a command: they call the library and talk to the person at the terminal.

mod check;
#[cfg(feature = "gpu")]
mod doctor;
mod exchange;
#[cfg(feature = "gpu")]
mod export;
#[cfg(feature = "gpu")]
mod findings;
mod inspect;
#[cfg(feature = "gpu")]
mod measure;
mod media;
#[cfg(feature = "gpu")]
mod opening;
#[cfg(feature = "gpu")]
mod progress;
#[cfg(feature = "window")]
mod run;
#[cfg(feature = "gpu")]
mod sound;
mod source;
#[cfg(feature = "gpu")]
mod stability;
mod translate;

use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use vitrine::report;
use vitrine::scene::{self, LoadError, LoadErrorKind, Scene, Source};
use vitrine::source::Report;
use vitrine::translate::{Options, Program};

use crate::cli::{self, Command};
use source::source;

/// Something is wrong with the scene.
pub const SCENE_HAS_PROBLEMS: u8 = 1;

/// Something is wrong around the scene: files, driver, window, command line.
pub const HOST_FAILED: u8 = 2;

/// The user ended it with Ctrl+C, as a shell reports that.
#[cfg(feature = "gpu")]
const INTERRUPTED: u8 = 130;

/// Runs a command. An error is the host's; a scene's problems have been printed already.
pub fn run(command: Command, started: Instant) -> anyhow::Result<ExitCode> {
    // Only an export says how long the whole program ran.
    let _ = started;
    match command {
        #[cfg(feature = "window")]
        Command::Run(args) => run::run(args),
        #[cfg(feature = "gpu")]
        Command::Export(args) => export::export(args, started),
        #[cfg(feature = "gpu")]
        Command::Measure(args) => measure::measure(args),
        #[cfg(feature = "gpu")]
        Command::Stability(args) => stability::stability(args),
        Command::Check(args) => check::check(args),
        Command::Translate(args) => translate::translate(args),
        Command::Inspect(args) => inspect::inspect(args),
        Command::Media(args) => media::media(args),
        Command::Import(args) => exchange::import(&args),
        Command::Pack(args) => exchange::pack(&args),
        #[cfg(feature = "gpu")]
        Command::Doctor => doctor::doctor(),
    }
}

/// Prints a failure of the host.
pub fn complain(error: &anyhow::Error) {
    report::tell(format!("{error:#}"));
}

/// An error whose message ends with the way out, in the form of the scenes' diagnostics.
fn failure(message: impl std::fmt::Display, hint: &str) -> anyhow::Error {
    let bold = "\u{1b}[1m";
    let (red, reset) = ("\u{1b}[1;91m", "\u{1b}[0m");
    match hint {
        "" => anyhow::anyhow!("{red}error{reset}{bold}: {message}{reset}"),
        hint => anyhow::anyhow!(
            "{red}error{reset}{bold}: {message}{reset}\n  |\n  = {bold}help{reset}: {hint}"
        ),
    }
}

/// A file that could not be written.
fn unwritable(path: &Path, error: &std::io::Error) -> anyhow::Error {
    // What follows the system's words names the file that is written aside.
    let words = error.to_string();
    let words = words.split(" at path").next().unwrap_or_default();
    failure(
        format!("cannot write `{}`: {words}", path.display()),
        "is there room on the disk, and may you write there?",
    )
}

fn unreadable(path: &Path, error: &std::io::Error) -> anyhow::Error {
    let hint = match error.kind() {
        std::io::ErrorKind::NotFound => {
            "a scene is a file of ShaderToy GLSL or JSON, a scene folder, a shader's address on the site, or `-` for standard input"
        }
        std::io::ErrorKind::PermissionDenied => "its permissions do not let you read it",
        _ => "",
    };
    failure(format!("cannot read `{}`: {error}", path.display()), hint)
}

/// Writes a result to standard output. Whoever reads it may have had enough, as `head` does.
fn print(text: &[u8]) -> anyhow::Result<()> {
    let mut stdout = std::io::stdout().lock();
    match stdout.write_all(text).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(failure(
            format!("cannot write to standard output: {error}"),
            "",
        )),
        _ => Ok(()),
    }
}

/// What became of a scene without a GPU.
enum Translation {
    Done(Scene, Vec<Program>),
    Problems(Report),
}

/// Loads a scene, or says what is wrong with it.
fn loaded(source: &Source) -> anyhow::Result<Result<Scene, Report>> {
    match scene::load(source) {
        Ok(scene) => Ok(Ok(scene)),
        Err(LoadError {
            kind: LoadErrorKind::Scene(report),
            ..
        }) => Ok(Err(report)),
        Err(LoadError {
            kind: LoadErrorKind::Io { path, error },
            ..
        }) => Err(unreadable(&path, &error)),
    }
}

/// Loads and translates a scene.
fn translated(source: &Source, options: &Options) -> anyhow::Result<Translation> {
    let scene = match loaded(source)? {
        Ok(scene) => scene,
        Err(report) => return Ok(Translation::Problems(report)),
    };
    Ok(match vitrine::translate::translate(&scene, options) {
        Ok(programs) => Translation::Done(scene, programs),
        Err(report) => Translation::Problems(report),
    })
}

/// How the command line wants a scene translated.
fn options(define: cli::DefineArgs) -> Options {
    Options {
        overrides: define.define,
        ..Options::default()
    }
}
