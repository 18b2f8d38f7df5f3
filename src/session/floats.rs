//! Pictures in floats, for those who measure or go on computing.

use glam::UVec2;

use super::{OpenError, Session, Setup};
use crate::frame::{FloatImage, FrameInput};
use crate::render::{Canvas, Extras, Format, Gpu, GpuError, Pace, ReadBack, Slot};
use crate::scene::Source;

/// The most frames that are drawn before one, of a scene whose buffers remember them.
const MOST_BEFORE: i32 = 60;

/// One way to draw a scene, into floats: with some macros, in some precision, giving its colour or a
/// value from within.
#[derive(Debug)]
pub struct Subject {
    /// The scene.
    pub session: Session,
    canvas: Canvas,
    slot: Slot,
    /// `iFrame` of what was drawn last.
    last: Option<i32>,
    /// How it is drawn in bands, if it is.
    pace: Option<Pace>,
}

/// What someone is told while a frame is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moment {
    /// The device is busy.
    Waiting,
    /// One of the frames before is done.
    FrameDone,
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
    pub fn open(gpu: &Gpu, source: &Source, setup: &Setup, size: UVec2) -> Result<Self, OpenError> {
        let setup = Setup {
            format: Format::Floats,
            ..setup.clone()
        };
        let session = Session::open(gpu, source, &setup)?;
        let canvas = session.renderer.canvas(gpu, size)?;
        let extras = Extras {
            timed_passes: session.renderer.pass_count(),
            finding_words: session.renderer.finding_words(),
        };
        let mut ring = ReadBack::new(gpu, &canvas.target, 1, extras)?;
        let slot = ring.slots.pop().expect("one slot was asked for");
        Ok(Subject {
            session,
            canvas,
            slot,
            last: None,
            pace: None,
        })
    }

    /// From now on draws in bands, so that the device is never busy for long.
    pub fn draw_in_bands(&mut self, gpu: &Gpu) {
        self.pace = Some(Pace::new(gpu, self.canvas.target.size()));
    }

    /// How many components of its pixels mean something.
    pub fn components(&self) -> usize {
        let image = self.session.programs.last();
        image.map_or(4, |program| usize::from(program.components))
    }

    /// Draws one frame and waits for it, after those before where buffers remember them. `tell` is called now and
    /// then; it may end the program.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        input: &FrameInput,
        tell: &mut dyn FnMut(Moment),
    ) -> Result<Drawn, GpuError> {
        let is_next = self
            .last
            .is_some_and(|last| last.checked_add(1) == Some(input.frame));
        let feeds_back = self.session.renderer.feeds_back() && !is_next;
        for before in frames_before(input, feeds_back) {
            self.hand_over(gpu, &before, false, tell)?;
            tell(Moment::FrameDone);
        }
        self.last = Some(input.frame);
        self.hand_over(gpu, input, true, tell)?;
        while !self.slot.is_ready(gpu)? {
            tell(Moment::Waiting);
        }
        let mut image = FloatImage::default();
        let transferred = self.slot.take_floats(gpu, &mut image)?;
        Ok(Drawn {
            image,
            seconds: transferred.gpu_seconds,
            findings: transferred.findings,
        })
    }

    /// Hands a frame to the device; one that is not wanted itself is waited for.
    fn hand_over(
        &mut self,
        gpu: &Gpu,
        input: &FrameInput,
        is_wanted: bool,
        tell: &mut dyn FnMut(Moment),
    ) -> Result<(), GpuError> {
        let renderer = &self.session.renderer;
        let (canvas, slot) = (&mut self.canvas, is_wanted.then_some(&mut self.slot));
        match &mut self.pace {
            None => renderer.render(gpu, input, canvas, slot),
            Some(pace) => {
                let mut between = || {
                    tell(Moment::Waiting);
                    true
                };
                renderer.render_in_bands(gpu, input, canvas, slot, pace, &mut between)?;
            }
        }
        match is_wanted {
            true => Ok(()),
            false => gpu.wait(),
        }
    }
}

/// The frames to draw from a clear beginning on before one that depends on them: as many as there were, but
/// not too many.
pub(super) fn frames_before(input: &FrameInput, feeds_back: bool) -> Vec<FrameInput> {
    let step = match input.time_delta {
        delta if delta > 0.0 => delta,
        _ => 1.0 / 60.0,
    };
    let count = match feeds_back {
        true => input.frame.clamp(0, MOST_BEFORE),
        false => 0,
    };
    let frame = |frame: i32| FrameInput {
        frame,
        time: input.time - step * (count - frame) as f32,
        ..*input
    };
    (0..count).map(frame).collect()
}
