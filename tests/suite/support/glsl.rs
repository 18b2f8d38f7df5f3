//! Folders of small GLSL files, each about one subject, and what their headers say.

use std::fs;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use vitrine::scene::{LoadErrorKind, Scene, Source, load};
use vitrine::source::Report;
use vitrine::translate::{Options, Program, translate};

use super::{plain, repository};

/// One file: the text of an Image pass.
pub struct Case {
    /// Its name without `.glsl`.
    pub name: String,
    pub text: Vec<u8>,
}

/// All `*.glsl` in a folder, a path in the repository or an absolute one, sorted by name.
pub fn cases(folder: &str) -> Vec<Case> {
    let folder = repository(folder);
    let entries = fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{} is a folder: {error}", folder.display()));
    let mut cases: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "glsl"))
        .map(|path| Case {
            name: path
                .file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned(),
            text: fs::read(&path).expect("a readable file"),
        })
        .collect();
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    assert!(!cases.is_empty(), "{} has no files", folder.display());
    cases
}

impl Case {
    /// What its header says behind `// key: `, one item for each line. Lines end as they like: some
    /// files are about that.
    pub fn header(&self, key: &str) -> Vec<String> {
        let text = String::from_utf8_lossy(&self.text);
        let start = format!("// {key}: ");
        text.split(['\r', '\n'])
            .take_while(|line| line.is_empty() || line.starts_with("//"))
            .filter_map(|line| Some(line.strip_prefix(&start)?.trim_end().to_owned()))
            .collect()
    }

    /// Loads and translates it. In a strict translation everything that WebGL2 refuses is an error.
    pub fn translated(&self, strict: bool) -> Result<(Scene, Vec<Program>), Report> {
        self.translated_with(&Options {
            strict,
            ..Options::default()
        })
    }

    /// The warnings that it runs with, or why it does not run, as a person reads them.
    pub fn warnings(&self, strict: bool) -> Result<String, String> {
        let (scene, programs) = self.translated(strict).map_err(|report| plain(&report))?;
        Ok(plain(&Report {
            files: scene.files,
            diagnostics: programs.into_iter().flat_map(|p| p.warnings).collect(),
        }))
    }

    /// Loads and translates it with any options.
    pub fn translated_with(&self, options: &Options) -> Result<(Scene, Vec<Program>), Report> {
        let source = Source::Text {
            name: format!("{}.glsl", self.name),
            bytes: self.text.clone(),
        };
        let scene = load(&source).map_err(|error| match error.kind {
            LoadErrorKind::Scene(report) => report,
            LoadErrorKind::Io { path, error } => panic!("{}: {error}", path.display()),
        })?;
        let programs = translate(&scene, options)?;
        Ok((scene, programs))
    }
}

/// Does `work` for each item, on as many threads as there are cores; the results are in the items' order.
pub fn on_every_core<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            match items.get(index) {
                Some(item) => done.push((index, work(item))),
                None => return done,
            }
        }
    };
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let mut done: Vec<_> = thread::scope(|scope| {
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(worker)).collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().expect("the work does not panic"))
            .collect()
    });
    done.sort_by_key(|&(index, _)| index);
    done.into_iter().map(|(_, result)| result).collect()
}
