//! The text that ShaderToy puts ahead of the author's: declarations and `main`.

use std::fmt::Write as _;

use super::bindings::{self, Uniform};
use super::bundle;
use super::plain::Plain;
use crate::scene::{CHANNELS, Pass, PassKind, SamplerKind};

/// What the site puts first. The precision of samplers is the site's too.
const PRECISION: &str = "\
precision highp float;
precision highp int;
precision mediump sampler3D;
";

const IMAGE: &str = "\
void mainImage(out vec4 color, in vec2 coord);
out vec4 shadertoy_out_color;
void main() {
    vec4 color;
    mainImage(color, gl_FragCoord.xy);
    shadertoy_out_color = vec4(color.xyz, 1.0);
}
";

/// The same for a text with assertions, which paint the picture when they fail.
const IMAGE_WITH_ASSERTIONS: &str = "\
void mainImage(out vec4 color, in vec2 coord);
void st_assert(bool holds);
void st_assert(bool holds, int which);
out vec4 shadertoy_out_color;
vec4 shadertoy_failed = vec4(1.0);
void st_assert(bool holds, int which) {
    if (!holds) shadertoy_failed[clamp(which, 0, 3)] = -1.0;
}
void st_assert(bool holds) {
    st_assert(holds, 0);
}
void main() {
    vec4 color;
    mainImage(color, gl_FragCoord.xy);
    if (shadertoy_failed.x < 0.0) color = vec4(1.0, 0.0, 0.0, 1.0);
    if (shadertoy_failed.y < 0.0) color = vec4(0.0, 1.0, 0.0, 1.0);
    if (shadertoy_failed.z < 0.0) color = vec4(0.0, 0.0, 1.0, 1.0);
    if (shadertoy_failed.w < 0.0) color = vec4(1.0, 1.0, 0.0, 1.0);
    shadertoy_out_color = vec4(color.xyz, 1.0);
}
";

const BUFFER: &str = "\
void mainImage(out vec4 color, in vec2 coord);
out vec4 outColor;
void main() {
    mainImage(outColor, gl_FragCoord.xy);
}
";

/// The corners of the face that is drawn come first, counted around it; the eye is last.
const CUBE: &str = "\
void mainCubemap(out vec4 color, in vec2 coord, in vec3 origin, in vec3 direction);
uniform vec4 unViewport;
uniform vec3 unCorners[5];
out vec4 outColor;
void main() {
    vec2 coord = gl_FragCoord.xy - unViewport.xy;
    vec2 at = coord / unViewport.zw;
    vec3 below = mix(unCorners[0], unCorners[1], at.x);
    vec3 above = mix(unCorners[3], unCorners[2], at.x);
    vec3 origin = unCorners[4];
    mainCubemap(outColor, coord, origin, normalize(mix(below, above, at.y) - origin));
}
";

/// Samples lie in rows of 512. The site has them leave as bytes, 16 bits to each ear; here they leave as floats, so
/// that what is no number can be told, and become integers afterwards in the same way.
const SOUND: &str = "\
vec2 mainSound(in int samp, float time);
uniform float iTimeOffset;
uniform int iSampleOffset;
out vec4 outColor;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int samp = at.y * 512 + at.x;
    vec2 sound = mainSound(iSampleOffset + samp, iTimeOffset + float(samp) / iSampleRate);
    outColor = vec4(sound, 0.0, 1.0);
}
";

/// How many lines the site puts ahead of a pass, so that `__LINE__` is here what it is there: some
/// shaders make noise of it.
fn lines_before(kind: PassKind) -> usize {
    match kind {
        PassKind::Image => 41,
        PassKind::Buffer(_) => 24,
        PassKind::Cube => 33,
        PassKind::Sound => 25,
    }
}

/// The preamble of a pass, with no more of the site's declarations than the words in `texts` may need.
/// A plain fragment shader brings its own `main`, and no line of the site's.
pub(super) fn preamble(pass: &Pass, texts: &[&str], plain: Option<&Plain>) -> String {
    let customs = plain.map(Plain::preamble).unwrap_or_default();
    let all = texts.iter().copied().chain([&*customs]);
    let mentions = |word: &str| all.clone().any(|text| text.contains(word));
    let has_clock = pass.kind != PassKind::Sound;
    let bundles: [bool; CHANNELS] = std::array::from_fn(|channel| {
        pass.kind == PassKind::Image && mentions(&bundle::name(channel))
    });
    let mut text = PRECISION.to_owned();
    for uniform in Uniform::ALL {
        let needed = mentions(uniform.name())
            || match uniform {
                Uniform::SampleRate => pass.kind == PassKind::Sound,
                Uniform::ChannelResolution | Uniform::ChannelTime => bundles.contains(&true),
                _ => false,
            };
        if needed && (has_clock || uniform.is_for_sound()) {
            writeln!(text, "uniform {};", uniform.declaration()).expect("strings take all text");
        }
    }
    for (channel, is_bundled) in bundles.into_iter().enumerate() {
        let sampler = pass.channels[channel]
            .as_ref()
            .map_or(SamplerKind::TwoD, |channel| channel.input.sampler())
            .glsl();
        let name = bindings::channel_name(channel);
        if mentions(name) || is_bundled {
            writeln!(text, "uniform {sampler} {name};").expect("strings take all text");
        }
        if is_bundled {
            let bundle = bundle::name(channel);
            writeln!(
                text,
                "uniform struct {{ {sampler} sampler; vec3 size; float time; int loaded; }} {bundle};"
            )
            .expect("strings take all text");
        }
    }
    if plain.is_some() {
        return text + &customs;
    }
    text.push_str(match pass.kind {
        PassKind::Image if mentions("st_assert") => IMAGE_WITH_ASSERTIONS,
        PassKind::Image => IMAGE,
        PassKind::Buffer(_) => BUFFER,
        PassKind::Cube => CUBE,
        PassKind::Sound => SOUND,
    });
    // A line end follows each text, so that one of them need not be written.
    let lines = text.lines().count() + 1;
    let missing = lines_before(pass.kind).saturating_sub(lines);
    text.insert_str(0, &"\n".repeat(missing));
    text
}

/// The author's function that a pass begins in, with the parameters it must have.
pub(super) fn entry_point(kind: PassKind) -> (&'static str, &'static str) {
    match kind {
        PassKind::Image | PassKind::Buffer(_) => (
            "mainImage",
            "void mainImage(out vec4 fragColor, in vec2 fragCoord)",
        ),
        PassKind::Cube => (
            "mainCubemap",
            "void mainCubemap(out vec4 fragColor, in vec2 fragCoord, in vec3 rayOri, in vec3 rayDir)",
        ),
        PassKind::Sound => ("mainSound", "vec2 mainSound(int samp, float time)"),
    }
}
