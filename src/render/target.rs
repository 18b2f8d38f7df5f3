use glam::UVec2;

use super::gpu::{Gpu, GpuError};

/// What a target holds of each channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Format {
    /// 8 bits without sRGB, as a window shows it.
    #[default]
    Bytes,
    /// 32-bit floats as the shader gives them, for those who measure.
    Floats,
}

impl Format {
    pub(super) fn texture(self) -> wgpu::TextureFormat {
        match self {
            Format::Bytes => wgpu::TextureFormat::Rgba8Unorm,
            Format::Floats => wgpu::TextureFormat::Rgba32Float,
        }
    }

    /// Bytes of a pixel.
    pub(super) fn stride(self) -> u32 {
        match self {
            Format::Bytes => 4,
            Format::Floats => 16,
        }
    }
}

/// The texture that the Image pass draws into, row 0 at the bottom.
#[derive(Debug)]
pub struct Target {
    size: UVec2,
    format: Format,
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

impl Target {
    /// A target of `size` pixels, each side from 1 to the device's limit.
    pub fn new(gpu: &Gpu, size: UVec2, format: Format) -> Result<Self, GpuError> {
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
                format: format.texture(),
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                    | wgpu::TextureUsages::COPY_SRC
                    | wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            })
        })?;
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Target {
            size,
            format,
            texture,
            view,
        })
    }

    /// Width and height in pixels.
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// What it holds.
    pub fn format(&self) -> Format {
        self.format
    }

    pub(super) fn texture(&self) -> &wgpu::Texture {
        &self.texture
    }

    pub(super) fn view(&self) -> &wgpu::TextureView {
        &self.view
    }
}
