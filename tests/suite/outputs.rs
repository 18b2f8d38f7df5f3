//! What is given for a pixel instead of its colour: values from within, and rounds of loops.

use glam::UVec2;
use vitrine::frame::{Clock, FloatImage};
use vitrine::glsl::Precision;
use vitrine::render::Gpu;
use vitrine::session::Subject;
use vitrine::translate::{Options, Output, Probe};

use crate::double::open_double;
use crate::support::{Folder, gpu, pasted, vitrine};

const SIZE: UVec2 = UVec2::new(4, 3);

fn drawn(gpu: &Gpu, text: &str, output: Output) -> FloatImage {
    let options = Options {
        output,
        ..Options::default()
    };
    let mut subject =
        Subject::open(gpu, &pasted(text), &options.into(), SIZE).expect("a good scene");
    let input = Clock::fixed(60.0).at(0, SIZE);
    subject
        .draw(gpu, &input, &mut |_| {})
        .expect("a device")
        .image
}

fn probe(name: &str) -> Output {
    Output::Probe(name.parse::<Probe>().expect(name))
}

/// The pixel in column `x` and row `y`, counted from the bottom left.
fn pixel(image: &FloatImage, x: u32, y: u32) -> [f32; 4] {
    image.rgba[((SIZE.y - 1 - y) * SIZE.x + x) as usize]
}

const VALUES: &str = "
float twice(float x) { if (x < 1.) return 7.; return 2. * x; }
vec3 passed(vec3 v) { vec3 inner = v + 1.; return inner; }
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float t = fragCoord.x;
    int n = -3;
    bool b = fragCoord.y > 1.;
    uvec2 u = uvec2(fragCoord);
    const float k = .25;
    vec3 nor = passed(vec3(fragCoord, 0.));
    for (int i = 0; i < 3; i++) { float last = float(i); t += last; }
    if (fragCoord.x < 1.) { float only = 5.; fragColor = vec4(twice(.5)); return; }
    float only = 6.;
    t = twice(t);
    fragColor = vec4(nor, 1.);
}";

#[test]
fn a_probe_gives_the_value_at_the_end_of_its_function() {
    let Some(gpu) = gpu() else { return };
    for (name, left, right) in [
        // The first column leaves early.
        ("t", [3.5, 0., 0., 1.], [2. * 5.5, 0., 0., 1.]),
        ("n", [-3., 0., 0., 1.], [-3., 0., 0., 1.]),
        ("b", [1., 0., 0., 1.], [1., 0., 0., 1.]),
        ("u", [0., 2., 0., 1.], [2., 2., 0., 1.]),
        ("nor", [1.5, 3.5, 1., 1.], [3.5, 3.5, 1., 1.]),
        ("last", [2., 0., 0., 1.], [2., 0., 0., 1.]),
        // Of two variables of one name it is the last in the text.
        ("only", [0., 0., 0., 1.], [6., 0., 0., 1.]),
        ("fragCoord", [0.5, 2.5, 0., 1.], [2.5, 2.5, 0., 1.]),
        ("fragColor", [7.; 4], [3.5, 3.5, 1., 1.]),
        ("passed.inner", [1.5, 3.5, 1., 1.], [3.5, 3.5, 1., 1.]),
        ("passed()", [1.5, 3.5, 1., 1.], [3.5, 3.5, 1., 1.]),
        ("twice()", [7., 0., 0., 1.], [2. * 5.5, 0., 0., 1.]),
    ] {
        let image = drawn(gpu, VALUES, probe(name));
        assert_eq!(pixel(&image, 0, 2), left, "{name}, left");
        assert_eq!(pixel(&image, 2, 2), right, "{name}, right");
    }
}

#[test]
fn a_probe_is_as_precise_as_the_program() {
    let Some(gpu) = gpu() else { return };
    let text = "void mainImage(out vec4 c, in vec2 p) {
        float third = 1. / (p.x + 2.5);
        float rest = (third - .33333334) * 1e9;
        c = vec4(rest);
    }";
    if open_double(gpu, &pasted(text)).is_none() {
        return;
    }
    let rest = |precision| {
        let options = Options {
            precision,
            output: probe("rest"),
            ..Options::default()
        };
        let mut subject =
            Subject::open(gpu, &pasted(text), &options.into(), SIZE).expect("a good scene");
        let input = Clock::fixed(60.0).at(0, SIZE);
        let image = subject
            .draw(gpu, &input, &mut |_| {})
            .expect("a device")
            .image;
        pixel(&image, 0, 0)[0]
    };
    let exact = (1.0_f64 / 3.0 - 0.33333334) * 1e9;
    assert!((f64::from(rest(Precision::Double)) - exact).abs() < 1e-6);
    assert!(f64::from(rest(Precision::Single)).abs() < 20.0);
    assert!((f64::from(rest(Precision::Single)) - exact).abs() > 1e-3);
}

#[test]
fn loops_are_counted() {
    let Some(gpu) = gpu() else { return };
    let text = "
float inner(int n) {
    float sum = 0.;
    for (int k = 0; k < 5; k++) { if (k == n) break; sum += 1.; }
    return sum;
}
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    int x = int(fragCoord.x);
    float sum = 0.;
    for (int i = 0; i < 4; i++) { if (i == 1) continue; sum += inner(x); }
    int n = 0;
    do { n++; } while (n < x);
    while (n < 7) n += 2;
    for (int i = 0; i < 3; i++) for (int j = 0; j < 2; j++) sum += 1.;
    fragColor = vec4(sum);
}";
    let first = drawn(gpu, text, Output::Rounds(0));
    let rest = drawn(gpu, text, Output::Rounds(4));
    let all = drawn(gpu, text, Output::AllRounds);
    for x in 0..4_u32 {
        let n = x.max(1);
        // A round that `break` ends has begun.
        let counts = [3 * (x + 1), 4, n, (7 - n).div_ceil(2), 3, 6];
        let got = [pixel(&first, x, 0), pixel(&rest, x, 0)].concat();
        assert_eq!(got[..6], counts.map(|n| n as f32), "column {x}");
        assert_eq!(pixel(&all, x, 0), [counts.iter().sum::<u32>() as f32; 4]);
    }
}

#[test]
fn what_no_probe_can_name() {
    let Some(gpu) = gpu() else { return };
    let text = "
struct S { float a; };
S make() { return S(1.); }
void mainImage(out vec4 c, in vec2 p) { mat2 m = mat2(1.); float a[2]; a[0] = m[0][0]; c = vec4(a[0] + make().a); }";
    for (name, words) in [
        ("x", "`mainImage` has no variable `x`"),
        ("make.x", "`make` has no variable `x`"),
        ("march()", "no function `march`"),
        ("make()", "`make()` is a `S`"),
        ("m", "`m` is a `mat2`"),
        ("a", "`a` is a `float[2]`"),
        ("mainImage()", "`mainImage()` is a `void`"),
    ] {
        let options = Options {
            output: probe(name),
            ..Options::default()
        };
        let scene = vitrine::scene::load(&pasted(text)).expect("a scene");
        let report = vitrine::translate::translate(&scene, &options).expect_err(name);
        let message = &report.diagnostics[0].message;
        assert!(message.contains(words), "{name}: {message}");
    }
    let _ = gpu;
}

#[test]
fn exr_files_hold_the_picture_and_the_probes() {
    use exr::prelude::{FlatSamples, ReadChannels as _, ReadLayers as _, read};
    let Some(_) = gpu() else { return };
    let folder = Folder::new();
    let scene = folder.write(
        "a.glsl",
        "void mainImage(out vec4 c, in vec2 p) {
            float t = p.x * 10.; vec2 flat2 = vec2(p.y, 0.);
            for (int i = 0; i < 3; i++) t += 1.;
            c = vec4(p, -2., 1.);
        }",
    );
    let file = folder.path().join("a.exr");
    let export = vitrine("export --size 4x3 --probe t,flat2 --count loops --out");
    let outcome = export.arg(&file).arg(scene).run();
    assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
    assert!(
        outcome
            .stderr
            .contains("a.glsl:3:13: 36 rounds, 3.0 a pixel, 3 at most")
    );
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels();
    let image = image.first_valid_layer().all_attributes().from_file(&file);
    let channels = image.expect("an EXR file").layer_data.channel_data.list;
    let mut found = Vec::new();
    for channel in channels {
        let FlatSamples::F32(values) = channel.sample_data else {
            panic!("{} has no floats", channel.name);
        };
        // The first is the pixel at the top left.
        found.push((channel.name.to_string(), values[0]));
    }
    let expected = [
        ("B", -2.0),
        ("G", 2.5),
        ("R", 0.5),
        ("flat2.X", 2.5),
        ("flat2.Y", 0.0),
        ("rounds", 3.0),
        ("t", 8.0),
    ];
    assert_eq!(
        found,
        expected.map(|(name, value)| (name.to_owned(), value))
    );
}
