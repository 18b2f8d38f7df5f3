//! Carries a study out: draws the reference and every variant, compares and times them.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::compare::{self, PictureError, ProbeError};
use super::study::{ReferencePrecision, Study, Variant};
use crate::frame::{Clock, FloatImage};
use crate::render::Gpu;
use crate::scene::Source;
use crate::session::{Drawn, OpenError, Subject};
use crate::translate::{Options, Output, Precision};

/// What is known of a variant at one moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// The variant's family.
    pub family: String,
    /// What tells it apart there.
    pub label: String,
    /// Its macros.
    pub defines: Vec<(String, String)>,
    /// Which of the study's references it is held against.
    pub reference: usize,
    /// `iTime`.
    pub time: f64,
    /// Rounds of loops, a pixel's mean.
    pub rounds: f64,
    /// How far it is from the reference, in 32 bits as it is drawn.
    pub total: Errors,
    /// The part of it that comes of the method: both in 64 bits.
    pub discretisation: Option<Errors>,
    /// The part that comes of rounding: the variant in 32 bits against itself in 64.
    pub rounding: Option<Errors>,
    /// Seconds that the device drew, ascending, one for each repetition.
    pub seconds: Vec<f64>,
}

/// How far a picture is from another, and a probe's values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// Of the probe, if the study has one.
    pub probe: Option<ProbeError>,
    /// Of the picture.
    pub picture: PictureError,
}

impl Cell {
    /// The median of the times.
    pub fn median_seconds(&self) -> Option<f64> {
        (!self.seconds.is_empty()).then(|| compare::quantile(&self.seconds, 0.5))
    }

    /// The error that the study is about.
    pub fn error(&self) -> f64 {
        self.total.main()
    }
}

impl Errors {
    /// The probe's median, or the picture's RMSE where there is no probe.
    pub fn main(&self) -> f64 {
        self.probe.map_or(self.picture.rmse, |probe| probe.median)
    }
}

/// What a study found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Findings {
    /// Every variant at every moment.
    pub cells: Vec<Cell>,
    /// How far each reference that is refined is from itself refined, at each moment.
    pub reference: Vec<Errors>,
    /// How many pixels a picture has.
    pub pixels: u32,
    /// The pictures that are furthest from the reference's.
    #[serde(skip)]
    pub worst: Vec<Worst>,
}

/// A picture far from the reference's.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// The variant's name.
    pub name: String,
    /// `iTime`.
    pub time: f64,
    /// How far each channel is off, with its sign lost.
    pub difference: FloatImage,
}

/// How many of the worst pictures are shown.
const WORST: usize = 3;

/// What someone waiting should know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress<'a> {
    /// Steps done.
    pub done: usize,
    /// Steps in all.
    pub of: usize,
    /// What comes next.
    pub next: &'a str,
}

/// What a run needs from around it.
pub struct Surroundings<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// The folder that the study's paths begin at.
    pub folder: &'a Path,
    /// Told before each step, and while the device is waited for.
    pub progress: &'a mut dyn FnMut(Progress<'_>),
    /// Asked for what an earlier run found out about a variant at a moment.
    pub known: &'a dyn Fn(&Variant, f64) -> Option<Cell>,
    /// Told what was found out, so that it need not be found again.
    pub keep: &'a mut dyn FnMut(&Cell),
}

/// A picture and a probe's values at each moment.
struct Views {
    pictures: Vec<FloatImage>,
    probes: Vec<FloatImage>,
    /// How many numbers a probe's value has.
    components: usize,
}

/// Carries a study out.
pub fn run(study: &Study, around: Surroundings<'_>) -> Result<Findings, OpenError> {
    let variants = study.variants(around.folder);
    let references = study.references(around.folder);
    let mut run = Run {
        study,
        done: 0,
        of: variants.len() + references.len() + study.repeats as usize,
        around,
    };
    let (mut truths, mut reference) = (Vec::new(), Vec::new());
    for (variant, refined) in &references {
        run.step(&variant.name());
        let truth = run.views(variant, run.reference_precision())?;
        if let Some(refined) = refined {
            let refined = run.views(refined, run.reference_precision())?;
            reference.extend(refined.errors(&truth, study));
        }
        truths.push(truth);
    }
    let mut cells = Vec::new();
    for variant in &variants {
        run.step(&variant.name());
        let times = variant.times.iter();
        let known: Option<Vec<Cell>> = times
            .map(|&time| (run.around.known)(variant, time))
            .collect();
        match known {
            Some(known) => cells.extend(known),
            None => {
                let found = run.cells(variant, &truths[variant.reference])?;
                found.iter().for_each(|cell| (run.around.keep)(cell));
                cells.extend(found);
            }
        }
    }
    let mut subjects = run.time(&variants, &mut cells)?;
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by(|&a, &b| {
        let rmse = |at: usize| cells[at].total.picture.rmse;
        rmse(b).total_cmp(&rmse(a))
    });
    // Which variant a cell is of, and which of its moments.
    let cells_of = |(index, variant): (usize, &Variant)| {
        let moments = 0..variant.times.len();
        moments.map(move |at| (index, at)).collect::<Vec<_>>()
    };
    let places: Vec<_> = variants.iter().enumerate().flat_map(cells_of).collect();
    let mut worst = Vec::new();
    for (index, at) in order.into_iter().take(WORST).map(|cell| places[cell]) {
        let variant = &variants[index];
        let image = run.draw(&mut subjects[index], variant.times[at])?.image;
        worst.push(Worst {
            name: variant.name(),
            time: variant.times[at],
            difference: compare::difference(&image, &truths[variant.reference].pictures[at]),
        });
    }
    Ok(Findings {
        worst,
        cells,
        reference,
        pixels: study.size.element_product(),
    })
}

impl Views {
    /// How far they are from others.
    fn errors(&self, truth: &Views, study: &Study) -> Vec<Errors> {
        (0..self.pictures.len())
            .map(|at| Errors {
                probe: study.probe.as_ref().map(|_| {
                    let (own, truth) = (&self.probes[at], &truth.probes[at]);
                    compare::probe(own, truth, self.components)
                }),
                picture: compare::picture(&self.pictures[at], &truth.pictures[at]),
            })
            .collect()
    }
}

struct Run<'s, 'a> {
    study: &'s Study,
    done: usize,
    of: usize,
    around: Surroundings<'a>,
}

impl Run<'_, '_> {
    fn step(&mut self, next: &str) {
        let (done, of) = (self.done, self.of);
        (self.around.progress)(Progress { done, of, next });
        self.done += 1;
    }

    fn reference_precision(&self) -> Precision {
        match self.study.reference.precision {
            ReferencePrecision::Double => Precision::Double,
            ReferencePrecision::Single => Precision::Single,
        }
    }

    fn open(
        &self,
        variant: &Variant,
        precision: Precision,
        output: Output,
    ) -> Result<Subject, OpenError> {
        let options = Options {
            overrides: variant.defines.clone(),
            precision,
            output,
            ..Options::default()
        };
        let source = Source::Path(variant.scene.clone());
        Subject::open(self.around.gpu, &source, &options, self.study.size)
    }

    fn draw(&mut self, subject: &mut Subject, time: f64) -> Result<Drawn, OpenError> {
        let input = Clock::fixed(60.0).at_time(time, self.study.size);
        Ok(subject.draw(self.around.gpu, &input, &mut || {})?)
    }

    /// Draws something at every moment of a variant; how many components of it mean something.
    fn images(
        &mut self,
        variant: &Variant,
        precision: Precision,
        output: Output,
    ) -> Result<(Vec<FloatImage>, usize), OpenError> {
        let mut subject = self.open(variant, precision, output)?;
        let components = subject.components();
        let times = variant.times.iter();
        let images = times.map(|&time| Ok(self.draw(&mut subject, time)?.image));
        Ok((images.collect::<Result<_, OpenError>>()?, components))
    }

    fn views(&mut self, variant: &Variant, precision: Precision) -> Result<Views, OpenError> {
        let (pictures, _) = self.images(variant, precision, Output::Colour)?;
        let (probes, components) = match &self.study.probe {
            None => (Vec::new(), 0),
            Some(probe) => self.images(variant, precision, Output::Probe(probe.clone()))?,
        };
        Ok(Views {
            pictures,
            probes,
            components,
        })
    }

    /// Everything about a variant but its times.
    fn cells(&mut self, variant: &Variant, truth: &Views) -> Result<Vec<Cell>, OpenError> {
        let study = self.study;
        let single = self.views(variant, Precision::Single)?;
        let total = single.errors(truth, study);
        let (mut discretisation, mut rounding) = (Vec::new(), Vec::new());
        if study.reference.precision == ReferencePrecision::Double {
            let double = self.views(variant, Precision::Double)?;
            discretisation = double.errors(truth, study);
            rounding = single.errors(&double, study);
        }
        let (rounds, _) = self.images(variant, Precision::Single, Output::AllRounds)?;
        let cell = |at: usize| {
            let counts = rounds[at].rgba.iter().map(|pixel| f64::from(pixel[0]));
            Cell {
                family: variant.family.clone(),
                label: variant.label.clone(),
                defines: variant.defines.clone(),
                reference: variant.reference,
                time: variant.times[at],
                rounds: counts.sum::<f64>() / f64::from(study.size.element_product()),
                total: total[at],
                discretisation: discretisation.get(at).copied(),
                rounding: rounding.get(at).copied(),
                seconds: Vec::new(),
            }
        };
        Ok((0..variant.times.len()).map(cell).collect())
    }

    /// Times all variants in turn, again and again, so that what disturbs the machine disturbs all.
    fn time(
        &mut self,
        variants: &[Variant],
        cells: &mut [Cell],
    ) -> Result<Vec<Subject>, OpenError> {
        let mut subjects = Vec::with_capacity(variants.len());
        for variant in variants {
            let mut subject = self.open(variant, Precision::Single, Output::Colour)?;
            // Some drivers finish compiling only when they first draw.
            self.draw(&mut subject, variant.times[0])?;
            subjects.push(subject);
        }
        for cell in cells.iter_mut() {
            cell.seconds.clear();
        }
        for repetition in 1..=self.study.repeats {
            self.step(&format!("timing, round {repetition}"));
            let mut cells = cells.iter_mut();
            for (variant, subject) in variants.iter().zip(&mut subjects) {
                for (&time, cell) in variant.times.iter().zip(&mut cells) {
                    cell.seconds.extend(self.draw(subject, time)?.seconds);
                }
            }
        }
        for cell in cells {
            cell.seconds.sort_by(f64::total_cmp);
        }
        Ok(subjects)
    }
}
