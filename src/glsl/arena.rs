//! Lists whose elements are named by small numbers instead of pointers: trees in them are compact,
//! have no depth for a destructor to overflow on, and are `Copy` to refer to.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// Names one element of an [`Arena`].
pub struct Id<T> {
    index: u32,
    of: PhantomData<fn() -> T>,
}

impl<T> Id<T> {
    /// The element's place in its arena.
    pub fn index(self) -> usize {
        self.index as usize
    }

    /// Names the element at a place.
    pub fn new(index: usize) -> Self {
        Id {
            index: index as u32,
            of: PhantomData,
        }
    }
}

impl<T> Clone for Id<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Id<T> {}

impl<T> PartialEq for Id<T> {
    fn eq(&self, other: &Self) -> bool {
        self.index == other.index
    }
}

impl<T> Eq for Id<T> {}

impl<T> Hash for Id<T> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.index.hash(state);
    }
}

impl<T> PartialOrd for Id<T> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl<T> Ord for Id<T> {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.index.cmp(&other.index)
    }
}

impl<T> fmt::Debug for Id<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.index)
    }
}

/// A row of elements in a [`Pool`].
pub struct Range<T> {
    start: u32,
    len: u32,
    of: PhantomData<fn() -> T>,
}

impl<T> Clone for Range<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Range<T> {}

impl<T> Default for Range<T> {
    /// Of no elements.
    fn default() -> Self {
        Range {
            start: 0,
            len: 0,
            of: PhantomData,
        }
    }
}

impl<T> fmt::Debug for Range<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}+{}", self.start, self.len)
    }
}

impl<T> Range<T> {
    /// Number of elements.
    pub fn len(self) -> usize {
        self.len as usize
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.len == 0
    }
}

/// Short rows of elements, one behind the other.
#[derive(Clone, Debug)]
pub struct Pool<T> {
    items: Vec<T>,
}

impl<T> Default for Pool<T> {
    fn default() -> Self {
        Pool { items: Vec::new() }
    }
}

impl<T: Copy> Pool<T> {
    /// Adds a row.
    pub fn add(&mut self, row: &[T]) -> Range<T> {
        self.extend(row.iter().copied())
    }

    /// Makes room for more elements.
    pub fn reserve(&mut self, more: usize) {
        self.items.reserve(more);
    }

    /// Adds a row whose elements are made on the way.
    pub fn extend(&mut self, row: impl Iterator<Item = T>) -> Range<T> {
        let start = self.items.len();
        self.items.extend(row);
        Range {
            start: start as u32,
            len: (self.items.len() - start) as u32,
            of: PhantomData,
        }
    }

    /// The elements of a row.
    pub fn get(&self, range: Range<T>) -> &[T] {
        &self.items[range.start as usize..][..range.len as usize]
    }
}

/// A growing list, indexed by [`Id`].
#[derive(Clone, Debug)]
pub struct Arena<T> {
    items: Vec<T>,
}

impl<T> Default for Arena<T> {
    fn default() -> Self {
        Arena { items: Vec::new() }
    }
}

impl<T> Arena<T> {
    /// Makes room for more elements.
    pub fn reserve(&mut self, more: usize) {
        self.items.reserve(more);
    }

    /// Adds an element.
    pub fn add(&mut self, item: T) -> Id<T> {
        let id = Id::new(self.items.len());
        self.items.push(item);
        id
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// All elements with their names, in the order of addition.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (Id<T>, &T)> {
        self.items
            .iter()
            .enumerate()
            .map(|(i, item)| (Id::new(i), item))
    }

    /// All names, in the order of addition.
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = Id<T>> + use<T> {
        (0..self.items.len()).map(Id::new)
    }
}

/// Some of an [`Arena`]'s elements.
pub struct IdSet<T> {
    /// A bit for each element.
    bits: Vec<u64>,
    of: PhantomData<fn() -> T>,
}

impl<T> Default for IdSet<T> {
    fn default() -> Self {
        IdSet {
            bits: Vec::new(),
            of: PhantomData,
        }
    }
}

impl<T> Clone for IdSet<T> {
    fn clone(&self) -> Self {
        IdSet {
            bits: self.bits.clone(),
            of: PhantomData,
        }
    }
}

impl<T> fmt::Debug for IdSet<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

impl<T> IdSet<T> {
    /// Adds an element; whether it was not there already.
    pub fn insert(&mut self, id: Id<T>) -> bool {
        let (word, bit) = (id.index() / 64, 1 << (id.index() % 64));
        if word >= self.bits.len() {
            self.bits.resize(word + 1, 0);
        }
        let before = self.bits[word];
        self.bits[word] |= bit;
        before & bit == 0
    }

    /// Adds several.
    pub fn extend(&mut self, ids: impl IntoIterator<Item = Id<T>>) {
        for id in ids {
            self.insert(id);
        }
    }

    /// Whether an element is there.
    pub fn contains(&self, id: Id<T>) -> bool {
        let word = self.bits.get(id.index() / 64);
        word.is_some_and(|word| word >> (id.index() % 64) & 1 != 0)
    }

    /// Whether an element is in both.
    pub fn meets(&self, other: &Self) -> bool {
        let mut words = self.bits.iter().zip(&other.bits);
        words.any(|(one, other)| one & other != 0)
    }

    /// Removes all elements.
    pub fn clear(&mut self) {
        self.bits.clear();
    }

    /// The elements, in the order of their arena.
    pub fn iter(&self) -> impl Iterator<Item = Id<T>> {
        let all = 0..self.bits.len() * 64;
        all.map(Id::new).filter(|&id| self.contains(id))
    }
}

impl<T> Index<Id<T>> for Arena<T> {
    type Output = T;

    fn index(&self, id: Id<T>) -> &T {
        &self.items[id.index()]
    }
}

impl<T> IndexMut<Id<T>> for Arena<T> {
    fn index_mut(&mut self, id: Id<T>) -> &mut T {
        &mut self.items[id.index()]
    }
}
