//! Smaller levels of textures, made from larger ones.

use super::gpu::{Gpu, GpuError};
use super::pass::{full_screen_pass, full_screen_pipeline};

/// Makes smaller levels of textures of the kinds that it was prepared for; for none, it holds nothing.
#[derive(Debug, Default)]
pub(super) struct Mipmaps {
    common: Option<Common>,
    shrinkers: Vec<Shrinker>,
}

/// What is the same for all kinds.
#[derive(Debug)]
struct Common {
    sampler: wgpu::Sampler,
    fragment: wgpu::ShaderModule,
}

/// What makes levels of one kind of texture: flat ones or volumes, in one format.
#[derive(Debug)]
struct Shrinker {
    kind: (wgpu::TextureFormat, wgpu::TextureViewDimension),
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

impl Common {
    fn new(gpu: &Gpu) -> Self {
        let device = gpu.device();
        Common {
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
    /// Makes ready for flat textures (`D2`) or volumes (`D3`) of this format.
    pub fn prepare(
        &mut self,
        gpu: &Gpu,
        format: wgpu::TextureFormat,
        dimension: wgpu::TextureViewDimension,
    ) -> Result<(), GpuError> {
        let kind = (format, dimension);
        if self.shrinker(kind).is_some() {
            return Ok(());
        }
        let common = &mut self.common;
        let shrinker = gpu.guarded("compiling the making of smaller levels", || {
            let common = common.get_or_insert_with(|| Common::new(gpu));
            let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
                binding,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty,
                count: None,
            };
            let texture = wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: true },
                view_dimension: dimension,
                multisampled: false,
            };
            let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
            let (place, name) = match dimension {
                wgpu::TextureViewDimension::D3 => (1, "shrink_volume"),
                _ => (0, "shrink"),
            };
            let layout = gpu
                .device()
                .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                    label: None,
                    entries: &[entry(place, texture), entry(2, sampler)],
                });
            let fragment = &common.fragment;
            let pipeline = full_screen_pipeline(gpu, Some(&layout), fragment, name, format);
            Shrinker {
                kind,
                layout,
                pipeline,
            }
        })?;
        self.shrinkers.push(shrinker);
        Ok(())
    }

    fn shrinker(
        &self,
        kind: (wgpu::TextureFormat, wgpu::TextureViewDimension),
    ) -> Option<&Shrinker> {
        self.shrinkers.iter().find(|shrinker| shrinker.kind == kind)
    }

    /// What reads a level, bound at `place`.
    fn bind(
        &self,
        gpu: &Gpu,
        shrinker: &Shrinker,
        place: u32,
        level: &wgpu::TextureView,
    ) -> Option<wgpu::BindGroup> {
        let common = self.common.as_ref()?;
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        Some(gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &shrinker.layout,
            entries: &[
                entry(place, wgpu::BindingResource::TextureView(level)),
                entry(2, wgpu::BindingResource::Sampler(&common.sampler)),
            ],
        }))
    }

    /// Records the making of each level from the one above it. Without preparation for the format it does nothing.
    pub fn shrink(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        format: wgpu::TextureFormat,
        levels: &[wgpu::TextureView],
    ) {
        let Some(shrinker) = self.shrinker((format, wgpu::TextureViewDimension::D2)) else {
            return;
        };
        for pair in levels.windows(2) {
            let group = self.bind(gpu, shrinker, 0, &pair[0]);
            full_screen_pass(encoder, &pair[1], &shrinker.pipeline, group.as_ref(), None);
        }
    }

    /// The same for a volume, layer by layer.
    pub fn shrink_volume(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        texture: &wgpu::Texture,
    ) {
        let kind = (texture.format(), wgpu::TextureViewDimension::D3);
        let Some(shrinker) = self.shrinker(kind) else {
            return;
        };
        let view = |level| {
            texture.create_view(&wgpu::TextureViewDescriptor {
                base_mip_level: level,
                mip_level_count: Some(1),
                ..Default::default()
            })
        };
        for level in 1..texture.mip_level_count() {
            let group = self.bind(gpu, shrinker, 1, &view(level - 1));
            let smaller = view(level);
            let side = |side: u32| (side >> level).max(1);
            let depth = side(texture.depth_or_array_layers());
            for layer in 0..depth {
                let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                    color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                        view: &smaller,
                        depth_slice: Some(layer),
                        resolve_target: None,
                        ops: wgpu::Operations::default(),
                    })],
                    ..Default::default()
                });
                pass.set_pipeline(&shrinker.pipeline);
                pass.set_bind_group(0, group.as_ref(), &[]);
                // The shader sees the depth of the viewport, which so tells it the layer.
                let middle = (layer as f32 + 0.5) / depth as f32;
                let (width, height) = (side(texture.width()), side(texture.height()));
                pass.set_viewport(0.0, 0.0, width as f32, height as f32, middle, middle);
                pass.draw(0..3, 0..1);
            }
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
