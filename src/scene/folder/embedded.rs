//! The scene that the program carries with it.

use std::path::Path;

/// The folder of the embedded scene, as [`embedded`] spells it.
pub(in crate::scene) const EMBEDDED: &str = "template";

/// The text of an embedded file; `path` is relative to `shadertoy/`.
pub(in crate::scene) fn embedded(path: &Path) -> Option<&'static str> {
    macro_rules! table {
        ($($name:literal),* $(,)?) => {
            [$(($name, include_str!(concat!("../../../shadertoy/", $name)))),*]
        };
    }
    const FILES: &[(&str, &str)] = &table![
        "template/scene.toml",
        "common/settings.glsl",
        "common/hash.glsl",
        "common/noise.glsl",
        "common/fbm.glsl",
        "common/levels.glsl",
        "common/march.glsl",
        "common/normal.glsl",
        "common/shadow.glsl",
        "common/material.glsl",
        "common/lighting.glsl",
        "common/atmosphere.glsl",
        "common/path.glsl",
        "common/camera.glsl",
        "template/image.glsl",
    ];
    FILES
        .iter()
        .find(|(name, _)| Path::new(name) == path)
        .map(|(_, text)| *text)
}
