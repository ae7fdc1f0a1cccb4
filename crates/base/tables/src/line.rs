//! One line of a table as cells.

use std::borrow::Cow;
use std::ops::Range;

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Separator {
    /// This character between two cells.
    Char(char),
    /// Any number of blanks and tabs.
    Blanks,
}

/// A quote that does not fit, at these bytes of the text.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct QuoteFault {
    pub at: Range<usize>,
    pub title: &'static str,
    pub expected: &'static str,
}

/// The kind of separator of a table with this header; `None` for a header with two kinds.
pub(crate) fn separator(header: &str) -> Option<Separator> {
    let mut is_quoted = false;
    let mut found = Vec::new();
    for letter in header.chars() {
        match letter {
            '"' => is_quoted = !is_quoted,
            ',' | ';' | '\t' if !is_quoted && !found.contains(&letter) => found.push(letter),
            _ => {}
        }
    }
    match found[..] {
        [] => Some(Separator::Char(',')),
        [only] => Some(Separator::Char(only)),
        _ => None,
    }
}

/// Puts the bytes of each cell of `line`, quotes included and blanks around left out, into `cells`. The line begins at
/// byte `start` of its text.
pub(crate) fn split(
    line: &str,
    start: usize,
    separator: Separator,
    cells: &mut Vec<Range<usize>>,
) -> Result<(), QuoteFault> {
    cells.clear();
    match separator {
        Separator::Blanks => {
            let place = |word: &str| start + (word.as_ptr().addr() - line.as_ptr().addr());
            cells.extend(line.split_whitespace().map(|word| place(word)..place(word) + word.len()));
            Ok(())
        }
        Separator::Char(separator) => split_at(line, start, separator, cells),
    }
}

fn split_at(
    line: &str,
    start: usize,
    separator: char,
    cells: &mut Vec<Range<usize>>,
) -> Result<(), QuoteFault> {
    let is_blank = |letter: char| letter != separator && letter.is_whitespace();
    let mut at = 0;
    loop {
        let rest = &line[at..];
        let first = at + (rest.len() - rest.trim_start_matches(is_blank).len());
        let closed = if line[first..].starts_with('"') {
            first + quoted(&line[first..], start + first)?
        } else {
            first
        };
        let end = line[closed..].find(separator).map_or(line.len(), |length| closed + length);
        let tail = line[closed..end].trim_matches(is_blank);
        if closed > first && !tail.is_empty() {
            let from = start + closed + line[closed..end].find(tail).unwrap_or(0);
            let (title, expected) = ("text behind a quote", "the next cell");
            return Err(QuoteFault { at: from..from + tail.len(), title, expected });
        }
        let last = first + line[first..end].trim_end_matches(is_blank).len();
        cells.push(start + first..start + last);
        if end == line.len() {
            return Ok(());
        }
        at = end + separator.len_utf8();
    }
}

/// Bytes of the quoted text at the start of `rest`, which begins at byte `at`; two quotes within stand for one.
fn quoted(rest: &str, at: usize) -> Result<usize, QuoteFault> {
    let mut from = 1;
    while let Some(found) = rest[from..].find('"') {
        let quote = from + found;
        if !rest[quote + 1..].starts_with('"') {
            return Ok(quote + 1);
        }
        from = quote + 2;
    }
    Err(QuoteFault {
        at: at..at + 1,
        title: "a quote that is not closed",
        expected: "a second quote in this line",
    })
}

/// What a cell says: its bytes without quotes and blanks around.
pub(crate) fn unquoted(cell: &str) -> Cow<'_, str> {
    match cell.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        None => Cow::Borrowed(cell),
        Some(inside) if inside.contains('"') => Cow::Owned(inside.replace("\"\"", "\"").trim().to_owned()),
        Some(inside) => Cow::Borrowed(inside.trim()),
    }
}
