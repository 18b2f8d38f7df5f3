//! Rules for every text that is kept as the expected message of a scene.

use std::collections::BTreeSet;
use std::fs;

use super::repository;

/// Words that belong to the translator's insides. An author cannot do anything with them.
const INSIDES: [&str; 7] = [
    "vitrine_", "Some(", "Handle", "Scalar {", "LHS", "naga", "panicked",
];

/// Messages are for people and are given once. The result says what is against that, one line for
/// each complaint; it is empty when all is well.
pub fn unfit_for_people(name: &str, text: &str) -> String {
    let mut problems = String::new();
    for words in INSIDES.iter().filter(|words| text.contains(**words)) {
        problems += &format!("{name} speaks of `{words}`\n");
    }
    // The same may be wrong in two places, which then follow.
    let lines: Vec<&str> = text.lines().collect();
    let is_title = |line: &str| line.starts_with("error") || line.starts_with("warning");
    let titles = lines.windows(2).filter(|pair| is_title(pair[0]));
    let titles: Vec<_> = titles.collect();
    if titles.iter().collect::<BTreeSet<_>>().len() < titles.len() {
        problems += &format!("{name} repeats itself\n");
    }
    problems
}

/// The files of a folder that belong to none of its scenes, whose names without ending are `stems`:
/// one line for each.
pub fn left_over(folder: &str, stems: &BTreeSet<String>) -> String {
    let mut problems = String::new();
    for entry in fs::read_dir(repository(folder)).expect("the folder") {
        let path = entry.expect("an entry").path();
        let stem = path.file_stem().expect("a name").to_string_lossy();
        if !stem.starts_with('.') && !stems.contains(stem.as_ref()) {
            problems += &format!("{} is left over\n", path.display());
        }
    }
    problems
}
