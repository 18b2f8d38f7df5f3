//! The sanitizer: each file in `tests/sanitize` has one fault, which its first line names: code, number of
//! pixels, the first of them, operands. The line where it is found ends in `// here`. Adding a test is
//! adding a file there.

use std::fs;
use std::path::{Path, PathBuf};

use glam::UVec2;
use vitrine::frame::Clock;
use vitrine::render::Gpu;
use vitrine::scene::{self, Source};
use vitrine::session::{Findings, Subject};
use vitrine::source::Report;
use vitrine::translate::{Checks, Options, translate};

use crate::support::{golden_text, gpu, pasted, plain, repository};

/// Draws one frame and says what was found.
fn report(gpu: &Gpu, source: &Source, size: UVec2) -> Report {
    let options = Options {
        checks: Checks::All,
        ..Options::default()
    };
    let mut subject = Subject::open(gpu, source, &options.into(), size).expect("a good scene");
    let input = Clock::fixed(60.0).at_time(1.0, size);
    let drawn = subject.draw(gpu, &input, &mut |_| {}).expect("a picture");
    let mut findings = Findings::default();
    let session = &subject.session;
    findings.note(&session.programs, &drawn.findings, &input, "");
    findings
        .find_operands(gpu, session)
        .expect("the operands can be looked up");
    findings.report(session)
}

/// A finding as the first line of a file names it.
fn line(report: &Report) -> String {
    let lines = report.diagnostics.iter().map(|found| {
        let (_, tail) = found
            .message
            .split_once(" in ")
            .expect("a number of pixels");
        let (pixels, place) = tail.split_once(" at ").expect("a first pixel");
        let count = pixels.split(' ').next().expect("a number");
        format!("{} in {count} pixels from {place}", found.code)
    });
    let lines: Vec<_> = lines.collect();
    match lines.as_slice() {
        [] => "nothing".to_owned(),
        lines => lines.join("; "),
    }
}

#[test]
fn every_fault_is_found_once_where_it_is() {
    let Some(gpu) = gpu() else { return };
    let mut problems = String::new();
    for path in glsl_files(&repository("tests/sanitize")) {
        let name = path
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let text = fs::read_to_string(&path).expect("a text");
        let expected = text
            .lines()
            .next()
            .expect("a line")
            .trim_start_matches("// ");
        let report = report(gpu, &Source::Path(path), UVec2::splat(8));
        let found = line(&report);
        if found != expected {
            problems += &format!("{name}: expected {expected}\n  found {found}\n");
        }
        let marked = text.lines().position(|line| line.contains("// here"));
        for diagnostic in &report.diagnostics {
            let span = diagnostic.span.expect("a place");
            let place = report.files.get(span.file).location(span.start);
            if Some(place.line) != marked.map(|line| line + 1) {
                problems += &format!("{name}: found in line {}\n", place.line);
            }
        }
    }
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn findings_read_like_a_compiler() {
    let Some(gpu) = gpu() else { return };
    let text = "#define SHARE(x, n) ((x) / (n))
void mainImage(out vec4 c, in vec2 p) {
    vec3 v;
    c = vec4(SHARE(0.5, floor(p.x) - 4.0)) + v.x;
}
";
    let found = plain(&report(gpu, &pasted(text), UVec2::splat(8)));
    golden_text("tests/sanitize/report.txt", &found).unwrap_or_else(|problem| panic!("{problem}"));
}

#[test]
fn edges_of_a_picture_count_no_pixel_twice() {
    let Some(gpu) = gpu() else { return };
    let text = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0 / (p.x - p.x)); }";
    for (x, y) in [(1, 1), (3, 5), (7, 1), (65, 33)] {
        let found = line(&report(gpu, &pasted(text), UVec2::new(x, y)));
        let expected = format!(
            "division-by-zero in {} pixels from (0, 0): 1.0 / 0.0",
            x * y
        );
        assert_eq!(found, expected);
    }
}

/// What is valid without checks is valid with them, and both looks number the sites alike.
#[test]
fn everything_accepted_can_be_watched() {
    let mut folders = vec!["tests/glsl/accept".to_owned(), "tests/sanitize".to_owned()];
    let scenes = fs::read_dir(repository("shadertoy")).expect("the scenes");
    folders.extend(scenes.map(|entry| {
        let name = entry.expect("an entry").file_name();
        format!("shadertoy/{}", name.to_string_lossy())
    }));
    for folder in folders {
        let path = repository(&folder);
        let sources: Vec<_> =
            match path.join("image.glsl").exists() || path.join("scene.toml").exists() {
                true => vec![path],
                false => glsl_files(&path),
            };
        for path in sources {
            let name = path.display().to_string();
            let Ok(scene) = scene::load(&Source::Path(path)) else {
                continue;
            };
            let with = |checks: Checks| {
                let options = Options {
                    checks,
                    round_budget: Some(1000),
                    round_limit: Some(100),
                    ..Options::default()
                };
                translate(&scene, &options)
            };
            if with(Checks::None).is_err() {
                continue;
            }
            let programs =
                with(Checks::All).unwrap_or_else(|report| panic!("{name}: {}", plain(&report)));
            let sites = programs.last().expect("a pass").sites.clone();
            let wanted = (0..sites.len() as u32).map(|site| (site, [0, 0])).collect();
            let again = with(Checks::Operands(wanted));
            let again = again.unwrap_or_else(|report| panic!("{name}: {}", plain(&report)));
            assert!(again.last().expect("a pass").sites == sites, "{name}");
        }
    }
}

fn glsl_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "glsl"))
        .collect();
    paths.sort();
    paths
}
