//! Pictures in floats, for those who measure or go on computing.

use glam::UVec2;

use super::{OpenError, Session};
use crate::frame::{FloatImage, FrameInput};
use crate::render::{Extras, Format, Gpu, GpuError, Pace, ReadBack, Slot, Target};
use crate::scene::Source;
use crate::translate;

/// One way to draw a scene, into floats: with some macros, in some precision, giving its colour or a
/// value from within.
#[derive(Debug)]
pub struct Subject {
    /// The scene.
    pub session: Session,
    target: Target,
    slot: Slot,
    /// How it is drawn in bands, if it is.
    pace: Option<Pace>,
}

/// A picture, and how long it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// What the shader gave.
    pub image: FloatImage,
    /// How long the device drew, if it can tell.
    pub seconds: Option<f64>,
    /// The words of findings, if the program looks for something.
    pub findings: Vec<u32>,
}

impl Subject {
    /// Opens a scene for pictures of one size.
    pub fn open(
        gpu: &Gpu,
        source: &Source,
        options: &translate::Options,
        size: UVec2,
    ) -> Result<Self, OpenError> {
        let session = Session::open_for(gpu, source, options, Format::Floats)?;
        let target = Target::new(gpu, size, Format::Floats)?;
        let extras = Extras {
            times: true,
            finding_words: session.renderer.finding_words(),
        };
        let mut ring = ReadBack::new(gpu, &target, 1, extras)?;
        let slot = ring.slots.pop().expect("one slot was asked for");
        Ok(Subject {
            session,
            target,
            slot,
            pace: None,
        })
    }

    /// From now on draws in bands, so that the device is never busy for long.
    pub fn draw_in_bands(&mut self, gpu: &Gpu) {
        self.pace = Some(Pace::new(gpu, self.target.size()));
    }

    /// How many components of its pixels mean something.
    pub fn components(&self) -> usize {
        let image = self.session.programs.last();
        image.map_or(4, |program| usize::from(program.components))
    }

    /// Draws one frame and waits for it. `waiting` is called now and then; it may end the program.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        input: &FrameInput,
        waiting: &mut dyn FnMut(),
    ) -> Result<Drawn, GpuError> {
        let renderer = &self.session.renderer;
        let slot = Some(&mut self.slot);
        match &mut self.pace {
            None => renderer.render(gpu, input, &self.target, slot),
            Some(pace) => {
                let mut between = || {
                    waiting();
                    true
                };
                renderer.render_in_bands(gpu, input, &self.target, slot, pace, &mut between)?;
            }
        }
        while !self.slot.is_ready(gpu)? {
            waiting();
        }
        let mut image = FloatImage::default();
        let transferred = self.slot.take_floats(gpu, &mut image)?;
        Ok(Drawn {
            image,
            seconds: transferred.gpu_seconds,
            findings: transferred.findings,
        })
    }
}
