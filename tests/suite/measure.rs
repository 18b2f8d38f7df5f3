//! `vitrine measure`: what it says of scenes whose truth is known in closed form.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use vitrine::measure::compare::quantile;
use vitrine::measure::run::{Cell, Findings, Surroundings, run};
use vitrine::measure::study::{Study, Variant};
use vitrine::measure::summary::{Row, cheapest, rows};
use vitrine::render::Gpu;

use crate::support::{Folder, gpu, vitrine};

/// A ray for each pixel, down onto a plane one unit below the eye. WAY 0 meets it by formula, WAY 1 in
/// even steps, and takes the middle of the last one.
const PLANE: &str = "
#define WAY 0
#define STEP 0.1
#define SHIFT 0.0
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 rd = normalize(vec3(uv, -1.));
    float t = -1. / rd.z;
#if WAY == 1
    t = 0.;
    for (int i = 0; i < 4000; i++) {
        if (1. + t * rd.z < 0.) break;
        t += STEP;
    }
    t -= .5 * STEP;
#elif WAY == 2
    if (fragCoord.x < 8.) t = -1.;
#endif
    fragColor = vec4(vec3(.25 + SHIFT), 1.);
}";

const STUDY: &str = r#"
title = "A plane"
scene = "plane.glsl"
size = "64x32"
probe = "t"
repeats = 3
goals = [0.02]
[reference]
define = { WAY = 0 }
refined = { SHIFT = 0.0 }
[[family]]
name = "exact"
vary = { SHIFT = [0.0, 0.125] }
[[family]]
name = "steps"
define = { WAY = 1 }
vary = { STEP = [0.4, 0.1, 0.025] }
[[family]]
name = "misses"
define = { WAY = 2 }
"#;

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("plane.glsl", PLANE);
    folder.write("study.toml", STUDY);
    folder
}

fn findings(
    gpu: &Gpu,
    folder: &Path,
    known: &dyn Fn(&Variant, f64) -> Option<Cell>,
) -> (Findings, usize, BTreeSet<String>) {
    findings_of(gpu, STUDY, folder, known)
}

fn findings_of(
    gpu: &Gpu,
    study: &str,
    folder: &Path,
    known: &dyn Fn(&Variant, f64) -> Option<Cell>,
) -> (Findings, usize, BTreeSet<String>) {
    let study = Study::parse(study).expect("a study");
    let (mut kept, mut steps) = (0, BTreeSet::new());
    let around = Surroundings {
        gpu,
        library: Default::default(),
        folder,
        progress: &mut |step| {
            steps.insert(step.next.to_owned());
        },
        known,
        keep: &mut |_| kept += 1,
    };
    (run(&study, around).expect("good scenes"), kept, steps)
}

/// The relative errors of steps, sorted.
fn expected(step: f64) -> Vec<f64> {
    let mut errors = Vec::new();
    for y in 0..32 {
        for x in 0..64 {
            let (u, v) = ((f64::from(x) + 0.5) / 64.0, (f64::from(y) + 0.5) / 32.0);
            let exact = (u * u + v * v + 1.0).sqrt();
            let stepped = (exact / step).ceil() * step - 0.5 * step;
            errors.push((stepped - exact).abs() / exact);
        }
    }
    errors.sort_by(f64::total_cmp);
    errors
}

#[track_caller]
fn assert_three_digits(got: f64, want: f64) {
    assert!(
        (got - want).abs() <= 1e-3 * want.abs(),
        "{got} instead of {want}"
    );
}

#[test]
fn what_changes_from_frame_to_frame_flickers() {
    let Some(gpu) = gpu() else { return };
    // A picture that grows brighter, with an error that stays, and one that comes and goes.
    let folder = Folder::with(
        "grey.glsl",
        "#define OFF 0.0\n#define SWING 0.0\n\
         void mainImage(out vec4 c, in vec2 p) {\n\
             c = vec4(vec3(0.25 + 0.1 * iTime + OFF + SWING * float(iFrame % 2)), 1);\n\
         }",
    );
    let study = r#"
        title = "Grey"
        scene = "grey.glsl"
        size = "8x4"
        times = [1.0, 2.5]
        flicker = true
        reference = { precision = "f32" }
        [[family]]
        name = "off"
        vary = { OFF = [0.125] }
        [[family]]
        name = "swings"
        vary = { SWING = [0.25] }"#;
    let (found, ..) = findings_of(gpu, study, folder.path(), &|_, _| None);
    let flicker: Vec<_> = found.cells.iter().map(|cell| cell.flicker).collect();
    let [Some(off), _, Some(swings), Some(later)] = flicker[..] else {
        panic!("{flicker:?}");
    };
    assert!(off < 1e-6, "{off}");
    assert_three_digits(swings, 0.25);
    assert_three_digits(later, 0.25);
}

#[test]
fn errors_are_those_of_the_formula() {
    let Some(gpu) = gpu() else { return };
    if !gpu.has_float64() {
        return eprintln!("skipped: no 64-bit floats");
    }
    let folder = folder();
    let (found, kept, steps) = findings(gpu, folder.path(), &|_, _| None);
    assert_eq!(kept, found.cells.len());
    assert!(steps.contains("reference") && steps.contains("misses"));
    let [exact, shifted, coarse, middle, fine, misses] = found.cells.as_slice() else {
        panic!("{:?}", found.cells);
    };
    let probe = |cell: &Cell| cell.total.probe.expect("a probe");
    assert!(probe(exact).max < 1e-6 && exact.total.picture.rmse == 0.0);
    assert_three_digits(shifted.total.picture.rmse, 0.125);
    assert_three_digits(shifted.total.picture.psnr, -20.0 * 0.125_f64.log10());
    assert_eq!(shifted.total.picture.above_8, 1.0);
    for (cell, step) in [(coarse, 0.4), (middle, 0.1), (fine, 0.025)] {
        let errors = expected(step);
        let method = cell
            .discretisation
            .expect("64 bits")
            .probe
            .expect("a probe");
        assert_three_digits(method.median, quantile(&errors, 0.5));
        assert_three_digits(method.p99, quantile(&errors, 0.99));
        assert_three_digits(
            method.mean,
            errors.iter().sum::<f64>() / errors.len() as f64,
        );
        // The two parts are within rounding of the whole.
        let rounding = cell.rounding.expect("64 bits").probe.expect("a probe");
        assert!((method.mean - probe(cell).mean).abs() <= rounding.mean);
        let rounds = expected_rounds(step);
        assert!(
            (cell.rounds - rounds).abs() < 0.05,
            "{} rounds, not {rounds}",
            cell.rounds
        );
    }
    assert_eq!(probe(misses).disagreements, 8 * 32);
    assert_eq!(
        exact.reference_error.expect("it is refined").main(),
        Some(0.0)
    );
    let rows = rows(&found);
    let cheapest = |goal| cheapest(&rows, goal).map(|row| row.family.as_str());
    assert_eq!(cheapest(1e-6), Some("exact"));
    assert_eq!(cheapest(-1.0), None);
    // What was found once is found again, and what is known is not looked for.
    let (again, kept, steps) = findings(gpu, folder.path(), &|variant, time| {
        let mut known = found.cells.iter();
        known
            .find(|cell| {
                cell.family == variant.family && cell.label == variant.label && cell.time == time
            })
            .cloned()
    });
    assert_eq!(kept, 0);
    assert!(!steps.contains("reference") && !steps.contains("misses"));
    let (fresh, ..) = findings(gpu, folder.path(), &|_, _| None);
    for (a, b) in again.cells.iter().zip(&fresh.cells) {
        assert_eq!(
            (a.total, a.discretisation, a.rounding, a.rounds),
            (b.total, b.discretisation, b.rounding, b.rounds)
        );
        assert_eq!(a.reference_error, b.reference_error);
    }
    assert_eq!(again.worst, fresh.worst);
}

/// The mean number of steps: the round that finds itself below the plane counts too.
fn expected_rounds(step: f64) -> f64 {
    let mut rounds = 0.0;
    for y in 0..32 {
        for x in 0..64 {
            let (u, v) = ((f64::from(x) + 0.5) / 64.0, (f64::from(y) + 0.5) / 32.0);
            rounds += ((u * u + v * v + 1.0).sqrt() / step).ceil() + 1.0;
        }
    }
    rounds / (64.0 * 32.0)
}

#[test]
fn families_are_measured_at_their_own_moments() {
    let Some(gpu) = gpu() else { return };
    if !gpu.has_float64() {
        return eprintln!("skipped: no 64-bit floats");
    }
    // What is off grows with the time: by 1/64 a second in the picture, by a tenth in `t`.
    let text = "
#define OFF 0.0
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float t = 1. + .1 * OFF * iTime;
    fragColor = vec4(vec3(.25 + OFF * iTime / 64.), 1.);
}";
    let study = r#"
title = "What grows"
scene = "grows.glsl"
size = "8x8"
times = [1, 2]
probe = "t"
repeats = 1
goals = [0.25, 10.0]
[reference]
[[family]]
name = "study's"
define = { OFF = 1.0 }
[[family]]
name = "late"
define = { OFF = 1.0 }
times = [16]
[[family]]
name = "as late"
times = [16]
[[family]]
name = "nowhere"
define = { OFF = -1.0 }
times = [16]
"#;
    let folder = Folder::new();
    folder.write("grows.glsl", text);
    folder.write("study.toml", study);
    let study = Study::parse(study).expect("a study");
    let mut told = 0;
    let around = Surroundings {
        gpu,
        library: Default::default(),
        folder: folder.path(),
        progress: &mut |_| told += 1,
        known: &|_, _| None,
        keep: &mut |_| {},
    };
    let found = run(&study, around).expect("good scenes");
    let expected = [
        ("study's", 1.0, Some(1.0)),
        ("study's", 2.0, Some(2.0)),
        ("late", 16.0, Some(16.0)),
        ("as late", 16.0, Some(0.0)),
        // Where nothing is hit there is no error, and none of 0 either.
        ("nowhere", 16.0, None),
    ];
    assert_eq!(found.cells.len(), expected.len());
    // Six frames of references, five of each cell; timing draws once more at first. A watchdog hears of all.
    assert!(told >= 6 + 5 * 5 + 4 + 5 + 3, "{told}");
    for (cell, (family, time, off)) in found.cells.iter().zip(expected) {
        assert_eq!((cell.family.as_str(), cell.time), (family, time));
        assert_three_digits(cell.total.picture.rmse, off.unwrap_or(16.0) / 64.0);
        assert_eq!(cell.error().is_some(), off.is_some());
        assert_three_digits(cell.error().unwrap_or(0.0), 0.1 * off.unwrap_or(0.0));
    }
    let worst: Vec<_> = found.worst.iter().map(|worst| worst.time).collect();
    assert_eq!(worst, [16.0, 16.0, 2.0]);
    let [first, second, third] = [0, 1, 2].map(|at| found.worst[at].difference.rgba[0][0]);
    assert_eq!([first, second, third], [0.25, 0.25, 1.0 / 32.0]);
    // Variants of other moments do not compete.
    let rows = rows(&found);
    assert!(rows[0].is_best && rows[2].is_best && !rows[3].is_best);
    assert_eq!(
        cheapest(&rows, 10.0).map(Row::name),
        Some("study's".to_owned())
    );
    let outcome = vitrine("measure")
        .arg(folder.path().join("study.toml"))
        .arg("-o")
        .arg(folder.path().join("report"))
        .run();
    assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
    let report = fs::read_to_string(folder.path().join("report/report.md")).expect("a report");
    let moments = "8×8 pixels at 1 s, 2 s (study's), at 16 s (late; as late; nowhere); error";
    assert!(report.contains(moments), "{report}");
}

#[test]
fn the_command_writes_a_report_and_goes_on_where_it_was() {
    let Some(gpu) = gpu() else { return };
    if !gpu.has_float64() {
        return eprintln!("skipped: no 64-bit floats");
    }
    let folder = folder();
    let out = folder.path().join("report");
    let measure = || {
        let study = folder.path().join("study.toml");
        let outcome = vitrine("measure").arg(study).arg("-o").arg(&out).run();
        assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
        outcome.stderr
    };
    assert!(measure().contains("6 cells in"));
    let report = fs::read_to_string(out.join("report.md")).expect("a report");
    assert!(
        report.contains("# A plane") && report.contains("steps STEP=0.025"),
        "{report}"
    );
    assert!(
        report.contains("The cheapest with an error of at most 0.020"),
        "{report}"
    );
    for file in [
        "report.csv",
        "report.json",
        "error-time.svg",
        "error-rounds.svg",
        "worst-1.png",
    ] {
        assert!(out.join(file).is_file(), "{file}");
    }
    // A run that was ended in the middle of a line.
    let kept = fs::read_to_string(out.join("cells.jsonl")).expect("cells");
    let third = kept.match_indices('\n').nth(2).expect("three lines").0;
    fs::write(out.join("cells.jsonl"), &kept[..third + 40]).expect("a file");
    let said = measure();
    assert!(said.contains("3 of them known from before"), "{said}");
    // Another reference is another study.
    let single = STUDY.replace("[reference]", "[reference]\nprecision = \"f32\"");
    folder.write("study.toml", &single);
    let said = measure();
    assert!(!said.contains("known from before"), "{said}");
}

#[test]
fn bad_studies_are_named() {
    let folder = folder();
    let said = |name: &str, text: &str| {
        folder.write(name, text);
        let outcome = vitrine("measure").arg(folder.path().join(name)).run();
        assert_eq!(outcome.code, Some(2), "{text}");
        outcome.stderr
    };
    assert!(said("a.toml", "title = 3").contains("a.toml"));
    assert!(said("a.toml", &STUDY.replace("[[family]]", "[[famly]]")).contains("famly"));
    assert!(said("a.glsl", PLANE).contains("is no study"));
}
