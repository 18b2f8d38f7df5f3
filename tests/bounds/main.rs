//! However hostile a text is, judging it ends in a program or in a complaint, without a crash, and in
//! bounded memory. How long it takes is printed, not asserted, because machines differ:
//!
//! `cargo test --release --test bounds -- --nocapture`

mod texts;

use std::time::Instant;

use peak_alloc::PeakAlloc;
use vitrine::scene::{self, Source};
use vitrine::translate::{self, Options};

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// The most memory that a text may take to judge, in bytes.
const MOST: usize = 200 << 20;

/// What becomes of a text: the first error, or nothing where it is accepted.
fn judge(text: String) -> Option<(&'static str, String)> {
    let source = Source::Text {
        name: "hostile.glsl".to_owned(),
        bytes: text.into_bytes(),
    };
    let report = match scene::load(&source) {
        Ok(scene) => translate::translate(&scene, &Options::default()).err()?,
        Err(error) => match error.kind {
            scene::LoadErrorKind::Scene(report) => report,
            scene::LoadErrorKind::Io { .. } => panic!("no file is read"),
        },
    };
    let first = report
        .diagnostics
        .into_iter()
        .find(vitrine::source::Diagnostic::is_error);
    let first = first.expect("a failure has an error");
    Some((first.code, first.message))
}

/// All in one test, since they share a heap.
#[test]
fn hostile_texts_are_judged_in_bounded_memory() {
    let mut faults = Vec::new();
    println!("{:>8} {:>6}  text", "ms", "MB");
    for texts::Text { name, text } in texts::all() {
        let before = HEAP.current_usage();
        HEAP.reset_peak_usage();
        let start = Instant::now();
        let error = judge(text);
        let time = start.elapsed();
        let peak = HEAP.peak_usage().saturating_sub(before);
        let outcome = match &error {
            None => "accepted".to_owned(),
            Some((code, message)) => format!("{code}: {message:.70}"),
        };
        let megabytes = peak >> 20;
        println!("{:8} {megabytes:6}  {name}: {outcome}", time.as_millis());
        if peak > MOST {
            faults.push(format!("{name}: takes {megabytes} MB"));
        }
        // A panic is caught where it happens and becomes this.
        if let Some((code, message)) = error
            && (code == "internal" || message.starts_with("translating takes longer than"))
        {
            faults.push(format!("{name}: {message}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
