//! What readers ask a file for: every key with its shape, noted while something is read.
//!
//! Nobody else has to know all keys of a format: who reads a file of it under [`record`] has the list.

use std::cell::RefCell;

/// A key that a reader asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Asked {
    /// Dotted path from the root, as `object[3].model`; empty for the root itself.
    pub path: String,
    /// What may stand there.
    pub shape: Shape,
    /// Whether a table without the key is at fault.
    pub is_required: bool,
}

/// What may stand under a key.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Type of the value.
    pub kind: ShapeKind,
    /// Least number, and whether it is allowed itself.
    pub low: Option<(f64, bool)>,
    /// Largest number, and whether it is allowed itself.
    pub high: Option<(f64, bool)>,
    /// Unit of the numbers.
    pub unit: Option<String>,
    /// Other rules, in words.
    pub rules: Vec<String>,
    /// Words that may stand in place of the value.
    pub or_words: Vec<String>,
}

/// Type of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum ShapeKind {
    /// A number that is finite.
    Number,
    /// A whole number of either sign.
    Whole,
    /// A whole number of 0 or more.
    Count,
    /// The word `true` or `false`.
    Boolean,
    /// A text in quotes.
    Text,
    /// One of some words.
    Words(Vec<String>),
    /// An array of values of one type; the count, where it is fixed.
    Array(Box<ShapeKind>, Option<usize>),
    /// One number, or an array of so many.
    NumberOrArray(usize),
    /// A table of known keys.
    Table,
    /// An array of tables.
    Tables,
    /// A table whose keys are names that its writer chooses, or that somebody else reads.
    OpenTable,
}

impl Shape {
    /// Any value of a type.
    pub(crate) fn of(kind: ShapeKind) -> Self {
        Self { kind, low: None, high: None, unit: None, rules: Vec::new(), or_words: Vec::new() }
    }
}

thread_local! {
    static NOTES: RefCell<Option<Vec<Asked>>> = const { RefCell::new(None) };
}

/// Does something, and returns with its result every key that readers of this thread asked for meanwhile, in their order.
pub fn record<T>(read: impl FnOnce() -> T) -> (T, Vec<Asked>) {
    let before = NOTES.replace(Some(Vec::new()));
    let read = read();
    (read, NOTES.replace(before).unwrap_or_default())
}

/// Notes a key while somebody records.
pub(crate) fn note(path: &str, is_required: bool, shape: impl FnOnce() -> Shape) {
    NOTES.with_borrow_mut(|notes| {
        if let Some(notes) = notes {
            notes.push(Asked { path: path.to_owned(), shape: shape(), is_required });
        }
    });
}
