//! Hands frames to the device: at once while they are quick, else band by band, so that the window and the
//! desktop around it can be used meanwhile.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use glam::UVec2;

use crate::frame::FrameInput;
use crate::render::{Canvas, Cursor, Gpu, Pace, Slot};
use crate::session::Session;

/// The frames of one session in one size.
pub(super) struct Drawing {
    pace: Pace,
    /// The frame of which not all bands have been handed over, and where it goes on.
    begun: Option<(FrameInput, Cursor)>,
    /// What has been handed over and is not done.
    under_way: Arc<AtomicU32>,
    /// How many rows the latest band to be done had, and how long they took.
    took: Arc<Mutex<Option<(u32, Duration)>>>,
}

impl Drawing {
    pub fn new(gpu: &Gpu, session: &Session, size: UVec2) -> Self {
        let mut guards = session.programs.iter().map(|program| &program.guards);
        let may_be_endless = guards.any(|guards| !guards.loops.is_empty());
        Drawing {
            pace: match may_be_endless {
                true => Pace::new(gpu, size),
                // The first frame comes sooner so.
                false => Pace::whole(gpu, size),
            },
            begun: None,
            under_way: Arc::default(),
            took: Arc::default(),
        }
    }

    /// Begins anew with another session or size; what is under way stays so.
    pub fn renew(&mut self, gpu: &Gpu, session: &Session, size: UVec2) {
        *self = Drawing {
            under_way: Arc::clone(&self.under_way),
            ..Drawing::new(gpu, session, size)
        };
    }

    /// How many frames or bands the device is busy with.
    pub fn under_way(&self) -> u32 {
        self.under_way.load(Ordering::Relaxed)
    }

    /// Whether a frame waits for its next band, and the device for something to do.
    pub fn wants_band(&self) -> bool {
        self.begun.is_some() && self.under_way() == 0
    }

    /// Whether no frame waits for its next band.
    pub fn is_free(&self) -> bool {
        self.begun.is_none()
    }

    /// Begins with a frame.
    pub fn begin(&mut self, input: &FrameInput) {
        self.begun = Some((*input, Cursor::default()));
    }

    /// Hands over the next band of the frame that was begun. With the last one goes the slot that `slot` gives,
    /// and the frame is returned; `done` is then called when it is finished.
    pub fn go_on<'s>(
        &mut self,
        gpu: &Gpu,
        session: &Session,
        canvas: &mut Canvas,
        slot: impl FnOnce(&FrameInput) -> Option<&'s mut Slot>,
        done: impl FnOnce() + Send + 'static,
    ) -> Option<FrameInput> {
        let (input, from) = self.begun.take()?;
        self.learn();
        let renderer = &session.renderer;
        let rows = renderer.rows_from(canvas, from, self.pace.rows());
        let is_whole = self.pace.is_whole() && from == Cursor::default();
        let slot = match is_whole || renderer.is_last_band(canvas, from, rows) {
            true => slot(&input),
            false => None,
        };
        let began = Instant::now();
        let next = if is_whole {
            renderer.render(gpu, &input, canvas, slot);
            None
        } else {
            let band = renderer.render_band(gpu, &input, canvas, from, rows, slot);
            band.1
        };
        self.under_way.fetch_add(1, Ordering::Relaxed);
        let (under_way, took) = (Arc::clone(&self.under_way), Arc::clone(&self.took));
        let is_last = next.is_none();
        gpu.on_done(move || {
            *took.lock().unwrap_or_else(PoisonError::into_inner) = Some((rows, began.elapsed()));
            under_way.fetch_sub(1, Ordering::Relaxed);
            if is_last {
                done();
            }
        });
        self.begun = next.map(|next| (input, next));
        is_last.then_some(input)
    }

    fn learn(&mut self) {
        let took = self
            .took
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        if let Some((rows, time)) = took {
            self.pace.took(rows, time);
        }
    }
}
