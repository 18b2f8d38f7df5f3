//! Frames with what is known only within their pixels: probes as channels of EXR files, and the work
//! of loops as a heat map.

use std::time::Instant;

use glam::UVec2;

use super::{ExportError, Job, Summary};
use crate::frame::{Controls, FloatImage, FrameImage, FrameInput};
use crate::output::{self, PngSink, WriteError};
use crate::render::{Gpu, GpuError, Watchdog};
use crate::scene::Source;
use crate::session::{Findings, Moment, OpenError, Setup, Subject};
use crate::source::Span;
use crate::translate::{Checks, Options, Output, Probe};

/// What to write of each pixel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Values beside the picture.
    pub probes: Vec<Probe>,
    /// Whether the rounds of loops are counted.
    pub rounds: bool,
}

/// A scene, once for its picture and once for each value.
#[derive(Debug)]
pub struct Layers {
    /// The scene as it is drawn.
    pub picture: Subject,
    probes: Vec<(String, Subject)>,
    all_rounds: Option<Subject>,
    /// Each counts four loops.
    rounds: Vec<Subject>,
    /// What the loops did so far.
    pub loops: Vec<LoopWork>,
    /// What went wrong so far.
    findings: Findings,
}

/// What a loop did in all frames together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoopWork {
    /// Where it is written.
    pub place: Option<Span>,
    /// How many rounds it made.
    pub rounds: f64,
    /// The most that it made in one pixel.
    pub most: f32,
}

/// Named values of all pixels, top row first.
type Channels = Vec<(String, Vec<f32>)>;

impl Layers {
    /// Opens a scene for pictures of one size.
    pub fn open(
        gpu: &Gpu,
        source: &Source,
        setup: &Setup,
        wanted: &Wanted,
        size: UVec2,
    ) -> Result<Self, OpenError> {
        let open = |output: Output| -> Result<Subject, OpenError> {
            let options = Options {
                checks: match output {
                    Output::Colour => setup.options.checks.clone(),
                    _ => Checks::None,
                },
                output,
                ..setup.options.clone()
            };
            let setup = Setup {
                options,
                ..setup.clone()
            };
            let mut subject = Subject::open(gpu, source, &setup, size)?;
            subject.draw_in_bands(gpu);
            Ok(subject)
        };
        let picture = open(Output::Colour)?;
        let probes = wanted.probes.iter().map(|probe| {
            let subject = open(Output::Probe(probe.clone()))?;
            Ok((probe.to_string(), subject))
        });
        let probes = probes.collect::<Result<_, OpenError>>()?;
        let mut layers = Layers {
            probes,
            all_rounds: None,
            rounds: Vec::new(),
            loops: Vec::new(),
            findings: Findings::default(),
            picture,
        };
        if wanted.rounds {
            let programs = layers.picture.session.programs.last();
            let program = programs.expect("a scene has an Image pass");
            layers.loops = program
                .loops
                .iter()
                .map(|&place| LoopWork {
                    place,
                    ..LoopWork::default()
                })
                .collect();
            let firsts = (0..layers.loops.len() as u32).step_by(4);
            layers.rounds = firsts
                .map(|first| open(Output::Rounds(first)))
                .collect::<Result<_, _>>()?;
            layers.all_rounds = Some(open(Output::AllRounds)?);
        }
        Ok(layers)
    }

    /// Whether the picture tells more than is seen.
    fn is_watched(&self) -> bool {
        self.picture.session.renderer.finding_words() > 0
    }

    /// One frame's picture, which may find something.
    fn draw_picture(
        &mut self,
        gpu: &Gpu,
        input: &FrameInput,
        within: &str,
        waiting: &mut dyn FnMut(Moment),
    ) -> Result<FloatImage, GpuError> {
        let drawn = self.picture.draw(gpu, input, waiting)?;
        let programs = &self.picture.session.programs;
        self.findings.note(programs, &drawn.findings, input, within);
        Ok(drawn.image)
    }

    /// Draws a frame that is not wanted itself, but that buffers remember.
    fn pass(
        &mut self,
        gpu: &Gpu,
        input: &FrameInput,
        waiting: &mut dyn FnMut(Moment),
    ) -> Result<(), GpuError> {
        let probes = self.probes.iter_mut().map(|(_, subject)| subject);
        let counts = self.rounds.iter_mut().chain(&mut self.all_rounds);
        for subject in probes.chain(counts).chain([&mut self.picture]) {
            subject.draw(gpu, input, waiting)?;
        }
        Ok(())
    }

    /// The values of one frame.
    fn channels(
        &mut self,
        gpu: &Gpu,
        input: &FrameInput,
        within: &str,
        waiting: &mut dyn FnMut(Moment),
    ) -> Result<Channels, GpuError> {
        let picture = self.draw_picture(gpu, input, within, waiting)?;
        let mut channels: Channels = Vec::new();
        for (i, name) in ["R", "G", "B"].into_iter().enumerate() {
            channels.push((name.to_owned(), component(&picture, i)));
        }
        for (name, subject) in &mut self.probes {
            let image = subject.draw(gpu, input, waiting)?.image;
            if subject.components() == 1 {
                channels.push((name.clone(), component(&image, 0)));
                continue;
            }
            let parts = ["X", "Y", "Z", "W"].into_iter().enumerate();
            for (i, part) in parts.take(subject.components()) {
                channels.push((format!("{name}.{part}"), component(&image, i)));
            }
        }
        if let Some(image) = self.count(gpu, input, waiting)? {
            channels.push(("rounds".to_owned(), component(&image, 0)));
        }
        Ok(channels)
    }

    /// Counts one frame's rounds, if they are wanted; all of a pixel in every component.
    fn count(
        &mut self,
        gpu: &Gpu,
        input: &FrameInput,
        waiting: &mut dyn FnMut(Moment),
    ) -> Result<Option<FloatImage>, GpuError> {
        for (subject, loops) in self.rounds.iter_mut().zip(self.loops.chunks_mut(4)) {
            let image = subject.draw(gpu, input, waiting)?.image;
            for (i, work) in loops.iter_mut().enumerate() {
                for pixel in &image.rgba {
                    work.rounds += f64::from(pixel[i]);
                    work.most = work.most.max(pixel[i]);
                }
            }
        }
        let Some(subject) = &mut self.all_rounds else {
            return Ok(None);
        };
        Ok(Some(subject.draw(gpu, input, waiting)?.image))
    }
}

fn component(image: &FloatImage, index: usize) -> Vec<f32> {
    image.rgba.iter().map(|pixel| pixel[index]).collect()
}

/// Draws and writes all frames of a job: EXR files with all channels, or PNG files with the work of
/// loops as a heat map. The rest is as with [`super::export`].
pub fn export_layers(
    gpu: &Gpu,
    layers: &mut Layers,
    job: &Job,
    watchdog: &Watchdog,
    progress: &mut dyn FnMut(u32) -> bool,
) -> Result<Summary, ExportError> {
    job.check_output()?;
    let mut summary = Summary::default();
    let mut sink = PngSink::default();
    let start = Instant::now();
    // Left to themselves, subjects take it that mouse and keys were always as they are.
    let depends = matches!(job.controls, Controls::Script(_));
    let feeds_back = depends && layers.picture.session.renderer.feeds_back();
    for (_, input) in job.before(feeds_back) {
        let mut goes_on = true;
        watchdog.begin();
        layers.pass(gpu, &input, &mut |_| goes_on &= progress(0))?;
        watchdog.rest();
        if !goes_on {
            summary.interrupted = true;
            return Ok(summary);
        }
    }
    for (number, input) in job.inputs() {
        let path = job.out.path(number);
        watchdog.begin();
        let mut goes_on = true;
        let mut waiting = |_| goes_on &= progress(summary.frames);
        let within = job.within(number);
        let (mut exr, mut heat) = (None, None);
        if job.out.is_exr() {
            exr = Some(layers.channels(gpu, &input, &within, &mut waiting)?);
        } else {
            heat = layers.count(gpu, &input, &mut waiting)?;
            if layers.is_watched() {
                layers.draw_picture(gpu, &input, &within, &mut waiting)?;
            }
        }
        watchdog.rest();
        if summary.frames == 0 {
            summary.first_frame = start.elapsed();
        }
        let encode = Instant::now();
        if let Some(channels) = exr {
            let bytes = output::exr(job.size, channels);
            let placed = bytes.and_then(|bytes| output::place(&path, &bytes, job.overwrite));
            placed.map_err(|error| WriteError { path, error })?;
        } else if let Some(image) = heat {
            sink.write(&path, &heat_map(&image), job.overwrite)?;
        }
        summary.encode += encode.elapsed();
        summary.frames += 1;
        if !goes_on || !progress(summary.frames) {
            break;
        }
    }
    summary.interrupted = summary.frames < job.frames.count();
    summary.findings = std::mem::take(&mut layers.findings);
    Ok(summary)
}

/// Colours from black over red and yellow to white, as hot iron has; white is the most in the frame.
fn heat_map(image: &FloatImage) -> FrameImage {
    let most = image.rgba.iter().map(|pixel| pixel[0]).fold(1.0, f32::max);
    let pixels = image.rgba.iter().map(|pixel| {
        let heat = 3.0 * pixel[0] / most;
        [heat, heat - 1.0, heat - 2.0, 1.0]
    });
    FloatImage {
        size: image.size,
        rgba: pixels.collect(),
    }
    .to_bytes()
}
