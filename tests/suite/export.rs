//! The export pipeline: through the library, and what it says about where the time went.

use std::time::Duration;

use glam::UVec2;
use serde_json::Value;
use vitrine::export::{ExportError, Frames, Job, OutPattern, export};
use vitrine::frame::{Clock, Controls, Date};
use vitrine::render::Watchdog;

use crate::support::{Folder, draw, gpu, open, pasted, read_png, vitrine};

const WAVES: &str = "
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(0.5 + 0.5 * sin(p.xyx * vec3(0.3, 0.7, 0.5) + iTime * vec3(9.0, 5.0, 3.0)), 1.0);
}";

fn job(folder: &Folder, frames: Frames) -> Job {
    let out = folder.path().join("new").join("%03d.png");
    Job {
        frames,
        fps: 10.0,
        date: Date::exported(),
        controls: Controls::Untouched,
        size: UVec2::new(33, 17),
        out: OutPattern::parse(out.to_str().expect("a plain path")).expect("a pattern"),
        overwrite: false,
        timed: true,
    }
}

fn no_watch() -> Watchdog {
    Watchdog::start(None, |_| {}, |_| {})
}

#[test]
fn a_file_holds_exactly_the_frame_of_its_number() {
    let Some(gpu) = gpu() else { return };
    let session = open(gpu, &pasted(WAVES));
    let folder = Folder::new();
    let job = job(&folder, Frames::Range(3..20));
    let mut told = Vec::new();
    let summary = export(gpu, &session, &job, &no_watch(), &mut |written| {
        told.push(written);
        true
    });
    let summary = summary.expect("an export");

    assert_eq!((summary.frames, summary.interrupted), (17, false));
    assert_eq!(summary.gpu_seconds.is_some(), gpu.has_timestamps());
    assert!(told.is_sorted() && told.last() == Some(&17), "{told:?}");
    for frame in 3..20 {
        let file = read_png(&folder.path().join(format!("new/{frame:03}.png")));
        let alone = draw(gpu, &session, &Clock::fixed(10.0).at(frame, job.size));
        assert!(file == alone, "frame {frame}");
    }
    assert_eq!(folder.files().len(), 17);
}

#[test]
fn it_stops_when_told_and_the_files_have_no_gap() {
    let Some(gpu) = gpu() else { return };
    let session = open(gpu, &pasted(WAVES));
    let folder = Folder::new();
    let job = job(&folder, Frames::Range(0..500));
    let mut calls = 0;
    let summary = export(gpu, &session, &job, &no_watch(), &mut |_| {
        calls += 1;
        calls < 5
    });
    let summary = summary.expect("an export");
    assert!(summary.interrupted);
    assert!((1..100).contains(&summary.frames), "{}", summary.frames);
    let expected = (0..summary.frames).map(|frame| format!("new/{frame:03}.png"));
    assert_eq!(folder.files(), expected.collect::<Vec<_>>());
}

#[test]
fn what_is_in_the_way_is_left_alone() {
    let Some(gpu) = gpu() else { return };
    let session = open(gpu, &pasted(WAVES));
    let folder = Folder::with("new/002.png", "mine");
    let mut job = job(&folder, Frames::Range(0..4));
    let run = |job: &Job| export(gpu, &session, job, &no_watch(), &mut |_| true);
    match run(&job) {
        Err(ExportError::Exists { first, count: 1 }) => assert!(first.ends_with("002.png")),
        other => panic!("{other:?}"),
    }
    assert_eq!(folder.files(), ["new/002.png"]);
    assert_eq!(folder.read("new/002.png"), b"mine");
    job.overwrite = true;
    assert_eq!(run(&job).expect("an export").frames, 4);
    assert_ne!(folder.read("new/002.png"), b"mine");
}

#[test]
fn a_watchdog_is_not_alarmed_by_an_export() {
    let Some(gpu) = gpu() else { return };
    let session = open(gpu, &pasted(WAVES));
    let folder = Folder::new();
    let watchdog = Watchdog::start(
        Some(Duration::from_secs(60)),
        |_| panic!("no frame is slow"),
        |_| panic!("no frame is stuck"),
    );
    let job = job(&folder, Frames::At(0.5));
    export(gpu, &session, &job, &watchdog, &mut |_| true).expect("an export");
    assert_eq!(folder.files(), ["new/005.png"]);
}

#[test]
fn statistics_say_where_the_time_went() {
    let Some(gpu) = gpu() else { return };
    let folder = Folder::with("waves.glsl", WAVES);
    let command =
        "export waves.glsl --out %d.png --frames 0..9 --size 320x180 --stats deep/stats.json";
    folder.run(command).exits(0).says("9 frames in");
    let stats: Value = serde_json::from_slice(&folder.read("deep/stats.json")).expect("JSON");
    let seconds = |key: &str| {
        let value = stats[key].as_f64();
        let value = value.unwrap_or_else(|| panic!("no number `{key}` in {stats:#}"));
        assert!((0.0..1000.0).contains(&value), "{key} = {value}");
        value
    };
    assert_eq!(stats["scene"], "waves");
    assert_eq!(stats["frames"], 9);
    assert_eq!(
        (&stats["width"], &stats["height"]),
        (&320.into(), &180.into())
    );
    assert_eq!(stats["adapter"], gpu.describe());
    let startup = seconds("startup_seconds");
    let parts = [
        "driver_seconds",
        "load_seconds",
        "translate_seconds",
        "pipeline_seconds",
    ];
    assert!(
        parts.map(seconds).iter().sum::<f64>() <= startup,
        "{stats:#}"
    );
    let wall = seconds("wall_seconds");
    assert!(
        startup + seconds("first_frame_seconds") <= wall,
        "{stats:#}"
    );
    assert!(seconds("read_back_seconds") <= wall, "{stats:#}");
    assert!(seconds("encode_seconds") > 0.0, "{stats:#}");
    if gpu.has_timestamps() {
        let drawing = seconds("gpu_seconds");
        assert!(drawing > 0.0 && drawing <= wall, "{stats:#}");
    } else {
        assert_eq!(stats["gpu_seconds"], Value::Null);
    }
}

#[test]
fn statistics_tell_passes_apart_and_name_those_that_cost_nothing() {
    let Some(gpu) = gpu() else { return };
    let pass =
        "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) + 0.1; }";
    let folder = Folder::with("image.glsl", pass);
    folder.write("buffer_a.glsl", pass);
    folder.write("buffer_b.glsl", WAVES);
    folder.write(
        "sound.glsl",
        "vec2 mainSound(int n, float t) { return vec2(t); }",
    );
    folder
        .run("export . --out a.png --size 64x36 --stats s.json")
        .exits(0);
    let stats: Value = serde_json::from_slice(&folder.read("s.json")).expect("JSON");
    assert_eq!(stats["left_out"], serde_json::json!(["Sound", "Buffer B"]));
    let passes = stats["passes"].as_array().expect("a list");
    let names: Vec<_> = passes.iter().map(|pass| &pass["name"]).collect();
    assert_eq!(names, ["Buffer A", "Image"]);
    let seconds = passes.iter().map(|pass| pass["gpu_seconds"].as_f64());
    match gpu.has_timestamps() {
        true => {
            let seconds: Vec<f64> = seconds.map(|seconds| seconds.expect("a time")).collect();
            assert!(seconds.iter().all(|&seconds| seconds > 0.0), "{stats:#}");
            let all = stats["gpu_seconds"].as_f64().expect("a time");
            assert!(seconds.iter().sum::<f64>() <= all * 1.001, "{stats:#}");
        }
        false => assert!(seconds.flatten().next().is_none()),
    }
}

#[test]
fn a_scene_can_come_through_standard_input() {
    let Some(gpu) = gpu() else { return };
    let folder = Folder::new();
    vitrine("export - --out a.png --size 9x9")
        .input(WAVES)
        .within(folder.path())
        .run()
        .exits(0);
    let picture = read_png(&folder.path().join("a.png"));
    let input = Clock::fixed(60.0).at(0, UVec2::new(9, 9));
    assert!(picture == draw(gpu, &open(gpu, &pasted(WAVES)), &input));
}
