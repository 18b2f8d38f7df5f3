use std::sync::{Arc, Condvar, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// How long a frame may take before someone is told about it.
const NOTICE_AFTER: Duration = Duration::from_secs(5);

/// Watches from its own thread that frames keep being finished. Drivers may block for ever in any
/// call when a shader never ends, so no check on the drawing thread would be enough.
#[derive(Debug)]
pub struct Watchdog {
    shared: Arc<Shared>,
    limit: Option<Duration>,
}

#[derive(Debug)]
struct Shared {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug)]
struct State {
    /// When the frame under way was begun; `None` while nothing is being drawn.
    began: Option<Instant>,
    /// When the device last showed that it is not stuck.
    since: Instant,
    noticed: bool,
    dropped: bool,
}

impl Watchdog {
    /// Starts watching. `on_slow` is called once for a frame that takes some seconds, `on_stuck` for
    /// one that takes `limit`; it is expected to end the process. Without a limit nothing is ever
    /// stuck.
    pub fn start(
        limit: Option<Duration>,
        on_slow: impl Fn(Duration) + Send + 'static,
        on_stuck: impl Fn(Duration) + Send + 'static,
    ) -> Self {
        let shared = Arc::new(Shared {
            state: Mutex::new(State {
                began: None,
                since: Instant::now(),
                noticed: false,
                dropped: false,
            }),
            changed: Condvar::new(),
        });
        let watched = Arc::clone(&shared);
        thread::spawn(move || watch(&watched, limit, &on_slow, &on_stuck));
        Watchdog { shared, limit }
    }

    /// A frame was begun, or finished while others are under way; or the driver compiles for one.
    pub fn begin(&self) {
        self.set(Some(Instant::now()));
    }

    /// A part of the frame was finished: the device is not stuck, however long the whole may take.
    pub fn go_on(&self) {
        self.shared.state.lock().expect("no holder panics").since = Instant::now();
    }

    /// How long a frame may take.
    pub fn limit(&self) -> Option<Duration> {
        self.limit
    }

    /// Nothing is being drawn any more.
    pub fn rest(&self) {
        self.set(None);
    }

    fn set(&self, began: Option<Instant>) {
        let mut state = self.shared.state.lock().expect("no holder panics");
        let was_resting = state.began.is_none();
        state.began = began;
        state.since = Instant::now();
        state.noticed = false;
        drop(state);
        // A watcher that already counts down notices a new time by itself.
        if was_resting {
            self.shared.changed.notify_one();
        }
    }
}

impl Drop for Watchdog {
    fn drop(&mut self) {
        self.shared.state.lock().expect("no holder panics").dropped = true;
        self.shared.changed.notify_one();
    }
}

fn watch(
    shared: &Shared,
    limit: Option<Duration>,
    on_slow: &dyn Fn(Duration),
    on_stuck: &dyn Fn(Duration),
) {
    let mut state = shared.state.lock().expect("no holder panics");
    while !state.dropped {
        let Some(began) = state.began else {
            state = shared.changed.wait(state).expect("no holder panics");
            continue;
        };
        let elapsed = state.since.elapsed();
        if limit.is_some_and(|limit| elapsed >= limit) {
            state.began = None;
            drop(state);
            on_stuck(elapsed);
            state = shared.state.lock().expect("no holder panics");
            continue;
        }
        if began.elapsed() >= NOTICE_AFTER && !state.noticed {
            state.noticed = true;
            drop(state);
            on_slow(began.elapsed());
            state = shared.state.lock().expect("no holder panics");
            continue;
        }
        let to_notice = (!state.noticed).then(|| NOTICE_AFTER.saturating_sub(began.elapsed()));
        let to_limit = limit.map(|limit| limit.saturating_sub(elapsed));
        let next = to_notice.into_iter().chain(to_limit).min();
        let pause = next.unwrap_or(Duration::from_secs(3600));
        state = shared
            .changed
            .wait_timeout(state, pause)
            .expect("no holder panics")
            .0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc;

    #[test]
    fn a_frame_that_never_ends_is_reported_once() {
        let (sender, receiver) = mpsc::channel();
        let limit = Duration::from_millis(30);
        let watchdog = Watchdog::start(Some(limit), |_| {}, move |t| sender.send(t).unwrap());
        watchdog.begin();
        let late = receiver
            .recv_timeout(Duration::from_secs(60))
            .expect("a report");
        assert!(late >= limit);
        assert!(receiver.try_recv().is_err(), "once");
    }

    #[test]
    fn a_frame_that_goes_on_is_not_stuck() {
        let (sender, receiver) = mpsc::channel();
        let limit = Duration::from_millis(200);
        let watchdog = Watchdog::start(Some(limit), |_| {}, move |t| sender.send(t).unwrap());
        watchdog.begin();
        for _ in 0..20 {
            thread::sleep(Duration::from_millis(20));
            watchdog.go_on();
        }
        assert!(receiver.try_recv().is_err(), "it went on");
        assert!(receiver.recv_timeout(Duration::from_secs(60)).is_ok());
    }

    #[test]
    fn rest_is_never_late() {
        let (sender, receiver) = mpsc::channel();
        let limit = Duration::from_millis(20);
        let watchdog = Watchdog::start(Some(limit), |_| {}, move |t| sender.send(t).unwrap());
        watchdog.begin();
        watchdog.rest();
        assert!(receiver.recv_timeout(Duration::from_millis(100)).is_err());
        drop(watchdog);
    }
}
