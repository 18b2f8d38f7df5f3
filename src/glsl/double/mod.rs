//! Built-in functions for programs whose floats have 64 bits. Graphics drivers compute them in 32 bits
//! only, so they are written in GLSL, of the operations that drivers do know.

use rustc_hash::FxHashMap;

use super::arena::Id;
use super::builtins::Builtin;
use super::hir::{Function, Hir};

/// The functions, to be compiled ahead of a program. Their names are reserved, so that no program can
/// have the same: the checker must be told how many of the tokens are these.
pub const TEXT: &str = include_str!("functions.glsl");

/// What a function's name has in front of the built-in function's that it stands for.
const PREFIX: &str = "__";

/// Which of a program's functions stand for built-in ones.
#[derive(Clone, Debug, Default)]
pub struct Functions(FxHashMap<(Builtin, usize), Id<Function>>);

impl Functions {
    /// Finds those of [`TEXT`] in a program that was compiled with it.
    pub fn new(hir: &Hir) -> Self {
        let functions = hir.functions.iter().filter_map(|(id, function)| {
            let name = hir.names.text(function.name).strip_prefix(PREFIX)?;
            let builtin = Builtin::find(name)?;
            Some(((builtin, function.parameters.len()), id))
        });
        Functions(functions.collect())
    }

    /// What stands for a built-in function of so many operands. It takes scalars.
    pub fn get(&self, builtin: Builtin, operands: usize) -> Option<Id<Function>> {
        self.0.get(&(builtin, operands)).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glsl::check::{self, check};
    use crate::glsl::names::Names;
    use crate::glsl::places::Places;
    use crate::glsl::preprocess::preprocess;
    use crate::glsl::prune::Reachable;
    use crate::glsl::{Precision, syntax};
    use crate::source::SourceMap;

    /// Compiles a program behind the functions, and gives the names of those that it needs.
    fn needed(program: &str) -> Vec<String> {
        let mut files = SourceMap::default();
        let units = [files.add("double", TEXT), files.add("program", program)];
        let own = preprocess(&files, &units[..1], &Default::default(), Names::default());
        let whole = preprocess(&files, &units, &Default::default(), Names::default());
        let parsed = syntax::parse(&whole.tokens, whole.names, true);
        let options = check::Options {
            strict: true,
            precision: Precision::Double,
            host_tokens: own.tokens.len(),
        };
        let mut ast = parsed.ast;
        let checked = check(&mut ast, Places::new(&whole.tokens), options);
        let found = [
            own.diagnostics,
            whole.diagnostics,
            parsed.diagnostics,
            checked.diagnostics,
        ];
        assert_eq!(found.concat(), []);
        let hir = checked.hir;
        let reachable = Reachable::new(&hir, &Functions::new(&hir));
        let names = reachable.functions.iter();
        let names = names.map(|&id| hir.names.text(hir.functions[id].name).to_owned());
        names.collect()
    }

    #[test]
    fn there_is_one_for_all_that_drivers_lack() {
        let calls: Vec<_> =
            "sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp log exp2 log2"
                .split(' ')
                .map(|name| (name, format!("{name}(x)")))
                .chain(["pow", "atan"].map(|name| (name, format!("{name}(x, x)"))))
                .collect();
        for (name, call) in calls {
            let found = needed(&format!(
                "out vec4 c; void main() {{ vec2 x = vec2(1.0); x = {call}; }}"
            ));
            let wanted = ["__", name].concat();
            assert_eq!(
                found.iter().filter(|known| **known == wanted).count(),
                1,
                "{call} needs {found:?}"
            );
        }
    }

    #[test]
    fn what_is_needed_comes_first_and_nothing_else() {
        assert_eq!(
            needed(
                "float f(float x) { return exp(x); } out vec4 c;
                void main() { float x = 1.0; x = f(sqrt(x)); }"
            ),
            [
                "__settled",
                "__power_of_two",
                "__scaled",
                "__exp_of_sum",
                "__exp",
                "f",
                "main"
            ]
        );
    }
}
