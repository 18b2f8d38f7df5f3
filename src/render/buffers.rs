//! What buffer passes draw for other passes: two textures each, of which one holds what was drawn last while the
//! other is drawn into.

use glam::UVec2;

use super::gpu::{Gpu, GpuError};
use super::mipmap::{Mipmaps, levels_of_layers};
use super::pass::GpuPass;
use crate::scene::{BufferLetter, Filter, Input, PassKind};

/// Width and height of the faces of the cubemap that a pass draws, in texels.
pub(super) const CUBE_SIDE: u32 = 1024;

/// What a pass draws for other passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Surface {
    Buffer(BufferLetter),
    Cube,
}

impl Surface {
    const ALL: [Surface; 5] = [
        Surface::Buffer(BufferLetter::A),
        Surface::Buffer(BufferLetter::B),
        Surface::Buffer(BufferLetter::C),
        Surface::Buffer(BufferLetter::D),
        Surface::Cube,
    ];

    /// What passes of this kind draw, if it is for others.
    pub fn drawn_by(kind: PassKind) -> Option<Self> {
        match kind {
            PassKind::Buffer(letter) => Some(Surface::Buffer(letter)),
            PassKind::Cube => Some(Surface::Cube),
            PassKind::Image | PassKind::Sound => None,
        }
    }

    /// What an input reads, if a pass draws it.
    pub fn read_by(input: &Input) -> Option<Self> {
        Surface::drawn_by(input.pass()?)
    }

    fn index(self) -> usize {
        match self {
            Surface::Buffer(letter) => letter.index(),
            Surface::Cube => 4,
        }
    }

    pub fn faces(self) -> u32 {
        match self {
            Surface::Buffer(_) => 1,
            Surface::Cube => 6,
        }
    }

    /// Width and height beside a picture of that size.
    pub fn size(self, picture: UVec2) -> UVec2 {
        match self {
            Surface::Buffer(_) => picture,
            Surface::Cube => UVec2::splat(CUBE_SIDE),
        }
    }

    pub fn format(self, gpu: &Gpu) -> wgpu::TextureFormat {
        match self {
            Surface::Buffer(_) => gpu.buffer_format(),
            Surface::Cube => wgpu::TextureFormat::Rgba16Float,
        }
    }
}

/// The buffers of a scene in pictures of one size, and how many frames they have seen.
#[derive(Debug)]
pub struct Buffers {
    size: UVec2,
    pairs: [Option<Pair>; Surface::ALL.len()],
    /// For each pass what it draws.
    draws: Vec<Option<Turn>>,
    /// What is bound for each pass that reads one, in even frames and in odd ones, for each face that it draws.
    groups: Vec<Option<[Vec<wgpu::BindGroup>; 2]>>,
    frames: u32,
}

/// When in a frame something is drawn or read of a buffer. Several passes may draw one, which then goes from half to half
/// several times.
#[derive(Clone, Copy, Debug)]
struct Turn {
    surface: Surface,
    /// How often it is drawn in a frame.
    count: usize,
    /// How often before this.
    before: usize,
}

impl Turn {
    fn new(passes: &[GpuPass], surface: Surface, place: usize) -> Self {
        let is_drawn = |pass: &&GpuPass| pass.draws() == Some(surface);
        Turn {
            surface,
            count: passes.iter().filter(is_drawn).count(),
            before: passes[..place].iter().filter(is_drawn).count(),
        }
    }

    /// The half that was drawn last; the other one is drawn into. `parity` is that of the frame.
    fn latest(&self, parity: usize) -> usize {
        (parity * self.count + self.before) % 2
    }
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
    /// The largest level.
    largest: wgpu::TextureView,
    /// Each level of each face by itself.
    faces: Vec<Vec<wgpu::TextureView>>,
}

impl Half {
    fn new(gpu: &Gpu, surface: Surface, picture: UVec2, levels: u32) -> Self {
        let size = surface.size(picture);
        let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("buffer"),
            size: extent(surface, size),
            mip_level_count: levels,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: surface.format(gpu),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC
                | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let seen = |levels: Option<u32>| {
            texture.create_view(&wgpu::TextureViewDescriptor {
                dimension: Some(match surface {
                    Surface::Buffer(_) => wgpu::TextureViewDimension::D2,
                    Surface::Cube => wgpu::TextureViewDimension::Cube,
                }),
                mip_level_count: levels,
                ..Default::default()
            })
        };
        Half {
            whole: seen(None),
            largest: seen(Some(1)),
            faces: levels_of_layers(&texture),
            texture,
        }
    }
}

fn extent(surface: Surface, size: UVec2) -> wgpu::Extent3d {
    wgpu::Extent3d {
        width: size.x,
        height: size.y,
        depth_or_array_layers: surface.faces(),
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
            let pairs = Surface::ALL.map(|surface| {
                let is_drawn = passes.iter().any(|pass| pass.draws() == Some(surface));
                let mut readers = reads().filter(|(read, _)| *read == surface).peekable();
                if !is_drawn && readers.peek().is_none() {
                    return None;
                }
                let is_shrunk = readers.any(|(_, filter)| filter == Filter::Mipmap);
                let levels = match is_shrunk {
                    true => surface.size(size).max_element().ilog2() + 1,
                    false => 1,
                };
                let halves = [(); 2].map(|()| Half::new(gpu, surface, size, levels));
                Some(Pair { halves })
            });
            let turn =
                |(place, pass): (usize, &GpuPass)| Some(Turn::new(passes, pass.draws()?, place));
            let mut buffers = Buffers {
                size,
                pairs,
                draws: passes.iter().enumerate().map(turn).collect(),
                groups: Vec::new(),
                frames: 0,
            };
            buffers.groups = passes
                .iter()
                .enumerate()
                .map(|(place, pass)| {
                    pass.reads().next()?;
                    Some([0, 1].map(|parity| {
                        let view = |surface, filter| {
                            buffers.view(Turn::new(passes, surface, place), filter, parity)
                        };
                        pass.bind(gpu, &view)
                    }))
                })
                .collect();
            buffers
        })
    }

    /// What a pass reads of a buffer: this frame's if that was drawn before it, else the last one's.
    fn view(&self, turn: Turn, filter: Filter, parity: usize) -> &wgpu::TextureView {
        let pair = self.pairs[turn.surface.index()].as_ref();
        let half = &pair.expect("what is read is there").halves[turn.latest(parity)];
        match filter {
            Filter::Mipmap => &half.whole,
            Filter::Nearest | Filter::Linear => &half.largest,
        }
    }

    /// What is bound for a pass in the frame that is being drawn, if it reads a buffer.
    pub(super) fn group(&self, place: usize, face: usize) -> Option<&wgpu::BindGroup> {
        let groups = self.groups[place].as_ref()?;
        Some(&groups[self.frames as usize % 2][face])
    }

    /// What a pass draws into in the frame that is being drawn; `None` is the picture.
    pub(super) fn target(&self, place: usize, face: usize) -> Option<&wgpu::TextureView> {
        let (_, half) = self.drawn(place)?;
        Some(&half.faces[face][0])
    }

    fn drawn(&self, place: usize) -> Option<(Surface, &Half)> {
        let turn = self.draws[place]?;
        let pair = self.pairs[turn.surface.index()].as_ref();
        let half = 1 - turn.latest(self.frames as usize % 2);
        Some((
            turn.surface,
            &pair.expect("what is drawn is there").halves[half],
        ))
    }

    /// Makes the smaller levels of what a pass has drawn, if anyone reads them.
    pub(super) fn shrink(
        &self,
        gpu: &Gpu,
        mipmaps: &Mipmaps,
        encoder: &mut wgpu::CommandEncoder,
        place: usize,
    ) {
        let Some((surface, half)) = self.drawn(place) else {
            return;
        };
        for levels in &half.faces {
            mipmaps.shrink(gpu, encoder, surface.format(gpu), levels);
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
        let halves = pairs.flat_map(|pair| &pair.halves);
        for view in halves.flat_map(|half| half.faces.iter().flatten()) {
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
        let picture = self.size.min(old.size);
        let descriptor = wgpu::CommandEncoderDescriptor { label: None };
        let mut encoder = gpu.device().create_command_encoder(&descriptor);
        for surface in Surface::ALL {
            let index = surface.index();
            let (Some(own), Some(other)) = (&self.pairs[index], &old.pairs[index]) else {
                continue;
            };
            for (own, other) in own.halves.iter().zip(&other.halves) {
                encoder.copy_texture_to_texture(
                    other.texture.as_image_copy(),
                    own.texture.as_image_copy(),
                    extent(surface, surface.size(picture)),
                );
            }
        }
        gpu.queue().submit([encoder.finish()]);
        self.frames = old.frames;
    }
}
