use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use super::{Scene, file, folder};
use crate::source::{Diagnostic, FileId, Report, SourceMap, Span};

/// The most text that a scene has, all its files together. The longest of some 141,000 passes
/// published on the site has 2.4 MB; what is larger than this is not a shader.
pub const MAX_BYTES: u64 = 8 << 20;

/// Where a scene comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// A file with the text of an Image pass or with ShaderToy's JSON, or a scene folder.
    Path(PathBuf),
    /// Text that lies in no file: standard input, the clipboard.
    Text {
        /// What to call it, `<stdin>` say.
        name: String,
        /// The text as it came in, not yet known to be UTF-8.
        bytes: Vec<u8>,
    },
    /// The scene that the program carries with it.
    Embedded,
}

/// Why there is no scene.
#[derive(Debug)]
pub struct LoadError {
    /// What went wrong.
    pub kind: LoadErrorKind,
    /// The files that the attempt looked at: a change to one of them may mend it.
    pub read: Vec<PathBuf>,
}

/// The two kinds of failure that a caller treats differently.
#[derive(Debug)]
pub enum LoadErrorKind {
    /// The texts are there, and something in them is wrong.
    Scene(Report),
    /// A file could not be read.
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: io::Error,
    },
}

/// Reads a scene and resolves everything that it refers to.
pub fn load(source: &Source) -> Result<Scene, LoadError> {
    let (parts, loading) = attempt(source, |loading| match source {
        Source::Path(path) if path.is_dir() => folder::load(loading, path),
        Source::Path(path) => file::load(loading, path),
        Source::Text { name, bytes } => file::load_text(loading, name, bytes),
        Source::Embedded => folder::load(loading, Path::new(folder::EMBEDDED)),
    })?;
    Ok(Scene {
        // It goes to terminals and title bars, which obey control characters.
        name: parts.name.replace(char::is_control, " "),
        size: parts.size,
        passes: parts.passes,
        warnings: loading.warnings,
        files: loading.files,
        read: loading.read,
    })
}

/// Reads something of a source, and keeps the files that it looked at, whatever comes of it.
pub(super) fn attempt<T>(
    source: &Source,
    work: impl FnOnce(&mut Loading) -> Result<T, Failure>,
) -> Result<(T, Loading), LoadError> {
    let mut loading = Loading {
        files: SourceMap::default(),
        warnings: Vec::new(),
        read: Vec::new(),
        bytes: 0,
        disk: match source {
            Source::Embedded => Disk::Embedded,
            _ => Disk::Real,
        },
    };
    match work(&mut loading) {
        Ok(made) => Ok((made, loading)),
        Err(Failure::Scene(diagnostics)) => Err(LoadError {
            kind: LoadErrorKind::Scene(Report {
                files: loading.files,
                diagnostics,
            }),
            read: loading.read,
        }),
        Err(Failure::Io(path, error)) => Err(LoadError {
            kind: LoadErrorKind::Io { path, error },
            read: loading.read,
        }),
    }
}

/// What a form of input turns into; [`load`] adds the files.
pub(super) struct Parts {
    pub name: String,
    pub size: Option<[u32; 2]>,
    pub passes: Vec<super::Pass>,
}

/// Why a form of input gave no scene.
pub(super) enum Failure {
    Scene(Vec<Diagnostic>),
    Io(PathBuf, io::Error),
}

impl From<Diagnostic> for Failure {
    fn from(diagnostic: Diagnostic) -> Self {
        Failure::Scene(vec![diagnostic])
    }
}

/// A load under way: what has been read so far, and from where.
pub(super) struct Loading {
    pub files: SourceMap,
    pub warnings: Vec<Diagnostic>,
    read: Vec<PathBuf>,
    /// How much text that is.
    bytes: u64,
    disk: Disk,
}

#[derive(Clone, Copy)]
enum Disk {
    Real,
    Embedded,
}

impl Loading {
    /// Whether there is such a file, and it is not a folder.
    pub fn is_file(&self, path: &Path) -> bool {
        match self.disk {
            Disk::Real => path.exists() && !path.is_dir(),
            Disk::Embedded => folder::embedded(path).is_some(),
        }
    }

    /// Whether `path`, symbolic links followed, lies in the folder `root` or below it.
    pub fn lies_within(&self, path: &Path, root: &Path) -> bool {
        match self.disk {
            Disk::Real => match (path.canonicalize(), root.canonicalize()) {
                (Ok(path), Ok(root)) => path.starts_with(root),
                // A file that is not there is reported as such when it is read.
                _ => true,
            },
            Disk::Embedded => true,
        }
    }

    /// Notes that the scene depends on `path`, whether or not it can be read.
    pub fn depends_on(&mut self, path: &Path) {
        self.read.push(path.to_owned());
    }

    /// Reads a text file.
    pub fn read(&mut self, path: &Path) -> Result<FileId, Failure> {
        self.depends_on(path);
        let bytes = match self.disk {
            Disk::Real => read_at_most(path, MAX_BYTES + 1),
            Disk::Embedded => folder::embedded(path)
                .map(|text| text.as_bytes().to_vec())
                .ok_or_else(|| io::ErrorKind::NotFound.into()),
        }
        .map_err(|error| Failure::Io(path.to_owned(), error))?;
        self.accept(&path.display().to_string(), &bytes)
    }

    /// Reads the text of a pass as it is, characters included that no shader can have.
    pub fn read_code(&mut self, path: &Path) -> Result<String, Failure> {
        self.depends_on(path);
        let bytes = read_at_most(path, MAX_BYTES + 1)
            .map_err(|error| Failure::Io(path.to_owned(), error))?;
        match String::from_utf8(bytes) {
            Ok(text) if text.len() as u64 <= MAX_BYTES => Ok(text),
            Ok(text) => {
                let file = self.accept(&path.display().to_string(), text.as_bytes())?;
                Ok(self.files.get(file).text.clone())
            }
            Err(error) => {
                let file = self.accept(&path.display().to_string(), error.as_bytes())?;
                Ok(self.files.get(file).text.clone())
            }
        }
    }

    /// Takes bytes as a text, if they are one.
    pub fn accept(&mut self, name: &str, bytes: &[u8]) -> Result<FileId, Failure> {
        self.bytes += bytes.len() as u64;
        if self.bytes > MAX_BYTES {
            let file = self.files.add(name, "");
            return Err(Diagnostic::error(
                "too-large",
                format!("the scene's text is larger than {} MiB", MAX_BYTES >> 20),
            )
            .at(self.files.whole(file))
            .hint("name a file of GLSL source text")
            .into());
        }
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            return Err(self.not_text(name, &[], "not-utf8", "the text is UTF-16, not UTF-8"));
        }
        match std::str::from_utf8(bytes) {
            Ok(text) if !text.contains('\0') => Ok(self.files.add(name, text)),
            Ok(_) => Err(self.not_text(
                name,
                bytes,
                "binary",
                "this is a binary file, not GLSL text",
            )),
            // Text in an old encoding has stray high bytes; control characters mean something else.
            Err(_) if bytes.iter().any(|&byte| byte < 0x09) => Err(self.not_text(
                name,
                bytes,
                "binary",
                "this is a binary file, not GLSL text",
            )),
            Err(error) => {
                let bad = bytes[error.valid_up_to()];
                let message =
                    format!("the text is not UTF-8: byte 0x{bad:02x} begins no character");
                Err(self.not_text(name, bytes, "not-utf8", &message))
            }
        }
    }

    /// An error at the first byte that is not text. The file is kept up to there, for the excerpt.
    fn not_text(&mut self, name: &str, bytes: &[u8], code: &'static str, message: &str) -> Failure {
        let readable = match code {
            "not-utf8" => std::str::from_utf8(bytes).map_or_else(|e| e.valid_up_to(), str::len),
            _ => 0,
        };
        let text = std::str::from_utf8(&bytes[..readable]).unwrap_or_default();
        let file = self.files.add(name, text);
        let end = self.files.whole(file).end;
        Diagnostic::error(code, message)
            .at(Span {
                file,
                start: end,
                end,
            })
            .hint(match code {
                "not-utf8" => "save the file again as UTF-8",
                _ => "name a text file that holds GLSL source",
            })
            .into()
    }
}

fn read_at_most(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(limit).read_to_end(&mut bytes)?;
    Ok(bytes)
}
