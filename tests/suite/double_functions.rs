//! The built-in functions of double precision against those of Rust, number by number.

use std::fmt::Write as _;

use glam::UVec2;
use vitrine::frame::{Clock, FrameImage};

use crate::double::open_double;
use crate::support::{draw, gpu, pasted};

/// How many numbers a function is given, for each range of them.
const SAMPLES: u32 = 2048;

/// In how many pixels a number comes back, at three bytes each.
const PIXELS: u32 = 5;

/// Numbers that shader and test make alike: nothing in it is rounded.
#[derive(Clone, Copy, Debug)]
enum Range {
    /// From one to another whole number.
    Linear(i32, i32),
    /// Between two powers of two.
    Powers(i32, i32),
    /// The same of either sign.
    Signed(i32, i32),
    /// Below one by as much.
    Below(i32, i32),
    /// Above one by as much.
    Above(i32, i32),
}

use Range::{Above, Below, Linear, Powers, Signed};

impl Range {
    fn glsl(self, seed: &str) -> String {
        match self {
            Linear(low, high) => format!("linear({low}, {high}, {seed})"),
            Powers(low, high) => format!("powers({low}, {high}, {seed})"),
            Signed(low, high) => format!("either({seed}) * powers({low}, {high}, {seed})"),
            Below(low, high) => format!("1. - powers({low}, {high}, {seed})"),
            Above(low, high) => format!("1. + powers({low}, {high}, {seed})"),
        }
    }

    fn number(self, seed: u32) -> f64 {
        match self {
            Linear(low, high) => f64::from(low) + (f64::from(high) - f64::from(low)) * unit(seed),
            Powers(low, high) => {
                let span = (high - low + 1) as u32;
                let exponent = low + (hash(seed ^ 0x5555_5555) % span) as i32;
                (1.0 + unit(seed)) * 2_f64.powi(exponent)
            }
            Signed(low, high) => either(seed) * Powers(low, high).number(seed),
            Below(low, high) => 1.0 - Powers(low, high).number(seed),
            Above(low, high) => 1.0 + Powers(low, high).number(seed),
        }
    }
}

fn hash(seed: u32) -> u32 {
    let mut i = seed;
    i = (i ^ (i >> 16)).wrapping_mul(0x7feb_352d);
    i = (i ^ (i >> 15)).wrapping_mul(0x846c_a68b);
    i ^ (i >> 16)
}

fn unit(seed: u32) -> f64 {
    f64::from(hash(seed)) * 2_f64.powi(-32)
}

fn either(seed: u32) -> f64 {
    if hash(seed ^ 0x3333_3333) & 1 == 0 {
        1.0
    } else {
        -1.0
    }
}

/// The same in GLSL.
const NUMBERS: &str = "
uint hash(uint i) {
    i = (i ^ (i >> 16)) * 0x7feb352du;
    i = (i ^ (i >> 15)) * 0x846ca68bu;
    return i ^ (i >> 16);
}
float unit(uint seed) {
    return float(hash(seed)) * 2.3283064365386963e-10;
}
float either(uint seed) {
    return (hash(seed ^ 0x33333333u) & 1u) == 0u ? 1. : -1.;
}
float linear(int low, int high, uint seed) {
    return float(low) + (float(high) - float(low)) * unit(seed);
}
float powers(int low, int high, uint seed) {
    int exponent = low + int(hash(seed ^ 0x55555555u) % uint(high - low + 1));
    float x = 1. + unit(seed);
    float power = exponent < 0 ? .5 : 2.;
    for (int i = 0; i < 10; i++) {
        if ((abs(exponent) >> i & 1) == 1) x *= power;
        power *= power;
    }
    return x;
}
";

/// What to hold against what. Where the result is near zero because the argument is rounded, only the
/// error itself counts, below `absolute`.
struct Case {
    call: &'static str,
    expected: fn(f64, f64) -> f64,
    x: Range,
    y: Range,
    absolute: f64,
}

fn case(call: &'static str, x: Range, expected: fn(f64, f64) -> f64) -> Case {
    Case {
        call,
        expected,
        x,
        y: Linear(0, 1),
        absolute: 0.0,
    }
}

/// Rust's own is not exact near one.
fn acosh(x: f64) -> f64 {
    let t = x - 1.0;
    match x < 1e9 {
        true => (t + (t * (t + 2.0)).sqrt()).ln_1p(),
        false => x.ln() + std::f64::consts::LN_2,
    }
}

/// Rust's own is not exact near minus one.
fn atanh(x: f64) -> f64 {
    let a = x.abs();
    (0.5 * (2.0 * a / (1.0 - a)).ln_1p()).copysign(x)
}

#[rustfmt::skip]
fn cases() -> Vec<Case> {
    let far = |case| Case { absolute: 2e-15, ..case };
    let by = |y, case| Case { y, ..case };
    vec![
        case("sin(x)", Linear(-10, 10), |x, _| x.sin()),
        case("sin(x)", Linear(-(1 << 20), 1 << 20), |x, _| x.sin()),
        case("sin(x)", Linear(-(1 << 30), 1 << 30), |x, _| x.sin()),
        far(case("sin(x)", Signed(31, 51), |x, _| x.sin())),
        case("sin(x)", Signed(-300, 0), |x, _| x.sin()),
        case("cos(x)", Linear(-10, 10), |x, _| x.cos()),
        case("cos(x)", Linear(-(1 << 20), 1 << 20), |x, _| x.cos()),
        case("cos(x)", Linear(-(1 << 30), 1 << 30), |x, _| x.cos()),
        far(case("cos(x)", Signed(31, 51), |x, _| x.cos())),
        case("tan(x)", Linear(-10, 10), |x, _| x.tan()),
        case("tan(x)", Linear(-(1 << 20), 1 << 20), |x, _| x.tan()),
        case("tan(x)", Linear(-(1 << 30), 1 << 30), |x, _| x.tan()),
        case("asin(x)", Linear(-1, 1), |x, _| x.asin()),
        case("asin(x)", Signed(-300, -1), |x, _| x.asin()),
        case("acos(x)", Linear(-1, 1), |x, _| x.acos()),
        case("acos(x)", Below(-53, -1), |x, _| x.acos()),
        case("atan(x)", Linear(-10, 10), |x, _| x.atan()),
        case("atan(x)", Signed(-300, 1023), |x, _| x.atan()),
        by(Linear(-1, 1), case("atan(x, y)", Linear(-1, 1), f64::atan2)),
        by(Signed(-400, 400), case("atan(x, y)", Signed(-400, 400), f64::atan2)),
        case("sinh(x)", Linear(-710, 710), |x, _| x.sinh()),
        case("sinh(x)", Signed(-300, 2), |x, _| x.sinh()),
        case("cosh(x)", Linear(-710, 710), |x, _| x.cosh()),
        case("cosh(x)", Linear(-3, 3), |x, _| x.cosh()),
        case("tanh(x)", Linear(-30, 30), |x, _| x.tanh()),
        case("tanh(x)", Signed(-300, 10), |x, _| x.tanh()),
        case("asinh(x)", Linear(-10, 10), |x, _| x.asinh()),
        case("asinh(x)", Signed(-300, 500), |x, _| x.asinh()),
        case("acosh(x)", Above(-52, 10), |x, _| acosh(x)),
        case("acosh(x)", Powers(0, 1023), |x, _| acosh(x)),
        case("atanh(x)", Linear(-1, 1), |x, _| atanh(x)),
        case("atanh(x)", Signed(-300, -1), |x, _| atanh(x)),
        case("atanh(x)", Below(-53, -1), |x, _| atanh(x)),
        case("exp(x)", Linear(-700, 709), |x, _| x.exp()),
        case("exp(x)", Signed(-60, 8), |x, _| x.exp()),
        case("exp2(x)", Linear(-1000, 1023), |x, _| x.exp2()),
        case("exp2(x)", Signed(-60, 8), |x, _| x.exp2()),
        case("log(x)", Powers(-1022, 1023), |x, _| x.ln()),
        case("log(x)", Below(-53, -2), |x, _| x.ln()),
        case("log(x)", Above(-52, -2), |x, _| x.ln()),
        case("log2(x)", Powers(-1022, 1023), |x, _| x.log2()),
        case("log2(x)", Below(-53, -2), |x, _| x.log2()),
        case("log2(x)", Above(-52, -2), |x, _| x.log2()),
        by(Linear(-8, 8), case("pow(x, y)", Linear(0, 4), f64::powf)),
        by(Linear(-300, 300), case("pow(x, y)", Linear(0, 10), f64::powf)),
        by(Signed(-8, 9), case("pow(x, y)", Powers(-1000, 1000), f64::powf)),
        by(Signed(0, 48), case("pow(x, y)", Below(-40, -8), f64::powf)),
        by(Signed(0, 48), case("pow(x, y)", Above(-40, -8), f64::powf)),
        // Products that compilers may see together with those inside.
        case("sin(3. * x)", Linear(-(1 << 20), 1 << 20), |x, _| (3.0 * x).sin()),
        case("tan(3. * x)", Linear(-(1 << 20), 1 << 20), |x, _| (3.0 * x).tan()),
        case("exp(3. * x)", Linear(-200, 200), |x, _| (3.0 * x).exp()),
    ]
}

/// A shader with a row for each of a function's cases and [`PIXELS`] columns for each number: its bytes
/// in three parts of 32 bits, which add up, and how often it was brought into their range by 2⁶⁴.
fn shader(cases: &[Case]) -> String {
    let mut numbers = String::new();
    for (row, case) in cases.iter().enumerate() {
        let [x, y] = [case.x.glsl("s"), case.y.glsl("s ^ 0x77777777u")];
        writeln!(numbers, "    if (row == {row}) {{ x = {x}; y = {y}; }}")
            .expect("strings take all text");
    }
    let call = cases[0].call;
    format!(
        "{NUMBERS}
void mainImage(out vec4 color, in vec2 p) {{
    int row = int(p.y), part = int(p.x) % {PIXELS};
    uint s = uint(int(p.x) / {PIXELS});
    float x = 0., y = 0.;
{numbers}
    float r = {call};
    int scale = 128;
    for (int i = 0; i < 20; i++) {{
        if (abs(r) >= 18446744073709551616.) {{ r *= 5.421010862427522e-20; scale++; }}
        if (abs(r) < 5.421010862427522e-20 && r != 0.) {{ r *= 18446744073709551616.; scale--; }}
    }}
    uint first = floatBitsToUint(r);
    float rest = r - uintBitsToFloat(first);
    uint second = floatBitsToUint(rest);
    uint third = floatBitsToUint(rest - uintBitsToFloat(second));
    uvec4 words = uvec4(first, second, third, uint(scale));
    vec3 bytes;
    for (int i = 0; i < 3; i++) {{
        int at = 3 * part + i;
        bytes[i] = float(words[at / 4] >> (8 * (at % 4)) & 255u);
    }}
    color = vec4(bytes / 255., 1.);
}}
"
    )
}

/// The number in a row of the shader's picture.
fn read_back(picture: &FrameImage, row: u32, sample: u32) -> f64 {
    let row = picture.size.y - 1 - row;
    let pixels = (0..PIXELS).flat_map(|part| picture.pixel(sample * PIXELS + part, row));
    let bytes: Vec<u8> = pixels.collect();
    let part = |i: usize| {
        let word = bytes[i..i + 4].try_into().expect("four bytes");
        f64::from(f32::from_le_bytes(word))
    };
    // In two steps: the factor may be out of range where the number is not.
    let scale = 2_f64.powi(32 * (i32::from(bytes[12]) - 128));
    (part(0) + part(4) + part(8)) * scale * scale
}

/// The largest relative error of a row, and where.
fn worst(case: &Case, picture: &FrameImage, row: u32) -> (f64, [f64; 2]) {
    let mut worst = (0.0, [0.0; 2]);
    for sample in 0..SAMPLES {
        let (x, y) = (case.x.number(sample), case.y.number(sample ^ 0x7777_7777));
        let expected = (case.expected)(x, y);
        // What is no normal number may be zero or infinite here.
        if !expected.is_normal() {
            continue;
        }
        let error = (read_back(picture, row, sample) - expected).abs();
        let relative = error / expected.abs();
        if error.is_nan() || (error > case.absolute && relative > worst.0) {
            worst = (relative, [x, y]);
        }
    }
    worst
}

#[test]
fn functions_are_those_of_rust() {
    let Some(gpu) = gpu() else { return };
    let mut problems = String::new();
    for cases in cases().chunk_by(|a, b| a.call == b.call) {
        let Some(session) = open_double(gpu, &pasted(&shader(cases))) else {
            return;
        };
        let size = UVec2::new(SAMPLES * PIXELS, cases.len() as u32);
        let picture = draw(gpu, &session, &Clock::fixed(60.0).at(0, size));
        for (row, case) in (0..).zip(cases) {
            let (error, at) = worst(case, &picture, row);
            let (call, x, y) = (case.call, case.x, case.y);
            let line = format!("{error:.1e} {call} of {x:?} and {y:?}, at {at:?}\n");
            print!("{line}");
            if error.is_nan() || error > 1e-14 {
                problems += &line;
            }
        }
    }
    assert!(problems.is_empty(), "\n{problems}");
}
