use super::{Options, Token, preprocess};
use crate::glsl::names::Names;
use crate::source::{Diagnostic, SourceMap, Span};

/// What comes of a text: its tokens, and what there is to say about it.
struct Outcome {
    files: SourceMap,
    /// Spellings, spans and origins.
    tokens: Vec<(String, Span, Option<Span>)>,
    diagnostics: Vec<Diagnostic>,
    has_odd_character: bool,
    unused: Vec<String>,
}

fn run_with(text: &str, strict: bool, overrides: &[(&str, &str)]) -> Outcome {
    let mut files = SourceMap::default();
    let file = files.add("a", text);
    let overrides: Vec<_> = overrides
        .iter()
        .map(|&(name, value)| (name.to_owned(), value.to_owned()))
        .collect();
    let options = Options {
        defines: &[("HOST", "1")],
        splices: &[],
        overrides: &overrides,
        strict,
    };
    let made = preprocess(&files, &[file], &options, Names::default());
    let spelled = |token: Token| {
        let text = made.names.text(token.spelling).to_owned();
        (text, token.span, token.origin())
    };
    Outcome {
        tokens: made.tokens.into_iter().map(spelled).collect(),
        diagnostics: made.diagnostics,
        has_odd_character: made.odd_character.is_some(),
        unused: made
            .unused_overrides
            .iter()
            .map(ToString::to_string)
            .collect(),
        files,
    }
}

impl Outcome {
    fn spelled(&self) -> String {
        let words: Vec<_> = self.tokens.iter().map(|(text, ..)| text.as_str()).collect();
        words.join(" ")
    }

    fn messages(&self) -> Vec<&str> {
        let found = self.diagnostics.iter();
        found.map(|found| found.message.as_str()).collect()
    }

    fn written(&self, span: Span) -> &str {
        &self.files.get(span.file).text[span.start as usize..span.end as usize]
    }

    fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}

fn run(text: &str) -> Outcome {
    run_with(text, false, &[])
}

#[track_caller]
fn expands(text: &str, expected: &str) {
    let outcome = run(text);
    assert_eq!(outcome.spelled(), expected, "{text}");
    assert_eq!(outcome.messages(), [""; 0], "{text}");
}

#[track_caller]
fn refuses(text: &str, part: &str) {
    let outcome = run(text);
    let messages = outcome.messages();
    let has_part = messages.iter().any(|message| message.contains(part));
    assert!(has_part && outcome.has_errors(), "{text}: {messages:?}");
}

/// What is an error to a browser and only a warning here.
#[track_caller]
fn warns(text: &str, part: &str) {
    for strict in [false, true] {
        let outcome = run_with(text, strict, &[]);
        let messages = outcome.messages();
        let has_part = messages.iter().any(|message| message.contains(part));
        assert!(has_part, "{text}: {messages:?}");
        assert_eq!(outcome.has_errors(), strict, "{text}: {messages:?}");
    }
}

mod directives;
mod expansion;
mod text;
