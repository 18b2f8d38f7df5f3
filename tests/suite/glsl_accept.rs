//! GLSL that WebGL2 runs, and the picture that comes of it. Each file in `tests/glsl/accept` has one
//! subject; its header says the picture (`support/expected.rs` has the format). Adding a test is
//! adding a file.
//!
//! All files are translated strictly: what WebGL2 accepts is no reason even for a warning.

use crate::support::{Drawing, cases, on_every_core};

#[test]
fn every_file_draws_its_picture() {
    let Some(drawing) = Drawing::new() else {
        return;
    };
    let cases = cases("tests/glsl/accept");
    let problems = on_every_core(&cases, |case| {
        drawing
            .is_as_expected(case, true)
            .err()
            .map(|problem| format!("{}: {problem}\n", case.name))
    });
    let problems: Vec<_> = problems.into_iter().flatten().collect();
    assert!(
        problems.is_empty(),
        "{} of {} files fail:\n{}",
        problems.len(),
        cases.len(),
        problems.concat()
    );
}
