//! How long the way from text to a validated module takes, on one core, beside naga's own GLSL front
//! end with the same validator.
//!
//! Run it with `cargo bench --bench translate`. The texts are the project's own shaders, as far as
//! both accept them. With `CORPUS_LIST=FILE`, a list of scenes, one path a line, it measures those
//! once each instead, in turn, and prints how the two compare and where our time goes.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use criterion::{Criterion, Throughput};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use vitrine::glsl::check::{self, check};
use vitrine::glsl::lower::{self, lower};
use vitrine::glsl::names::Names;
use vitrine::glsl::places::Places;
use vitrine::glsl::preprocess::{self, preprocess};
use vitrine::glsl::prune::Reachable;
use vitrine::glsl::{Arithmetic, Precision, double, finite, syntax};
use vitrine::scene::{self, CHANNELS, Pass, PassKind, SamplerKind, Scene, Source};
use vitrine::source::{Diagnostic, FileId, SourceMap};
use vitrine::translate::bindings::{self, Uniform};

const MAIN: &str = "
out vec4 shadertoy_out_color;
void main() {
    mainImage(shadertoy_out_color, gl_FragCoord.xy);
}
";

/// A pass as each of the two takes it.
struct Text {
    files: SourceMap,
    units: Vec<FileId>,
    naga: String,
}

impl Text {
    fn new(scene: &Scene, pass: &Pass) -> Self {
        let own: Vec<&str> = pass
            .sources
            .iter()
            .map(|&file| &*scene.files.get(file).text)
            .collect();
        let naga = [&naga_header(pass), own.join("\n").as_str(), MAIN].concat();
        let mut files = scene.files.clone();
        let mut units = vec![files.add("header", header(pass))];
        units.extend(&pass.sources);
        units.push(files.add("main", MAIN));
        Text { files, units, naga }
    }
}

fn samplers(pass: &Pass) -> [&'static str; CHANNELS] {
    pass.channels.each_ref().map(|channel| {
        channel
            .as_ref()
            .map_or(SamplerKind::TwoD, |channel| channel.input.sampler())
            .glsl()
    })
}

fn header(pass: &Pass) -> String {
    let mut text =
        "precision highp float; precision highp int; precision mediump sampler3D;\n".to_owned();
    for uniform in Uniform::ALL {
        text += &format!("uniform {};\n", uniform.declaration());
    }
    for (channel, sampler) in samplers(pass).into_iter().enumerate() {
        text += &format!("uniform {sampler} {};\n", bindings::channel_name(channel));
    }
    text
}

/// naga wants uniforms in a block, and textures apart from samplers.
fn naga_header(pass: &Pass) -> String {
    let mut text = "#version 450 core\nlayout(set = 0, binding = 0) uniform Block {\n".to_owned();
    for uniform in Uniform::ALL {
        text += &format!("{};\n", uniform.declaration());
    }
    text += "};\n";
    for (channel, sampler) in samplers(pass).into_iter().enumerate() {
        let texture = sampler.replace("sampler", "texture");
        let name = bindings::channel_name(channel);
        let (at, with) = (bindings::texture(channel), bindings::sampler(channel));
        text += &format!(
            "layout(set = 0, binding = {at}) uniform {texture} texture_{channel};\n\
             layout(set = 0, binding = {with}) uniform sampler sampler_{channel};\n\
             #define {name} {sampler}(texture_{channel}, sampler_{channel})\n"
        );
    }
    text
}

/// What a program is translated for.
const WAYS: [(&str, Arithmetic); 2] = [
    ("ours, to be drawn", Arithmetic::Expanded),
    ("ours, to be read", Arithmetic::Compact),
];

/// How often a list is measured.
const ROUNDS: usize = 15;

/// The phases of our front end, and the time that each took.
const PHASES: [&str; 5] = ["preprocess", "parse", "check", "lower", "validate"];

/// Our way; false if the text is refused.
fn ours(text: &Text, arithmetic: Arithmetic, times: &mut [Duration; 5]) -> bool {
    let mut start = Instant::now();
    let mut lap = |phase: usize| {
        let now = Instant::now();
        times[phase] += now - std::mem::replace(&mut start, now);
    };
    let is_fine = |found: &[Diagnostic]| !found.iter().any(Diagnostic::is_error);
    let preprocessed = preprocess(
        &text.files,
        &text.units,
        &preprocess::Options {
            defines: &[("HW_PERFORMANCE", "1")],
            ..preprocess::Options::default()
        },
        Names::default(),
    );
    lap(0);
    let parsed = syntax::parse(&preprocessed.tokens, preprocessed.names, false);
    lap(1);
    if !is_fine(&preprocessed.diagnostics) || !is_fine(&parsed.diagnostics) {
        return false;
    }
    let mut ast = parsed.ast;
    let places = Places::new(&preprocessed.tokens);
    let mut checked = check(&mut ast, places, check::Options::default());
    lap(2);
    if !is_fine(&checked.diagnostics) || checked.hir.main.is_none() {
        return false;
    }
    finite::mark_finite_loops(&mut checked.hir);
    let double_functions = double::Functions::default();
    let reachable = Reachable::new(&checked.hir, &double_functions);
    let lowered = lower(
        &checked.hir,
        &reachable,
        &lower::Options {
            precision: Precision::Single,
            arithmetic,
            output: lower::Output::Colour,
            round_budget: None,
            round_limit: None,
            low_samplers: false,
            checks: lower::Checks::None,
            interface: &bindings::INTERFACE,
            unit_0: None,
            double_functions: &double_functions,
        },
    );
    lap(3);
    let valid = validate(&lowered.module);
    lap(4);
    valid
}

fn nagas(text: &Text, frontend: &mut naga::front::glsl::Frontend) -> bool {
    let options = naga::front::glsl::Options::from(naga::ShaderStage::Fragment);
    match frontend.parse(&options, &text.naga) {
        Ok(module) => validate(&module),
        Err(_) => false,
    }
}

fn validate(module: &naga::Module) -> bool {
    let capabilities = Capabilities::default() | Capabilities::SHADER_FLOAT16_IN_FLOAT32;
    let valid = Validator::new(ValidationFlags::all(), capabilities).validate(module);
    black_box(valid).is_ok()
}

/// The passes that both accept, among those that draw pictures.
fn texts(paths: &[PathBuf]) -> Vec<Text> {
    let scenes = paths.iter();
    let scenes = scenes.filter_map(|path| scene::load(&Source::Path(path.clone())).ok());
    let mut texts = Vec::new();
    for scene in scenes {
        let passes = scene.passes.iter();
        let drawing =
            passes.filter(|pass| matches!(pass.kind, PassKind::Image | PassKind::Buffer(_)));
        texts.extend(drawing.map(|pass| Text::new(&scene, pass)));
    }
    texts.retain(|text| {
        // naga's front end panics on some texts.
        let naga = std::panic::AssertUnwindSafe(|| nagas(text, &mut Default::default()));
        ours(text, Arithmetic::Compact, &mut Default::default())
            && std::panic::catch_unwind(naga).unwrap_or(false)
    });
    texts
}

fn corpus(list: &Path) {
    std::panic::set_hook(Box::new(|_| {}));
    let list = std::fs::read_to_string(list).expect("a list of scenes");
    let paths: Vec<PathBuf> = list.lines().map(PathBuf::from).collect();
    let texts = texts(&paths);
    let bytes: usize = texts.iter().map(|text| text.naga.len()).sum();
    println!(
        "{} passes of {} scenes, {bytes} bytes",
        texts.len(),
        paths.len()
    );
    for (name, arithmetic) in WAYS {
        let mut own = Duration::MAX;
        let mut phases = Default::default();
        let mut ratios = Vec::new();
        for _ in 0..ROUNDS {
            let mut times = [Duration::ZERO; 5];
            let start = Instant::now();
            for text in &texts {
                black_box(ours(text, arithmetic, &mut times));
            }
            let ours = start.elapsed();
            let start = Instant::now();
            for text in &texts {
                black_box(nagas(text, &mut Default::default()));
            }
            ratios.push(start.elapsed().as_secs_f64() / ours.as_secs_f64().max(f64::MIN_POSITIVE));
            if ours < own {
                (own, phases) = (ours, times);
            }
        }
        ratios.sort_by(f64::total_cmp);
        let ratio = ratios[ROUNDS / 2];
        println!("{name}: {own:.1?}, {ratio:.2} times as fast, median of {ROUNDS}");
        for (phase, time) in PHASES.iter().zip(phases) {
            println!("  {phase:10} {time:9.1?}");
        }
    }
}

fn own_shaders() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    for folder in ["shadertoy", "tests/seeds", "tests/glsl/accept"] {
        let entries = std::fs::read_dir(root.join(folder)).into_iter().flatten();
        paths.extend(entries.map(|entry| entry.expect("an entry").path()));
    }
    paths.sort();
    paths
}

fn main() {
    if let Some(list) = std::env::var_os("CORPUS_LIST") {
        return corpus(Path::new(&list));
    }
    let texts = texts(&own_shaders());
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("text to validated module");
    let bytes = texts.iter().map(|text| text.naga.len() as u64).sum();
    group.throughput(Throughput::Bytes(bytes));
    for (name, arithmetic) in WAYS {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let each = texts.iter();
                each.filter(|text| ours(text, arithmetic, &mut Default::default()))
                    .count()
            });
        });
    }
    group.bench_function("naga's", |bencher| {
        bencher.iter(|| {
            let each = texts.iter();
            each.filter(|text| nagas(text, &mut Default::default()))
                .count()
        });
    });
    group.finish();
    criterion.final_summary();
}
