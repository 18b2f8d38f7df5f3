//! GLSL that WebGL2 takes, but that deserves a look. Each file in `tests/glsl/warn` has something that
//! runs and is undefined or surprises; the `.txt` beside it are the warnings, also of a strict
//! translation. Adding a test is adding a file there and running with `BLESS=1`.

use crate::support::{Case, cases, golden_text, left_over, on_every_core, unfit_for_people};

const FOLDER: &str = "tests/glsl/warn";

fn problem(case: &Case) -> String {
    let name = format!("{}.txt", case.name);
    let [lenient, strict] = [false, true].map(|strict| case.warnings(strict));
    if lenient != strict {
        return format!("{name} differs in a strict translation: {strict:?}\n");
    }
    let lenient = match lenient {
        Ok(warnings) => warnings,
        Err(report) => return format!("{}.glsl is refused\n{report}", case.name),
    };
    if lenient.is_empty() {
        return format!("{}.glsl has no warning\n", case.name);
    }
    let snapshot = golden_text(&format!("{FOLDER}/{name}"), &lenient);
    snapshot.err().unwrap_or_default() + &unfit_for_people(&name, &lenient)
}

#[test]
fn every_file_has_its_warnings() {
    let problems = on_every_core(&cases(FOLDER), problem).concat();
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn every_warning_belongs_to_a_file() {
    let stems = cases(FOLDER).into_iter().map(|case| case.name).collect();
    let problems = left_over(FOLDER, &stems);
    assert!(problems.is_empty(), "\n{problems}");
}
