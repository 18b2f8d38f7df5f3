//! Input scripts and dates, as frames show them.

use crate::support::{Folder, claims, gpu, read_png};

/// Shows `iMouse` as a row of 4 pixels, and above it a key's three rows in the texture of the keyboard.
const SCENE: &str = r#"{"ver":"0.1","info":{"id":"keys","name":"keys"},"renderpass":[{"inputs":[
    {"id":"4dXGRr","type":"keyboard","filepath":"/presets/tex00.jpg","channel":0,
     "sampler":{"filter":"nearest","wrap":"clamp","vflip":"true","srgb":"false","internal":"byte"}}],
    "outputs":[{"id":"4dfGRr","channel":0}],"name":"Image","type":"image",
    "code":"void mainImage(out vec4 c, in vec2 p) {\n int x = int(p.x);\n if (p.y > 1.0) { c = vec4(x > 2 ? 0.0 : texelFetch(iChannel0, ivec2(65, x), 0).x); return; }\n float v = iMouse[x];\n c = vec4(abs(v) / 255.0, v > 0.0 ? 1.0 : 0.0, v < 0.0 ? 1.0 : 0.0, 1.0);\n}"}]}"#;

const SCRIPT: &str = r#"{"version":1,"width":4,"height":2,"fps":30}
{"frame":2,"time":0.066,"mouse":"press","x":1,"y":0}
{"frame":2,"key":65,"down":true}
{"frame":3,"mouse":"move","x":3,"y":1}
{"frame":4,"mouse":"release"}
{"frame":4,"key":65,"down":false}
"#;

/// `iMouse` and the key's rows of an exported picture of 4 × 2 pixels.
fn seen(folder: &Folder, file: &str) -> ([i32; 4], [u8; 3]) {
    let picture = read_png(&folder.path().join(file));
    let mouse = [0, 1, 2, 3].map(|x| {
        let [value, _, is_negative] = picture.pixel(x, 1).map(i32::from);
        if is_negative > 0 { -value } else { value }
    });
    (mouse, [0, 1, 2].map(|x| picture.pixel(x, 0)[0]))
}

#[test]
fn an_export_replays_a_script_however_it_is_cut() {
    if gpu().is_none() {
        return;
    }
    let folder = Folder::with("keys.json", SCENE);
    folder.write("input.jsonl", SCRIPT);
    let export = "export keys.json --size 4x2 --input input.jsonl";
    folder
        .run(&format!("{export} --frames 0..6 --out all%d.png"))
        .exits(0);
    let all = [0, 1, 2, 3, 4, 5].map(|frame| seen(&folder, &format!("all{frame}.png")));
    let expected = [
        ([0, 0, 0, 0], [0, 0, 0]),
        ([0, 0, 0, 0], [0, 0, 0]),
        ([1, 0, 1, 0], [255, 255, 255]),
        ([3, 1, 1, 0], [255, 0, 255]),
        ([3, 1, -1, 0], [0, 0, 255]),
        ([3, 1, -1, 0], [0, 0, 255]),
    ];
    assert_eq!(all, expected);
    for frame in [3, 5] {
        let part = format!("{export} --frames {frame}..{} --out part%d.png", frame + 1);
        folder.run(&part).exits(0);
        assert_eq!(seen(&folder, &format!("part{frame}.png")), expected[frame]);
    }
    // The script's own rate: frame 3 is at a tenth of a second.
    folder
        .run(&format!("{export} --time 0.1 --out time.png"))
        .exits(0);
    assert_eq!(seen(&folder, "time.png"), expected[3]);
    folder
        .run(&format!("{export} --time 0.1 --fps 50 --out fps.png"))
        .exits(0);
    assert_eq!(seen(&folder, "fps.png"), expected[5]);
}

#[test]
fn positions_follow_the_size_and_values_from_within_see_them_too() {
    if gpu().is_none() {
        return;
    }
    // (3 + ½) · 10 = 35 and (1 + ½) · 10 = 15: the middle of the pixel counts.
    let claim = claims(&["iMouse == vec4(35.0, 1.0, 15.0, 0.0)"]);
    let everywhere = claim.replace("int i = int(p.x)", "int i = 0");
    let folder = Folder::with("claim.glsl", everywhere);
    folder.write("input.jsonl", SCRIPT);
    let export = "export claim.glsl --size 40x2 --input input.jsonl --time 0.1 --fps 30";
    folder.run(&format!("{export} --out a.png")).exits(0);
    assert_eq!(
        read_png(&folder.path().join("a.png")).pixel(7, 0),
        [0, 255, 0]
    );
    folder
        .run(&format!("{export} --count loops --probe p --out c.exr"))
        .exits(0);
}

#[test]
fn buffers_remember_what_was_done_before() {
    use exr::prelude::{ReadChannels as _, ReadLayers as _};
    if gpu().is_none() {
        return;
    }
    let folder = Folder::new();
    // Buffer A counts the frames in which the button was down.
    let count = "void mainImage(out vec4 c, in vec2 p) {
        c = texelFetch(iChannel0, ivec2(p), 0) + vec4(iMouse.z > 0.0 ? 0.25 : 0.0);
    }";
    let image = "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }";
    folder.write("scene/buffer_a.glsl", count);
    folder.write("scene/image.glsl", image);
    folder.write("input.jsonl", SCRIPT);
    // The button is down in frames 2 and 3.
    let export = "export scene --size 4x2 --input input.jsonl --frames 5..6";
    for (out, more) in [("plain.png", ""), ("layers.exr", "--probe p")] {
        folder.run(&format!("{export} --out {out} {more}")).exits(0);
    }
    let plain = read_png(&folder.path().join("plain.png"));
    assert_eq!(plain.pixel(1, 1), [128; 3]);
    let layers = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_file(folder.path().join("layers.exr"));
    let channels = layers.expect("a picture").layer_data.channel_data.list;
    let red = channels.iter().find(|channel| channel.name.eq("R"));
    let red = red.expect("a channel").sample_data.values_as_f32();
    assert_eq!(red.collect::<Vec<_>>(), [0.5; 8]);
}

#[test]
fn a_mouse_and_a_date_can_be_given() {
    if gpu().is_none() {
        return;
    }
    let held = [
        "iMouse == vec4(3.0, 1.0, 3.0, -1.0)",
        "iDate == vec4(2026.0, 10.0, 25.0, 43200.0)",
    ];
    let folder = Folder::with("claims.glsl", claims(&held));
    let export = "export claims.glsl --size 2x1 --mouse 3,1 --date 2026-11-25T12:00:00";
    folder
        .run(&format!("{export} --time 5 --out a.png"))
        .exits(0);
    crate::support::assert_claims(&held, &read_png(&folder.path().join("a.png")));
    let other = "export claims.glsl --size 2x1 --mouse=-3,1,0,5 --out b.png";
    folder.run(other).exits(0);
    assert_eq!(
        read_png(&folder.path().join("b.png")).pixel(0, 0),
        [255, 0, 0]
    );
}

#[test]
fn what_is_wrong_is_told() {
    let folder = Folder::with(
        "a.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(0); }",
    );
    folder.write("bad.jsonl", SCRIPT.replace("\"release\"", "\"let go\""));
    folder.write("empty.jsonl", "");
    let run = |arguments: &str| folder.run(&format!("export a.glsl --out a.png {arguments}"));
    run("--input bad.jsonl")
        .exits(2)
        .says("`bad.jsonl`, line 5: unknown variant `let go`");
    run("--input empty.jsonl")
        .exits(2)
        .says("`empty.jsonl`, line 1: the script is empty");
    run("--input missing.jsonl")
        .exits(2)
        .says("cannot read `missing.jsonl`");
    run("--input bad.jsonl --mouse 1,1")
        .exits(2)
        .says("cannot be used with");
    run("--date tomorrow")
        .exits(2)
        .says("`--date tomorrow` is no date");
    run("--mouse 1").exits(2).says("write it as X,Y");
    let huge = std::fs::File::create(folder.path().join("huge.jsonl")).expect("a file");
    huge.set_len((64 << 20) + 1).expect("it takes no room");
    run("--input huge.jsonl")
        .exits(2)
        .says("`huge.jsonl` is larger than 64 MiB");
    assert!(!folder.path().join("a.png").exists());
}

#[cfg(feature = "window")]
#[test]
fn a_recording_that_is_there_stays() {
    let folder = Folder::with("mine.jsonl", "mine");
    folder
        .run("run --record-input mine.jsonl")
        .exits(2)
        .says("`mine.jsonl` exists already")
        .says("--overwrite");
    folder
        .run("run --overwrite")
        .exits(2)
        .says("--record-input");
    assert_eq!(folder.read("mine.jsonl"), b"mine");
}
