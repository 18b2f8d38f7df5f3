//! Says what is wrong with scenes, one or thousands, without a GPU.
//!
//! A few scenes are checked here. Many are checked by worker processes, this same program started
//! again: whatever a scene does to a worker, the others are checked all the same.

mod names;
mod pool;
mod summary;
mod verdict;
mod worker;

use std::process::ExitCode;
use std::time::Duration;

use vitrine::report;
use vitrine::translate::Options;

use super::print;
use crate::cli::{CheckArgs, Format};
use summary::Summary;
use verdict::{Judgement, Verdict, judge};

/// Up to this many scenes are not worth the start of another process.
const HANDFUL: usize = 4;

/// How long a scene may take when many are checked. Real ones take milliseconds.
const TIME_LIMIT: Duration = Duration::from_secs(8);

/// MiB of memory that a scene may take when many are checked.
const MEMORY_LIMIT: u64 = 2048;

/// Checks every scene, also after one that is wrong or missing. What is said of them comes in the
/// order in which they were named.
pub fn check(args: CheckArgs) -> anyhow::Result<ExitCode> {
    let options = Options {
        strict: args.strict,
        overrides: args.define.define.clone(),
        ..Options::default()
    };
    if args.worker {
        return Ok(worker::serve(&args, &options));
    }
    let names = names::gather(&args)?;
    let mut summary = Summary::default();
    let mut each = |judgement: Judgement| {
        summary.count(&judgement);
        tell(&judgement, &args)
    };
    let is_handful = names.len() <= HANDFUL && args.jobs.is_none();
    if is_handful && args.timeout.is_none() && args.memory.is_none() {
        for name in &names {
            each(judge(name, &args, &options))?;
        }
    } else {
        pool::judge_all(&names, &args, &options, &mut each)?;
    }
    if args.summary {
        let text = match args.format {
            Format::Human => summary.human(),
            Format::Json => serde_json::to_string(&summary)? + "\n",
        };
        print(text.as_bytes())?;
    }
    Ok(summary.exit_code().into())
}

/// Prints what there is to say of a scene: complaints to standard error, lines for tools to standard
/// output. Of a summary's scenes only those are named that nothing is known about.
fn tell(judgement: &Judgement, args: &CheckArgs) -> anyhow::Result<()> {
    let is_known = matches!(judgement.verdict, Verdict::Accept | Verdict::Refuse);
    let text = match (args.summary, is_known) {
        (true, true) => return Ok(()),
        (true, false) => &judgement.complaint,
        (false, _) => &judgement.text,
    };
    if args.format == Format::Json && !args.summary {
        return print(text.as_bytes());
    }
    if let Some(text) = text.strip_suffix('\n') {
        report::tell(text);
    }
    Ok(())
}
