use super::*;
use crate::scene::{
    BufferLetter, Channel, Filter, Input, LoadErrorKind, Media, Sampling, Scene, Source, Wrap, load,
};
use crate::source::Report;

fn loaded(text: &str) -> Result<Scene, Report> {
    let source = Source::Text {
        name: "a.json".to_owned(),
        bytes: text.as_bytes().to_vec(),
    };
    load(&source).map_err(|error| match error.kind {
        LoadErrorKind::Scene(report) => report,
        LoadErrorKind::Io { error, .. } => panic!("nothing is read: {error}"),
    })
}

fn scene(text: &str) -> Scene {
    loaded(text).unwrap_or_else(|report| panic!("{:?}", report.diagnostics))
}

/// What is wrong, as code, message and the text from the marked place on.
fn refused(text: &str) -> (&'static str, String, String) {
    let report = loaded(text)
        .err()
        .unwrap_or_else(|| panic!("accepted: {text}"));
    let [problem] = report.diagnostics.as_slice() else {
        panic!("several problems: {:?}", report.diagnostics);
    };
    let span = problem.span.expect("a place");
    let marked = &report.files.get(span.file).text[span.start as usize..];
    (problem.code, problem.message.clone(), marked.to_owned())
}

#[track_caller]
fn assert_refused(text: &str, code: &str, words: &str, marked: &str) {
    let (found, message, place) = refused(text);
    assert_eq!(found, code, "{message}");
    assert!(message.contains(words), "{message}");
    assert!(place.starts_with(marked), "{marked} is not at {place}");
}

fn names(scene: &Scene) -> Vec<&'static str> {
    scene.passes.iter().map(|pass| pass.kind.name()).collect()
}

/// A site export with every kind of pass.
const ALL: &str = r#"{
    "ver": "0.1",
    "info": { "id": "abc", "name": "All of it", "tags": [] },
    "renderpass": [
        { "type": "image", "name": "Image", "description": "", "code": "own",
          "inputs": [ { "id": "XsXGR8", "type": "buffer", "filepath": "/media/previz/buffer01.png",
                        "channel": 2, "published": 1,
                        "sampler": { "filter": "nearest", "wrap": "repeat", "vflip": "true",
                                     "srgb": "false", "internal": "byte" } } ],
          "outputs": [ { "id": "4dfGRr", "channel": 0 } ] },
        { "type": "common", "name": "Common", "code": "first", "inputs": [], "outputs": [] },
        { "type": "buffer", "name": "Buffer @", "code": "b", "inputs": [],
          "outputs": [ { "id": "XsXGR8", "channel": 0 } ] },
        { "type": "cubemap", "name": "Cube A", "code": "cube", "inputs": [],
          "outputs": [ { "id": "4dX3Rr", "channel": 0 } ] },
        { "type": "buffer", "name": "", "code": "a", "inputs": [],
          "outputs": [ { "id": "4dXGR8", "channel": 0 } ] },
        { "type": "sound", "name": "Sound", "code": "s", "inputs": [], "outputs": [] },
        { "type": "common", "name": "Common", "code": "second", "inputs": [], "outputs": [] }
    ]
}"#;

#[test]
fn every_pass_is_read() {
    let scene = scene(ALL);
    assert_eq!(scene.name, "All of it");
    // Buffers are drawn in the file's order, not the alphabet's.
    assert_eq!(
        names(&scene),
        ["Sound", "Buffer B", "Buffer A", "Cube A", "Image"]
    );
    assert_eq!(scene.image().kind, PassKind::Image);
    for pass in &scene.passes {
        let mut texts = pass.sources.iter().map(|&id| &*scene.files.get(id).text);
        assert_eq!(
            texts.clone().take(2).collect::<Vec<_>>(),
            ["first", "second"]
        );
        let own = match pass.kind {
            PassKind::Image => "own",
            PassKind::Buffer(BufferLetter::A) => "a",
            PassKind::Buffer(_) => "b",
            PassKind::Cube => "cube",
            PassKind::Sound => "s",
        };
        assert_eq!(texts.next_back(), Some(own));
        let name = &scene.files.get(*pass.sources.last().expect("a text")).name;
        assert_eq!(*name, format!("a.json: {}", pass.kind.name()));
    }
    let channel = Channel {
        input: Input::Buffer(BufferLetter::B),
        sampling: Sampling {
            filter: Filter::Nearest,
            wrap: Wrap::Repeat,
            vflip: true,
        },
    };
    assert_eq!(scene.image().channels, [None, None, Some(channel), None]);
    assert!(scene.warnings.is_empty());
}

/// An answer of the public interface.
const API: &str = r#"{"Shader": {"ver": "0.1", "info": {"id": "x", "name": ""}, "renderpass": [
    {"inputs": [
        {"id": 257, "src": "/media/previz/buffer00.png", "ctype": "buffer", "channel": 0,
         "sampler": {"filter": "linear", "wrap": "clamp", "vflip": "true", "srgb": "false"}},
        {"id": 17, "src": "/media/a/noise.png", "ctype": "texture", "channel": 1, "published": 1}],
     "outputs": [{"id": 37, "channel": 0}], "code": "i", "name": "Image", "type": "image"},
    {"inputs": [], "outputs": [{"id": 257, "channel": 0}], "code": "a", "name": "", "type": "buffer"}
]}}"#;

#[test]
fn the_public_interface_has_other_keys() {
    let scene = scene(API);
    assert_eq!(scene.name, "a.json", "an empty name is none");
    assert_eq!(names(&scene), ["Buffer A", "Image"]);
    let inputs = scene
        .image()
        .channels
        .clone()
        .map(|bound| bound.map(|c| c.input));
    let media = Media::Site {
        id: "17".to_owned(),
        path: "/media/a/noise.png".to_owned(),
    };
    let [first, second, ..] = inputs;
    assert_eq!(first, Some(Input::Buffer(BufferLetter::A)));
    assert_eq!(second, Some(Input::Texture(media)));
}

#[test]
fn the_last_input_decides_how_a_buffer_wraps() {
    let reads = |channel: u32, id: &str, wrap: &str| {
        format!(
            r#"{{"type":"buffer","id":"{id}","channel":{channel},"sampler":{{"wrap":"{wrap}"}}}}"#
        )
    };
    let (a, b) = ("4dXGR8", "XsXGR8");
    let scene = scene(&format!(
        r#"{{"renderpass":[{{"type":"buffer","name":"Buffer A","code":"a","inputs":[{},{}]}},
            {{"type":"buffer","name":"Buffer B","code":"b","inputs":[{}]}},
            {{"type":"image","code":"i","inputs":[{}]}}]}}"#,
        reads(0, a, "clamp"),
        reads(1, b, "repeat"),
        reads(0, b, "repeat"),
        reads(0, a, "repeat"),
    ));
    let channels = scene.passes.iter().flat_map(|pass| &pass.channels);
    let wraps: Vec<Wrap> = channels.flatten().map(|c| c.sampling.wrap).collect();
    assert_eq!(wraps, [Wrap::Repeat; 4]);
    let [warning] = &scene.warnings[..] else {
        panic!(
            "one channel is read otherwise than it says: {:?}",
            scene.warnings
        );
    };
    assert_eq!(warning.code, "shared-wrap");
    assert_eq!(
        warning.message,
        "Buffer A: iChannel0 reads Buffer A with the wrap `clamp`, but on the site a buffer has one wrap, and the \
         last input that reads it says `repeat`: it is read so"
    );
}

/// A shader of an Image pass with these inputs, on one line.
fn with_inputs(inputs: &str) -> String {
    format!(r#"{{"renderpass":[{{"type":"image","code":"i","inputs":[{inputs}]}}]}}"#)
}

#[test]
fn every_input_has_its_sampler_and_the_sites_defaults() {
    use crate::scene::SamplerKind::{Cube, ThreeD, TwoD};
    use Filter::{Linear, Mipmap, Nearest};
    use Wrap::{Clamp, Repeat};
    #[rustfmt::skip]
    let inputs = [
        ("texture", "Xsf3zn", "/media/a/f.png", "texture", TwoD, Mipmap, Repeat, true),
        ("buffer", "4sXGR8", "", "Buffer C", TwoD, Linear, Clamp, true),
        ("buffer", "?", "/media/previz/buffer03.png", "Buffer D", TwoD, Linear, Clamp, true),
        ("cubemap", "XsfGzn", "/media/a/5.jpg", "cubemap", Cube, Mipmap, Clamp, false),
        ("cubemap", "4dX3Rr", "", "Cube A", Cube, Mipmap, Clamp, false),
        ("cubemap", "?", "/media/previz/cubemap00.png", "Cube A", Cube, Mipmap, Clamp, false),
        ("volume", "4sfGRr", "/media/a/2.bin", "volume", ThreeD, Mipmap, Repeat, true),
        ("keyboard", "4dXGRr", "/presets/tex00.jpg", "keyboard", TwoD, Nearest, Clamp, true),
        ("music", "4sXGzn", "/media/a/a.mp3", "music", TwoD, Linear, Clamp, true),
        ("musicstream", "", "https://example.org/x", "musicstream", TwoD, Linear, Clamp, true),
        ("mic", "XdXGRr", "/presets/mic.png", "mic", TwoD, Linear, Clamp, true),
        ("video", "Xdf3Rn", "/media/a/e.webm", "video", TwoD, Linear, Clamp, true),
        ("webcam", "4sf3zn", "/presets/webcam.png", "webcam", TwoD, Linear, Clamp, true),
    ];
    for (kind, id, path, name, sampler, filter, wrap, vflip) in inputs {
        let input = format!(r#"{{"type":"{kind}","id":"{id}","filepath":"{path}","channel":3}}"#);
        let scene = scene(&with_inputs(&input));
        let [.., Some(channel)] = &scene.image().channels else {
            panic!("{kind} is not bound: {:?}", scene.warnings);
        };
        assert_eq!(channel.input.name(), name);
        assert_eq!(channel.input.sampler(), sampler, "{kind}");
        let expected = Sampling {
            filter,
            wrap,
            vflip,
        };
        assert_eq!(channel.sampling, expected, "{kind} {id}");
        if let Some(media) = channel.input.media() {
            let (id, path) = (id.to_owned(), path.to_owned());
            assert_eq!(*media, Media::Site { id, path });
        }
    }
}

#[test]
fn sampler_settings_mean_what_the_site_makes_of_them() {
    let sampling = |kind: &str, settings: &str| {
        let input = format!(r#"{{"type":"{kind}","channel":0,"sampler":{{{settings}}}}}"#);
        let scene = scene(&with_inputs(&input));
        let [Some(channel), ..] = &scene.image().channels else {
            panic!("{kind} is not bound");
        };
        let Sampling {
            filter,
            wrap,
            vflip,
        } = channel.sampling;
        (filter.name(), wrap.name(), vflip)
    };
    let given =
        r#""filter":"linear","wrap":"clamp","vflip":"false","srgb":"true","internal":"float""#;
    assert_eq!(sampling("texture", given), ("linear", "clamp", false));
    let odd = r#""filter":"cubic","wrap":"mirror","vflip":true"#;
    assert_eq!(sampling("video", odd), ("nearest", "repeat", true));
    let ignored = r#""filter":"linear","wrap":"repeat""#;
    assert_eq!(sampling("keyboard", ignored), ("nearest", "clamp", true));
}

#[test]
fn strange_inputs_are_left_out_with_a_warning() {
    for (input, words) in [
        (
            r#"{"type":"smell","channel":1}"#,
            "Image: iChannel1 has an input of the unknown `type` `smell`",
        ),
        (r#"{"channel":1}"#, "the unknown `type` ``"),
        (
            r#"{"type":"buffer","id":"zzz","channel":1}"#,
            "iChannel1 is a buffer, but its `id` `zzz` names none",
        ),
        (
            r#"{"type":"texture","channel":4}"#,
            "`channel` is `4`, but there are only 0 to 3",
        ),
        (r#"{"type":"texture","channel":-1}"#, "`channel` is `-1`"),
    ] {
        let text = with_inputs(input);
        let scene = scene(&text);
        let [warning] = scene.warnings.as_slice() else {
            panic!("{input}: {:?}", scene.warnings);
        };
        assert!(warning.message.contains(words), "{}", warning.message);
        assert!(!warning.is_error());
        let place = warning.span.expect("a place").start as usize;
        assert!(text[place..].starts_with(input), "{place}");
        assert_eq!(scene.image().channels, [None, None, None, None]);
    }
    let twice = r#"{"type":"mic","channel":0},{"type":"webcam","channel":"0"}"#;
    let scene = scene(&with_inputs(twice));
    let [Some(channel), ..] = &scene.image().channels else {
        panic!("nothing is bound");
    };
    assert_eq!(channel.input, Input::Webcam, "the later wins");
}

#[test]
fn buffers_without_an_id_go_by_name_and_by_order() {
    let buffers = |names: &[(&str, &str)]| {
        let mut text = r#"{"renderpass":[{"type":"image","code":""}"#.to_owned();
        for (name, outputs) in names {
            text +=
                &format!(r#",{{"type":"buffer","name":"{name}","outputs":{outputs},"code":""}}"#);
        }
        text + "]}"
    };
    let drawn = |list: &[(&str, &str)]| names(&scene(&buffers(list)));
    let by_name = [("Buffer C", "[]"), ("Buf A", "null"), ("", "[257]")];
    assert_eq!(
        drawn(&by_name),
        ["Buffer C", "Buffer A", "Buffer A", "Image"]
    );
    let by_order = [
        ("none", "[]"),
        ("", r#"[{"id":"4dXGR8"}]"#),
        ("Buffer", "{}"),
    ];
    assert_eq!(
        drawn(&by_order),
        ["Buffer B", "Buffer A", "Buffer C", "Image"]
    );
    let five = [("", "[]"); 5];
    assert_refused(
        &buffers(&five),
        "json",
        "more buffers than four",
        r#"{"type":"buffer""#,
    );
}

#[test]
fn a_shader_may_be_wrapped() {
    let bare = with_inputs("");
    for text in [
        format!("[{bare}]"),
        format!(r#"[{{"Shader":{bare}}}]"#),
        format!(r#"{{"userName":"me","date":"","numShaders":1,"shaders":[{bare}]}}"#),
        format!("\u{feff}\n\n [ {bare} ] \n"),
    ] {
        assert_eq!(names(&scene(&text)), ["Image"], "{text}");
    }
    let deep = format!("{}{bare}{}", "[".repeat(9), "]".repeat(9));
    assert_refused(&deep, "json", "too many lists", "[[[[");
}

#[test]
fn several_shaders_are_refused_by_name() {
    let named = |name| format!(r#"{{"info":{{"name":"{name}"}},"renderpass":[]}}"#);
    let text = format!(r#"[{},{{"Shader":{}}},7]"#, named("Sea"), named("Sky"));
    let words = "the file holds 3 shaders: `Sea`, `Sky`, one without a name";
    assert_refused(&text, "several-shaders", words, "[");
    let text = format!("[{}]", vec![named("Sea"); 1000].join(","));
    assert_refused(&text, "several-shaders", "`Sea` and 980 more", "[");
}

#[test]
fn what_is_no_shader_is_refused_with_a_place() {
    let error = r#"{"Error":"Shader not found"}"#;
    assert_refused(error, "site-error", "\"Shader not found\"", "{");
    assert_refused("[]", "json", "holds no shader", "[");
    assert_refused("{}", "json", "missing field `renderpass`", "{");
    assert_refused(
        r#"{"renderpass":[]}"#,
        "no-image-pass",
        "no Image pass",
        "{",
    );
    let pass = |fields: &str| format!("{{\n \"renderpass\": [\n  {{{fields}}}\n ]\n}}");
    let sound = pass(r#""type":"sound","code":"s""#);
    assert_refused(&sound, "no-image-pass", "no Image pass", "{\n");
    assert_refused(
        &pass(r#""type":"image""#),
        "json",
        "missing field `code`",
        "}\n ]",
    );
    assert_refused(
        &pass(r#""code":"""#),
        "json",
        "missing field `type`",
        "}\n ]",
    );
    let wrong = pass(r#""type":"image","code":7"#);
    assert_refused(&wrong, "json", "invalid type: integer `7`", "7}\n ]");
    let unknown = pass(r#""type":"smell","code":"""#);
    assert_refused(
        &unknown,
        "json",
        "unknown type `smell`",
        r#"{"type":"smell""#,
    );
    let input = with_inputs(r#"{"type":"mic"}"#);
    assert_refused(&input, "json", "missing field `channel`", "}]}]}");
    let cut = &ALL[..400];
    assert_eq!(refused(cut).0, "json");
    assert!(
        refused(cut).1.starts_with("the text ends"),
        "{}",
        refused(cut).1
    );
}

#[test]
fn glsl_is_not_taken_for_json() {
    for text in [
        "{",
        "[",
        "{ float x; }",
        "[1]",
        "void f() {}",
        "/* {\" */",
        "",
    ] {
        assert!(!is_json(text), "{text}");
    }
    for text in [
        "{\"",
        " \n{ \"ver\"",
        "{}",
        "[{",
        "[ ]",
        "[[{",
        "\u{feff}{\"a\"",
    ] {
        assert!(is_json(text), "{text}");
    }
}

/// Whatever is done to a file, what comes of it is a scene with an Image pass or a place in the text.
#[test]
fn broken_files_never_panic() {
    let scraps = [
        "{", "}", "[", "]", "\"", ",", ":", "\\", "null", "7", "-1e999", "\n", "\u{e4}",
    ];
    let mut state = 0x5eed_u64;
    let mut below = |limit: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % limit.max(1) as u64) as usize
    };
    for round in 0..4_000 {
        let mut text: Vec<char> = [ALL, API][round % 2].chars().collect();
        for _ in 0..1 + below(3) {
            let at = below(text.len() + 1);
            let end = (at + below(12)).min(text.len());
            match below(4) {
                0 => drop(text.drain(at..end)),
                1 => text.truncate(at),
                2 => {
                    let copy = text[at..end].to_vec();
                    text.splice(at..at, copy);
                }
                _ => drop(text.splice(at..at, scraps[below(scraps.len())].chars())),
            }
        }
        let text: String = text.into_iter().collect();
        match loaded(&text) {
            Ok(scene) => assert_eq!(scene.image().kind, PassKind::Image),
            Err(report) => {
                for problem in &report.diagnostics {
                    let span = problem.span.expect("a place");
                    let file = &report.files.get(span.file).text;
                    assert!(file.get(span.start as usize..span.end as usize).is_some());
                }
            }
        }
    }
    let deep = "[".repeat(200_000);
    assert_eq!(refused(&deep).0, "json");
    let deep = "{\"Shader\":".repeat(50_000) + "1" + &"}".repeat(50_000);
    assert_eq!(refused(&deep).0, "json");
}
