//! GLSL that WebGL2 refuses, and what its author reads. Each file in `tests/glsl/refuse` has one
//! thing wrong, its first line says which; the `.txt` beside it is the message of a strict
//! translation. Adding a test is adding a file there and running with `BLESS=1`.

use crate::support::{Case, cases, golden_text, left_over, on_every_core, plain, unfit_for_people};

const FOLDER: &str = "tests/glsl/refuse";

fn problem(case: &Case) -> String {
    let name = format!("{}.txt", case.name);
    let Err(report) = case.translated(true) else {
        return format!("{}.glsl is accepted\n", case.name);
    };
    let text = plain(&report);
    let snapshot = golden_text(&format!("{FOLDER}/{name}"), &text);
    snapshot.err().unwrap_or_default() + &unfit_for_people(&name, &text)
}

#[test]
fn every_file_is_refused_with_its_message() {
    let problems = on_every_core(&cases(FOLDER), problem).concat();
    assert!(problems.is_empty(), "\n{problems}");
}

#[test]
fn every_message_belongs_to_a_file() {
    let stems = cases(FOLDER).into_iter().map(|case| case.name).collect();
    let problems = left_over(FOLDER, &stems);
    assert!(problems.is_empty(), "\n{problems}");
}
