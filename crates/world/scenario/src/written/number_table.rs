//! Tables of numbers as text, every cell with its place.

use std::ops::Range;
use std::sync::Arc;

use diagnostics::{CsvRow, LongList, Place, Problem, Problems, Source};

/// A table being read: where it comes from and what was wrong so far.
pub(super) struct NumberTable<'p> {
    source: Arc<Source>,
    faults: LongList,
    problems: &'p Problems,
}

/// A cell: its text without blanks and quotes, and the bytes it takes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cell<'t> {
    pub text: &'t str,
    pub span: Range<usize>,
}

impl<'p> NumberTable<'p> {
    pub fn new(name: &str, text: &str, problems: &'p Problems) -> Self {
        let source = Arc::new(Source { name: name.into(), text: text.into() });
        Self { source, faults: LongList::new(name), problems }
    }

    pub fn place(&self, span: &Range<usize>) -> Place {
        Place { source: self.source.clone(), span: span.clone() }
    }

    /// Records a fault at the bytes `span`: what is wrong, and what was expected.
    pub fn fault(&mut self, span: &Range<usize>, title: String, expected: &str) {
        let found = self.source.text[span.clone()].to_owned();
        let problem = Problem::at(&self.place(span), title).found(found).expected(expected);
        self.faults.push(problem);
    }

    /// A number of at most `most` either way; `name` names it in the message.
    pub fn number(&mut self, cell: &Cell, name: &str, most: f64) -> Option<f64> {
        let number = cell.text.parse().ok().filter(|number: &f64| number.abs() <= most);
        if number.is_none() {
            let found = if cell.text.is_empty() { "nothing" } else { cell.text };
            let expected = format!("a number from -{most} to {most}");
            self.fault(&cell.span, format!("`{name}` must be {expected}, not {found}"), &expected);
        }
        number
    }

    /// What was read, if nothing was wrong; else the first faults are handed on, and the number of the rest.
    pub fn finish<T>(self, read: T) -> Option<T> {
        self.faults.finish(read, self.problems)
    }
}

/// Cells of a row of a CSV text.
pub(super) fn cells<'r>(row: &CsvRow<'r>) -> Vec<Cell<'r>> {
    row.texts().zip(row.spans()).map(|(text, span)| Cell { text, span }).collect()
}

/// Lines of a table whose cells end at blanks; those that are empty or a comment (`#`) are passed over.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Vec<Cell<'_>>> {
    let without_mark = text.trim_start_matches('\u{feff}');
    let mark = text.len() - without_mark.len();
    let starts = without_mark.split_inclusive('\n').scan(mark, |offset, line| {
        let start = *offset;
        *offset += line.len();
        Some((start, line))
    });
    let holds_anything = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    starts.filter(move |(_, line)| holds_anything(line)).map(|(start, line)| words(line, start))
}

fn words(line: &str, start: usize) -> Vec<Cell<'_>> {
    let place = |word: &str| start + (word.as_ptr().addr() - line.as_ptr().addr());
    let cell = |word| Cell { text: unquoted(word), span: place(word)..place(word) + word.len() };
    line.split_whitespace().map(cell).collect()
}

fn unquoted(word: &str) -> &str {
    word.strip_prefix('"').and_then(|text| text.strip_suffix('"')).unwrap_or(word)
}

#[cfg(test)]
mod tests {
    use diagnostics::CsvRows;

    use super::{Cell, cells, lines};

    fn show(text: &str, row: &[Cell]) -> Vec<(String, String)> {
        row.iter().map(|cell| (cell.text.to_owned(), text[cell.span.clone()].to_owned())).collect()
    }

    #[test]
    fn cells_know_their_place() {
        let text = "\u{feff}\"a\", b ,,\u{e4}\r\n\n# c\n1,2\n\"3,4\"";
        let mut rows = CsvRows::new(text);
        let mut next = || rows.next_row().map(|row| show(text, &cells(&row))).unwrap_or_default();
        let pair = |a: &str, b: &str| (a.to_owned(), b.to_owned());
        assert_eq!(next(), [pair("a", "\"a\""), pair("b", "b"), pair("", ""), pair("\u{e4}", "\u{e4}")]);
        assert_eq!(next(), [pair("1", "1"), pair("2", "2")]);
        assert_eq!(next(), [pair("3,4", "\"3,4\"")]);
        assert_eq!(next(), []);
    }

    #[test]
    fn blanks_of_any_number_part_cells() {
        let text = "\u{feff}# c\n  1 \t\u{a0}22  3 \n";
        let rows: Vec<_> = lines(text).map(|row| show(text, &row)).collect();
        let pair = |a: &str| (a.to_owned(), a.to_owned());
        assert_eq!(rows, [[pair("1"), pair("22"), pair("3")]]);
    }
}
