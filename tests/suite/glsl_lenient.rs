//! GLSL that WebGL2 refuses and Vitrine runs all the same, with a warning: nothing is unclear about
//! what it means. Each file in `tests/glsl/lenient` has one such thing; its header says the picture
//! (`support/expected.rs` has the format) and the `.txt` beside it is the warning. A strict
//! translation refuses them all. Adding a test is adding a file there and running with `BLESS=1`.

use crate::support::{Case, cases, golden_text, left_over, on_every_core, unfit_for_people};

const FOLDER: &str = "tests/glsl/lenient";

fn problem(case: &Case) -> String {
    let name = format!("{}.txt", case.name);
    let warnings = match case.warnings(false) {
        Ok(warnings) => warnings,
        Err(report) => return format!("{}.glsl is refused\n{report}", case.name),
    };
    if warnings.is_empty() {
        return format!("{}.glsl is accepted without a warning\n", case.name);
    }
    let snapshot = golden_text(&format!("{FOLDER}/{name}"), &warnings);
    snapshot.err().unwrap_or_default() + &unfit_for_people(&name, &warnings)
}

#[test]
fn every_file_runs_with_its_warning() {
    let problems = on_every_core(&cases(FOLDER), problem).concat();
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn a_strict_translation_refuses_every_file() {
    let accepted = on_every_core(&cases(FOLDER), |case| match case.translated(true) {
        Ok(_) => format!("{}.glsl\n", case.name),
        Err(_) => String::new(),
    })
    .concat();
    assert!(accepted.is_empty(), "these are accepted:\n{accepted}");
}

#[cfg(feature = "gpu")]
#[test]
fn every_file_draws_its_picture() {
    let Some(drawing) = crate::support::Drawing::new() else {
        return;
    };
    let problems = on_every_core(&cases(FOLDER), |case| {
        match drawing.is_as_expected(case, false) {
            Ok(()) => String::new(),
            Err(problem) => format!("{}: {problem}\n", case.name),
        }
    })
    .concat();
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn every_warning_belongs_to_a_file() {
    let stems = cases(FOLDER).into_iter().map(|case| case.name).collect();
    let problems = left_over(FOLDER, &stems);
    assert!(problems.is_empty(), "\n{problems}");
}
