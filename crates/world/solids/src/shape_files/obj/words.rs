//! Statements of an OBJ text: lines as words, without comments.

use crate::shape_files::text::{Word, words};

/// Statements as words; empty ones are left out. A backslash at the end of a line joins the next line to it, except in a comment.
pub(super) fn statements(text: &str) -> impl Iterator<Item = Vec<Word<'_>>> {
    let mut lines = text.lines();
    std::iter::from_fn(move || {
        let mut statement = Vec::new();
        loop {
            let Some(line) = lines.next() else { return (!statement.is_empty()).then_some(statement) };
            let (said, is_whole) = match (line.split_once('#'), line.trim_end().strip_suffix('\\')) {
                (Some((said, _)), _) => (said, true),
                (None, Some(said)) => (said, false),
                (None, None) => (line, true),
            };
            statement.extend(words(text, said));
            if is_whole && !statement.is_empty() {
                return Some(statement);
            }
        }
    })
}
