use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

use glam::UVec2;

use super::gpu::{Gpu, GpuError};
use super::target::{Format, Target};
use crate::frame::{FloatImage, FrameImage};

/// The two timestamps of a pass, of eight bytes each.
const PASS_BYTES: u64 = 16;

/// A ring of buffers through which pictures come back from the GPU.
///
/// While one slot is being read, others can be drawn into; each goes from [`super::Renderer::render`]
/// to [`Slot::is_ready`] to [`Slot::take`], and is then free again.
#[derive(Debug)]
pub struct ReadBack {
    /// The slots, to be used in turn.
    pub slots: Vec<Slot>,
}

impl ReadBack {
    /// A ring of `count` slots for pictures like those of `target`.
    pub fn new(gpu: &Gpu, target: &Target, count: usize, extras: Extras) -> Result<Self, GpuError> {
        let extras = Extras {
            timed_passes: match gpu.has_timestamps() {
                true => extras.timed_passes,
                false => 0,
            },
            ..extras
        };
        let (size, format) = (target.size(), target.format());
        let layout = Layout::new(size, format, extras);
        let doing = "making the read-back buffers";
        if layout.bytes > gpu.device().limits().max_buffer_size {
            return Err(GpuError::OutOfMemory { doing });
        }
        gpu.guarded(doing, || ReadBack {
            slots: (0..count)
                .map(|_| Slot::new(gpu, size, format, layout))
                .collect(),
        })
    }
}

impl ReadBack {
    /// A slot that brings back findings alone, of pictures of any size.
    pub fn of_findings(gpu: &Gpu, finding_words: u32) -> Result<Slot, GpuError> {
        let extras = Extras {
            timed_passes: 0,
            finding_words,
        };
        let (size, format) = (UVec2::ZERO, Format::Bytes);
        let layout = Layout::new(size, format, extras);
        gpu.guarded("making a read-back buffer", || {
            Slot::new(gpu, size, format, layout)
        })
    }
}

/// What a slot brings back besides the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extras {
    /// How many passes are timed, where the device can tell: none, or as many as the
    /// [renderer](super::Renderer::pass_count) has.
    pub timed_passes: u32,
    /// So many words of findings, see [`Renderer::finding_words`](super::Renderer::finding_words).
    pub finding_words: u32,
}

/// Where in a slot's buffer everything is, in bytes: the picture first.
#[derive(Clone, Copy, Debug)]
struct Layout {
    /// From one row of the picture to the next, padded as copies demand.
    stride: u32,
    findings: u64,
    finding_words: u32,
    times: u64,
    timed_passes: u32,
    /// All of it.
    bytes: u64,
}

impl Layout {
    fn new(size: UVec2, format: Format, extras: Extras) -> Self {
        let stride = format.stride() * size.x;
        let stride = stride.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let findings = u64::from(stride) * u64::from(size.y);
        let finding_words = extras.finding_words;
        let end = (findings + 4 * u64::from(finding_words)).next_multiple_of(8);
        let timed_passes = extras.timed_passes;
        let mut layout = Layout {
            stride,
            findings,
            finding_words,
            times: end,
            timed_passes,
            bytes: end,
        };
        layout.bytes += layout.times_bytes();
        layout
    }

    fn times_bytes(&self) -> u64 {
        PASS_BYTES * u64::from(self.timed_passes)
    }
}

/// One picture on its way back.
#[derive(Debug)]
pub struct Slot {
    size: UVec2,
    format: Format,
    layout: Layout,
    buffer: wgpu::Buffer,
    stopwatch: Option<Stopwatch>,
    state: Arc<AtomicU8>,
}

const PENDING: u8 = 0;
const MAPPED: u8 = 1;
const FAILED: u8 = 2;

/// What came back besides the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Transferred {
    /// How long the GPU drew this frame, from the beginning of its first pass to the end of its last, if it was asked
    /// and can tell.
    pub gpu_seconds: Option<f64>,
    /// How long each pass took, under the same conditions. The smaller levels of buffers are made between passes.
    pub pass_seconds: Vec<f64>,
    /// The words of findings, of all passes that have some.
    pub findings: Vec<u32>,
}

impl Slot {
    fn new(gpu: &Gpu, size: UVec2, format: Format, layout: Layout) -> Self {
        Slot {
            size,
            format,
            layout,
            buffer: gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: Some("read-back"),
                size: layout.bytes,
                usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
                mapped_at_creation: false,
            }),
            stopwatch: (layout.timed_passes > 0).then(|| Stopwatch::new(gpu, &layout)),
            state: Arc::default(),
        }
    }

    /// The timestamps of a band, which may be the first or the last of a pass.
    pub(super) fn timestamps(
        &self,
        pass: usize,
        is_first: bool,
        is_last: bool,
    ) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        let stopwatch = self.stopwatch.as_ref().filter(|_| is_first || is_last)?;
        Some(wgpu::RenderPassTimestampWrites {
            query_set: &stopwatch.queries,
            beginning_of_pass_write_index: is_first.then_some(2 * pass as u32),
            end_of_pass_write_index: is_last.then_some(2 * pass as u32 + 1),
        })
    }

    /// Asks for what `target` holds now, without drawing it again.
    pub fn copy_of(&mut self, gpu: &Gpu, target: &Target) {
        let descriptor = wgpu::CommandEncoderDescriptor { label: None };
        let encoder = gpu.device().create_command_encoder(&descriptor);
        self.copy(gpu, encoder, target, std::iter::empty());
    }

    /// Adds the copy to `encoder`, submits it and asks for the result.
    pub(super) fn copy<'b>(
        &mut self,
        gpu: &Gpu,
        mut encoder: wgpu::CommandEncoder,
        target: &Target,
        findings: impl Iterator<Item = &'b wgpu::Buffer>,
    ) {
        if self.size != UVec2::ZERO {
            debug_assert_eq!(self.size, target.size(), "a slot is made for one size");
            self.copy_picture(&mut encoder, target);
        }
        self.add_findings(&mut encoder, findings);
        if let Some(Stopwatch { queries, resolved }) = &self.stopwatch {
            let (times, bytes) = (self.layout.times, self.layout.times_bytes());
            encoder.resolve_query_set(queries, 0..2 * self.layout.timed_passes, resolved, 0);
            encoder.copy_buffer_to_buffer(resolved, 0, &self.buffer, times, bytes);
        }
        self.submit(gpu, encoder);
    }

    /// Asks for findings alone, without drawing.
    pub(super) fn copy_findings<'b>(
        &mut self,
        gpu: &Gpu,
        findings: impl Iterator<Item = &'b wgpu::Buffer>,
    ) {
        let descriptor = wgpu::CommandEncoderDescriptor { label: None };
        let mut encoder = gpu.device().create_command_encoder(&descriptor);
        self.add_findings(&mut encoder, findings);
        self.submit(gpu, encoder);
    }

    fn add_findings<'b>(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        findings: impl Iterator<Item = &'b wgpu::Buffer>,
    ) {
        let mut at = self.layout.findings;
        let end = at + 4 * u64::from(self.layout.finding_words);
        for buffer in findings {
            let bytes = buffer.size().min(end - at);
            if bytes > 0 {
                encoder.copy_buffer_to_buffer(buffer, 0, &self.buffer, at, bytes);
            }
            at += bytes;
        }
    }

    fn submit(&mut self, gpu: &Gpu, encoder: wgpu::CommandEncoder) {
        gpu.queue().submit([encoder.finish()]);
        self.state.store(PENDING, Ordering::Release);
        let state = Arc::clone(&self.state);
        self.buffer
            .map_async(wgpu::MapMode::Read, .., move |result| {
                let outcome = if result.is_ok() { MAPPED } else { FAILED };
                state.store(outcome, Ordering::Release);
            });
    }

    fn copy_picture(&self, encoder: &mut wgpu::CommandEncoder, target: &Target) {
        encoder.copy_texture_to_buffer(
            target.texture().as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &self.buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(self.layout.stride),
                    rows_per_image: None,
                },
            },
            target.texture().size(),
        );
    }

    /// Waits a moment for the picture; `false` means that it is still being drawn.
    pub fn is_ready(&self, gpu: &Gpu) -> Result<bool, GpuError> {
        gpu.wait_for(|| self.state.load(Ordering::Acquire) != PENDING)?;
        match self.state.load(Ordering::Acquire) {
            FAILED => Err(GpuError::Lost(
                "a picture could not be read back".to_owned(),
            )),
            state => Ok(state == MAPPED),
        }
    }

    /// Whether everything is back, without waiting.
    pub fn has_come_back(&self) -> Result<bool, GpuError> {
        match self.state.load(Ordering::Acquire) {
            FAILED => Err(GpuError::Lost("findings could not be read back".to_owned())),
            state => Ok(state == MAPPED),
        }
    }

    /// Copies a picture of bytes that is ready into `image`, top row first and without alpha, and
    /// frees the slot. `image`'s memory is reused.
    pub fn take(&mut self, gpu: &Gpu, image: &mut FrameImage) -> Result<Transferred, GpuError> {
        debug_assert_eq!(self.format, Format::Bytes);
        image.size = self.size;
        image.rgb.clear();
        self.take_rows(gpu, |row| {
            let pixels = row.chunks_exact(4);
            image.rgb.extend(pixels.flat_map(|pixel| &pixel[..3]));
        })
    }

    /// The same for a picture of floats, whose alpha is kept.
    pub fn take_floats(
        &mut self,
        gpu: &Gpu,
        image: &mut FloatImage,
    ) -> Result<Transferred, GpuError> {
        debug_assert_eq!(self.format, Format::Floats);
        image.size = self.size;
        image.rgba.clear();
        self.take_rows(gpu, |row| {
            let pixels = row.chunks_exact(16);
            let pixels = pixels.map(bytemuck::pod_read_unaligned::<[f32; 4]>);
            image.rgba.extend(pixels);
        })
    }

    /// The words of findings alone; frees the slot.
    pub fn take_findings(&mut self, gpu: &Gpu) -> Result<Vec<u32>, GpuError> {
        Ok(self.take_rows(gpu, |_| {})?.findings)
    }

    /// Hands out the rows, the top one first, and frees the slot.
    fn take_rows(
        &mut self,
        gpu: &Gpu,
        mut each: impl FnMut(&[u8]),
    ) -> Result<Transferred, GpuError> {
        let (times, findings);
        {
            let mapped = self
                .buffer
                .get_mapped_range(..)
                .map_err(|error| GpuError::Lost(error.to_string()))?;
            let row = (self.format.stride() * self.size.x) as usize;
            for y in (0..self.size.y as usize).rev() {
                each(&mapped[y * self.layout.stride as usize..][..row]);
            }
            let words = mapped[self.layout.findings as usize..].chunks_exact(4);
            findings = words
                .take(self.layout.finding_words as usize)
                .map(bytemuck::pod_read_unaligned)
                .collect();
            let bytes = self.layout.times as usize..self.layout.bytes as usize;
            let passes = mapped[bytes].chunks_exact(PASS_BYTES as usize);
            times = passes
                .map(bytemuck::pod_read_unaligned)
                .collect::<Vec<[u64; 2]>>();
        }
        self.buffer.unmap();
        let tick = f64::from(gpu.queue().get_timestamp_period()) * 1e-9;
        let seconds = |from: u64, to: u64| to.saturating_sub(from) as f64 * tick;
        Ok(Transferred {
            gpu_seconds: times
                .first()
                .zip(times.last())
                .map(|(first, last)| seconds(first[0], last[1])),
            pass_seconds: times.iter().map(|&[from, to]| seconds(from, to)).collect(),
            findings,
        })
    }
}

/// A pair of timestamps around each pass of a frame.
#[derive(Debug)]
struct Stopwatch {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
}

impl Stopwatch {
    fn new(gpu: &Gpu, layout: &Layout) -> Self {
        Stopwatch {
            queries: gpu.device().create_query_set(&wgpu::QuerySetDescriptor {
                label: None,
                ty: wgpu::QueryType::Timestamp,
                count: 2 * layout.timed_passes,
            }),
            resolved: gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: layout.times_bytes(),
                usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
        }
    }
}
