//! The interactive player: a window, its input, and the files behind the picture.
//!
//! The event loop is thin: it turns events into clock, mouse and frame input, and everything that
//! takes time (loading, translating, compiling) happens on another thread while the old picture
//! keeps moving.

mod app;
mod drawing;
mod findings;
mod hands;
mod input;
mod picture;
#[cfg(not(feature = "sound"))]
#[path = "silence.rs"]
mod sound;
#[cfg(feature = "sound")]
mod sound;
mod stage;
mod title;
mod watch;

use std::path::PathBuf;
use std::time::{Duration, Instant};

use glam::UVec2;
use winit::error::EventLoopError;
use winit::event_loop::EventLoop;

use crate::frame::Date;
use crate::render::{AdapterChoice, GpuError, Watchdog};
use crate::scene::Source;
use crate::session::{OpenError, Session, Setup};
use crate::source::Report;

/// What to play, and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene to begin with.
    pub source: Source,
    /// How to open it, also after changes, and every scene that follows it.
    pub setup: Setup,
    /// Size of the window's inside in pixels.
    pub size: UVec2,
    /// Pixels drawn for each pixel of the window's width and height.
    pub scale: f64,
    /// The most frames to draw in a second.
    pub fps_limit: Option<f64>,
    /// Whether to follow changes of the scene's files.
    pub watch: bool,
    /// The date of the first frame, if it is not today's.
    pub date: Option<Date>,
    /// Whether the scene's sound is not heard at first.
    pub mute: bool,
    /// Where mouse and keys are recorded, if they are.
    pub record: Option<Record>,
    /// The adapter to draw with.
    pub adapter: AdapterChoice,
}

/// A recording of mouse and keys.
#[derive(Clone, Debug)]
pub struct Record {
    /// The file.
    pub path: PathBuf,
    /// Whether it is replaced if it is there already.
    pub overwrite: bool,
}

/// Why there is no window any more, other than that it was closed.
#[derive(Debug)]
pub enum PlayError {
    /// The system gives no window.
    Window(String),
    /// Input cannot be recorded.
    Record {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: std::io::Error,
    },
    /// The driver failed.
    Gpu(GpuError),
    /// The first scene did not open.
    Open(OpenError),
}

impl From<GpuError> for PlayError {
    fn from(error: GpuError) -> Self {
        PlayError::Gpu(error)
    }
}

impl From<EventLoopError> for PlayError {
    fn from(error: EventLoopError) -> Self {
        let words = error.to_string();
        // winit begins with the place in its own source.
        let words = match words.split_once(".rs:") {
            Some((_, rest)) => rest.split_once(": ").map_or(rest, |(_, words)| words),
            None => &words,
        };
        PlayError::Window(words.to_owned())
    }
}

/// Every reason to wake up that does not come from the window itself.
#[derive(Debug)]
enum Wake {
    /// Files of the scene have changed, the first of them at this time.
    Changed { at: Instant },
    /// A scene has been opened on the side, or not.
    Opened(Box<Opened>),
    /// Something has gone wrong in a frame.
    Found(Report),
    /// A reloaded scene's first frame has been drawn.
    FirstFrame {
        reload: Reload,
        began: Instant,
        took: Duration,
    },
}

/// The outcome of opening a scene on the side.
#[derive(Debug)]
struct Opened {
    /// Counts the openings.
    number: u64,
    source: Source,
    result: Result<Session, OpenError>,
    /// When the change was saved, if this follows one.
    saved: Option<Instant>,
    began: Instant,
}

/// A good reload, on its way to its first frame.
#[derive(Clone, Debug)]
struct Reload {
    name: String,
    saved: Instant,
    /// From the save until loading began: the time in which the files came to rest.
    settle: Duration,
    translate: Duration,
    build: Duration,
    /// When the scene was ready to be drawn.
    ready: Instant,
}

/// Plays until the window is closed.
pub fn play(options: Options, watchdog: Watchdog) -> Result<(), PlayError> {
    let event_loop = EventLoop::<Wake>::with_user_event().build()?;
    let mut app = app::App::new(options, watchdog, event_loop.create_proxy());
    event_loop.run_app(&mut app)?;
    app.outcome()
}
