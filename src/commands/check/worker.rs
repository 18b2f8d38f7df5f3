//! A process that checks scenes for another: names come in on standard input, one JSON string a line,
//! judgements go out on standard output, one JSON object a line.

use std::io::{BufRead as _, Write as _};
use std::path::Path;
use std::process::{ExitCode, exit};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use vitrine::translate::Options;

use super::MEMORY_LIMIT;
use super::verdict::judge;
use crate::cli::CheckArgs;

/// How a worker ends that needs too much memory.
pub(super) const OUT_OF_MEMORY: i32 = 77;

/// How often the memory is measured. A shader's worth of text takes longer to become much.
const MEASURE_EVERY: Duration = Duration::from_millis(20);

/// Answers until there are no more questions.
pub(super) fn serve(args: &CheckArgs, options: &Options) -> ExitCode {
    limit_memory(args.memory.unwrap_or(MEMORY_LIMIT));
    let (sender, names) = mpsc::channel::<String>();
    thread::spawn(move || {
        for line in std::io::stdin().lock().lines() {
            let name = line.ok().and_then(|line| serde_json::from_str(&line).ok());
            let Some(name) = name else { break };
            // The receiver is gone when nobody listens to the answers.
            let _ = sender.send(name);
        }
        // Nobody waits for an answer any more, however long it takes.
        exit(0);
    });
    for name in names {
        let judgement = judge(Path::new(&name), args, options);
        let line = serde_json::to_string(&judgement).expect("plain data") + "\n";
        let mut stdout = std::io::stdout().lock();
        if stdout
            .write_all(line.as_bytes())
            .and_then(|()| stdout.flush())
            .is_err()
        {
            break;
        }
    }
    ExitCode::SUCCESS
}

/// Ends the process when it holds more than `limit` MiB, where the system tells how much it holds.
fn limit_memory(limit: u64) {
    thread::spawn(move || {
        while let Some(held) = resident_kib() {
            if held > limit << 10 {
                exit(OUT_OF_MEMORY);
            }
            thread::sleep(MEASURE_EVERY);
        }
    });
}

/// KiB of memory that the process holds, on Linux.
fn resident_kib() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().strip_suffix("kB")?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(target_os = "linux")]
    #[test]
    fn linux_tells_how_much_memory_is_held() {
        let held = resident_kib().expect("a number");
        assert!((100..100 << 20).contains(&held), "{held} KiB");
    }
}
