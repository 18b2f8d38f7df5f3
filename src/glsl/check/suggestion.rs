//! "Did you mean …?"

use super::Checker;
use crate::glsl::builtins::Builtin;
use crate::glsl::names::Name;

impl Checker<'_> {
    /// A visible name that is spelled almost like this one.
    pub(super) fn similar_name(&self, name: Name) -> Option<String> {
        if self.errors > SEARCHES {
            return None;
        }
        let wanted = self.text(name);
        let candidates = self.scopes.names().map(|known| self.text(known));
        closest(wanted, candidates.filter(|known| *known != wanted))
    }

    /// A function that is spelled almost like this.
    pub(super) fn similar_function(&self, name: Name) -> Option<String> {
        let wanted = self.text(name);
        let own = self
            .signatures
            .iter()
            .map(|signature| self.text(signature.name));
        let builtins = Builtin::ALL.iter().map(|builtin| builtin.name());
        closest(wanted, own.chain(builtins).filter(|known| *known != wanted))
    }
}

/// After so many errors no more names are searched for.
const SEARCHES: usize = 20;

/// Longer names are made by programs, which do not slip.
const LONGEST: usize = 64;

/// The candidate with the fewest changes, if they are few enough for a slip of the fingers.
pub(super) fn closest<'c>(
    wanted: &str,
    candidates: impl Iterator<Item = &'c str>,
) -> Option<String> {
    let limit = match wanted.len() {
        3..6 => 1,
        6..=LONGEST => 2,
        _ => return None,
    };
    candidates
        .filter(|candidate| candidate.len().abs_diff(wanted.len()) <= limit)
        .map(|candidate| (distance(wanted, candidate), candidate))
        .filter(|&(distance, _)| distance <= limit)
        .min()
        .map(|(_, candidate)| candidate.to_owned())
}

/// Damerau's and Levenshtein's distance with transposed neighbours, letter case ignored at no cost
/// only when nothing else differs. Both are no longer than [`LONGEST`] and the two letters that may
/// be too many.
fn distance(a: &str, b: &str) -> usize {
    if a.eq_ignore_ascii_case(b) {
        return 1;
    }
    // What both have in common at either end is no matter, and most of what long names are.
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let same = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[same..], &b[same..]);
    let both = a.iter().rev().zip(b.iter().rev());
    let same = both.take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[..a.len() - same], &b[..b.len() - same]);
    let mut rows = [[0; LONGEST + 3]; 3];
    for (j, cost) in rows[0].iter_mut().enumerate() {
        *cost = j;
    }
    for (i, &from) in a.iter().enumerate() {
        let [before, last, row] = [i + 2, i, i + 1].map(|row| row % 3);
        rows[row][0] = i + 1;
        for (j, &to) in b.iter().enumerate() {
            let mut cost = (rows[last][j] + usize::from(from != to))
                .min(rows[last][j + 1] + 1)
                .min(rows[row][j] + 1);
            if i > 0 && j > 0 && from == b[j - 1] && a[i - 1] == to {
                cost = cost.min(rows[before][j - 1] + 1);
            }
            rows[row][j + 1] = cost;
        }
    }
    rows[a.len() % 3][b.len()]
}

#[cfg(test)]
mod tests {
    use super::closest;

    #[test]
    fn slips_are_recognised() {
        let known = ["smoothstep", "iTime", "fragCoord", "mix"];
        let find = |wanted| closest(wanted, known.into_iter());
        assert_eq!(find("smothstep").as_deref(), Some("smoothstep"));
        assert_eq!(find("itime").as_deref(), Some("iTime"));
        assert_eq!(find("fragCorod").as_deref(), Some("fragCoord"));
        assert_eq!(find("brightness"), None);
        assert_eq!(find("ab"), None);
        assert_eq!(find("mxi").as_deref(), Some("mix"));
        assert_eq!(find("smoothsteppp").as_deref(), Some("smoothstep"));
        let long = "x".repeat(66);
        assert_eq!(
            closest(&long[2..], [&*long].into_iter()),
            Some(long.clone())
        );
        assert_eq!(closest(&long, [&*long].into_iter()), None);
    }
}
