use std::sync::Arc;

use glam::{UVec2, Vec4};
use wgpu::rwh::{HasDisplayHandle, HasWindowHandle};

use super::gpu::{AdapterChoice, Gpu, GpuError, instance, pick};
use super::pass::{full_screen_pass, full_screen_pipeline};
use super::target::Target;

/// Shows pictures in a window.
#[derive(Debug)]
pub struct Presenter {
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
    window_size: wgpu::Buffer,
    /// The last picture's texture, bound.
    bound: Option<(wgpu::Texture, wgpu::BindGroup)>,
}

/// What became of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Presented {
    /// It is on its way to the screen.
    Shown,
    /// The window takes none just now: it is hidden, or still showing the ones before.
    Skipped,
}

impl Presenter {
    /// Opens an adapter that can draw into `window`.
    ///
    /// `display` is the connection that the window belongs to; some drivers want to know it first.
    pub fn open<D, W>(
        choice: &AdapterChoice,
        display: D,
        window: Arc<W>,
        size: UVec2,
    ) -> Result<(Gpu, Self), GpuError>
    where
        D: HasDisplayHandle + std::fmt::Debug + Clone + Send + Sync + 'static,
        W: HasWindowHandle + HasDisplayHandle + std::fmt::Debug + Send + Sync + 'static,
    {
        let (surface, adapter) = pick(choice, &|backends| {
            let descriptor = wgpu::InstanceDescriptor::new_with_display_handle_from_env(Box::new(
                display.clone(),
            ));
            let instance = instance(descriptor, backends);
            let surface = instance
                .create_surface(Arc::clone(&window))
                .map_err(|error| GpuError::Surface(error.to_string()))?;
            Ok((instance, Some(surface)))
        })?;
        let surface = surface.expect("the opening above makes one");
        let gpu = Gpu::open(&adapter)?;
        let presenter = Presenter::new(&gpu, &adapter, surface, size)?;
        Ok((gpu, presenter))
    }

    fn new(
        gpu: &Gpu,
        adapter: &wgpu::Adapter,
        surface: wgpu::Surface<'static>,
        size: UVec2,
    ) -> Result<Self, GpuError> {
        let mut config = surface
            .get_default_config(adapter, size.x.max(1), size.y.max(1))
            .ok_or_else(|| GpuError::Surface("it has no format in common".to_owned()))?;
        let formats = surface.get_capabilities(adapter).formats;
        let plain = formats.iter().copied().find(|format| {
            matches!(
                format,
                wgpu::TextureFormat::Bgra8Unorm | wgpu::TextureFormat::Rgba8Unorm
            )
        });
        config.format = plain.unwrap_or(config.format);
        config.present_mode = wgpu::PresentMode::AutoVsync;
        let entry_point = match config.format.is_srgb() {
            true => "decoded",
            false => "plain",
        };
        let device = gpu.device();
        gpu.guarded("preparing the window", || {
            surface.configure(device, &config);
            let layout = device.create_bind_group_layout(&layout());
            let fragment = device.create_shader_module(wgpu::include_wgsl!("present.wgsl"));
            let pipeline =
                full_screen_pipeline(gpu, Some(&layout), &fragment, entry_point, config.format);
            let window_size = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("window size"),
                size: size_of::<Vec4>() as u64,
                usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            Presenter {
                surface,
                config,
                layout,
                pipeline,
                window_size,
                bound: None,
            }
        })
    }

    /// The window has a new size, in pixels; neither side is 0.
    pub fn resize(&mut self, gpu: &Gpu, size: UVec2) {
        let limit = gpu.max_size();
        (self.config.width, self.config.height) = (size.x.min(limit), size.y.min(limit));
        self.surface.configure(gpu.device(), &self.config);
    }

    /// Draws the picture over the whole window. May wait for the display's next refresh.
    pub fn present(&mut self, gpu: &Gpu, target: &Target) -> Result<Presented, GpuError> {
        let frame = match self.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(frame)
            | wgpu::CurrentSurfaceTexture::Suboptimal(frame) => frame,
            wgpu::CurrentSurfaceTexture::Timeout | wgpu::CurrentSurfaceTexture::Occluded => {
                return Ok(Presented::Skipped);
            }
            wgpu::CurrentSurfaceTexture::Outdated | wgpu::CurrentSurfaceTexture::Validation => {
                self.surface.configure(gpu.device(), &self.config);
                gpu.check()?;
                return Ok(Presented::Skipped);
            }
            wgpu::CurrentSurfaceTexture::Lost => {
                gpu.check()?;
                return Err(GpuError::Surface("the display took it away".to_owned()));
            }
        };
        let size = Vec4::new(
            self.config.width as f32,
            self.config.height as f32,
            0.0,
            0.0,
        );
        gpu.queue()
            .write_buffer(&self.window_size, 0, bytemuck::bytes_of(&size));
        let descriptor = wgpu::CommandEncoderDescriptor { label: None };
        let mut encoder = gpu.device().create_command_encoder(&descriptor);
        let view = frame
            .texture
            .create_view(&wgpu::TextureViewDescriptor::default());
        let group = self.bind(gpu, target);
        full_screen_pass(&mut encoder, &view, &self.pipeline, Some(&group), None);
        gpu.queue().submit([encoder.finish()]);
        gpu.queue().present(frame);
        Ok(Presented::Shown)
    }

    /// The bind group for this target, kept as long as the target is the same.
    fn bind(&mut self, gpu: &Gpu, target: &Target) -> wgpu::BindGroup {
        if let Some((texture, group)) = &self.bound
            && texture == target.texture()
        {
            return group.clone();
        }
        let same_size = target.size() == UVec2::new(self.config.width, self.config.height);
        let filter = match same_size {
            true => wgpu::FilterMode::Nearest,
            false => wgpu::FilterMode::Linear,
        };
        let sampler = gpu.device().create_sampler(&wgpu::SamplerDescriptor {
            mag_filter: filter,
            min_filter: filter,
            ..Default::default()
        });
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        let group = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.layout,
            entries: &[
                entry(0, wgpu::BindingResource::TextureView(target.view())),
                entry(1, wgpu::BindingResource::Sampler(&sampler)),
                entry(2, self.window_size.as_entire_binding()),
            ],
        });
        self.bound = Some((target.texture().clone(), group.clone()));
        group
    }
}

fn layout() -> wgpu::BindGroupLayoutDescriptor<'static> {
    const fn entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
        wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty,
            count: None,
        }
    }
    const ENTRIES: [wgpu::BindGroupLayoutEntry; 3] = [
        entry(
            0,
            wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: true },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
        ),
        entry(
            1,
            wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        ),
        entry(
            2,
            wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
        ),
    ];
    wgpu::BindGroupLayoutDescriptor {
        label: None,
        entries: &ENTRIES,
    }
}
