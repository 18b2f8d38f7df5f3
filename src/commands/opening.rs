//! What every command that draws does first, and how it gives up.

use std::time::Duration;

use vitrine::frame::Date;
use vitrine::render::{AdapterChoice, GpuError, Watchdog};
use vitrine::report;
use vitrine::scene::Source;
use vitrine::session::{OpenError, Setup};
use vitrine::translate::{Options, translate};

use super::media::library;
use super::{HOST_FAILED, SCENE_HAS_PROBLEMS, failure, loaded, unreadable};
use crate::cli::{GpuArgs, MediaArgs};

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

/// Whether a scene loads, translates and can be drawn; if not, its problems are printed. Asked before
/// a driver is started and a window opened, which take far longer.
fn can_run(source: &Source, options: &Options) -> anyhow::Result<bool> {
    let ready = loaded(source)?.and_then(|scene| translate(&scene, options));
    if let Err(report) = &ready {
        report::show(report);
    }
    Ok(ready.is_ok())
}

/// How to open a scene that can run; `None` if it cannot, and its problems are printed.
pub fn setup(
    source: &Source,
    options: Options,
    media: &MediaArgs,
) -> anyhow::Result<Option<Setup>> {
    if !can_run(source, &options)? {
        return Ok(None);
    }
    Ok(Some(Setup {
        options,
        library: library(media)?,
        ..Setup::default()
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
