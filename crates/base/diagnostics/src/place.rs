//! Where something stands: a source text and a range of bytes in it.

use std::ops::Range;
use std::sync::Arc;

/// A text that somebody wrote, with the name under which the user knows it.
#[derive(Debug, PartialEq, Eq)]
pub struct Source {
    /// The path as the user gave it, or a word such as `--set`.
    pub name: String,
    /// The whole text of the source.
    pub text: String,
}

impl Source {
    /// Line and column of a byte offset, both from 1, the column in characters.
    /// An offset behind the end is taken as the end.
    pub fn line_and_column(&self, offset: usize) -> (usize, usize) {
        let found = Cursor::new(self).to(offset);
        (found.line, found.column)
    }

    /// The nearest offset at or below `offset` that lies in the text and between two characters.
    pub(crate) fn floor_boundary(&self, offset: usize) -> usize {
        let offset = offset.min(self.text.len());
        (0..=offset).rev().find(|&at| self.text.is_char_boundary(at)).unwrap_or(0)
    }
}

/// Goes through a source from place to place. Places in ascending order cost one walk, however many there are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cursor<'s> {
    pub source: &'s Source,
    /// Byte offset in the text.
    pub at: usize,
    /// Byte offset at which the line begins.
    pub line_start: usize,
    /// Line and column from 1, the column in characters.
    pub line: usize,
    pub column: usize,
}

impl<'s> Cursor<'s> {
    /// At the start of `source`.
    pub fn new(source: &'s Source) -> Self {
        Self { source, at: 0, line_start: 0, line: 1, column: 1 }
    }

    /// At `offset` of the same source.
    pub fn to(self, offset: usize) -> Self {
        let at = self.source.floor_boundary(offset);
        let from = if at < self.at { Self::new(self.source) } else { self };
        let passed = &from.source.text[from.at..at];
        match passed.rfind('\n') {
            None => Self { at, column: from.column + passed.chars().count(), ..from },
            Some(newline) => Self {
                source: from.source,
                at,
                line_start: from.at + newline + 1,
                line: from.line + passed.matches('\n').count(),
                column: passed[newline + 1..].chars().count() + 1,
            },
        }
    }
}

/// A range of bytes in a source; cheap to clone and to keep beside a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The text the place is in.
    pub source: Arc<Source>,
    /// Bytes of the text.
    pub span: Range<usize>,
}

impl Place {
    /// Line of the place's first byte, from 1.
    pub fn line(&self) -> usize {
        self.source.line_and_column(self.span.start).0
    }

    /// The text of the place.
    pub(crate) fn text(&self) -> &str {
        let start = self.source.floor_boundary(self.span.start);
        let end = self.source.floor_boundary(self.span.end).max(start);
        &self.source.text[start..end]
    }
}

/// A value and where it stands, for rules that are checked after reading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placed<T> {
    /// The value as read.
    pub value: T,
    /// Its place in the file.
    pub place: Place,
    /// Its dotted key path, as `raster.sweeps`.
    pub key: String,
}
