//! Runs code that an untrusted text can drive into deep recursion, a panic or an endless loop.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Once, mpsc};
use std::thread;
use std::time::Duration;

use super::refusal;
use crate::source::Diagnostic;

/// Reserved, not used: pages are taken only as recursion reaches them.
const STACK_BYTES: usize = 512 << 20;

/// Real shaders take milliseconds; what takes this long expands without end.
const TIME_LIMIT: Duration = Duration::from_secs(10);

/// Why guarded code gave no result.
pub(super) enum Failure {
    Panic(String),
    TimeLimit,
    NoThread(std::io::Error),
}

impl Failure {
    pub fn diagnostic(&self) -> Diagnostic {
        match self {
            Failure::Panic(message) => refusal::internal(message),
            Failure::TimeLimit => Diagnostic::error(
                "too-complex",
                format!("translating takes longer than {} s", TIME_LIMIT.as_secs()),
            )
            .hint("macros that expand into each other are the usual cause"),
            Failure::NoThread(error) => {
                refusal::internal(&format!("the system gives no thread: {error}"))
            }
        }
    }
}

/// Runs `work` on a thread with a deep stack. On a time limit the thread is left behind: it cannot
/// be stopped, and ends with the process.
pub(super) fn guarded<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Result<T, Failure> {
    let (sender, receiver) = mpsc::channel();
    thread::Builder::new()
        .name("translate".to_owned())
        .stack_size(STACK_BYTES)
        .spawn(move || {
            // The receiver is gone when the time limit has passed.
            let _ = sender.send(caught(work));
        })
        .map_err(Failure::NoThread)?;
    match receiver.recv_timeout(TIME_LIMIT) {
        Ok(result) => result.map_err(Failure::Panic),
        Err(_) => Err(Failure::TimeLimit),
    }
}

/// Runs `work`; if it panics, returns the message instead of printing it.
pub(crate) fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    silence_panics();
    GUARDED.set(true);
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    GUARDED.set(false);
    result.map_err(|payload| message(payload.as_ref()))
}

thread_local! {
    /// Whether a panic on this thread becomes a diagnostic.
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// Keeps guarded panics off standard error; all others are reported as before.
fn silence_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let report = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if !GUARDED.get() {
                report(info);
            }
        }));
    });
}

fn message(payload: &(dyn std::any::Any + Send)) -> String {
    let text = payload
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| payload.downcast_ref::<&str>().copied());
    // The first line says it; what follows is a dump of the translator's innards.
    let first = text.and_then(|text| text.lines().next());
    first.unwrap_or("it stopped without a message").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_diagnostic() {
        let failure = guarded(|| -> u32 { panic!("no such {}\nthing", "type") }).err();
        let diagnostic = failure.expect("a failure").diagnostic();
        assert_eq!(diagnostic.code, "internal");
        assert!(
            diagnostic.message.ends_with("no such type"),
            "{}",
            diagnostic.message
        );
    }

    #[test]
    fn results_pass_through() {
        assert_eq!(guarded(|| 7).ok(), Some(7));
    }
}
