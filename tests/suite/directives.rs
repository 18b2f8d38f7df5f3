//! Directives of a single file for its host, as the extension "Shader Toy" of Visual Studio Code has them.

use vitrine::scene::{self, Filter, Input, LoadErrorKind, PassKind, Source, Wrap};

use crate::forms::{GOOD, channel, files, kinds, loaded};
use crate::support::{Folder, vitrine};

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
fn settings_without_a_texture_do_nothing() {
    let folder = Folder::with("a.glsl", format!("#iChannel2::VFlip \"true\"\n{GOOD}"));
    let outcome = folder.run("check a.glsl");
    outcome
        .exits(0)
        .says("warning[unbound-channel]")
        .says("nothing is bound to iChannel2")
        .says("1:19");
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
