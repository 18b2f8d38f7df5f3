//! The values of a pass's uniforms.

use std::sync::{Arc, Mutex};

use glam::{Vec3, vec3, vec4};

use super::buffers::{CUBE_SIDE, Surface};
use super::channel;
use super::gpu::Gpu;
use crate::frame::{FrameInput, SAMPLE_RATE};
use crate::media::{Content, Feed};
use crate::scene::{CHANNELS, Pass};
use crate::translate::UniformBlock;
use crate::translate::bindings::{self, Uniform};

/// std140's stride of array elements, in bytes.
const ARRAY_STRIDE: usize = 16;

/// Where the blocks of several faces begin in one buffer is a multiple of so many bytes: what every device takes.
const ALIGNMENT: u32 = 256;

/// Which part of what a pass draws is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// There is but one.
    Whole,
    /// One face of a cubemap, in the order +X, −X, +Y, −Y, +Z, −Z.
    Face(u32),
    /// A block of a sound that begins with this sample.
    Block(u32),
}

impl Part {
    /// Which of the faces it is.
    pub fn face(self) -> u32 {
        match self {
            Part::Face(face) => face,
            Part::Whole | Part::Block(_) => 0,
        }
    }
}

/// The corners of each face, where `fragCoord` is (0, 0), (1024, 0), (1024, 1024) and (0, 1024), as GL lays out cubemaps.
const CORNERS: [[Vec3; 4]; 6] = {
    const fn at(x: f32, y: f32, z: f32) -> Vec3 {
        vec3(x, y, z)
    }
    let (p, m) = (1.0, -1.0);
    [
        [at(p, p, p), at(p, p, m), at(p, m, m), at(p, m, p)],
        [at(m, p, m), at(m, p, p), at(m, m, p), at(m, m, m)],
        [at(m, p, m), at(p, p, m), at(p, p, p), at(m, p, p)],
        [at(m, m, p), at(p, m, p), at(p, m, m), at(m, m, m)],
        [at(m, p, p), at(p, p, p), at(p, m, p), at(m, m, p)],
        [at(p, p, m), at(m, p, m), at(m, m, m), at(p, m, m)],
    ]
};

/// A pass's uniform block, and what of it does not change.
#[derive(Debug)]
pub(super) struct Uniforms {
    buffer: wgpu::Buffer,
    block: UniformBlock,
    /// What else the pass draws than the picture, or something as large as it.
    surface: Option<Surface>,
    /// `None` is the picture's size.
    channel_resolution: [Option<Vec3>; CHANNELS],
    /// What tells how far it has played.
    feeds: [Option<Arc<Mutex<dyn Feed>>>; CHANNELS],
}

impl Uniforms {
    pub fn new<'c>(
        gpu: &Gpu,
        block: &UniformBlock,
        pass: &Pass,
        content: &dyn Fn(usize) -> Option<&'c Content>,
    ) -> Self {
        let surface = Surface::drawn_by(pass.kind);
        let faces = surface.map_or(1, Surface::faces);
        Uniforms {
            buffer: gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: Some("uniforms"),
                size: u64::from(stride(block) * (faces - 1) + block.size),
                usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
            block: block.clone(),
            surface,
            channel_resolution: std::array::from_fn(|index| {
                channel::resolution(pass.channels[index].as_ref(), content(index))
            }),
            feeds: std::array::from_fn(|index| match content(index) {
                Some(Content::Live(feed)) => Some(Arc::clone(feed)),
                _ => None,
            }),
        }
    }

    /// What is bound for a face.
    pub fn binding(&self, face: u32) -> wgpu::BindingResource<'_> {
        wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: &self.buffer,
            offset: u64::from(face * stride(&self.block)),
            size: std::num::NonZeroU64::new(u64::from(self.block.size)),
        })
    }

    pub fn upload(&self, gpu: &Gpu, input: &FrameInput, part: Part) {
        let size = std::num::NonZeroU64::new(u64::from(self.block.size));
        let offset = u64::from(part.face() * stride(&self.block));
        let view = size.and_then(|size| gpu.queue().write_buffer_with(&self.buffer, offset, size));
        // Without a view the device is lost, which `Gpu::check` tells.
        if let Some(mut view) = view {
            let mut bytes = [0; bindings::BLOCK_SIZE as usize];
            let bytes = &mut bytes[..self.block.size as usize];
            self.pack(input, part, bytes);
            view.copy_from_slice(bytes);
        }
    }

    /// Writes the members that the pass reads at their places; the rest of the block is left alone.
    fn pack(&self, input: &FrameInput, part: Part, bytes: &mut [u8]) {
        let size = self
            .surface
            .map_or(input.resolution, |surface| surface.size(input.resolution));
        for &(uniform, offset) in &self.block.members {
            let mut put = |at: usize, value: &[u8]| {
                let start = offset as usize + at;
                bytes[start..start + value.len()].copy_from_slice(value);
            };
            match uniform {
                Uniform::Resolution => {
                    let size = size.as_vec2().extend(1.0);
                    put(0, bytemuck::bytes_of(&size));
                }
                Uniform::Time => put(0, bytemuck::bytes_of(&input.time)),
                Uniform::TimeDelta => put(0, bytemuck::bytes_of(&input.time_delta)),
                Uniform::FrameRate => put(0, bytemuck::bytes_of(&input.frame_rate)),
                Uniform::Frame => put(0, bytemuck::bytes_of(&input.frame)),
                Uniform::Mouse => put(0, bytemuck::bytes_of(&input.mouse)),
                Uniform::Date => put(0, bytemuck::bytes_of(&input.date)),
                Uniform::SampleRate => put(0, bytemuck::bytes_of(&SAMPLE_RATE)),
                Uniform::ChannelTime => {
                    for (channel, feed) in self.feeds.iter().enumerate() {
                        let Some(feed) = feed else { continue };
                        let feed = feed.lock().expect("no holder panics");
                        let position = feed.position(f64::from(input.time)) as f32;
                        put(channel * ARRAY_STRIDE, bytemuck::bytes_of(&position));
                    }
                }
                Uniform::Viewport => {
                    let side = CUBE_SIDE as f32;
                    put(0, bytemuck::bytes_of(&vec4(0.0, 0.0, side, side)));
                }
                // The eye, behind the corners, is at the origin.
                Uniform::Corners => {
                    for (corner, at) in CORNERS[part.face() as usize].iter().enumerate() {
                        put(corner * ARRAY_STRIDE, bytemuck::bytes_of(at));
                    }
                }
                Uniform::TimeOffset => {
                    let Part::Block(first) = part else { continue };
                    let seconds = (f64::from(first) / f64::from(SAMPLE_RATE)) as f32;
                    put(0, bytemuck::bytes_of(&seconds));
                }
                Uniform::SampleOffset => {
                    let Part::Block(first) = part else { continue };
                    put(0, bytemuck::bytes_of(&first));
                }
                Uniform::ChannelResolution => {
                    for (channel, size) in self.channel_resolution.iter().enumerate() {
                        let size = size.unwrap_or(input.resolution.as_vec2().extend(1.0));
                        put(channel * ARRAY_STRIDE, bytemuck::bytes_of(&size));
                    }
                }
            }
        }
    }
}

fn stride(block: &UniformBlock) -> u32 {
    block.size.next_multiple_of(ALIGNMENT)
}
