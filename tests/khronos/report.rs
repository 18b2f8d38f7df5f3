//! What came of the cases, and how it is told.

use std::fmt;

/// What came of a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It was not tried, for this reason.
    Skipped(&'static str),
    /// The fragment shader does what it must.
    Passed,
    /// The fragment shader is refused as it must be, with this complaint.
    Refused(String),
    /// The fragment shader fails to do what it must.
    Failed(String),
    /// The fragment shader should be refused.
    WronglyAccepted(String),
}

/// How many cases came to what.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    passed: usize,
    failed: usize,
    refused: usize,
    wrongly_accepted: usize,
    skipped: usize,
}

impl Tally {
    /// Counts a case.
    pub fn add(&mut self, outcome: &Outcome) {
        *match outcome {
            Outcome::Skipped(_) => &mut self.skipped,
            Outcome::Passed => &mut self.passed,
            Outcome::Failed(_) => &mut self.failed,
            Outcome::Refused(_) => &mut self.refused,
            Outcome::WronglyAccepted(_) => &mut self.wrongly_accepted,
        } += 1;
    }

    /// Counts the cases of another.
    pub fn join(&mut self, other: Tally) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.refused += other.refused;
        self.wrongly_accepted += other.wrongly_accepted;
        self.skipped += other.skipped;
    }

    /// How many cases are not as they should be.
    pub fn failures(&self) -> usize {
        self.failed + self.wrongly_accepted
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let runs = format!("{}/{} pass", self.passed, self.passed + self.failed);
        let refused = self.refused + self.wrongly_accepted;
        let refusals = format!("{}/{refused} rightly refused", self.refused);
        write!(f, "{runs:>15}  {refusals:>25}  {:>4} skipped", self.skipped)
    }
}
