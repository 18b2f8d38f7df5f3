//! `vitrine measure` against arithmetic: surfaces whose distance is known in closed form, marched in steps,
//! here and in a shader. Every number of a probe's error is what the formula says, to three digits.

use vitrine::measure::compare::quantile;
use vitrine::measure::run::{Cell, Surroundings, run};
use vitrine::measure::study::Study;
use vitrine::render::Gpu;

use crate::support::{Folder, gpu};

const SIZE: (u32, u32) = (64, 48);

/// A sphere before the eye, met by formula or in even steps, of which the middle of the last is taken. Near
/// the edge the steps jump over it.
const SPHERE: &str = "
#define STEP 0.0
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = 2. * fragCoord / iResolution.xy - 1.;
    vec3 ro = vec3(0., 0., 3.), rd = normalize(vec3(uv * .6, -1.));
    float t = -1.;
    if (STEP == 0.) {
        float b = dot(ro, rd), disc = b * b - 8.;
        if (disc > 0.) t = -b - sqrt(disc);
    } else {
        for (int i = 1; i < 10000; i++) {
            float at = float(i) * STEP;
            if (at > 5.) break;
            if (length(ro + at * rd) < 1.) { t = at - .5 * STEP; break; }
        }
    }
    fragColor = vec4(t * .2);
}";

/// What the shader finds, computed here.
fn sphere(uv: [f64; 2], step: f64) -> Option<f64> {
    let [x, y] = uv.map(|u| 0.6 * (2.0 * u - 1.0));
    let length = (x * x + y * y + 1.0).sqrt();
    let rd = [x / length, y / length, -1.0 / length];
    if step == 0.0 {
        let b = 3.0 * rd[2];
        let disc = b * b - 8.0;
        return (disc > 0.0).then(|| -b - disc.sqrt());
    }
    let steps = (1..10000).map(|i| f64::from(i) * step);
    steps.take_while(|at| *at <= 5.0).find_map(|at| {
        let p = [at * rd[0], at * rd[1], 3.0 + at * rd[2]];
        let is_inside = p.iter().map(|c| c * c).sum::<f64>().sqrt() < 1.0;
        is_inside.then_some(at - 0.5 * step)
    })
}

/// Level rays into a hill of one sine, met by formula or in even steps with a straight line between the
/// last two.
const SINE: &str = "
#define STEP 0.0
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 rd = normalize(vec3(1., 0., uv.x - .5));
    float y = .45 * uv.y, t = -1.;
    if (STEP == 0.) {
        t = .5 * asin(y / .5) / rd.x;
    } else {
        float before = y;
        for (int i = 1; i < 10000; i++) {
            float at = float(i) * STEP;
            float above = y - .5 * sin(2. * at * rd.x);
            if (above < 0.) { t = at - STEP + STEP * before / (before - above); break; }
            before = above;
        }
    }
    fragColor = vec4(t);
}";

fn sine(uv: [f64; 2], step: f64) -> Option<f64> {
    let z = uv[0] - 0.5;
    let x = 1.0 / (1.0 + z * z).sqrt();
    let y = 0.45 * uv[1];
    if step == 0.0 {
        return Some(0.5 * (y / 0.5).asin() / x);
    }
    let mut before = y;
    (1..10000).map(|i| f64::from(i) * step).find_map(|at| {
        let above = y - 0.5 * (2.0 * at * x).sin();
        if above < 0.0 {
            return Some(at - step + step * before / (before - above));
        }
        before = above;
        None
    })
}

/// Errors relative to the formula, ascending, and how many pixels only one of the two hits.
fn expected(scene: fn([f64; 2], f64) -> Option<f64>, step: f64) -> (Vec<f64>, usize) {
    let (mut errors, mut disagreements) = (Vec::new(), 0);
    for y in 0..SIZE.1 {
        for x in 0..SIZE.0 {
            let at = |i: u32, count: u32| (f64::from(i) + 0.5) / f64::from(count);
            let uv = [at(x, SIZE.0), at(y, SIZE.1)];
            match (scene(uv, 0.0), scene(uv, step)) {
                (Some(exact), Some(stepped)) => errors.push((stepped - exact).abs() / exact),
                (None, None) => {}
                _ => disagreements += 1,
            }
        }
    }
    errors.sort_by(f64::total_cmp);
    (errors, disagreements)
}

fn cells(gpu: &Gpu, text: &str) -> Vec<Cell> {
    let folder = Folder::with("scene.glsl", text);
    let study = format!(
        "title = \"Steps\"\nscene = \"scene.glsl\"\nsize = \"{}x{}\"\nprobe = \"t\"\nrepeats = 1\n\
         [reference]\n[[family]]\nname = \"steps\"\nvary = {{ STEP = [0.3, 0.1, 0.02] }}\n",
        SIZE.0, SIZE.1
    );
    let around = Surroundings {
        gpu,
        library: Default::default(),
        folder: folder.path(),
        progress: &mut |_| {},
        known: &|_, _| None,
        keep: &mut |_| {},
    };
    let study = Study::parse(&study).expect("a study");
    run(&study, around).expect("good scenes").cells
}

#[track_caller]
fn assert_three_digits(what: &str, got: f64, want: f64) {
    let close = (got - want).abs() <= 1e-3 * want.abs();
    assert!(close, "{what}: {got} instead of {want}");
}

fn hold_against(text: &str, scene: fn([f64; 2], f64) -> Option<f64>) {
    let Some(gpu) = gpu() else { return };
    if !gpu.has_float64() {
        return eprintln!("skipped: no 64-bit floats");
    }
    let cells = cells(gpu, text);
    for (cell, step) in cells.iter().zip([0.3, 0.1, 0.02]) {
        let (errors, disagreements) = expected(scene, step);
        let parts = [cell.discretisation, cell.rounding].map(|part| {
            let part = part.expect("64 bits");
            part.probe.expect("a probe")
        });
        let [method, rounding] = parts;
        let name = |what: &str| format!("{what} of STEP={step}");
        assert_three_digits(&name("median"), method.median, quantile(&errors, 0.5));
        assert_three_digits(&name("p99"), method.p99, quantile(&errors, 0.99));
        assert_three_digits(&name("max"), method.max, quantile(&errors, 1.0));
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        assert_three_digits(&name("mean"), method.mean, mean);
        assert_eq!(method.disagreements, disagreements, "{step}");
        // Method and rounding together are the whole, but for pixels that rounding puts on another step.
        let total = cell.total.probe.expect("a probe");
        let apart = (total.mean - method.mean).abs();
        assert!(apart <= rounding.mean + 1e-9, "{step}: {apart} apart");
    }
}

#[test]
fn steps_to_a_sphere() {
    hold_against(SPHERE, sphere);
}

#[test]
fn steps_with_a_line_to_a_sine() {
    hold_against(SINE, sine);
}
