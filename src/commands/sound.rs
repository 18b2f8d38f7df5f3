//! `export --sound`: the sound of a scene's Sound pass as a WAV file.

use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::Ordering;

use vitrine::frame::SAMPLE_RATE;
use vitrine::output::{Samples, WavSink};
use vitrine::render::{Gpu, SOUND_BLOCK};
use vitrine::report;
use vitrine::session::Track;

use super::export::{DEFAULT_FPS, interruption};
use super::opening::{adapter_choice, explain, gpu_failure, ready, watchdog};
use super::progress::Progress;
use super::{INTERRUPTED, SCENE_HAS_PROBLEMS, failure, options, source, unwritable};
use crate::cli::{ExportArgs, SoundFormat};

/// Writes the sound that belongs to the frames, or that of the length that is asked for.
pub fn export_sound(args: &ExportArgs, path: &Path) -> anyhow::Result<ExitCode> {
    let rate = f64::from(SAMPLE_RATE);
    let fps = args.fps.unwrap_or(DEFAULT_FPS);
    let sample = |seconds: f64| (seconds * rate).round() as u64;
    let (start, end) = match (args.frames, args.seconds) {
        (Some(frames), None) => (
            sample(f64::from(frames.start) / fps),
            sample(f64::from(frames.end) / fps),
        ),
        (_, seconds) => (0, sample(seconds.unwrap_or(Track::SECONDS)).max(1)),
    };
    // `iSampleOffset` is an int.
    if end > i32::MAX as u64 {
        return Err(failure(
            "the sound is longer than its samples can be counted",
            "a sound has at most 48,695 seconds",
        ));
    }
    let samples = match args.sound_format {
        SoundFormat::Pcm16 => Samples::Pcm16,
        SoundFormat::Float => Samples::Float32,
    };
    let unwritten = |error: vitrine::output::WriteError| unwritable(&error.path, &error.error);
    let mut wav = WavSink::create(path, rate as u32, samples, end - start, args.overwrite)
        .map_err(|error| match error.error.kind() {
            std::io::ErrorKind::AlreadyExists => failure(
                format!("`{}` exists already", path.display()),
                "choose another name, or replace it with `--overwrite`",
            ),
            _ => unwritten(error),
        })?;
    let source = source(&args.scene, args.web.refresh)?;
    let options = options(args.define.clone());
    let Some(ready) = ready(&source, options, &args.inputs)? else {
        return Ok(SCENE_HAS_PROBLEMS.into());
    };
    let gpu = Gpu::headless(&adapter_choice(&args.gpu)).map_err(|error| gpu_failure(&error))?;
    let watchdog = watchdog(&args.gpu);
    watchdog.begin();
    let mut track = match Track::open(&gpu, &source, &ready.setup) {
        Ok(Some(track)) => track,
        Ok(None) => {
            return Err(failure(
                format!("`{}` has no Sound pass", args.scene.display()),
                "a folder scene has its sound in `sound.glsl`, a shader of the site in the tab Sound",
            ));
        }
        Err(error) => return explain(error).map(Into::into),
    };
    report::show(&track.session.warnings);
    let interrupted = interruption()?;
    let block = u64::from(SOUND_BLOCK);
    let (first, last) = (start / block, (end - 1) / block);
    let mut progress = Progress::new((last - first + 1) as u32, "blocks");
    let mut no_numbers = 0_u64;
    for number in first..=last {
        watchdog.begin();
        let mut goes_on = || !interrupted.load(Ordering::Relaxed);
        let computed = track.block(&gpu, number as u32, &mut goes_on);
        let Some(frames) = computed.map_err(|error| gpu_failure(&error))? else {
            return Ok(INTERRUPTED.into());
        };
        let from = start.saturating_sub(number * block) as usize;
        let to = (end - number * block).min(block) as usize;
        let wanted = &frames[from..to];
        no_numbers += wanted
            .iter()
            .flatten()
            .filter(|sample| sample.is_nan())
            .count() as u64;
        wav.push(wanted).map_err(unwritten)?;
        progress.at((number - first + 1) as u32);
    }
    watchdog.rest();
    progress.end();
    wav.finish().map_err(unwritten)?;
    if no_numbers > 0 {
        report::tell(format_args!(
            "warning: {no_numbers} samples are no numbers (NaN); they are silent"
        ));
    }
    let seconds = (end - start) as f64 / rate;
    report::tell(format_args!(
        "{seconds:.1} s of sound in {}",
        path.display()
    ));
    Ok(ExitCode::SUCCESS)
}
