//! Rows of a CSV text that somebody wrote, every cell with its place.

use std::ops::Range;

use csv::{Reader, ReaderBuilder, StringRecord};

/// Rows of a CSV text, read by the crate `csv`: commas between cells, quotes as RFC 4180 has them, any line ends, a byte
/// order mark in front or not. Rows that are empty or begin with `#` are passed over; blanks around a cell are not part
/// of it.
///
/// ```
/// use diagnostics::CsvRows;
/// let mut rows = CsvRows::new("a, \"b\"\r\n# a comment\r\n1,\"2\"\r\n");
/// let header = rows.next_row().expect("a header");
/// assert_eq!(header.texts().collect::<Vec<_>>(), ["a", "b"]);
/// let row = rows.next_row().expect("a row");
/// assert_eq!((row.text(1), row.span(1)), ("2", 23..26));
/// assert!(rows.next_row().is_none());
/// ```
#[derive(Debug)]
pub struct CsvRows<'t> {
    text: &'t str,
    /// Bytes of a byte order mark.
    mark: usize,
    reader: Reader<&'t [u8]>,
    record: StringRecord,
}

/// One row of a CSV text.
#[derive(Debug, Clone, Copy)]
pub struct CsvRow<'r> {
    text: &'r str,
    start: usize,
    record: &'r StringRecord,
    is_last: bool,
}

impl<'t> CsvRows<'t> {
    /// The rows of `text`.
    pub fn new(text: &'t str) -> Self {
        let without_mark = text.trim_start_matches('\u{feff}');
        let reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .from_reader(without_mark.as_bytes());
        Self { text, mark: text.len() - without_mark.len(), reader, record: StringRecord::new() }
    }

    /// The next row that holds anything; nothing at the end.
    pub fn next_row(&mut self) -> Option<CsvRow<'_>> {
        // A text in UTF-8 with rows of any width has nothing that the reader refuses.
        while matches!(self.reader.read_record(&mut self.record), Ok(true)) {
            let from = self.record.position().map_or(0, csv::Position::byte) as usize;
            let start = begin_of_row(self.text, self.mark + from);
            let is_empty = self.record.len() == 1 && self.record[0].trim().is_empty();
            if !is_empty && !self.text[start..].trim_start().starts_with('#') {
                let is_last = self.mark + self.reader.position().byte() as usize >= self.text.len();
                return Some(CsvRow { text: self.text, start, record: &self.record, is_last });
            }
        }
        None
    }
}

impl<'r> CsvRow<'r> {
    /// How many cells it has.
    pub fn width(&self) -> usize {
        self.record.len()
    }

    /// What stands in a cell, without quotes and blanks around it; nothing in one that is not there.
    pub fn text(&self, cell: usize) -> &'r str {
        let text = self.record.get(cell).unwrap_or_default().trim();
        // Quotes behind a blank are none to the reader.
        let inside = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        inside.unwrap_or(text).trim()
    }

    /// What stands in its cells.
    pub fn texts(&self) -> impl Iterator<Item = &'r str> {
        let row = *self;
        (0..row.width()).map(move |cell| row.text(cell))
    }

    /// Bytes of the whole text that a cell takes, with its quotes.
    pub fn span(&self, cell: usize) -> Range<usize> {
        let (spans, _) = spans(self.text, self.start);
        spans.get(cell).cloned().unwrap_or(self.start..self.start)
    }

    /// Bytes of all its cells.
    pub fn spans(&self) -> Vec<Range<usize>> {
        spans(self.text, self.start).0
    }

    /// Bytes of the row.
    pub fn whole(&self) -> Range<usize> {
        let (spans, _) = spans(self.text, self.start);
        self.start..spans.last().map_or(self.start, |last| last.end)
    }

    /// Where a quote is opened that does not end in the row's own line, if there is one: rows behind it would be taken
    /// for its text.
    pub fn open_quote(&self) -> Option<Range<usize>> {
        let is_broken = |cell: &str| cell.contains(['\n', '\r']);
        if !self.is_last && !self.record.iter().any(is_broken) {
            return None;
        }
        let (spans, is_open) = spans(self.text, self.start);
        let broken = spans.iter().find(|span| is_broken(&self.text[(*span).clone()]));
        let at = broken.or(spans.last().filter(|_| is_open))?.start;
        Some(at..at + 1)
    }
}

/// Where the row begins that the reader found from `at` on: it passes over empty lines and comments.
fn begin_of_row(text: &str, at: usize) -> usize {
    let mut rest = &text[at..];
    loop {
        rest = rest.trim_start_matches(['\r', '\n']);
        if !rest.starts_with('#') {
            return text.len() - rest.len();
        }
        rest = rest.find('\n').map_or("", |end| &rest[end..]);
    }
}

/// Bytes of the cells of the row that begins at `start`, and whether the text ends within quotes.
fn spans(text: &str, start: usize) -> (Vec<Range<usize>>, bool) {
    let (mut spans, mut begin) = (Vec::new(), start);
    let (mut is_quoted, mut closed_at) = (false, usize::MAX);
    for (at, byte) in text.bytes().enumerate().skip(start) {
        match byte {
            b'"' if is_quoted => (is_quoted, closed_at) = (false, at),
            // A second quote right behind a first stands for one.
            b'"' if at == begin || at == closed_at.wrapping_add(1) => is_quoted = true,
            b',' if !is_quoted => {
                spans.push(trimmed(text, begin..at));
                begin = at + 1;
            }
            b'\n' | b'\r' if !is_quoted => {
                spans.push(trimmed(text, begin..at));
                return (spans, false);
            }
            _ => {}
        }
    }
    spans.push(trimmed(text, begin..text.len()));
    (spans, is_quoted)
}

fn trimmed(text: &str, span: Range<usize>) -> Range<usize> {
    let piece = &text[span.clone()];
    let start = span.start + (piece.len() - piece.trim_start().len());
    start..start + piece.trim().len()
}
