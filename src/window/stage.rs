use std::sync::Arc;
use std::time::{Duration, Instant};

use glam::{DVec2, IVec2, UVec2};
use winit::dpi::PhysicalSize;
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};
use winit::window::{Fullscreen, Window};

use super::drawing::Drawing;
use super::findings::Gatherer;
use super::title::Title;
use super::{Options, PlayError, Reload, Wake, input};
use crate::frame::{Clock, FrameInput};
use crate::render::{Canvas, Gpu, Presented, Presenter};
use crate::session::Session;

/// Frames handed to a GPU before waiting for the oldest.
const FRAMES_UNDER_WAY: u32 = 2;

/// When to try again after the window took no picture, because it is hidden perhaps.
const AFTER_SKIP: Duration = Duration::from_millis(16);

/// How long a driver on the CPU is left to compile a new scene undisturbed: a frame of the old one would
/// take its cores, and be in the way of the new one's first.
const HUSH: Duration = Duration::from_millis(250);

/// How often the title bar is renewed while time runs.
const TITLE_EVERY: Duration = Duration::from_millis(250);

/// What exists once there is a window: the window, the GPU behind it, and the scene that is on.
pub(super) struct Stage {
    pub window: Arc<Window>,
    pub gpu: Arc<Gpu>,
    pub canvas: Canvas,
    pub session: Arc<Session>,
    /// The latest frame that was drawn.
    pub shown: Option<FrameInput>,
    /// Whether a frame should be drawn although time stands still.
    pub stale: bool,
    /// When the next frame is due, at the earliest.
    pub next_frame: Instant,
    /// When to try presenting again, after the window took no picture.
    present_after: Instant,
    presenter: Presenter,
    gatherer: Option<Gatherer>,
    options: Options,
    /// Whether the target holds a frame that the window has not been given.
    unpresented: bool,
    drawing: Drawing,
    /// When the latest frame was begun.
    began: Instant,
    /// The reload whose first frame is the next one.
    fresh: Option<Reload>,
    problem: Option<String>,
    titled: Option<Instant>,
}

impl Stage {
    /// Opens the window, an adapter that can draw to it, and the first scene.
    pub fn open(event_loop: &ActiveEventLoop, options: &Options) -> Result<Self, PlayError> {
        let UVec2 { x, y } = options.size;
        let attributes = Window::default_attributes()
            .with_title("Vitrine")
            .with_inner_size(PhysicalSize::new(x, y));
        let window = event_loop
            .create_window(attributes)
            .map_err(|error| PlayError::Window(error.to_string()))?;
        let window = Arc::new(window);
        let (gpu, presenter) = Presenter::open(
            &options.adapter,
            event_loop.owned_display_handle(),
            Arc::clone(&window),
            size_of(&window),
        )?;
        let session =
            Session::open(&gpu, &options.source, &options.setup).map_err(PlayError::Open)?;
        let size = picture_size(&gpu, &window, options.scale);
        let canvas = session.renderer.canvas(&gpu, size)?;
        Ok(Stage {
            drawing: Drawing::new(&gpu, &session, size),
            gatherer: Gatherer::new(&gpu, &session)?,
            window,
            gpu: Arc::new(gpu),
            canvas,
            session: Arc::new(session),
            shown: None,
            stale: true,
            next_frame: Instant::now(),
            present_after: Instant::now(),
            presenter,
            options: options.clone(),
            unpresented: false,
            began: Instant::now(),
            fresh: None,
            problem: None,
            titled: None,
        })
    }

    /// Width and height of the picture in pixels.
    pub fn size(&self) -> UVec2 {
        self.canvas.target.size()
    }

    /// Frames a second to be expected of a quick scene.
    pub fn rate(&self) -> f64 {
        let monitor = self.window.current_monitor();
        let display = monitor.and_then(|monitor| monitor.refresh_rate_millihertz());
        let display = display
            .map(|rate| f64::from(rate) / 1000.0)
            .filter(|&rate| rate >= 1.0);
        let display = display.unwrap_or(60.0);
        self.options
            .fps_limit
            .map_or(display, |limit| limit.min(display))
    }

    /// Another scene is being opened, or has been.
    pub fn set_opening(&mut self, is_opening: bool) {
        let now = Instant::now();
        self.next_frame = match is_opening && self.gpu.is_cpu() {
            true => self.next_frame.max(now + HUSH),
            false => self.next_frame.min(now),
        };
    }

    /// Whether the GPU is drawing.
    pub fn is_busy(&self) -> bool {
        self.drawing.under_way() > 0
    }

    /// Whether a frame should be drawn now.
    pub fn wants_frame(&self, clock: &Clock, now: Instant) -> bool {
        let moving = !clock.is_paused() || self.stale;
        let free = self.drawing.is_free() && self.drawing.under_way() < self.most_under_way();
        moving && free && !self.unpresented && now >= self.next_frame
    }

    /// Whether the next band of a frame should be drawn now.
    pub fn wants_band(&self) -> bool {
        self.drawing.wants_band()
    }

    /// Whether a frame that was drawn should be given to the window now.
    pub fn wants_present(&self, now: Instant) -> bool {
        self.unpresented && now >= self.present_after && !(self.presents_late() && self.is_busy())
    }

    /// When there is something to do again, if time alone decides that.
    pub fn next_event(&self, clock: &Clock) -> Option<Instant> {
        match self.unpresented {
            true => Some(self.present_after),
            false => (!clock.is_paused() || self.stale).then_some(self.next_frame),
        }
    }

    /// Drivers on the CPU do not return from presenting until the frame is drawn. The event loop
    /// cannot wait for that: such frames are presented once they are done.
    fn presents_late(&self) -> bool {
        self.gpu.is_cpu()
    }

    fn most_under_way(&self) -> u32 {
        match self.presents_late() {
            true => 1,
            false => FRAMES_UNDER_WAY,
        }
    }

    /// Draws a frame; it is given to the window now or when [`Stage::wants_present`] says so.
    pub fn draw(
        &mut self,
        input: &FrameInput,
        wakes: &EventLoopProxy<Wake>,
    ) -> Result<(), PlayError> {
        let started = Instant::now();
        self.began = started;
        self.drawing.begin(input);
        self.stale = false;
        if let Some(limit) = self.options.fps_limit {
            let period = Duration::from_secs_f64(1.0 / limit);
            self.next_frame = pace(self.next_frame, started, period);
        }
        self.draw_band(wakes)
    }

    /// Draws the next band of the frame that was begun: of a quick one, all of it.
    pub fn draw_band(&mut self, wakes: &EventLoopProxy<Wake>) -> Result<(), PlayError> {
        let gatherer = self.gatherer.as_mut();
        let slot = |input: &FrameInput| gatherer.and_then(|gatherer| gatherer.slot(input));
        let (began, wakes) = (self.began, wakes.clone());
        let fresh = self.fresh.clone();
        let done = move || {
            if let Some(reload) = fresh {
                let wake = Wake::FirstFrame {
                    reload,
                    began,
                    took: began.elapsed(),
                };
                // The loop is gone when the window is.
                let _ = wakes.send_event(wake);
            }
        };
        let drawing = &mut self.drawing;
        let drawn = drawing.go_on(&self.gpu, &self.session, &mut self.canvas, slot, done);
        let Some(input) = drawn else {
            return Ok(());
        };
        self.fresh = None;
        self.shown = Some(input);
        self.unpresented = true;
        match self.presents_late() {
            true => Ok(()),
            false => self.present(),
        }
    }

    /// Takes in what went wrong in the frames that are done.
    pub fn gather(&mut self, wakes: &EventLoopProxy<Wake>) -> Result<(), PlayError> {
        if let Some(gatherer) = &mut self.gatherer {
            gatherer.gather(&self.gpu, &self.session, wakes)?;
        }
        Ok(())
    }

    /// Gives the window the latest picture, also again where the system has lost it.
    pub fn present(&mut self) -> Result<(), PlayError> {
        if self.shown.is_none() {
            return Ok(());
        }
        self.window.pre_present_notify();
        match self.presenter.present(&self.gpu, &self.canvas.target)? {
            Presented::Shown => self.unpresented = false,
            Presented::Skipped => self.present_after = Instant::now() + AFTER_SKIP,
        }
        self.gpu.check()?;
        Ok(())
    }

    /// The next frame is this scene's.
    pub fn replace(&mut self, session: Session, reload: Option<Reload>) -> Result<(), PlayError> {
        self.gatherer = Gatherer::new(&self.gpu, &session)?;
        let size = self.size();
        // As on the site, buffers keep what they hold when a text is compiled anew.
        self.canvas = session.renderer.resized(&self.gpu, &self.canvas, size)?;
        self.unpresented = false;
        self.drawing.renew(&self.gpu, &session, size);
        self.session = Arc::new(session);
        self.fresh = reload;
        self.problem = None;
        self.titled = None;
        self.stale = true;
        Ok(())
    }

    /// Something is wrong with the scene's latest state.
    pub fn set_problem(&mut self, problem: String) {
        self.problem = Some(problem);
        self.titled = None;
    }

    /// Follows the window's size.
    pub fn resize(&mut self) -> Result<(), PlayError> {
        let size = size_of(&self.window);
        // A minimised window has no pixels; it keeps the picture it had.
        if size.min_element() == 0 {
            return Ok(());
        }
        self.presenter.resize(&self.gpu, size);
        let picture = picture_size(&self.gpu, &self.window, self.options.scale);
        if picture != self.size() {
            let renderer = &self.session.renderer;
            self.canvas = renderer.resized(&self.gpu, &self.canvas, picture)?;
            self.drawing.renew(&self.gpu, &self.session, picture);
            // The new one holds nothing yet.
            self.unpresented = false;
        }
        self.stale = true;
        Ok(())
    }

    pub fn toggle_full_screen(&self) {
        self.window.set_fullscreen(match self.window.fullscreen() {
            Some(_) => None,
            None => Some(Fullscreen::Borderless(None)),
        });
    }

    /// The picture's pixel under a point of the window.
    pub fn pixel_under(&self, point: DVec2) -> IVec2 {
        input::pixel_under(point, size_of(&self.window), self.size())
    }

    /// Renews the title bar if what it says may have changed.
    pub fn renew_title(&mut self, clock: &Clock) {
        let is_due = |at: Instant| at.elapsed() >= TITLE_EVERY && !clock.is_paused();
        if !self.titled.is_none_or(is_due) {
            return;
        }
        let title = Title {
            name: &self.session.scene.name,
            fps: self.shown.map_or(0.0, |input| input.frame_rate),
            time: self.shown.map_or(0.0, |input| input.time),
            resolution: self.size(),
            paused: clock.is_paused(),
            problem: self.problem.as_deref(),
        };
        self.window.set_title(&title.text());
        self.titled = Some(Instant::now());
    }

    /// What the title says is no longer so.
    pub fn title_changed(&mut self) {
        self.titled = None;
    }
}

/// When the next frame is due: one period after the last was, unless that is past already.
fn pace(due: Instant, now: Instant, period: Duration) -> Instant {
    let next = due + period;
    if next > now { next } else { now + period }
}

fn size_of(window: &Window) -> UVec2 {
    let size = window.inner_size();
    UVec2::new(size.width, size.height)
}

fn picture_size(gpu: &Gpu, window: &Window, scale: f64) -> UVec2 {
    let scaled = (size_of(window).as_dvec2() * scale).round().as_uvec2();
    scaled.clamp(UVec2::ONE, UVec2::splat(gpu.max_size()))
}
