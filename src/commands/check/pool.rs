//! Worker processes, and what becomes of those that do not answer.

use std::collections::BTreeMap;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use vitrine::translate::Options;

use super::super::failure;
use super::super::source::comes_from_outside;
use super::verdict::{Judgement, cut_off, judge};
use super::worker::OUT_OF_MEMORY;
use super::{MEMORY_LIMIT, TIME_LIMIT};
use crate::cli::{CheckArgs, Format};

/// After an answer that took this long, a worker may still be busy with what the translator gave up.
const TIRED: Duration = Duration::from_secs(5);

/// Judges the scenes on several workers, and hands on the judgements in the order of the names.
pub(super) fn judge_all(
    names: &[PathBuf],
    args: &CheckArgs,
    options: &Options,
    each: &mut dyn FnMut(Judgement) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let jobs = args.jobs.map_or_else(
        || thread::available_parallelism().map_or(1, usize::from),
        usize::from,
    );
    let next = AtomicUsize::new(0);
    let (sender, judgements) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..jobs.min(names.len()) {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                let mut desk = Desk::new(args, options);
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(name) = names.get(index) else { break };
                    // The receiver is gone after a failure.
                    let _ = sender.send((index, desk.judge(name)));
                }
            });
        }
        drop(sender);
        let result = in_order(&judgements, each);
        // After a failure nobody should begin another scene.
        next.store(names.len(), Ordering::Relaxed);
        result
    })
}

/// Hands on what comes in any order in the order of its numbers.
fn in_order(
    judgements: &Receiver<(usize, anyhow::Result<Judgement>)>,
    each: &mut dyn FnMut(Judgement) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let mut early = BTreeMap::new();
    let mut next = 0;
    for (index, judgement) in judgements {
        early.insert(index, judgement);
        while let Some(judgement) = early.remove(&next) {
            each(judgement?)?;
            next += 1;
        }
    }
    Ok(())
}

/// One line of work: a worker at a time, replaced when it is lost.
struct Desk<'a> {
    args: &'a CheckArgs,
    options: &'a Options,
    worker: Option<Worker>,
}

impl<'a> Desk<'a> {
    fn new(args: &'a CheckArgs, options: &'a Options) -> Self {
        Desk {
            args,
            options,
            worker: None,
        }
    }

    fn judge(&mut self, path: &Path) -> anyhow::Result<Judgement> {
        // A worker's standard input is taken, and names go to it as text. Its time is not for waiting on the site.
        let name = path.to_str().filter(|_| !comes_from_outside(path));
        let Some(name) = name else {
            return Ok(judge(path, self.args, self.options));
        };
        let worker = match &mut self.worker {
            Some(worker) => worker,
            none => none.insert(Worker::start(self.args, self.options).map_err(|error| {
                failure(format!("cannot start a process that checks: {error}"), "")
            })?),
        };
        let limit = self.args.timeout.map_or(TIME_LIMIT, |seconds| {
            Duration::from_secs(u64::from(seconds))
        });
        let began = Instant::now();
        let answer = worker.ask(name, limit);
        let is_lost = !matches!(answer, Answer::Judgement(_));
        if is_lost || began.elapsed() > TIRED {
            self.worker = None;
        }
        let (why, hint) = match answer {
            Answer::Judgement(judgement) => return Ok(judgement),
            Answer::Late => (
                format!("it takes longer than {} s", limit.as_secs()),
                "give it more time with `--timeout SECONDS`",
            ),
            Answer::End(status) if status.code() == Some(OUT_OF_MEMORY) => {
                let limit = self.args.memory.unwrap_or(MEMORY_LIMIT);
                (
                    format!("it takes more than {limit} MiB of memory"),
                    "give it more with `--memory MIB`",
                )
            }
            Answer::End(status) => (
                format!("the process that checked it ended with {status}"),
                "please report this shader: no text should do that",
            ),
        };
        Ok(cut_off(path, self.args.format, &why, hint))
    }
}

/// A process that checks one scene after the other.
struct Worker {
    child: Child,
    names: ChildStdin,
    answers: Receiver<String>,
}

/// What comes of asking a worker.
enum Answer {
    Judgement(Judgement),
    /// It has not answered in time.
    Late,
    /// The worker ended instead.
    End(ExitStatus),
}

impl Worker {
    fn start(args: &CheckArgs, options: &Options) -> std::io::Result<Self> {
        let mut command = Command::new(std::env::current_exe()?);
        command.args(["check", "--worker", "--format"]);
        command.arg(match args.format {
            Format::Human => "human",
            Format::Json => "json",
        });
        if options.strict {
            command.arg("--strict");
        }
        for (name, value) in &options.overrides {
            command.arg(format!("--define={name}={value}"));
        }
        if let Some(limit) = args.memory {
            command.arg(format!("--memory={limit}"));
        }
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            // Its last words would stand between other scenes'; how it ended is told.
            .stderr(Stdio::null())
            .spawn()?;
        let names = child.stdin.take().expect("it is piped");
        let stdout = child.stdout.take().expect("it is piped");
        let (sender, answers) = mpsc::channel();
        // It ends with the worker, whose end of the pipe is then closed.
        thread::spawn(move || {
            for line in BufReader::new(stdout).lines().map_while(Result::ok) {
                let _ = sender.send(line);
            }
        });
        Ok(Worker {
            child,
            names,
            answers,
        })
    }

    fn ask(&mut self, name: &str, limit: Duration) -> Answer {
        let line = serde_json::to_string(name).expect("plain data") + "\n";
        // A worker that is gone gives no answer either.
        let _ = self.names.write_all(line.as_bytes());
        match self.answers.recv_timeout(limit) {
            Ok(line) => Answer::Judgement(serde_json::from_str(&line).expect("a worker's answer")),
            Err(RecvTimeoutError::Timeout) => Answer::Late,
            Err(RecvTimeoutError::Disconnected) => {
                Answer::End(self.child.wait().expect("a child can be waited for"))
            }
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
