//! Hands frames to the device: at once while they are quick, else band by band, so that the window and the
//! desktop around it can be used meanwhile.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::frame::FrameInput;
use crate::render::{Gpu, Pace, Slot, Target};
use crate::session::Session;

/// A frame that is drawn at once and takes longer is one too many.
const SLOW: Duration = Duration::from_millis(500);

/// The frames of one session in one size.
pub(super) struct Drawing {
    pace: Pace,
    /// The frame of which not all bands have been handed over, and its next row.
    begun: Option<(FrameInput, u32)>,
    /// What has been handed over and is not done.
    under_way: Arc<AtomicU32>,
    /// How many rows the latest band to be done had, and how long they took.
    took: Arc<Mutex<Option<(u32, Duration)>>>,
}

impl Drawing {
    pub fn new(gpu: &Gpu, session: &Session, target: &Target) -> Self {
        let mut guards = session.programs.iter().map(|program| &program.guards);
        let may_be_endless = guards.any(|guards| !guards.loops.is_empty());
        Drawing {
            pace: match may_be_endless {
                true => Pace::new(gpu, target.size()),
                // The first frame comes sooner so.
                false => Pace::whole(gpu, target.size()),
            },
            begun: None,
            under_way: Arc::default(),
            took: Arc::default(),
        }
    }

    /// Begins anew with another session or target; what is under way stays so.
    pub fn renew(&mut self, gpu: &Gpu, session: &Session, target: &Target) {
        *self = Drawing {
            under_way: Arc::clone(&self.under_way),
            ..Drawing::new(gpu, session, target)
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
        self.begun = Some((*input, 0));
    }

    /// Hands over the next band of the frame that was begun. With the last one goes the slot that `slot` gives,
    /// and the frame is returned; `done` is then called when it is finished.
    pub fn go_on<'s>(
        &mut self,
        gpu: &Gpu,
        session: &Session,
        target: &Target,
        slot: impl FnOnce(&FrameInput) -> Option<&'s mut Slot>,
        done: impl FnOnce() + Send + 'static,
    ) -> Option<FrameInput> {
        let (input, from) = self.begun.take()?;
        self.learn();
        let height = target.size().y;
        let to = height.min(from + self.pace.rows());
        let is_last = to == height;
        let slot = if is_last { slot(&input) } else { None };
        let renderer = &session.renderer;
        let began = Instant::now();
        renderer.render_rows(gpu, &input, target, from..to, slot);
        self.under_way.fetch_add(1, Ordering::Relaxed);
        let (under_way, took) = (Arc::clone(&self.under_way), Arc::clone(&self.took));
        gpu.on_done(move || {
            *took.lock().unwrap_or_else(PoisonError::into_inner) =
                Some((to - from, began.elapsed()));
            under_way.fetch_sub(1, Ordering::Relaxed);
            if is_last {
                done();
            }
        });
        if is_last {
            return Some(input);
        }
        self.begun = Some((input, to));
        None
    }

    fn learn(&mut self) {
        let took = self
            .took
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        if let Some((rows, time)) = took
            && (!self.pace.is_whole() || time > SLOW)
        {
            self.pace.took(rows, time);
        }
    }
}
