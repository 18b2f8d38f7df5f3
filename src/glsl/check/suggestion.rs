//! "Did you mean …?"

use super::Checker;
use crate::glsl::builtins::Builtin;
use crate::glsl::names::Name;

impl Checker<'_> {
    /// A visible name that is spelled almost like this one.
    pub(super) fn similar_name(&self, name: Name) -> Option<String> {
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

/// The candidate with the fewest changes, if they are few enough for a slip of the fingers.
pub(super) fn closest<'c>(
    wanted: &str,
    candidates: impl Iterator<Item = &'c str>,
) -> Option<String> {
    let limit = match wanted.len() {
        0..3 => return None,
        3..6 => 1,
        _ => 2,
    };
    candidates
        .filter(|candidate| candidate.len().abs_diff(wanted.len()) <= limit)
        .map(|candidate| (distance(wanted, candidate), candidate))
        .filter(|&(distance, _)| distance <= limit)
        .min()
        .map(|(_, candidate)| candidate.to_owned())
}

/// Damerau's and Levenshtein's distance with transposed neighbours, letter case ignored at no cost
/// only when nothing else differs.
fn distance(a: &str, b: &str) -> usize {
    if a.eq_ignore_ascii_case(b) {
        return 1;
    }
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for (i, &from) in a.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, &to) in b.iter().enumerate() {
            let mut cost = (last[j] + usize::from(from != to))
                .min(last[j + 1] + 1)
                .min(row[j] + 1);
            if i > 0 && j > 0 && from == b[j - 1] && a[i - 1] == to {
                cost = cost.min(before[j - 1] + 1);
            }
            row.push(cost);
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
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
    }
}
