//! The author's files, places in them, and what there is to say about them.
//!
//! Everything here is plain data. Places are byte ranges; lines and columns are made only where they
//! are shown ([`SourceFile::location`]).

mod diagnostic;

pub use diagnostic::{Diagnostic, Report, Severity};

/// Names one file of a [`SourceMap`]. Only meaningful together with the map that gave it out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FileId(u32);

impl FileId {
    /// The place of the file in its map.
    pub(crate) fn index(self) -> u32 {
        self.0
    }

    /// The id behind [`FileId::index`].
    pub(crate) fn from_index(index: u32) -> Self {
        FileId(index)
    }
}

/// A byte range in one of the author's files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// The file that the range lies in.
    pub file: FileId,
    /// First byte of the range.
    pub start: u32,
    /// One past the last byte; equal to `start` for a point between two characters.
    pub end: u32,
}

/// A place as people and editors count it: both numbers start at 1, and a column is one character
/// (a Unicode scalar value), so that a tab and an umlaut count once each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Location {
    /// Line number.
    pub line: usize,
    /// Character within the line.
    pub column: usize,
}

/// One text of the author's, exactly as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceFile {
    /// What to call the file when speaking to its author: a path as given, or `<stdin>`.
    pub name: String,
    /// The text, byte for byte: line ends and byte-order mark included.
    pub text: String,
}

impl SourceFile {
    /// Turns a byte offset into line and column. Offsets past the end give the end of the text;
    /// offsets inside a character give that character.
    pub fn location(&self, offset: u32) -> Location {
        let mut end = (offset as usize).min(self.text.len());
        while !self.text.is_char_boundary(end) {
            end -= 1;
        }
        let before = &self.text[..end];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Location {
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
        }
    }
}

/// All files that one scene was loaded from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SourceMap {
    files: Vec<SourceFile>,
}

impl SourceMap {
    /// Adds a file and returns its name within this map.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> FileId {
        let id = FileId(u32::try_from(self.files.len()).expect("fewer than 2^32 files"));
        self.files.push(SourceFile {
            name: name.into(),
            text: text.into(),
        });
        id
    }

    /// The file behind an id that this map gave out.
    ///
    /// # Panics
    /// When the id comes from another map.
    pub fn get(&self, id: FileId) -> &SourceFile {
        &self.files[id.0 as usize]
    }

    /// Where a span begins, as `file:line:column`.
    pub fn place(&self, span: Span) -> String {
        let file = self.get(span.file);
        let at = file.location(span.start);
        format!("{}:{}:{}", file.name, at.line, at.column)
    }

    /// A span over the whole file.
    pub fn whole(&self, file: FileId) -> Span {
        let end = u32::try_from(self.get(file).text.len()).unwrap_or(u32::MAX);
        Span {
            file,
            start: 0,
            end,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str, offset: u32) -> (usize, usize) {
        let mut files = SourceMap::default();
        let file = files.add("a.glsl", text);
        let place = files.get(file).location(offset);
        (place.line, place.column)
    }

    #[test]
    fn lines_and_columns_start_at_one() {
        assert_eq!(at("abc", 0), (1, 1));
        assert_eq!(at("abc\nd", 4), (2, 1));
        assert_eq!(at("abc\r\nd", 5), (2, 1));
    }

    #[test]
    fn a_column_is_a_character() {
        assert_eq!(at("äb", 2), (1, 2));
        assert_eq!(
            at("äb", 1),
            (1, 1),
            "inside a character gives that character"
        );
    }

    #[test]
    fn beyond_the_end_is_the_end() {
        assert_eq!(at("a\n", 900), (2, 1));
    }
}
