use crate::glsl::arena::Id;
use crate::glsl::hir::{Constant, Global, Local};
use crate::glsl::names::Name;
use crate::glsl::syntax::ast::TokenIndex;
use crate::glsl::types::{Struct, Type};

/// What a name means.
#[derive(Clone, Copy, Debug)]
pub(super) enum Symbol {
    Local(Id<Local>),
    Global(Id<Global>),
    /// A member of a uniform block without an instance's name.
    BlockMember(Id<Global>, u32),
    /// A `const` variable.
    Constant(Type, Id<Constant>),
    Struct(Id<Struct>),
    /// A uniform block's name, which means nothing by itself.
    Block,
    /// A function of the author's, or several.
    Function,
    /// A declaration that was wrong: its uses are not reported again.
    Wrong,
}

/// A declared name.
#[derive(Clone, Copy, Debug)]
struct Entry {
    name: Name,
    symbol: Symbol,
    at: TokenIndex,
    depth: usize,
    /// What the name meant before.
    hidden: Option<u32>,
}

/// The names that are visible, §4.2. The global scope has depth 0.
#[derive(Debug)]
pub(super) struct Scopes {
    /// For each name, its innermost entry.
    visible: Vec<Option<u32>>,
    entries: Vec<Entry>,
    /// Number of entries when each scope but the global one was opened.
    opened: Vec<usize>,
}

impl Scopes {
    pub fn new(names: usize) -> Self {
        Scopes {
            visible: vec![None; names],
            entries: Vec::new(),
            opened: Vec::new(),
        }
    }

    pub fn open(&mut self) {
        self.opened.push(self.entries.len());
    }

    pub fn close(&mut self) {
        let begin = self.opened.pop().expect("as many closed as opened");
        for entry in self.entries.drain(begin..).rev() {
            self.visible[entry.name.index()] = entry.hidden;
        }
    }

    pub fn depth(&self) -> usize {
        self.opened.len()
    }

    fn entry(&self, name: Name) -> Option<&Entry> {
        let index = (*self.visible.get(name.index())?)?;
        Some(&self.entries[index as usize])
    }

    pub fn find(&self, name: Name) -> Option<Symbol> {
        self.entry(name).map(|entry| entry.symbol)
    }

    /// Where the innermost declaration of a name stands.
    pub fn declared_at(&self, name: Name) -> Option<TokenIndex> {
        self.entry(name).map(|entry| entry.at)
    }

    /// What a name means in the innermost scope.
    pub fn find_here(&self, name: Name) -> Option<Symbol> {
        let entry = self.entry(name)?;
        (entry.depth == self.depth()).then_some(entry.symbol)
    }

    /// Gives a name its meaning in the innermost scope; whatever it meant before is hidden.
    pub fn declare(&mut self, name: Name, symbol: Symbol, at: TokenIndex) {
        if self.visible.len() <= name.index() {
            self.visible.resize(name.index() + 1, None);
        }
        let index = self.entries.len() as u32;
        self.entries.push(Entry {
            name,
            symbol,
            at,
            depth: self.depth(),
            hidden: self.visible[name.index()].replace(index),
        });
    }

    /// All visible names that mean something.
    pub fn names(&self) -> impl Iterator<Item = Name> {
        let entries = self.entries.iter();
        entries
            .filter(|entry| !matches!(entry.symbol, Symbol::Wrong))
            .map(|entry| entry.name)
    }
}
