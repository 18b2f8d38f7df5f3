//! Interned names.

use std::hash::{Hash, Hasher};

use hashbrown::HashTable;
use rustc_hash::FxHasher;

/// A name of the program, interned: equal names are equal numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name(u32);

impl Name {
    /// The name's number among [`Names::len`].
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// All names of one program.
#[derive(Clone, Debug, Default)]
pub struct Names {
    by_text: HashTable<Name>,
    spellings: Spellings,
}

/// The spellings of names, one behind the other.
#[derive(Clone, Debug, Default)]
struct Spellings {
    text: String,
    /// Where each ends.
    ends: Vec<u32>,
}

impl Spellings {
    fn get(&self, Name(index): Name) -> &str {
        let end = |index: usize| self.ends[index] as usize;
        let index = index as usize;
        let start = if index == 0 { 0 } else { end(index - 1) };
        &self.text[start..end(index)]
    }
}

/// What a spelling is found by.
pub(super) fn hash(text: &str) -> u64 {
    let mut hasher = FxHasher::default();
    text.hash(&mut hasher);
    hasher.finish()
}

impl Names {
    /// The name with this spelling.
    pub fn intern(&mut self, text: &str) -> Name {
        self.intern_hashed(hash(text), text)
    }

    /// The same for a text whose [`hash`] is known.
    pub(super) fn intern_hashed(&mut self, hashed: u64, text: &str) -> Name {
        let spellings = &mut self.spellings;
        if let Some(&known) = (self.by_text).find(hashed, |&name| spellings.get(name) == text) {
            return known;
        }
        let name = Name(spellings.ends.len() as u32);
        spellings.text.push_str(text);
        spellings.ends.push(spellings.text.len() as u32);
        (self.by_text).insert_unique(hashed, name, |&name| hash(spellings.get(name)));
        name
    }

    /// How a name is spelled.
    ///
    /// # Panics
    /// When the name comes from another program.
    pub fn text(&self, name: Name) -> &str {
        self.spellings.get(name)
    }

    /// How many names there are.
    pub fn len(&self) -> usize {
        self.spellings.ends.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
