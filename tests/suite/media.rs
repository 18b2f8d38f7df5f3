//! Pictures, cubemaps, volumes and sounds behind channels, held against values computed by hand.

use glam::UVec2;
use vitrine::frame::Clock;
use vitrine::scene::Source;

use crate::support::{Folder, assert_claims, claims, draw, gpu, open};

/// Writes a picture; texels are red, green, blue and alpha, its top row first.
fn write_picture(
    folder: &Folder,
    name: &str,
    width: u32,
    height: u32,
    texel: impl Fn(u32, u32) -> [u8; 4],
) {
    let picture = image::RgbaImage::from_fn(width, height, |x, y| image::Rgba(texel(x, y)));
    picture
        .save(folder.path().join(name))
        .expect("a picture can be written");
}

/// A scene folder whose Image pass makes these claims, with this in its manifest behind the pass's source.
fn scene(these: &[&str], channels: &str) -> Folder {
    let folder = Folder::with("image.glsl", claims(these));
    folder.write(
        "scene.toml",
        format!("[image]\nsource = \"image.glsl\"\n{channels}\n"),
    );
    folder
}

fn assert_hold(these: &[&str], folder: &Folder) {
    let Some(gpu) = gpu() else { return };
    let session = open(gpu, &Source::Path(folder.path().to_owned()));
    let input = Clock::fixed(60.0).at(0, UVec2::new(these.len() as u32, 1));
    assert_claims(these, &draw(gpu, &session, &input));
}

/// Red counts columns, green rows from the top.
fn counted(x: u32, y: u32) -> [u8; 4] {
    [10 * x as u8, 10 * y as u8, 7, 200]
}

#[test]
fn vflip_decides_which_row_of_a_picture_is_the_first() {
    let these = [
        "round(255.0 * texelFetch(iChannel0, ivec2(1, 0), 0)) == vec4(10, 10, 7, 200)",
        "round(255.0 * texelFetch(iChannel1, ivec2(1, 0), 0)) == vec4(10, 0, 7, 200)",
        "textureSize(iChannel0, 0) == ivec2(3, 2)",
        "iChannelResolution[0] == vec3(3, 2, 1)",
        "iChannelResolution[2] == vec3(0)",
        "texture(iChannel2, vec2(0.5)) == vec4(0, 0, 0, 1)",
    ];
    let folder = scene(
        &these,
        "iChannel0 = { texture = \"a.png\" }\niChannel1 = { texture = \"a.png\", vflip = false }",
    );
    write_picture(&folder, "a.png", 3, 2, counted);
    assert_hold(&these, &folder);
}

#[test]
fn filter_and_wrap_are_the_channels_own() {
    let these = [
        // Columns are 0 and 200: halfway, and beyond the right edge.
        "abs(textureLod(iChannel0, vec2(0.5, 0.5), 0.0).x * 255.0 - 100.0) < 1.1",
        "round(textureLod(iChannel1, vec2(0.51, 0.5), 0.0).x * 255.0) == 200.0",
        "textureLod(iChannel1, vec2(1.1, 0.5), 0.0).x == 0.0",
        "round(textureLod(iChannel3, vec2(1.1, 0.5), 0.0).x * 255.0) == 200.0",
        "round(textureLod(iChannel3, vec2(1.9, 0.5), 0.0).x * 255.0) == 0.0",
        "round(textureLod(iChannel2, vec2(1.1, 0.5), 0.0).x * 255.0) == 200.0",
        // The smallest level is the mean; without mipmaps there is none.
        "abs(textureLod(iChannel0, vec2(0.1, 0.5), 9.0).x * 255.0 - 100.0) < 1.1",
        "textureLod(iChannel2, vec2(0.1, 0.5), 9.0).x == 0.0",
    ];
    let folder = scene(
        &these,
        "iChannel0 = { texture = \"a.png\" }\n\
         iChannel1 = { texture = \"a.png\", filter = \"nearest\" }\n\
         iChannel2 = { texture = \"a.png\", filter = \"linear\", wrap = \"clamp\" }\n\
         iChannel3 = { texture = \"a.png\", filter = \"nearest\", wrap = \"mirror\" }",
    );
    write_picture(&folder, "a.png", 2, 2, |x, _| [200 * x as u8, 0, 0, 255]);
    assert_hold(&these, &folder);
}

#[test]
fn the_sites_grey_pictures_have_one_channel() {
    let Some(_) = gpu() else { return };
    let these = ["round(255.0 * texelFetch(iChannel0, ivec2(0), 0)) == vec4(51, 0, 0, 255)"];
    let folder = scene(&these, "iChannel0 = { texture = \"Bayer\" }");
    std::fs::create_dir(folder.path().join("copies")).expect("a folder");
    write_picture(&folder, "copies/bayer.png", 8, 8, |_, _| [51, 51, 51, 255]);
    folder
        .run("export . --media copies --size 1x1 --out a.png")
        .exits(0);
    let picture = crate::support::read_png(&folder.path().join("a.png"));
    assert_claims(&these, &picture);
}

/// Each face has its number from 1 to 6 in red, and its first row is green.
fn face(number: usize) -> impl Fn(u32, u32) -> [u8; 4] {
    move |_, y| [number as u8, if y == 0 { 255 } else { 0 }, 0, 255]
}

#[test]
fn a_cubemap_has_its_faces_where_gl_has_them() {
    let these = [
        "round(255.0 * texture(iChannel0, vec3(1, 0, 0)).x) == 1.0",
        "round(255.0 * texture(iChannel0, vec3(-1, 0, 0)).x) == 2.0",
        "round(255.0 * texture(iChannel0, vec3(0, 1, 0)).x) == 3.0",
        "round(255.0 * texture(iChannel0, vec3(0, -1, 0)).x) == 4.0",
        "round(255.0 * texture(iChannel0, vec3(0, 0, 1)).x) == 5.0",
        "round(255.0 * texture(iChannel0, vec3(0, 0, -1)).x) == 6.0",
        // The first row of a face on the side is its upper one.
        "texture(iChannel0, vec3(1, 0.9, 0)).y == 1.0",
        "texture(iChannel0, vec3(1, -0.9, 0)).y == 0.0",
        // Flipped, what was above is below, and faces stand on their heads.
        "round(255.0 * texture(iChannel1, vec3(0, 1, 0)).x) == 4.0",
        "texture(iChannel1, vec3(1, -0.9, 0)).y == 1.0",
        "iChannelResolution[0] == vec3(0)",
    ];
    let folder = scene(
        &these,
        "iChannel0 = { cubemap = \"sky.png\", filter = \"nearest\" }\n\
         iChannel1 = { cubemap = \"sky.png\", filter = \"nearest\", vflip = true }",
    );
    for number in 0..6 {
        let name = if number == 0 {
            "sky.png".to_owned()
        } else {
            format!("sky_{number}.png")
        };
        write_picture(&folder, &name, 4, 4, face(number + 1));
    }
    assert_hold(&these, &folder);
}

#[test]
fn the_cubemap_that_a_pass_draws_is_seen_where_it_was_drawn() {
    let these = [
        "distance(texture(iChannel0, vec3(1, 0.5, -0.25)).xyz, normalize(vec3(1, 0.5, -0.25))) < 0.003",
        "distance(texture(iChannel0, vec3(-1, 0.5, 0.75)).xyz, normalize(vec3(-1, 0.5, 0.75))) < 0.003",
        "distance(texture(iChannel0, vec3(0.5, 1, 0.25)).xyz, normalize(vec3(0.5, 1, 0.25))) < 0.003",
        "distance(texture(iChannel0, vec3(0.5, -1, 0.25)).xyz, normalize(vec3(0.5, -1, 0.25))) < 0.003",
        "distance(texture(iChannel0, vec3(0.5, 0.25, 1)).xyz, normalize(vec3(0.5, 0.25, 1))) < 0.003",
        "distance(texture(iChannel0, vec3(0.5, 0.25, -1)).xyz, normalize(vec3(0.5, 0.25, -1))) < 0.003",
        // It has all of `fragCoord`, and its own resolution.
        "abs(texture(iChannel0, vec3(1, 0, 0)).w - 512.0) < 1.0",
        "iChannelResolution[0] == vec3(1024, 1024, 1)",
        // This frame's, because it is drawn before.
        "texture(iChannel0, vec3(1, 0, 0)).x > 0.9",
    ];
    let folder = scene(
        &these,
        "iChannel0 = { cube = true, filter = \"linear\" }\n[cube_a]\nsource = \"cube_a.glsl\"",
    );
    folder.write(
        "cube_a.glsl",
        "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) {\n\
             c = vec4(o + d, iResolution.x == 1024.0 ? p.x : -1.0);\n\
         }",
    );
    assert_hold(&these, &folder);
}

#[test]
fn a_volume_counts_across_up_and_inward() {
    let these = [
        "round(255.0 * texelFetch(iChannel0, ivec3(1, 0, 0), 0)) == vec4(1, 0, 0, 255)",
        "round(255.0 * texelFetch(iChannel0, ivec3(0, 1, 0), 0).x) == 2.0",
        "round(255.0 * texelFetch(iChannel0, ivec3(0, 0, 2), 0).x) == 8.0",
        "textureSize(iChannel0, 0) == ivec3(2, 2, 3)",
        "iChannelResolution[0] == vec3(2, 2, 3)",
        "round(255.0 * textureLod(iChannel0, vec3(1.25, 0.25, 0.2), 0.0).x) == 0.0",
        // The next level has one texel, the mean of all twelve; devices round as they please.
        "textureSize(iChannel1, 1) == ivec3(1)",
        "abs(255.0 * textureLod(iChannel1, vec3(0.3), 1.0).x - 5.5) < 1.1",
    ];
    let folder = scene(
        &these,
        "iChannel0 = { volume = \"v.bin\", filter = \"nearest\" }\niChannel1 = { volume = \"v.bin\" }",
    );
    let mut bytes = b"BIN\0".to_vec();
    [2_u32, 2, 3]
        .iter()
        .for_each(|side| bytes.extend(side.to_le_bytes()));
    bytes.extend([1, 0, 0, 0]);
    bytes.extend(0..12);
    folder.write("v.bin", bytes);
    assert_hold(&these, &folder);
}

#[test]
fn music_is_a_spectrum_above_a_waveform_and_tells_how_far_it_has_played() {
    let these = [
        "iChannelResolution[0] == vec3(512, 2, 1)",
        "iChannelTime[0] == 1.0",
        // A sine of 100 of the transform's steps, a third of what is loud.
        "texelFetch(iChannel0, ivec2(100, 0), 0).x > texelFetch(iChannel0, ivec2(110, 0), 0).x + 0.3",
        "texelFetch(iChannel0, ivec2(400, 0), 0).x < 0.1",
        "texelFetch(iChannel0, ivec2(3, 1), 0).yzw == vec3(0, 0, 1)",
        "iChannelTime[1] == 0.0",
    ];
    let folder = scene(&these, "iChannel0 = { music = \"sine.wav\" }");
    let spec = hound::WavSpec {
        channels: 1,
        sample_rate: 44_100,
        bits_per_sample: 16,
        sample_format: hound::SampleFormat::Int,
    };
    let mut wav = hound::WavWriter::create(folder.path().join("sine.wav"), spec).expect("a file");
    for sample in 0..2 * 44_100 {
        let turns = f64::from(sample) * 100.0 / 2048.0;
        wav.write_sample((10_000.0 * (turns * std::f64::consts::TAU).sin()) as i16)
            .expect("room");
    }
    wav.finalize().expect("room");
    let Some(gpu) = gpu() else { return };
    let session = open(gpu, &Source::Path(folder.path().to_owned()));
    let input = Clock::fixed(60.0).at(60, UVec2::new(these.len() as u32, 1));
    assert_claims(&these, &draw(gpu, &session, &input));
}

/// A white picture with this sound.
fn with_sound(text: &str) -> Folder {
    let image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }";
    let folder = Folder::with("image.glsl", image);
    folder.write("sound.glsl", text);
    folder
}

/// All samples, left and right in turn.
fn floats(wav: &mut hound::WavReader<impl std::io::Read>) -> Vec<f32> {
    wav.samples()
        .map(|sample| sample.expect("a float"))
        .collect()
}

#[test]
fn the_samples_of_a_sound_are_what_the_shader_computes() {
    let Some(_) = gpu() else { return };
    let folder = with_sound(
        "vec2 mainSound(int n, float t) {\n\
             if (n == 1000) return vec2(sqrt(t - 100.0), 0.5);\n\
             return vec2(float(n % 441) / 441.0, t / 10.0);\n\
         }",
    );
    folder
        .run("export . --sound s.wav --sound-format float --seconds 7")
        .exits(0)
        .says("1 samples are no numbers");
    let mut wav = hound::WavReader::open(folder.path().join("s.wav")).expect("a sound");
    assert_eq!((wav.spec().sample_rate, wav.spec().channels), (44_100, 2));
    let samples = floats(&mut wav);
    assert_eq!(samples.len(), 2 * 7 * 44_100);
    // Blocks meet at 262,144 samples.
    for n in [0_usize, 1, 440, 441, 999, 262_143, 262_144, 300_000] {
        let (left, right) = ((n % 441) as f32 / 441.0, n as f32 / 441_000.0);
        assert!(
            (samples[2 * n] - left).abs() < 1e-6,
            "left of {n}: {}",
            samples[2 * n]
        );
        assert!(
            (samples[2 * n + 1] - right).abs() < 1e-6,
            "right of {n}: {}",
            samples[2 * n + 1]
        );
    }
    assert_eq!(samples[2000..2002], [0.0, 0.5]);
    folder
        .run("export . --sound s.wav --seconds 1")
        .exits(2)
        .says("exists already");
    folder
        .run("export . --sound part.wav --frames 60..90 --fps 30")
        .exits(0)
        .says("1.0 s of sound");
    let mut part = hound::WavReader::open(folder.path().join("part.wav")).expect("a sound");
    let first = part
        .samples::<i16>()
        .nth(1)
        .expect("a sample")
        .expect("an integer");
    assert!((f32::from(first) / 32_768.0 - 0.2).abs() < 1e-4, "{first}");
}

#[test]
fn a_sound_reads_pictures_and_no_keys() {
    let Some(_) = gpu() else { return };
    let folder = with_sound(
        "vec2 mainSound(int n, float t) {\n\
             return vec2(texelFetch(iChannel0, ivec2(1, 1), 0).x, texelFetch(iChannel1, ivec2(1, 1), 0).w / 2.0);\n\
         }",
    );
    folder.write(
        "scene.toml",
        "[sound]\nsource = \"sound.glsl\"\niChannel0 = { texture = \"a.png\" }\niChannel1 = { keyboard = true }\n\
         [image]\nsource = \"image.glsl\"\n",
    );
    write_picture(&folder, "a.png", 2, 2, |_, _| [51, 0, 0, 255]);
    folder
        .run("export . --sound s.wav --sound-format float --seconds 0.001")
        .exits(0);
    let mut wav = hound::WavReader::open(folder.path().join("s.wav")).expect("a sound");
    let samples = floats(&mut wav);
    assert!((samples[0] - 0.2).abs() < 1e-6, "{}", samples[0]);
    assert_eq!(samples[1], 0.5, "what is unbound is opaque black");
}

#[test]
fn a_scene_without_a_sound_has_none_to_export() {
    let Some(_) = gpu() else { return };
    let folder = Folder::with(
        "a.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }",
    );
    folder
        .run("export a.glsl --sound s.wav")
        .exits(2)
        .says("has no Sound pass");
    assert_eq!(folder.files(), ["a.glsl"]);
}

#[test]
fn what_is_no_picture_is_said_with_file_and_pass() {
    let Some(_) = gpu() else { return };
    let image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(textureSize(iChannel0, 0).x); }";
    let folder = Folder::with("image.glsl", image);
    let bind = |what: &str| {
        folder.write(
            "scene.toml",
            format!("[image]\nsource = \"image.glsl\"\niChannel0 = {{ {what} }}\n"),
        );
    };
    let mut huge = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec();
    huge.extend([100_000_u32.to_be_bytes(), 100_000_u32.to_be_bytes()].concat());
    huge.extend([8, 6, 0, 0, 0, 0x7d, 0x0c, 0x6f, 0x2b]);
    for (name, content, binding, words) in [
        (
            "a.png",
            b"no picture".to_vec(),
            "texture = \"a.png\"",
            "is no picture",
        ),
        ("huge.png", huge, "texture = \"huge.png\"", "huge.png` "),
        (
            "v.bin",
            b"BIN\0\x02\0\0\0\x02\0\0\0\x02\0\0\0\x01\0\0\0abc".to_vec(),
            "volume = \"v.bin\"",
            "3 of 8 bytes",
        ),
        (
            "s.mp3",
            b"no sound".to_vec(),
            "music = \"s.mp3\"",
            "is no sound",
        ),
    ] {
        folder.write(name, content);
        bind(binding);
        folder
            .run("export . --size 4x4 --out a-picture.png")
            .exits(1)
            .says("error[media]: iChannel0 of Image: ")
            .says(name)
            .says(words);
    }
}

#[test]
fn a_stand_in_shows_something_and_can_be_left_away() {
    let Some(_) = gpu() else { return };
    let image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(texelFetch(iChannel0, ivec2(p), 0).xyz, 1); }";
    let folder = scene(&[], "iChannel0 = { texture = \"RGBA Noise Small\" }");
    folder.write("image.glsl", image);
    folder.run("export . --size 64x64 --out a.png").exits(0);
    folder
        .run("export . --size 64x64 --out b.png --no-stand-ins")
        .exits(0);
    let read = |name| crate::support::read_png(&folder.path().join(name)).rgb;
    assert!(read("b.png").iter().all(|&byte| byte == 0));
    let noise = read("a.png");
    let mean = noise.iter().map(|&byte| f64::from(byte)).sum::<f64>() / noise.len() as f64;
    assert!((mean - 127.5).abs() < 4.0, "{mean}");
}
