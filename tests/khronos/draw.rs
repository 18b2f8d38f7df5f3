//! Draws a program with every set of its values: one pixel each.

use std::sync::{Arc, OnceLock};

use vitrine::glsl::lower::{Lowered, Tables};
use wgpu::util::DeviceExt as _;

use super::compile::{BLOCK, TABLES};
use super::format::{Type, Value};
use super::specialise::Program;

const FULL_SCREEN: &str = "
@vertex
fn full_screen(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index / 2u), f32(index % 2u));
    return vec4f(corner * 4.0 - 1.0, 0.0, 1.0);
}
";

/// Colours are read back as they are computed.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;
const BYTES_PER_PIXEL: u32 = 16;

/// The best adapter, or the one that `WGPU_ADAPTER_NAME` names.
pub fn adapter() -> Result<wgpu::Adapter, String> {
    // Starting OpenGL takes long.
    let backends = wgpu::Backends::from_env().unwrap_or(wgpu::Backends::PRIMARY);
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends,
        ..wgpu::InstanceDescriptor::new_without_display_handle_from_env()
    });
    pollster::block_on(async {
        match wgpu::util::initialize_adapter_from_env(&instance, None).await {
            Ok(adapter) => Ok(adapter),
            Err(_) => instance.request_adapter(&Default::default()).await,
        }
    })
    .map_err(|error| error.to_string())
}

/// A graphics device for one thread.
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    vertex: wgpu::ShaderModule,
    /// Why the device does not work any longer.
    lost: Arc<OnceLock<String>>,
}

impl Gpu {
    /// Opens a device.
    pub fn open(adapter: &wgpu::Adapter) -> Result<Self, String> {
        let descriptor = wgpu::DeviceDescriptor {
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| error.to_string())?;
        let lost = Arc::new(OnceLock::new());
        let reason = Arc::clone(&lost);
        device.set_device_lost_callback(move |_, message| {
            // The first reason is the one that counts.
            let _ = reason.set(message);
        });
        let vertex = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(FULL_SCREEN.into()),
        });
        Ok(Gpu {
            device,
            queue,
            vertex,
            lost,
        })
    }

    /// Whether a driver's failure has ended the device.
    pub fn is_lost(&self) -> bool {
        self.lost.get().is_some()
    }

    /// Compiles a program and gives the colour that it draws with each set of its values.
    pub fn draw(&self, lowered: &Lowered, program: &Program) -> Result<Vec<[f32; 4]>, String> {
        let scopes = [
            wgpu::ErrorFilter::Internal,
            wgpu::ErrorFilter::OutOfMemory,
            wgpu::ErrorFilter::Validation,
        ]
        .map(|filter| self.device.push_error_scope(filter));
        let colors = self.draw_unguarded(lowered, program);
        // What comes of a lack of memory is invalid, which is the smaller news.
        let mut error = None;
        for scope in scopes.into_iter().rev() {
            error = pollster::block_on(scope.pop()).or(error);
        }
        match (self.lost.get(), error) {
            (Some(reason), _) => Err(format!("the graphics device was lost: {reason}")),
            (None, Some(error)) => Err(error.to_string()),
            (None, None) => colors,
        }
    }

    fn draw_unguarded(
        &self,
        lowered: &Lowered,
        program: &Program,
    ) -> Result<Vec<[f32; 4]>, String> {
        let bindings = Bindings::new(self, lowered, program);
        let pipeline = self.pipeline(lowered, &bindings);
        let sets = program.sets;
        let size = wgpu::Extent3d {
            width: sets as u32,
            ..Default::default()
        };
        let target = self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let row = size.width * BYTES_PER_PIXEL;
        let row = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let result = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: row.into(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        {
            let view = target.create_view(&Default::default());
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: Default::default(),
                })],
                ..Default::default()
            });
            pass.set_pipeline(&pipeline);
            for set in 0..sets as u32 {
                bindings.bind(&mut pass, set);
                pass.set_scissor_rect(set, 0, 1, 1);
                pass.draw(0..3, 0..1);
            }
        }
        encoder.copy_texture_to_buffer(
            target.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &result,
                layout: wgpu::TexelCopyBufferLayout {
                    bytes_per_row: Some(row),
                    ..Default::default()
                },
            },
            size,
        );
        self.queue.submit([encoder.finish()]);
        // An error of this shows when the bytes are asked for.
        result.map_async(wgpu::MapMode::Read, .., |_| {});
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .map_err(|error| error.to_string())?;
        let bytes = result
            .get_mapped_range(..)
            .map_err(|error| error.to_string())?;
        let colors: &[[f32; 4]] = bytemuck::cast_slice(&bytes);
        Ok(colors[..sets].to_vec())
    }

    fn pipeline(&self, lowered: &Lowered, bindings: &Bindings) -> wgpu::RenderPipeline {
        let fragment = self
            .device
            .create_shader_module(wgpu::ShaderModuleDescriptor {
                label: None,
                source: wgpu::ShaderSource::Naga(std::borrow::Cow::Owned(lowered.module.clone())),
            });
        let layout = self
            .device
            .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: None,
                bind_group_layouts: &[Some(&bindings.layout)],
                immediate_size: 0,
            });
        self.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: None,
                layout: Some(&layout),
                vertex: wgpu::VertexState {
                    module: &self.vertex,
                    entry_point: Some("full_screen"),
                    compilation_options: Default::default(),
                    buffers: &[],
                },
                primitive: Default::default(),
                depth_stencil: None,
                multisample: Default::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &fragment,
                    entry_point: Some("main"),
                    compilation_options: Default::default(),
                    targets: &[Some(FORMAT.into())],
                }),
                multiview_mask: None,
                cache: None,
            })
    }
}

/// What a program reads: the sets of uniforms lie in one buffer, one behind the other.
struct Bindings {
    layout: wgpu::BindGroupLayout,
    group: wgpu::BindGroup,
    /// How far the sets are apart; `None` without uniforms.
    stride: Option<u32>,
}

impl Bindings {
    fn new(gpu: &Gpu, lowered: &Lowered, program: &Program) -> Self {
        let alignment = gpu.device.limits().min_uniform_buffer_offset_alignment;
        let block = lowered.uniforms.as_ref();
        let stride = block.map(|block| block.size.next_multiple_of(alignment));
        let uniforms = block.zip(stride).map(|(block, stride)| {
            let stride = stride as usize;
            let mut words = vec![0; stride / 4 * program.sets];
            for member in &block.members {
                let value = program
                    .uniforms
                    .iter()
                    .find(|value| value.name == member.name);
                let value = value.expect("the block has only the uniforms that it was asked for");
                for (set, words) in words.chunks_mut(stride / 4).enumerate() {
                    store(&mut words[member.offset as usize / 4..], value, set);
                }
            }
            (block.size, gpu.buffer(&words, wgpu::BufferUsages::UNIFORM))
        });
        let tables = lowered.tables.as_ref().map(|tables| upload(gpu, tables));

        let mut entries = Vec::new();
        let mut resources = Vec::new();
        if let Some((size, buffer)) = &uniforms {
            entries.push(entry(BLOCK, wgpu::BufferBindingType::Uniform, true));
            resources.push(wgpu::BindGroupEntry {
                binding: BLOCK,
                resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                    buffer,
                    offset: 0,
                    size: std::num::NonZeroU64::new((*size).into()),
                }),
            });
        }
        if let Some((ty, buffer)) = &tables {
            entries.push(entry(TABLES, *ty, false));
            resources.push(wgpu::BindGroupEntry {
                binding: TABLES,
                resource: buffer.as_entire_binding(),
            });
        }
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: None,
                entries: &entries,
            });
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &resources,
        });
        Bindings {
            layout,
            group,
            stride,
        }
    }

    fn bind(&self, pass: &mut wgpu::RenderPass<'_>, set: u32) {
        let offset = self.stride.map(|stride| set * stride);
        pass.set_bind_group(super::compile::GROUP, &self.group, offset.as_slice());
    }
}

impl Gpu {
    fn buffer(&self, words: &[u32], usage: wgpu::BufferUsages) -> wgpu::Buffer {
        self.device
            .create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: None,
                contents: bytemuck::cast_slice(words),
                usage,
            })
    }
}

fn upload(gpu: &Gpu, tables: &Tables) -> (wgpu::BufferBindingType, wgpu::Buffer) {
    match tables.in_storage {
        true => (
            wgpu::BufferBindingType::Storage { read_only: true },
            gpu.buffer(&tables.words, wgpu::BufferUsages::STORAGE),
        ),
        false => (
            wgpu::BufferBindingType::Uniform,
            gpu.buffer(&tables.words, wgpu::BufferUsages::UNIFORM),
        ),
    }
}

fn entry(
    binding: u32,
    ty: wgpu::BufferBindingType,
    has_dynamic_offset: bool,
) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty,
            has_dynamic_offset,
            min_binding_size: None,
        },
        count: None,
    }
}

/// Writes a uniform as the block holds it: each column of a matrix begins a new row of four numbers.
fn store(words: &mut [u32], value: &Value, set: usize) {
    let Type { columns, rows, .. } = value.ty;
    let (columns, rows) = (usize::from(columns), usize::from(rows));
    for column in 0..columns {
        let given = &value.set(set)[column * rows..][..rows];
        words[column * 4..][..rows].copy_from_slice(given);
    }
}
