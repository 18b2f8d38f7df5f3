use std::ops::Range;

use super::buffers::Surface;
use super::gpu::{Gpu, GpuError};
use super::texture::{self, Textures};
use super::{
    channel,
    uniforms::{Part, Uniforms},
};
use crate::frame::FrameInput;
use crate::media::Inputs;
use crate::scene::{CHANNELS, Filter, Input, Pass, PassKind, SamplerKind};
use crate::translate::bindings;
use crate::translate::{Program, Tables};

/// What is bound for one pass.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PassLayout {
    /// The entries of the pass's bind group layout; with none, there is no bind group.
    pub entries: Vec<wgpu::BindGroupLayoutEntry>,
}

/// The GPU objects of one pass.
#[derive(Debug)]
pub(super) struct GpuPass {
    kind: PassKind,
    pipeline: wgpu::RenderPipeline,
    layout: PassLayout,
    group_layout: Option<wgpu::BindGroupLayout>,
    /// What is bound for each face, if it is the same in every frame.
    bind_groups: Vec<wgpu::BindGroup>,
    uniforms: Option<Uniforms>,
    tables: Option<wgpu::Buffer>,
    /// Where the pass notes its findings.
    findings: Option<wgpu::Buffer>,
    channels: [BoundChannel; CHANNELS],
}

/// What a pass uses of a channel.
#[derive(Debug, Default)]
struct BoundChannel {
    texture: Option<BoundTexture>,
    sampler: Option<wgpu::Sampler>,
}

#[derive(Debug)]
enum BoundTexture {
    /// One that does not change.
    Fixed(wgpu::TextureView),
    /// What a pass draws.
    Drawn(Surface, Filter),
    /// The keys, which each frame brings anew.
    Keyboard(wgpu::Texture, wgpu::TextureView),
}

/// Where what a pass draws can be seen, if it is read so.
pub(super) type SurfaceView<'v> = dyn Fn(Surface, Filter) -> &'v wgpu::TextureView + 'v;

impl GpuPass {
    pub fn new(
        gpu: &Gpu,
        pass: &Pass,
        program: &Program,
        format: wgpu::TextureFormat,
        place: usize,
        inputs: &Inputs,
        textures: &mut Textures,
    ) -> Result<Self, GpuError> {
        let device = gpu.device();
        if program.is_double() && !gpu.has_float64() {
            let adapter = gpu.describe();
            return Err(GpuError::NoFloat64 { adapter });
        }
        if program.findings.is_some() && !gpu.can_note_findings() {
            let adapter = gpu.describe();
            return Err(GpuError::NoFindings { adapter });
        }
        let layout = layout(pass, program);
        let content = |channel| inputs.of(place, channel);
        let uniforms = program
            .uniforms
            .as_ref()
            .map(|block| Uniforms::new(gpu, block, pass, &content));
        let mut channels: [BoundChannel; CHANNELS] = Default::default();
        for (index, usage) in program.channels.iter().enumerate() {
            let bound = pass.channels[index].as_ref();
            if usage.texture {
                let input = bound.map(|channel| &channel.input);
                channels[index].texture = Some(match (bound, content(index)) {
                    (Some(channel), Some(content)) => {
                        BoundTexture::Fixed(textures.view(gpu, channel, content)?)
                    }
                    (Some(channel), None)
                        if let Some(surface) = Surface::read_by(&channel.input) =>
                    {
                        BoundTexture::Drawn(surface, channel.sampling.filter)
                    }
                    _ if input == Some(&Input::Keyboard) => {
                        let texture = channel::keyboard(gpu)?;
                        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
                        BoundTexture::Keyboard(texture, view)
                    }
                    _ => {
                        let kind = input.map_or(SamplerKind::TwoD, Input::sampler);
                        BoundTexture::Fixed(texture::unbound(gpu, kind)?)
                    }
                });
            }
            if usage.sampler {
                channels[index].sampler = Some(channel::sampler(gpu, bound));
            }
        }
        let tables = program.tables.as_ref().map(|tables| upload(gpu, tables));
        let findings = program.findings.map(|words| findings(gpu, words));
        let (group_layout, pipeline) = gpu.guarded("compiling the shader", || {
            let group_layout = (!layout.entries.is_empty()).then(|| {
                device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                    label: None,
                    entries: &layout.entries,
                })
            });
            let fragment = shader_module(gpu, program);
            let pipeline = full_screen_pipeline(
                gpu,
                group_layout.as_ref(),
                &fragment,
                Program::ENTRY_POINT,
                format,
            );
            (group_layout, pipeline)
        })?;
        let mut pass = GpuPass {
            kind: pass.kind,
            pipeline,
            layout,
            group_layout,
            bind_groups: Vec::new(),
            uniforms,
            tables,
            findings,
            channels,
        };
        if pass.group_layout.is_some() && pass.reads().next().is_none() {
            let none = |_, _| unreachable!("nothing that is drawn is read");
            pass.bind_groups =
                gpu.guarded("binding what the shader reads", || pass.bind(gpu, &none))?;
        }
        Ok(pass)
    }

    /// A bind group of all that the pass uses, for each face that it draws. Call it within [`Gpu::guarded`].
    pub fn bind(&self, gpu: &Gpu, surface: &SurfaceView<'_>) -> Vec<wgpu::BindGroup> {
        let faces = 0..self.draws().map_or(1, Surface::faces);
        faces
            .map(|face| self.bind_face(gpu, surface, face))
            .collect()
    }

    fn bind_face(&self, gpu: &Gpu, surface: &SurfaceView<'_>, face: u32) -> wgpu::BindGroup {
        let mut entries = Vec::new();
        let mut bind = |binding, resource| {
            entries.push(wgpu::BindGroupEntry { binding, resource });
        };
        if let Some(uniforms) = &self.uniforms {
            bind(bindings::UNIFORMS, uniforms.binding(face));
        }
        if let Some(tables) = &self.tables {
            bind(bindings::TABLES, tables.as_entire_binding());
        }
        if let Some(findings) = &self.findings {
            bind(bindings::FINDINGS, findings.as_entire_binding());
        }
        for (index, channel) in self.channels.iter().enumerate() {
            if let Some(texture) = &channel.texture {
                let view = match texture {
                    BoundTexture::Fixed(view) | BoundTexture::Keyboard(_, view) => view,
                    BoundTexture::Drawn(drawn, filter) => surface(*drawn, *filter),
                };
                let resource = wgpu::BindingResource::TextureView(view);
                bind(bindings::texture(index), resource);
            }
            if let Some(sampler) = &channel.sampler {
                let resource = wgpu::BindingResource::Sampler(sampler);
                bind(bindings::sampler(index), resource);
            }
        }
        gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: self.group_layout.as_ref().expect("something is bound"),
            entries: &entries,
        })
    }

    pub fn layout(&self) -> &PassLayout {
        &self.layout
    }

    pub fn findings(&self) -> Option<&wgpu::Buffer> {
        self.findings.as_ref()
    }

    pub fn kind(&self) -> PassKind {
        self.kind
    }

    /// What the pass draws for others, if it does.
    pub fn draws(&self) -> Option<Surface> {
        Surface::drawn_by(self.kind)
    }

    /// What the pass reads of what passes draw, and how.
    pub fn reads(&self) -> impl Iterator<Item = (Surface, Filter)> {
        self.channels
            .iter()
            .filter_map(|channel| match channel.texture {
                Some(BoundTexture::Drawn(surface, filter)) => Some((surface, filter)),
                _ => None,
            })
    }

    /// Records the drawing of a band of one frame, or of a part of something else. `group` is bound if it is not the same in
    /// every frame.
    pub fn draw(
        &self,
        gpu: &Gpu,
        input: &FrameInput,
        encoder: &mut wgpu::CommandEncoder,
        view: &wgpu::TextureView,
        group: Option<&wgpu::BindGroup>,
        band: Band<'_>,
    ) {
        if let Some(uniforms) = &self.uniforms {
            uniforms.upload(gpu, input, band.part);
        }
        for channel in &self.channels {
            if let Some(BoundTexture::Keyboard(texture, _)) = &channel.texture {
                channel::press(gpu, texture, &input.keyboard);
            }
        }
        let group = group.or(self.bind_groups.get(band.part.face() as usize));
        full_screen_pass(encoder, view, &self.pipeline, group, Some(band));
    }
}

/// The pass's shader, with run-time checks of what is not known to be harmless.
fn shader_module(gpu: &Gpu, program: &Program) -> wgpu::ShaderModule {
    let descriptor = wgpu::ShaderModuleDescriptor {
        label: Some(program.kind.name()),
        source: wgpu::ShaderSource::Naga(std::borrow::Cow::Owned(program.module.clone())),
    };
    let guards = &program.guards;
    let mut checks = wgpu::ShaderRuntimeChecks::checked();
    checks.force_loop_bounding = !guards.loops.is_empty() && program.round_budget.is_none();
    checks.bounds_checks = !guards.accesses.is_empty();
    checks.int_div_checks = !guards.divisions.is_empty();
    #[expect(
        unsafe_code,
        reason = "wgpu leaves it to its caller that checks are not needed"
    )]
    // SAFETY: a kind of check is left away only if the translator has shown for every place of that
    // kind in the program that it cannot fail: each loop ends, by its budget if not by itself, each index is in range, no divisor is 0
    // or −1. All other checks stay.
    unsafe {
        gpu.device()
            .create_shader_module_trusted(descriptor, checks)
    }
}

/// A buffer with the program's constant tables.
fn upload(gpu: &Gpu, tables: &Tables) -> wgpu::Buffer {
    use wgpu::util::DeviceExt as _;
    gpu.device()
        .create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("tables"),
            contents: bytemuck::cast_slice(&tables.words),
            usage: match tables.in_storage {
                true => wgpu::BufferUsages::STORAGE,
                false => wgpu::BufferUsages::UNIFORM,
            },
        })
}

/// A buffer for so many words of findings.
fn findings(gpu: &Gpu, words: u32) -> wgpu::Buffer {
    gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some("findings"),
        size: 4 * u64::from(words),
        usage: wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::COPY_SRC
            | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// A pipeline that covers its target with one triangle. Call it within [`Gpu::guarded`].
pub(super) fn full_screen_pipeline(
    gpu: &Gpu,
    group_layout: Option<&wgpu::BindGroupLayout>,
    fragment: &wgpu::ShaderModule,
    entry_point: &str,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let device = gpu.device();
    let vertex = device.create_shader_module(wgpu::include_wgsl!("full_screen.wgsl"));
    let groups: &[_] = match &group_layout {
        Some(_) => &[group_layout],
        None => &[],
    };
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: groups,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &vertex,
            entry_point: Some("full_screen"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: fragment,
            entry_point: Some(entry_point),
            compilation_options: Default::default(),
            targets: &[Some(format.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// Some rows of a picture, counted from the bottom.
#[derive(Clone, Debug)]
pub(super) struct Band<'t> {
    pub width: u32,
    pub rows: Range<u32>,
    pub part: Part,
    /// Whether what was there before stays where nothing is drawn: a buffer shows it there, a picture black.
    pub keeps: bool,
    pub timestamps: Option<wgpu::RenderPassTimestampWrites<'t>>,
}

/// Records one draw over the whole of `view`, or over a band of it.
pub(super) fn full_screen_pass(
    encoder: &mut wgpu::CommandEncoder,
    view: &wgpu::TextureView,
    pipeline: &wgpu::RenderPipeline,
    bind_group: Option<&wgpu::BindGroup>,
    band: Option<Band<'_>>,
) {
    let is_cleared = band
        .as_ref()
        .is_none_or(|band| band.rows.start == 0 && !band.keeps);
    let rows = band.as_ref().map(|band| (band.width, band.rows.clone()));
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: None,
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: match is_cleared {
                    true => wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    false => wgpu::LoadOp::Load,
                },
                store: wgpu::StoreOp::Store,
            },
        })],
        timestamp_writes: band.and_then(|band| band.timestamps),
        ..Default::default()
    });
    pass.set_pipeline(pipeline);
    if let Some(group) = bind_group {
        pass.set_bind_group(bindings::GROUP, group, &[]);
    }
    if let Some((width, rows)) = rows {
        pass.set_scissor_rect(0, rows.start, width, rows.end - rows.start);
    }
    pass.draw(0..3, 0..1);
}

fn layout(pass: &Pass, program: &Program) -> PassLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    let mut entries = Vec::new();
    if let Some(block) = &program.uniforms {
        entries.push(entry(
            bindings::UNIFORMS,
            wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: std::num::NonZeroU64::new(u64::from(block.size)),
            },
        ));
    }
    if let Some(tables) = &program.tables {
        entries.push(entry(
            bindings::TABLES,
            wgpu::BindingType::Buffer {
                ty: match tables.in_storage {
                    true => wgpu::BufferBindingType::Storage { read_only: true },
                    false => wgpu::BufferBindingType::Uniform,
                },
                has_dynamic_offset: false,
                min_binding_size: std::num::NonZeroU64::new(4 * tables.words.len() as u64),
            },
        ));
    }
    if let Some(words) = program.findings {
        entries.push(entry(
            bindings::FINDINGS,
            wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only: false },
                has_dynamic_offset: false,
                min_binding_size: std::num::NonZeroU64::new(4 * u64::from(words)),
            },
        ));
    }
    for (index, usage) in program.channels.iter().enumerate() {
        if usage.texture {
            let bound = pass.channels[index].as_ref();
            let kind = bound.map_or(SamplerKind::TwoD, |channel| channel.input.sampler());
            entries.push(entry(
                bindings::texture(index),
                wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: true },
                    view_dimension: texture::dimension(kind),
                    multisampled: false,
                },
            ));
        }
        if usage.sampler {
            entries.push(entry(
                bindings::sampler(index),
                wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
            ));
        }
    }
    PassLayout { entries }
}
