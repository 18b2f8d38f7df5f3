//! What is bound to a channel: a texture and a sampler, made only if the pass uses them.

use super::gpu::{Gpu, GpuError};
use crate::frame::Keyboard;
use crate::scene::{self, Channel, Filter, Input, Wrap};

/// Texels on their way to the GPU, row 0 at the bottom.
struct Texels {
    size: u32,
    rgba: Vec<u8>,
}

/// Uploads the texture behind a channel; an unbound channel reads (0, 0, 0, 1).
pub(super) fn texture(gpu: &Gpu, channel: Option<&Channel>) -> Result<wgpu::Texture, GpuError> {
    let texels = match channel.map(|channel| &channel.input) {
        Some(Input::Noise) => Texels {
            size: scene::NOISE_SIZE,
            rgba: scene::noise_texture(),
        },
        // Other inputs do not get here yet: `session::require_drawable` refuses them.
        _ => Texels {
            size: 1,
            rgba: vec![0, 0, 0, 255],
        },
    };
    let levels = match channel.map(|channel| channel.sampling.filter) {
        Some(Filter::Mipmap) => mip_chain(texels),
        _ => vec![texels],
    };
    let extent = |size| wgpu::Extent3d {
        width: size,
        height: size,
        depth_or_array_layers: 1,
    };
    gpu.guarded("making a channel's texture", || {
        let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("channel"),
            size: extent(levels[0].size),
            mip_level_count: levels.len() as u32,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        for (level, texels) in levels.iter().enumerate() {
            gpu.queue().write_texture(
                wgpu::TexelCopyTextureInfo {
                    mip_level: level as u32,
                    ..texture.as_image_copy()
                },
                &texels.rgba,
                wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(4 * texels.size),
                    rows_per_image: None,
                },
                extent(texels.size),
            );
        }
        texture
    })
}

/// The texture behind a channel that reads the keyboard.
pub(super) fn keyboard(gpu: &Gpu) -> Result<wgpu::Texture, GpuError> {
    gpu.guarded("making the keyboard's texture", || {
        gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("keyboard"),
            size: keyboard_size(),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::R8Unorm,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        })
    })
}

fn keyboard_size() -> wgpu::Extent3d {
    let [width, height] = Keyboard::SIZE;
    wgpu::Extent3d {
        width,
        height,
        depth_or_array_layers: 1,
    }
}

/// Writes the keys as a frame has them.
pub(super) fn press(gpu: &Gpu, texture: &wgpu::Texture, keyboard: &Keyboard) {
    gpu.queue().write_texture(
        texture.as_image_copy(),
        &keyboard.texels(),
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(Keyboard::SIZE[0]),
            rows_per_image: None,
        },
        keyboard_size(),
    );
}

/// Every level down to one texel, each the mean of 2 × 2 texels of the one before, as GL's
/// `generateMipmap` makes them for sizes that are powers of two.
fn mip_chain(base: Texels) -> Vec<Texels> {
    let mut levels = vec![base];
    while let Some(last) = levels.last()
        && last.size > 1
    {
        let size = last.size / 2;
        let mut rgba = Vec::with_capacity(4 * (size * size) as usize);
        for y in 0..size {
            for x in 0..size {
                for channel in 0..4 {
                    let at = |dx, dy| {
                        let index = (2 * y + dy) * last.size + 2 * x + dx;
                        u32::from(last.rgba[4 * index as usize + channel])
                    };
                    let sum = at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1);
                    rgba.push(((sum + 2) / 4) as u8);
                }
            }
        }
        levels.push(Texels { size, rgba });
    }
    levels
}

/// The sampler of a channel; it does not matter for an unbound one.
pub(super) fn sampler(gpu: &Gpu, channel: Option<&Channel>) -> wgpu::Sampler {
    let (filter, wrap) = match channel {
        Some(Channel { sampling, .. }) => (sampling.filter, sampling.wrap),
        None => (Filter::Nearest, Wrap::Clamp),
    };
    let address = match wrap {
        Wrap::Clamp => wgpu::AddressMode::ClampToEdge,
        Wrap::Repeat => wgpu::AddressMode::Repeat,
    };
    let between = match filter {
        Filter::Nearest => wgpu::FilterMode::Nearest,
        Filter::Linear | Filter::Mipmap => wgpu::FilterMode::Linear,
    };
    gpu.device().create_sampler(&wgpu::SamplerDescriptor {
        label: Some("channel"),
        address_mode_u: address,
        address_mode_v: address,
        address_mode_w: address,
        mag_filter: between,
        min_filter: between,
        mipmap_filter: match filter {
            Filter::Mipmap => wgpu::MipmapFilterMode::Linear,
            Filter::Nearest | Filter::Linear => wgpu::MipmapFilterMode::Nearest,
        },
        ..Default::default()
    })
}

/// `iChannelResolution` of a channel: width, height and depth in texels, 0 if unbound; `None` of a buffer,
/// which is as large as the picture.
pub(super) fn resolution(channel: Option<&Channel>) -> Option<glam::Vec3> {
    match channel.map(|channel| &channel.input) {
        Some(Input::Noise) => {
            let size = scene::NOISE_SIZE as f32;
            Some(glam::vec3(size, size, 1.0))
        }
        Some(Input::Keyboard) => {
            let [width, height] = Keyboard::SIZE.map(|side| side as f32);
            Some(glam::vec3(width, height, 1.0))
        }
        Some(Input::Buffer(_)) => None,
        _ => Some(glam::Vec3::ZERO),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mip_levels_are_means() {
        let base = Texels {
            size: 2,
            rgba: vec![
                0, 10, 20, 255, 4, 10, 20, 255, 8, 10, 20, 255, 12, 11, 20, 255,
            ],
        };
        let levels = mip_chain(base);
        assert_eq!(levels.len(), 2);
        assert_eq!(levels[1].rgba, [6, 10, 20, 255]);
    }
}
