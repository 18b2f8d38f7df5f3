//! Where a scene breaks: draws it under extreme times, sizes, mice and frame numbers.

use std::fmt;

use glam::{UVec2, Vec4};
use serde::Serialize;

use super::compare;
use crate::frame::{Clock, FloatImage, FrameInput};
use crate::render::Gpu;
use crate::scene::Source;
use crate::session::{Drawn, Findings, Moment, OpenError, Setup, Subject};
use crate::source::{Diagnostic, Report};
use crate::translate::{Checks, Options, Output, Precision};

/// The size of pictures where the size itself is not what varies.
pub const SIZE: UVec2 = UVec2::new(96, 54);

/// The rounds that loops not known to end may make in a pixel. Mesa's drivers on the CPU end all loops
/// of a pixel after 65,535 together, without a word.
pub const ROUND_BUDGET: u32 = 50_000;

/// From which share of pixels on, off by more than 8/255, 32 bits no longer draw the picture.
pub const ROUNDING_LIMIT: f64 = 0.25;

/// How many times a step from frame to frame may exceed both of its neighbours.
pub const JUMP_FACTOR: f64 = 4.0;

/// Steps below this RMSE are never jumps.
pub const JUMP_LEAST: f64 = 0.02;

/// What is extreme.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// What varies, and its value.
    pub name: String,
    /// The frame.
    pub input: FrameInput,
    /// Macros that it sets.
    pub defines: Vec<(String, String)>,
    /// Whether the scene is expected to stand it.
    pub is_required: bool,
    /// Whether it is one of the moments at which the frames around are looked at.
    pub is_moment: bool,
}

/// What is wrong with a picture, with the threshold that it crossed.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Fault {
    /// Pixels with a component that is no number; the first, from the bottom left.
    Nan {
        /// How many.
        pixels: usize,
        /// Column and row.
        first: [u32; 2],
    },
    /// Pixels with an infinite component.
    Infinite {
        /// How many.
        pixels: usize,
        /// Column and row.
        first: [u32; 2],
    },
    /// The share of pixels that are off by more than 8/255 from the same in 64 bits, which is over
    /// [`ROUNDING_LIMIT`].
    Rounding {
        /// The share.
        share: f64,
    },
    /// Every pixel has one colour, though the scene at rest has many.
    Flat,
    /// Pixels in which loops that are not known to end made over [`ROUND_BUDGET`] rounds.
    Endless {
        /// How many.
        pixels: usize,
        /// Column and row.
        first: [u32; 2],
        /// The loop that made the most there, as `file:line:column`.
        place: Option<String>,
    },
    /// A step to the next frame that is out of line with the steps around it: over [`JUMP_FACTOR`]
    /// times the larger.
    Jump {
        /// Its RMSE over the larger neighbour's.
        factor: f64,
    },
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Nan {
                pixels,
                first: [x, y],
            } => {
                write!(f, "{pixels} pixels are no number, the first at ({x}, {y})")
            }
            Fault::Infinite {
                pixels,
                first: [x, y],
            } => {
                write!(f, "{pixels} pixels are infinite, the first at ({x}, {y})")
            }
            Fault::Rounding { share } => write!(
                f,
                "rounding moves {:.0} % of the pixels by more than 8/255 (limit {:.0} %)",
                share * 100.0,
                ROUNDING_LIMIT * 100.0
            ),
            Fault::Flat => write!(f, "every pixel has the same colour"),
            Fault::Endless {
                pixels,
                first: [x, y],
                place,
            } => write!(
                f,
                "a loop does not end in {pixels} pixels, the first at ({x}, {y}){}; cut off after \
                 {ROUND_BUDGET} rounds",
                place
                    .as_ref()
                    .map_or(String::new(), |place| format!(": {place}"))
            ),
            Fault::Jump { factor } => write!(
                f,
                "the step to the next frame is {factor:.1} times its neighbours (limit {JUMP_FACTOR})"
            ),
        }
    }
}

/// What was found out about a case.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// What varied, and its value.
    pub name: String,
    /// Whether the scene is expected to stand it.
    pub required: bool,
    /// What is wrong; nothing, if all is well.
    pub faults: Vec<Fault>,
    /// At how many places of the text the sanitizer found something, if it looked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub findings: Option<usize>,
    /// The share of pixels that rounding moves by more than 8/255; none where the device has no 64 bits.
    pub rounding: Option<f64>,
}

/// The cases that every scene is put to.
pub fn cases(defines: &[(String, Vec<String>)]) -> Vec<Case> {
    let clock = Clock::fixed(60.0);
    let at = |time: f64, size: UVec2| clock.at_time(time, size);
    let case = |name: String, input: FrameInput, is_required: bool| Case {
        name,
        input,
        defines: Vec::new(),
        is_required,
        is_moment: false,
    };
    let mut cases = Vec::new();
    for time in [0.0, 1e-3, 1.0, 60.0, 3_600.0, 86_400.0, 1e6, 1e7] {
        cases.push(Case {
            is_moment: true,
            ..case(format!("iTime = {time}"), at(time, SIZE), time <= 3_600.0)
        });
    }
    for (x, y) in [(1, 1), (2, 1), (1, 2000), (4096, 2)] {
        let name = format!("iResolution = {x} × {y}");
        cases.push(case(name, at(1.0, UVec2::new(x, y)), true));
    }
    let size = SIZE.as_vec2();
    for (x, y) in [(0.0, 0.0), (size.x, 0.0), (0.0, size.y), (size.x, size.y)] {
        let mouse = Vec4::new(x, y, x, y);
        let input = FrameInput {
            mouse,
            ..at(1.0, SIZE)
        };
        cases.push(case(format!("iMouse at ({x}, {y})"), input, true));
    }
    for frame in [0, 1 << 24, i32::MAX] {
        let input = FrameInput {
            frame,
            ..at(1.0, SIZE)
        };
        cases.push(case(format!("iFrame = {frame}"), input, true));
    }
    for time_delta in [0.0, 10.0] {
        let input = FrameInput {
            time_delta,
            ..at(1.0, SIZE)
        };
        cases.push(case(format!("iTimeDelta = {time_delta}"), input, true));
    }
    for (name, values) in defines {
        for value in values {
            cases.push(Case {
                defines: vec![(name.clone(), value.clone())],
                ..case(format!("{name} = {value}"), at(1.0, SIZE), true)
            });
        }
    }
    cases
}

/// What was found out about a scene.
#[derive(Clone, Debug, Default)]
pub struct Examination {
    /// A verdict for each case.
    pub verdicts: Vec<Verdict>,
    /// What the sanitizer found in all of them, if [`Options::checks`] is [`Checks::All`].
    pub findings: Report,
}

/// Puts a scene to all cases. `progress` is told the number of cases done and the next one's name.
pub fn examine(
    gpu: &Gpu,
    source: &Source,
    setup: &Setup,
    cases: &[Case],
    progress: &mut dyn FnMut(usize, &str),
) -> Result<Examination, OpenError> {
    let mut scene = Examined {
        progress,
        case: (0, String::new()),
        gpu,
        source,
        setup,
        open: Vec::new(),
        findings: Vec::new(),
    };
    let rest = Clock::fixed(60.0).at_time(1.0, SIZE);
    let rest = scene.image(&rest, &[], Precision::Single, &Output::Colour)?;
    let is_varied = !is_flat(&rest);
    let mut verdicts = Vec::new();
    for (done, case) in cases.iter().enumerate() {
        scene.case = (done, case.name.clone());
        scene.tell();
        verdicts.push(scene.verdict(case, is_varied)?);
    }
    Ok(Examination {
        verdicts,
        findings: scene.report()?,
    })
}

/// A scene, opened in as many ways as it has been drawn.
struct Examined<'a> {
    progress: &'a mut dyn FnMut(usize, &str),
    /// The case that is looked at, and how many there were before.
    case: (usize, String),
    gpu: &'a Gpu,
    source: &'a Source,
    setup: &'a Setup,
    open: Vec<(Way, Subject)>,
    /// What the sanitizer found under each set of macros.
    findings: Vec<(Way, Findings)>,
}

/// What tells the ways apart.
#[derive(Clone, PartialEq)]
struct Way {
    size: UVec2,
    defines: Vec<(String, String)>,
    precision: Precision,
    output: Output,
    checks: Checks,
}

impl Way {
    /// As the window draws it, under some macros.
    fn plain(input: &FrameInput, defines: &[(String, String)]) -> Self {
        Way {
            size: input.resolution,
            defines: defines.to_vec(),
            precision: Precision::Single,
            output: Output::Colour,
            checks: Checks::None,
        }
    }
}

impl Examined<'_> {
    fn tell(&mut self) {
        (self.progress)(self.case.0, &self.case.1);
    }

    /// Draws a frame in one of the ways; the frames before it that buffers remember count each for itself.
    fn draw(&mut self, way: &Way, input: &FrameInput) -> Result<Drawn, OpenError> {
        let at = self.open(way)?;
        let Examined {
            progress,
            case,
            gpu,
            open,
            ..
        } = self;
        let mut tell = |moment| {
            if moment == Moment::FrameDone {
                progress(case.0, &case.1);
            }
        };
        Ok(open[at].1.draw(gpu, input, &mut tell)?)
    }

    fn subject(&mut self, way: &Way) -> Result<&mut Subject, OpenError> {
        let at = self.open(way)?;
        Ok(&mut self.open[at].1)
    }

    /// Opens the scene in one of the ways, unless it is open so; its place among those that are.
    fn open(&mut self, way: &Way) -> Result<usize, OpenError> {
        let known = self.open.iter().position(|(known, _)| known == way);
        Ok(match known {
            Some(index) => index,
            None => {
                let options = Options {
                    overrides: [&*self.setup.options.overrides, &way.defines].concat(),
                    precision: way.precision,
                    output: way.output.clone(),
                    checks: way.checks.clone(),
                    round_budget: Some(ROUND_BUDGET),
                    ..self.setup.options.clone()
                };
                let setup = Setup {
                    options,
                    ..self.setup.clone()
                };
                let subject = Subject::open(self.gpu, self.source, &setup, way.size)?;
                self.open.push((way.clone(), subject));
                self.open.len() - 1
            }
        })
    }

    fn image(
        &mut self,
        input: &FrameInput,
        defines: &[(String, String)],
        precision: Precision,
        output: &Output,
    ) -> Result<FloatImage, OpenError> {
        let way = Way {
            precision,
            output: output.clone(),
            ..Way::plain(input, defines)
        };
        Ok(self.draw(&way, input)?.image)
    }

    /// Draws a case once more, watched; at how many places something went wrong.
    fn sanitize(&mut self, case: &Case) -> Result<Option<usize>, OpenError> {
        if self.setup.options.checks != Checks::All {
            return Ok(None);
        }
        let way = Way {
            checks: Checks::All,
            ..Way::plain(&case.input, &case.defines)
        };
        let known = |(known, _): &(Way, Findings)| known.defines == way.defines;
        let known = self.findings.iter().position(known);
        let (first, mut findings) = match known {
            Some(known) => self.findings.swap_remove(known),
            None => (way.clone(), Findings::default()),
        };
        let drawn = self.draw(&way, &case.input)?;
        let programs = &self.subject(&way)?.session.programs;
        let count = findings.note(programs, &drawn.findings, &case.input, &case.name);
        self.findings.push((first, findings));
        Ok(Some(count))
    }

    /// What the sanitizer found in all cases; what several sets of macros have in common, once.
    fn report(&mut self) -> Result<Report, OpenError> {
        let mut report = Report::default();
        let gpu = self.gpu;
        for (way, mut findings) in std::mem::take(&mut self.findings) {
            let session = &self.subject(&way)?.session;
            findings.find_operands(gpu, session)?;
            let found = findings.report(session);
            report.files = found.files;
            for diagnostic in found.diagnostics {
                let is_known = |known: &Diagnostic| {
                    (known.code, known.span) == (diagnostic.code, diagnostic.span)
                };
                if !report.diagnostics.iter().any(is_known) {
                    report.diagnostics.push(diagnostic);
                }
            }
        }
        Ok(report)
    }

    fn verdict(&mut self, case: &Case, is_varied: bool) -> Result<Verdict, OpenError> {
        let Case { input, defines, .. } = case;
        let image = self.image(input, defines, Precision::Single, &Output::Colour)?;
        let mut faults = Vec::new();
        if let Some((pixels, first)) = count(&image, |pixel| pixel.iter().any(|x| x.is_nan())) {
            faults.push(Fault::Nan { pixels, first });
        }
        if let Some((pixels, first)) = count(&image, |pixel| pixel.iter().any(|x| x.is_infinite()))
        {
            faults.push(Fault::Infinite { pixels, first });
        }
        if is_varied && input.resolution.element_product() >= 16 && is_flat(&image) {
            faults.push(Fault::Flat);
        }
        let mut rounding = None;
        if self.gpu.has_float64() {
            let double = self.image(input, defines, Precision::Double, &Output::Colour)?;
            let share = compare::picture(&image, &double).above_8;
            rounding = Some(share);
            if share > ROUNDING_LIMIT {
                faults.push(Fault::Rounding { share });
            }
        }
        let spent = self.image(input, defines, Precision::Single, &Output::Spent)?;
        if let Some((pixels, first)) = count(&spent, |pixel| pixel[0] > ROUND_BUDGET as f32) {
            let place = self.busiest_loop(input, defines, first)?;
            faults.push(Fault::Endless {
                pixels,
                first,
                place,
            });
        }
        if case.is_moment {
            faults.extend(self.jump(case, &image)?);
        }
        Ok(Verdict {
            name: case.name.clone(),
            required: case.is_required,
            faults,
            findings: self.sanitize(case)?,
            rounding,
        })
    }

    /// The loop that made the most rounds in a pixel.
    fn busiest_loop(
        &mut self,
        input: &FrameInput,
        defines: &[(String, String)],
        [x, y]: [u32; 2],
    ) -> Result<Option<String>, OpenError> {
        let way = Way::plain(input, defines);
        let loops = self.subject(&way)?.session.programs.last();
        let loops = loops.map_or(Vec::new(), |image| image.loops.clone());
        let at = ((input.resolution.y - 1 - y) * input.resolution.x + x) as usize;
        let mut rounds = Vec::new();
        for first in (0..loops.len() as u32).step_by(4) {
            let image = self.image(input, defines, Precision::Single, &Output::Rounds(first))?;
            rounds.extend(image.rgba[at]);
        }
        let counted = loops.iter().zip(&rounds);
        let busiest = counted.max_by(|a, b| a.1.total_cmp(b.1));
        let scene = &self.subject(&way)?.session.scene;
        Ok(busiest.and_then(|(span, _)| Some(scene.files.place((*span)?))))
    }

    /// Whether the step to the next frame is out of line with the step before and the one behind.
    fn jump(&mut self, case: &Case, image: &FloatImage) -> Result<Option<Fault>, OpenError> {
        let mut frame = |step: f32| -> Result<FloatImage, OpenError> {
            let time = case.input.time + step / 60.0;
            let input = FrameInput { time, ..case.input };
            self.image(&input, &case.defines, Precision::Single, &Output::Colour)
        };
        let frames = [&frame(-1.0)?, image, &frame(1.0)?, &frame(2.0)?];
        let step = |at: usize| compare::picture(frames[at], frames[at + 1]).rmse;
        let around = step(0).max(step(2));
        let factor = step(1) / around;
        let is_jump = step(1) > JUMP_LEAST && factor > JUMP_FACTOR;
        Ok(is_jump.then_some(Fault::Jump { factor }))
    }
}

/// How many pixels are so, and the first from the bottom left.
fn count(image: &FloatImage, is_so: impl Fn(&[f32; 4]) -> bool) -> Option<(usize, [u32; 2])> {
    let (width, height) = (image.size.x as usize, image.size.y as usize);
    let rows = image.rgba.chunks(width).rev().enumerate();
    let mut found = rows.flat_map(|(y, row)| {
        let pixels = row.iter().enumerate().filter(|(_, pixel)| is_so(pixel));
        pixels.map(move |(x, _)| [x as u32, y as u32])
    });
    debug_assert_eq!(image.rgba.len(), width * height);
    let first = found.next()?;
    Some((1 + found.count(), first))
}

fn is_flat(image: &FloatImage) -> bool {
    let bytes = image.to_bytes().rgb;
    bytes.chunks(3).all(|pixel| pixel == &bytes[..3])
}
