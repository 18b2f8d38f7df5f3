//! Counts of verdicts.

use std::collections::BTreeMap;

use serde::Serialize;

use super::super::{HOST_FAILED, SCENE_HAS_PROBLEMS};
use super::verdict::{Judgement, Verdict};

/// How many scenes got which verdict.
#[derive(Debug, Default, Serialize)]
pub(super) struct Summary {
    files: usize,
    accepted: usize,
    /// Of those accepted.
    with_warnings: usize,
    refused: usize,
    /// Of those refused, by the code of the first error.
    codes: BTreeMap<String, usize>,
    unreadable: usize,
    cut_off: usize,
}

impl Summary {
    pub fn count(&mut self, judgement: &Judgement) {
        self.files += 1;
        self.with_warnings += usize::from(judgement.is_warned);
        match judgement.verdict {
            Verdict::Accept => self.accepted += 1,
            Verdict::CutOff => self.cut_off += 1,
            Verdict::Unreadable => self.unreadable += 1,
            Verdict::Refuse => {
                self.refused += 1;
                let code = judgement.code.clone().unwrap_or_default();
                *self.codes.entry(code).or_default() += 1;
            }
        }
    }

    pub fn exit_code(&self) -> u8 {
        if self.unreadable > 0 {
            HOST_FAILED
        } else if self.refused + self.cut_off > 0 {
            SCENE_HAS_PROBLEMS
        } else {
            0
        }
    }

    /// A table, the most frequent codes first.
    pub fn human(&self) -> String {
        let mut rows = vec![
            ("accepted", self.accepted),
            ("  with warnings", self.with_warnings),
            ("refused", self.refused),
        ];
        let indented = self.codes.iter().map(|(code, n)| (format!("  {code}"), *n));
        let mut codes: Vec<_> = indented.collect();
        codes.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        rows.extend(codes.iter().map(|(code, count)| (&**code, *count)));
        rows.push(("could not be read", self.unreadable));
        rows.push(("cut off", self.cut_off));
        rows.push(("all", self.files));
        let wide = rows.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        rows.iter()
            .map(|(name, count)| format!("{name:<wide$} {count:>7}\n"))
            .collect()
    }
}
