//! From the site's JSON to a scene folder and back: nothing is lost.

use serde_json::{Value, json};
use vitrine::scene::{self, Scene, Source};

use crate::support::{Folder, vitrine};

const CODE: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }";

/// Imports a JSON text into a folder and packs that again.
#[track_caller]
fn round_trip(text: &str) -> (Folder, String) {
    let folder = Folder::with("x.json", text);
    folder.run("import x.json --into scene").exits(0);
    let packed = folder.run("pack scene").exits(0).text();
    (folder, packed)
}

#[track_caller]
fn same_values(text: &str) -> Folder {
    let (folder, packed) = round_trip(text);
    let value = |text: &str| serde_json::from_str::<Value>(text).expect("JSON");
    assert_eq!(value(&packed), value(text));
    folder
}

fn loaded(source: &Source) -> Scene {
    scene::load(source).unwrap_or_else(|error| panic!("{error:?}"))
}

/// What is drawn: the passes with their texts and channels.
fn drawn(scene: &Scene) -> Vec<(String, Vec<String>, String)> {
    let passes = scene.passes.iter();
    passes
        .map(|pass| {
            let texts = pass.sources.iter();
            let texts = texts.map(|&file| scene.files.get(file).text.clone());
            let channels = pass.channels.iter().map(|channel| {
                let bound = channel.as_ref();
                bound.map(|channel| (channel.input.name(), channel.sampling))
            });
            (
                pass.kind.name().to_owned(),
                texts.collect(),
                format!("{:?}", channels.collect::<Vec<_>>()),
            )
        })
        .collect()
}

/// A shader with all that is odd in real ones.
fn odd() -> Value {
    let sampler = json!({ "filter": "nearest", "wrap": "repeat", "vflip": "false", "srgb": "true", "internal": "float" });
    json!({
        "ver": "0.1", "flags": { "mFlagVR": "false" },
        "info": {
            "id": "4tcXyz", "date": "1601554121", "viewed": 677, "name": "Nebel \"\u{e4}\" \\ '''", "username": "me",
            "description": "\n[b]two[/b]\r\n'''lines\u{7}\"\"\"", "likes": 22, "published": 3, "flags": 48, "usePreview": 0,
            "tags": ["a", "b"], "hasliked": 0, "parentid": "", "parentname": "", "rating": 1.50,
        },
        "renderpass": [
            { "type": "common", "name": "", "code": "float a;\r\n", "inputs": [], "outputs": [], "description": "" },
            { "type": "buffer", "name": "Buffer @", "code": format!("\u{feff}{CODE}"), "outputs": [{ "id": "XsXGR8", "channel": 0 }],
              "inputs": [
                { "id": "XsXGR8", "filepath": "/media/previz/buffer01.png", "type": "buffer", "channel": 0, "sampler": sampler,
                  "published": 1, "unheard": [1, null] },
                { "id": "nobody", "filepath": "/media/a/gone.png", "type": "texture", "channel": 3 },
                { "id": "nobody", "type": "smell", "channel": 2 },
              ] },
            { "type": "image", "name": "Image", "code": CODE, "outputs": [], "inputs": [
                { "id": "XdX3Rn", "type": "texture", "channel": 1, "sampler": sampler,
                  "filepath": "/media/a/52d2a8f514c4fd2d9866587f4d7b2a5bfa1a11a0e772077d7682deb8b3b517e5.jpg" },
                { "id": "4dX3Rr", "filepath": "/media/a//media/previz/cubemap00.png", "type": "cubemap", "channel": 0 },
                { "id": "zzz", "filepath": "https://soundcloud.com/a/b", "type": "musicstream", "channel": 2 },
                { "id": "4dXGRr", "filepath": "/presets/tex00.jpg", "type": "keyboard", "channel": 3 },
                { "id": "XdXGRr", "filepath": "/presets/mic.png", "type": "mic", "channel": 3 },
            ] },
            { "type": "common", "name": "Common", "code": "", "inputs": [], "outputs": [] },
            { "type": "buffer", "name": "Buf A", "code": CODE, "inputs": [], "outputs": [{ "id": "4dXGR8", "channel": 0 }] },
            { "type": "cubemap", "name": "Cube A", "code": "", "inputs": [], "outputs": [{ "id": "4dX3Rr", "channel": 0 }] },
            { "type": "sound", "name": "Sound", "code": "vec2 mainSound(int s, float t) { return vec2(0.0); }", "inputs": [],
              "outputs": "none" },
        ],
    })
}

#[test]
fn everything_comes_back() {
    let folder = same_values(&odd().to_string());
    let files = folder.files();
    for name in [
        "buffer_a.glsl",
        "buffer_b.glsl",
        "common.glsl",
        "common_2.glsl",
        "cube_a.glsl",
        "image.glsl",
        "scene.toml",
        "shadertoy.json",
        "sound.glsl",
    ] {
        assert!(files.contains(&format!("scene/{name}")), "{files:?}");
    }
    let manifest = String::from_utf8(folder.read("scene/scene.toml")).expect("text");
    for line in [
        "order = [\"B\", \"A\"]",
        "iChannel1 = { texture = \"Abstract 1\", filter = \"nearest\", vflip = false }",
        "iChannel0 = { cube = true }",
        "iChannel3 = { mic = true }",
        "iChannel3 = { texture = { id = \"nobody\", path = \"/media/a/gone.png\" } }",
    ] {
        assert!(manifest.contains(line), "{line} is not in\n{manifest}");
    }
}

#[test]
fn the_same_bytes_of_the_sites_own_files() {
    let text = odd().to_string();
    let (_, packed) = round_trip(&text);
    assert_eq!(packed.trim_end(), text);
    // Numbers keep their spelling, and keys their order.
    let text = r#"{"renderpass":[{"code":"x","type":"image","n":1.50e2}],"ver":"0.1","info":{"z":1,"name":"N","a":2.0}}"#;
    let (_, packed) = round_trip(text);
    assert_eq!(packed.trim_end(), text);
}

#[test]
fn the_folder_is_the_scene_that_the_json_is() {
    let mut shader = odd();
    // An empty pass can be kept, but not drawn.
    shader["renderpass"][5]["code"] =
        json!("void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(d, 1); }");
    let (folder, _) = round_trip(&shader.to_string());
    let of_json = loaded(&Source::Path(folder.path().join("x.json")));
    let of_folder = loaded(&Source::Path(folder.path().join("scene")));
    assert_eq!(drawn(&of_folder), drawn(&of_json));
    assert_eq!(of_folder.name, of_json.name);
    for (one, other) in of_folder.passes.iter().zip(&of_json.passes) {
        assert_eq!(one.channels[3], other.channels[3], "media keep their names");
    }
}

#[test]
fn the_public_interface_becomes_an_export() {
    let text = json!([{ "Shader": { "ver": "0.1", "info": { "id": "x", "name": "Sea" }, "renderpass": [
        { "inputs": [
            { "id": 257, "src": "/media/previz/buffer00.png", "ctype": "buffer", "channel": 0,
              "sampler": { "filter": "linear", "wrap": "repeat" } },
            { "id": 5, "ctype": "texture", "channel": 1, "published": 1,
              "src": "/media/a/8de3a3924cb95bd0e95a443fff0326c869f9d4979cd1d5b6e94e2a01f5be53e9.jpg" },
            { "id": 33, "src": "/presets/tex00.jpg", "ctype": "keyboard", "channel": 2 },
        ], "outputs": [{ "id": 37, "channel": 0 }], "code": CODE, "name": "Image", "type": "image" },
        { "inputs": [], "outputs": [{ "id": 257, "channel": 0 }], "code": CODE, "name": "", "type": "buffer" },
    ] } }]);
    let (folder, packed) = round_trip(&text.to_string());
    let value: Value = serde_json::from_str(&packed).expect("JSON");
    let image = &value["renderpass"][0];
    assert_eq!(image["inputs"][0]["id"], "4dXGR8");
    assert_eq!(image["inputs"][0]["type"], "buffer");
    assert_eq!(image["inputs"][0]["filepath"], "/media/previz/buffer00.png");
    assert_eq!(image["inputs"][1]["id"], "4dfGRn");
    assert_eq!(image["inputs"][2]["id"], "4dXGRr");
    assert_eq!(image["outputs"][0]["id"], "4dfGRr");
    assert_eq!(value["renderpass"][1]["outputs"][0]["id"], "4dXGR8");
    assert!(!packed.contains("ctype") && !packed.contains("src"));
    folder.write("y.json", &packed);
    let scenes = ["x.json", "y.json", "scene"];
    let scenes = scenes.map(|name| drawn(&loaded(&Source::Path(folder.path().join(name)))));
    assert_eq!(scenes[0], scenes[1]);
    assert_eq!(scenes[0], scenes[2]);
}

/// Shaders put together at random: whatever passes, inputs and keys they have, they come back.
#[test]
fn random_shaders_come_back() {
    let mut state = 0x5eed_u64;
    let mut below = move |limit: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % limit as u64) as usize
    };
    let ids = [
        "4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8", "4dX3Rr", "XdX3Rn", "Xsf3zn", "4dfGRn", "odd",
    ];
    let kinds = [
        "buffer", "texture", "cubemap", "volume", "video", "music", "mic", "webcam", "keyboard",
        "smell",
    ];
    let words = [
        "nearest", "linear", "mipmap", "clamp", "repeat", "true", "false", "", "cubic",
    ];
    for round in 0..150 {
        let is_api = round % 3 == 0;
        let mut passes = Vec::new();
        let mut letters = vec![0, 1, 2, 3];
        for _ in 0..below(7) {
            let kind = ["common", "buffer", "sound", "cubemap", "common"][below(5)];
            let mut outputs = json!([]);
            if kind == "buffer" {
                if letters.is_empty() {
                    continue;
                }
                let letter = letters.remove(below(letters.len()));
                outputs = match is_api {
                    true => json!([{ "id": 257 + letter, "channel": 0 }]),
                    false => json!([{ "id": ids[letter], "channel": 0 }]),
                };
            }
            passes.push((kind, outputs));
        }
        let image = below(passes.len() + 1);
        passes.insert(image, ("image", json!([])));
        let passes: Vec<Value> = passes
            .into_iter()
            .map(|(kind, outputs)| {
                let inputs: Vec<Value> = (0..below(5))
                    .map(|_| {
                        let (kind, path) = match is_api {
                            true => ("ctype", "src"),
                            false => ("type", "filepath"),
                        };
                        json!({
                            "id": if is_api { json!(below(300)) } else { json!(ids[below(ids.len())]) },
                            kind: kinds[below(kinds.len())], path: format!("/media/a/{}", below(5)),
                            "channel": below(5),
                            "sampler": { "filter": words[below(9)], "wrap": words[below(9)], "vflip": words[below(9)] },
                        })
                    })
                    .collect();
                let code = ["", CODE, "\u{e4}\r\n\t\"", "// \u{2028}\\n"][below(4)];
                json!({ "type": kind, "name": "Buf", "code": code, "inputs": inputs, "outputs": outputs })
            })
            .collect();
        let shader = json!({ "ver": "0.1", "info": { "name": words[below(9)], "likes": below(9) }, "renderpass": passes });
        let text = shader.to_string();
        let folder = tempfile::tempdir().expect("a folder");
        let source = Source::Text {
            name: "x.json".to_owned(),
            bytes: text.clone().into_bytes(),
        };
        let imported = scene::import(&source).unwrap_or_else(|error| panic!("{text}: {error:?}"));
        for (name, bytes) in imported.files {
            std::fs::write(folder.path().join(name), bytes).expect("a file");
        }
        let packed = scene::pack(folder.path()).unwrap_or_else(|error| panic!("{text}: {error:?}"));
        match is_api {
            false => assert_eq!(packed.text.trim_end(), text),
            true => {
                let again = Source::Text {
                    name: "x.json".to_owned(),
                    bytes: packed.text.clone().into_bytes(),
                };
                let (one, other) = (loaded(&source), loaded(&again));
                assert_eq!(drawn(&one), drawn(&other), "{text}\n{}", packed.text);
            }
        }
    }
}

#[test]
fn changes_of_the_manifest_are_packed() {
    let (folder, _) = round_trip(&odd().to_string());
    let manifest = String::from_utf8(folder.read("scene/scene.toml")).expect("text");
    let manifest = manifest
        .replace("order = [\"B\", \"A\"]\n", "")
        .replace("filter = \"nearest\", vflip = false", "wrap = \"clamp\"")
        .replace(
            "iChannel0 = { cube = true }",
            "iChannel0 = { video = \"Britney Spears\" }",
        )
        .replace("common_2.glsl\"", "common_2.glsl\", \"more.glsl\"");
    let manifest = manifest
        .lines()
        .map(|line| match line.starts_with("name = ") {
            true => "name = \"Fog\"",
            false => line,
        })
        .collect::<Vec<_>>()
        .join("\n");
    folder.write(
        "scene/scene.toml",
        manifest + "\n[buffer_c]\nsource = \"buffer_a.glsl\"\n",
    );
    folder.write("scene/more.glsl", "float more;");
    folder.run("pack scene -o y.json").exits(0);
    let value: Value = serde_json::from_slice(&folder.read("y.json")).expect("JSON");
    assert_eq!(value["info"]["name"], "Fog");
    assert_eq!(value["info"]["likes"], 22);
    let passes = value["renderpass"].as_array().expect("passes");
    let outputs = passes.iter().map(|pass| pass["outputs"][0]["id"].as_str());
    let outputs: Vec<_> = outputs.map(Option::unwrap_or_default).collect();
    let (a, b, c) = ("4dXGR8", "XsXGR8", "4sXGR8");
    assert_eq!(outputs, ["", a, "", "", b, "4dX3Rr", "", "", c]);
    assert_eq!(passes[7]["code"], "float more;");
    let inputs = passes[2]["inputs"].as_array().expect("inputs");
    assert_eq!(inputs[0]["sampler"]["wrap"], "clamp");
    assert_eq!(inputs[0]["sampler"]["filter"], "mipmap");
    assert_eq!(
        inputs[0]["sampler"]["internal"], "float",
        "what the manifest has no key for stays"
    );
    assert_eq!(inputs[1]["id"], "Xdf3Rn");
    assert_eq!(inputs[1]["type"], "video");
    assert_eq!(inputs.len(), 5);
}

#[test]
fn a_folder_that_was_never_on_the_site() {
    let folder = Folder::with("hills/image.glsl", CODE);
    folder.write("hills/buffer_b.glsl", CODE);
    let packed = folder.run("pack hills").exits(0).text();
    let value: Value = serde_json::from_str(&packed).expect("JSON");
    assert_eq!(value["ver"], "0.1");
    assert_eq!(value["info"]["name"], "hills");
    let passes = value["renderpass"].as_array().expect("passes");
    assert_eq!(passes[0]["name"], "Buffer B");
    assert_eq!(passes[0]["outputs"][0]["id"], "XsXGR8");
    assert_eq!(
        passes[1]["inputs"][0]["filepath"],
        "/media/previz/buffer01.png"
    );
    vitrine("check -").input(packed).run().exits(0);
}

#[test]
fn what_the_site_cannot_have_is_named() {
    let folder = Folder::with("a/image.glsl", CODE);
    folder.write("a/rock.png", "");
    folder.write(
        "a/scene.toml",
        "[image]\nsource = \"image.glsl\"\niChannel0 = { texture = \"rock.png\" }\niChannel2 = { procedural = \"noise\" }\n",
    );
    let outcome = folder.run("pack a");
    outcome
        .exits(1)
        .says("error[not-on-site]: the site cannot have: `a/rock.png` (Image, iChannel0), generated noise (Image, iChannel2)")
        .says("help: ");
    assert!(outcome.stdout.is_empty());
}

#[test]
fn a_folder_that_is_there_stays() {
    let folder = Folder::with("x.json", odd().to_string());
    folder.write("full/image.glsl", "mine");
    folder.write("full/notes.txt", "mine");
    folder.write("file", "");
    let before = folder.files();
    let outcome = folder.run("import x.json --into full");
    outcome
        .exits(2)
        .says("is there and not empty")
        .says("--overwrite");
    folder
        .run("import x.json --into file")
        .exits(2)
        .says("is a file");
    folder.write("bad.json", "{\"renderpass\":[]}");
    folder
        .run("import bad.json --into new")
        .exits(1)
        .says("no-image-pass");
    folder.write("a.glsl", CODE);
    folder
        .run("import a.glsl --into new")
        .exits(1)
        .says("can be imported");
    folder.run("pack file").exits(2).says("is no folder");
    folder.run("pack gone").exits(2).says("is no folder");
    let now = folder.files();
    assert_eq!(now.len(), before.len() + 2, "{now:?}");
    folder.run("import x.json --into full --overwrite").exits(0);
    assert_eq!(folder.read("full/notes.txt"), b"mine");
    assert_eq!(folder.read("full/image.glsl"), CODE.as_bytes());
    std::fs::create_dir(folder.path().join("empty")).expect("a folder");
    folder.run("import x.json --into empty").exits(0);
    vitrine("import - --into deep/er")
        .within(folder.path())
        .input(odd().to_string())
        .run()
        .exits(0);
    assert!(folder.files().contains(&"deep/er/scene.toml".to_owned()));
    assert!(!folder.files().iter().any(|name| name.contains(".part")));
}

#[test]
fn a_broken_record_of_the_site_is_refused() {
    for (text, words) in [
        ("[", "expected an object"),
        ("{}", "`renderpass` is no list"),
        ("{\"renderpass\":[7]}", "a pass is no object"),
        (
            "{\"renderpass\":[{\"type\":\"image\"}]}",
            "does not name the file",
        ),
        (
            "{\"renderpass\":[{\"type\":\"image\",\"code-file\":\"../../../secret\"},{\"type\":\"image\",\"code-file\":\"image.glsl\"}]}",
            "there is no file `../../../secret`",
        ),
        (
            "{\"renderpass\":[{\"type\":\"smell\",\"code-file\":\"image.glsl\"}]}",
            "unknown type",
        ),
    ] {
        let folder = Folder::with("a/image.glsl", CODE);
        folder.write("a/shadertoy.json", text);
        folder
            .run("pack a")
            .exits(1)
            .says("error[json]")
            .says(words);
        folder.run("check a").exits(0);
    }
}
