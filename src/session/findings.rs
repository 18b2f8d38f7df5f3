//! What goes wrong while frames are drawn: gathered over frames, and looked at again for the operands.

use super::floats::frames_before;
use super::{OpenError, Session};
use crate::frame::FrameInput;
use crate::render::{Extras, Gpu, GpuError, Pace, ReadBack, Renderer};
use crate::source::{Diagnostic, Report};
use crate::translate::{self, Checks, Finding, OPERAND_WORDS, Program};

/// What frames of one session have found, by pass and site.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Findings {
    found: Vec<Found>,
}

/// What was found at a site.
#[derive(Clone, Debug, PartialEq)]
struct Found {
    /// The pass, by its number.
    pass: usize,
    finding: Finding,
    /// The first frame.
    input: FrameInput,
    /// Whether someone looks for the operands, or has.
    is_known: bool,
}

impl Findings {
    /// What has been found since this was asked last.
    pub fn take_new(&mut self) -> Findings {
        let new = self.found.iter_mut().filter(|found| !found.is_known);
        let found = new.map(|found| {
            let new = found.clone();
            found.is_known = true;
            new
        });
        Findings {
            found: found.collect(),
        }
    }

    /// Whether nothing went wrong.
    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// Takes in the words that a frame has brought back. `within` names the frame, as
    /// [`Finding::within`] does. Returns how many sites have something wrong in this frame.
    pub fn note(
        &mut self,
        programs: &[Program],
        mut words: &[u32],
        input: &FrameInput,
        within: &str,
    ) -> usize {
        let mut count = 0;
        for (pass, program) in programs.iter().enumerate() {
            let Some(own) = program
                .findings
                .and_then(|own| words.split_off(..own as usize))
            else {
                continue;
            };
            for (site, (words, place)) in own.chunks_exact(2).zip(&program.sites).enumerate() {
                // What the host's text does is no author's business.
                if words[0] == 0 || place.span.is_none() {
                    continue;
                }
                count += 1;
                let first = !words[1];
                let pixel = [first as u16, (first >> 16) as u16];
                self.add(pass, site, words[0], pixel, input, within);
            }
        }
        count
    }

    fn add(
        &mut self,
        pass: usize,
        site: usize,
        pixels: u32,
        first: [u16; 2],
        input: &FrameInput,
        within: &str,
    ) {
        let key = |found: &Found| (found.pass, found.finding.site);
        match self.found.binary_search_by_key(&(pass, site), key) {
            Ok(known) => {
                let known = &mut self.found[known].finding;
                known.pixels += u64::from(pixels);
                known.frames += 1;
            }
            Err(place) => {
                let finding = Finding {
                    site,
                    cause: site,
                    pixels: pixels.into(),
                    frames: 1,
                    first,
                    within: within.to_owned(),
                    operands: String::new(),
                };
                let found = Found {
                    pass,
                    finding,
                    input: *input,
                    is_known: false,
                };
                self.found.insert(place, found);
            }
        }
    }

    /// Draws the first frames again, to see what the operands were. The session must be the one whose frames
    /// were noted.
    pub fn find_operands(&mut self, gpu: &Gpu, session: &Session) -> Result<(), OpenError> {
        for pass in 0..session.programs.len() {
            self.find_operands_of(pass, gpu, session)?;
        }
        self.found
            .iter_mut()
            .for_each(|found| found.is_known = true);
        Ok(())
    }

    fn find_operands_of(
        &mut self,
        pass: usize,
        gpu: &Gpu,
        session: &Session,
    ) -> Result<(), OpenError> {
        let sites = &session.programs[pass].sites;
        let of_pass = self.found.iter_mut().filter(|found| found.pass == pass);
        let asked: Vec<&mut Found> = of_pass
            .filter(|found| !found.is_known && sites[found.finding.site].has_operands())
            .collect();
        if asked.is_empty() {
            return Ok(());
        }
        let wanted = asked.iter().map(|found| {
            let Finding { site, first, .. } = found.finding;
            (site as u32, first)
        });
        let options = translate::Options {
            checks: Checks::Operands(wanted.collect()),
            ..session.setup.options.clone()
        };
        let scene = &session.scene;
        let programs =
            translate::translate(scene, &options).map_err(|report| OpenError::Scene {
                report,
                read: scene.read.clone(),
            })?;
        let renderer = {
            let format = session.setup.format;
            Renderer::new(gpu, scene, &programs, &session.inputs, format)?
        };
        // One program looks at all sites; each frame tells of those that it was the first for.
        let mut drawn: Vec<(FrameInput, Vec<u32>)> = Vec::new();
        let before: u32 = programs[..pass].iter().filter_map(|p| p.findings).sum();
        for (slot, found) in asked.into_iter().enumerate() {
            let known = drawn.iter().position(|(input, _)| *input == found.input);
            let known = match known {
                Some(known) => known,
                None => {
                    let words = words(gpu, &renderer, &found.input)?;
                    drawn.push((found.input, words));
                    drawn.len() - 1
                }
            };
            let words = &drawn[known].1;
            let at = before as usize + slot * OPERAND_WORDS as usize;
            found.finding.look_up(sites, &words[at..]);
        }
        Ok(())
    }

    /// What there is to say, each site once, in the order of the text.
    pub fn report(&self, session: &Session) -> Report {
        let diagnostics = self.found.iter().map(|found| {
            let program = &session.programs[found.pass];
            Diagnostic {
                pass: Some(program.kind.name().to_owned()),
                ..found.finding.diagnostic(&program.sites)
            }
        });
        let mut diagnostics: Vec<Diagnostic> = diagnostics.collect();
        diagnostics.sort_by_key(|diagnostic| diagnostic.span.map(|s| (s.file, s.start, s.end)));
        Report {
            files: session.scene.files.clone(),
            diagnostics,
        }
    }
}

/// Draws a frame for the words that it notes.
fn words(gpu: &Gpu, renderer: &Renderer, input: &FrameInput) -> Result<Vec<u32>, GpuError> {
    let mut canvas = renderer.canvas(gpu, input.resolution)?;
    let extras = Extras {
        finding_words: renderer.finding_words(),
        ..Extras::default()
    };
    let mut ring = ReadBack::new(gpu, &canvas.target, 1, extras)?;
    let slot = &mut ring.slots[0];
    let mut pace = Pace::new(gpu, input.resolution);
    for before in frames_before(input, renderer.feeds_back()) {
        renderer.render_in_bands(gpu, &before, &mut canvas, None, &mut pace, &mut || true)?;
    }
    renderer.render_in_bands(gpu, input, &mut canvas, Some(slot), &mut pace, &mut || true)?;
    while !slot.is_ready(gpu)? {}
    slot.take_findings(gpu)
}
