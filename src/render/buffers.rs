//! What buffer passes draw for other passes: two textures each, of which one holds what was drawn last while the
//! other is drawn into.

use glam::UVec2;

use super::gpu::{Gpu, GpuError};
use super::mipmap::Mipmaps;
use super::pass::GpuPass;
use crate::scene::{BufferLetter, Filter};

/// The buffers of a scene in pictures of one size, and how many frames they have seen.
#[derive(Debug)]
pub struct Buffers {
    size: UVec2,
    pairs: [Option<Pair>; BufferLetter::ALL.len()],
    /// What is bound for each pass that reads a buffer, in even frames and in odd ones.
    groups: Vec<Option<[wgpu::BindGroup; 2]>>,
    frames: u32,
}

/// The two halves of a buffer.
#[derive(Debug)]
struct Pair {
    halves: [Half; 2],
}

#[derive(Debug)]
struct Half {
    texture: wgpu::Texture,
    /// All levels.
    whole: wgpu::TextureView,
    /// Each level by itself.
    levels: Vec<wgpu::TextureView>,
}

impl Half {
    fn new(gpu: &Gpu, size: UVec2, levels: u32) -> Self {
        let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("buffer"),
            size: wgpu::Extent3d {
                width: size.x,
                height: size.y,
                depth_or_array_layers: 1,
            },
            mip_level_count: levels,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: gpu.buffer_format(),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC
                | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = |level: Option<u32>| {
            texture.create_view(&wgpu::TextureViewDescriptor {
                base_mip_level: level.unwrap_or(0),
                mip_level_count: level.map(|_| 1),
                ..Default::default()
            })
        };
        Half {
            whole: view(None),
            levels: (0..levels).map(|level| view(Some(level))).collect(),
            texture,
        }
    }
}

impl Buffers {
    /// Clear buffers for these passes, as many as they draw or read.
    pub(super) fn new(gpu: &Gpu, passes: &[GpuPass], size: UVec2) -> Result<Self, GpuError> {
        let limit = gpu.max_size();
        if size.min_element() == 0 || size.max_element() > limit {
            return Err(GpuError::Size { size, limit });
        }
        gpu.guarded("making the buffers", || {
            let reads = || passes.iter().flat_map(GpuPass::reads);
            let pairs = BufferLetter::ALL.map(|letter| {
                let is_drawn = passes.iter().any(|pass| pass.draws() == Some(letter));
                let mut readers = reads().filter(|(read, _)| *read == letter).peekable();
                if !is_drawn && readers.peek().is_none() {
                    return None;
                }
                let is_shrunk = readers.any(|(_, filter)| filter == Filter::Mipmap);
                let levels = match is_shrunk {
                    true => size.max_element().ilog2() + 1,
                    false => 1,
                };
                let halves = [(); 2].map(|()| Half::new(gpu, size, levels));
                Some(Pair { halves })
            });
            let mut buffers = Buffers {
                size,
                pairs,
                groups: Vec::new(),
                frames: 0,
            };
            buffers.groups = passes
                .iter()
                .enumerate()
                .map(|(place, pass)| {
                    pass.reads().next()?;
                    Some([0, 1].map(|parity| {
                        let view =
                            |letter, filter| buffers.view(passes, letter, filter, place, parity);
                        pass.bind(gpu, &view)
                    }))
                })
                .collect();
            buffers
        })
    }

    /// What a pass reads of a buffer: this frame's if that was drawn before it, else the last one's.
    fn view(
        &self,
        passes: &[GpuPass],
        letter: BufferLetter,
        filter: Filter,
        place: usize,
        parity: usize,
    ) -> &wgpu::TextureView {
        let writer = passes.iter().position(|pass| pass.draws() == Some(letter));
        let is_fresh = writer.is_some_and(|writer| writer < place);
        let pair = self.pairs[letter.index()].as_ref();
        let half = &pair.expect("what is read is there").halves[parity ^ usize::from(is_fresh)];
        match filter {
            Filter::Mipmap => &half.whole,
            Filter::Nearest | Filter::Linear => &half.levels[0],
        }
    }

    /// What is bound for a pass in the frame that is being drawn, if it reads a buffer.
    pub(super) fn group(&self, place: usize) -> Option<&wgpu::BindGroup> {
        let groups = self.groups[place].as_ref()?;
        Some(&groups[self.frames as usize % 2])
    }

    /// What a pass draws into in the frame that is being drawn.
    pub(super) fn target(&self, letter: BufferLetter) -> &wgpu::TextureView {
        &self.drawn(letter).levels[0]
    }

    fn drawn(&self, letter: BufferLetter) -> &Half {
        let pair = self.pairs[letter.index()].as_ref();
        &pair.expect("what is drawn is there").halves[1 - self.frames as usize % 2]
    }

    /// Makes the smaller levels of what a pass has drawn, if anyone reads them.
    pub(super) fn shrink(
        &self,
        gpu: &Gpu,
        mipmaps: &Mipmaps,
        encoder: &mut wgpu::CommandEncoder,
        letter: BufferLetter,
    ) {
        let levels = &self.drawn(letter).levels;
        for pair in levels.windows(2) {
            mipmaps.shrink(gpu, encoder, &pair[0], &pair[1]);
        }
    }

    /// A frame is complete.
    pub(super) fn frame_drawn(&mut self) {
        self.frames = self.frames.wrapping_add(1);
    }

    /// Clears everything, because time begins again.
    pub(super) fn restart(&mut self, encoder: &mut wgpu::CommandEncoder) {
        if self.frames == 0 {
            return;
        }
        self.frames = 0;
        let pairs = self.pairs.iter().flatten();
        let levels = pairs.flat_map(|pair| pair.halves.iter().flat_map(|half| &half.levels));
        for view in levels {
            encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                ..Default::default()
            });
        }
    }

    /// Takes over what others hold, as far as it fits: the lower left of both.
    pub(super) fn take_over(&mut self, gpu: &Gpu, old: &Buffers) {
        let size = self.size.min(old.size);
        let descriptor = wgpu::CommandEncoderDescriptor { label: None };
        let mut encoder = gpu.device().create_command_encoder(&descriptor);
        for (own, other) in self.pairs.iter().zip(&old.pairs) {
            let (Some(own), Some(other)) = (own, other) else {
                continue;
            };
            for (own, other) in own.halves.iter().zip(&other.halves) {
                encoder.copy_texture_to_texture(
                    other.texture.as_image_copy(),
                    own.texture.as_image_copy(),
                    wgpu::Extent3d {
                        width: size.x,
                        height: size.y,
                        depth_or_array_layers: 1,
                    },
                );
            }
        }
        gpu.queue().submit([encoder.finish()]);
        self.frames = old.frames;
    }
}
