//! Drawing with wgpu: the only room that knows it.
//!
//! A [`Renderer`] holds the GPU objects of one scene, a [`Canvas`] what it draws into. It owns no window and reads no clock: device,
//! frame input and target come from its caller.
//!
//! Orientation: every texture's row 0 is its bottom row, as in GL, and `fragCoord` grows upward. The
//! picture is turned once, where it leaves the GPU: in [`ReadBack`] and in the window's presenter.

mod buffers;
mod channel;
mod gpu;
mod mipmap;
mod pace;
mod pass;
#[cfg(feature = "window")]
mod present;
mod read_back;
mod target;
mod texture;
mod uniforms;
mod watchdog;

pub use gpu::{AdapterChoice, AdapterSummary, Gpu, GpuError, adapters};
pub use pace::Pace;
pub use pass::PassLayout;
#[cfg(feature = "window")]
pub use present::{Presented, Presenter};
pub use read_back::{Extras, ReadBack, Slot, Transferred};
pub use target::{Format, Target};
pub use watchdog::Watchdog;

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Instant;

use buffers::{Buffers, Surface};
use glam::UVec2;
use texture::Textures;
use uniforms::Part;

use crate::frame::FrameInput;
use crate::media::Inputs;
use crate::scene::{Filter, PassKind, Scene};
use crate::translate::Program;

/// Width and height of the pictures whose pixels are the samples of a sound, row by row from the bottom.
pub const SOUND_SIDE: u32 = 512;

/// The samples of such a picture.
pub const SOUND_BLOCK: u32 = SOUND_SIDE * SOUND_SIDE;

/// What has been handed to the device together.
#[derive(Debug)]
pub struct Submission(Arc<AtomicBool>);

/// What a scene is drawn into: the picture, and the buffers that its passes draw for each other.
#[derive(Debug)]
pub struct Canvas {
    /// The picture.
    pub target: Target,
    buffers: Buffers,
}

/// Where a frame goes on: a pass, and its next row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cursor {
    pass: usize,
    row: u32,
}

/// The GPU objects of one scene: pipelines, uniforms, channel textures.
#[derive(Debug)]
pub struct Renderer {
    passes: Vec<pass::GpuPass>,
    format: Format,
    /// Those of them that change are written before each frame.
    textures: Mutex<Textures>,
}

impl Renderer {
    /// Builds everything that the programs use, and nothing else. `programs` are the translations of
    /// `scene`'s passes, and `inputs` what they read, in their order. The picture has this format.
    ///
    /// The driver compiles here; some drivers finish only during the first frame.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        programs: &[Program],
        inputs: &Inputs,
        format: Format,
    ) -> Result<Self, GpuError> {
        let mut textures = Textures::default();
        let mut passes = Vec::new();
        for (place, (pass, program)) in scene.passes.iter().zip(programs).enumerate() {
            let drawn = Surface::drawn_by(pass.kind);
            let format = drawn.map_or(format.texture(), |surface| surface.format(gpu));
            let pass =
                pass::GpuPass::new(gpu, pass, program, format, place, inputs, &mut textures)?;
            passes.push(pass);
        }
        for (surface, filter) in passes.iter().flat_map(pass::GpuPass::reads) {
            if filter == Filter::Mipmap {
                textures.mipmaps.prepare(
                    gpu,
                    surface.format(gpu),
                    wgpu::TextureViewDimension::D2,
                )?;
            }
        }
        Ok(Renderer {
            passes,
            format,
            textures: Mutex::new(textures),
        })
    }

    /// Makes what the scene is drawn into, in pictures of one size, each side from 1 to the device's
    /// limit. Buffers are clear.
    pub fn canvas(&self, gpu: &Gpu, size: UVec2) -> Result<Canvas, GpuError> {
        Ok(Canvas {
            target: Target::new(gpu, size, self.format)?,
            buffers: Buffers::new(gpu, &self.passes, size)?,
        })
    }

    /// The same in another size. Buffers keep what they hold, from the lower left as far as it fits.
    pub fn resized(&self, gpu: &Gpu, old: &Canvas, size: UVec2) -> Result<Canvas, GpuError> {
        let mut canvas = self.canvas(gpu, size)?;
        canvas.buffers.take_over(gpu, &old.buffers);
        Ok(canvas)
    }

    /// Whether a frame depends on the one before: some pass reads what a buffer held then.
    pub fn feeds_back(&self) -> bool {
        self.passes.iter().enumerate().any(|(place, pass)| {
            pass.reads().any(|(surface, _)| {
                let is_drawn = |pass: &pass::GpuPass| pass.draws() == Some(surface);
                let writer = self.passes.iter().position(is_drawn);
                writer.is_some_and(|writer| writer >= place)
            })
        })
    }

    /// Records the drawing of one frame, or of a sound's block with the number `iFrame`, and submits it, followed by a copy into `slot` if one is given. With
    /// `iFrame` 0 time begins anew: buffers are cleared.
    pub fn render(
        &self,
        gpu: &Gpu,
        input: &FrameInput,
        canvas: &mut Canvas,
        slot: Option<&mut Slot>,
    ) {
        let mut encoder = encoder(gpu);
        let mut cursor = Some(Cursor::default());
        while let Some(from) = cursor {
            let slot = slot.as_deref();
            cursor = self.record(gpu, input, canvas, &mut encoder, from, u32::MAX, slot);
        }
        self.submit(gpu, encoder, canvas, slot);
    }

    /// The same for some of a frame's rows, counted from the bottom; returns where it goes on, if it does.
    /// The copy follows the last.
    pub fn render_band(
        &self,
        gpu: &Gpu,
        input: &FrameInput,
        canvas: &mut Canvas,
        from: Cursor,
        rows: u32,
        slot: Option<&mut Slot>,
    ) -> (Submission, Option<Cursor>) {
        let mut encoder = encoder(gpu);
        let next = self.record(
            gpu,
            input,
            canvas,
            &mut encoder,
            from,
            rows,
            slot.as_deref(),
        );
        let slot = slot.filter(|_| next.is_none());
        (self.submit(gpu, encoder, canvas, slot), next)
    }

    /// How many rows a band has that begins here, of so many at most. It ends where a face of a cubemap does.
    pub fn rows_from(&self, canvas: &Canvas, from: Cursor, most: u32) -> u32 {
        let height = self.size_of(canvas, from).y;
        most.min(height - from.row % height)
    }

    /// Whether a band of so many rows that begins here is a frame's last.
    pub fn is_last_band(&self, canvas: &Canvas, from: Cursor, rows: u32) -> bool {
        from.pass + 1 == self.passes.len() && from.row + rows >= self.rows_of(canvas, from)
    }

    /// Width and height of what the pass draws, of one face of a cubemap.
    fn size_of(&self, canvas: &Canvas, cursor: Cursor) -> UVec2 {
        let picture = canvas.target.size();
        let drawn = self.passes[cursor.pass].draws();
        drawn.map_or(picture, |surface| surface.size(picture))
    }

    /// The rows of all its faces.
    fn rows_of(&self, canvas: &Canvas, cursor: Cursor) -> u32 {
        let drawn = self.passes[cursor.pass].draws();
        self.size_of(canvas, cursor).y * drawn.map_or(1, Surface::faces)
    }

    #[expect(clippy::too_many_arguments, reason = "a band has this many sides")]
    fn record(
        &self,
        gpu: &Gpu,
        input: &FrameInput,
        canvas: &mut Canvas,
        encoder: &mut wgpu::CommandEncoder,
        from: Cursor,
        rows: u32,
        slot: Option<&Slot>,
    ) -> Option<Cursor> {
        let UVec2 {
            x: width,
            y: height,
        } = self.size_of(canvas, from);
        let rows = self.rows_from(canvas, from, rows);
        let is_first = from == Cursor::default();
        let is_last = self.is_last_band(canvas, from, rows);
        if is_first {
            let mut textures = self.textures.lock().expect("no holder panics");
            textures.advance(gpu, input.time);
            for buffer in self.findings() {
                encoder.clear_buffer(buffer, 0, None);
            }
            if input.frame == 0 {
                canvas.buffers.restart(encoder);
            }
        }
        let pass = &self.passes[from.pass];
        let (face, row) = (from.row / height, from.row % height);
        let part = match pass.kind() {
            PassKind::Cube => Part::Face(face),
            // The frames of a sound are its blocks.
            PassKind::Sound => Part::Block(input.frame.unsigned_abs() * SOUND_BLOCK),
            PassKind::Image | PassKind::Buffer(_) => Part::Whole,
        };
        let end = from.row + rows;
        let is_whole = end >= self.rows_of(canvas, from);
        let band = pass::Band {
            part,
            width,
            rows: row..row + rows,
            keeps: pass.draws().is_some(),
            timestamps: slot.and_then(|slot| slot.timestamps(from.pass, from.row == 0, is_whole)),
        };
        let buffers = &canvas.buffers;
        let target = buffers.target(from.pass, face as usize);
        let view = target.unwrap_or(canvas.target.view());
        let group = buffers.group(from.pass, face as usize);
        pass.draw(gpu, input, encoder, view, group, band);
        if !is_whole {
            return Some(Cursor { row: end, ..from });
        }
        if pass.draws().is_some() {
            let textures = self.textures.lock().expect("no holder panics");
            buffers.shrink(gpu, &textures.mipmaps, encoder, from.pass);
        }
        if !is_last {
            return Some(Cursor {
                pass: from.pass + 1,
                row: 0,
            });
        }
        canvas.buffers.frame_drawn();
        None
    }

    fn submit(
        &self,
        gpu: &Gpu,
        encoder: wgpu::CommandEncoder,
        canvas: &Canvas,
        slot: Option<&mut Slot>,
    ) -> Submission {
        match slot {
            Some(slot) => slot.copy(gpu, encoder, &canvas.target, self.findings()),
            None => {
                gpu.queue().submit([encoder.finish()]);
            }
        }
        let is_done = Arc::new(AtomicBool::new(false));
        let done = Arc::clone(&is_done);
        gpu.on_done(move || done.store(true, Ordering::Release));
        Submission(is_done)
    }

    /// Draws a frame band by band, and waits for each, so that the device is never busy for long. `between`
    /// is called in between and while waiting; `false` gives the frame up after the band under way, which
    /// is then the result.
    pub fn render_in_bands(
        &self,
        gpu: &Gpu,
        input: &FrameInput,
        canvas: &mut Canvas,
        mut slot: Option<&mut Slot>,
        pace: &mut Pace,
        between: &mut dyn FnMut() -> bool,
    ) -> Result<bool, GpuError> {
        let mut from = Cursor::default();
        loop {
            let rows = self.rows_from(canvas, from, pace.rows());
            let began = Instant::now();
            let slot = slot.as_deref_mut();
            let (submission, next) = self.render_band(gpu, input, canvas, from, rows, slot);
            let mut goes_on = true;
            while !gpu.is_done(&submission)? {
                goes_on &= between();
            }
            pace.took(rows, began.elapsed());
            match next {
                None => return Ok(true),
                Some(next) => from = next,
            }
            if !(goes_on && between()) {
                return Ok(false);
            }
        }
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

    /// How many passes it draws.
    pub fn pass_count(&self) -> u32 {
        self.passes.len() as u32
    }

    /// What is bound for each pass, for those who want to know what was left out.
    pub fn layouts(&self) -> impl Iterator<Item = &PassLayout> {
        self.passes.iter().map(pass::GpuPass::layout)
    }
}

fn encoder(gpu: &Gpu) -> wgpu::CommandEncoder {
    let descriptor = wgpu::CommandEncoderDescriptor { label: None };
    gpu.device().create_command_encoder(&descriptor)
}
