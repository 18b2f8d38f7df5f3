//! The forms in which a scene can be written: customary files, keys of `scene.toml`.

use std::path::Path;

use vitrine::scene::{
    self, Channel, Filter, Input, LoadErrorKind, Media, PassKind, Scene, Source, Wrap,
};

use crate::support::Folder;

pub const GOOD: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n";

pub fn loaded(folder: &Folder, name: &str) -> Scene {
    match scene::load(&Source::Path(folder.path().join(name))) {
        Ok(scene) => scene,
        Err(error) => match error.kind {
            LoadErrorKind::Scene(report) => panic!("{:?}", report.diagnostics),
            LoadErrorKind::Io { path, error } => panic!("{}: {error}", path.display()),
        },
    }
}

pub fn kinds(scene: &Scene) -> Vec<&'static str> {
    scene.passes.iter().map(|pass| pass.kind.name()).collect()
}

pub fn channel(scene: &Scene, kind: PassKind, index: usize) -> Channel {
    let pass = scene.passes.iter().find(|pass| pass.kind == kind);
    let bound = pass.and_then(|pass| pass.channels[index].clone());
    bound.unwrap_or_else(|| panic!("{} reads nothing through {index}", kind.name()))
}

/// The names of an input's files.
pub fn files(input: &Input) -> Vec<String> {
    let Some(Media::Files(files)) = input.media() else {
        panic!("{input:?} lies in no files");
    };
    let name = |path: &Path| {
        path.file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned()
    };
    files.iter().map(|path| name(path)).collect()
}

const CUBE: &str =
    "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(d, 1); }\n";
const SOUND: &str = "vec2 mainSound(int s, float t) { return vec2(sin(t)); }\n";

#[test]
fn files_of_customary_names_are_passes() {
    let folder = Folder::with("a/image.glsl", GOOD);
    folder.write("a/cube_a.glsl", CUBE);
    folder.write("a/sound.glsl", SOUND);
    folder.write("a/buffer_b.glsl", GOOD);
    let scene = loaded(&folder, "a");
    assert_eq!(kinds(&scene), ["Sound", "Buffer B", "Cube A", "Image"]);
    folder.run("check a").exits(0).says("a: fine");
}

/// A manifest of an Image pass with these lines.
fn with_image(lines: &str) -> Folder {
    let folder = Folder::with("a/image.glsl", GOOD);
    folder.write(
        "a/scene.toml",
        format!("[image]\nsource = \"image.glsl\"\n{lines}"),
    );
    folder
}

#[test]
fn a_manifest_binds_every_kind_of_input() {
    let folder = with_image(
        "iChannel0 = { texture = \"rock.png\", vflip = false }\niChannel1 = { music = \"../song.mp3\" }\n\
         iChannel2 = { video = \"clip.mp4\", wrap = \"repeat\" }\niChannel3 = { mic = true }\n\
         [cube_a]\nsource = \"cube.glsl\"\niChannel0 = { cubemap = \"sky.png\" }\niChannel1 = { cubemap = \"cross.png\" }\n\
         iChannel2 = { cubemap = [\"1\", \"2\", \"3\", \"4\", \"5\", \"6\"] }\niChannel3 = { cube = true }\n\
         [sound]\nsource = \"sound.glsl\"\niChannel0 = { volume = \"x.bin\" }\niChannel1 = { webcam = true }\n\
         iChannel2 = { texture = \"london\" }\niChannel3 = { cubemap = \"XsfGzn\", filter = \"linear\" }\n",
    );
    let manifest = String::from_utf8(folder.read("a/scene.toml")).expect("text");
    folder.write("a/scene.toml", format!("size = [640, 360]\n{manifest}"));
    folder.write("a/cube.glsl", CUBE);
    folder.write("a/sound.glsl", SOUND);
    for name in [
        "a/rock.png",
        "song.mp3",
        "a/clip.mp4",
        "a/cross.png",
        "a/x.bin",
        "a/sky.png",
    ] {
        folder.write(name, "");
    }
    for face in 1..6 {
        folder.write(&format!("a/sky_{face}.png"), "");
    }
    for face in 1..7 {
        folder.write(&format!("a/{face}"), "");
    }
    let scene = loaded(&folder, "a");
    assert_eq!(kinds(&scene), ["Sound", "Cube A", "Image"]);
    assert_eq!(scene.size, Some([640, 360]));
    assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
    let image = |index| channel(&scene, PassKind::Image, index);
    assert_eq!(files(&image(0).input), ["rock.png"]);
    let sampling = image(0).sampling;
    assert_eq!(
        (sampling.filter, sampling.wrap, sampling.vflip),
        (Filter::Mipmap, Wrap::Repeat, false)
    );
    assert_eq!(files(&image(1).input), ["song.mp3"]);
    let sampling = image(2).sampling;
    assert_eq!(
        (sampling.filter, sampling.wrap, sampling.vflip),
        (Filter::Linear, Wrap::Repeat, true)
    );
    assert_eq!(image(3).input, Input::Mic);
    let cube = |index| channel(&scene, PassKind::Cube, index);
    assert_eq!(files(&cube(0).input).len(), 6);
    assert_eq!(files(&cube(0).input)[5], "sky_5.png");
    assert_eq!(files(&cube(1).input), ["cross.png"]);
    assert_eq!(files(&cube(2).input), ["1", "2", "3", "4", "5", "6"]);
    assert!(!cube(1).sampling.vflip && cube(1).sampling.wrap == Wrap::Clamp);
    assert_eq!(cube(3).input, Input::CubeBuffer);
    let sound = |index| channel(&scene, PassKind::Sound, index);
    assert!(matches!(sound(2).input, Input::Texture(Media::Site { id, .. }) if id == "4dfGRn"));
    assert!(
        matches!(sound(3).input, Input::Cubemap(Media::Site { path, .. }) if path.ends_with(".jpg"))
    );
    for name in ["rock.png", "sky_3.png", "song.mp3"] {
        assert!(
            scene.read.iter().any(|path| path.ends_with(name)),
            "{name} is watched"
        );
    }
}

#[test]
fn a_file_wins_over_a_name_of_the_site() {
    let folder = with_image("iChannel0 = { texture = \"London\" }\n");
    let of_site = channel(&loaded(&folder, "a"), PassKind::Image, 0);
    assert!(matches!(of_site.input, Input::Texture(Media::Site { .. })));
    folder.write("a/London", "");
    let own = channel(&loaded(&folder, "a"), PassKind::Image, 0);
    assert_eq!(files(&own.input), ["London"]);
}

#[track_caller]
fn manifest_refused(lines: &str, words: &[&str]) {
    let folder = with_image(lines);
    folder.write("a/sky.png", "");
    folder.write("a/sky_1.png", "");
    let outcome = folder.run("check a");
    outcome
        .exits(1)
        .says("error[manifest]")
        .says("a/scene.toml:");
    for words in words {
        outcome.says(words);
    }
}

#[test]
fn what_a_manifest_cannot_name() {
    manifest_refused(
        "iChannel0 = { texture = \"gone.png\" }\n",
        &[
            "there is no file `a/gone.png`",
            "3:25",
            "Abstract 1, Abstract 2",
        ],
    );
    manifest_refused(
        "iChannel0 = { texture = \"Forest\" }\n",
        &[
            "`Forest` is a cubemap, not a texture",
            "cubemap = \"Forest\"",
        ],
    );
    manifest_refused(
        "iChannel0 = { video = \"/etc/hostname\" }\n",
        &["lies outside the scene"],
    );
    manifest_refused(
        "iChannel0 = { cubemap = \"sky.png\" }\n",
        &["`a/sky_2.png`, a face of the cubemap"],
    );
    manifest_refused("iChannel0 = { cubemap = [\"a\"] }\n", &["the six faces"]);
    manifest_refused(
        "iChannel0 = { texture = 7 }\n",
        &["invalid type", "a file, the name of"],
    );
    manifest_refused(
        "iChannel0 = { texture = { id = \"a\" } }\n",
        &["missing field `path`"],
    );
    manifest_refused(
        "iChannel0 = { textur = \"a\" }\n",
        &["unknown field `textur`", "`cubemap`"],
    );
    manifest_refused(
        "iChannel0 = { mic = true, webcam = true }\n",
        &["bound to one thing", "`volume`"],
    );
    let folder = with_image("");
    folder.write(
        "a/scene.toml",
        "size = [0, 9]\n[image]\nsource = \"image.glsl\"\n",
    );
    folder
        .run("check a")
        .exits(1)
        .says("from 1 to 16384 pixels")
        .says("1:8");
}

#[test]
fn a_pass_that_is_not_there_reads_black_with_a_warning() {
    let folder = with_image("iChannel2 = { buffer = \"C\" }\niChannel3 = { cube = true }\n");
    let outcome = folder.run("check a");
    outcome
        .exits(0)
        .says(
            "warning[missing-pass]: Image: iChannel2 reads Buffer C, which the scene does not have",
        )
        .says("Image: iChannel3 reads Cube A")
        .says("a/scene.toml:3:13");
    let json = r#"{"renderpass":[{"type":"image","code":"void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }",
        "inputs":[{"id":"4dXGR8","type":"buffer","channel":1,"sampler":{"filter":"cubic","wrap":7,"vflip":true}},
                  {"id":"what","type":"texture","filepath":"/etc/passwd","channel":0}]}]}"#;
    let folder = Folder::with("a.json", json);
    let outcome = folder.run("check a.json");
    outcome
        .exits(0)
        .says("warning[missing-pass]: Image: iChannel1 reads Buffer A")
        .says("warning[unknown-sampler]: Image: iChannel1 has the unknown `filter` `\"cubic\"`")
        .says("Image: iChannel1 has the unknown `wrap` `7`, which is read as `repeat`")
        .says("warning[unknown-media]: Image: iChannel0 reads a texture with the `id` `what`")
        .says("a.json:2:");
}
