use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use anyhow::Context as _;
use glam::UVec2;
use serde::Serialize;
use vitrine::export::{
    self, ExportError, Frames, Job, Layers, OutPattern, Summary, Wanted, export_layers,
};
use vitrine::frame::Controls;
use vitrine::input_script::{self, ScriptError};
use vitrine::output;
use vitrine::render::{Gpu, Watchdog};
use vitrine::report;
use vitrine::scene::Source;
use vitrine::session::{Session, Setup};
use vitrine::translate::{Output, Probe};

use super::findings::{checks, show_findings};
use super::opening::{adapter_choice, date, explain, gpu_failure, ready, slow_frame, watchdog};
use super::progress::Progress;
use super::sound::export_sound;
use super::{INTERRUPTED, SCENE_HAS_PROBLEMS, failure, options, source, unwritable};
use crate::cli::{Count, ExportArgs, Precision};

/// Frames per second where nothing says otherwise.
pub const DEFAULT_FPS: f64 = 60.0;

/// The pictures of a scene that is made for no size.
const USUAL_SIZE: UVec2 = UVec2::new(1280, 720);

pub fn export(args: ExportArgs, started: Instant) -> anyhow::Result<ExitCode> {
    if let Some(path) = &args.sound {
        return export_sound(&args, path);
    }
    let mut job = job(&args)?;
    // What cannot be written is refused before anything is started.
    job.check_output().map_err(explain_export)?;
    let source = source(&args.scene, args.web.refresh)?;
    let mut options = options(args.define.clone());
    if args.precision == Precision::F64 {
        options.precision = vitrine::translate::Precision::Double;
    }
    options.checks = checks(args.sanitize);
    options.low_samplers = args.lowp;
    if args.sanitize && args.precision == Precision::F64 {
        return Err(failure(
            "`--sanitize` looks at what is computed in 32 bits",
            "leave `--precision f64` away",
        ));
    }
    let wanted = wanted(&args, &job)?;
    if let ([probe], false) = (wanted.probes.as_slice(), job.out.is_exr()) {
        options.output = Output::Probe(probe.clone());
    }
    let Some(ready) = ready(&source, options, &args.inputs)? else {
        return Ok(SCENE_HAS_PROBLEMS.into());
    };
    job.size = ready.size(args.size, USUAL_SIZE);
    let setup = ready.setup;
    let opening = Instant::now();
    let gpu = Gpu::headless(&adapter_choice(&args.gpu)).map_err(|error| gpu_failure(&error))?;
    let driver = opening.elapsed();
    let watchdog = watchdog(&args.gpu);
    watchdog.begin();
    if job.out.is_exr() || wanted.rounds {
        return export_layered(&gpu, &source, &setup, &wanted, &job, &watchdog);
    }
    let session = match Session::open(&gpu, &source, &setup) {
        Ok(session) => session,
        Err(error) => return explain(error).map(Into::into),
    };
    report::show(&session.warnings);
    let opened = started.elapsed();

    let before = job.before(session.renderer.feeds_back()).count();
    if before > 0 {
        report::tell(format_args!(
            "drawing the {before} frames before, which its buffers remember"
        ));
    }
    let interrupted = interruption()?;
    let mut progress = Progress::new(job.frames.count(), "frames");
    let result = export::export(&gpu, &session, &job, &watchdog, &mut |written| {
        progress.at(written);
        !interrupted.load(Ordering::Relaxed)
    });
    progress.end();
    if let Err(ExportError::Slow { findings, .. }) = &result {
        // There is no time to draw it again for the operands.
        report::show(&findings.report(&session));
    }
    let mut summary = result.map_err(explain_export)?;
    show_findings(&gpu, &session, &mut summary.findings)?;
    let wall = started.elapsed();

    report_end(&job, &summary, wall);
    if let Some(path) = &args.stats {
        let stats = Stats::new(&gpu, &session, &job, &summary, driver, opened, wall);
        let text = serde_json::to_string_pretty(&stats)? + "\n";
        output::place(path, text.as_bytes(), true).map_err(|error| unwritable(path, &error))?;
    }
    Ok(match summary.interrupted {
        true => INTERRUPTED.into(),
        false => ExitCode::SUCCESS,
    })
}

/// What is asked for beside the picture, if the files can hold it.
fn wanted(args: &ExportArgs, job: &Job) -> anyhow::Result<Wanted> {
    let probes = args.probe.iter().map(|name| name.parse::<Probe>());
    let probes: Result<Vec<_>, _> = probes.collect();
    let wanted = Wanted {
        probes: probes.map_err(|message| failure(message, ""))?,
        rounds: args.count == Some(Count::Loops),
    };
    let fills = wanted.probes.len() + usize::from(wanted.rounds);
    if fills > 1 && !job.out.is_exr() {
        return Err(failure(
            "a PNG file holds one value in place of the colour",
            "write EXR files, `--out frames/%05d.exr`, which hold the picture and all values",
        ));
    }
    if args.stats.is_some() && (job.out.is_exr() || wanted.rounds) {
        return Err(failure(
            "`--stats` tells of plain pictures only",
            "`vitrine measure` times what draws values",
        ));
    }
    Ok(wanted)
}

/// Exports with values from within the pixels.
fn export_layered(
    gpu: &Gpu,
    source: &Source,
    setup: &Setup,
    wanted: &Wanted,
    job: &Job,
    watchdog: &Watchdog,
) -> anyhow::Result<ExitCode> {
    let started = Instant::now();
    let mut layers = match Layers::open(gpu, source, setup, wanted, job.size) {
        Ok(layers) => layers,
        Err(error) => return explain(error).map(Into::into),
    };
    report::show(&layers.picture.session.warnings);
    let interrupted = interruption()?;
    let mut progress = Progress::new(job.frames.count(), "frames");
    let result = export_layers(gpu, &mut layers, job, watchdog, &mut |written| {
        progress.at(written);
        !interrupted.load(Ordering::Relaxed)
    });
    progress.end();
    let mut summary = result.map_err(explain_export)?;
    show_findings(gpu, &layers.picture.session, &mut summary.findings)?;
    let files = &layers.picture.session.scene.files;
    let pixels = f64::from(job.size.element_product()) * f64::from(summary.frames.max(1));
    for work in &layers.loops {
        let place = match work.place {
            None => "the host's text".to_owned(),
            Some(span) => files.place(span),
        };
        report::tell(format_args!(
            "{place}: {:.0} rounds, {:.1} a pixel, {:.0} at most",
            work.rounds,
            work.rounds / pixels,
            work.most
        ));
    }
    report_end(job, &summary, started.elapsed());
    Ok(match summary.interrupted {
        true => INTERRUPTED.into(),
        false => ExitCode::SUCCESS,
    })
}

fn job(args: &ExportArgs) -> anyhow::Result<Job> {
    // Without it there is `--sound`, and the command line is refused without either.
    let out = args.out.as_deref().unwrap_or_default();
    let out = OutPattern::parse(out).map_err(|error| {
        failure(
            format!(
                "`--out {}`: {error}",
                args.out.as_deref().unwrap_or_default()
            ),
            "a pattern like frames/%05d.png gives every frame a file",
        )
    })?;
    let frames = match (args.frames, args.time) {
        (Some(range), _) => Frames::Range(range.start..range.end),
        (None, Some(time)) => Frames::At(time),
        (None, None) => Frames::Range(0..1),
    };
    let controls = controls(args)?;
    let fps = args.fps.unwrap_or(match &controls {
        Controls::Script(script) => script.fps,
        _ => DEFAULT_FPS,
    });
    Ok(Job {
        frames,
        fps,
        date: date(args.date.as_deref())?.unwrap_or_default(),
        controls,
        // The scene may say another one.
        size: USUAL_SIZE,
        out,
        overwrite: args.overwrite,
        timed: args.stats.is_some(),
    })
}

/// What the frames see of mouse and keys.
fn controls(args: &ExportArgs) -> anyhow::Result<Controls> {
    if let Some(path) = &args.input {
        let script = input_script::read(path).map_err(|error| {
            let hint = match error {
                ScriptError::Io { .. } => "",
                _ => "`vitrine run --record-input FILE` writes one",
            };
            failure(error, hint)
        })?;
        return Ok(Controls::Script(Arc::new(script)));
    }
    Ok(match args.mouse {
        Some(mouse) => Controls::Mouse(mouse.0.into()),
        None => Controls::Untouched,
    })
}

fn explain_export(error: ExportError) -> anyhow::Error {
    match &error {
        ExportError::Gpu(gpu) => gpu_failure(gpu),
        ExportError::Slow { limit, .. } => slow_frame(*limit),
        ExportError::OneFile { .. } => failure(
            &error,
            "put `%d` or `%05d` into `--out` where the frame number goes",
        ),
        ExportError::Exists { .. } => failure(
            &error,
            "add `--overwrite` to replace what is there, or choose another `--out`",
        ),
        ExportError::Write(write) => unwritable(&write.path, &write.error),
    }
}

/// Becomes true on the first Ctrl+C; a second one ends the process at once.
pub fn interruption() -> anyhow::Result<Arc<AtomicBool>> {
    let flag = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&flag);
    ctrlc::set_handler(move || {
        if raised.swap(true, Ordering::Relaxed) {
            std::process::exit(INTERRUPTED.into());
        }
        report::tell("finishing the frames under way; press Ctrl+C again to stop at once");
    })
    .context("cannot listen for Ctrl+C")?;
    Ok(flag)
}

fn report_end(job: &Job, summary: &Summary, wall: Duration) {
    let count = job.frames.count();
    let (first, done) = match &job.frames {
        Frames::Range(range) => (range.start, summary.frames),
        Frames::At(_) => (0, summary.frames),
    };
    let seconds = wall.as_secs_f64();
    if summary.interrupted {
        report::tell(format_args!("interrupted after {done} of {count} frames"));
        if let Frames::Range(range) = &job.frames {
            report::tell(format_args!(
                "the rest: --frames {}..{}",
                first + done,
                range.end
            ));
        }
    } else {
        let noun = if done == 1 { "frame" } else { "frames" };
        report::tell(format_args!("{done} {noun} in {seconds:.2} s"));
    }
}

/// Where the time of an export went. All times are in seconds.
#[derive(Serialize)]
struct Stats<'a> {
    scene: &'a str,
    adapter: String,
    width: u32,
    height: u32,
    frames: u32,
    /// From the start of the program to the last file.
    wall_seconds: f64,
    /// From the start of the program to the first submission; `driver`, `load`, `translate` and
    /// `pipeline` are parts of it.
    startup_seconds: f64,
    driver_seconds: f64,
    load_seconds: f64,
    translate_seconds: f64,
    pipeline_seconds: f64,
    /// From the first submission to the first picture back, late compilation by the driver included.
    first_frame_seconds: f64,
    /// Drawing, as the GPU's own clock has it; null where it has none.
    gpu_seconds: Option<f64>,
    /// The passes in the order in which they are drawn, and the part of `gpu_seconds` that each took. What that is more
    /// than their sum lies between them.
    passes: Vec<PassStats>,
    /// Passes that nothing needs, and that therefore cost nothing.
    left_out: Vec<&'static str>,
    /// Copying pictures out of the GPU's memory.
    read_back_seconds: f64,
    /// Encoding and writing, the sum over all threads.
    encode_seconds: f64,
}

#[derive(Serialize)]
struct PassStats {
    name: &'static str,
    gpu_seconds: Option<f64>,
}

impl<'a> Stats<'a> {
    fn new(
        gpu: &Gpu,
        session: &'a Session,
        job: &Job,
        summary: &Summary,
        driver: Duration,
        opened: Duration,
        wall: Duration,
    ) -> Self {
        Stats {
            scene: &session.scene.name,
            adapter: gpu.describe(),
            width: job.size.x,
            height: job.size.y,
            frames: summary.frames,
            wall_seconds: wall.as_secs_f64(),
            startup_seconds: opened.as_secs_f64(),
            driver_seconds: driver.as_secs_f64(),
            load_seconds: session.timing.load.as_secs_f64(),
            translate_seconds: session.timing.translate.as_secs_f64(),
            pipeline_seconds: session.timing.build.as_secs_f64(),
            first_frame_seconds: summary.first_frame.as_secs_f64(),
            gpu_seconds: summary.gpu_seconds,
            passes: (0..)
                .zip(&session.scene.passes)
                .map(|(place, pass)| PassStats {
                    name: pass.kind.name(),
                    gpu_seconds: summary.pass_seconds.get::<usize>(place).copied(),
                })
                .collect(),
            left_out: session.left_out.iter().map(|kind| kind.name()).collect(),
            read_back_seconds: summary.read_back.as_secs_f64(),
            encode_seconds: summary.encode.as_secs_f64(),
        }
    }
}
