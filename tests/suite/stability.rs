//! `vitrine stability`: faults that were planted are found, and a clean scene has none.

use vitrine::measure::stability::{Fault, Verdict, cases, examine};
use vitrine::render::Gpu;
use vitrine::session::Setup;

use crate::support::{gpu, pasted};

fn verdicts(gpu: &Gpu, text: &str, defines: &[(String, Vec<String>)]) -> Vec<Verdict> {
    let cases = cases(defines);
    examine(
        gpu,
        &pasted(text),
        &Setup::default(),
        &cases,
        &mut |_, _| {},
    )
    .expect("a good scene")
    .verdicts
}

#[track_caller]
fn faults<'v>(verdicts: &'v [Verdict], name: &str) -> &'v [Fault] {
    let found = verdicts.iter().find(|verdict| verdict.name == name);
    &found.unwrap_or_else(|| panic!("no case {name}")).faults
}

#[test]
fn a_clean_scene_has_no_fault() {
    let Some(gpu) = gpu() else { return };
    let text = "void mainImage(out vec4 c, in vec2 p) {
        vec2 uv = p / iResolution.xy;
        float sum = 0.;
        for (int i = 0; i < 8; i++) sum += uv.x * .1;
        c = vec4(uv, sum + .1 * fract(float(iFrame % 7) * .01), 1.);
    }";
    for verdict in verdicts(gpu, text, &[]) {
        assert_eq!(verdict.faults, [], "{}", verdict.name);
    }
}

#[test]
fn planted_faults_are_found() {
    let Some(gpu) = gpu() else { return };
    let text = "
#define CASE 0
void mainImage(out vec4 c, in vec2 p) {
    vec2 uv = p / iResolution.xy;
    c = vec4(uv, .5, 1.);
    float zero = iTime - iTime;
#if CASE == 1
    if (p.x > 3. && p.y > 2.) c.x = sqrt(zero - 1.);
#elif CASE == 2
    if (p.x > 90. && p.y > 50.) c.y = 1. / zero;
#elif CASE == 3
    c = vec4(.2, .3, .4, 1.);
#elif CASE == 4
    float t = zero;
    while (t < 1.) { if (p.x > 5.) t += .5; else t += .5 * t; }
    c.z = t * .5;
#endif
    if (iTime > 86400.) c = vec4(uv.x * step(86400.01, iTime));
}";
    let values = ["1", "2", "3", "4"].map(str::to_owned).to_vec();
    let found = verdicts(gpu, text, &[("CASE".to_owned(), values)]);
    assert_eq!(faults(&found, "iTime = 1"), []);
    let nan = Fault::Nan {
        pixels: 93 * 52,
        first: [3, 2],
    };
    assert!(
        faults(&found, "CASE = 1").contains(&nan),
        "{:?}",
        faults(&found, "CASE = 1")
    );
    let infinite = Fault::Infinite {
        pixels: 6 * 4,
        first: [90, 50],
    };
    assert_eq!(faults(&found, "CASE = 2"), [infinite]);
    assert_eq!(faults(&found, "CASE = 3"), [Fault::Flat]);
    let endless = Fault::Endless {
        pixels: 5 * 54,
        first: [0, 0],
        place: Some("pasted:15:5".to_owned()),
    };
    assert_eq!(faults(&found, "CASE = 4"), [endless]);
}

#[test]
fn a_jump_from_frame_to_frame_is_found() {
    let Some(gpu) = gpu() else { return };
    // The picture changes slowly, but for one leap just behind the second second.
    let text = "void mainImage(out vec4 c, in vec2 p) {
        vec2 uv = p / iResolution.xy;
        c = vec4(uv * .5 + iTime * .0001 + (iTime > 60.01 ? .4 : 0.), .5, 1.);
    }";
    let found = verdicts(gpu, text, &[]);
    assert!(matches!(faults(&found, "iTime = 60"), [Fault::Jump { .. }]));
    assert_eq!(faults(&found, "iTime = 1"), []);
}

#[test]
fn what_32_bits_cannot_hold_is_told() {
    let Some(gpu) = gpu() else { return };
    if !gpu.has_float64() {
        return eprintln!("skipped: no 64-bit floats");
    }
    let text = "void mainImage(out vec4 c, in vec2 p) {
        float x = p.x + iTime * 1000.;
        c = vec4(fract(x * .37), p.x / iResolution.x, .2, 1.);
    }";
    let found = verdicts(gpu, text, &[]);
    assert_eq!(faults(&found, "iTime = 1"), []);
    let late = faults(&found, "iTime = 1000000");
    assert!(
        late.iter()
            .any(|fault| matches!(fault, Fault::Rounding { .. })),
        "{late:?}"
    );
}
