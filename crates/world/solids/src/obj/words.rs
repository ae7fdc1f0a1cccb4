//! A text as lines of words.

use std::ops::Range;

/// A word and the bytes that it takes.
pub(super) type Word<'t> = (&'t str, Range<usize>);

/// Lines as words, without comments; empty lines are left out.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Vec<Word<'_>>> {
    let start_of = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    let words = move |line: &'_ str| -> Vec<(usize, usize)> {
        let said = line.split('#').next().unwrap_or_default();
        said.split_whitespace().map(|word| (start_of(word), word.len())).collect()
    };
    let found = text.lines().map(words).filter(|words| !words.is_empty());
    found.map(|words| words.into_iter().map(|(at, len)| (&text[at..at + len], at..at + len)).collect())
}
