//! A folder of verdicts that another implementation gave, held against ours.
//!
//! ```text
//! VERDICTS=DIR cargo test --test suite -- --ignored --nocapture verdicts
//! ```
//!
//! Every `*.glsl` in the folder is an Image pass with a header:
//!
//! ```text
//! // May arrays be added?                          the question
//! // verdict: refuse                               or accept
//! // angle: '+' : Invalid operation for arrays     the other's message, if it gave one
//! // at: 6                                         its line in this file; or header, none, link
//! ```
//!
//! It is a report, not a test: it prints how far the two agree and where they do not, and never fails.

use vitrine::source::Diagnostic;

use crate::support::{Case, cases, on_every_core};

/// What is known about one file.
struct Probe {
    name: String,
    accepts: bool,
    message: String,
    /// The line of the other's message, where it has one in the file.
    line: Option<usize>,
    ours: Ours,
}

enum Ours {
    Accepts,
    Refuses {
        message: String,
        line: Option<usize>,
    },
}

impl Probe {
    fn ask(case: &Case) -> Probe {
        let first = |key| case.header(key).into_iter().next();
        Probe {
            name: case.name.clone(),
            accepts: match first("verdict").as_deref() {
                Some("accept") => true,
                Some("refuse") => false,
                other => panic!("{}: the verdict is {other:?}", case.name),
            },
            message: first("angle").unwrap_or_default(),
            line: first("at").and_then(|at| at.parse().ok()),
            ours: Ours::of(case),
        }
    }

    fn agrees(&self) -> bool {
        self.accepts == matches!(self.ours, Ours::Accepts)
    }

    /// The other's line and ours, of a refusal that both agree on.
    fn lines(&self) -> Option<(usize, Option<usize>)> {
        match self.ours {
            Ours::Refuses { line, .. } if self.agrees() => Some((self.line?, line)),
            _ => None,
        }
    }
}

impl Ours {
    fn of(case: &Case) -> Ours {
        let Err(report) = case.translated(true) else {
            return Ours::Accepts;
        };
        let error = report.diagnostics.iter().find(|found| found.is_error());
        let error = error.expect("a refusal has an error");
        let line = error.span.map(|span| {
            let file = report.files.get(span.file);
            file.location(span.start).line
        });
        Ours::Refuses {
            message: described(error),
            line,
        }
    }

    fn message(&self) -> &str {
        match self {
            Ours::Accepts => "accepted",
            Ours::Refuses { message, .. } => message,
        }
    }
}

fn described(error: &Diagnostic) -> String {
    format!("[{}] {}", error.code, error.message)
}

#[test]
#[ignore = "it needs cases with a browser's verdicts, which are not part of this repository: VERDICTS=FOLDER"]
fn verdicts_agree() {
    let Some(folder) = std::env::var_os("VERDICTS") else {
        println!("VERDICTS names no folder");
        return;
    };
    let probes = on_every_core(&cases(&folder.to_string_lossy()), Probe::ask);

    let [wrongly_refused, wrongly_accepted] = [true, false].map(|accepts| -> Vec<_> {
        let disagree = |probe: &&Probe| probe.accepts == accepts && !probe.agrees();
        probes.iter().filter(disagree).collect()
    });
    println!("\nRefused, but to be accepted: {}", wrongly_refused.len());
    for probe in &wrongly_refused {
        println!("  {}: {}", probe.name, probe.ours.message());
    }
    println!("\nAccepted, but to be refused: {}", wrongly_accepted.len());
    for probe in &wrongly_accepted {
        println!("  {}: {}", probe.name, probe.message);
    }

    let lines: Vec<_> = probes
        .iter()
        .filter_map(|probe| Some((probe, probe.lines()?)))
        .collect();
    let elsewhere = lines
        .iter()
        .filter(|(_, (theirs, ours))| Some(*theirs) != *ours);
    println!("\nRefused on another line: {}", elsewhere.clone().count());
    for (probe, (theirs, ours)) in elsewhere.clone() {
        let ours = ours.map_or("none".to_owned(), |line| line.to_string());
        println!(
            "  {}: line {ours} instead of {theirs}: {} | {}",
            probe.name,
            probe.ours.message(),
            probe.message
        );
    }

    let agreeing = probes.iter().filter(|probe| probe.agrees()).count();
    println!("\nverdicts that agree: {}", share(agreeing, probes.len()));
    let same = lines.len() - elsewhere.count();
    println!("refusals on the same line: {}", share(same, lines.len()));
}

fn share(part: usize, whole: usize) -> String {
    let percent = 100.0 * part as f64 / whole.max(1) as f64;
    format!("{part} of {whole}, {percent:.2} %")
}
