use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use glam::UVec2;

/// Which adapter to use.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum AdapterChoice {
    /// `WGPU_ADAPTER_NAME` if set, otherwise the fastest kind there is, a CPU driver last.
    #[default]
    Auto,
    /// A driver that runs on the CPU.
    Cpu,
    /// A real GPU, never a CPU driver.
    Gpu,
    /// The first adapter whose name contains this, upper and lower case alike.
    Named(String),
}

impl AdapterChoice {
    /// Reads the value of `--adapter`: `cpu`, `gpu`, or part of a name.
    pub fn from_name(name: &str) -> Self {
        match name {
            "cpu" => AdapterChoice::Cpu,
            "gpu" => AdapterChoice::Gpu,
            name => AdapterChoice::Named(name.to_owned()),
        }
    }
}

/// What went wrong between this program and the graphics driver.
#[derive(Clone, Debug, thiserror::Error)]
pub enum GpuError {
    /// No driver at all.
    #[error("no graphics adapter was found")]
    NoAdapter,
    /// Adapters exist, but not the one asked for.
    #[error("no adapter matches `{wanted}`; there are: {}", found.join(", "))]
    NoSuchAdapter {
        /// What was asked for.
        wanted: String,
        /// The adapters' names.
        found: Vec<String>,
    },
    /// The adapter gives no device.
    #[error("the adapter `{adapter}` cannot be opened: {message}")]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The driver's words.
        message: String,
    },
    /// A picture of no pixels, or of more than the device draws.
    #[error("a picture of {}x{} is beyond this adapter, which draws 1x1 to {limit}x{limit}", size.x, size.y)]
    Size {
        /// The size asked for.
        size: UVec2,
        /// The largest width and height.
        limit: u32,
    },
    /// A program in double precision, on a device without 64-bit floats.
    #[error("the adapter `{adapter}` cannot compute in double precision")]
    NoFloat64 {
        /// The adapter's name.
        adapter: String,
    },
    /// A program that notes findings, on a device whose shaders cannot write to buffers.
    #[error(
        "the adapter `{adapter}` lets shaders write to no buffer, so that they cannot be watched"
    )]
    NoFindings {
        /// The adapter's name.
        adapter: String,
    },
    /// Memory ran out, on the device or for it.
    #[error("out of memory while {doing}")]
    OutOfMemory {
        /// What was being done.
        doing: &'static str,
    },
    /// The device stopped working: unplugged, reset by a driver, or hung.
    #[error("the graphics device was lost: {0}")]
    Lost(String),
    /// The driver or wgpu refused something that it should have taken.
    #[error("the graphics driver failed while {doing}: {message}")]
    Refused {
        /// What was being done.
        doing: &'static str,
        /// Its words.
        message: String,
    },
    /// There is no way to show pictures in this window.
    #[error("the window cannot show pictures: {0}")]
    Surface(String),
}

impl GpuError {
    /// The way out.
    pub fn hint(&self) -> &'static str {
        match self {
            GpuError::NoAdapter => {
                "install a graphics driver; without a GPU, Debian's and Ubuntu's package \
                 mesa-vulkan-drivers draws on the CPU (see `vitrine doctor`)"
            }
            GpuError::NoSuchAdapter { .. } => "`vitrine doctor` lists the adapters",
            GpuError::NoDevice { .. } => {
                "update the driver, or choose another adapter with `--adapter`"
            }
            GpuError::Size { .. } => "choose a size within these limits with `--size WxH`",
            GpuError::NoFloat64 { .. } => {
                "`vitrine doctor` lists which adapters have 64-bit floats; `--adapter` chooses one"
            }
            GpuError::NoFindings { .. } => {
                "`vitrine doctor` lists the adapters; `--adapter` chooses one"
            }
            GpuError::OutOfMemory { .. } => {
                "choose a smaller `--size`, close other programs, or try `--adapter cpu`"
            }
            GpuError::Lost(_) => {
                "a shader that runs too long on one frame is the usual cause: try a smaller \
                 `--size`, shorter loops, or `--adapter cpu`"
            }
            GpuError::Refused { .. } => {
                "`vitrine translate --to spirv` shows what the driver was given; try another \
                 adapter with `--adapter`"
            }
            GpuError::Surface(_) => {
                "`vitrine export` needs no window; `vitrine doctor` lists the adapters"
            }
        }
    }
}

/// The first error that no one was waiting for.
type Faults = Arc<Mutex<Option<GpuError>>>;

/// A device and its queue.
#[derive(Debug)]
pub struct Gpu {
    adapter: wgpu::AdapterInfo,
    device: wgpu::Device,
    queue: wgpu::Queue,
    faults: Faults,
    can_note_findings: bool,
}

impl Gpu {
    /// Opens an adapter for drawing without a window.
    pub fn headless(choice: &AdapterChoice) -> Result<Self, GpuError> {
        let (_, adapter) = pick(choice, &|backends| {
            let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
            Ok((instance(descriptor, backends), None))
        })?;
        Gpu::open(&adapter)
    }

    pub(super) fn open(adapter: &wgpu::Adapter) -> Result<Self, GpuError> {
        let info = adapter.get_info();
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("vitrine"),
            required_features: adapter.features()
                & (wgpu::Features::TIMESTAMP_QUERY
                    | wgpu::Features::SHADER_F64
                    | wgpu::Features::FLOAT32_FILTERABLE),
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) =
            pollster::block_on(adapter.request_device(&descriptor)).map_err(|error| {
                GpuError::NoDevice {
                    adapter: info.name.clone(),
                    message: error.to_string(),
                }
            })?;
        let faults = Faults::default();
        let uncaptured = Arc::clone(&faults);
        device.on_uncaptured_error(Arc::new(move |error| {
            note(&uncaptured, from_wgpu(error, "drawing"));
        }));
        let lost = Arc::clone(&faults);
        device.set_device_lost_callback(move |reason, message| {
            if reason != wgpu::DeviceLostReason::Destroyed {
                note(&lost, GpuError::Lost(message));
            }
        });
        Ok(Gpu {
            adapter: info,
            device,
            queue,
            faults,
            can_note_findings: can_note_findings(adapter),
        })
    }

    /// The adapter's name and driver.
    pub fn describe(&self) -> String {
        describe(&self.adapter)
    }

    /// Whether the driver draws on the CPU.
    pub fn is_cpu(&self) -> bool {
        self.adapter.device_type == wgpu::DeviceType::Cpu
    }

    /// The largest width and height of a picture.
    pub fn max_size(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }

    /// Whether the device can time what it draws.
    pub fn has_timestamps(&self) -> bool {
        self.device
            .features()
            .contains(wgpu::Features::TIMESTAMP_QUERY)
    }

    /// Whether shaders can compute in 64-bit floats.
    pub fn has_float64(&self) -> bool {
        self.device.features().contains(wgpu::Features::SHADER_F64)
    }

    /// How many rounds the driver lets a loop make at most before it ends it without a word, a little less.
    pub fn round_limit(&self) -> Option<u32> {
        // Mesa's drivers on the CPU grant all loops of a pixel 65,535 rounds together, if not unrolled
        // (`LP_MAX_TGSI_LOOP_ITERATIONS`). One loop alone surely gets no more.
        self.adapter.name.contains("llvmpipe").then_some(65_500)
    }

    /// What buffer passes draw: floats of 32 bits, or of 16 where those cannot be read between texels.
    pub(super) fn buffer_format(&self) -> wgpu::TextureFormat {
        match self.filters_floats() {
            true => wgpu::TextureFormat::Rgba32Float,
            false => wgpu::TextureFormat::Rgba16Float,
        }
    }

    /// Whether textures of 32-bit floats can be read between texels.
    pub(super) fn filters_floats(&self) -> bool {
        let features = self.device.features();
        features.contains(wgpu::Features::FLOAT32_FILTERABLE)
    }

    /// Whether shaders can write to buffers, and so note what goes wrong in them.
    pub fn can_note_findings(&self) -> bool {
        self.can_note_findings
    }

    /// Fails with the first error that has turned up outside of any call.
    pub fn check(&self) -> Result<(), GpuError> {
        match &*self.faults.lock().expect("no holder panics") {
            Some(fault) => Err(fault.clone()),
            None => Ok(()),
        }
    }

    /// Lets finished work call back, without waiting.
    pub fn poll(&self) {
        // Only waiting can fail.
        let _ = self.device.poll(wgpu::PollType::Poll);
    }

    /// Calls `done` when all that was submitted so far has finished.
    pub fn on_done(&self, done: impl FnOnce() + Send + 'static) {
        self.queue.on_submitted_work_done(done);
    }

    /// Waits a moment for what was submitted; `false` means that the device is still busy with it.
    pub fn is_done(&self, submission: &super::Submission) -> Result<bool, GpuError> {
        self.wait_for(|| submission.0.load(Ordering::Acquire))
    }

    /// Waits a moment for what work that has finished calls back. wgpu's own wait with a limit panics now and then where
    /// several threads wait for one device, so that it is asked again and again instead.
    pub(super) fn wait_for(&self, is_done: impl Fn() -> bool) -> Result<bool, GpuError> {
        let began = Instant::now();
        let mut pause = Duration::from_micros(50);
        loop {
            self.poll();
            self.check()?;
            if is_done() {
                return Ok(true);
            }
            if began.elapsed() > WAIT_SLICE {
                return Ok(false);
            }
            thread::sleep(pause);
            pause = (2 * pause).min(Duration::from_millis(1));
        }
    }

    /// Waits until all that was submitted so far has finished.
    pub fn wait(&self) -> Result<(), GpuError> {
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .map_err(|error| GpuError::Lost(error.to_string()))?;
        self.check()
    }

    pub(super) fn device(&self) -> &wgpu::Device {
        &self.device
    }

    pub(super) fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// Runs `work` and turns what wgpu or the driver says about it, a panic included, into an error.
    pub(super) fn guarded<T>(
        &self,
        doing: &'static str,
        work: impl FnOnce() -> T,
    ) -> Result<T, GpuError> {
        let scopes = [
            wgpu::ErrorFilter::Internal,
            wgpu::ErrorFilter::OutOfMemory,
            wgpu::ErrorFilter::Validation,
        ]
        .map(|filter| self.device.push_error_scope(filter));
        let result = crate::translate::caught(work);
        let mut error = None;
        for scope in scopes.into_iter().rev() {
            error = error.or(pollster::block_on(scope.pop()));
        }
        match (result, error) {
            (Ok(value), None) => Ok(value),
            (Err(message), None) => Err(GpuError::Refused { doing, message }),
            (_, Some(error)) => Err(from_wgpu(error, doing)),
        }
    }
}

fn note(faults: &Faults, error: GpuError) {
    let mut first = faults.lock().expect("no holder panics");
    first.get_or_insert(error);
}

fn from_wgpu(error: wgpu::Error, doing: &'static str) -> GpuError {
    match error {
        wgpu::Error::OutOfMemory { .. } => GpuError::OutOfMemory { doing },
        wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. } => {
            GpuError::Refused {
                doing,
                message: description.split_whitespace().collect::<Vec<_>>().join(" "),
            }
        }
    }
}

fn describe(info: &wgpu::AdapterInfo) -> String {
    let driver = [info.driver.as_str(), info.driver_info.as_str()]
        .into_iter()
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join(" ");
    match driver.as_str() {
        "" => format!("{} ({})", info.name, info.backend),
        driver => format!("{} ({}, {driver})", info.name, info.backend),
    }
}

/// Opens the instance for some backends, and the window's surface if there is a window.
pub(super) type Opening<'a> =
    &'a dyn Fn(
        wgpu::Backends,
    ) -> Result<(wgpu::Instance, Option<wgpu::Surface<'static>>), GpuError>;

/// Finds an adapter that suits the choice and can present to the surface, if there is one.
///
/// `WGPU_BACKEND` decides the backends. By default OpenGL is tried only when nothing better exists:
/// starting it takes time.
pub(super) fn pick(
    choice: &AdapterChoice,
    opening: Opening<'_>,
) -> Result<(Option<wgpu::Surface<'static>>, wgpu::Adapter), GpuError> {
    let mut found = Vec::new();
    for backends in backends() {
        // An interface that is not there cannot make a surface either; another may.
        let Ok((instance, surface)) = opening(backends) else {
            continue;
        };
        let mut adapters = enumerate(&instance, backends);
        found.extend(adapters.iter().map(|adapter| adapter.get_info().name));
        adapters.retain(|adapter| {
            surface
                .as_ref()
                .is_none_or(|surface| adapter.is_surface_supported(surface))
        });
        if let Some(adapter) = choose(choice, adapters) {
            return Ok((surface, adapter));
        }
    }
    let wanted = match choice {
        _ if found.is_empty() => return Err(GpuError::NoAdapter),
        AdapterChoice::Auto => match std::env::var("WGPU_ADAPTER_NAME") {
            Ok(name) => name,
            Err(_) => return Err(GpuError::Surface("no adapter can draw to it".to_owned())),
        },
        AdapterChoice::Cpu => "cpu".to_owned(),
        AdapterChoice::Gpu => "gpu".to_owned(),
        AdapterChoice::Named(name) => name.clone(),
    };
    found.dedup();
    Err(GpuError::NoSuchAdapter { wanted, found })
}

fn backends() -> Vec<wgpu::Backends> {
    match wgpu::Backends::from_env() {
        Some(backends) => vec![backends],
        None => vec![wgpu::Backends::PRIMARY, wgpu::Backends::SECONDARY],
    }
}

pub(super) fn instance(
    descriptor: wgpu::InstanceDescriptor,
    backends: wgpu::Backends,
) -> wgpu::Instance {
    wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends,
        ..descriptor
    })
}

/// The adapters of an instance, best first.
fn enumerate(instance: &wgpu::Instance, backends: wgpu::Backends) -> Vec<wgpu::Adapter> {
    let mut adapters = pollster::block_on(instance.enumerate_adapters(backends));
    adapters.sort_by_key(|adapter| {
        let info = adapter.get_info();
        (rank(info.device_type), backend_rank(info.backend))
    });
    adapters
}

fn rank(kind: wgpu::DeviceType) -> u8 {
    let saves_power = wgpu::PowerPreference::from_env() == Some(wgpu::PowerPreference::LowPower);
    match kind {
        wgpu::DeviceType::DiscreteGpu => u8::from(saves_power) * 2,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 3,
        wgpu::DeviceType::Other => 4,
        wgpu::DeviceType::Cpu => 5,
    }
}

fn backend_rank(backend: wgpu::Backend) -> u8 {
    match backend {
        wgpu::Backend::Vulkan | wgpu::Backend::Metal => 0,
        wgpu::Backend::Dx12 => 1,
        _ => 2,
    }
}

fn choose(choice: &AdapterChoice, adapters: Vec<wgpu::Adapter>) -> Option<wgpu::Adapter> {
    let name = match choice {
        AdapterChoice::Named(name) => Some(name.to_lowercase()),
        AdapterChoice::Auto => std::env::var("WGPU_ADAPTER_NAME")
            .ok()
            .map(|name| name.to_lowercase()),
        AdapterChoice::Cpu | AdapterChoice::Gpu => None,
    };
    adapters.into_iter().find(|adapter| {
        let info = adapter.get_info();
        let is_cpu = info.device_type == wgpu::DeviceType::Cpu;
        match (choice, &name) {
            (AdapterChoice::Cpu, _) => is_cpu,
            (AdapterChoice::Gpu, _) => !is_cpu,
            (_, Some(name)) => info.name.to_lowercase().contains(name.as_str()),
            (_, None) => true,
        }
    })
}

/// What `vitrine doctor` tells about an adapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterSummary {
    /// Name, interface and driver.
    pub description: String,
    /// `discrete GPU`, `integrated GPU`, `CPU` ….
    pub kind: &'static str,
    /// The largest width and height of a picture.
    pub max_size: u32,
    /// Whether `export --stats` can give GPU seconds.
    pub timestamps: bool,
    /// Whether shaders can compute in 64-bit floats.
    pub float64: bool,
    /// Whether `--sanitize` works.
    pub findings: bool,
}

/// Whether an adapter's fragment shaders can write to buffers.
fn can_note_findings(adapter: &wgpu::Adapter) -> bool {
    let flags = adapter.get_downlevel_capabilities().flags;
    flags.contains(wgpu::DownlevelFlags::FRAGMENT_WRITABLE_STORAGE)
        && adapter.limits().max_storage_buffers_per_shader_stage >= 2
}

/// All adapters of all interfaces, best first.
pub fn adapters() -> Vec<AdapterSummary> {
    let mut summaries: Vec<AdapterSummary> = Vec::new();
    for backends in backends() {
        let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
        for adapter in enumerate(&instance(descriptor, backends), backends) {
            let info = adapter.get_info();
            let features = adapter.features();
            summaries.push(AdapterSummary {
                description: describe(&info),
                kind: match info.device_type {
                    wgpu::DeviceType::DiscreteGpu => "discrete GPU",
                    wgpu::DeviceType::IntegratedGpu => "integrated GPU",
                    wgpu::DeviceType::VirtualGpu => "virtual GPU",
                    wgpu::DeviceType::Cpu => "CPU",
                    wgpu::DeviceType::Other => "unknown kind",
                },
                max_size: adapter.limits().max_texture_dimension_2d,
                timestamps: features.contains(wgpu::Features::TIMESTAMP_QUERY),
                float64: features.contains(wgpu::Features::SHADER_F64),
                findings: can_note_findings(&adapter),
            });
        }
    }
    summaries
}

/// How long a wait for the device lasts before its caller looks around.
const WAIT_SLICE: Duration = Duration::from_millis(100);
