//! Textures of what is loaded: pictures, cubemaps, volumes, and what changes with time.

use std::sync::{Arc, Mutex};

use half::f16;

use super::gpu::{Gpu, GpuError};
use super::mipmap::{Mipmaps, levels_of_layers};
use crate::media::{Content, Feed, Format, Texels};
use crate::scene::{Channel, Filter, Input, SamplerKind};

/// The textures of a renderer, each made once whoever reads it.
#[derive(Debug, Default)]
pub(super) struct Textures {
    still: Vec<(Arc<Texels>, Use, wgpu::TextureView)>,
    live: Vec<Live>,
    /// What makes their smaller levels, and those of what passes draw.
    pub mipmaps: Mipmaps,
}

/// How a channel wants its texture made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Use {
    kind: SamplerKind,
    is_flipped: bool,
    is_shrunk: bool,
}

/// A texture for each way in which something that changes with time is read.
#[derive(Debug)]
struct Live {
    feed: Arc<Mutex<dyn Feed>>,
    textures: Vec<(bool, wgpu::Texture)>,
    /// The time of what the textures hold.
    time: Option<f32>,
}

impl Textures {
    /// The texture of what a channel reads, without what only some readers see.
    pub fn view(
        &mut self,
        gpu: &Gpu,
        channel: &Channel,
        content: &Content,
    ) -> Result<wgpu::TextureView, GpuError> {
        let usage = Use {
            kind: channel.input.sampler(),
            is_flipped: channel.sampling.vflip && heeds_vflip(&channel.input),
            is_shrunk: channel.sampling.filter == Filter::Mipmap,
        };
        match content {
            Content::Still(texels) => {
                let is_known = |(other, other_usage, _): &&(Arc<Texels>, Use, _)| {
                    Arc::ptr_eq(other, texels) && *other_usage == usage
                };
                if let Some((.., view)) = self.still.iter().find(is_known) {
                    return Ok(view.clone());
                }
                let view = upload(gpu, &mut self.mipmaps, texels, usage)?;
                self.still.push((Arc::clone(texels), usage, view.clone()));
                Ok(view)
            }
            Content::Live(feed) => self.live_view(gpu, feed, usage.is_flipped),
        }
    }

    fn live_view(
        &mut self,
        gpu: &Gpu,
        feed: &Arc<Mutex<dyn Feed>>,
        is_flipped: bool,
    ) -> Result<wgpu::TextureView, GpuError> {
        let known = self
            .live
            .iter()
            .position(|live| Arc::ptr_eq(&live.feed, feed));
        let place = known.unwrap_or_else(|| {
            self.live.push(Live {
                feed: Arc::clone(feed),
                textures: Vec::new(),
                time: None,
            });
            self.live.len() - 1
        });
        let live = &mut self.live[place];
        let texture = match live.textures.iter().find(|(other, _)| *other == is_flipped) {
            Some((_, texture)) => texture.clone(),
            None => {
                let feed = feed.lock().expect("no holder panics");
                let ([width, height], format) = (feed.size(), feed.format());
                let texture = new_texture(gpu, SamplerKind::TwoD, [width, height, 1], format, 1)?;
                live.textures.push((is_flipped, texture.clone()));
                texture
            }
        };
        Ok(texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }

    /// Brings what changes with time to where it is at `time` seconds.
    pub fn advance(&mut self, gpu: &Gpu, time: f32) {
        for live in &mut self.live {
            if live.time == Some(time) {
                continue;
            }
            live.time = Some(time);
            let mut feed = live.feed.lock().expect("no holder panics");
            let ([width, height], format) = (feed.size(), feed.format());
            if let Some(texels) = feed.texels(f64::from(time)) {
                let row = width as usize * format.bytes();
                let flipped: Vec<u8> = texels.chunks(row).rev().flatten().copied().collect();
                for (is_flipped, texture) in &live.textures {
                    let bytes = if *is_flipped { &flipped } else { texels };
                    write(gpu, texture, [width, height, 1], bytes);
                }
            }
        }
    }
}

/// Whether `vflip` means something to what a channel reads.
fn heeds_vflip(input: &Input) -> bool {
    matches!(
        input,
        Input::Noise | Input::Texture(_) | Input::Cubemap(_) | Input::Video(_) | Input::Webcam
    )
}

/// What is read where nothing is bound: (0, 0, 0, 1), as WebGL has it.
pub(super) fn unbound(gpu: &Gpu, kind: SamplerKind) -> Result<wgpu::TextureView, GpuError> {
    let layers = if kind == SamplerKind::Cube { 6 } else { 1 };
    let texels = Texels {
        size: [1, 1, layers],
        format: Format::Rgba8,
        bytes: [0, 0, 0, 255].repeat(layers as usize),
    };
    let usage = Use {
        kind,
        is_flipped: false,
        is_shrunk: false,
    };
    upload(gpu, &mut Mipmaps::default(), &texels, usage)
}

pub(super) fn dimension(kind: SamplerKind) -> wgpu::TextureViewDimension {
    match kind {
        SamplerKind::TwoD => wgpu::TextureViewDimension::D2,
        SamplerKind::ThreeD => wgpu::TextureViewDimension::D3,
        SamplerKind::Cube => wgpu::TextureViewDimension::Cube,
    }
}

fn upload(
    gpu: &Gpu,
    mipmaps: &mut Mipmaps,
    texels: &Texels,
    usage: Use,
) -> Result<wgpu::TextureView, GpuError> {
    let [width, height, depth] = texels.size;
    let (largest, limit) = match usage.kind {
        SamplerKind::ThreeD => {
            let limit = gpu.device().limits().max_texture_dimension_3d;
            (width.max(height).max(depth), limit)
        }
        _ => (width.max(height), gpu.max_size()),
    };
    if largest > limit {
        let size = glam::uvec2(width, height);
        return Err(GpuError::Size { size, limit });
    }
    let mut stored = Stored::new(texels);
    if usage.is_flipped {
        stored.flip(usage.kind);
    }
    let count = if usage.is_shrunk {
        largest.ilog2() + 1
    } else {
        1
    };
    let texture = new_texture(gpu, usage.kind, texels.size, texels.format, count)?;
    let format = texture.format();
    if count > 1 {
        let dimension = match usage.kind {
            SamplerKind::ThreeD => wgpu::TextureViewDimension::D3,
            SamplerKind::TwoD | SamplerKind::Cube => wgpu::TextureViewDimension::D2,
        };
        mipmaps.prepare(gpu, format, dimension)?;
    }
    gpu.guarded("filling a channel's texture", || {
        write(gpu, &texture, texels.size, &stored.bytes(format));
        if count > 1 {
            let descriptor = wgpu::CommandEncoderDescriptor { label: None };
            let mut encoder = gpu.device().create_command_encoder(&descriptor);
            if usage.kind == SamplerKind::ThreeD {
                mipmaps.shrink_volume(gpu, &mut encoder, &texture);
            } else {
                for levels in levels_of_layers(&texture) {
                    mipmaps.shrink(gpu, &mut encoder, format, &levels);
                }
            }
            gpu.queue().submit([encoder.finish()]);
        }
        texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(dimension(usage.kind)),
            ..Default::default()
        })
    })
}

fn new_texture(
    gpu: &Gpu,
    kind: SamplerKind,
    [width, height, depth]: [u32; 3],
    format: Format,
    levels: u32,
) -> Result<wgpu::Texture, GpuError> {
    use wgpu::TextureFormat::{R8Unorm, R16Float, R32Float, Rgba8Unorm, Rgba16Float, Rgba32Float};
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    gpu.guarded("making a channel's texture", || {
        gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("channel"),
            size: wgpu::Extent3d {
                width,
                height,
                depth_or_array_layers: depth,
            },
            mip_level_count: levels,
            sample_count: 1,
            dimension: match kind {
                SamplerKind::ThreeD => wgpu::TextureDimension::D3,
                _ => wgpu::TextureDimension::D2,
            },
            // Not every device filters between floats of 32 bits.
            format: match (format, gpu.filters_floats()) {
                (Format::R8, _) => R8Unorm,
                (Format::Rgba8, _) => Rgba8Unorm,
                (Format::R32Float, true) => R32Float,
                (Format::R32Float, false) => R16Float,
                (Format::Rgba32Float, true) => Rgba32Float,
                (Format::Rgba32Float, false) => Rgba16Float,
            },
            usage: match levels > 1 {
                true => usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                false => usage,
            },
            view_formats: &[],
        })
    })
}

fn write(gpu: &Gpu, texture: &wgpu::Texture, size: [u32; 3], bytes: &[u8]) {
    let [width, height, depth] = size;
    let texel = texture.format().block_copy_size(None);
    gpu.queue().write_texture(
        texture.as_image_copy(),
        bytes,
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: texel.map(|texel| texel * width),
            rows_per_image: Some(height),
        },
        wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: depth,
        },
    );
}

/// The numbers of a texture as they are stored: bytes from 0 to 255, floats as they are.
struct Stored {
    size: [u32; 3],
    components: usize,
    numbers: Vec<f32>,
}

impl Stored {
    fn new(texels: &Texels) -> Self {
        let numbers = match texels.format {
            Format::R8 | Format::Rgba8 => texels.bytes.iter().copied().map(f32::from).collect(),
            Format::R32Float | Format::Rgba32Float => {
                let floats = texels.bytes.as_chunks().0.iter();
                floats.map(|bytes| f32::from_le_bytes(*bytes)).collect()
            }
        };
        Stored {
            size: texels.size,
            components: match texels.format {
                Format::R8 | Format::R32Float => 1,
                Format::Rgba8 | Format::Rgba32Float => 4,
            },
            numbers,
        }
    }

    /// Turns each layer over, so that its last row becomes the first. The faces of a cubemap that look up and down change
    /// places then.
    fn flip(&mut self, kind: SamplerKind) {
        let row = self.size[0] as usize * self.components;
        let layer = row * self.size[1] as usize;
        for layer in self.numbers.chunks_mut(layer) {
            let turned: Vec<f32> = layer.chunks(row).rev().flatten().copied().collect();
            layer.copy_from_slice(&turned);
        }
        if kind == SamplerKind::Cube {
            let (up, down) = self.numbers[2 * layer..4 * layer].split_at_mut(layer);
            up.swap_with_slice(down);
        }
    }

    /// The numbers as a texture of this format wants them.
    fn bytes(&self, format: wgpu::TextureFormat) -> Vec<u8> {
        use wgpu::TextureFormat::{R16Float, R32Float, Rgba16Float, Rgba32Float};
        let numbers = self.numbers.iter();
        match format {
            R32Float | Rgba32Float => numbers.flat_map(|number| number.to_le_bytes()).collect(),
            R16Float | Rgba16Float => {
                let largest = f16::MAX.to_f32();
                let halves = numbers.map(|number| f16::from_f32(number.clamp(-largest, largest)));
                halves.flat_map(f16::to_le_bytes).collect()
            }
            _ => numbers.map(|&number| number as u8).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stored(size: [u32; 3], bytes: &[u8]) -> Stored {
        Stored::new(&Texels {
            size,
            format: Format::R8,
            bytes: bytes.to_vec(),
        })
    }

    #[test]
    fn a_flipped_cubemap_looks_up_where_it_looked_down() {
        let mut faces = stored([1, 2, 6], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
        faces.flip(SamplerKind::Cube);
        assert_eq!(
            faces.numbers,
            [1, 0, 3, 2, 7, 6, 5, 4, 9, 8, 11, 10].map(|n| n as f32)
        );
    }
}
