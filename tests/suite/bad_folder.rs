//! What a folder gets whose manifest is wrong: the place in it, the way out, exit code 1, no file.

use crate::bad_input::{GOOD, refused};
use crate::support::Folder;

/// Expects a folder with a good `image.glsl` and this manifest to be refused, at this place.
#[track_caller]
fn manifest_refused(manifest: &str, place: &str, words: &[&str]) {
    let folder = Folder::with("a/image.glsl", GOOD);
    folder.write("a/scene.toml", manifest);
    let place = format!("a/scene.toml:{place}");
    let always = ["error[manifest]: ", "help: ", &place];
    refused(&folder, "a", 1, &[words, &always].concat());
}

#[test]
fn a_folder_without_a_scene() {
    let folder = Folder::with("a/notes.txt", "nothing to draw");
    let message = "error[no-scene]: the folder `a` holds no scene";
    refused(
        &folder,
        "a",
        1,
        &[message, "`scene.toml`, or an `image.glsl`"],
    );
}

#[test]
fn an_unknown_key() {
    let manifest = "[image]\nsource = \"image.glsl\"\niChanel0 = { procedural = \"noise\" }\n";
    manifest_refused(
        manifest,
        "3:1",
        &["unknown field `iChanel0`", "`iChannel0`"],
    );
}

#[test]
fn an_unknown_value() {
    let channel = "iChannel0 = { procedural = \"noise\", filter = \"cubic\" }";
    let manifest = format!("[image]\nsource = \"image.glsl\"\n{channel}\n");
    manifest_refused(
        &manifest,
        "3:46",
        &["`cubic`", "`nearest`, `linear`, `mipmap`"],
    );
}

#[test]
fn no_toml() {
    manifest_refused("[image\nsource = \"image.glsl\"\n", "1:7", &[]);
}

#[test]
fn a_missing_image() {
    manifest_refused("name = \"Hills\"\n", "1:1", &["missing field `image`"]);
    manifest_refused("", "1:1", &["missing field `image`"]);
}

#[test]
fn a_missing_file() {
    let manifest = "common = [\"gone.glsl\"]\n[image]\nsource = \"image.glsl\"\n";
    let message = "there is no file `a/gone.glsl`";
    manifest_refused(manifest, "1:11", &[message, "paths are relative"]);
}

#[test]
fn a_missing_file_of_the_customary_name() {
    let manifest = "[image]\n[buffer_a]\niChannel0 = { buffer = \"A\" }\n";
    let message = "there is no file `a/buffer_a.glsl`";
    manifest_refused(manifest, "2:1", &[message]);
}

#[test]
fn a_folder_for_a_file() {
    manifest_refused("[image]\nsource = \".\"\n", "2:10", &[]);
    manifest_refused("[image]\nsource = \"\"\n", "2:10", &[]);
}

#[test]
fn a_file_outside() {
    let hint = "name a file in the scene folder or in a folder beside it";
    let manifest = "[image]\nsource = \"/etc/hostname\"\n";
    manifest_refused(manifest, "2:10", &["lies outside the scene", hint]);

    let folder = Folder::with("secret.txt", GOOD);
    folder.write(
        "deep/a/scene.toml",
        "[image]\nsource = \"../../secret.txt\"\n",
    );
    let message = "`../../secret.txt` lies outside the scene";
    refused(&folder, "deep/a", 1, &[message, "deep/a/scene.toml:2:10"]);
}

#[cfg(unix)]
#[test]
fn a_file_outside_behind_a_link() {
    let folder = Folder::with("secret.txt", GOOD);
    folder.write("deep/a/scene.toml", "[image]\nsource = \"image.glsl\"\n");
    let link = folder.path().join("deep/a/image.glsl");
    std::os::unix::fs::symlink("../../secret.txt", link).expect("a link");
    refused(
        &folder,
        "deep/a",
        1,
        &["`image.glsl` lies outside the scene"],
    );
}

#[test]
fn a_manifest_that_names_one_large_file_again_and_again() {
    let folder = Folder::with("a/image.glsl", GOOD);
    folder.write("a/large.glsl", "// filler\n".repeat(1 << 20));
    let common = "\"large.glsl\", ".repeat(1000);
    let manifest = format!("common = [{common}]\n[image]\nsource = \"image.glsl\"\n");
    folder.write("a/scene.toml", manifest);
    refused(
        &folder,
        "a",
        1,
        &["text is larger than 8 MiB", "a/large.glsl"],
    );
}

#[test]
fn a_channel_that_is_bound_to_two_things() {
    manifest_refused(
        "[image]\nsource = \"image.glsl\"\niChannel0 = { procedural = \"noise\", buffer = \"A\" }\n",
        "3:13",
        &["bound to one thing"],
    );
    manifest_refused(
        "[image]\nsource = \"image.glsl\"\niChannel0 = { filter = \"linear\" }\n",
        "3:13",
        &["bound to one thing"],
    );
}

#[test]
fn a_buffer_that_is_none() {
    manifest_refused(
        "[image]\nsource = \"image.glsl\"\niChannel0 = { buffer = \"E\" }\n",
        "3:24",
        &["unknown variant `E`"],
    );
}

#[test]
fn an_order_of_buffers_that_are_not_there() {
    manifest_refused(
        "order = [\"B\"]\n[image]\nsource = \"image.glsl\"\n[buffer_a]\nsource = \"image.glsl\"\n",
        "1:9",
        &["`order` does not name each buffer"],
    );
}
