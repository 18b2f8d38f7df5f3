//! Smaller levels of textures that are drawn.

use super::gpu::{Gpu, GpuError};
use super::pass::{full_screen_pass, full_screen_pipeline};

/// Makes smaller levels of buffers.
#[derive(Debug)]
pub(super) struct Mipmaps {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
}

impl Mipmaps {
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        let device = gpu.device();
        gpu.guarded("compiling the making of smaller levels", || {
            let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: None,
                entries: &[wgpu::BindGroupLayoutEntry {
                    binding: 0,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Texture {
                        sample_type: wgpu::TextureSampleType::Float { filterable: false },
                        view_dimension: wgpu::TextureViewDimension::D2,
                        multisampled: false,
                    },
                    count: None,
                }],
            });
            let fragment = device.create_shader_module(wgpu::include_wgsl!("mipmap.wgsl"));
            let format = gpu.buffer_format();
            let pipeline = full_screen_pipeline(gpu, Some(&layout), &fragment, "shrink", format);
            Mipmaps { pipeline, layout }
        })
    }

    /// Records the making of a level from the one above it.
    pub fn shrink(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        above: &wgpu::TextureView,
        level: &wgpu::TextureView,
    ) {
        let group = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(above),
            }],
        });
        full_screen_pass(encoder, level, &self.pipeline, Some(&group), None);
    }
}
