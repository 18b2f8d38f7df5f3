//! Shaders in ShaderToy's own JSON.

use serde_json::{Value, json};

use crate::support::{Folder, vitrine};

/// A pass as the site exports it.
fn pass(kind: &str, output: &str, code: &str, inputs: Value) -> Value {
    json!({
        "inputs": inputs, "outputs": [{ "id": output, "channel": 0 }],
        "code": code, "name": "", "description": "", "type": kind,
    })
}

fn export(passes: &[Value]) -> String {
    json!({ "ver": "0.1", "info": { "id": "x", "name": "Rings" }, "renderpass": passes })
        .to_string()
}

/// An Image pass over a Common and a buffer.
fn rings() -> String {
    let reads = json!([{
        "id": "4dXGR8", "filepath": "/media/previz/buffer00.png", "type": "buffer", "channel": 1,
        "sampler": { "filter": "nearest", "wrap": "clamp", "vflip": "true" },
    }]);
    export(&[
        pass(
            "common",
            "",
            "float ring(float r) { return fract(r); } // rings",
            json!([]),
        ),
        pass(
            "image",
            "4dfGRr",
            "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel1, p / iResolution.xy); }",
            reads,
        ),
        pass(
            "buffer",
            "4dXGR8",
            "void mainImage(out vec4 c, in vec2 p) { c = vec4(ring(length(p) + iTime)); }",
            json!([]),
        ),
    ])
}

#[test]
fn every_pass_is_checked_inspected_and_translated() {
    let folder = Folder::with("rings.json", rings());
    folder
        .run("check rings.json")
        .exits(0)
        .says("rings.json: fine");
    let text = folder
        .run("inspect rings.json --format json")
        .exits(0)
        .text();
    let lines: Vec<Value> = text
        .lines()
        .map(|l| serde_json::from_str(l).unwrap())
        .collect();
    let passes: Vec<_> = lines.iter().map(|line| &line["pass"]).collect();
    assert_eq!(passes, ["Buffer A", "Image"]);
    assert_eq!(lines[0]["scene"], "Rings");
    assert_eq!(lines[0]["functions"], json!(["mainImage", "ring"]));
    let channel = json!({
        "name": "iChannel1", "input": "Buffer A", "media": null,
        "filter": "nearest", "wrap": "clamp", "texture": true, "sampler": true,
    });
    assert_eq!(lines[1]["channels"], json!([channel]));

    let translated = |pass: &str| {
        let outcome = vitrine("translate rings.json --to wgsl --pass")
            .arg(pass)
            .within(folder.path())
            .run();
        outcome.exits(0).text()
    };
    assert!(translated("Buffer A").contains("fn ring"));
    assert!(translated("Image").contains("textureSample"));
    let image = folder.run("translate rings.json --to wgsl").exits(0).text();
    assert_eq!(image, translated("image"), "Image is the default");
    vitrine("translate rings.json --to wgsl --pass")
        .arg("Buffer B")
        .within(folder.path())
        .run()
        .exits(2)
        .says("help: it has: Buffer A, Image");
}

#[test]
fn a_mistake_is_shown_in_the_pass_not_in_the_json() {
    let code = "// A ring.\nvoid mainImage(out vec4 c, in vec2 p) {\n    c = vec4(lost);\n}";
    let folder = Folder::with(
        "a.json",
        export(&[
            pass("buffer", "XsXGR8", code, json!([])),
            pass(
                "image",
                "4dfGRr",
                "void mainImage(out vec4 c, in vec2 p) {}",
                json!([]),
            ),
        ]),
    );
    folder
        .run("check a.json")
        .exits(1)
        .says("error[unknown-variable]: `lost` is not declared")
        .says("a.json: Buffer B:3:14");
    let text = folder.run("check a.json --format json").exits(1).text();
    let line: Value = serde_json::from_str(&text).expect("one object");
    let verdicts: Vec<_> = line["passes"]
        .as_array()
        .expect("passes")
        .iter()
        .map(|pass| {
            (
                pass["name"].as_str().unwrap(),
                pass["verdict"].as_str().unwrap(),
            )
        })
        .collect();
    assert_eq!(verdicts, [("Buffer B", "refuse"), ("Image", "accept")]);
    assert_eq!(
        line["passes"][0]["diagnostics"][0]["code"],
        "unknown-variable"
    );
}

#[test]
fn json_is_recognised_on_standard_input() {
    let outcome = vitrine("check -").input(rings()).run();
    outcome.exits(0).says("-: fine");
    let outcome = vitrine("check -").input("{\"renderpass\": [").run();
    outcome
        .exits(1)
        .says("error[json]: the text ends")
        .says("<stdin>:1:16");
    // GLSL in a file that claims to be JSON.
    let folder = Folder::with("a.json", "void mainImage(out vec4 c, in vec2 p) {}\n");
    folder
        .run("check a.json")
        .exits(1)
        .says("error[json]: expected value")
        .says("a.json:1:1");
}

#[test]
fn a_strange_input_is_a_warning() {
    let inputs = json!([{ "id": 1, "type": "smell", "channel": 0 }]);
    let code = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }";
    let text = export(&[pass("image", "4dfGRr", code, inputs)]);
    let folder = Folder::with("a.json", text);
    folder
        .run("check a.json")
        .exits(0)
        .says("warning[unknown-input]: Image: iChannel0 has an input of the unknown `type` `smell`")
        .says("a.json: fine");
}

#[cfg(feature = "gpu")]
#[test]
fn a_single_pass_is_drawn() {
    if crate::support::gpu().is_none() {
        return;
    }
    let code = "void mainImage(out vec4 c, in vec2 p) { c = vec4(tone(p), 0.5, 1.0); }";
    let common = "vec2 tone(vec2 p) { return p / iResolution.xy; }";
    let passes = [
        pass("image", "4dfGRr", code, json!([])),
        pass("common", "", common, json!([])),
    ];
    let folder = Folder::with(
        "a.json",
        json!([{ "Shader": { "renderpass": passes } }]).to_string(),
    );
    folder.write("b.glsl", format!("{common}\n{code}"));
    for (scene, out) in [("a.json", "a.png"), ("b.glsl", "b.png")] {
        folder
            .run(&format!("export {scene} --size 16x8 --out {out}"))
            .exits(0);
    }
    assert!(
        folder.read("a.png") == folder.read("b.png"),
        "the same text, the same picture"
    );
}
