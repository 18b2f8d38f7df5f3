//! Drawing with wgpu: the only room that knows it.
//!
//! A [`Renderer`] holds the GPU objects of one scene. It owns no window and reads no clock: device,
//! frame input and target come from its caller.
//!
//! Orientation: every texture's row 0 is its bottom row, as in GL, and `fragCoord` grows upward. The
//! picture is turned once, where it leaves the GPU: in [`ReadBack`] and in the window's presenter.

mod channel;
mod gpu;
mod pass;
#[cfg(feature = "window")]
mod present;
mod read_back;
mod target;
mod watchdog;

pub use gpu::{AdapterChoice, AdapterSummary, Gpu, GpuError, adapters};
pub use pass::PassLayout;
#[cfg(feature = "window")]
pub use present::{Presented, Presenter};
pub use read_back::{Extras, ReadBack, Slot, Transferred};
pub use target::{Format, Target};
pub use watchdog::Watchdog;

use crate::frame::FrameInput;
use crate::scene::Scene;
use crate::translate::Program;

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
        let mut encoder = gpu
            .device()
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: None });
        let timestamps = slot.as_ref().and_then(|slot| slot.timestamps());
        for buffer in self.findings() {
            encoder.clear_buffer(buffer, 0, None);
        }
        for pass in &self.passes {
            pass.draw(gpu, input, &mut encoder, target, timestamps.clone());
        }
        match slot {
            None => {
                gpu.queue().submit([encoder.finish()]);
            }
            Some(slot) => slot.copy(gpu, encoder, target, self.findings()),
        }
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
