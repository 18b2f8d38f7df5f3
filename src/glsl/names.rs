//! Interned names.

use std::sync::Arc;

use rustc_hash::FxHashMap;

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
    by_text: FxHashMap<Arc<str>, Name>,
    texts: Vec<Arc<str>>,
}

impl Names {
    /// The name with this spelling.
    pub fn intern(&mut self, text: &str) -> Name {
        if let Some(&known) = self.by_text.get(text) {
            return known;
        }
        let name = Name(self.texts.len() as u32);
        let text: Arc<str> = text.into();
        self.texts.push(text.clone());
        self.by_text.insert(text, name);
        name
    }

    /// The name with this spelling, if the program has it.
    pub fn find(&self, text: &str) -> Option<Name> {
        self.by_text.get(text).copied()
    }

    /// How a name is spelled.
    ///
    /// # Panics
    /// When the name comes from another program.
    pub fn text(&self, name: Name) -> &str {
        &self.texts[name.0 as usize]
    }

    /// How many names there are.
    pub fn len(&self) -> usize {
        self.texts.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty()
    }
}
