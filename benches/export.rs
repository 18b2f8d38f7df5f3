//! What exporting costs on top of drawing.
//!
//! Three questions, each answered in one run, interleaved, with medians:
//!
//! - a trivial gradient, 1280×720, 120 frames: an export against a bare loop that renders and throws
//!   away;
//! - the terrain template, 640×360, 60 frames: the export's wall time against the GPU's own time;
//! - four buffers of 1280×720 that each read themselves and another, 120 frames: the GPU's time for whole frames against
//!   that of their passes.
//!
//! Run it with `cargo bench --bench export`. It draws with the default adapter, or with the one that
//! `WGPU_ADAPTER_NAME` names.

use std::path::Path;
use std::time::{Duration, Instant};

use glam::UVec2;
use vitrine::export::{Frames, Job, OutPattern, Summary, export};
use vitrine::frame::{Clock, Controls, Date};
use vitrine::render::{AdapterChoice, Gpu, Watchdog};
use vitrine::scene::Source;
use vitrine::session::{Session, Setup};

const REPEATS: usize = 7;

const GRADIENT: &str = "void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, 0.5 + 0.5 * sin(iTime), 1.0);
}";

fn main() {
    // `cargo test --benches` passes a flag that asks for a quick look only.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let gpu = Gpu::headless(&AdapterChoice::Auto).expect("a graphics adapter");
    println!("{}", gpu.describe());
    gradient(&gpu);
    template(&gpu);
    feedback(&gpu);
}

fn gradient(gpu: &Gpu) {
    let source = Source::Text {
        name: "gradient".to_owned(),
        bytes: GRADIENT.into(),
    };
    let session = Session::open(gpu, &source, &Setup::default()).expect("a scene that runs");
    let (size, frames) = (UVec2::new(1280, 720), 120);
    bare_loop(gpu, &session, size, 10);
    let (mut bare, mut exported) = (Vec::new(), Vec::new());
    for _ in 0..REPEATS {
        bare.push(bare_loop(gpu, &session, size, frames).as_secs_f64());
        exported.push(
            exported_once(gpu, &session, size, frames, false)
                .0
                .as_secs_f64(),
        );
    }
    let (bare, exported) = (median(bare), median(exported));
    println!("gradient, 1280x720, {frames} frames, median of {REPEATS}");
    println!(
        "  bare loop  {:7.2} ms a frame",
        1e3 * bare / f64::from(frames)
    );
    println!(
        "  export     {:7.2} ms a frame",
        1e3 * exported / f64::from(frames)
    );
    println!("  ratio      {:7.2}", exported / bare);
}

fn template(gpu: &Gpu) {
    let source = Source::Embedded;
    let session = Session::open(gpu, &source, &Setup::default()).expect("the embedded scene runs");
    let (size, frames) = (UVec2::new(640, 360), 60);
    // The driver's late compilation belongs to the start-up.
    exported_once(gpu, &session, size, 1, true);
    let (mut walls, mut ratios) = (Vec::new(), Vec::new());
    for _ in 0..3 {
        let (wall, summary) = exported_once(gpu, &session, size, frames, true);
        walls.push(wall.as_secs_f64());
        if let Some(seconds) = summary.gpu_seconds {
            ratios.push(wall.as_secs_f64() / seconds);
        }
    }
    println!("template, 640x360, {frames} frames, median of 3");
    println!("  export     {:7.2} s", median(walls));
    match ratios.is_empty() {
        true => println!("  this adapter cannot time itself"),
        false => println!("  wall / GPU {:7.3}", median(ratios)),
    }
}

/// A pass that spreads what it held and what another buffer holds, as simulations do.
const SPREAD: &str = "void mainImage(out vec4 c, in vec2 p) {
    vec4 sum = vec4(0.0);
    for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++) {
        ivec2 at = clamp(ivec2(p) + ivec2(x, y), ivec2(0), ivec2(iResolution.xy) - 1);
        sum += texelFetch(iChannel0, at, 0) + 0.1 * texelFetch(iChannel1, at, 0);
    }
    c = fract(sum / 9.0 + 0.01 * vec4(p / iResolution.xy, iTime, 1.0));
}";

fn feedback(gpu: &Gpu) {
    let folder = tempfile::tempdir().expect("a folder for the scene");
    let write = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).expect("room for the scene");
    };
    let mut manifest = String::new();
    for (letter, other) in ["AD", "BA", "CB", "DC"].map(|pair| pair.split_at(1)) {
        let name = format!("buffer_{}", letter.to_lowercase());
        write(&format!("{name}.glsl"), SPREAD);
        manifest += &format!(
            "[{name}]\nsource = \"{name}.glsl\"\n\
             iChannel0 = {{ buffer = \"{letter}\" }}\niChannel1 = {{ buffer = \"{other}\" }}\n"
        );
    }
    let show = "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }";
    write("image.glsl", show);
    manifest += "[image]\nsource = \"image.glsl\"\niChannel0 = { buffer = \"D\" }\n";
    write("scene.toml", &manifest);
    let source = Source::Path(folder.path().to_owned());
    let session = Session::open(gpu, &source, &Setup::default()).expect("a scene that runs");
    let (size, frames) = (UVec2::new(1280, 720), 120);
    exported_once(gpu, &session, size, 10, true);
    let (mut passes, mut ratios) = (Vec::new(), Vec::new());
    for _ in 0..REPEATS {
        let (_, summary) = exported_once(gpu, &session, size, frames, true);
        let sum: f64 = summary.pass_seconds.iter().sum();
        if let Some(seconds) = summary.gpu_seconds {
            passes.push(sum);
            ratios.push(seconds / sum);
        }
    }
    println!("four feedback buffers, 1280x720, {frames} frames, median of {REPEATS}");
    match ratios.is_empty() {
        true => println!("  this adapter cannot time itself"),
        false => {
            let per_frame = 1e3 * median(passes) / f64::from(frames);
            println!("  passes     {per_frame:7.3} ms a frame");
            println!("  frame / passes {:7.3}", median(ratios));
        }
    }
}

/// Draws frames one after the other, waits for them and looks at none.
fn bare_loop(gpu: &Gpu, session: &Session, size: UVec2, frames: u32) -> Duration {
    let canvas = session.renderer.canvas(gpu, size);
    let mut canvas = canvas.expect("a size that the adapter draws");
    let clock = Clock::fixed(60.0);
    let start = Instant::now();
    for frame in 0..frames {
        let input = clock.at(frame, size);
        session.renderer.render(gpu, &input, &mut canvas, None);
        gpu.wait().expect("a frame that ends");
    }
    start.elapsed()
}

fn exported_once(
    gpu: &Gpu,
    session: &Session,
    size: UVec2,
    frames: u32,
    timed: bool,
) -> (Duration, Summary) {
    let folder = tempfile::tempdir().expect("room for the frames");
    let job = Job {
        frames: Frames::Range(0..frames),
        fps: 60.0,
        date: Date::exported(),
        controls: Controls::Untouched,
        size,
        out: pattern(folder.path()),
        overwrite: false,
        timed,
    };
    let watchdog = Watchdog::start(None, |_| {}, |_| {});
    let start = Instant::now();
    let summary = export(gpu, session, &job, &watchdog, &mut |_| true);
    (start.elapsed(), summary.expect("an export that succeeds"))
}

fn pattern(folder: &Path) -> OutPattern {
    let escaped = folder.display().to_string().replace('%', "%%");
    OutPattern::parse(&format!("{escaped}/%05d.png")).expect("a pattern")
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
