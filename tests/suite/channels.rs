//! What a scene reads from `iChannel0` to `iChannel3`.

use glam::UVec2;
use vitrine::frame::{Clock, FrameInput, Keyboard};
use vitrine::scene::{NOISE_SIZE, Source, noise_texture};
use vitrine::session::{Session, Setup};
use vitrine::translate::Options;

use crate::support::{Folder, assert_claims, claims, draw, gpu, open, plain};

/// A scene folder whose `iChannel0` is the noise texture, `sampling` being what the manifest adds.
fn noise_scene(image: &str, sampling: &str) -> Folder {
    let folder = Folder::with("image.glsl", image);
    let manifest = format!(
        "[image]\nsource = \"image.glsl\"\niChannel0 = {{ procedural = \"noise\"{sampling} }}\n"
    );
    folder.write("scene.toml", manifest);
    folder
}

fn assert_all_hold(these: &[&str], sampling: &str) {
    let Some(gpu) = gpu() else { return };
    let folder = noise_scene(&claims(these), sampling);
    let session = open(gpu, &Source::Path(folder.path().to_owned()));
    let input = Clock::fixed(60.0).at(0, UVec2::new(these.len() as u32, 1));
    assert_claims(these, &draw(gpu, &session, &input));
}

/// A texel of the noise texture as a GLSL expression.
fn texel(x: u32, y: u32) -> String {
    let noise = noise_texture();
    let at = 4 * (y * NOISE_SIZE + x) as usize;
    let [r, g, b, a] = noise[at..at + 4] else {
        unreachable!("four bytes")
    };
    format!("vec4({r}.0, {g}.0, {b}.0, {a}.0)")
}

#[test]
fn row_0_of_a_texture_is_its_bottom_row() {
    let Some(gpu) = gpu() else { return };
    let image = "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }";
    let folder = noise_scene(image, "");
    let session = open(gpu, &Source::Path(folder.path().to_owned()));
    let picture = draw(gpu, &session, &Clock::fixed(60.0).at(0, UVec2::new(16, 16)));
    let noise = noise_texture();
    for (x, y) in [(3, 5), (0, 0), (15, 0), (7, 15)] {
        let at = 4 * (y * NOISE_SIZE + x) as usize;
        assert_eq!(
            picture.pixel(x, 15 - y),
            noise[at..at + 3],
            "texel {x}, {y}"
        );
    }
}

#[test]
fn all_four_components_arrive() {
    let fetched = format!(
        "round(255.0 * texelFetch(iChannel0, ivec2(3, 5), 0)) == {}",
        texel(3, 5)
    );
    assert_all_hold(&[&fetched], "");
}

#[test]
fn coordinates_repeat_or_stop_at_the_edge() {
    let inside = format!(
        "round(255.0 * textureLod(iChannel0, vec2(3.5, 5.5) / 256.0, 0.0)) == {}",
        texel(3, 5)
    );
    let beyond = |x, y| {
        format!(
            "round(255.0 * textureLod(iChannel0, vec2(256.0 + 3.5, -256.0 + 5.5) / 256.0, 0.0)) == {}",
            texel(x, y)
        )
    };
    assert_all_hold(
        &[&inside, &beyond(3, 5)],
        ", filter = \"nearest\", wrap = \"repeat\"",
    );
    assert_all_hold(
        &[&inside, &beyond(255, 0)],
        ", filter = \"nearest\", wrap = \"clamp\"",
    );
}

#[test]
fn filters_do_as_they_are_called() {
    let between = "textureLod(iChannel0, vec2(4.0, 5.5) / 256.0, 0.0)";
    let mean =
        "0.5 * (texelFetch(iChannel0, ivec2(3, 5), 0) + texelFetch(iChannel0, ivec2(4, 5), 0))";
    let linear = format!("distance({between}, {mean}) < 0.01");
    let nearest = format!("distance({between}, {mean}) > 0.01");
    // The smallest level is the mean of all: half of everything, for each value is equally frequent.
    // Devices round each level as they please; one upward in all eight is off by 4/255.
    let smallest = "distance(textureLod(iChannel0, vec2(0.3), 8.0), vec4(0.5)) < 0.04";
    let not_mixed = "distance(textureLod(iChannel0, vec2(0.3), 8.0), vec4(0.5)) > 0.02";
    assert_all_hold(&[&linear, smallest], ", filter = \"mipmap\"");
    assert_all_hold(&[&linear, not_mixed], ", filter = \"linear\"");
    assert_all_hold(&[&nearest, not_mixed], ", filter = \"nearest\"");
    // As the site has it for a new texture.
    assert_all_hold(&[&linear, smallest], "");
}

#[test]
fn a_channel_knows_its_size() {
    assert_all_hold(
        &[
            "iChannelResolution[0] == vec3(256.0, 256.0, 1.0)",
            "iChannelResolution[1] == vec3(0.0)",
            "iChannelTime[0] == 0.0",
            "textureSize(iChannel0, 0) == ivec2(256)",
        ],
        "",
    );
}

#[test]
fn a_sampler_of_the_authors_own_reads_the_first_channel() {
    let Some(gpu) = gpu() else { return };
    let these = [
        "read(own, p) == texelFetch(iChannel0, ivec2(p), 0)",
        "own_size() == ivec2(256)",
        // Of another type than what the first channel reads, it is unbound.
        "texture(cube, vec3(1)) == vec4(0, 0, 0, 1)",
    ];
    let own = "uniform sampler2D own;\nuniform samplerCube cube;\n\
               vec4 read(sampler2D t, vec2 p) { return texelFetch(t, ivec2(p), 0); }\n\
               ivec2 own_size() { return textureSize(own, 0); }\n";
    let folder = noise_scene(&format!("{own}{}", claims(&these)), "");
    let session = open(gpu, &Source::Path(folder.path().to_owned()));
    let input = Clock::fixed(60.0).at(0, UVec2::new(these.len() as u32, 1));
    assert_claims(&these, &draw(gpu, &session, &input));
}

#[test]
fn a_channels_structure_has_its_sampler_size_time_and_whether_it_is_loaded() {
    assert_all_hold(
        &[
            "texelFetch(iCh0.sampler, ivec2(p), 0) == texelFetch(iChannel0, ivec2(p), 0)",
            "textureSize(iCh0 . sampler, 0) == ivec2(256)",
            "iCh0.size == vec3(256.0, 256.0, 1.0) && iCh0.size.xy == vec2(256.0)",
            "iCh0.time == 0.0 && iCh3.time == 0.0",
            "iCh0.loaded == 1 && iCh1.loaded == 0",
            "iCh1.size == vec3(0.0)",
            "texture(iCh2.sampler, vec2(0.5)) == vec4(0, 0, 0, 1)",
        ],
        "",
    );
}

/// Texels are cut off to halves, what follows is rounded to them, and what no texel takes part in is left alone.
#[test]
fn samplers_of_low_precision_give_halves() {
    let Some(gpu) = gpu() else { return };
    let texel = noise_texture()[0];
    let cut = (f32::from(texel) / 255.0).to_bits() & 0xffff_e000;
    let these = [
        &*format!("floatBitsToUint(texelFetch(iChannel0, ivec2(0), 0).x) == {cut}u"),
        "halved(texelFetch(iChannel0, ivec2(0), 0) * 0.3)",
        "halved(changed(texelFetch(iChannel0, ivec2(0), 0)))",
        "halved(declared())",
        "halved(texelFetch(iChannel0, ivec2(5), 0) * 2.0 - texture(iChannel0, vec2(0.4)))",
        // Too small for a normal half: a multiple of the smallest. And constants are rounded before they are compared.
        "tiny((texelFetch(iChannel0, ivec2(0), 0) * 0.00001).x)",
        "texture(iChannel0, vec2(0.1)).x * 0.0 + 0.7998046875 == texture(iChannel0, vec2(0.1)).x * 0.0 + 0.8",
        // The bits of integers: of what is no number as well, which becomes quiet.
        "floatBitsToUint(texelFetch(iChannel1, ivec2(0), 0)) == uvec4(0x7fc12000u, 0xffc00000u, 0x7f800000u, 0u)",
        "int(texelFetch(iChannel0, ivec2(0), 0).x * 0.0 + 40000.0) == 32767",
        "ivec2(texelFetch(iChannel0, ivec2(0), 0).xy * 0.0 - 40000.0) == ivec2(-32768)",
        "int(iResolution.y * 40000.0) == 40000",
        "!halved(vec4(iResolution.x / 7.3))",
        "!halved(texelFetch(iChannel0, ivec2(0), 0) / (iResolution.x + 2.1))",
    ];
    let ask = "vec4 changed(vec4 v) { v.y += 1.0; return v; }\n\
               vec4 declared() { vec4 v = texelFetch(iChannel0, ivec2(0), 0); v.y += 0.1; return v; }\n\
               bool halved(vec4 v) { return (floatBitsToUint(v.x) & 0x1fffu) == 0u; }\n\
               bool tiny(float v) { return v != 0.0 && fract(v * 16777216.0) == 0.0; }\n";
    let folder = Folder::with("image.glsl", format!("{ask}{}", claims(&these)));
    folder.write(
        "scene.toml",
        "[image]\niChannel0 = { procedural = \"noise\" }\niChannel1 = { buffer = \"A\" }\n[buffer_a]\n",
    );
    folder.write(
        "buffer_a.glsl",
        "void mainImage(out vec4 o, vec2 p) {
            // Not known before it runs, for compilers make quiet what they know.
            o = uintBitsToFloat(uvec4(0x7f812345u, 0xffc00001u, 0x7f800000u, 0x12345u) | uint(iFrame));
        }",
    );
    let setup = Setup::from(Options {
        low_samplers: true,
        ..Options::default()
    });
    let source = Source::Path(folder.path().to_owned());
    let session = Session::open(gpu, &source, &setup).expect("a good scene");
    let input = Clock::fixed(60.0).at(0, UVec2::new(these.len() as u32, 1));
    assert_claims(&these, &draw(gpu, &session, &input));
}

#[test]
fn an_unbound_channel_reads_opaque_black_and_warns() {
    let Some(gpu) = gpu() else { return };
    let these = [
        "texture(iChannel2, vec2(0.3)) == vec4(0.0, 0.0, 0.0, 1.0)",
        "texelFetch(iChannel2, ivec2(0), 0) == vec4(0.0, 0.0, 0.0, 1.0)",
    ];
    let session = open(gpu, &crate::support::pasted(&claims(&these)));
    let input = Clock::fixed(60.0).at(0, UVec2::new(2, 1));
    assert_claims(&these, &draw(gpu, &session, &input));

    let warnings = plain(&session.warnings);
    assert_eq!(session.warnings.diagnostics.len(), 1, "{warnings}");
    assert!(!session.warnings.has_errors());
    assert!(
        warnings.contains("`iChannel2` is read but nothing is bound to it"),
        "{warnings}"
    );
}

#[test]
fn the_keyboard_has_a_column_for_each_key() {
    let Some(gpu) = gpu() else { return };
    let these = [
        "texelFetch(iChannel0, ivec2(65, 0), 0) == vec4(1, 0, 0, 1)",
        "texelFetch(iChannel0, ivec2(65, 1), 0).x == 1.0",
        "texelFetch(iChannel0, ivec2(65, 2), 0).x == 1.0",
        "texelFetch(iChannel0, ivec2(66, 0), 0) == vec4(0, 0, 0, 1)",
        // Held since the frame before: it is not pressed again.
        "texelFetch(iChannel0, ivec2(37, 0), 0).x == 1.0",
        "texelFetch(iChannel0, ivec2(37, 1), 0).x == 0.0",
        "textureSize(iChannel0, 0) == ivec2(256, 3)",
        "iChannelResolution[0] == vec3(256, 3, 1)",
        // Between keys there is nothing, whatever is asked for.
        "texture(iChannel0, vec2(65.9 / 256.0, 0.1)).x == 1.0",
        "texture(iChannel0, vec2(1.3, 0.1)).x == 0.0",
    ];
    let folder = Folder::with("image.glsl", claims(&these));
    folder.write(
        "scene.toml",
        "[image]\nsource = \"image.glsl\"\niChannel0 = { keyboard = true, filter = \"linear\" }\n",
    );
    let session = open(gpu, &Source::Path(folder.path().to_owned()));
    assert!(session.reads_keyboard());
    let mut keyboard = Keyboard::default();
    keyboard.press(37);
    keyboard.frame_drawn();
    keyboard.press(65);
    let input = FrameInput {
        keyboard,
        ..Clock::fixed(60.0).at(0, UVec2::new(these.len() as u32, 1))
    };
    assert_claims(&these, &draw(gpu, &session, &input));
}
