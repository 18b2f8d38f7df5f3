//! What a scene does not use is not there: not in its bindings, not in what `inspect` says.

use serde_json::{Value, json};
use vitrine::scene::Source;

use crate::support::{gpu, open, pasted, repository, vitrine};

const UNIFORMS: u32 = 0;

/// The bindings of a text's bind group, each with what it is; uniform blocks with their size.
fn bindings(text: &str) -> Option<Vec<(u32, String)>> {
    let session = open(gpu()?, &pasted(text));
    let mut layouts = session.renderer.layouts();
    let layout = layouts.next().expect("one pass");
    assert!(layouts.next().is_none(), "one pass");
    let entries = layout.entries.iter().map(|entry| {
        let what = match entry.ty {
            wgpu::BindingType::Buffer {
                min_binding_size, ..
            } => {
                let size = min_binding_size
                    .expect("the size of a block is known")
                    .get();
                // Some drivers want whole vectors.
                format!("{} bytes", size.next_multiple_of(16))
            }
            wgpu::BindingType::Texture { .. } => "texture".to_owned(),
            wgpu::BindingType::Sampler(_) => "sampler".to_owned(),
            ref other => panic!("{other:?} is no part of a scene"),
        };
        (entry.binding, what)
    });
    Some(entries.collect())
}

fn expected(entries: &[(u32, &str)]) -> Option<Vec<(u32, String)>> {
    gpu()?;
    Some(
        entries
            .iter()
            .map(|&(binding, what)| (binding, what.to_owned()))
            .collect(),
    )
}

fn image(body: &str) -> String {
    format!("void mainImage(out vec4 c, in vec2 p) {{ {body} }}")
}

#[test]
fn a_plain_scene_binds_nothing() {
    assert_eq!(
        bindings(&image("c = vec4(p / 9.0, 0.0, 1.0);")),
        expected(&[])
    );
}

#[test]
fn one_uniform_takes_one_block_of_its_size() {
    assert_eq!(
        bindings(&image("c = vec4(iTime);")),
        expected(&[(UNIFORMS, "16 bytes")])
    );
    assert_eq!(
        bindings(&image("c = iMouse;")),
        expected(&[(UNIFORMS, "16 bytes")])
    );
}

#[test]
fn what_only_comments_and_dead_functions_read_is_left_out() {
    let text =
        "// iMouse iChannel1\nfloat unused() { return iTime + texture(iChannel0, vec2(0.0)).x; }\n";
    assert_eq!(
        bindings(&(text.to_owned() + &image("c = vec4(1.0);"))),
        expected(&[])
    );
}

#[test]
fn what_the_preprocessor_drops_is_left_out() {
    let text = "#if 0\nfloat f() { return iTime; }\n#endif\n#define UNUSED iMouse\n";
    assert_eq!(
        bindings(&(text.to_owned() + &image("c = vec4(1.0);"))),
        expected(&[])
    );
}

#[test]
fn fetching_needs_no_sampler() {
    assert_eq!(
        bindings(&image("c = texelFetch(iChannel0, ivec2(p), 0);")),
        expected(&[(1, "texture")])
    );
    assert_eq!(
        bindings(&image("c = vec4(textureSize(iChannel3, 0), 0, 1);")),
        expected(&[(7, "texture")])
    );
}

#[test]
fn sampling_needs_both() {
    assert_eq!(
        bindings(&image("c = texture(iChannel1, p);")),
        expected(&[(3, "texture"), (4, "sampler")])
    );
}

#[test]
fn only_scenes_that_read_a_texture_or_a_buffer_bind_one() {
    let Some(gpu) = gpu() else { return };
    let with_texture = [
        "canyon",
        "derivatives",
        "haze",
        "mars",
        "temporal",
        "texture_noise",
    ];
    for (name, folder) in crate::support::scene_folders() {
        let session = open(gpu, &Source::Path(folder));
        let layout = session.renderer.layouts().next().expect("one pass");
        let count = if with_texture.contains(&&*name) { 3 } else { 1 };
        assert_eq!(layout.entries.len(), count, "{name}");
        // The seeds' code counts on `smoothstep` with reversed edges here and there.
        let mut warnings = session.warnings.diagnostics.iter();
        assert!(
            warnings.all(|found| found.code == "reversed-smoothstep"),
            "{name}"
        );
    }
}

fn inspected(text: &str) -> Value {
    let outcome = vitrine("inspect - --format json").input(text).run();
    outcome.exits(0);
    serde_json::from_str(&outcome.text()).expect("one object")
}

#[test]
fn inspect_says_what_was_left_out() {
    let found = inspected(&image("c = vec4(1.0);"));
    assert_eq!(found["uniforms"], json!([]));
    assert_eq!(found["uniform_block"], Value::Null);
    assert_eq!(
        found["left_out"]["objects"],
        json!(["uniform block", "textures", "samplers", "bind group"])
    );
    assert_eq!(
        found["left_out"]["uniforms"].as_array().map(Vec::len),
        Some(10)
    );

    let text = "float dead() { return iMouse.x; }\nfloat live() { return iTime; }\n".to_owned();
    let found = inspected(&(text + &image("c = live() * texelFetch(iChannel0, ivec2(p), 0);")));
    assert_eq!(found["uniforms"], json!(["iTime"]));
    assert_eq!(found["functions"], json!(["live", "mainImage"]));
    assert_eq!(found["left_out"]["functions"], json!(["dead"]));
    assert_eq!(
        found["left_out"]["channels"],
        json!(["iChannel1", "iChannel2", "iChannel3"])
    );
    assert_eq!(found["left_out"]["objects"], json!(["samplers"]));
    let channel = &found["channels"][0];
    assert_eq!(channel["name"], "iChannel0");
    assert_eq!(channel["input"], "unbound");
    assert_eq!(channel["texture"], true);
    assert_eq!(channel["sampler"], false);
}

#[test]
fn inspect_tells_people_the_same() {
    let canyon = repository("shadertoy/canyon");
    let outcome = vitrine("inspect").arg(canyon).run();
    let text = outcome.exits(0).text();
    assert!(text.starts_with("Canyon, pass Image\n"), "{text}");
    assert!(text.contains("iChannel0 (noise, linear, repeat)"), "{text}");
    let (used, left_out) = text.split_once("left out\n").expect("both parts");
    assert!(used.contains("mapCanyon"), "{text}");
    assert!(left_out.contains("iMouse"), "{text}");
}

/// A pixel that is discarded leaves its loops, since graphics libraries may let it go on for its neighbours' sake. Programs
/// without such a loop know nothing of it.
#[test]
fn only_loops_of_programs_that_discard_ask_whether_the_pixel_was() {
    let count = |body: &str| {
        let wgsl = vitrine("translate - --to wgsl").input(image(body)).run();
        wgsl.exits(0).text().matches("discarded").count()
    };
    // Declared, set, read behind the round and before `continue`.
    let body =
        "for (; c.x < 9.0; c.x++) { if (p.x > 2.0) discard; if (p.y > 2.0) continue; c.y++; }";
    assert_eq!(count(body), 4);
    assert_eq!(count("if (p.x > 2.0) discard; c = vec4(1.0);"), 0);
    assert_eq!(
        count("while (c.x < 9.0) { if (p.x > 2.0) break; c.x += 1.0; }"),
        0
    );
}
