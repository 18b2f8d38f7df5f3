//! Pictures out of ffmpeg, one behind the other.

use std::fmt;
use std::io::Read as _;
use std::path::Path;
use std::process::Child;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::super::MediaError;
use super::probe::{Facts, address, all, guarded, last_line, start};

/// Pictures that are decoded ahead.
const AHEAD: usize = 2;
/// How far before the first wanted picture decoding begins, in seconds: what is seen then may have begun to be shown before.
const LEAD: f64 = 2.0;

/// A running ffmpeg. It ends when this is dropped.
pub(super) struct Stream {
    child: Child,
    pictures: Option<Receiver<Vec<u8>>>,
    /// Gives back the memory of pictures.
    spare: Sender<Vec<u8>>,
    complaint: Option<JoinHandle<String>>,
    /// The number of the first picture, counted from the film's beginning.
    pub first: u64,
    /// The number of the picture that comes next.
    pub next: u64,
    /// Whether it was waited for in vain: then nobody waits again until something comes.
    is_late: bool,
}

impl fmt::Debug for Stream {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stream")
            .field("next", &self.next)
            .finish_non_exhaustive()
    }
}

/// What came.
pub(super) enum Next {
    /// A picture and its number.
    Picture(u64, Vec<u8>),
    /// There are no more.
    Ended,
    /// It takes too long.
    Late,
}

impl Stream {
    /// Starts ffmpeg so that the picture `first` is what comes next.
    pub(super) fn start(path: &Path, facts: &Facts, first: u64) -> Result<Stream, MediaError> {
        let rate = facts.rate();
        let [width, height] = facts.size;
        let lead = first.min((LEAD * rate).ceil() as u64);
        let mut command = guarded("ffmpeg", path, facts.demuxer);
        command.arg("-nostdin");
        if first > lead {
            // A quarter of a picture before it, as times in files are rounded.
            let seconds = ((first - lead) as f64 - 0.25) / rate;
            command.arg("-ss").arg(format!("{seconds:.6}"));
        }
        command.arg("-i").arg(address(path));
        command.args(["-map", "0:V:0", "-an", "-sn", "-dn", "-vf"]);
        let [over, under] = facts.rate;
        command.arg(format!(
            "fps={over}/{under}:start_time=0:round=near,trim=start_frame={lead},setpts=PTS-STARTPTS,\
             scale={width}:{height},format=rgba"
        ));
        command.args(["-f", "rawvideo", "-pix_fmt", "rgba", "pipe:1"]);
        let mut child = start(command, path)?;
        let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
        let (sender, pictures) = mpsc::sync_channel(AHEAD);
        let (spare, spares) = mpsc::channel::<Vec<u8>>();
        let length = 4 * width as usize * height as usize;
        thread::spawn(move || {
            let Some(mut pipe) = stdout else { return };
            loop {
                let mut picture = spares.try_recv().unwrap_or_default();
                picture.resize(length, 0);
                // Nobody listens any more when the stream was dropped.
                if pipe.read_exact(&mut picture).is_err() || sender.send(picture).is_err() {
                    return;
                }
            }
        });
        Ok(Stream {
            child,
            pictures: Some(pictures),
            spare,
            complaint: Some(thread::spawn(move || all(stderr))),
            first,
            next: first,
            is_late: false,
        })
    }

    /// The next picture, which is waited for so long and no longer.
    pub(super) fn next(&mut self, patience: Duration) -> Next {
        let Some(pictures) = &self.pictures else {
            return Next::Ended;
        };
        let patience = if self.is_late {
            Duration::ZERO
        } else {
            patience
        };
        match pictures.recv_timeout(patience) {
            Ok(picture) => {
                self.is_late = false;
                self.next += 1;
                Next::Picture(self.next - 1, picture)
            }
            Err(RecvTimeoutError::Timeout) => {
                self.is_late = true;
                Next::Late
            }
            Err(RecvTimeoutError::Disconnected) => Next::Ended,
        }
    }

    /// Takes back the memory of a picture.
    pub(super) fn give_back(&self, picture: Vec<u8>) {
        let _ = self.spare.send(picture);
    }

    /// What ffmpeg had to complain about, once it has ended.
    pub(super) fn complaint(mut self) -> Option<String> {
        self.end();
        let text = self.complaint.take()?.join().ok()?;
        last_line(&text).map(str::to_owned)
    }

    fn end(&mut self) {
        // First the channel, so that the thread that reads does not wait for room in it.
        self.pictures = None;
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Stream {
    fn drop(&mut self) {
        self.end();
    }
}
