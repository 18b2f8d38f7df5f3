//! Channels that the command line binds: `--channel [PASS.]N=FILE`.

use crate::support::{Folder, assert_claims, claims, gpu, read_png};

/// Writes a picture of one colour.
fn write_plain(folder: &Folder, name: &str, colour: [u8; 4]) {
    let picture = image::RgbaImage::from_pixel(3, 2, image::Rgba(colour));
    let path = folder.path().join(name);
    picture.save(path).expect("a picture can be written");
}

#[test]
fn a_channel_of_any_pass_can_be_bound() {
    let Some(_) = gpu() else { return };
    let these = [
        "round(255.0 * texture(iChannel0, vec2(0.5))) == vec4(10, 20, 30, 255)",
        "textureSize(iChannel0, 0) == ivec2(3, 2)",
        "iChannelResolution[1] == vec3(256, 3, 1)",
        "round(255.0 * texelFetch(iChannel2, ivec2(0), 0)) == vec4(40, 50, 60, 255)",
        "iChannelResolution[3] == vec3(256, 256, 1)",
    ];
    let folder = Folder::with("a/image.glsl", claims(&these));
    folder.write(
        "a/buffer_a.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel2, ivec2(0), 0); }",
    );
    folder.write(
        "a/scene.toml",
        "[buffer_a]\nsource = \"buffer_a.glsl\"\n\
         [image]\nsource = \"image.glsl\"\niChannel2 = { buffer = \"A\" }\n",
    );
    write_plain(&folder, "one.png", [10, 20, 30, 255]);
    write_plain(&folder, "two.png", [40, 50, 60, 255]);
    let channels =
        "--channel 0=one.png --channel image.1=keyboard --channel A.2=two.png --channel 3=noise";
    folder
        .run(&format!("export a {channels} --size 5x1 --out a.png"))
        .exits(0);
    assert_claims(&these, &read_png(&folder.path().join("a.png")));
}

#[test]
fn a_picture_takes_the_place_of_a_cubemap() {
    let Some(_) = gpu() else { return };
    let these = [
        "round(255.0 * texture(iChannel0, vec3(1, 0, 0)).x) == 10.0",
        "round(255.0 * texture(iChannel0, vec3(0, 0, -1)).x) == 60.0",
    ];
    let folder = Folder::with("image.glsl", claims(&these));
    folder.write(
        "scene.toml",
        "[image]\nsource = \"image.glsl\"\niChannel0 = { cubemap = \"Uffizi Gallery\" }\n",
    );
    for face in 0..6_u8 {
        let name = match face {
            0 => "sky.png".to_owned(),
            _ => format!("sky_{face}.png"),
        };
        let colour = image::Rgba([10 * (face + 1), 0, 0, 255]);
        let picture = image::RgbaImage::from_pixel(4, 4, colour);
        picture.save(folder.path().join(name)).expect("a picture");
    }
    folder
        .run("export . --channel 0=sky.png --size 2x1 --out a.png")
        .exits(0);
    assert_claims(&these, &read_png(&folder.path().join("a.png")));
}

#[test]
fn what_cannot_be_bound_is_said() {
    let Some(_) = gpu() else { return };
    let image = "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }";
    let folder = Folder::with("a.glsl", image);
    folder.write("notes.md", "");
    for (binding, code, words) in [
        ("clip.mp4", 2, "write it as N=FILE or PASS.N=FILE"),
        ("7=clip.mp4", 2, "there is no channel `7`, only 0 to 3"),
        ("0=clip.mp4", 1, "there is no such file"),
        ("0=notes.md", 1, "name a file that ends in one of png, jpg"),
        ("B.0=keyboard", 1, "the scene has no Buffer B"),
    ] {
        let outcome = folder.run(&format!("export a.glsl --channel {binding} --out a.png"));
        outcome.exits(code).says(words);
    }
    folder
        .run("export a.glsl --channel 0=keyboard --channel 1=mic --size 1x1 --out a.png")
        .exits(0)
        .says("Image: nothing reads iChannel1, which is bound to `mic`");
}

#[test]
fn a_scene_is_as_large_as_it_says() {
    let Some(_) = gpu() else { return };
    let folder = Folder::with(
        "image.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }",
    );
    folder.write(
        "scene.toml",
        "size = [6, 4]\n[image]\nsource = \"image.glsl\"\n",
    );
    let size = |arguments: &str| {
        let command = format!("export . --out a.png --overwrite {arguments}");
        folder.run(&command).exits(0);
        let picture = read_png(&folder.path().join("a.png"));
        (picture.size.x, picture.size.y)
    };
    assert_eq!(size(""), (6, 4));
    assert_eq!(size("--size 3x2"), (3, 2));
}
