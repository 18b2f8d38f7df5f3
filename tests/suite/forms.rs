//! The forms in which a scene can be written: customary files, keys of `scene.toml`, directives of a single file.

use std::path::Path;

use vitrine::scene::{
    self, Channel, Filter, Input, LoadErrorKind, Media, PassKind, Scene, Source, Wrap,
};

use crate::support::{Folder, vitrine};

const GOOD: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n";

fn loaded(folder: &Folder, name: &str) -> Scene {
    match scene::load(&Source::Path(folder.path().join(name))) {
        Ok(scene) => scene,
        Err(error) => match error.kind {
            LoadErrorKind::Scene(report) => panic!("{:?}", report.diagnostics),
            LoadErrorKind::Io { path, error } => panic!("{}: {error}", path.display()),
        },
    }
}

fn kinds(scene: &Scene) -> Vec<&'static str> {
    scene.passes.iter().map(|pass| pass.kind.name()).collect()
}

fn channel(scene: &Scene, kind: PassKind, index: usize) -> Channel {
    let pass = scene.passes.iter().find(|pass| pass.kind == kind);
    let bound = pass.and_then(|pass| pass.channels[index].clone());
    bound.unwrap_or_else(|| panic!("{} reads nothing through {index}", kind.name()))
}

/// The names of an input's files.
fn files(input: &Input) -> Vec<String> {
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

/// A shader of the extension's kind, with all that it may say.
fn shader() -> Folder {
    let folder = Folder::with(
        "s/main.glsl",
        "// #iChannel3 \"comment.png\"\n#iChannel0 \"file://feed.glsl\" // another pass\n#iChannel0::MinFilter \"Nearest\"\n\
         #iChannel0::MagFilter \"Nearest\"\n#iChannel1 'sky_{}.png'\n#iChannel1::Type \"CubeMap\"\n\
         #include \"lib/math.glsl\"\n#iKeyboard\n#iUniform float speed = 1 in { 0.0, 2.0 } step 0.5\n\
         #iUniform color3 tint = color3(1.0, .5, 0)\n#StrictCompatibility\n\
         void mainImage(out vec4 c, in vec2 p) {\n    c = texture(iChannel0, p) * twice(speed) + vec4(tint, 1.0);\n    \
         if (isKeyDown(Key_Shift)) c += texture(iChannel1, vec3(p, 1.0));\n}\n",
    );
    folder.write(
        "s/feed.glsl",
        "#iChannel0 \"self\"\n#iChannel0::WrapMode \"Repeat\"\n#include \"lib/more.glsl\"\nvoid main() { gl_FragColor = texture2D(iChannel0, gl_FragCoord.xy) + two() + iGlobalTime; }\n",
    );
    folder.write("s/lib/math.glsl", "#include \"more.glsl\"\n#include \"lib/nothing.glsl\"\nfloat twice(float x) { return two() * x; }");
    folder.write("s/lib/more.glsl", "float two() { return 2.0; }\n");
    folder.write("s/lib/nothing.glsl", "");
    for direction in ["px", "nx", "py", "ny", "pz", "nz"] {
        folder.write(&format!("s/sky_{direction}.png"), "");
    }
    folder
}

#[test]
fn directives_bind_include_and_declare() {
    let folder = shader();
    folder
        .run("check s/main.glsl")
        .exits(0)
        .says("s/main.glsl: fine");
    let scene = loaded(&folder, "s/main.glsl");
    assert_eq!(kinds(&scene), ["Buffer A", "Image"]);
    let image = |index| channel(&scene, PassKind::Image, index);
    assert_eq!(image(0).sampling.filter, Filter::Nearest);
    assert_eq!(files(&image(1).input)[..2], ["sky_px.png", "sky_nx.png"]);
    assert_eq!(image(3).input, Input::Keyboard, "the last free channel");
    let own = scene.passes[0].channels[0].clone().expect("itself");
    assert_eq!(own.input.name(), "Buffer A");
    assert_eq!(own.sampling.wrap, Wrap::Repeat);
    for name in ["lib/more.glsl", "feed.glsl", "sky_nz.png"] {
        assert!(
            scene.read.iter().any(|path| path.ends_with(name)),
            "{name} is watched"
        );
    }
    folder.run("check s/main.glsl -D speed=2.0").exits(0);
    let glsl = folder
        .run("translate s/main.glsl --to wgsl -D speed=7.25")
        .exits(0)
        .text();
    assert!(glsl.contains("7.25"), "the value of -D wins");
}

#[test]
fn what_is_wrong_is_shown_where_it_is_written() {
    let folder = shader();
    folder.write(
        "s/lib/math.glsl",
        "#include \"more.glsl\"\nfloat twice(float x) { return two() * y; }",
    );
    folder
        .run("check s/main.glsl")
        .exits(1)
        .says("s/lib/math.glsl:2:39")
        .says("`y` is not declared");
    let folder = Folder::with(
        "a.glsl",
        "#iUniform int n = 3\n\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(lost, n); }",
    );
    folder
        .run("check a.glsl")
        .exits(1)
        .says("a.glsl:3:50")
        .says("`lost` is not declared");
}

#[test]
fn lines_are_counted_as_in_the_file() {
    let text = "#iUniform float x = 0.0\n#include \"b.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) {\n    c = vec4(b + x); int line[__LINE__ == 4 ? 1 : -1]; }";
    let folder = Folder::with("a.glsl", text);
    folder.write(
        "b.glsl",
        "\n\nconst float b = 1.0;\nint lineB[__LINE__ == 4 ? 1 : -1];",
    );
    folder.run("check a.glsl").exits(0);
}

#[test]
fn shaders_that_read_one_another_are_drawn_behind_what_they_read() {
    let folder = Folder::with("a.glsl", format!("#iChannel0 \"b.glsl\"\n{GOOD}"));
    folder.write(
        "b.glsl",
        format!("#iChannel0 \"a.glsl\"\n#iChannel1 \"self\"\n{GOOD}"),
    );
    let scene = loaded(&folder, "a.glsl");
    assert_eq!(kinds(&scene), ["Buffer A", "Buffer B", "Image"]);
    let reads = |pass: usize, index: usize| {
        let bound = scene.passes[pass].channels[index].as_ref();
        bound.map(|channel| channel.input.name())
    };
    assert_eq!(
        [reads(0, 0), reads(0, 1)],
        [Some("Buffer B"), Some("Buffer A")]
    );
    assert_eq!(
        [reads(1, 0), reads(2, 0)],
        [Some("Buffer A"), Some("Buffer B")]
    );
    folder.run("check a.glsl").exits(0);
    for (name, next) in [("1", "2"), ("2", "3"), ("3", "4"), ("4", "5"), ("5", "1")] {
        folder.write(
            &format!("{name}.glsl"),
            format!("#iChannel0 \"{next}.glsl\"\n{GOOD}"),
        );
    }
    folder
        .run("check 1.glsl")
        .exits(1)
        .says("more than four buffers");
}

#[track_caller]
fn refused(lines: &str, place: &str, words: &[&str]) {
    let folder = Folder::with("s/a.glsl", format!("{lines}\n{GOOD}"));
    folder.write("s/b.glsl", "#include \"a.glsl\"\n");
    folder.write("s/x.png", "");
    folder.write("s/x.odd", "");
    let outcome = folder.run("check s/a.glsl");
    outcome
        .exits(1)
        .says("error[directive]")
        .says(&format!("s/a.glsl:{place}"));
    for words in words {
        outcome.says(words);
    }
}

#[test]
fn directives_that_are_wrong() {
    refused(
        "#iChannel0 \"https://a.b/c.png\"",
        "1:12",
        &["on the network", "save it beside"],
    );
    refused(
        "#iChannel0 \"gone.png\"",
        "1:12",
        &["there is no file `s/gone.png`"],
    );
    refused(
        "#iChannel0 \"/etc/hostname\"",
        "1:12",
        &["outside the shader's folder"],
    );
    refused("#iChannel0 \"x.odd\"", "1:12", &["of no kind", "mp3"]);
    refused("#iChannel0 x.png", "1:12", &["is missing here"]);
    refused(
        "#iChannel0 \"x.png\" \"x.png\"",
        "1:20",
        &["should end before this"],
    );
    refused("#iChannel4 \"x.png\"", "1:1", &["there is no `iChannel4`"]);
    refused(
        "#iChannel0::MinFilter \"Best\"",
        "1:23",
        &["cannot be `Best`", "\"NearestMipMapNearest\""],
    );
    refused(
        "#iChannel0::Filter \"x\"",
        "1:13",
        &["no setting `Filter`", "MagFilter"],
    );
    refused("#iChannel0::VFlip \"true\"", "1:19", &["nothing is bound"]);
    refused(
        "#iChannel0 \"c_{}.png\"",
        "1:12",
        &["six directions", "posx negx"],
    );
    refused("#include \"a.glsl\"", "1:10", &["includes itself"]);
    refused("#include \"x.glsl\" // y", "1:10", &["there is no file"]);
    refused(
        "#iUniform mat4 x = 1.0",
        "1:11",
        &["no type of `#iUniform`", "color3"],
    );
    refused("#iUniform float x", "1:18", &["a value is missing"]);
    refused(
        "#iUniform vec3 x = vec2(1, 2)",
        "1:16",
        &["has 3 components"],
    );
    refused("#iUniform int x = 1.5", "1:15", &["no whole number"]);
    refused(
        "#iUniform float x = 1.0 in { 0.0 }",
        "1:34",
        &["the largest value"],
    );
    refused(
        "#iUniform float x = vec2(",
        "1:26",
        &["a number is missing"],
    );
    refused("#iVertex \"x.glsl\"", "1:1", &["no vertex shaders"]);
    let all = "#iChannel0 \"x.png\"\n#iChannel1 \"x.png\"\n#iChannel2 \"x.png\"\n#iChannel3 \"x.png\"\n#iKeyboard";
    refused(all, "5:1", &["the keyboard needs a channel"]);
    let folder = Folder::with("s/a.glsl", format!("#include \"b.glsl\"\n{GOOD}"));
    folder.write("s/b.glsl", "#include \"a.glsl\"\n");
    folder
        .run("check s/a.glsl")
        .exits(1)
        .says("s/b.glsl:1:10")
        .says("includes itself");
}

#[test]
fn includes_have_limits() {
    let folder = Folder::with("0.glsl", format!("#include \"1.glsl\"\n{GOOD}"));
    for depth in 1..30 {
        folder.write(
            &format!("{depth}.glsl"),
            format!("#include \"{}.glsl\"\n", depth + 1),
        );
    }
    folder
        .run("check 0.glsl")
        .exits(1)
        .says("more than 16 deep");
    // Each includes the next one often: together more than there are atoms.
    for depth in 0..10 {
        let line = format!("#include \"{}.glsl\"\n", depth + 1);
        folder.write(&format!("{depth}.glsl"), line.repeat(40) + GOOD);
    }
    folder.write("10.glsl", "float x;");
    folder
        .run("check 0.glsl")
        .exits(1)
        .says("includes others too often");
}

#[test]
fn a_text_without_a_file_has_directives_but_no_files() {
    let text = format!(
        "#iUniform vec2 a = vec2(1)\n#iChannel0 \"self\"\n{}",
        GOOD.replace("1.0", "a, a")
    );
    vitrine("check -")
        .input(text)
        .run()
        .exits(0)
        .says("-: fine");
    for line in ["#include \"x.glsl\"", "#iChannel0 \"x.png\""] {
        let outcome = vitrine("check -").input(format!("{line}\n{GOOD}")).run();
        outcome
            .exits(1)
            .says("there is no folder to look for `x.")
            .says("<stdin>:1:");
    }
}

/// Whatever stands in a directive's line, it is obeyed or refused.
#[test]
fn broken_directives_never_panic() {
    let pieces = [
        "#iChannel0",
        "#iChannel",
        "#iUniform",
        "#include",
        "#iKeyboard",
        "::",
        "MinFilter",
        "Type",
        "\"self\"",
        "\"\"",
        "'",
        "\"",
        " float x",
        " = ",
        "1",
        "-",
        ".",
        "1e",
        " in ",
        "{",
        "}",
        "vec3(",
        ")",
        ",",
        " step ",
        "//",
        "/*",
        "*/",
        "\\",
        "\u{e4}",
        "\n",
        "\r",
        "\t",
        "#",
        "\"x_{}.png\"",
    ];
    let mut state = 0x5eed_u64;
    let mut below = |limit: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % limit as u64) as usize
    };
    for _ in 0..3_000 {
        let mut text = pieces[below(5)].to_owned();
        for _ in 0..below(14) {
            text += pieces[below(pieces.len())];
        }
        let source = Source::Text {
            name: "a".to_owned(),
            bytes: format!("{text}\n{GOOD}").into_bytes(),
        };
        match scene::load(&source) {
            Ok(scene) => drop(vitrine::translate::translate(&scene, &Default::default())),
            Err(error) => {
                let LoadErrorKind::Scene(report) = error.kind else {
                    panic!("{text}: nothing is read");
                };
                for problem in report.diagnostics {
                    let span = problem.span.expect("a place");
                    let file = &report.files.get(span.file).text;
                    assert!(
                        file.get(span.start as usize..span.end as usize).is_some(),
                        "{text}"
                    );
                }
            }
        }
    }
}
