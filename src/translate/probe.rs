//! Finds the value that a probe names.

use crate::glsl::arena::Id;
use crate::glsl::hir::{Function, Hir, Local};
use crate::glsl::lower::{Watched, can_be_watched};
use crate::glsl::types::spell;
use crate::source::Diagnostic;

/// What may be asked for instead of the colour.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub enum Output {
    /// The colour.
    #[default]
    Colour,
    /// A value by its name, which [`Probe`] reads.
    Probe(Probe),
    /// The rounds that four loops made in the pixel, from this one of [`super::Program::loops`] on.
    Rounds(u32),
    /// The rounds that all loops made together.
    AllRounds,
    /// The rounds that counted against [`super::Options::round_budget`].
    Spent,
}

/// The name of a value within a pass.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Probe {
    /// `NAME` or `FUNCTION.NAME`: what a variable holds at the end of its function, which is the pass's
    /// entry point where none is named.
    Variable {
        /// The function.
        function: Option<String>,
        /// The variable.
        name: String,
    },
    /// `FUNCTION()`: what it returned last.
    Result(String),
}

impl std::str::FromStr for Probe {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (function, name) = match (text.strip_suffix("()"), text.split_once('.')) {
            (Some(function), _) => (Some(function), None),
            (None, Some((function, name))) => (Some(function), Some(name)),
            (None, None) => (None, Some(text)),
        };
        let is_name = |text: &str| {
            let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
            !text.is_empty()
                && text.chars().all(is_part)
                && !text.starts_with(|c: char| c.is_ascii_digit())
        };
        if ![function, name].into_iter().flatten().all(is_name) {
            return Err(format!(
                "`{text}` names no value: write a variable of the entry point as `t`, that of another \
                 function as `march.t`, what a function returned as `march()`"
            ));
        }
        Ok(
            match (function.map(str::to_owned), name.map(str::to_owned)) {
                (Some(function), None) => Probe::Result(function),
                (function, name) => Probe::Variable {
                    function,
                    name: name.unwrap_or_default(),
                },
            },
        )
    }
}

impl std::fmt::Display for Probe {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Probe::Variable {
                function: None,
                name,
            } => write!(f, "{name}"),
            Probe::Variable {
                function: Some(function),
                name,
            } => write!(f, "{function}.{name}"),
            Probe::Result(function) => write!(f, "{function}()"),
        }
    }
}

/// The value that a probe means. Of several functions or variables of one name it is the last in the
/// text that can be given for a pixel. `entry` is the name of the entry point.
pub(super) fn find(hir: &Hir, probe: &Probe, entry: &str) -> Result<Watched, Diagnostic> {
    let (function, name) = match probe {
        Probe::Result(function) => (function.as_str(), None),
        Probe::Variable { function, name } => {
            (function.as_deref().unwrap_or(entry), Some(name.as_str()))
        }
    };
    let is_meant = |id: &Id<Function>| hir.names.text(hir.functions[*id].name) == function;
    let functions: Vec<_> = hir.functions.ids().filter(is_meant).collect();
    if functions.is_empty() {
        let all = hir.functions.iter();
        let names = all.map(|(_, function)| hir.names.text(function.name));
        return Err(unknown(
            format!("the pass has no function `{function}`"),
            names.filter(|name| !name.starts_with("__")),
        ));
    }
    let is_fine = |watched: &Watched| {
        let ty = watched.ty(hir);
        match can_be_watched(ty) {
            true => Ok(*watched),
            false => Err(Diagnostic::error(
                "probe",
                format!("`{probe}` is a `{}`", spell(ty, &hir.structs, &hir.names)),
            )
            .hint("a probe is a number or a vector")),
        }
    };
    let Some(name) = name else {
        let results = functions.iter().map(|&id| is_fine(&Watched::Result(id)));
        return last_fine(results).expect("there is a function");
    };
    let is_named = |local: &Local| local.name.is_some_and(|own| hir.names.text(own) == name);
    let locals = functions.iter().flat_map(|&id| {
        let locals = hir.functions[id].locals.iter();
        let named = locals.filter(|(_, local)| is_named(local));
        named.map(move |(local, _)| is_fine(&Watched::Local(id, local)))
    });
    last_fine(locals).unwrap_or_else(|| {
        let locals = functions
            .iter()
            .flat_map(|&id| hir.functions[id].locals.iter());
        let names = locals.filter_map(|(_, local)| Some(hir.names.text(local.name?)));
        Err(unknown(
            format!("`{function}` has no variable `{name}`"),
            names,
        ))
    })
}

/// The last that is fine, or else the last complaint.
fn last_fine(
    found: impl Iterator<Item = Result<Watched, Diagnostic>>,
) -> Option<Result<Watched, Diagnostic>> {
    found.reduce(|before, next| if next.is_ok() { next } else { before })
}

fn unknown<'a>(message: String, names: impl Iterator<Item = &'a str>) -> Diagnostic {
    const MOST: usize = 12;
    let mut known: Vec<String> = Vec::new();
    for name in names {
        let quoted = format!("`{name}`");
        if !known.contains(&quoted) {
            known.push(quoted);
        }
    }
    let more = if known.len() > MOST { ", …" } else { "" };
    known.truncate(MOST);
    let problem = Diagnostic::error("probe", message);
    match known.is_empty() {
        true => problem,
        false => problem.hint(format!("there are {}{more}", known.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::Probe;

    #[test]
    fn names_of_probes() {
        for text in ["t", "_a1", "march.t", "march()"] {
            let probe: Probe = text.parse().expect(text);
            assert_eq!(probe.to_string(), text);
        }
        for text in ["", "1a", "a b", "a.b.c", "a.", ".b", "()", "a.b()", "f(x)"] {
            assert!(text.parse::<Probe>().is_err(), "{text}");
        }
    }
}
