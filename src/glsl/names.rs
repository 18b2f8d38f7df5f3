//! Interned spellings: of names, of numbers and of the language's own vocabulary.

use std::borrow::Cow;
use std::hash::{Hash, Hasher};
use std::sync::LazyLock;

use hashbrown::HashTable;
use rustc_hash::FxHasher;

use super::words::{self, Symbol};

/// A spelling, interned: equal ones are equal numbers. The vocabulary of the language has the first
/// numbers, in every program the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name(u32);

impl Name {
    /// The name's number among [`Names::count`].
    pub fn index(self) -> usize {
        self.0 as usize
    }

    /// Whether it is a keyword, or a word that is kept for one.
    pub fn is_word(self) -> bool {
        (Symbol::ALL.len()..words::COUNT).contains(&self.index())
    }

    /// The operator or bracket that is spelled so.
    pub(super) fn symbol(self) -> Option<Symbol> {
        Symbol::ALL.get(self.index()).copied()
    }
}

impl From<Symbol> for Name {
    fn from(symbol: Symbol) -> Self {
        Name(symbol as u32)
    }
}

/// Where names are looked up by what they are made of.
type Table = HashTable<Entry>;

#[derive(Clone, Copy, Debug)]
struct Entry {
    /// The bytes themselves, as [`packed`]; 0 where they do not fit.
    packed: u64,
    name: Name,
}

/// The bytes of a spelling as one number, which no other spelling has, so that it need not be compared
/// as a text; 0 if there are more than 8.
fn packed(text: &str) -> u64 {
    match text.len() {
        ..=PACKED => text.bytes().fold(0, pack),
        _ => 0,
    }
}

/// How many bytes are [`packed`] at most.
const PACKED: usize = 8;

/// A packed spelling with one more byte.
#[inline]
pub(super) fn pack(packed: u64, byte: u8) -> u64 {
    packed << 8 | u64::from(byte)
}

/// What a spelling is found by.
#[inline]
fn hash(packed: u64, text: &str) -> u64 {
    let mut hasher = FxHasher::default();
    match packed {
        0 => text.hash(&mut hasher),
        _ => packed.hash(&mut hasher),
    }
    hasher.finish()
}

/// The words of the language.
struct Vocabulary {
    /// Those that are made of letters.
    words: Table,
    spellings: Vec<&'static str>,
}

static VOCABULARY: LazyLock<Vocabulary> = LazyLock::new(|| {
    let spellings: Vec<_> = words::vocabulary().map(|(text, _)| text).collect();
    // Room for most programs' own names.
    let mut words = Table::with_capacity(800);
    for (index, text) in spellings.iter().enumerate().skip(Symbol::ALL.len()) {
        let name = Name(index as u32);
        let packed = packed(text);
        let hash_of = |entry: &Entry| hash(entry.packed, spellings[entry.name.index()]);
        words.insert_unique(hash(packed, text), Entry { packed, name }, hash_of);
    }
    Vocabulary { words, spellings }
});

/// All names of one program, and the language's.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// Both, once there are own ones.
    table: Table,
    own: Spellings,
}

/// The spellings that are not the language's, one behind the other.
#[derive(Clone, Debug, Default)]
struct Spellings {
    text: String,
    /// Where each ends.
    ends: Vec<u32>,
}

impl Spellings {
    fn get(&self, name: Name) -> &str {
        let index = name.index() - words::COUNT;
        let end = |index: usize| self.ends[index] as usize;
        let start = if index == 0 { 0 } else { end(index - 1) };
        &self.text[start..end(index)]
    }
}

impl Names {
    /// The name with this spelling, which may be an operator's or a bracket's.
    pub fn intern(&mut self, text: &str) -> Name {
        let mut symbols = Symbol::ALL.iter();
        match symbols.find(|symbol| symbol.text() == text) {
            Some(symbol) => (*symbol).into(),
            None => self.intern_word(text),
        }
    }

    /// The name with this spelling, which is no operator's or bracket's.
    pub(super) fn intern_word(&mut self, text: &str) -> Name {
        self.intern_packed(packed(text), text)
    }

    /// The same for a spelling that is packed already, if it has no more than 8 bytes.
    #[inline]
    pub(super) fn intern_packed(&mut self, packed: u64, text: &str) -> Name {
        let packed = if text.len() <= PACKED { packed } else { 0 };
        let hashed = hash(packed, text);
        match self.find_packed(packed, hashed, text) {
            Some(known) => known,
            None => self.add(packed, hashed, text),
        }
    }

    /// The name with this spelling, if there is one.
    pub fn find(&self, text: &str) -> Option<Name> {
        let packed = packed(text);
        self.find_packed(packed, hash(packed, text), text)
    }

    #[inline]
    fn find_packed(&self, packed: u64, hashed: u64, text: &str) -> Option<Name> {
        let table = match self.own.ends.is_empty() {
            true => &VOCABULARY.words,
            false => &self.table,
        };
        let is_it = |entry: &Entry| {
            entry.packed == packed && (packed != 0 || self.text(entry.name) == text)
        };
        table.find(hashed, is_it).map(|entry| entry.name)
    }

    #[cold]
    fn add(&mut self, packed: u64, hashed: u64, text: &str) -> Name {
        if self.own.ends.is_empty() {
            self.table.clone_from(&VOCABULARY.words);
        }
        let name = Name(self.count() as u32);
        self.own.text.push_str(text);
        self.own.ends.push(self.own.text.len() as u32);
        let Names { table, own } = self;
        let text = |name| spelling(name, own);
        let hash_of = |entry: &Entry| hash(entry.packed, text(entry.name));
        table.insert_unique(hashed, Entry { packed, name }, hash_of);
        name
    }

    /// How a name is spelled.
    ///
    /// # Panics
    /// When the name comes from another program.
    pub fn text(&self, name: Name) -> &str {
        spelling(name, &self.own)
    }

    /// The spelling, cut where a message would get too long.
    pub(super) fn quoted(&self, name: Name) -> Cow<'_, str> {
        const MOST: usize = 60;
        let text = self.text(name);
        match text.char_indices().nth(MOST) {
            Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
            None => Cow::Borrowed(text),
        }
    }

    /// How many names there are, those of the language included.
    pub fn count(&self) -> usize {
        words::COUNT + self.own.ends.len()
    }
}

fn spelling(name: Name, own: &Spellings) -> &str {
    match VOCABULARY.spellings.get(name.index()) {
        Some(text) => text,
        None => own.get(name),
    }
}
