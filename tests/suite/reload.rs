//! Saving a scene again: a good one takes over, a bad one changes nothing and says why.

use glam::UVec2;
use vitrine::frame::{Clock, FrameImage};
use vitrine::render::Gpu;
use vitrine::scene::Source;
use vitrine::session::{OpenError, Session};

use crate::support::{Folder, draw, gpu, open, plain};

const RED: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0, 0.0, 0.0, 1.0); }";
const BROKEN: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0, 0.0, 0.0, 1.0) }";
const BLUE: &str =
    "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.0, 0.0, fract(iTime), 1.0); }";

fn picture(gpu: &Gpu, session: &Session) -> FrameImage {
    draw(gpu, session, &Clock::fixed(2.0).at(1, UVec2::new(4, 4)))
}

/// The scene's problems as text, and the files that the attempt read.
fn problems(result: Result<(), OpenError>) -> (String, Vec<std::path::PathBuf>) {
    match result {
        Err(OpenError::Scene { report, read }) => (plain(&report), read),
        other => panic!("{other:?} instead of a report"),
    }
}

#[test]
fn good_then_bad_then_good() {
    let Some(gpu) = gpu() else { return };
    let folder = Folder::with("a.glsl", RED);
    let source = Source::Path(folder.path().join("a.glsl"));
    let mut session = open(gpu, &source);
    let red = picture(gpu, &session);
    assert_eq!(red.pixel(0, 0), [255, 0, 0]);

    let path = folder.write("a.glsl", BROKEN);
    let (report, read) = problems(session.reload(gpu, &source));
    assert!(report.contains("a.glsl:1:"), "{report}");
    assert_eq!(read, [path], "a change to this file may mend it");
    assert_eq!(picture(gpu, &session), red, "the old picture keeps moving");

    folder.write("a.glsl", BLUE);
    session.reload(gpu, &source).expect("it is mended");
    // Half a level is rounded either way.
    assert!(matches!(
        picture(gpu, &session).pixel(0, 0),
        [0, 0, 127 | 128]
    ));
    assert!(session.timing.translate.as_nanos() > 0);
}

#[test]
fn a_file_that_is_gone_or_empty_changes_nothing() {
    let Some(gpu) = gpu() else { return };
    let folder = Folder::with("a.glsl", RED);
    let path = folder.path().join("a.glsl");
    let source = Source::Path(path.clone());
    let mut session = open(gpu, &source);
    let red = picture(gpu, &session);

    // As an editor leaves it for a moment while it saves.
    folder.write("a.glsl", "");
    let (report, _) = problems(session.reload(gpu, &source));
    assert!(report.contains("the file is empty"), "{report}");
    std::fs::remove_file(&path).expect("it can be removed");
    match session.reload(gpu, &source) {
        Err(OpenError::Io { path: missing, .. }) => assert_eq!(missing, path),
        other => panic!("{other:?}"),
    }
    assert_eq!(picture(gpu, &session), red);
}

#[test]
fn a_broken_common_file_is_the_one_that_is_named() {
    let Some(gpu) = gpu() else { return };
    let folder = Folder::with(
        "common.glsl",
        "vec3 tint() { return vec3(0.0, 1.0, 0.0); }\n",
    );
    folder.write(
        "image.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(tint(), 1.0); }\n",
    );
    let source = Source::Path(folder.path().to_owned());
    let mut session = open(gpu, &source);
    assert_eq!(picture(gpu, &session).pixel(0, 0), [0, 255, 0]);
    let read: Vec<_> = session
        .scene
        .read
        .iter()
        .filter_map(|path| path.file_name())
        .collect();
    assert!(
        read.contains(&"common.glsl".as_ref()) && read.contains(&"image.glsl".as_ref()),
        "{read:?}"
    );

    let common = folder.write("common.glsl", "\nvec3 tint() { return unknown; }\n");
    let (report, read) = problems(session.reload(gpu, &source));
    assert!(report.contains("common.glsl:2:"), "{report}");
    assert!(!report.contains("image.glsl"), "{report}");
    assert!(read.contains(&common), "{read:?}");

    folder.write(
        "common.glsl",
        "vec3 tint() { return vec3(0.0, 0.0, 1.0); }\n",
    );
    session.reload(gpu, &source).expect("it is mended");
    assert_eq!(picture(gpu, &session).pixel(0, 0), [0, 0, 255]);
}

#[test]
fn a_folder_can_gain_and_change_its_manifest() {
    let Some(gpu) = gpu() else { return };
    let folder = Folder::with("image.glsl", RED);
    folder.write("other.glsl", BLUE);
    let source = Source::Path(folder.path().to_owned());
    let mut session = open(gpu, &source);
    let manifest = folder.path().join("scene.toml");
    assert!(
        session.scene.read.contains(&manifest),
        "its appearance is a change to the scene"
    );

    folder.write("scene.toml", "[image]\nsource = \"other.glsl\"\n");
    session.reload(gpu, &source).expect("a scene");
    assert!(matches!(
        picture(gpu, &session).pixel(0, 0),
        [0, 0, 127 | 128]
    ));

    folder.write("scene.toml", "[image]\nsource = \"third.glsl\"\n");
    let (report, read) = problems(session.reload(gpu, &source));
    assert!(report.contains("there is no file"), "{report}");
    assert!(
        read.contains(&folder.path().join("third.glsl")),
        "its appearance may mend it"
    );
}
