//! What is true of every text, however hostile.

pub mod grammar;

use vitrine::scene::{self, LoadErrorKind, Source};
use vitrine::source::Report;
use vitrine::translate::{Arithmetic, Checks, Language, Options, translate, write};

/// Translates a text, both ways, and panics unless there is a program that can be written or a
/// complaint that makes sense.
pub fn judge(bytes: &[u8]) {
    let source = Source::Text {
        name: "fuzz.glsl".to_owned(),
        bytes: bytes.to_vec(),
    };
    let scene = match scene::load(&source) {
        Ok(scene) => scene,
        Err(error) => match error.kind {
            LoadErrorKind::Scene(report) => return assert_sound(&report),
            LoadErrorKind::Io { .. } => panic!("no file is read"),
        },
    };
    let ways = [
        (false, Arithmetic::Expanded, Checks::None),
        (true, Arithmetic::Compact, Checks::None),
        (false, Arithmetic::Expanded, Checks::All),
    ];
    let accepted = ways.map(|(strict, arithmetic, checks)| {
        let options = Options {
            strict,
            arithmetic,
            checks,
            round_budget: Some(1000),
            round_limit: Some(100),
            ..Options::default()
        };
        match translate(&scene, &options) {
            Ok(programs) => {
                for program in &programs {
                    for language in [Language::Wgsl, Language::Spirv] {
                        if let Err(diagnostic) = write(program, language) {
                            panic!("{language:?}: {}", diagnostic.message);
                        }
                    }
                }
                true
            }
            Err(report) => {
                assert_sound(&report);
                false
            }
        }
    });
    assert_ne!(accepted[..2], [false, true], "strictness only takes away");
    assert!(accepted[0] || !accepted[2], "checks add nothing to the language");
}

fn assert_sound(report: &Report) {
    assert!(report.has_errors(), "a failure without an error");
    for diagnostic in &report.diagnostics {
        let message = &diagnostic.message;
        // A panic is caught where it happens and becomes this.
        assert_ne!(diagnostic.code, "internal", "{message}");
        assert!(
            !message.starts_with("translating takes longer than"),
            "{message}"
        );
        assert!(!message.trim().is_empty(), "no message: {diagnostic:?}");
        if let Some(span) = diagnostic.span {
            let file = &report.files.get(span.file).text;
            let marked = file.get(span.start as usize..span.end as usize);
            assert!(marked.is_some(), "{diagnostic:?} marks no part of the text");
        }
    }
}
