//! The user's configuration, and the folders of the system that belong to this program.

use std::fs::File;
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use etcetera::BaseStrategy as _;
use serde::Deserialize;

/// The most bytes that the file has; what is larger is something else.
const MAX_BYTES: u64 = 1 << 20;

/// What the user wants in every run, from `config.toml`.
#[derive(Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// The key to the site's interface.
    pub api_key: Option<String>,
    /// The folder with the site's media.
    pub media: Option<PathBuf>,
}

impl std::fmt::Debug for Config {
    /// The key is nobody else's business.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let api_key = self.api_key.as_ref().map(|_| "…");
        f.debug_struct("Config")
            .field("api_key", &api_key)
            .field("media", &self.media)
            .finish()
    }
}

/// Why there is no configuration.
#[derive(Debug, thiserror::Error)]
pub enum ConfigError {
    /// The file is there, but could not be read.
    #[error("cannot read `{}`: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: io::Error,
    },
    /// Something in it is wrong.
    #[error("`{}`{}: {message}", path.display(), line.map_or(String::new(), |line| format!(", line {line}")))]
    Content {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1, if it is known.
        line: Option<usize>,
        /// What is wrong.
        message: String,
    },
}

/// The configuration file's path, if the user has a home.
pub fn path() -> Option<PathBuf> {
    let base = etcetera::base_strategy::choose_native_strategy().ok()?;
    Some(base.config_dir().join("vitrine").join("config.toml"))
}

/// The folder for what can be fetched again, if the user has a home.
pub fn cache() -> Option<PathBuf> {
    let base = etcetera::base_strategy::choose_native_strategy().ok()?;
    Some(base.cache_dir().join("vitrine"))
}

impl Config {
    /// Reads the user's file; without one nothing is set.
    pub fn load() -> Result<Self, ConfigError> {
        path().map_or(Ok(Config::default()), |path| Config::read(&path))
    }

    /// Reads a file; one that is not there sets nothing.
    pub fn read(path: &Path) -> Result<Self, ConfigError> {
        let mut text = String::new();
        let read = File::open(path).and_then(|file| {
            let read = file.take(MAX_BYTES).read_to_string(&mut text)?;
            Ok(read)
        });
        match read {
            Ok(_) => {}
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Config::default()),
            Err(error) => {
                return Err(ConfigError::Io {
                    path: path.to_owned(),
                    error,
                });
            }
        }
        // The parser's own report would quote the line, and with it perhaps the key.
        toml::from_str(&text).map_err(|error| ConfigError::Content {
            path: path.to_owned(),
            line: error.span().map(|span| {
                let before = text.get(..span.start).unwrap_or_default();
                1 + before.matches('\n').count()
            }),
            message: match error.message().split_once(", expected ") {
                // It names the value, too.
                Some((wrong, expected)) if wrong.starts_with("invalid type") => {
                    format!("expected {expected}")
                }
                _ => error.message().to_owned(),
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_it_holds_and_what_it_must_not() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("config.toml");
        assert_eq!(Config::read(&path).unwrap(), Config::default());
        let read = |text: &str| {
            std::fs::write(&path, text).unwrap();
            Config::read(&path)
        };
        let config = read("api_key = \"fdKjWm\"\nmedia = \"/srv/media\"\n").unwrap();
        assert_eq!(config.api_key.as_deref(), Some("fdKjWm"));
        assert_eq!(config.media.as_deref(), Some(Path::new("/srv/media")));
        assert!(!format!("{config:?}").contains("fdKjWm"));
        let message = read("\napi_kay = \"fdKjWm\"").unwrap_err().to_string();
        assert!(
            message.contains("line 2: unknown field `api_kay`"),
            "{message}"
        );
        assert!(message.contains("`api_key`"), "{message}");
        for bad in [
            "api_key = 5",
            "api_key = 7777",
            "api_key = \"fdKjWm",
            "=",
            "[media]",
        ] {
            let message = read(bad).unwrap_err().to_string();
            assert!(message.contains("line 1"), "{message}");
            assert!(!message.contains("fdKjWm"), "{message}");
            assert!(!message.contains("7777"), "{message}");
        }
        std::fs::write(&path, b"\xff\xff").unwrap();
        assert!(
            Config::read(&path)
                .unwrap_err()
                .to_string()
                .contains("cannot read")
        );
    }
}
