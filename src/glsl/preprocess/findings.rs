use crate::source::Diagnostic;

/// The most errors, and the most warnings, that are kept: nobody reads more, and a hostile text
/// could have one in every byte.
const MOST: usize = 100;

/// What there is to say about the text so far.
#[derive(Debug, Default)]
pub(super) struct Findings {
    list: Vec<Diagnostic>,
    errors: usize,
}

impl Findings {
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let errors = self.errors + usize::from(diagnostic.is_error());
        let warnings = self.list.len() + 1 - errors;
        if errors <= MOST && warnings <= MOST {
            self.list.push(diagnostic);
            self.errors = errors;
        }
    }

    pub fn into_list(self) -> Vec<Diagnostic> {
        self.list
    }
}
