//! Smaller levels of textures, made from larger ones.

use super::gpu::{Gpu, GpuError};
use super::pass::{full_screen_pass, full_screen_pipeline};

/// Makes smaller levels of textures in the formats that it was prepared for; for none, it holds nothing.
#[derive(Debug, Default)]
pub(super) struct Mipmaps {
    common: Option<Common>,
    pipelines: Vec<(wgpu::TextureFormat, wgpu::RenderPipeline)>,
}

/// What is the same for all formats.
#[derive(Debug)]
struct Common {
    layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    fragment: wgpu::ShaderModule,
}

impl Common {
    fn new(gpu: &Gpu) -> Self {
        let device = gpu.device();
        let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty,
            count: None,
        };
        let texture = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
        Common {
            layout: device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: None,
                entries: &[entry(0, texture), entry(1, sampler)],
            }),
            sampler: device.create_sampler(&wgpu::SamplerDescriptor {
                mag_filter: wgpu::FilterMode::Linear,
                min_filter: wgpu::FilterMode::Linear,
                ..Default::default()
            }),
            fragment: device.create_shader_module(wgpu::include_wgsl!("mipmap.wgsl")),
        }
    }
}

impl Mipmaps {
    /// Makes ready for textures of this format.
    pub fn prepare(&mut self, gpu: &Gpu, format: wgpu::TextureFormat) -> Result<(), GpuError> {
        if self.pipelines.iter().any(|(known, _)| *known == format) {
            return Ok(());
        }
        let common = &mut self.common;
        let pipeline = gpu.guarded("compiling the making of smaller levels", || {
            let common = common.get_or_insert_with(|| Common::new(gpu));
            let layout = Some(&common.layout);
            full_screen_pipeline(gpu, layout, &common.fragment, "shrink", format)
        })?;
        self.pipelines.push((format, pipeline));
        Ok(())
    }

    /// Records the making of each level from the one above it. Without preparation for the format it does nothing.
    pub fn shrink(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        format: wgpu::TextureFormat,
        levels: &[wgpu::TextureView],
    ) {
        let mut pipelines = self.pipelines.iter();
        let pipeline = pipelines.find(|(known, _)| *known == format);
        let (Some(common), Some((_, pipeline))) = (&self.common, pipeline) else {
            return;
        };
        for pair in levels.windows(2) {
            let group = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &common.layout,
                entries: &[
                    wgpu::BindGroupEntry {
                        binding: 0,
                        resource: wgpu::BindingResource::TextureView(&pair[0]),
                    },
                    wgpu::BindGroupEntry {
                        binding: 1,
                        resource: wgpu::BindingResource::Sampler(&common.sampler),
                    },
                ],
            });
            full_screen_pass(encoder, &pair[1], pipeline, Some(&group), None);
        }
    }
}

/// Each level of each layer of a texture by itself.
pub(super) fn levels_of_layers(texture: &wgpu::Texture) -> Vec<Vec<wgpu::TextureView>> {
    let view = |layer: u32, level: u32| {
        texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2),
            base_array_layer: layer,
            array_layer_count: Some(1),
            base_mip_level: level,
            mip_level_count: Some(1),
            ..Default::default()
        })
    };
    let levels = |layer| {
        (0..texture.mip_level_count())
            .map(|level| view(layer, level))
            .collect()
    };
    (0..texture.depth_or_array_layers()).map(levels).collect()
}
