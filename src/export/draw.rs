//! Frames on their way to the device: one behind the other while they are quick, else each by itself and band
//! by band, so that the machine can be used meanwhile and a frame without end can be given up.

use std::time::{Duration, Instant};

use crate::frame::FrameInput;
use crate::render::{Canvas, Gpu, GpuError, Pace, ReadBack, Slot, Watchdog};
use crate::session::Session;

use super::Job;

/// What frames are drawn with.
pub(super) struct Drawing<'a> {
    pub canvas: Canvas,
    gpu: &'a Gpu,
    session: &'a Session,
    watchdog: &'a Watchdog,
    pace: Pace,
}

/// What became of a frame.
pub(super) enum Outcome {
    /// It was handed over whole, or is done but for being read back.
    Drawn,
    /// It took longer than this limit. The words are the findings that it had so far.
    GivenUp(Duration, Vec<u32>),
}

impl<'a> Drawing<'a> {
    pub fn new(
        gpu: &'a Gpu,
        session: &'a Session,
        job: &Job,
        watchdog: &'a Watchdog,
    ) -> Result<Self, GpuError> {
        Ok(Drawing {
            canvas: session.renderer.canvas(gpu, job.size)?,
            gpu,
            session,
            watchdog,
            pace: Pace::new(gpu, job.size),
        })
    }

    /// Whether the next frame may be handed over while others are under way.
    pub fn is_quick(&self) -> bool {
        self.pace.is_whole()
    }

    /// Learns how long it took until a frame that was handed over was back.
    pub fn waited(&mut self, time: Duration) {
        // What was drawn in bands was waited for before.
        if self.is_quick() {
            self.pace.took(self.canvas.target.size().y, time);
        }
    }

    /// Draws a frame, which comes back through the slot if one is given. `waiting` is called now and then.
    pub fn draw(
        &mut self,
        input: &FrameInput,
        mut slot: Option<&mut Slot>,
        waiting: &mut dyn FnMut(),
    ) -> Result<Outcome, GpuError> {
        let Drawing {
            gpu,
            canvas,
            watchdog,
            ..
        } = self;
        let renderer = &self.session.renderer;
        // Of frames that do not come back it is not known when they are done.
        if let Some(slot) = &mut slot
            && self.pace.is_whole()
        {
            renderer.render(gpu, input, canvas, Some(slot));
            return Ok(Outcome::Drawn);
        }
        let began = Instant::now();
        let limit = watchdog.limit().unwrap_or(Duration::MAX);
        let mut between = || {
            watchdog.go_on();
            waiting();
            began.elapsed() < limit
        };
        let pace = &mut self.pace;
        let is_drawn = renderer.render_in_bands(gpu, input, canvas, slot, pace, &mut between)?;
        Ok(match is_drawn {
            true => Outcome::Drawn,
            false => Outcome::GivenUp(limit, self.findings_so_far()?),
        })
    }

    fn findings_so_far(&self) -> Result<Vec<u32>, GpuError> {
        let renderer = &self.session.renderer;
        let words = renderer.finding_words();
        if words == 0 {
            return Ok(Vec::new());
        }
        let mut slot = ReadBack::of_findings(self.gpu, words)?;
        renderer.copy_findings(self.gpu, &mut slot);
        while !slot.is_ready(self.gpu)? {}
        slot.take_findings(self.gpu)
    }
}
