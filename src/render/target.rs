use glam::UVec2;

use super::gpu::{Gpu, GpuError};

/// The texture that the Image pass draws into: 8 bits a channel, no sRGB, row 0 at the bottom.
#[derive(Debug)]
pub struct Target {
    size: UVec2,
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

impl Target {
    /// The format of every target.
    pub(super) const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

    /// A target of `size` pixels, each side from 1 to the device's limit.
    pub fn new(gpu: &Gpu, size: UVec2) -> Result<Self, GpuError> {
        let limit = gpu.max_size();
        if size.min_element() == 0 || size.max_element() > limit {
            return Err(GpuError::Size { size, limit });
        }
        let texture = gpu.guarded("making the picture's texture", || {
            gpu.device().create_texture(&wgpu::TextureDescriptor {
                label: Some("picture"),
                size: wgpu::Extent3d {
                    width: size.x,
                    height: size.y,
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: Self::FORMAT,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                    | wgpu::TextureUsages::COPY_SRC
                    | wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            })
        })?;
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Target {
            size,
            texture,
            view,
        })
    }

    /// Width and height in pixels.
    pub fn size(&self) -> UVec2 {
        self.size
    }

    pub(super) fn texture(&self) -> &wgpu::Texture {
        &self.texture
    }

    pub(super) fn view(&self) -> &wgpu::TextureView {
        &self.view
    }
}
