//! From text to a validated module, on one core: this project's front end against naga's own, on shaders
//! that both accept.
//!
//! ```text
//! cargo bench --bench translate
//! ```
//!
//! The shaders are the scenes without textures and the small ones of `tests/glsl/accept`. With
//! `SHADERS=FILE`, a list of files with an Image pass each, those are added.

use std::path::{Path, PathBuf};
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use naga::front::glsl::{Frontend, Options};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use vitrine::glsl::check::{self, check};
use vitrine::glsl::lower::{self, Interface, lower};
use vitrine::glsl::places::Places;
use vitrine::glsl::preprocess::{self, preprocess};
use vitrine::glsl::prune::Reachable;
use vitrine::glsl::{Precision, finite, syntax};
use vitrine::scene::{self, Source};
use vitrine::source::{FileId, SourceMap};

const PREAMBLE: &str = "\
precision highp float;
uniform vec3 iResolution;
uniform float iTime;
uniform vec4 iMouse;
uniform int iFrame;
out vec4 color;
void mainImage(out vec4 color, in vec2 coord);
void main() { vec4 c; mainImage(c, gl_FragCoord.xy); color = c; }
";

const NAGA_PREAMBLE: &str = "\
#version 450
layout(set = 0, binding = 0, std140) uniform Uniforms {
    vec3 iResolution; float iTime; vec4 iMouse; int iFrame;
};
layout(location = 0) out vec4 color;
";

const NAGA_MAIN: &str = "
void main() { vec4 c = vec4(0.0); mainImage(c, gl_FragCoord.xy); color = c; }
";

/// One shader for either front end.
struct Shader {
    files: SourceMap,
    units: Vec<FileId>,
    naga: String,
}

impl Shader {
    fn new(texts: &[String]) -> Self {
        let mut files = SourceMap::default();
        let mut units = vec![files.add("preamble", PREAMBLE)];
        units.extend(texts.iter().map(|text| files.add("text", text.as_str())));
        Shader {
            files,
            units,
            naga: format!("{NAGA_PREAMBLE}{}{NAGA_MAIN}", texts.join("\n")),
        }
    }

    fn with_vitrine(&self, interface: &Interface) -> Option<naga::Module> {
        let preprocessed = preprocess(&self.files, &self.units, &preprocess::Options::default());
        let mut parsed = syntax::parse(&preprocessed.tokens, false);
        let places = Places::new(&preprocessed.tokens);
        let mut checked = check(&mut parsed.ast, places, check::Options::default());
        let all = [
            preprocessed.diagnostics,
            parsed.diagnostics,
            checked.diagnostics,
        ];
        if all.iter().flatten().any(|found| found.is_error()) {
            return None;
        }
        finite::mark_finite_loops(&mut checked.hir);
        let reachable = Reachable::new(&checked.hir);
        let options = lower::Options {
            precision: Precision::Single,
            interface,
            double_functions: Default::default(),
        };
        let module = lower(&checked.hir, &reachable, &options).module;
        validate(&module).then_some(module)
    }

    fn with_naga(&self) -> Option<naga::Module> {
        let options = Options::from(naga::ShaderStage::Fragment);
        let module = Frontend::default().parse(&options, &self.naga).ok()?;
        validate(&module).then_some(module)
    }
}

fn validate(module: &naga::Module) -> bool {
    let capabilities = Capabilities::default() | Capabilities::SHADER_FLOAT16_IN_FLOAT32;
    let mut validator = Validator::new(ValidationFlags::all(), capabilities);
    validator.validate(module).is_ok()
}

fn interface() -> Interface {
    Interface {
        uniforms: ["iResolution", "iTime", "iMouse", "iFrame"]
            .map(str::to_owned)
            .into(),
        ..Interface::default()
    }
}

fn folder(path: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let mut paths: Vec<_> = std::fs::read_dir(root)
        .expect("the folder is there")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    paths
}

/// The texts of a scene's Image pass.
fn texts(path: PathBuf) -> Option<Vec<String>> {
    let scene = scene::load(&Source::Path(path)).ok()?;
    let sources = scene.image().sources.iter();
    Some(
        sources
            .map(|&file| scene.files.get(file).text.clone())
            .collect(),
    )
}

fn shaders() -> Vec<Shader> {
    let listed = std::env::var_os("SHADERS").map_or(Vec::new(), |list| {
        let list = std::fs::read_to_string(list).expect("the list can be read");
        list.lines().map(PathBuf::from).collect()
    });
    let interface = interface();
    let paths = folder("shadertoy")
        .into_iter()
        .chain(folder("tests/glsl/accept"))
        .chain(listed);
    paths
        .filter_map(|path| Some(Shader::new(&texts(path)?)))
        .filter(|shader| {
            // Some texts make naga's front end panic.
            let by_naga = std::panic::catch_unwind(|| shader.with_naga().is_some());
            by_naga.unwrap_or(false) && shader.with_vitrine(&interface).is_some()
        })
        .collect()
}

fn translate(criterion: &mut Criterion) {
    let shaders = shaders();
    let interface = interface();
    let bytes = shaders.iter().map(|shader| shader.naga.len() as u64).sum();
    println!("{} shaders, {bytes} bytes", shaders.len());
    let mut group = criterion.benchmark_group("translate");
    group.throughput(Throughput::Bytes(bytes)).sample_size(20);
    group.measurement_time(Duration::from_secs(10));
    group.bench_function("vitrine", |bencher| {
        bencher.iter(|| {
            let done = shaders
                .iter()
                .filter(|one| one.with_vitrine(&interface).is_some());
            done.count()
        });
    });
    group.bench_function("naga", |bencher| {
        bencher.iter(|| {
            shaders
                .iter()
                .filter(|one| one.with_naga().is_some())
                .count()
        });
    });
    group.finish();
}

criterion_group!(benches, translate);
criterion_main!(benches);
