//! What is bound to a channel besides its texture: a sampler, made only if the pass uses it; and the keyboard.

use glam::{UVec3, Vec3, uvec3};

use super::buffers::{CUBE_SIDE, Surface};
use super::gpu::{Gpu, GpuError};
use crate::frame::Keyboard;
use crate::media::Content;
use crate::scene::{Channel, Filter, Input, Wrap};

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

/// The sampler of a channel; it does not matter for an unbound one.
pub(super) fn sampler(gpu: &Gpu, channel: Option<&Channel>) -> wgpu::Sampler {
    let (filter, wrap) = match channel {
        Some(Channel { sampling, .. }) => (sampling.filter, sampling.wrap),
        None => (Filter::Nearest, Wrap::Clamp),
    };
    let address = match wrap {
        Wrap::Clamp => wgpu::AddressMode::ClampToEdge,
        Wrap::Repeat => wgpu::AddressMode::Repeat,
        Wrap::Mirror => wgpu::AddressMode::MirrorRepeat,
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

/// `iChannelResolution` of a channel: width, height and depth in texels. It is 0 if the channel is unbound, and, as on the
/// site, of cubemaps that no pass draws. `None` of a buffer, which is as large as the picture.
pub(super) fn resolution(channel: Option<&Channel>, content: Option<&Content>) -> Option<Vec3> {
    let input = channel.map(|channel| &channel.input);
    let flat = |[width, height]: [u32; 2]| Some(uvec3(width, height, 1).as_vec3());
    match (input, content) {
        (Some(Input::Keyboard), _) => flat(Keyboard::SIZE),
        (Some(Input::Cubemap(_)), _) => Some(Vec3::ZERO),
        (_, Some(Content::Still(texels))) => Some(UVec3::from(texels.size).as_vec3()),
        (_, Some(Content::Live(feed))) => flat(feed.lock().expect("no holder panics").size()),
        (Some(input), None) => match Surface::read_by(input) {
            Some(Surface::Buffer(_)) => None,
            Some(Surface::Cube) => flat([CUBE_SIDE; 2]),
            None => Some(Vec3::ZERO),
        },
        (None, None) => Some(Vec3::ZERO),
    }
}
