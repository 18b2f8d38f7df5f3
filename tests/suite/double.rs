//! Programs in double precision.

use std::io::ErrorKind;
use std::process::Command;

use glam::UVec2;
use vitrine::frame::Clock;
use vitrine::glsl::Precision;
use vitrine::render::Gpu;
use vitrine::scene::{self, Source};
use vitrine::session::{OpenError, Session};
use vitrine::translate::{Language, Options, translate, write};

use crate::support::{
    Folder, assert_claims, claims, distances, draw, gpu, open, pasted, plain, repository,
    scene_folders,
};

fn options() -> Options {
    Options {
        precision: Precision::Double,
        ..Options::default()
    }
}

/// Opens a scene in double precision, if the device has it.
pub fn open_double(gpu: &Gpu, source: &Source) -> Option<Session> {
    match Session::open(gpu, source, &options().into()) {
        Ok(session) => Some(session),
        Err(OpenError::Scene { report, .. }) => panic!("{}", plain(&report)),
        Err(OpenError::Gpu(error)) if !gpu.has_float64() => {
            let message = error.to_string();
            assert!(message.ends_with("cannot compute in double precision"));
            eprintln!("skipped: {message}");
            None
        }
        Err(error) => panic!("{error:?}"),
    }
}

#[test]
fn special_values_are_as_documented() {
    let Some(gpu) = gpu() else { return };
    // `z` is zero, which no compiler can know.
    let claims_of_z = [
        "sin(z) == 0. && cos(z) == 1. && tan(z) == 0.",
        "asin(z) == 0. && acos(1. + z) == 0. && atan(z) == 0.",
        "isnan(asin(z + 1.5)) && isnan(acos(z - 1.5))",
        "atan(z, z) == 0. && atan(z, 1.) == 0. && atan(z, -1.) == radians(180.)",
        "atan(1. / z) == radians(90.) && atan(1., z) == radians(90.)",
        "sinh(z) == 0. && cosh(z) == 1. && tanh(z) == 0. && tanh(z - 1000.) == -1.",
        "isinf(sinh(z + 1000.)) && isinf(cosh(z - 1000.))",
        "asinh(z) == 0. && acosh(1. + z) == 0. && isnan(acosh(z)) && atanh(z) == 0.",
        "isinf(atanh(z + 1.)) && isnan(atanh(z + 2.))",
        "exp(z) == 1. && exp(z - 1000.) == 0. && isinf(exp(z + 1000.))",
        "exp2(z + 10.) == 1024. && exp2(z - 3.) == .125 && isinf(exp2(z + 1024.))",
        "log(z + 1.) == 0. && isinf(log(z)) && log(z) < 0. && isnan(log(z - 1.))",
        "log2(z + 1024.) == 10. && log2(z + .125) == -3.",
        "pow(z + 2., 10.) == 1024. && abs(pow(9., z + .5) - 3.) < 1e-15",
        "pow(z, 2.) == 0. && pow(z, z) == 1. && isinf(pow(z, -1.)) && isnan(pow(z - 2., 2.))",
        "pow(z + 1., 1e300) == 1. && isinf(pow(z + 2., 1e300)) && pow(z + 2., -1e300) == 0.",
        "isnan(sin(1. / z)) && sin(z + 1e300) == 0.",
        "all(equal(exp2(vec3(0., 1., 2.) + z), vec3(1., 2., 4.)))",
    ];
    let claims_of_z = claims_of_z.map(|claim| format!("holds({claim})"));
    let all: Vec<&str> = claims_of_z.iter().map(String::as_str).collect();
    let text = format!(
        "float z;\n#define holds(claim) (z = p.y - .5, claim)\n{}",
        claims(&all)
    );
    let Some(session) = open_double(gpu, &pasted(&text)) else {
        return;
    };
    let size = UVec2::new(all.len() as u32, 1);
    let picture = draw(gpu, &session, &Clock::fixed(60.0).at(0, size));
    assert_claims(&all, &picture);
}

#[test]
fn the_template_looks_the_same() {
    let Some(gpu) = gpu() else { return };
    let source = Source::Path(repository("shadertoy/template"));
    let Some(double) = open_double(gpu, &source) else {
        return;
    };
    let input = Clock::fixed(60.0).at_time(1.0, UVec2::new(320, 180));
    let single = open(gpu, &source);
    let distances = distances(&draw(gpu, &double, &input), &draw(gpu, &single, &input));
    let sum: f64 = distances.iter().map(|&distance| f64::from(distance)).sum();
    let mean = sum / distances.len() as f64;
    println!("the mean difference is {mean:.3} of 255");
    assert!(mean < 1.0, "the mean difference is {mean}");
}

#[test]
fn every_scene_is_valid() {
    let folder = Folder::new();
    let mut is_there = true;
    for (name, scene) in scene_folders() {
        let scene = scene::load(&Source::Path(scene)).expect("a scene");
        let programs = translate(&scene, &options())
            .unwrap_or_else(|report| panic!("{name}: {}", plain(&report)));
        for program in programs {
            assert!(program.is_double());
            let binary = write(&program, Language::Spirv).expect("SPIR-V");
            let file = folder.write(&format!("{name}.spv"), binary);
            let verdict = Command::new("spirv-val")
                .args(["--target-env", "vulkan1.1"])
                .arg(file)
                .output();
            match verdict {
                Err(error) if error.kind() == ErrorKind::NotFound => is_there = false,
                other => {
                    let output = other.expect("spirv-val runs");
                    let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
                    assert!(output.status.success(), "{name}: {complaint}");
                }
            }
        }
    }
    if !is_there {
        eprintln!("not validated, there is no spirv-val (Debian's package spirv-tools)");
    }
}

#[test]
fn authors_and_their_macros_do_not_meet_the_functions() {
    let text = "#define x y\n#define floor nothing\nfloat s(float r) { return sin(r); }\n\
        void mainImage(out vec4 c, in vec2 p) { c = vec4(s(p.x)); }";
    let options = Options {
        overrides: vec![("r".to_owned(), "angle".to_owned())],
        ..options()
    };
    let scene = scene::load(&pasted(text)).expect("a scene");
    let programs =
        translate(&scene, &options).unwrap_or_else(|report| panic!("{}", plain(&report)));
    let warnings = programs[0].warnings.iter();
    assert!(warnings.map(|found| found.code).eq(["hiding-macro"]));
    assert_eq!(programs[0].functions.used, ["mainImage", "s"]);
    assert!(programs[0].functions.unused.is_empty());
    let text = "float __sin(float x) { return x; }\nvoid mainImage(out vec4 c, in vec2 p) {}";
    let scene = scene::load(&pasted(text)).expect("a scene");
    let report = translate(&scene, &options).expect_err("the name is reserved");
    assert_eq!(report.diagnostics[0].code, "reserved-name");
}
