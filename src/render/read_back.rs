use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

use glam::UVec2;

use super::gpu::{Gpu, GpuError, WAIT_SLICE};
use super::target::{Format, Target};
use crate::frame::{FloatImage, FrameImage};

/// Two timestamps of eight bytes.
const TIMES_BYTES: u64 = 16;

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
            times: extras.times && gpu.has_timestamps(),
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
            times: false,
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
    /// How long the GPU drew, where the device can tell.
    pub times: bool,
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
    times: Option<u64>,
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
        let times = extras.times.then_some(end);
        Layout {
            stride,
            findings,
            finding_words,
            times,
            bytes: end + times.map_or(0, |_| TIMES_BYTES),
        }
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
    submission: Option<wgpu::SubmissionIndex>,
    state: Arc<AtomicU8>,
}

const PENDING: u8 = 0;
const MAPPED: u8 = 1;
const FAILED: u8 = 2;

/// What came back besides the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Transferred {
    /// How long the GPU drew this frame, if it was asked and can tell.
    pub gpu_seconds: Option<f64>,
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
            stopwatch: layout.times.map(|_| Stopwatch::new(gpu)),
            submission: None,
            state: Arc::default(),
        }
    }

    /// The timestamps of a band, which may be a frame's first or last.
    pub(super) fn timestamps(
        &self,
        is_first: bool,
        is_last: bool,
    ) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        let stopwatch = self.stopwatch.as_ref().filter(|_| is_first || is_last)?;
        Some(wgpu::RenderPassTimestampWrites {
            query_set: &stopwatch.queries,
            beginning_of_pass_write_index: is_first.then_some(0),
            end_of_pass_write_index: is_last.then_some(1),
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
    ) -> wgpu::SubmissionIndex {
        if self.size != UVec2::ZERO {
            debug_assert_eq!(self.size, target.size(), "a slot is made for one size");
            self.copy_picture(&mut encoder, target);
        }
        self.add_findings(&mut encoder, findings);
        if let (Some(stopwatch), Some(times)) = (&self.stopwatch, self.layout.times) {
            encoder.resolve_query_set(&stopwatch.queries, 0..2, &stopwatch.resolved, 0);
            encoder.copy_buffer_to_buffer(&stopwatch.resolved, 0, &self.buffer, times, TIMES_BYTES);
        }
        self.submit(gpu, encoder)
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

    fn submit(&mut self, gpu: &Gpu, encoder: wgpu::CommandEncoder) -> wgpu::SubmissionIndex {
        let submission = gpu.queue().submit([encoder.finish()]);
        self.submission = Some(submission.clone());
        self.state.store(PENDING, Ordering::Release);
        let state = Arc::clone(&self.state);
        self.buffer
            .map_async(wgpu::MapMode::Read, .., move |result| {
                let outcome = if result.is_ok() { MAPPED } else { FAILED };
                state.store(outcome, Ordering::Release);
            });
        submission
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
        let poll = gpu.device().poll(wgpu::PollType::Wait {
            submission_index: self.submission.clone(),
            timeout: Some(WAIT_SLICE),
        });
        gpu.check()?;
        match (self.state.load(Ordering::Acquire), poll) {
            (MAPPED, _) => Ok(true),
            (FAILED, _) => Err(GpuError::Lost(
                "a picture could not be read back".to_owned(),
            )),
            (_, Ok(_) | Err(wgpu::PollError::Timeout)) => Ok(false),
            (_, Err(error)) => Err(GpuError::Lost(error.to_string())),
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
        let (gpu_seconds, findings);
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
            gpu_seconds = self.layout.times.map(|times| {
                let times = times as usize;
                let tick = |at: usize| -> u64 { bytemuck::pod_read_unaligned(&mapped[at..at + 8]) };
                let ticks = tick(times + 8).saturating_sub(tick(times));
                ticks as f64 * f64::from(gpu.queue().get_timestamp_period()) * 1e-9
            });
        }
        self.buffer.unmap();
        Ok(Transferred {
            gpu_seconds,
            findings,
        })
    }
}

/// A pair of timestamps around one frame.
#[derive(Debug)]
struct Stopwatch {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
}

impl Stopwatch {
    fn new(gpu: &Gpu) -> Self {
        Stopwatch {
            queries: gpu.device().create_query_set(&wgpu::QuerySetDescriptor {
                label: None,
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            }),
            resolved: gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: TIMES_BYTES,
                usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
        }
    }
}
