//! Drawing with wgpu: the only room that knows it.
//!
//! A [`Renderer`] holds the GPU objects of one scene. It owns no window and reads no clock: device,
//! frame input and target come from its caller.
//!
//! Orientation: every texture's row 0 is its bottom row, as in GL, and `fragCoord` grows upward. The
//! picture is turned once, where it leaves the GPU: in [`ReadBack`] and in the window's presenter.

mod channel;
mod gpu;
mod pace;
mod pass;
#[cfg(feature = "window")]
mod present;
mod read_back;
mod target;
mod watchdog;

pub use gpu::{AdapterChoice, AdapterSummary, Gpu, GpuError, adapters};
pub use pace::Pace;
pub use pass::PassLayout;
#[cfg(feature = "window")]
pub use present::{Presented, Presenter};
pub use read_back::{Extras, ReadBack, Slot, Transferred};
pub use target::{Format, Target};
pub use watchdog::Watchdog;

use std::ops::Range;
use std::time::Instant;

use crate::frame::FrameInput;
use crate::scene::Scene;
use crate::translate::Program;

/// What has been handed to the device together.
#[derive(Debug)]
pub struct Submission(wgpu::SubmissionIndex);

/// The GPU objects of one scene: pipelines, uniforms, channel textures.
#[derive(Debug)]
pub struct Renderer {
    passes: Vec<pass::GpuPass>,
}

impl Renderer {
    /// Builds everything that the programs use, and nothing else. `programs` are the translations of
    /// `scene`'s passes, in their order. All targets must have this format.
    ///
    /// The driver compiles here; some drivers finish only during the first frame.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        programs: &[Program],
        format: Format,
    ) -> Result<Self, GpuError> {
        let passes = scene
            .passes
            .iter()
            .zip(programs)
            .map(|(pass, program)| pass::GpuPass::new(gpu, pass, program, format))
            .collect::<Result<_, _>>()?;
        Ok(Renderer { passes })
    }

    /// Records the drawing of one frame into `target` and submits it, followed by a copy into
    /// `read_back`'s slot if one is given.
    pub fn render(&self, gpu: &Gpu, input: &FrameInput, target: &Target, slot: Option<&mut Slot>) {
        self.render_rows(gpu, input, target, 0..target.size().y, slot);
    }

    /// The same for some of the picture's rows, counted from the bottom. The first band of a frame begins
    /// with row 0; the copy follows the last.
    pub fn render_rows(
        &self,
        gpu: &Gpu,
        input: &FrameInput,
        target: &Target,
        rows: Range<u32>,
        slot: Option<&mut Slot>,
    ) -> Submission {
        let mut encoder = gpu
            .device()
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: None });
        let is_first = rows.start == 0;
        let is_last = rows.end >= target.size().y;
        if is_first {
            for buffer in self.findings() {
                encoder.clear_buffer(buffer, 0, None);
            }
        }
        let band = pass::Band {
            rows,
            timestamps: slot
                .as_ref()
                .and_then(|slot| slot.timestamps(is_first, is_last)),
        };
        for pass in &self.passes {
            pass.draw(gpu, input, &mut encoder, target, band.clone());
        }
        Submission(match slot {
            Some(slot) if is_last => slot.copy(gpu, encoder, target, self.findings()),
            _ => gpu.queue().submit([encoder.finish()]),
        })
    }

    /// Draws a frame band by band, and waits for each, so that the device is never busy for long. `between`
    /// is called in between and while waiting; `false` gives the frame up after the band under way, which
    /// is then the result.
    pub fn render_in_bands(
        &self,
        gpu: &Gpu,
        input: &FrameInput,
        target: &Target,
        mut slot: Option<&mut Slot>,
        pace: &mut Pace,
        between: &mut dyn FnMut() -> bool,
    ) -> Result<bool, GpuError> {
        let height = target.size().y;
        let mut from = 0;
        while from < height {
            let rows = from..height.min(from + pace.rows());
            from = rows.end;
            let count = rows.end - rows.start;
            let began = Instant::now();
            let submission = self.render_rows(gpu, input, target, rows, slot.as_deref_mut());
            let mut goes_on = true;
            while !gpu.is_done(&submission)? {
                goes_on &= between();
            }
            pace.took(count, began.elapsed());
            if from < height && !(goes_on && between()) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Asks for the findings of what has been drawn of a frame so far.
    pub fn copy_findings(&self, gpu: &Gpu, slot: &mut Slot) {
        slot.copy_findings(gpu, self.findings());
    }

    /// How many words the passes note their findings in, one pass behind the other.
    pub fn finding_words(&self) -> u32 {
        let bytes: u64 = self.findings().map(wgpu::Buffer::size).sum();
        (bytes / 4) as u32
    }

    fn findings(&self) -> impl Iterator<Item = &wgpu::Buffer> {
        self.passes.iter().filter_map(|pass| pass.findings())
    }

    /// What is bound for each pass, for those who want to know what was left out.
    pub fn layouts(&self) -> impl Iterator<Item = &PassLayout> {
        self.passes.iter().map(pass::GpuPass::layout)
    }
}
