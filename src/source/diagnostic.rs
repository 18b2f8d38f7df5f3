use super::{SourceMap, Span};

/// How much a [`Diagnostic`] weighs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The scene runs; something about it deserves a look.
    Warning,
    /// The scene cannot run.
    Error,
}

impl Severity {
    /// The lower-case English word, as reports and JSON spell it.
    pub fn as_str(self) -> &'static str {
        match self {
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// One thing to tell a shader's author.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Error or warning.
    pub severity: Severity,
    /// A stable, lower-case name of the kind of problem, for tools: `no-main-image`, `syntax`, ….
    pub code: &'static str,
    /// What is wrong, in one line.
    pub message: String,
    /// Where in the author's own files; `None` when no file could be read at all.
    pub span: Option<Span>,
    /// Other places that have to do with it, and what they have to do with it.
    pub notes: Vec<(Span, String)>,
    /// What to do about it.
    pub hint: Option<String>,
    /// The pass being translated, by ShaderToy's name for it; `None` while loading.
    pub pass: Option<String>,
}

impl Diagnostic {
    /// An error of the given kind. Place, notes, hint and pass are added with the methods below.
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Diagnostic {
            severity: Severity::Error,
            code,
            message: message.into(),
            span: None,
            notes: Vec::new(),
            hint: None,
            pass: None,
        }
    }

    /// A warning of the given kind.
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Diagnostic {
            severity: Severity::Warning,
            ..Diagnostic::error(code, message)
        }
    }

    /// Points at a place.
    pub fn at(mut self, span: impl Into<Option<Span>>) -> Self {
        self.span = span.into();
        self
    }

    /// Says ahead of the message what it is about.
    pub fn within(mut self, what: &str) -> Self {
        self.message = format!("{what}: {}", self.message);
        self
    }

    /// Points at another place.
    pub fn note(mut self, span: Span, text: impl Into<String>) -> Self {
        self.notes.push((span, text.into()));
        self
    }

    /// Adds the way out.
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// Whether this stops the scene from running.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// Diagnostics together with the files that they point into, in the order they should be read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// The files that the spans of `diagnostics` refer to.
    pub files: SourceMap,
    /// What there is to say.
    pub diagnostics: Vec<Diagnostic>,
}

impl Report {
    /// Whether any of the diagnostics is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}
