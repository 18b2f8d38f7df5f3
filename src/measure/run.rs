//! Carries a study out: draws the reference and every variant, compares and times them.

use std::path::Path;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::compare::{self, PictureError, ProbeError};
use super::study::{ReferencePrecision, Study, Variant};
use crate::frame::{Clock, FloatImage};
use crate::media::Library;
use crate::render::Gpu;
use crate::scene::Source;
use crate::session::{Drawn, OpenError, Setup, Subject};
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
    /// The most in one pixel.
    pub most_rounds: f64,
    /// How far it is from the reference, in 32 bits as it is drawn.
    pub total: Errors,
    /// The part of it that comes of the method: both in 64 bits.
    pub discretisation: Option<Errors>,
    /// The part that comes of rounding: the variant in 32 bits against itself in 64.
    pub rounding: Option<Errors>,
    /// How far the reference is from itself refined, if it is to be.
    // What was kept before there was this is not to be read as if there were none.
    #[serde(deserialize_with = "Option::deserialize")]
    pub reference_error: Option<Errors>,
    /// How much the error changed since the frame before, if the study asks: see [`compare::flicker`].
    #[serde(deserialize_with = "Option::deserialize")]
    pub flicker: Option<f64>,
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
    pub fn error(&self) -> Option<f64> {
        self.total.main()
    }
}

impl Errors {
    /// The probe's median, or the picture's RMSE where there is no probe; `None` of a probe that has no
    /// pixel which both hit.
    pub fn main(&self) -> Option<f64> {
        match self.probe {
            Some(probe) => (probe.hits > 0).then_some(probe.median),
            None => Some(self.picture.rmse),
        }
    }
}

/// What a study found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Findings {
    /// Every variant at every moment.
    pub cells: Vec<Cell>,
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
    /// What comes next, or is under way.
    pub next: &'a str,
}

/// What a run needs from around it.
pub struct Surroundings<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// Where the files come from that channels read.
    pub library: Arc<Library>,
    /// The folder that the study's paths begin at.
    pub folder: &'a Path,
    /// Told before each step, and before each scene that is opened and each frame that is drawn.
    pub progress: &'a mut dyn FnMut(Progress<'_>),
    /// Asked for what an earlier run found out about a variant at a moment.
    pub known: &'a dyn Fn(&Variant, f64) -> Option<Cell>,
    /// Told what was found out, so that it need not be found again.
    pub keep: &'a mut dyn FnMut(&Cell),
}

/// Frames a second, of all pictures that are compared.
const FPS: f64 = 60.0;

/// A picture and a probe's values at each moment.
struct Views {
    pictures: Vec<FloatImage>,
    /// The pictures of the frames before, if they are asked for.
    before: Vec<FloatImage>,
    probes: Vec<FloatImage>,
    /// How many numbers a probe's value has.
    components: usize,
}

/// What variants are held against.
struct Truth {
    views: Views,
    /// How far it is from itself refined, at each moment; empty if it is not to be.
    refined: Vec<Errors>,
}

/// Carries a study out.
pub fn run(study: &Study, around: Surroundings<'_>) -> Result<Findings, OpenError> {
    let variants = study.variants(around.folder);
    let references = study.references(around.folder);
    let known: Vec<Option<Vec<Cell>>> = variants
        .iter()
        .map(|variant| known(variant, around.known))
        .collect();
    let mut is_needed = vec![false; references.len()];
    for (variant, known) in variants.iter().zip(&known) {
        is_needed[variant.reference] |= known.is_none();
    }
    let unknown = known.iter().filter(|known| known.is_none()).count();
    let needed = is_needed.iter().filter(|&&needed| needed).count();
    let mut run = Run {
        study,
        begun: 0,
        name: String::new(),
        // The last two are to compile what is timed, and the worst pictures.
        of: needed + unknown + study.repeats as usize + 2,
        around,
    };
    let mut truths = Vec::new();
    for (is_needed, (reference, refined)) in is_needed.into_iter().zip(&references) {
        truths.push(match is_needed {
            true => Some(run.truth(reference, refined.as_ref())?),
            false => None,
        });
    }
    let mut cells = Vec::new();
    for (variant, known) in variants.iter().zip(known) {
        match (known, &truths[variant.reference]) {
            (None, Some(truth)) => {
                let found = run.cells(variant, truth)?;
                found.iter().for_each(|cell| (run.around.keep)(cell));
                cells.extend(found);
            }
            (known, _) => cells.extend(known.into_iter().flatten()),
        }
    }
    let mut subjects = run.time(&variants, &mut cells)?;
    let worst = run.worst(&variants, &references, &truths, &cells, &mut subjects)?;
    Ok(Findings {
        worst,
        cells,
        pixels: study.size.element_product(),
    })
}

/// What is known of a variant, if it is known of all moments.
fn known(variant: &Variant, known: &dyn Fn(&Variant, f64) -> Option<Cell>) -> Option<Vec<Cell>> {
    let cell = |&time: &f64| {
        Some(Cell {
            reference: variant.reference,
            ..known(variant, time)?
        })
    };
    variant.times.iter().map(cell).collect()
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

    /// How much they flicker against others at each moment; empty if that is not asked for.
    fn flicker(&self, truth: &Views) -> Vec<f64> {
        let pairs = self.before.iter().zip(&self.pictures);
        let truths = truth.before.iter().zip(&truth.pictures);
        pairs
            .zip(truths)
            .map(|((before, now), (old, new))| compare::flicker([before, now], [old, new]))
            .collect()
    }
}

/// The most rounds in one pixel.
fn most(rounds: &FloatImage) -> f64 {
    let counts = rounds.rgba.iter().map(|pixel| f64::from(pixel[0]));
    counts.fold(0.0, f64::max)
}

struct Run<'s, 'a> {
    study: &'s Study,
    /// Steps that were begun, and the name of the last.
    begun: usize,
    name: String,
    of: usize,
    around: Surroundings<'a>,
}

impl Run<'_, '_> {
    fn step(&mut self, name: &str) {
        self.begun += 1;
        name.clone_into(&mut self.name);
        self.tell();
    }

    fn tell(&mut self) {
        (self.around.progress)(Progress {
            done: self.begun - 1,
            of: self.of,
            next: &self.name,
        });
    }

    fn reference_precision(&self) -> Precision {
        match self.study.reference.precision {
            ReferencePrecision::Double => Precision::Double,
            ReferencePrecision::Single => Precision::Single,
        }
    }

    fn open(
        &mut self,
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
        self.tell();
        let setup = Setup {
            options,
            library: Arc::clone(&self.around.library),
            ..Setup::default()
        };
        Subject::open(self.around.gpu, &source, &setup, self.study.size)
    }

    fn draw(&mut self, subject: &mut Subject, time: f64) -> Result<Drawn, OpenError> {
        self.tell();
        let input = Clock::fixed(FPS).at_time(time, self.study.size);
        Ok(subject.draw(self.around.gpu, &input, &mut |_| {})?)
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
        let mut subject = self.open(variant, precision, Output::Colour)?;
        let (mut pictures, mut before) = (Vec::new(), Vec::new());
        for &time in &variant.times {
            if self.study.flicker {
                before.push(self.draw(&mut subject, time - 1.0 / FPS)?.image);
            }
            pictures.push(self.draw(&mut subject, time)?.image);
        }
        let (probes, components) = match &self.study.probe {
            None => (Vec::new(), 0),
            Some(probe) => self.images(variant, precision, Output::Probe(probe.clone()))?,
        };
        Ok(Views {
            pictures,
            before,
            probes,
            components,
        })
    }

    /// How many rounds loops make in each pixel.
    fn rounds(&mut self, variant: &Variant) -> Result<Vec<FloatImage>, OpenError> {
        let (rounds, _) = self.images(variant, Precision::Single, Output::AllRounds)?;
        Ok(rounds)
    }

    fn truth(
        &mut self,
        reference: &Variant,
        refined: Option<&Variant>,
    ) -> Result<Truth, OpenError> {
        self.step(&reference.name());
        let precision = self.reference_precision();
        let views = self.views(reference, precision)?;
        let refined = match refined {
            Some(refined) => self.views(refined, precision)?.errors(&views, self.study),
            None => Vec::new(),
        };
        Ok(Truth { views, refined })
    }

    /// Everything about a variant but its times.
    fn cells(&mut self, variant: &Variant, truth: &Truth) -> Result<Vec<Cell>, OpenError> {
        self.step(&variant.name());
        let study = self.study;
        let single = self.views(variant, Precision::Single)?;
        let total = single.errors(&truth.views, study);
        let flicker = single.flicker(&truth.views);
        let (mut discretisation, mut rounding) = (Vec::new(), Vec::new());
        if study.reference.precision == ReferencePrecision::Double {
            let double = self.views(variant, Precision::Double)?;
            discretisation = double.errors(&truth.views, study);
            rounding = single.errors(&double, study);
        }
        let rounds = self.rounds(variant)?;
        let cell = |at: usize| {
            let counts = rounds[at].rgba.iter().map(|pixel| f64::from(pixel[0]));
            Cell {
                family: variant.family.clone(),
                label: variant.label.clone(),
                defines: variant.defines.clone(),
                reference: variant.reference,
                time: variant.times[at],
                rounds: counts.sum::<f64>() / f64::from(study.size.element_product()),
                most_rounds: most(&rounds[at]),
                total: total[at],
                discretisation: discretisation.get(at).copied(),
                rounding: rounding.get(at).copied(),
                reference_error: truth.refined.get(at).copied(),
                flicker: flicker.get(at).copied(),
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
        self.step("compiling");
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

    /// The pictures that are furthest off. Of a reference that was not drawn, because all that is held against it is
    /// known from before, the picture alone is drawn.
    fn worst(
        &mut self,
        variants: &[Variant],
        references: &[(Variant, Option<Variant>)],
        truths: &[Option<Truth>],
        cells: &[Cell],
        subjects: &mut [Subject],
    ) -> Result<Vec<Worst>, OpenError> {
        self.step("the worst pictures");
        // Which variant a cell is of, and which of its moments.
        let moments =
            |variant: usize| (0..variants[variant].times.len()).map(move |at| (variant, at));
        let places = (0..variants.len()).flat_map(moments);
        let mut order: Vec<_> = cells.iter().zip(places).collect();
        order.sort_by(|(a, _), (b, _)| {
            let [a, b] = [a, b].map(|cell| cell.total.picture.rmse);
            b.total_cmp(&a)
        });
        let mut drawn: Vec<Option<Subject>> = references.iter().map(|_| None).collect();
        let mut worst = Vec::new();
        for (cell, (variant, at)) in order.into_iter().take(WORST) {
            let image = self.draw(&mut subjects[variant], cell.time)?.image;
            let difference = match &truths[cell.reference] {
                Some(truth) => compare::difference(&image, &truth.views.pictures[at]),
                None => {
                    let subject = match &mut drawn[cell.reference] {
                        Some(subject) => subject,
                        empty => empty.insert(self.open(
                            &references[cell.reference].0,
                            self.reference_precision(),
                            Output::Colour,
                        )?),
                    };
                    compare::difference(&image, &self.draw(subject, cell.time)?.image)
                }
            };
            worst.push(Worst {
                name: variants[variant].name(),
                time: cell.time,
                difference,
            });
        }
        Ok(worst)
    }
}
