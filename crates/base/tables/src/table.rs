//! A table that is being read.

use std::ops::Range;
use std::sync::Arc;

use diagnostics::{LongList, Place, Problem, Problems, Source};
use limits::Limit;

use crate::form::Form;
use crate::header::{Header, HeaderFault, missing};
use crate::line::{QuoteFault, Separator, separator, split, unquoted};
use crate::number::{Number, Sign, number};
use crate::row::Row;
use crate::turn::beyond_a_turn;

/// A table that is being read row by row. Lines that are empty, begin with `#` or have only empty cells are passed over.
#[derive(Debug)]
pub struct Table {
    source: Arc<Source>,
    form: &'static Form,
    separator: Separator,
    header: Header,
    /// Bytes of the header; of nothing, if the table has none.
    header_at: Range<usize>,
    /// Where the next line begins.
    next: usize,
    /// Bytes of the cells of the row that is being read.
    cells: Vec<Range<usize>>,
    /// Rows read so far, those without values too.
    rows: u64,
    /// Whether any row so far has values.
    has_rows: bool,
    sign: Option<Sign>,
    /// Largest number of each column so far, either way, in the unit that its header names.
    largest: Vec<f64>,
    /// All decimal commas so far could stand between thousands.
    is_ambiguous: bool,
    faults: LongList,
}

impl Table {
    /// A table whose first row names its columns. Faults of the header go to the list of the table; of a header whose cells
    /// cannot be told no row is read.
    pub fn with_header(source: Arc<Source>, form: &'static Form) -> Self {
        let mut table = Self::new(source, form);
        if !table.read_header() {
            table.next = table.source.text.len();
        }
        table
    }

    /// A table without a header, with the columns in the order of `form` and blanks between them.
    pub fn in_order(source: Arc<Source>, form: &'static Form) -> Self {
        let mut table = Self::new(source, form);
        (table.separator, table.header) = (Separator::Blanks, Header::in_order(form));
        table.check_comments();
        table
    }

    fn new(source: Arc<Source>, form: &'static Form) -> Self {
        Self {
            faults: LongList::new(&source.name),
            header: Header::default(),
            header_at: 0..0,
            separator: Separator::Char(','),
            next: 0,
            cells: Vec::new(),
            rows: 0,
            has_rows: false,
            sign: None,
            largest: vec![0.0; form.columns.len()],
            is_ambiguous: true,
            source,
            form,
        }
    }

    /// Whether the table has a column.
    pub fn has(&self, column: usize) -> bool {
        self.header.places.get(column).is_some_and(Option::is_some)
    }

    /// The name that the header has for a column, if the table has it.
    pub fn name(&self, column: usize) -> Option<&'static str> {
        self.header.places.get(column).copied().flatten().map(|place| place.name)
    }

    /// Records that the header lacks a column that this table needs; a header that could not be read has its own fault.
    pub fn refuse_without(&mut self, column: usize) {
        if self.header.width == 0 {
            return;
        }
        let fault = missing(self.form, self.form.columns[column].name, self.header_at.clone());
        self.header_fault(fault);
    }

    /// Records a fault of the whole header.
    pub fn refuse_header(&mut self, title: String, expected: &str) {
        self.fault(self.header_at.clone(), title, expected, None);
    }

    /// The next row that holds anything; `None` at the end. Rows with a fault in their quotes or their width are recorded
    /// and left out.
    pub fn next_row(&mut self) -> Option<Row<'_>> {
        loop {
            let line = self.next_line()?;
            self.rows += 1;
            if !Limit::Rows.allows(self.rows) {
                self.refuse_rest(line);
                return None;
            }
            if self.split(&line) && self.has_values() && self.has_width() {
                self.has_rows = true;
                return Some(Row::new(self));
            }
        }
    }

    /// What was `read`, if nothing was wrong. Otherwise the first faults go to `problems`, and the number of the others. Notes
    /// tell of decimal commas that could be read otherwise, and of angles beyond a turn.
    pub fn finish<T>(mut self, read: T, problems: &Problems) -> Option<T> {
        if !self.has_rows && self.faults.is_empty() {
            let title = format!("a {} without rows", self.form.what);
            let expected = match self.separator {
                Separator::Blanks => format!("rows of {}", self.form.names().join(" ")),
                Separator::Char(_) => "at least one row under the header".into(),
            };
            self.fault(self.header_at.clone(), title, &expected, None);
        }
        if self.sign == Some(Sign::Comma) && self.is_ambiguous {
            let name = &self.source.name;
            problems.note(format!("{name}: commas in numbers are decimal commas: 1,234 is read as 1.234"));
        }
        let angles = self
            .header
            .places
            .iter()
            .zip(&self.largest)
            .filter_map(|(place, largest)| beyond_a_turn(place.as_ref()?.name, *largest));
        angles.for_each(|note| problems.note(format!("{}: {note}", self.source.name)));
        self.faults.finish(read, problems)
    }

    /// Place of these bytes.
    pub(crate) fn place(&self, span: Range<usize>) -> Place {
        Place { source: self.source.clone(), span }
    }

    pub(crate) fn bytes(&self, span: &Range<usize>) -> &str {
        &self.source.text[span.clone()]
    }

    pub(crate) fn header(&self) -> &Header {
        &self.header
    }

    pub(crate) fn cells(&self) -> &[Range<usize>] {
        &self.cells
    }

    pub(crate) fn push(&mut self, problem: Problem) {
        self.faults.push(problem);
    }

    /// Keeps the largest number of a column, either way.
    pub(crate) fn met(&mut self, column: usize, number: f64) {
        self.largest[column] = self.largest[column].max(number.abs());
    }

    /// Bytes of the row that is being read.
    pub(crate) fn whole_row(&self) -> Range<usize> {
        let end = self.cells.last().map_or(self.next, |last| last.end);
        self.cells.first().map_or(self.next, |first| first.start)..end
    }

    /// Whether a comma within a number stands in front of its decimals.
    pub(crate) fn commas_are_decimal(&self) -> bool {
        self.separator != Separator::Char(',')
    }

    /// Whether a number has the decimal sign of those before it.
    pub(crate) fn keeps_sign(&mut self, number: &Number) -> bool {
        let Some(sign) = number.sign else { return true };
        self.is_ambiguous &= number.is_ambiguous;
        *self.sign.get_or_insert(sign) == sign
    }

    /// Bytes of the next line that is no comment and holds anything but blanks.
    fn next_line(&mut self) -> Option<Range<usize>> {
        while self.next < self.source.text.len() {
            let start = self.next;
            let rest = &self.source.text[start..];
            let length = rest.find('\n').unwrap_or(rest.len());
            self.next = start + length + 1;
            let line = rest[..length].trim();
            if !line.is_empty() && !line.starts_with('#') {
                return Some(start..start + length);
            }
        }
        self.next = self.source.text.len();
        None
    }

    /// Records that the table has more rows than are allowed; `line` is the first of them. No further row is read.
    fn refuse_rest(&mut self, line: Range<usize>) {
        self.next = self.source.text.len();
        let most = Limit::Rows.value();
        let title = format!("a {} of more than {most} rows", self.form.what);
        self.fault(line, title, &format!("at most {most} rows"), Some(Limit::Rows.to_string()));
    }

    /// Finds the cells of a line; records a fault in its quotes.
    fn split(&mut self, line: &Range<usize>) -> bool {
        let source = self.source.clone();
        match split(&source.text[line.clone()], line.start, self.separator, &mut self.cells) {
            Ok(()) => true,
            Err(QuoteFault { at, title, expected }) => {
                self.fault(at, title.into(), expected, None);
                false
            }
        }
    }

    fn has_values(&self) -> bool {
        self.cells.iter().any(|cell| !unquoted(self.bytes(cell)).is_empty())
    }

    /// Whether the row has as many cells as the table; records a fault if not, or if a cell without a name holds something.
    fn has_width(&mut self) -> bool {
        let (found, width) = (self.cells.len(), self.header.width);
        if found != width {
            let (title, expected) = match self.separator {
                Separator::Blanks => {
                    let names = self.form.names().join(" ");
                    (format!("a row of {found} numbers"), format!("the {width} numbers {names}"))
                }
                Separator::Char(_) => {
                    (format!("a row of {found} cells under a header of {width}"), "as many cells".into())
                }
            };
            self.fault(self.whole_row(), title, &expected, None);
            return false;
        }
        let mut nameless = self.header.nameless.iter().map(|cell| self.cells[*cell].clone());
        match nameless.find(|cell| !unquoted(self.bytes(cell)).is_empty()) {
            None => true,
            Some(cell) => {
                self.fault(cell, "a value in a column without a name".into(), "a name in the header", None);
                false
            }
        }
    }

    /// Reads the header; `false` if its cells cannot be told.
    fn read_header(&mut self) -> bool {
        let told = self.told_separator();
        let Some(line) = self.next_line() else {
            let title = format!("an empty {}", self.form.what);
            self.fault(0..0, title, "a header and at least one row", None);
            return false;
        };
        self.header_at = line.clone();
        match told.or(separator(self.bytes(&line))) {
            Some(separator) => self.separator = separator,
            None => {
                let title = "two kinds of separators in one header".into();
                self.fault(line, title, "commas, semicolons or tabs between cells", None);
                return false;
            }
        }
        if !self.split(&line) {
            return false;
        }
        self.header_at = self.whole_row();
        let text = |cell: &Range<usize>| (unquoted(self.bytes(cell)).into_owned(), cell.clone());
        let cells: Vec<_> = self.cells.iter().map(text).collect();
        if cells.iter().all(|(text, _)| number(text, true).is_ok()) {
            let names: Vec<_> = self.form.columns.iter().map(|column| column.name).collect();
            let expected = format!("a header such as {}", names.join(","));
            self.fault(
                self.header_at.clone(),
                "a first row of numbers, not of names".into(),
                &expected,
                None,
            );
            return false;
        }
        let mut faults = Vec::new();
        self.header = Header::by_name(self.form, &cells, &mut faults);
        faults.into_iter().for_each(|fault| self.header_fault(fault));
        true
    }

    /// The separator in a line of its own, `sep=;`, with which Excel begins a file.
    fn told_separator(&mut self) -> Option<Separator> {
        let line = self.source.text.strip_prefix("sep=")?.split('\n').next()?;
        let separator = [",", ";", "\t"].into_iter().find(|separator| *separator == line)?;
        self.next_line();
        separator.chars().next().map(Separator::Char)
    }

    fn header_fault(&mut self, HeaderFault { at, title, expected, help }: HeaderFault) {
        self.fault(at, title, &expected, help);
    }

    /// A comment in front of a table without a header may name its columns; it must name them in the order of the form. A quaternion
    /// may be named by its parts alone, `w x y z`: its scalar stands last.
    fn check_comments(&mut self) {
        let mut at = 0;
        let source = self.source.clone();
        for line in source.text.split_inclusive('\n').take_while(|line| {
            let line = line.trim();
            line.is_empty() || line.starts_with('#')
        }) {
            let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
            let words: Vec<&str> =
                line.split(|letter| !is_part(letter)).filter(|word| !word.is_empty()).collect();
            let named: Vec<usize> =
                words.iter().filter_map(|word| self.form.find(word)).map(|found| found.0).collect();
            let is_scalar_first = |four: &[&str]| four.concat().eq_ignore_ascii_case("wxyz");
            let has_quaternion = self.form.find("qw").is_some();
            // A sentence may hold one or two of the names by chance.
            if (named.len() >= 4 && !named.is_sorted())
                || (has_quaternion && words.windows(4).any(is_scalar_first))
            {
                let expected = self.form.names().join(" ");
                let end = at + line.trim_end().len();
                self.fault(
                    at..end,
                    "a comment that names the columns in another order".into(),
                    &expected,
                    None,
                );
            }
            at += line.len();
        }
    }
}
