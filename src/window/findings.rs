//! What goes wrong in the frames of a window: noticed behind each frame, looked at on the side, told once.

use std::sync::Arc;
use std::thread;

use winit::event_loop::EventLoopProxy;

use super::Wake;
use crate::frame::FrameInput;
use crate::render::{Gpu, GpuError, ReadBack, Slot};
use crate::session::{Findings, Session};

/// Gathers what the frames of one session find.
pub(super) struct Gatherer {
    slot: Slot,
    /// The frame whose findings the slot waits for.
    awaited: Option<FrameInput>,
    findings: Findings,
}

impl Gatherer {
    /// For a session that looks for something.
    pub fn new(gpu: &Gpu, session: &Session) -> Result<Option<Self>, GpuError> {
        let words = session.renderer.finding_words();
        if words == 0 {
            return Ok(None);
        }
        Ok(Some(Gatherer {
            slot: ReadBack::of_findings(gpu, words)?,
            awaited: None,
            findings: Findings::default(),
        }))
    }

    /// The slot for a frame, unless it waits for that of another.
    pub fn slot(&mut self, input: &FrameInput) -> Option<&mut Slot> {
        if self.awaited.is_some() {
            return None;
        }
        self.awaited = Some(*input);
        Some(&mut self.slot)
    }

    /// Takes in what has come back. What is new is looked at on another thread, which then wakes the loop.
    pub fn gather(
        &mut self,
        gpu: &Arc<Gpu>,
        session: &Arc<Session>,
        wakes: &EventLoopProxy<Wake>,
    ) -> Result<(), GpuError> {
        let Some(input) = self.awaited else {
            return Ok(());
        };
        if !self.slot.has_come_back()? {
            return Ok(());
        }
        self.awaited = None;
        let words = self.slot.take_findings(gpu)?;
        let within = format!("iTime = {}", input.time);
        self.findings
            .note(&session.programs, &words, &input, &within);
        let mut new = self.findings.take_new();
        if new.is_empty() {
            return Ok(());
        }
        let (gpu, session, wakes) = (Arc::clone(gpu), Arc::clone(session), wakes.clone());
        thread::spawn(move || {
            // Without operands there is still something to say.
            let _ = new.find_operands(&gpu, &session);
            // The loop is gone when the window is.
            let _ = wakes.send_event(Wake::Found(new.report(&session)));
        });
        Ok(())
    }
}
