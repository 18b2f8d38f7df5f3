//! Follows the files of a scene.
//!
//! Editors save in different ways: some write the file in place, some (Vim, many IDEs) write another
//! file and rename it over the old one, which a watch on the file itself would not survive. So the
//! parent folders are watched, and events are told apart by name.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use notify::event::{AccessKind, AccessMode, EventKind};
use notify::{RecommendedWatcher, RecursiveMode, Watcher as _};

/// A change counts once nothing more has happened for this long: editors save in several steps.
const SETTLE: Duration = Duration::from_millis(30);

/// A change counts at the latest after this long, however busy the files are.
const SETTLE_AT_MOST: Duration = Duration::from_millis(300);

/// A watch over the files of one scene at a time.
pub(super) struct FileWatch {
    watcher: RecommendedWatcher,
    files: Arc<Mutex<HashSet<PathBuf>>>,
    folders: HashSet<PathBuf>,
}

impl FileWatch {
    /// Starts watching nothing. `changed` is called, on another thread, with the time at which the
    /// first of a burst of changes was seen.
    pub fn start(changed: impl Fn(Instant) + Send + 'static) -> notify::Result<Self> {
        let files: Arc<Mutex<HashSet<PathBuf>>> = Arc::default();
        let watched = Arc::clone(&files);
        let (sender, receiver) = mpsc::channel();
        let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
            let Ok(event) = event else { return };
            let watched = watched.lock().expect("no holder panics");
            if changes_content(event.kind) && event.paths.iter().any(|path| watched.contains(path))
            {
                // The receiver is gone when the window is.
                let _ = sender.send(Instant::now());
            }
        })?;
        thread::spawn(move || {
            while let Ok(first) = receiver.recv() {
                settle(&receiver, first);
                changed(first);
            }
        });
        Ok(FileWatch {
            watcher,
            files,
            folders: HashSet::new(),
        })
    }

    /// Watches these files from now on, and no others. They need not exist, but their folders do.
    pub fn follow(&mut self, paths: &[PathBuf]) {
        let files: HashSet<PathBuf> = paths.iter().flat_map(|path| places(path)).collect();
        let folders: HashSet<PathBuf> = files
            .iter()
            .filter_map(|file| file.parent().map(Path::to_owned))
            .collect();
        *self.files.lock().expect("no holder panics") = files;
        for folder in self.folders.difference(&folders) {
            // A folder that is gone is no longer watched anyway.
            let _ = self.watcher.unwatch(folder);
        }
        self.folders = folders
            .into_iter()
            .filter(|folder| {
                self.folders.contains(folder)
                    || self
                        .watcher
                        .watch(folder, RecursiveMode::NonRecursive)
                        .is_ok()
            })
            .collect();
    }
}

/// Where a file can change: its own place, and behind a symbolic link its target's.
fn places(path: &Path) -> Vec<PathBuf> {
    let mut places = Vec::new();
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    if let (Ok(folder), Some(name)) = (folder.canonicalize(), path.file_name()) {
        places.push(folder.join(name));
    }
    if let Ok(target) = path.canonicalize() {
        places.push(target);
    }
    places
}

/// Reading a file is an event too, and must not look like a change.
fn changes_content(kind: EventKind) -> bool {
    match kind {
        EventKind::Access(AccessKind::Close(AccessMode::Write)) => true,
        EventKind::Access(_) => false,
        _ => true,
    }
}

fn settle(receiver: &mpsc::Receiver<Instant>, first: Instant) {
    while first.elapsed() < SETTLE_AT_MOST {
        match receiver.recv_timeout(SETTLE) {
            Ok(_) => {}
            Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => return,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    struct Watched {
        folder: tempfile::TempDir,
        watch: FileWatch,
        changes: mpsc::Receiver<Instant>,
    }

    fn watched(name: &str) -> (Watched, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(name);
        fs::write(&file, "a").unwrap();
        let (sender, changes) = mpsc::channel();
        let mut watch = FileWatch::start(move |at| sender.send(at).unwrap_or(())).unwrap();
        watch.follow(std::slice::from_ref(&file));
        let watched = Watched {
            folder,
            watch,
            changes,
        };
        (watched, file)
    }

    fn changed(watched: &Watched) -> bool {
        watched
            .changes
            .recv_timeout(Duration::from_secs(20))
            .is_ok()
    }

    fn quiet(watched: &Watched) -> bool {
        watched
            .changes
            .recv_timeout(Duration::from_millis(150))
            .is_err()
    }

    #[test]
    fn writing_in_place_is_one_change() {
        let (watched, file) = watched("a.glsl");
        fs::write(&file, "b").unwrap();
        assert!(changed(&watched));
        assert!(quiet(&watched));
    }

    #[test]
    fn renaming_over_the_file_is_a_change_every_time() {
        let (watched, file) = watched("a.glsl");
        for text in ["b", "c"] {
            let aside = watched.folder.path().join("4913~");
            fs::write(&aside, text).unwrap();
            fs::rename(&aside, &file).unwrap();
            assert!(changed(&watched), "{text}");
        }
    }

    #[test]
    fn reading_and_neighbours_are_no_changes() {
        let (watched, file) = watched("a.glsl");
        fs::read(&file).unwrap();
        fs::write(watched.folder.path().join("b.glsl"), "b").unwrap();
        assert!(quiet(&watched));
    }

    #[test]
    fn a_file_that_is_not_there_yet_can_appear() {
        let (mut watched, _) = watched("a.glsl");
        let later = watched.folder.path().join("later.glsl");
        watched.watch.follow(std::slice::from_ref(&later));
        fs::write(&later, "b").unwrap();
        assert!(changed(&watched));
    }
}
