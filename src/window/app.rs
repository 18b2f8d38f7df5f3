use std::path::PathBuf;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use glam::DVec2;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalPosition;
use winit::event::{ElementState, KeyEvent, MouseButton, StartCause, TouchPhase, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::keyboard::{Key, ModifiersState};
use winit::window::WindowId;

use super::hands::Hands;
use super::input::{self, Command};
use super::sound::Sound;
use super::stage::Stage;
use super::watch::FileWatch;
use super::{Opened, Options, PlayError, Reload, Wake, picture};
use crate::frame::Clock;
use crate::render::Watchdog;
use crate::report;
use crate::scene::Source;
use crate::session::{OpenError, Session};
use crate::source::Report;

/// How often to look whether the GPU has finished, where nothing else wakes the loop.
const GLANCE: Duration = Duration::from_millis(2);

/// The event loop's state.
pub(super) struct App {
    options: Options,
    watchdog: Watchdog,
    wakes: EventLoopProxy<Wake>,
    watch: Option<FileWatch>,
    clock: Clock,
    hands: Hands,
    pointer: DVec2,
    modifiers: ModifiersState,
    stage: Option<Stage>,
    sound: Sound,
    opening: Opening,
    /// The number of the latest opening; answers to older ones no longer count.
    latest_opening: u64,
    failure: Option<PlayError>,
}

/// Whether a scene is being opened on the side.
enum Opening {
    Idle,
    Busy,
    /// Files have changed again in the meantime, first at this time.
    BusyAndStale(Instant),
}

impl App {
    pub fn new(options: Options, watchdog: Watchdog, wakes: EventLoopProxy<Wake>) -> Self {
        App {
            clock: options.date.map_or_else(Clock::default, Clock::from_date),
            sound: Sound::new(options.mute),
            options,
            watchdog,
            wakes,
            watch: None,
            hands: Hands::default(),
            pointer: DVec2::ZERO,
            modifiers: ModifiersState::empty(),
            stage: None,
            opening: Opening::Idle,
            latest_opening: 0,
            failure: None,
        }
    }

    /// How playing ended.
    pub fn outcome(self) -> Result<(), PlayError> {
        self.hands.finish();
        match self.failure {
            Some(failure) => Err(failure),
            None => Ok(()),
        }
    }

    /// Ends the loop if something failed that it cannot go on without.
    fn expect(&mut self, event_loop: &ActiveEventLoop, result: Result<(), PlayError>) {
        if let Err(failure) = result {
            self.failure.get_or_insert(failure);
            event_loop.exit();
        }
    }

    fn open_window(&mut self, event_loop: &ActiveEventLoop) -> Result<(), PlayError> {
        // The driver compiles here, which may take it long or for ever.
        self.watchdog.begin();
        let stage = Stage::open(event_loop, &self.options)?;
        self.watchdog.rest();
        if let Some(record) = &self.options.record {
            self.hands.record(record, stage.size(), stage.rate())?;
        }
        report::show(&stage.session.warnings);
        if self.options.watch {
            self.start_watching(&stage.session.scene.read);
        }
        let Options { source, setup, .. } = &self.options;
        self.sound.play(&stage.gpu, &stage.session, source, setup);
        self.stage = Some(stage);
        Ok(())
    }

    fn start_watching(&mut self, files: &[PathBuf]) {
        let wakes = self.wakes.clone();
        let watch = FileWatch::start(move |at| {
            // The loop is gone when the window is.
            let _ = wakes.send_event(Wake::Changed { at });
        });
        match watch {
            Ok(mut watch) => {
                watch.follow(files);
                self.watch = Some(watch);
            }
            Err(error) => report::tell(format_args!("changes will not be noticed: {error}")),
        }
    }

    /// Lets the GPU's finished work call back.
    fn glance(&mut self) -> Result<(), PlayError> {
        if let Some(stage) = &mut self.stage {
            stage.gpu.poll();
            stage.gpu.check()?;
            stage.gather(&self.wakes)?;
        }
        Ok(())
    }

    /// Draws a frame if it is time for one, and fills the window.
    fn redraw(&mut self) -> Result<(), PlayError> {
        let Some(stage) = &mut self.stage else {
            return Ok(());
        };
        let now = Instant::now();
        let is_lost = self.clock.is_paused() && !stage.stale;
        if stage.wants_present(now) || is_lost {
            stage.present()?;
        }
        if stage.wants_band() {
            self.watchdog.go_on();
            stage.draw_band(&self.wakes)?;
        } else if stage.wants_frame(&self.clock, now) {
            let mut input = self.clock.tick(stage.size());
            self.hands.give(&mut input);
            self.sound.follow(input.time, !self.clock.is_paused());
            self.watchdog.begin();
            if self.clock.is_paused() {
                stage.title_changed();
            }
            stage.draw(&input, &self.wakes)?;
        }
        Ok(())
    }

    /// Opens a scene on another thread; the answer is [`Wake::Opened`].
    fn open_aside(&mut self, source: Source, saved: Option<Instant>) {
        let Some(stage) = &mut self.stage else {
            return;
        };
        stage.set_opening(true);
        let (gpu, wakes) = (Arc::clone(&stage.gpu), self.wakes.clone());
        self.opening = Opening::Busy;
        self.latest_opening += 1;
        let number = self.latest_opening;
        let setup = self.options.setup.clone();
        thread::spawn(move || {
            let began = Instant::now();
            let result = Session::open(&gpu, &source, &setup);
            let opened = Opened {
                number,
                source,
                result,
                saved,
                began,
            };
            // The loop is gone when the window is.
            let _ = wakes.send_event(Wake::Opened(Box::new(opened)));
        });
    }

    fn changed(&mut self, at: Instant) {
        match self.opening {
            Opening::Idle => self.open_aside(self.options.source.clone(), Some(at)),
            Opening::Busy => self.opening = Opening::BusyAndStale(at),
            Opening::BusyAndStale(_) => {}
        }
    }

    fn opened(&mut self, opened: Opened) -> Result<(), PlayError> {
        if opened.number != self.latest_opening {
            return Ok(());
        }
        if let Some(stage) = &mut self.stage {
            stage.set_opening(false);
        }
        let opening = std::mem::replace(&mut self.opening, Opening::Idle);
        let is_new = opened.source != self.options.source;
        match opened.result {
            Ok(session) => {
                let reload = opened.saved.map(|saved| Reload {
                    name: session.scene.name.clone(),
                    saved,
                    settle: opened.began - saved,
                    translate: session.timing.load + session.timing.translate,
                    build: session.timing.build,
                    ready: opened.began + session.timing.total(),
                });
                self.options.source = opened.source;
                self.take(session, reload, is_new)?;
            }
            Err(error) => self.refuse(error, is_new)?,
        }
        if let Opening::BusyAndStale(at) = opening {
            self.changed(at);
        }
        Ok(())
    }

    /// The scene on stage is this one from now on. Time runs on, unless it is another scene.
    fn take(
        &mut self,
        session: Session,
        reload: Option<Reload>,
        is_new: bool,
    ) -> Result<(), PlayError> {
        report::show(&session.warnings);
        if let Some(watch) = &mut self.watch {
            watch.follow(&session.scene.read);
        }
        if is_new {
            self.clock.reset();
            self.hands.let_go();
        }
        if let Some(stage) = &mut self.stage {
            let Options { source, setup, .. } = &self.options;
            self.sound.play(&stage.gpu, &session, source, setup);
            stage.replace(session, reload)?;
        }
        Ok(())
    }

    /// Says what is wrong, in the terminal and in the title; the scene on stage stays.
    fn refuse(&mut self, error: OpenError, is_new: bool) -> Result<(), PlayError> {
        let Some(stage) = &mut self.stage else {
            return Ok(());
        };
        let problem = match error {
            OpenError::Scene { report, read } => {
                report::show(&report);
                if let (Some(watch), false) = (&mut self.watch, is_new) {
                    let known = stage.session.scene.read.iter();
                    let files: Vec<PathBuf> = known.chain(&read).cloned().collect();
                    watch.follow(&files);
                }
                first_line(&report)
            }
            OpenError::Io { path, error } => {
                let problem = format!("cannot read {}: {error}", path.display());
                report::tell(format_args!("error: {problem}"));
                problem
            }
            OpenError::Gpu(error) => {
                // What the driver will not take is the scene's fault as long as the device lives.
                stage.gpu.check()?;
                report::tell(format_args!("error: {error}\n  = help: {}", error.hint()));
                error.to_string()
            }
        };
        stage.set_problem(problem);
        Ok(())
    }

    fn obey(&mut self, event_loop: &ActiveEventLoop, command: Command) {
        match command {
            Command::TogglePause => {
                self.clock.set_paused(!self.clock.is_paused());
                let time = self.stage.as_ref().and_then(|stage| stage.shown);
                let time = time.map_or(0.0, |input| input.time);
                self.sound.follow(time, !self.clock.is_paused());
            }
            Command::ToggleMute => {
                let words = if self.sound.toggle_mute() {
                    "off"
                } else {
                    "on"
                };
                report::tell(format_args!("sound is {words}"));
            }
            Command::Step(frames) if frames < 0 && self.hands.is_recording() => {
                report::tell("there is no way back while input is recorded, but to the start");
            }
            Command::Step(frames) => self.clock.step(frames),
            Command::Restart => {
                self.clock.reset();
                self.hands.restart();
            }
            Command::ToggleFullScreen => {
                if let Some(stage) = &self.stage {
                    stage.toggle_full_screen();
                }
            }
            Command::Save => self.save(),
            Command::Paste => match clipboard() {
                Ok(source) => self.open_aside(source, None),
                Err(error) => report::tell(format_args!("nothing pasted: {error}")),
            },
            Command::Leave => event_loop.exit(),
        }
        self.input_came();
    }

    /// A key went down or up: a command, or something for a scene that reads the keyboard.
    fn key(
        &mut self,
        event_loop: &ActiveEventLoop,
        key: &Key,
        state: ElementState,
        is_repeated: bool,
    ) {
        let stage = self.stage.as_ref();
        let is_scenes = stage.is_some_and(|stage| stage.session.reads_keyboard());
        let is_down = state == ElementState::Pressed;
        let command = input::command(key, self.modifiers, is_scenes).filter(|_| is_down);
        match (command, input::key_code(key)) {
            // Only stepping makes sense to hold down.
            (Some(command), _) if !is_repeated || matches!(command, Command::Step(_)) => {
                self.obey(event_loop, command);
            }
            (None, Some(code)) if is_scenes => {
                self.hands.key(code, is_down);
                self.input_came();
            }
            _ => {}
        }
    }

    fn save(&self) {
        let Some(stage) = &self.stage else { return };
        let time = stage.shown.map_or(0.0, |input| input.time);
        match picture::save(
            &stage.gpu,
            &stage.canvas.target,
            &stage.session.scene.name,
            time,
        ) {
            Ok(path) => report::tell(format_args!("saved {}", path.display())),
            Err(error) => report::tell(format_args!("not saved: {error}")),
        }
    }

    fn point(&mut self, at: PhysicalPosition<f64>) {
        self.pointer = DVec2::new(at.x, at.y);
        if let Some(stage) = &self.stage {
            self.hands
                .moved(stage.pixel_under(self.pointer), stage.size());
        }
        if self.hands.is_dragging() {
            self.input_came();
        }
    }

    fn press(&mut self, is_down: bool) {
        match &self.stage {
            Some(stage) if is_down => {
                let at = stage.pixel_under(self.pointer);
                self.hands.press(at, stage.size());
            }
            _ => self.hands.release(),
        }
        self.input_came();
    }

    /// While paused, input forces one redraw, as on the site.
    fn input_came(&mut self) {
        if let Some(stage) = &mut self.stage {
            stage.stale = true;
        }
    }
}

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.stage.is_none() {
            let opened = self.open_window(event_loop);
            self.expect(event_loop, opened);
        }
    }

    fn new_events(&mut self, event_loop: &ActiveEventLoop, _cause: StartCause) {
        let looked = self.glance();
        self.expect(event_loop, looked);
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, wake: Wake) {
        match wake {
            Wake::Changed { at } => self.changed(at),
            Wake::Found(report) => report::show(&report),
            Wake::Opened(opened) => {
                let taken = self.opened(*opened);
                self.expect(event_loop, taken);
            }
            Wake::FirstFrame {
                reload,
                began,
                took,
            } => report::tell(reload.line(began, took)),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                let drawn = self.redraw();
                self.expect(event_loop, drawn);
            }
            WindowEvent::Resized(_) => {
                let resized = self.stage.as_mut().map_or(Ok(()), Stage::resize);
                self.expect(event_loop, resized);
            }
            WindowEvent::ModifiersChanged(modifiers) => self.modifiers = modifiers.state(),
            WindowEvent::KeyboardInput {
                event:
                    KeyEvent {
                        logical_key,
                        state,
                        repeat,
                        ..
                    },
                is_synthetic: false,
                ..
            } => self.key(event_loop, &logical_key, state, repeat),
            // What is released elsewhere is not seen.
            WindowEvent::Focused(false) => self.hands.release_keys(),
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
                    TouchPhase::Moved => {}
                    TouchPhase::Ended | TouchPhase::Cancelled => self.press(false),
                }
            }
            WindowEvent::DroppedFile(path) => self.open_aside(Source::Path(path), None),
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let Some(stage) = &mut self.stage else { return };
        stage.renew_title(&self.clock);
        let is_busy = stage.is_busy();
        if !is_busy && !stage.wants_band() {
            self.watchdog.rest();
        }
        let now = Instant::now();
        let wants_redraw =
            stage.wants_present(now) || stage.wants_band() || stage.wants_frame(&self.clock, now);
        event_loop.set_control_flow(if wants_redraw {
            stage.window.request_redraw();
            ControlFlow::Wait
        } else if is_busy {
            ControlFlow::WaitUntil(now + GLANCE)
        } else {
            stage
                .next_event(&self.clock)
                .map_or(ControlFlow::Wait, ControlFlow::WaitUntil)
        });
    }
}

impl Reload {
    /// The line after a good reload. The driver compiles while building, and some drivers again in
    /// the first frame, which waits for the old scene's frame under way.
    fn line(&self, began: Instant, first_frame: Duration) -> String {
        let ms = |duration: Duration| duration.as_secs_f64() * 1000.0;
        format!(
            "reloaded {} in {:.0} ms: settle {:.0}, translate {:.0}, driver {:.0}, wait {:.0}, \
             first frame {:.0}",
            self.name,
            ms(began + first_frame - self.saved),
            ms(self.settle),
            ms(self.translate),
            ms(self.build),
            ms(began - self.ready),
            ms(first_frame),
        )
    }
}

fn clipboard() -> Result<Source, arboard::Error> {
    let text = arboard::Clipboard::new()?.get_text()?;
    Ok(Source::Text {
        name: "<clipboard>".to_owned(),
        bytes: text.into_bytes(),
    })
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
