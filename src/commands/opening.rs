//! What every command that draws does first, and how it gives up.

use std::time::Duration;

use glam::UVec2;
use vitrine::frame::Date;
use vitrine::render::{AdapterChoice, GpuError, Watchdog};
use vitrine::report;
use vitrine::scene::{Binding, Source};
use vitrine::session::{OpenError, Setup};
use vitrine::translate::{Options, translate};

use super::media::library;
use super::{HOST_FAILED, SCENE_HAS_PROBLEMS, failure, loaded, unreadable};
use crate::cli::{GpuArgs, InputArgs, Size};

pub fn adapter_choice(args: &GpuArgs) -> AdapterChoice {
    match &args.adapter {
        Some(name) => AdapterChoice::from_name(name),
        None => AdapterChoice::Auto,
    }
}

/// The date given on the command line.
pub fn date(text: Option<&str>) -> anyhow::Result<Option<Date>> {
    let date = text.map(|text| {
        let read = text.parse::<Date>();
        read.map_err(|hint| failure(format!("`--date {text}` is no date"), &hint))
    });
    date.transpose()
}

/// A scene that loads and translates.
pub struct Ready {
    /// How to open it.
    pub setup: Setup,
    /// The size that it is made for.
    pub size: Option<UVec2>,
}

impl Ready {
    /// The size of the pictures: what is asked for, or else the scene's own, or else `usual`.
    pub fn size(&self, asked: Option<Size>, usual: UVec2) -> UVec2 {
        let asked = asked.map(|size| UVec2::new(size.width, size.height));
        asked.or(self.size).unwrap_or(usual)
    }
}

/// Loads and translates a scene, which is asked before a driver is started and a window opened, because those take far
/// longer. `None` if it cannot be drawn; then its problems have been printed.
pub fn ready(
    source: &Source,
    options: Options,
    inputs: &InputArgs,
) -> anyhow::Result<Option<Ready>> {
    let bindings = inputs.channel.iter().map(|text| {
        let read = text.parse::<Binding>();
        read.map_err(|hint| failure(format!("`--channel {text}` binds nothing"), &hint))
    });
    let bindings: Vec<Binding> = bindings.collect::<Result<_, _>>()?;
    let checked = loaded(source)?.and_then(|mut scene| {
        scene.bind(&bindings)?;
        translate(&scene, &options)?;
        Ok(scene)
    });
    let scene = match checked {
        Ok(scene) => scene,
        Err(report) => {
            report::show(&report);
            return Ok(None);
        }
    };
    Ok(Some(Ready {
        size: scene.size.map(UVec2::from_array),
        setup: Setup {
            options,
            library: library(&inputs.media)?,
            bindings,
            ..Setup::default()
        },
    }))
}

pub fn gpu_failure(error: &GpuError) -> anyhow::Error {
    failure(error, error.hint())
}

/// Says why a scene did not open: prints the scene's problems, or returns the host's failure.
pub fn explain(error: OpenError) -> anyhow::Result<u8> {
    match error {
        OpenError::Scene { report, .. } => {
            report::show(&report);
            Ok(SCENE_HAS_PROBLEMS)
        }
        OpenError::Io { path, error } => Err(unreadable(&path, &error)),
        OpenError::Gpu(error) => Err(gpu_failure(&error)),
    }
}

/// A watchdog that tells of slow frames, and ends the process when a frame takes too long: a driver
/// that is stuck in a shader cannot be stopped in any other way.
pub fn watchdog(args: &GpuArgs) -> Watchdog {
    let limit = (args.frame_timeout > 0.0).then(|| Duration::from_secs_f64(args.frame_timeout));
    Watchdog::start(
        limit,
        |elapsed| {
            report::tell(format_args!(
                "a frame is taking longer than {} s …",
                elapsed.as_secs()
            ));
        },
        |elapsed| {
            super::complain(&slow_frame(elapsed));
            end_at_once(HOST_FAILED);
        },
    )
}

/// A frame that takes too long.
pub fn slow_frame(time: Duration) -> anyhow::Error {
    failure(
        format!("a frame was not finished after {:.0} s", time.as_secs_f64()),
        "does a loop never end, or is an array very large? Otherwise choose a smaller `--size`, \
         or give it more time with `--frame-timeout SECONDS`",
    )
}

/// Ends the process without dropping the device, which would wait for the stuck frame.
fn end_at_once(code: u8) -> ! {
    std::process::exit(code.into())
}
