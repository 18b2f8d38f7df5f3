//! Threads that turn pictures into files while the next ones are drawn.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, mpsc};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use crate::frame::FrameImage;
use crate::output::{PngSink, WriteError};

/// More threads than this help no disk.
const MAX_THREADS: usize = 8;

struct Job {
    path: PathBuf,
    image: FrameImage,
}

struct Finished {
    image: FrameImage,
    result: Result<(), WriteError>,
    took: Duration,
}

/// A fixed set of threads and of pictures that go round between them and their caller.
pub(super) struct Encoders {
    jobs: mpsc::Sender<Job>,
    finished: mpsc::Receiver<Finished>,
    free: Vec<FrameImage>,
    /// Pictures handed out to the threads.
    busy: usize,
    threads: Vec<JoinHandle<()>>,
    /// Files written so far.
    pub written: u32,
    /// Time spent encoding and writing, all threads together.
    pub spent: Duration,
}

impl Encoders {
    pub fn start(overwrite: bool) -> Self {
        let count = thread::available_parallelism().map_or(1, |n| n.get().min(MAX_THREADS));
        let (jobs, queue) = mpsc::channel::<Job>();
        let (done, finished) = mpsc::channel();
        let queue = Arc::new(Mutex::new(queue));
        let threads = (0..count)
            .map(|_| {
                let (queue, done) = (Arc::clone(&queue), done.clone());
                thread::spawn(move || work(&queue, &done, overwrite))
            })
            .collect();
        Encoders {
            jobs,
            finished,
            // One more than there are threads, to be filled while all of them are busy.
            free: vec![FrameImage::default(); count + 1],
            busy: 0,
            threads,
            written: 0,
            spent: Duration::ZERO,
        }
    }

    /// A picture to fill; waits for one if all are being written.
    pub fn blank(&mut self) -> Result<FrameImage, WriteError> {
        while let Ok(finished) = self.finished.try_recv() {
            self.account(finished)?;
        }
        while self.free.is_empty() {
            self.wait_for_one()?;
        }
        Ok(self.free.pop().expect("just checked"))
    }

    /// Hands a picture over to be written to `path`.
    pub fn write(&mut self, path: PathBuf, image: FrameImage) {
        self.busy += 1;
        let sent = self.jobs.send(Job { path, image });
        assert!(sent.is_ok(), "the threads outlive their queue");
    }

    /// Waits until everything is written.
    pub fn finish(mut self) -> Result<(u32, Duration), WriteError> {
        let mut first_error = None;
        while self.busy > 0 {
            if let Err(error) = self.wait_for_one() {
                first_error.get_or_insert(error);
            }
        }
        drop(self.jobs);
        for thread in self.threads {
            let _ = thread.join();
        }
        match first_error {
            Some(error) => Err(error),
            None => Ok((self.written, self.spent)),
        }
    }

    fn wait_for_one(&mut self) -> Result<(), WriteError> {
        let finished = self
            .finished
            .recv()
            .expect("the threads outlive their queue");
        self.account(finished)
    }

    fn account(&mut self, finished: Finished) -> Result<(), WriteError> {
        self.busy -= 1;
        self.spent += finished.took;
        self.free.push(finished.image);
        finished.result?;
        self.written += 1;
        Ok(())
    }
}

fn work(queue: &Mutex<mpsc::Receiver<Job>>, done: &mpsc::Sender<Finished>, overwrite: bool) {
    let mut sink = PngSink::default();
    loop {
        let next = queue.lock().expect("no holder panics").recv();
        // The queue ends when the export does.
        let Ok(Job { path, image }) = next else {
            return;
        };
        let start = Instant::now();
        let result = sink.write(&path, &image, overwrite);
        let finished = Finished {
            image,
            result,
            took: start.elapsed(),
        };
        if done.send(finished).is_err() {
            return;
        }
    }
}
