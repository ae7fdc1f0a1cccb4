//! Tables of numbers as text, every cell with its place.

use std::ops::Range;
use std::sync::Arc;

use diagnostics::{LongList, Place, Problem, Problems, Source};

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

    /// Records a fault.
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

/// Lines of a table that hold anything but a comment (`#`); cells end at commas, or else at blanks.
pub(super) fn lines(text: &str, comma: bool) -> impl Iterator<Item = Vec<Cell<'_>>> {
    let without_mark = text.trim_start_matches('\u{feff}');
    let mark = text.len() - without_mark.len();
    let starts = without_mark.split_inclusive('\n').scan(mark, |offset, line| {
        let start = *offset;
        *offset += line.len();
        Some((start, line))
    });
    let holds_anything = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let filled = starts.filter(move |(_, line)| holds_anything(line));
    filled.map(move |(start, line)| cells(line, start, comma))
}

fn cells(line: &str, start: usize, comma: bool) -> Vec<Cell<'_>> {
    let line = line.trim_end_matches(['\n', '\r']);
    let is_end = |c: char| if comma { c == ',' } else { c.is_whitespace() };
    let mut offset = start;
    let mut cells = Vec::new();
    for piece in line.split(is_end) {
        let inner = piece.trim();
        let begin = offset + (piece.len() - piece.trim_start().len());
        if comma || !inner.is_empty() {
            let unquoted = inner.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
            let text = unquoted.unwrap_or(inner);
            cells.push(Cell { text, span: begin..begin + inner.len() });
        }
        offset += piece.len() + piece_end(line, offset - start + piece.len());
    }
    cells
}

/// Bytes of the separator at `at`; 0 at the end of the line.
fn piece_end(line: &str, at: usize) -> usize {
    line[at..].chars().next().map_or(0, char::len_utf8)
}

#[cfg(test)]
mod tests {
    use super::{Cell, lines};

    fn texts(text: &str, comma: bool) -> Vec<Vec<(String, String)>> {
        let show = |cell: &Cell| (cell.text.to_owned(), text[cell.span.clone()].to_owned());
        lines(text, comma).map(|line| line.iter().map(show).collect()).collect()
    }

    #[test]
    fn cells_know_their_place() {
        let cells = texts("\u{feff}\"a\", b ,,\u{e4}\r\n\n# c\n1,2\n\"3,4\"", true);
        let pair = |a: &str, b: &str| (a.to_owned(), b.to_owned());
        assert_eq!(cells[0], [pair("a", "\"a\""), pair("b", "b"), pair("", ""), pair("\u{e4}", "\u{e4}")]);
        assert_eq!(cells[1], [pair("1", "1"), pair("2", "2")]);
        // A quote around a separator is none: no number begins with one.
        assert_eq!(cells[2], [pair("\"3", "\"3"), pair("4\"", "4\"")]);
    }

    #[test]
    fn blanks_of_any_number_part_cells() {
        let cells = texts("  1 \t\u{a0}22  3 \n", false);
        let words: Vec<&str> = cells[0].iter().map(|(_, shown)| shown.as_str()).collect();
        assert_eq!(words, ["1", "22", "3"]);
    }
}
