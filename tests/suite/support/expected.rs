//! The picture that a file's header promises.
//!
//! ```text
//! // subject in a sentence
//! // expect: R G B           bytes 0..255, the same in every pixel
//! // or: R G B               another picture that is fine too, where the language leaves it open
//! // expect-at: X Y R G B    instead of these: some pixels, counted from the bottom left
//! ```
//!
//! The pictures are 8 by 8 pixels at `iTime` 0.5, which is frame 30, with no channel bound. Most files
//! count checks: check *k*, in the order of the file, adds bit *k* % 8 to the channel *k* / 8. All bits
//! are expected, so that the bits that are missing name the checks that failed, and a translator that
//! does nothing fails them all.

use std::io::{self, Write as _};
use std::sync::Mutex;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use glam::UVec2;
use vitrine::frame::{Clock, FrameImage};
use vitrine::media::Inputs;
use vitrine::render::{AdapterChoice, Format, Gpu, GpuError, Renderer};
use vitrine::scene::Scene;
use vitrine::translate::{Arithmetic, Options, Program};

use super::{Case, draw_with, plain};

type Colour = [u8; 3];

const SIZE: UVec2 = UVec2::splat(8);

/// A file takes some milliseconds.
const SLOW: Duration = Duration::from_secs(20);

enum Expected {
    /// Every pixel has one of these colours, the same in the whole picture.
    Everywhere(Vec<Colour>),
    /// These pixels, counted from the bottom left.
    At(Vec<(UVec2, Colour)>),
}

impl Expected {
    fn of(case: &Case) -> Result<Self, String> {
        let mut colours = Vec::new();
        for text in case.header("expect").iter().chain(&case.header("or")) {
            colours.push(numbers(text)?);
        }
        let mut points = Vec::new();
        for text in case.header("expect-at") {
            let [x, y, r, g, b] = numbers(&text)?;
            let point = UVec2::new(x.into(), y.into());
            if point.max_element() >= SIZE.min_element() {
                return Err(format!("there is no pixel {point}"));
            }
            points.push((point, [r, g, b]));
        }
        match (colours.is_empty(), points.is_empty()) {
            (false, true) => Ok(Expected::Everywhere(colours)),
            (true, false) => Ok(Expected::At(points)),
            _ => Err("its header needs either `// expect:` or `// expect-at:`".to_owned()),
        }
    }

    /// What is wrong with a picture.
    fn compare(&self, picture: &FrameImage, counts_checks: bool) -> Result<(), String> {
        let wrong: Vec<(UVec2, Colour, Colour)> = match self {
            Expected::Everywhere(colours) => {
                let wrong = |colour: &Colour| -> Vec<_> {
                    let all = (0..SIZE.y).flat_map(|y| (0..SIZE.x).map(move |x| UVec2::new(x, y)));
                    differences(picture, all.map(|point| (point, *colour)))
                };
                let wrong: Vec<_> = colours.iter().map(wrong).collect();
                if wrong.iter().any(Vec::is_empty) {
                    return Ok(());
                }
                wrong.into_iter().next().expect("there is a first colour")
            }
            Expected::At(points) => differences(picture, points.iter().copied()),
        };
        let Some((point, got, want)) = wrong.first() else {
            return Ok(());
        };
        let mut problem = format!(
            "{} pixels are wrong; ({}, {}) is {got:?} instead of {want:?}",
            wrong.len(),
            point.x,
            point.y
        );
        if counts_checks {
            let failed = failed_checks(&wrong);
            problem = format!("the checks {failed:?}, counted from 0, fail: {problem}");
        }
        Err(problem)
    }
}

fn numbers<const N: usize>(text: &str) -> Result<[u8; N], String> {
    let numbers: Result<Vec<u8>, _> = text.split_whitespace().map(str::parse).collect();
    let numbers = numbers.ok().and_then(|numbers| numbers.try_into().ok());
    numbers.ok_or_else(|| format!("`{text}` should be {N} numbers from 0 to 255"))
}

fn differences(
    picture: &FrameImage,
    wanted: impl Iterator<Item = (UVec2, Colour)>,
) -> Vec<(UVec2, Colour, Colour)> {
    wanted
        .map(|(point, want)| (point, picture.pixel(point.x, SIZE.y - 1 - point.y), want))
        .filter(|(_, got, want)| got != want)
        .collect()
}

/// The numbers of the bits in which any pixel differs.
fn failed_checks(wrong: &[(UVec2, Colour, Colour)]) -> Vec<usize> {
    let fails = |check: &usize| {
        let (channel, bit) = (check / 8, 1 << (check % 8));
        wrong
            .iter()
            .any(|(_, got, want)| (got[channel] ^ want[channel]) & bit != 0)
    };
    (0..24).filter(fails).collect()
}

/// Draws many files from several threads, each thread on a device of its own: drivers on the CPU
/// compile on one thread for each device. The other tests' device is left alone, because one broken
/// program can cost everybody the device.
pub struct Drawing {
    idle: Mutex<Vec<Gpu>>,
}

impl Drawing {
    /// `None` where [`super::gpu`] is.
    pub fn new() -> Option<Self> {
        super::gpu()?;
        let idle = Mutex::default();
        Some(Drawing { idle })
    }

    /// Translates and draws a file and holds the picture against its header. The error says what is
    /// wrong.
    pub fn is_as_expected(&self, case: &Case, strict: bool) -> Result<(), String> {
        let expected = Expected::of(case)?;
        let _slow = told_when_slow(&case.name);
        let (scene, programs) = case
            .translated_with(&Options {
                strict,
                // As it is when it is drawn.
                arithmetic: Arithmetic::Expanded,
                ..Options::default()
            })
            .map_err(|report| format!("it is refused\n{}", plain(&report)))?;
        let picture = self
            .draw(&scene, &programs)
            .map_err(|error| error.to_string())?;
        let counts_checks = String::from_utf8_lossy(&case.text).contains("okR");
        expected.compare(&picture, counts_checks)
    }

    /// Whatever fails is tried again on a new device, where only the culprit fails again.
    fn draw(&self, scene: &Scene, programs: &[Program]) -> Result<FrameImage, GpuError> {
        let mut gpu = self.idle.lock().expect("no holder panics").pop();
        let picture = gpu.as_ref().map(|gpu| drawn(gpu, scene, programs));
        let picture = match picture {
            Some(Ok(picture)) => picture,
            _ => drawn(
                gpu.insert(Gpu::headless(&AdapterChoice::Auto)?),
                scene,
                programs,
            )?,
        };
        self.idle.lock().expect("no holder panics").extend(gpu);
        Ok(picture)
    }
}

fn drawn(gpu: &Gpu, scene: &Scene, programs: &[Program]) -> Result<FrameImage, GpuError> {
    let renderer = Renderer::new(gpu, scene, programs, &Inputs::default(), Format::Bytes)?;
    draw_with(gpu, &renderer, &Clock::fixed(60.0).at(30, SIZE))
}

/// Names a file on standard error that is still under way after a while: a driver that does not come
/// back would otherwise hold up the tests without a word. It is quiet once the result is dropped.
fn told_when_slow(name: &str) -> Sender<()> {
    let (under_way, ended) = mpsc::channel();
    let name = name.to_owned();
    thread::spawn(move || {
        if ended.recv_timeout(SLOW) == Err(RecvTimeoutError::Timeout) {
            // Not with a macro: what macros print is kept back until the test ends.
            let _ = writeln!(io::stderr(), "{name} takes longer than {SLOW:?}");
        }
    });
    under_way
}

#[test]
fn a_wrong_picture_names_its_failing_checks() {
    let case = |header: &str| Case {
        name: "case".to_owned(),
        text: header.into(),
    };
    let filled = |colour: Colour| FrameImage {
        size: SIZE,
        rgb: colour.repeat(64),
    };
    let expected = Expected::of(&case("// subject\n// expect: 255 3 0\n// or: 1 2 3\n"));
    let expected = expected.expect("an expectation");
    assert_eq!(expected.compare(&filled([255, 3, 0]), true), Ok(()));
    assert_eq!(expected.compare(&filled([1, 2, 3]), true), Ok(()));
    let problem = expected.compare(&filled([253, 1, 0]), true);
    let problem = problem.expect_err("bits are missing");
    assert!(problem.starts_with("the checks [1, 9], "), "{problem}");

    let expected = Expected::of(&case("// subject\r\n// expect-at: 2 0 9 8 7\r\nvoid"));
    let expected = expected.expect("an expectation");
    let mut picture = filled([0; 3]);
    picture.rgb[3 * (7 * 8 + 2)..][..3].copy_from_slice(&[9, 8, 7]);
    assert_eq!(expected.compare(&picture, false), Ok(()));

    for header in [
        "",
        "// expect: 1 2",
        "// expect: 1 2 256",
        "// expect-at: 8 0 1 1 1",
    ] {
        assert!(Expected::of(&case(header)).is_err(), "{header}");
    }
}
