//! Frames to files: a pipeline in which one frame is drawn while the one before is read back and
//! those before that are encoded and written on other threads.

mod draw;
mod encoders;
mod layers;
mod pattern;

pub use layers::{Layers, LoopWork, Wanted, export_layers};
pub use pattern::{OutPattern, PatternError};

use std::collections::VecDeque;
use std::ops::Range;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use draw::{Drawing, Outcome};
use encoders::Encoders;
use glam::UVec2;

use crate::frame::{Clock, Controls, Date, FixedClock, FrameInput};
use crate::output::WriteError;
use crate::render::{Extras, Gpu, GpuError, ReadBack, Watchdog};
use crate::session::{Findings, Session};

/// Frames under way at once: one being drawn, one being read back, one waiting in between.
const RING: usize = 3;

/// What to export.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Which frames.
    pub frames: Frames,
    /// Frames per second of the fixed clock; positive and finite.
    pub fps: f64,
    /// `iDate`, which stands still.
    pub date: Date,
    /// The mouse and the keys.
    pub controls: Controls,
    /// Width and height of every picture in pixels.
    pub size: UVec2,
    /// Where the pictures go.
    pub out: OutPattern,
    /// Whether files that are already there are replaced.
    pub overwrite: bool,
    /// Whether to ask the GPU how long it draws.
    pub timed: bool,
}

/// A selection of frames.
#[derive(Clone, Debug, PartialEq)]
pub enum Frames {
    /// Frames by number, the end not included.
    Range(Range<u32>),
    /// The one frame at this time in seconds.
    At(f64),
}

impl Frames {
    /// How many frames these are.
    pub fn count(&self) -> u32 {
        match self {
            Frames::Range(range) => range.end.saturating_sub(range.start),
            Frames::At(_) => 1,
        }
    }
}

/// Why an export stopped.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The driver failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// A frame took longer than the watchdog's limit, but the device is not stuck.
    #[error("a frame was not finished after {:.0} s", limit.as_secs_f64())]
    Slow {
        /// The limit.
        limit: Duration,
        /// What had gone wrong by then.
        findings: Findings,
    },
    /// A picture could not be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// Several frames would go to one file.
    #[error("{count} frames cannot all be written to one file")]
    OneFile {
        /// How many.
        count: u32,
    },
    /// Files are in the way.
    #[error("`{}` exists already{}", first.display(), more(*.count))]
    Exists {
        /// The first of them.
        first: PathBuf,
        /// How many there are.
        count: usize,
    },
}

fn more(count: usize) -> String {
    match count {
        1 => String::new(),
        count => format!(", and {} more", count - 1),
    }
}

/// What an export did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Files written.
    pub frames: u32,
    /// Whether it was told to stop before the end.
    pub interrupted: bool,
    /// From the first frame's submission until its picture was back. Drivers that compile late do it
    /// here.
    pub first_frame: Duration,
    /// Time that the GPU drew, all frames together, if it was asked and can tell.
    pub gpu_seconds: Option<f64>,
    /// The parts of it that each pass took, in their order; none where that is not known.
    pub pass_seconds: Vec<f64>,
    /// Time spent copying pictures out of the GPU's memory.
    pub read_back: Duration,
    /// Time spent encoding and writing, all threads together.
    pub encode: Duration,
    /// What went wrong in the frames.
    pub findings: Findings,
}

impl Job {
    /// Refuses what cannot be written, before anything is drawn.
    pub fn check_output(&self) -> Result<(), ExportError> {
        let count = self.frames.count();
        if count > 1 && !self.out.is_numbered() {
            return Err(ExportError::OneFile { count });
        }
        if self.overwrite {
            return Ok(());
        }
        let taken = match (&self.frames, self.out.is_numbered()) {
            (Frames::Range(range), true) => self.out.existing(range.clone()),
            _ => self
                .inputs()
                .map(|(number, _)| number)
                .filter(|&n| self.out.path(n).exists())
                .collect(),
        };
        match taken.first() {
            None => Ok(()),
            Some(&first) => Err(ExportError::Exists {
                first: self.out.path(first),
                count: taken.len(),
            }),
        }
    }

    /// How a frame is called in findings.
    fn within(&self, number: u32) -> String {
        match self.frames.count() {
            1 => String::new(),
            _ => format!("frame {number}"),
        }
    }

    /// The frames that have to be drawn before the first one that is wanted, because it depends on them.
    pub fn before(&self, feeds_back: bool) -> impl Iterator<Item = (u32, FrameInput)> + '_ {
        let clock = self.clock();
        let first = match &self.frames {
            Frames::Range(range) => range.start,
            Frames::At(time) => clock.at_time(*time, self.size).frame.max(0) as u32,
        };
        let count = if feeds_back { first } else { 0 };
        let mut hands = self.controls.hands(self.size);
        (0..count).map(move |number| (number, hands(clock.at(number, self.size))))
    }

    fn clock(&self) -> FixedClock {
        Clock::fixed(self.fps).on(self.date)
    }

    /// Every frame's number and input.
    fn inputs(&self) -> impl Iterator<Item = (u32, FrameInput)> + '_ {
        let clock = self.clock();
        let mut hands = self.controls.hands(self.size);
        let (range, single) = match &self.frames {
            Frames::Range(range) => (range.clone(), None),
            Frames::At(time) => (0..0, Some(clock.at_time(*time, self.size))),
        };
        range
            .map(move |number| (number, clock.at(number, self.size)))
            .chain(single.map(|input| (input.frame as u32, input)))
            .map(move |(number, input)| (number, hands(input)))
    }
}

/// Draws and writes all frames of a job.
///
/// `progress` is called with the number of files written so far, after each frame that has come
/// back; returning `false` ends the export once the frames under way are written. The watchdog is
/// told of every frame.
pub fn export(
    gpu: &Gpu,
    session: &Session,
    job: &Job,
    watchdog: &Watchdog,
    progress: &mut dyn FnMut(u32) -> bool,
) -> Result<Summary, ExportError> {
    job.check_output()?;
    let mut drawing = Drawing::new(gpu, session, job, watchdog)?;
    let extras = Extras {
        timed_passes: match job.timed {
            true => session.renderer.pass_count(),
            false => 0,
        },
        finding_words: session.renderer.finding_words(),
    };
    let ring = ReadBack::new(gpu, &drawing.canvas.target, RING, extras)?;
    let mut free = ring.slots;
    let mut under_way = VecDeque::with_capacity(RING);
    let mut encoders = Encoders::start(job.overwrite);
    let mut summary = Summary::default();
    let before = job.before(session.renderer.feeds_back());
    let before = before.map(|(number, input)| (number, input, false));
    let wanted = job.inputs().map(|(number, input)| (number, input, true));
    let mut inputs = before.chain(wanted);
    let start = Instant::now();
    let mut came_back = 0;
    watchdog.begin();
    let drawn: Result<(), ExportError> = (|| {
        loop {
            // Keep the GPU supplied.
            while !summary.interrupted
                && (drawing.is_quick() || under_way.is_empty())
                && !free.is_empty()
                && let Some((number, input, is_wanted)) = inputs.next()
            {
                let mut slot = if is_wanted { free.pop() } else { None };
                let mut goes_on = true;
                let mut waiting = || goes_on &= progress(encoders.written);
                let outcome = drawing.draw(&input, slot.as_mut(), &mut waiting)?;
                summary.interrupted |= !goes_on;
                if let Outcome::GivenUp(limit, words) = outcome {
                    let mut findings = std::mem::take(&mut summary.findings);
                    findings.note(&session.programs, &words, &input, &job.within(number));
                    return Err(ExportError::Slow { limit, findings });
                }
                match slot {
                    Some(slot) => under_way.push_back((number, input, slot)),
                    None => watchdog.begin(),
                }
            }
            // Take back the oldest frame.
            let Some((number, input, mut slot)) = under_way.pop_front() else {
                return Ok(());
            };
            let waiting = Instant::now();
            while !slot.is_ready(gpu)? {
                summary.interrupted |= !progress(encoders.written);
            }
            drawing.waited(waiting.elapsed());
            // A slow disk is not the GPU's fault.
            watchdog.rest();
            let mut image = encoders.blank()?;
            watchdog.begin();
            let copy = Instant::now();
            let transferred = slot.take(gpu, &mut image)?;
            summary.read_back += copy.elapsed();
            if let Some(seconds) = transferred.gpu_seconds {
                *summary.gpu_seconds.get_or_insert(0.0) += seconds;
            }
            let passes = transferred.pass_seconds;
            summary.pass_seconds.resize(passes.len(), 0.0);
            for (sum, seconds) in summary.pass_seconds.iter_mut().zip(passes) {
                *sum += seconds;
            }
            summary.findings.note(
                &session.programs,
                &transferred.findings,
                &input,
                &job.within(number),
            );
            if came_back == 0 {
                summary.first_frame = start.elapsed();
            }
            came_back += 1;
            encoders.write(job.out.path(number), image);
            free.push(slot);
            summary.interrupted |= !progress(encoders.written);
        }
    })();
    watchdog.rest();
    let written = encoders.finish();
    drawn?;
    (summary.frames, summary.encode) = written?;
    summary.interrupted &= summary.frames < job.frames.count();
    progress(summary.frames);
    Ok(summary)
}
