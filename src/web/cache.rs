use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::ShaderId;
use crate::output::{self, WriteError};
use crate::scene::MAX_BYTES;

/// The answers that were fetched before, a file each.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// The one in the program's folder for what can be fetched again.
    pub fn within(folder: &Path) -> Self {
        Cache {
            folder: folder.join("shaders"),
        }
    }

    fn path(&self, id: &ShaderId) -> PathBuf {
        self.folder.join(format!("{}.json", id.as_str()))
    }

    /// What was answered for this id. What is damaged is as good as not there, and so is another shader's answer: some
    /// systems do not tell capital letters in the names of files from small ones, and ids do.
    pub fn get(&self, id: &ShaderId) -> Option<Vec<u8>> {
        let mut bytes = Vec::new();
        let file = File::open(self.path(id)).ok()?;
        file.take(MAX_BYTES + 1).read_to_end(&mut bytes).ok()?;
        let answer: Value = serde_json::from_slice(&bytes).ok()?;
        (answer["Shader"]["info"]["id"] == id.as_str()).then_some(bytes)
    }

    /// Keeps an answer.
    pub fn keep(&self, id: &ShaderId, answer: &[u8]) -> Result<(), WriteError> {
        let path = self.path(id);
        output::place(&path, answer, true).map_err(|error| WriteError { path, error })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_gives_what_it_was_given_and_nothing_damaged() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::within(folder.path());
        let id = ShaderId::from_word("4dXGR8").unwrap();
        assert_eq!(cache.get(&id), None);
        let answer = br#"{"Shader":{"info":{"id":"4dXGR8"}}}"#;
        cache.keep(&id, answer).unwrap();
        assert_eq!(cache.get(&id).as_deref(), Some(&answer[..]));
        for other in [
            &answer[..20],
            br#"{"Shader":{"info":{"id":"4dxgr8"}}}"#,
            b"[]",
        ] {
            cache.keep(&id, other).unwrap();
            assert_eq!(cache.get(&id), None);
        }
    }
}
