//! Smaller levels of textures that are drawn.

use super::gpu::{Gpu, GpuError};
use super::pass::{full_screen_pass, full_screen_pipeline};

/// Makes smaller levels of buffers.
#[derive(Debug)]
pub(super) struct Mipmaps {
    /// One for each format of what is shrunk.
    pipelines: Vec<(wgpu::TextureFormat, wgpu::RenderPipeline)>,
    layout: wgpu::BindGroupLayout,
}

impl Mipmaps {
    pub fn new(gpu: &Gpu, formats: &[wgpu::TextureFormat]) -> Result<Self, GpuError> {
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
            let pipeline = |&format: &wgpu::TextureFormat| {
                let pipeline =
                    full_screen_pipeline(gpu, Some(&layout), &fragment, "shrink", format);
                (format, pipeline)
            };
            Mipmaps {
                pipelines: formats.iter().map(pipeline).collect(),
                layout,
            }
        })
    }

    /// Records the making of a level from the one above it.
    pub fn shrink(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        format: wgpu::TextureFormat,
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
        let mut pipelines = self.pipelines.iter();
        let (_, pipeline) = pipelines
            .find(|(other, _)| *other == format)
            .expect("made for what is shrunk");
        full_screen_pass(encoder, level, pipeline, Some(&group), None);
    }
}
