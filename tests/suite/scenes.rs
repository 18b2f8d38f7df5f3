//! The scenes that come with the program: each is drawn and held against a golden picture.

use std::collections::BTreeSet;
use std::fs;

use glam::UVec2;
use vitrine::frame::Clock;
use vitrine::scene::{self, Scene, Source};

use crate::support::{
    Tolerance, differing, draw, golden_picture, gpu, open, pasted, repository, scene_folders,
};

const SIZE: UVec2 = UVec2::new(96, 54);

/// Drivers round in their own ways, and a ray that just meets or just misses a ridge then lands
/// somewhere else: few pixels, but far off.
const TOLERANCE: Tolerance = Tolerance {
    levels: 2,
    share: 0.99,
};

/// The share of the pixels that must change in four seconds. The sky of `haze` is of one colour in its
/// seed, and fills half the picture.
fn least_movement(scene: &str) -> f64 {
    match scene {
        "haze" => 0.3,
        _ => 0.5,
    }
}

#[test]
fn every_scene_draws_its_golden_picture_and_moves() {
    let Some(gpu) = gpu() else { return };
    let mut problems = String::new();
    for (name, folder) in scene_folders() {
        let session = open(gpu, &Source::Path(folder));
        let at = |time| draw(gpu, &session, &Clock::fixed(60.0).at_time(time, SIZE));
        let picture = at(1.0);
        if let Err(problem) = golden_picture(&name, &picture, TOLERANCE) {
            problems += &problem;
        }
        let colours: BTreeSet<_> = picture.rgb.chunks(3).collect();
        if colours.len() < 200 {
            problems += &format!("{name}: only {} colours, nearly flat\n", colours.len());
        }
        let brightness = picture.rgb.iter().map(|&b| f64::from(b)).sum::<f64>();
        let mean = brightness / picture.rgb.len() as f64;
        if !(30.0..225.0).contains(&mean) {
            problems += &format!("{name}: the mean brightness is {mean:.0} of 255\n");
        }
        let moved = differing(&picture, &at(5.0));
        if (moved as f64) < least_movement(&name) * (picture.rgb.len() / 3) as f64 {
            problems += &format!("{name}: only {moved} pixels changed in four seconds\n");
        }
    }
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn every_golden_picture_belongs_to_a_scene() {
    let scenes = scene_folders()
        .into_iter()
        .map(|(name, _)| format!("{name}.png"));
    let goldens = fs::read_dir(repository("tests/goldens")).expect("the goldens");
    let goldens = goldens.map(|entry| entry.expect("an entry").file_name());
    assert_eq!(
        goldens
            .map(|name| name.to_string_lossy().into_owned())
            .collect::<BTreeSet<_>>(),
        scenes.collect::<BTreeSet<_>>()
    );
}

#[test]
fn the_template_pasted_as_one_text_draws_the_same_bytes() {
    let Some(gpu) = gpu() else { return };
    let text = fs::read_to_string(repository("tests/seeds/template.glsl")).expect("the seed");
    let input = Clock::fixed(60.0).at_time(1.0, SIZE);
    let one_text = draw(gpu, &open(gpu, &pasted(&text)), &input);
    let folder = Source::Path(repository("shadertoy/template"));
    assert_eq!(
        differing(&one_text, &draw(gpu, &open(gpu, &folder), &input)),
        0
    );
}

#[test]
fn the_embedded_scene_is_the_template_on_disk() {
    let embedded = scene::load(&Source::Embedded).expect("the embedded scene");
    let on_disk = Source::Path(repository("shadertoy/template"));
    let on_disk = scene::load(&on_disk).expect("the template");
    assert_eq!(embedded.name, on_disk.name);
    assert_eq!(texts(&embedded), texts(&on_disk));
    assert_eq!(embedded.image().channels, on_disk.image().channels);
}

fn texts(scene: &Scene) -> Vec<&str> {
    let sources = scene.image().sources.iter();
    sources
        .map(|&file| scene.files.get(file).text.as_str())
        .collect()
}
