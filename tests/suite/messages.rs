//! What the author of a broken scene reads. Each file and each folder in `tests/messages` is a scene
//! with one thing wrong; the `.txt` beside it is what `check` prints, a `.json` what it prints for
//! tools. Adding a message test is adding a scene there and running with `BLESS=1`.

use std::fs;

use crate::support::{golden_text, left_over, repository, unfit_for_people, vitrine};

const FOLDER: &str = "tests/messages";

/// The names of the folder's entries that are scenes, sorted.
fn cases() -> Vec<String> {
    let entries = fs::read_dir(repository(FOLDER)).expect("the messages");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let scenes =
        paths.filter(|path| path.is_dir() || path.extension().is_some_and(|e| e == "glsl"));
    let mut names: Vec<_> = scenes
        .map(|path| {
            path.file_name()
                .expect("a name")
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    names.sort();
    names
}

#[test]
fn every_broken_scene_says_what_it_should() {
    let mut problems = String::new();
    for case in cases() {
        let outcome = vitrine("check").arg(&case).within(repository(FOLDER)).run();
        if outcome.code != Some(1) || !outcome.stdout.is_empty() {
            problems += &format!("{case} exits with {:?}\n", outcome.code);
        }
        let stem = case.trim_end_matches(".glsl");
        if let Err(problem) = golden_text(&format!("{FOLDER}/{stem}.txt"), &outcome.stderr) {
            problems += &problem;
        }
    }
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn tools_are_told_the_same() {
    let mut problems = String::new();
    for case in [
        "missing_semicolon.glsl",
        "tab_and_umlaut.glsl",
        "error_in_common",
        "no_scene",
    ] {
        let outcome = vitrine("check --format json")
            .arg(case)
            .within(repository(FOLDER))
            .run();
        assert_eq!(outcome.code, Some(1), "{case}");
        let stem = case.trim_end_matches(".glsl");
        if let Err(problem) = golden_text(&format!("{FOLDER}/{stem}.json"), &outcome.text()) {
            problems += &problem;
        }
    }
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn every_expected_message_belongs_to_a_scene() {
    let stems = cases()
        .iter()
        .map(|case| case.trim_end_matches(".glsl").to_owned())
        .collect();
    let problems = left_over(FOLDER, &stems);
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn messages_are_for_people_and_are_given_once() {
    let mut problems = String::new();
    for case in cases() {
        let stem = case.trim_end_matches(".glsl");
        let path = repository(FOLDER).join(format!("{stem}.txt"));
        let text = fs::read_to_string(path).expect("an expected message");
        problems += &unfit_for_people(&format!("{stem}.txt"), &text);
    }
    assert!(problems.is_empty(), "\n{problems}");
}
