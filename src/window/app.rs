use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use glam::{DVec2, UVec2};
use winit::application::ApplicationHandler;
use winit::dpi::{PhysicalPosition, PhysicalSize};
use winit::event::{ElementState, KeyEvent, MouseButton, StartCause, TouchPhase, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::keyboard::ModifiersState;
use winit::window::{Fullscreen, Window, WindowId};

use super::input::{self, Command};
use super::picture;
use super::title::Title;
use super::watch::FileWatch;
use super::{Opened, Options, PlayError, Reload, Wake};
use crate::frame::{Clock, FrameInput, Mouse};
use crate::render::{Gpu, Presented, Presenter, Target, Watchdog};
use crate::report;
use crate::scene::Source;
use crate::session::{OpenError, Session};
use crate::source::Report;

/// Frames handed to the GPU before waiting for the oldest.
const FRAMES_UNDER_WAY: u32 = 2;

/// How often to look whether the GPU has finished, where nothing else wakes the loop.
const GLANCE: Duration = Duration::from_millis(2);

/// How often the title bar is renewed.
const TITLE_EVERY: Duration = Duration::from_millis(250);

/// The event loop's state.
pub(super) struct App {
    options: Options,
    watchdog: Watchdog,
    wakes: EventLoopProxy<Wake>,
    watch: Option<FileWatch>,
    clock: Clock,
    mouse: Mouse,
    pointer: DVec2,
    modifiers: ModifiersState,
    stage: Option<Stage>,
    opening: OpeningState,
    failure: Option<PlayError>,
}

/// What exists once there is a window.
struct Stage {
    window: Arc<Window>,
    gpu: Arc<Gpu>,
    presenter: Presenter,
    target: Target,
    session: Session,
    /// The latest frame that was drawn.
    shown: Option<FrameInput>,
    /// Whether a frame should be drawn although time stands still.
    stale: bool,
    next_frame: Instant,
    under_way: Arc<AtomicU32>,
    /// The reload whose first frame is the next one.
    fresh: Option<Reload>,
    problem: Option<String>,
    titled: Instant,
}

/// Whether a scene is being opened on the side.
enum OpeningState {
    Idle,
    Busy,
    /// Files have changed again in the meantime.
    BusyAndStale(Instant),
}

impl App {
    pub fn new(options: Options, watchdog: Watchdog, wakes: EventLoopProxy<Wake>) -> Self {
        App {
            options,
            watchdog,
            wakes,
            watch: None,
            clock: Clock::default(),
            mouse: Mouse::default(),
            pointer: DVec2::ZERO,
            modifiers: ModifiersState::empty(),
            stage: None,
            opening: OpeningState::Idle,
            failure: None,
        }
    }

    /// How playing ended.
    pub fn outcome(self) -> Result<(), PlayError> {
        match self.failure {
            Some(failure) => Err(failure),
            None => Ok(()),
        }
    }

    fn fail(&mut self, event_loop: &ActiveEventLoop, failure: impl Into<PlayError>) {
        self.failure.get_or_insert(failure.into());
        event_loop.exit();
    }

    fn open_window(&mut self, event_loop: &ActiveEventLoop) -> Result<(), PlayError> {
        let UVec2 { x, y } = self.options.size;
        let attributes = Window::default_attributes()
            .with_title("Vitrine")
            .with_inner_size(PhysicalSize::new(x, y));
        let window = event_loop
            .create_window(attributes)
            .map_err(|error| PlayError::Window(error.to_string()))?;
        let window = Arc::new(window);
        let (gpu, presenter) = Presenter::open(
            &self.options.adapter,
            event_loop.owned_display_handle(),
            Arc::clone(&window),
            size_of(&window),
        )?;
        let target = Target::new(&gpu, picture_size(&gpu, &window, self.options.scale))?;
        let session = Session::open(&gpu, &self.options.source).map_err(PlayError::Open)?;
        show(&session.warnings);
        if self.options.watch {
            self.start_watching(&session.scene.read);
        }
        self.stage = Some(Stage {
            window,
            gpu: Arc::new(gpu),
            presenter,
            target,
            session,
            shown: None,
            stale: true,
            next_frame: Instant::now(),
            under_way: Arc::default(),
            fresh: None,
            problem: None,
            titled: Instant::now() - TITLE_EVERY,
        });
        Ok(())
    }

    fn start_watching(&mut self, files: &[PathBuf]) {
        let wakes = self.wakes.clone();
        // The loop is gone when the window is.
        let watch = FileWatch::start(move |at| drop(wakes.send_event(Wake::Changed { at })));
        match watch {
            Ok(mut watch) => {
                watch.follow(files);
                self.watch = Some(watch);
            }
            Err(error) => anstream::eprintln!("changes will not be noticed: {error}"),
        }
    }

    /// Lets the GPU's finished work call back.
    fn glance(&mut self) -> Result<(), PlayError> {
        if let Some(stage) = &self.stage {
            stage.gpu.poll();
            stage.gpu.check()?;
        }
        Ok(())
    }

    /// Draws a frame if it is time for one, and fills the window.
    fn redraw(&mut self) -> Result<(), PlayError> {
        let Some(stage) = &mut self.stage else {
            return Ok(());
        };
        let now = Instant::now();
        if !stage.wants_frame(&self.clock, now) {
            if self.clock.is_paused() && stage.shown.is_some() {
                stage.presenter.present(&stage.gpu, &stage.target)?;
            }
            return Ok(());
        }
        let mut input = self.clock.tick(stage.target.size());
        input.mouse = self.mouse.frame_value();
        self.watchdog.begin();
        let started = Instant::now();
        let Stage { gpu, session, .. } = stage;
        session.renderer.render(gpu, &input, &stage.target, None);
        self.mouse.frame_drawn();
        stage.shown = Some(input);
        stage.stale = false;
        stage.under_way.fetch_add(1, Ordering::Relaxed);
        let under_way = Arc::clone(&stage.under_way);
        let first = stage
            .fresh
            .take()
            .map(|reload| (reload, self.wakes.clone()));
        stage.gpu.on_done(move || {
            under_way.fetch_sub(1, Ordering::Relaxed);
            if let Some((reload, wakes)) = first {
                let took = started.elapsed();
                let _ = wakes.send_event(Wake::FirstFrame { reload, took });
            }
        });
        stage.window.pre_present_notify();
        if stage.presenter.present(&stage.gpu, &stage.target)? == Presented::Skipped {
            stage.stale = true;
            stage.next_frame = now + Duration::from_millis(16);
        } else if let Some(limit) = self.options.fps_limit {
            stage.next_frame = pace(stage.next_frame, now, Duration::from_secs_f64(1.0 / limit));
        }
        if self.clock.is_paused() {
            stage.title(&self.clock);
        }
        stage.gpu.check()?;
        Ok(())
    }

    /// Opens a scene on another thread; the answer is [`Wake::Opened`].
    fn open_aside(&mut self, source: Source, saved: Option<Instant>) {
        let Some(stage) = &self.stage else { return };
        let (gpu, wakes) = (Arc::clone(&stage.gpu), self.wakes.clone());
        self.opening = OpeningState::Busy;
        thread::spawn(move || {
            let began = Instant::now();
            let result = Session::open(&gpu, &source);
            let _ = wakes.send_event(Wake::Opened(Box::new(Opened {
                source,
                result,
                saved,
                began,
            })));
        });
    }

    fn changed(&mut self, at: Instant) {
        match self.opening {
            OpeningState::Idle => self.open_aside(self.options.source.clone(), Some(at)),
            OpeningState::Busy => self.opening = OpeningState::BusyAndStale(at),
            OpeningState::BusyAndStale(_) => {}
        }
    }

    fn opened(&mut self, opened: Opened) -> Result<(), PlayError> {
        let stale = match std::mem::replace(&mut self.opening, OpeningState::Idle) {
            OpeningState::BusyAndStale(at) => Some(at),
            _ => None,
        };
        let is_new = opened.source != self.options.source;
        match opened.result {
            Ok(session) => {
                let reload = opened.saved.map(|saved| Reload {
                    name: session.scene.name.clone(),
                    saved,
                    settle: opened.began - saved,
                    translate: session.timing.load + session.timing.translate,
                    build: session.timing.build,
                });
                show(&session.warnings);
                if let Some(watch) = &mut self.watch {
                    watch.follow(&session.scene.read);
                }
                self.options.source = opened.source;
                if is_new {
                    self.clock.reset();
                    self.mouse = Mouse::default();
                }
                if let Some(stage) = &mut self.stage {
                    stage.replace(session, reload);
                }
            }
            Err(OpenError::Gpu(error)) => {
                // What the driver will not take is the scene's fault as long as the device lives.
                if let Some(stage) = &self.stage {
                    stage.gpu.check()?;
                }
                self.tell(format!("{error}"), &format!("error: {error}\n"));
            }
            Err(OpenError::Io { path, error }) => {
                let problem = format!("cannot read {}: {error}", path.display());
                self.tell(problem.clone(), &format!("error: {problem}\n"));
            }
            Err(OpenError::Scene { report, read }) => {
                if let (Some(watch), false) = (&mut self.watch, is_new) {
                    let known = self.stage.as_ref().map(|stage| &stage.session.scene.read);
                    let all: Vec<PathBuf> =
                        known.into_iter().flatten().chain(&read).cloned().collect();
                    watch.follow(&all);
                }
                self.tell(first_line(&report), &report::human(&report));
            }
        }
        if let Some(at) = stale {
            self.changed(at);
        }
        Ok(())
    }

    /// Says what is wrong, in the terminal and in the title.
    fn tell(&mut self, problem: String, text: &str) {
        anstream::eprint!("{text}");
        if let Some(stage) = &mut self.stage {
            stage.problem = Some(problem);
            stage.title(&self.clock);
        }
    }

    fn obey(&mut self, event_loop: &ActiveEventLoop, command: Command) {
        let Some(stage) = &mut self.stage else { return };
        match command {
            Command::TogglePause => self.clock.set_paused(!self.clock.is_paused()),
            Command::Step(frames) => self.clock.step(frames),
            Command::Restart => self.clock.reset(),
            Command::ToggleFullScreen => {
                let full = match stage.window.fullscreen() {
                    Some(_) => None,
                    None => Some(Fullscreen::Borderless(None)),
                };
                stage.window.set_fullscreen(full);
            }
            Command::Save => {
                let time = stage.shown.map_or(0.0, |input| input.time);
                match picture::save(&stage.gpu, &stage.target, &stage.session.scene.name, time) {
                    Ok(path) => anstream::eprintln!("saved {}", path.display()),
                    Err(error) => anstream::eprintln!("not saved: {error}"),
                }
                return;
            }
            Command::Paste => {
                match clipboard() {
                    Ok(text) => self.open_aside(
                        Source::Text {
                            name: "<clipboard>".to_owned(),
                            bytes: text.into_bytes(),
                        },
                        None,
                    ),
                    Err(error) => anstream::eprintln!("nothing pasted: {error}"),
                }
                return;
            }
            Command::Leave => return event_loop.exit(),
        }
        stage.stale = true;
    }

    fn point(&mut self, at: PhysicalPosition<f64>) {
        self.pointer = DVec2::new(at.x, at.y);
        if let Some(pixel) = self.pixel() {
            self.mouse.moved(pixel);
        }
    }

    fn press(&mut self, down: bool) {
        match (down, self.pixel()) {
            (true, Some(pixel)) => self.mouse.press(pixel),
            _ => self.mouse.release(),
        }
        self.input_came();
    }

    fn pixel(&self) -> Option<glam::IVec2> {
        let stage = self.stage.as_ref()?;
        let window = size_of(&stage.window);
        Some(input::pixel_under(
            self.pointer,
            window,
            stage.target.size(),
        ))
    }

    /// While paused, input forces one redraw, as on the site.
    fn input_came(&mut self) {
        if let Some(stage) = &mut self.stage {
            stage.stale = true;
        }
    }

    fn resized(&mut self) -> Result<(), PlayError> {
        let Some(stage) = &mut self.stage else {
            return Ok(());
        };
        let size = size_of(&stage.window);
        // A minimised window has no pixels; it keeps the picture it had.
        if size.min_element() == 0 {
            return Ok(());
        }
        stage.presenter.resize(&stage.gpu, size);
        let picture = picture_size(&stage.gpu, &stage.window, self.options.scale);
        if picture != stage.target.size() {
            stage.target = Target::new(&stage.gpu, picture)?;
        }
        stage.stale = true;
        Ok(())
    }
}

impl Stage {
    fn wants_frame(&self, clock: &Clock, now: Instant) -> bool {
        let moving = !clock.is_paused() || self.stale;
        let free = self.under_way.load(Ordering::Relaxed) < FRAMES_UNDER_WAY;
        moving && free && now >= self.next_frame
    }

    /// The next frame is this scene's.
    fn replace(&mut self, session: Session, reload: Option<Reload>) {
        self.session = session;
        self.fresh = reload;
        self.problem = None;
        self.stale = true;
    }

    fn title(&mut self, clock: &Clock) {
        let title = Title {
            name: &self.session.scene.name,
            fps: self.shown.map_or(0.0, |input| input.frame_rate),
            time: self.shown.map_or(0.0, |input| input.time),
            resolution: self.target.size(),
            paused: clock.is_paused(),
            problem: self.problem.as_deref(),
        };
        self.window.set_title(&title.text());
        self.titled = Instant::now();
    }
}

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.stage.is_none()
            && let Err(error) = self.open_window(event_loop)
        {
            self.fail(event_loop, error);
        }
    }

    fn new_events(&mut self, event_loop: &ActiveEventLoop, _cause: StartCause) {
        if let Err(error) = self.glance() {
            self.fail(event_loop, error);
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, wake: Wake) {
        match wake {
            Wake::Changed { at } => self.changed(at),
            Wake::Opened(opened) => {
                if let Err(error) = self.opened(*opened) {
                    self.fail(event_loop, error);
                }
            }
            Wake::FirstFrame { reload, took } => anstream::eprintln!("{}", reload.line(took)),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::Resized(_) => {
                if let Err(error) = self.resized() {
                    self.fail(event_loop, error);
                }
            }
            WindowEvent::RedrawRequested => {
                if let Err(error) = self.redraw() {
                    self.fail(event_loop, error);
                }
            }
            WindowEvent::ModifiersChanged(modifiers) => self.modifiers = modifiers.state(),
            WindowEvent::KeyboardInput {
                event:
                    KeyEvent {
                        logical_key,
                        state: ElementState::Pressed,
                        repeat,
                        ..
                    },
                is_synthetic: false,
                ..
            } => match input::command(&logical_key, self.modifiers) {
                // Only stepping makes sense to hold down.
                Some(command) if !repeat || matches!(command, Command::Step(_)) => {
                    self.obey(event_loop, command);
                }
                _ => {}
            },
            WindowEvent::CursorMoved { position, .. } => self.point(position),
            WindowEvent::MouseInput {
                state,
                button: MouseButton::Left,
                ..
            } => self.press(state == ElementState::Pressed),
            WindowEvent::Touch(touch) => {
                self.point(touch.location);
                match touch.phase {
                    TouchPhase::Started => self.press(true),
                    TouchPhase::Moved => self.input_came(),
                    TouchPhase::Ended | TouchPhase::Cancelled => self.press(false),
                }
            }
            WindowEvent::DroppedFile(path) => self.open_aside(Source::Path(path), None),
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let Some(stage) = &mut self.stage else { return };
        let now = Instant::now();
        if now.duration_since(stage.titled) >= TITLE_EVERY && !self.clock.is_paused() {
            stage.title(&self.clock);
        }
        let busy = stage.under_way.load(Ordering::Relaxed) > 0;
        if !busy {
            self.watchdog.rest();
        }
        let moving = !self.clock.is_paused() || stage.stale;
        event_loop.set_control_flow(match (moving, busy) {
            (true, _) if stage.wants_frame(&self.clock, now) => {
                stage.window.request_redraw();
                ControlFlow::Wait
            }
            (_, true) => ControlFlow::WaitUntil(now + GLANCE),
            (true, false) => ControlFlow::WaitUntil(stage.next_frame),
            (false, false) => ControlFlow::Wait,
        });
    }
}

impl Reload {
    /// The line after a good reload. The driver compiles while building, and some drivers again in
    /// the first frame.
    fn line(&self, first_frame: Duration) -> String {
        let ms = |duration: Duration| duration.as_secs_f64() * 1000.0;
        format!(
            "reloaded {} in {:.0} ms: settle {:.0}, translate {:.0}, driver {:.0}, first frame {:.0}",
            self.name,
            ms(self.saved.elapsed()),
            ms(self.settle),
            ms(self.translate),
            ms(self.build),
            ms(first_frame),
        )
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

fn show(report: &Report) {
    anstream::eprint!("{}", report::human(report));
}

fn clipboard() -> Result<String, arboard::Error> {
    arboard::Clipboard::new()?.get_text()
}

/// What fits in a title: the first diagnostic's file, line and message.
fn first_line(report: &Report) -> String {
    let Some(first) = report.diagnostics.first() else {
        return String::new();
    };
    match first.span {
        Some(span) => {
            let file = report.files.get(span.file);
            let line = file.location(span.start).line;
            format!("{}:{line}: {}", file.name, first.message)
        }
        None => first.message.clone(),
    }
}
