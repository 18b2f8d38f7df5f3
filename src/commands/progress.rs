//! How far a long command is.

use std::io::IsTerminal as _;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use vitrine::report;

/// How often progress is told where there is no terminal.
const PLAIN_LINE_EVERY: Duration = Duration::from_secs(5);

/// A bar on a terminal, a line now and then elsewhere.
pub enum Progress {
    Bar(ProgressBar),
    Lines {
        total: u32,
        noun: &'static str,
        started: Instant,
        last: Instant,
    },
}

impl Progress {
    pub fn new(total: u32, noun: &'static str) -> Self {
        if std::io::stderr().is_terminal() {
            let bar = ProgressBar::new(u64::from(total));
            let template = "{wide_bar} {pos}/{len} {prefix}, {per_sec}, {eta} left {msg}";
            bar.set_prefix(noun);
            bar.set_style(ProgressStyle::with_template(template).expect("a valid template"));
            return Progress::Bar(bar);
        }
        Progress::Lines {
            total,
            noun,
            started: Instant::now(),
            last: Instant::now(),
        }
    }

    pub fn at(&mut self, done: u32) {
        match self {
            Progress::Bar(bar) => bar.set_position(u64::from(done)),
            Progress::Lines {
                total,
                noun,
                started,
                last,
            } => {
                if last.elapsed() >= PLAIN_LINE_EVERY {
                    *last = Instant::now();
                    let seconds = started.elapsed().as_secs();
                    report::tell(format_args!("{done} of {total} {noun} after {seconds} s"));
                }
            }
        }
    }

    /// Says what is being done.
    pub fn say(&self, what: &str) {
        if let Progress::Bar(bar) = self {
            bar.set_message(what.to_owned());
            bar.tick();
        }
    }

    pub fn end(&self) {
        if let Progress::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}
