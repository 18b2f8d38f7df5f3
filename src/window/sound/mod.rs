//! Plays the sound of scenes, and the music on their channels: a thread computes the samples of the sound on the GPU, a
//! little ahead of what is heard.

mod speaker;
mod tape;

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread;
use std::time::Duration;

use crate::render::Gpu;
use crate::report;
use crate::scene::{Input, Source};
use crate::session::{OpenError, Session, Setup, Track};
use tape::Tape;

/// How often the thread looks whether more samples are needed, which last for seconds.
const GLANCE: Duration = Duration::from_millis(100);

/// The sound of what is in the window.
pub(super) struct Sound {
    tape: Arc<Mutex<Tape>>,
    /// The device, once there was something to play.
    stream: Option<cpal::Stream>,
    /// The number of the scene that is heard. Threads that compute another one end.
    current: Arc<AtomicU64>,
}

impl Sound {
    pub fn new(is_muted: bool) -> Self {
        Sound {
            tape: Arc::new(Mutex::new(Tape::new(is_muted))),
            stream: None,
            current: Arc::default(),
        }
    }

    /// What is heard from now on is this scene, opened from there.
    pub fn play(&mut self, gpu: &Arc<Gpu>, session: &Session, source: &Source, setup: &Setup) {
        let number = self.current.fetch_add(1, Ordering::SeqCst) + 1;
        let (music, idle) = (session.inputs.sounds(), session.idle_music());
        let is_silent = music.is_empty() && idle.is_empty() && !session.has_sound();
        {
            let mut tape = lock(&self.tape);
            tape.set_music(music);
            // The sound that was computed last goes on until the next is there.
            if !session.has_sound() {
                tape.clear();
            }
        }
        if is_silent {
            return;
        }
        if self.stream.is_none() {
            match speaker::open(&self.tape) {
                Ok(stream) => self.stream = Some(stream),
                Err(error) => {
                    return report::tell(format_args!("the scene's sound is not heard: {error}"));
                }
            }
        }
        let worker = Worker {
            gpu: Arc::clone(gpu),
            tape: Arc::clone(&self.tape),
            number,
            current: Arc::clone(&self.current),
        };
        let has_sound = session.has_sound();
        let (source, setup) = (source.clone(), setup.clone());
        thread::spawn(move || {
            worker.load(&idle, &setup);
            if has_sound {
                worker.compute(&source, &setup);
            }
        });
    }

    /// The picture is at this time, in seconds, and goes on or stands still.
    pub fn follow(&self, time: f32, runs: bool) {
        lock(&self.tape).follow(time.into(), runs);
    }

    /// Whether it is silent now.
    pub fn toggle_mute(&self) -> bool {
        lock(&self.tape).toggle_mute()
    }
}

impl Drop for Sound {
    fn drop(&mut self) {
        self.current.fetch_add(1, Ordering::SeqCst);
    }
}

/// Loads and computes the samples of one scene.
struct Worker {
    gpu: Arc<Gpu>,
    tape: Arc<Mutex<Tape>>,
    number: u64,
    current: Arc<AtomicU64>,
}

impl Worker {
    fn is_current(&self) -> bool {
        self.current.load(Ordering::SeqCst) == self.number
    }

    fn load(&self, music: &[Input], setup: &Setup) {
        for input in music {
            match setup.library.recording(input) {
                Ok(Some(sound)) if self.is_current() => lock(&self.tape).add_music(sound),
                Ok(_) => {}
                Err(error) => {
                    report::tell(format_args!("the scene's music is not heard: {error}"));
                }
            }
        }
    }

    fn compute(&self, source: &Source, setup: &Setup) {
        let mut track = match Track::open(&self.gpu, source, setup) {
            Ok(Some(track)) => track,
            Err(OpenError::Gpu(error)) => return self.give_up(&error),
            // The file has changed since its picture was opened, and will be opened again.
            Ok(None) | Err(_) => return,
        };
        if self.is_current() {
            lock(&self.tape).begin();
        }
        while self.is_current() {
            let wanted = lock(&self.tape).wanted();
            let Some(block) = wanted else {
                thread::sleep(GLANCE);
                continue;
            };
            match track.block(&self.gpu, block as u32, &mut || self.is_current()) {
                Ok(Some(samples)) => {
                    let mut tape = lock(&self.tape);
                    if self.is_current() {
                        tape.put(block, samples);
                    }
                }
                Ok(None) => return,
                Err(error) => return self.give_up(&error),
            }
        }
    }

    fn give_up(&self, error: &dyn std::fmt::Display) {
        report::tell(format_args!(
            "the scene's sound cannot be computed: {error}"
        ));
    }
}

fn lock(tape: &Mutex<Tape>) -> MutexGuard<'_, Tape> {
    tape.lock().expect("no holder panics")
}
