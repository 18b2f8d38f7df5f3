//! Passes that draw buffers for each other: their order, what they remember, how they are read.

use glam::UVec2;
use serde_json::{Value, json};
use vitrine::frame::{Clock, FloatImage};
use vitrine::render::{Extras, Format, Gpu, Pace, ReadBack};
use vitrine::scene::{PassKind, Source};
use vitrine::session::{Session, Setup};
use vitrine::translate::Options;

use crate::support::{Folder, gpu, repository, vitrine};

/// The site's ids of what passes write.
const IDS: [&str; 4] = ["4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8"];

/// A buffer by its letter, read through the channel of its place in a list.
fn inputs(letters: &str, filter: &str) -> Value {
    let inputs = letters.chars().enumerate().map(|(channel, letter)| {
        let id = IDS[letter as usize - 'A' as usize];
        let sampler = json!({ "filter": filter, "wrap": "clamp", "vflip": "true" });
        json!({ "id": id, "type": "buffer", "channel": channel, "sampler": sampler })
    });
    inputs.collect()
}

/// A pass: `A` to `D`, or `image`; the body of its `mainImage`, in which `at(n)` is the texel of channel n here.
fn pass(kind: &str, body: &str, inputs: Value) -> Value {
    let code = format!(
        "#define at(n) texelFetch(n, ivec2(p), 0)\nvoid mainImage(out vec4 c, in vec2 p) {{ {body} }}"
    );
    let (kind, id) = match kind {
        "image" => ("image", "4dfGRr"),
        letter => ("buffer", IDS[usize::from(letter.as_bytes()[0] - b'A')]),
    };
    json!({ "type": kind, "code": code, "inputs": inputs, "outputs": [{ "id": id, "channel": 0 }], "name": "" })
}

fn floats(options: &Options) -> Setup {
    Setup {
        options: options.clone(),
        format: Format::Floats,
        ..Setup::default()
    }
}

fn scene(passes: &[Value]) -> Source {
    Source::Text {
        name: "scene.json".to_owned(),
        bytes: json!({ "ver": "0.1", "renderpass": passes, "info": { "name": "Buffers" } })
            .to_string()
            .into_bytes(),
    }
}

const SIZE: UVec2 = UVec2::new(8, 6);

fn open(gpu: &Gpu, passes: &[Value]) -> Session {
    let options = Options::default();
    Session::open(gpu, &scene(passes), &floats(&options)).expect("a good scene")
}

/// Draws frames one after the other, the numbers as given; the last picture.
fn drawn(gpu: &Gpu, session: &Session, frames: &[u32], sizes: &[UVec2]) -> FloatImage {
    let mut canvas = session.renderer.canvas(gpu, sizes[0]).expect("a canvas");
    let mut image = FloatImage::default();
    let mut size = sizes[0];
    for (i, &frame) in frames.iter().enumerate() {
        let wanted = sizes[i.min(sizes.len() - 1)];
        if wanted != size {
            size = wanted;
            canvas = session
                .renderer
                .resized(gpu, &canvas, size)
                .expect("a canvas");
        }
        let mut ring = ReadBack::new(gpu, &canvas.target, 1, Extras::default()).expect("a slot");
        let slot = &mut ring.slots[0];
        let input = Clock::fixed(60.0).at(frame, size);
        session
            .renderer
            .render(gpu, &input, &mut canvas, Some(slot));
        while !slot.is_ready(gpu).expect("the device works") {}
        slot.take_floats(gpu, &mut image).expect("a picture");
    }
    image
}

/// The texel in the lower left.
fn corner(image: &FloatImage) -> [f32; 4] {
    image.rgba[((image.size.y - 1) * image.size.x) as usize]
}

fn frames(count: u32) -> Vec<u32> {
    (0..count).collect()
}

#[test]
fn a_pass_remembers_what_it_drew() {
    let Some(gpu) = gpu() else { return };
    let session = open(
        gpu,
        &[
            pass(
                "A",
                "c = at(iChannel0) + vec4(1., float(iFrame), 0.25, 0.);",
                inputs("A", "nearest"),
            ),
            pass("image", "c = at(iChannel0);", inputs("A", "nearest")),
        ],
    );
    assert!(session.renderer.feeds_back());
    // Frames 0 to 4: five times one, and 0 + 1 + 2 + 3 + 4.
    assert_eq!(
        corner(&drawn(gpu, &session, &frames(5), &[SIZE])),
        [5.0, 10.0, 1.25, 1.0]
    );
}

#[test]
fn two_passes_that_draw_one_buffer_see_each_other() {
    let Some(gpu) = gpu() else { return };
    let add = |number: &str| {
        let body = format!("c = at(iChannel0) + vec4({number}, 1, 0, 0);");
        pass("A", &body, inputs("A", "nearest"))
    };
    let image = pass("image", "c = at(iChannel0);", inputs("A", "nearest"));
    let session = open(gpu, &[add("10"), add("100"), image.clone()]);
    for count in 1..5 {
        let [sum, draws, ..] = corner(&drawn(gpu, &session, &frames(count), &[SIZE]));
        let count = count as f32;
        assert_eq!((sum, draws), (110.0 * count, 2.0 * count));
    }
    let session = open(gpu, &[add("1"), add("10"), add("100"), image]);
    for count in 1..5 {
        let [sum, draws, ..] = corner(&drawn(gpu, &session, &frames(count), &[SIZE]));
        let count = count as f32;
        assert_eq!((sum, draws), (111.0 * count, 3.0 * count));
    }
}

#[test]
fn a_discarded_texel_stays_what_it_was_two_frames_ago() {
    let Some(gpu) = gpu() else { return };
    let body = "if (iFrame > 1) discard; c = vec4(iFrame + 1);";
    let session = open(
        gpu,
        &[
            pass("A", body, json!([])),
            pass("image", "c = at(iChannel0);", inputs("A", "nearest")),
        ],
    );
    // The half that is drawn into is the one of the frame before the last: that of frame 0, then that of frame 1.
    for (count, expected) in [(2, 2.0), (3, 1.0), (4, 2.0), (5, 1.0)] {
        let shown = corner(&drawn(gpu, &session, &frames(count), &[SIZE]));
        assert_eq!(shown[0], expected, "after {count} frames");
    }
}

#[test]
fn what_is_drawn_later_is_the_last_frames() {
    let Some(gpu) = gpu() else { return };
    // B comes first in the file, as on the site: its own letter does not matter.
    let session = open(
        gpu,
        &[
            pass(
                "B",
                "c = vec4(iFrame + 1, at(iChannel0).x, 0, 0);",
                inputs("A", "nearest"),
            ),
            pass(
                "A",
                "c = vec4(at(iChannel0).x * 10., at(iChannel1).x, 0, 0);",
                inputs("BA", "nearest"),
            ),
            pass(
                "image",
                "c = vec4(at(iChannel0).xy, at(iChannel1).y, 1);",
                inputs("AB", "nearest"),
            ),
        ],
    );
    // In frame 3: A holds ten times B's 4, and what it held itself, 30; B saw A's 30.
    assert_eq!(
        corner(&drawn(gpu, &session, &frames(4), &[SIZE])),
        [40.0, 30.0, 30.0, 1.0]
    );
}

#[test]
fn nothing_is_remembered_without_feedback() {
    let Some(gpu) = gpu() else { return };
    let session = open(
        gpu,
        &[
            pass("A", "c = vec4(p, iFrame, -3.5);", json!([])),
            pass("image", "c = at(iChannel0).wzyx;", inputs("A", "nearest")),
        ],
    );
    assert!(!session.renderer.feeds_back());
    // Buffers hold floats of any sign, alpha included; the picture's own alpha is 1.
    assert_eq!(
        corner(&drawn(gpu, &session, &[7], &[SIZE])),
        [-3.5, 7.0, 0.5, 1.0]
    );
}

#[test]
fn time_that_begins_again_clears_buffers() {
    let Some(gpu) = gpu() else { return };
    let session = open(
        gpu,
        &[
            pass("A", "c = at(iChannel0) + 1.;", inputs("A", "nearest")),
            pass("image", "c = at(iChannel0);", inputs("A", "nearest")),
        ],
    );
    assert_eq!(
        corner(&drawn(gpu, &session, &[0, 1, 2, 0, 1], &[SIZE]))[0],
        2.0
    );
}

#[test]
fn another_size_keeps_the_lower_left() {
    let Some(gpu) = gpu() else { return };
    let session = open(
        gpu,
        &[
            pass(
                "A",
                "c = iFrame == 0 ? vec4(p, 0, 0) : at(iChannel0);",
                inputs("A", "nearest"),
            ),
            pass(
                "image",
                "c = vec4(at(iChannel0).xy, iChannelResolution[0].xy);",
                inputs("A", "nearest"),
            ),
        ],
    );
    let larger = UVec2::new(11, 9);
    let image = drawn(gpu, &session, &[0, 1, 2], &[SIZE, SIZE, larger]);
    for y in 0..larger.y {
        for x in 0..larger.x {
            let row = larger.y - 1 - y;
            let texel = image.rgba[(row * larger.x + x) as usize];
            let is_old = x < SIZE.x && y < SIZE.y;
            let expected = match is_old {
                true => [x as f32 + 0.5, y as f32 + 0.5],
                false => [0.0, 0.0],
            };
            assert_eq!([texel[0], texel[1]], expected, "{x}, {y}");
            assert_eq!(texel[2], larger.x as f32);
        }
    }
}

#[test]
fn a_pass_that_nothing_reads_is_left_out() {
    let Some(gpu) = gpu() else { return };
    let session = open(
        gpu,
        &[
            pass("A", "c = vec4(1);", json!([])),
            pass("B", "c = at(iChannel0);", inputs("A", "nearest")),
            pass("C", "c = vec4(3);", inputs("B", "nearest")),
            // It is bound but not read.
            pass("image", "c = at(iChannel1);", inputs("AC", "nearest")),
        ],
    );
    let kinds: Vec<_> = session
        .programs
        .iter()
        .map(|program| program.kind.name())
        .collect();
    assert_eq!(kinds, ["Buffer C", "Image"]);
    assert_eq!(session.scene.image().kind, PassKind::Image);
    assert_eq!(corner(&drawn(gpu, &session, &[0], &[SIZE]))[0], 3.0);
}

#[test]
fn a_buffer_that_no_pass_draws_is_clear() {
    let Some(gpu) = gpu() else { return };
    let session = open(
        gpu,
        &[pass(
            "image",
            "c = at(iChannel0) + vec4(0, textureSize(iChannel0, 0), 0);",
            inputs("D", "linear"),
        )],
    );
    assert!(!session.renderer.feeds_back());
    assert_eq!(
        corner(&drawn(gpu, &session, &[0], &[SIZE])),
        [0.0, 8.0, 6.0, 1.0]
    );
}

#[test]
fn each_reader_has_its_filter() {
    let Some(gpu) = gpu() else { return };
    let read = "c = vec4(texture(iChannel0, vec2(.5, .25)).x, textureLod(iChannel0, vec2(.5), 9.).x, 0, 1);";
    let checks = "c = vec4(mod(floor(p.x), 2.));";
    for (filter, between, level) in [
        ("nearest", 0.0, 0.0),
        ("linear", 0.5, 0.5),
        ("mipmap", 0.5, 0.5),
    ] {
        let session = open(
            gpu,
            &[
                pass("A", checks, json!([])),
                pass("image", read, inputs("A", filter)),
            ],
        );
        let [x, y, ..] = corner(&drawn(gpu, &session, &[0], &[SIZE]));
        assert_eq!((x, y), (between, level), "{filter}");
    }
    // The smallest level is the mean of all.
    let session = open(
        gpu,
        &[
            pass("A", "c = vec4(p.x, p.y * p.y, 0, 1);", json!([])),
            pass(
                "image",
                "c = textureLod(iChannel0, vec2(.5), 20.);",
                inputs("A", "mipmap"),
            ),
        ],
    );
    let size = UVec2::new(16, 8);
    let [x, y, ..] = corner(&drawn(gpu, &session, &[0], &[size]));
    let squares: f32 = (0..8).map(|i| (i as f32 + 0.5).powi(2)).sum();
    assert!(
        (x - 8.0).abs() < 1e-4 && (y - squares / 8.0).abs() < 1e-3,
        "{x} {y}"
    );
}

#[test]
fn bands_make_the_same_picture() {
    let Some(gpu) = gpu() else { return };
    let session = open(
        gpu,
        &[
            pass(
                "A",
                "c = texture(iChannel0, p / iResolution.xy * .9) * .5 + vec4(sin(p.x), cos(p.y), iFrame, 1);",
                inputs("A", "linear"),
            ),
            pass(
                "image",
                "c = textureLod(iChannel0, p / iResolution.yx, 1.);",
                inputs("A", "mipmap"),
            ),
        ],
    );
    let size = UVec2::new(40, 60);
    let whole = drawn(gpu, &session, &frames(4), &[size]);
    let mut canvas = session.renderer.canvas(gpu, size).expect("a canvas");
    let mut image = FloatImage::default();
    for frame in 0..4 {
        let mut ring = ReadBack::new(gpu, &canvas.target, 1, Extras::default()).expect("a slot");
        let slot = &mut ring.slots[0];
        let input = Clock::fixed(60.0).at(frame, size);
        let mut pace = Pace::new(gpu, size);
        let bands = &mut || true;
        let renderer = &session.renderer;
        renderer
            .render_in_bands(gpu, &input, &mut canvas, Some(slot), &mut pace, bands)
            .expect("the device works");
        while !slot.is_ready(gpu).expect("the device works") {}
        slot.take_floats(gpu, &mut image).expect("a picture");
    }
    assert!(image == whole);
}

#[test]
fn an_export_from_the_middle_is_the_same() {
    if gpu().is_none() {
        return;
    }
    let Source::Text { bytes, .. } = scene(&[
        pass(
            "A",
            "c = at(iChannel0) + vec4(.01, .02 * fract(p.x * .1), .005, 0.);",
            inputs("A", "nearest"),
        ),
        pass("image", "c = at(iChannel0);", inputs("A", "nearest")),
    ]) else {
        unreachable!("it is a text");
    };
    let folder = Folder::with("a.json", String::from_utf8(bytes).expect("JSON"));
    let export = |rest: &str| {
        let outcome = vitrine(&format!("export a.json --size 16x8 {rest}"))
            .within(folder.path())
            .run();
        assert_eq!(outcome.code, Some(0), "{}", outcome.stderr);
        outcome.stderr
    };
    export("--frames 0..6 --out all%d.png");
    let said = export("--frames 5..6 --out late%d.png");
    assert!(said.contains("drawing the 5 frames before"), "{said}");
    export("--time 0.0833 --out still.png");
    let bytes = |name: &str| std::fs::read(folder.path().join(name)).expect("a picture");
    assert!(bytes("all5.png") == bytes("late5.png"));
    assert!(bytes("all5.png") == bytes("still.png"));
    assert!(bytes("all4.png") != bytes("all5.png"));
}

/// Life's rules on its own last frame, in a folder without a manifest and in one with.
#[test]
fn folders_have_buffers() {
    let Some(gpu) = gpu() else { return };
    let own =
        "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) + ONE; }";
    let other =
        "void mainImage(out vec4 c, in vec2 p) { c = 10. * texelFetch(iChannel0, ivec2(p), 0); }";
    let image = "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel1, ivec2(p), 0); }";
    let folder = Folder::new();
    folder.write("common.glsl", "#define ONE vec4(1, 2, 3, 4)");
    folder.write("buffer_a.glsl", own);
    folder.write("buffer_b.glsl", other);
    folder.write("image.glsl", image);
    let open = || {
        let source = Source::Path(folder.path().to_owned());
        Session::open(gpu, &source, &floats(&Options::default())).expect("a good scene")
    };
    let shown = |session: &Session| corner(&drawn(gpu, session, &frames(3), &[SIZE]));
    // Each pass reads Buffer A through iChannel0 and Buffer B through iChannel1.
    assert_eq!(shown(&open()), [30.0, 60.0, 90.0, 1.0]);
    folder.write(
        "scene.toml",
        r#"
common = ["common.glsl"]
order = ["B", "A"]
[buffer_a]
source = "buffer_a.glsl"
iChannel0 = { buffer = "A", filter = "nearest" }
[buffer_b]
source = "buffer_b.glsl"
iChannel0 = { buffer = "A" }
[image]
source = "image.glsl"
iChannel1 = { buffer = "B", wrap = "repeat" }
"#,
    );
    // B is drawn first now, and sees what A held in the last frame.
    assert_eq!(shown(&open()), [20.0, 40.0, 60.0, 1.0]);
}

#[test]
fn blending_over_time_begins_as_the_template() {
    let Some(gpu) = gpu() else { return };
    let draw = |name: &str, defines: &[(&str, &str)]| {
        let options = Options {
            overrides: defines
                .iter()
                .map(|(name, value)| (name.to_string(), value.to_string()))
                .collect(),
            ..Options::default()
        };
        let source = Source::Path(repository("shadertoy").join(name));
        let session = Session::open(gpu, &source, &floats(&options));
        let session = session.expect("a good scene");
        drawn(gpu, &session, &frames(3), &[UVec2::new(96, 54)])
    };
    let template = draw("template", &[]);
    let plain = draw("temporal", &[("NEW_SHARE", "1.0"), ("JITTER", "0")]);
    assert!(plain == template);
    assert!(draw("temporal", &[]) != template);
}
