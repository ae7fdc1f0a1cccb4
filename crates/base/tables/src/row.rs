//! One row of a table, and what is wrong with it.

use std::borrow::Cow;
use std::ops::{Range, RangeInclusive};

use dates::DateError;
use diagnostics::{Place, Problem};

use crate::clock::{Clock, Time};
use crate::line::unquoted;
use crate::number::{NoNumber, Number, number};
use crate::table::Table;

/// A cell that was refused; the table has the fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Faulty;

/// One row of a [`Table`]. Columns are named by their index in the form of the table.
#[derive(Debug)]
pub struct Row<'t> {
    table: &'t mut Table,
}

/// What stands in a cell.
enum Content {
    /// The table has no such column.
    NoColumn,
    /// The cell is empty, or holds empty quotes.
    Empty,
    Number(Number),
    Other(NoNumber),
}

impl<'t> Row<'t> {
    pub(crate) fn new(table: &'t mut Table) -> Self {
        Self { table }
    }

    /// Whether the table has a column.
    pub fn has(&self, column: usize) -> bool {
        self.table.has(column)
    }

    /// What stands in a cell, without quotes; nothing if the table has no such column.
    pub fn text(&self, column: usize) -> Option<Cow<'_, str>> {
        let place = self.table.header().places[column]?;
        Some(unquoted(self.table.bytes(self.table.cells().get(place.cell)?)))
    }

    /// Place of a cell in the file; of the row, if the table has no such column.
    pub fn place(&self, column: usize) -> Place {
        self.table.place(self.span(column))
    }

    /// A finite number in a range of the unit that the form names; every row needs it. `None` where the cell has a fault or
    /// the column is missing.
    pub fn number(&mut self, column: usize, range: RangeInclusive<f64>) -> Option<f64> {
        let content = self.content(column);
        self.in_range(column, content, range).ok().flatten()
    }

    /// The same where the column may be missing and the cell empty.
    ///
    /// # Errors
    /// If something else than a number of the range stands there.
    pub fn optional_number(
        &mut self,
        column: usize,
        range: RangeInclusive<f64>,
    ) -> Result<Option<f64>, Faulty> {
        match self.content(column) {
            Content::Empty => Ok(None),
            content => self.in_range(column, content, range),
        }
    }

    /// A finite number for which `is_good` holds, in the unit that the form names; `expected` says so in the message.
    pub fn number_that(
        &mut self,
        column: usize,
        is_good: impl Fn(f64) -> bool,
        expected: &str,
    ) -> Option<f64> {
        let content = self.content(column);
        self.that(column, content, is_good, expected).ok().flatten()
    }

    /// The same where the column may be missing and the cell empty.
    ///
    /// # Errors
    /// If something else stands there.
    pub fn optional_number_that(
        &mut self,
        column: usize,
        is_good: impl Fn(f64) -> bool,
        expected: &str,
    ) -> Result<Option<f64>, Faulty> {
        match self.content(column) {
            Content::Empty => Ok(None),
            content => self.that(column, content, is_good, expected),
        }
    }

    /// A time, in seconds or as a date, counted by `clock` (s).
    pub fn time(&mut self, column: usize, clock: &mut Clock) -> Option<f64> {
        let time = match self.text(column).map(|text| dates::read(&text)) {
            Some(Ok(date)) => Time::Date(date),
            Some(Err(error @ DateError::Calendar { .. })) => {
                self.refuse(column, &error.expected());
                return None;
            }
            _ => Time::Seconds(self.seconds(column)?),
        };
        clock.count(time).map_err(|expected| self.refuse(column, &expected)).ok()
    }

    /// A time as a number (s), whatever it counts from.
    fn seconds(&mut self, column: usize) -> Option<f64> {
        let content = self.content(column);
        let expected = "a number of seconds, or a date such as 2026-11-26T22:00:00Z";
        self.that(column, content, |_| true, expected).ok().flatten()
    }

    /// Records that a cell is not what was expected: "`x_m` must be EXPECTED, not FOUND".
    pub fn refuse(&mut self, column: usize, expected: &str) {
        self.refuse_with(column, expected, None);
    }

    /// Records a fault of the whole row.
    pub fn refuse_row(&mut self, title: String, expected: &str) {
        let whole = self.table.whole_row();
        self.table.fault(whole, title, expected, None);
    }

    fn refuse_with(&mut self, column: usize, expected: &str, help: Option<&str>) {
        let Some(place) = self.table.header().places[column] else { return };
        let found = self.text(column).unwrap_or_default();
        let found = if found.is_empty() { "nothing".into() } else { short(&found) };
        let title = format!("`{}` must be {expected}, not {found}", place.name);
        self.table.fault(self.span(column), title, expected, help.map(str::to_owned));
    }

    fn span(&self, column: usize) -> Range<usize> {
        let cell = self.table.header().places[column].and_then(|place| self.table.cells().get(place.cell));
        cell.cloned().unwrap_or_else(|| self.table.whole_row())
    }

    fn content(&self, column: usize) -> Content {
        match self.text(column) {
            None => Content::NoColumn,
            Some(text) if text.is_empty() => Content::Empty,
            Some(text) => match number(&text, self.table.commas_are_decimal()) {
                Ok(number) => Content::Number(number),
                Err(none) => Content::Other(none),
            },
        }
    }

    fn in_range(
        &mut self,
        column: usize,
        content: Content,
        range: RangeInclusive<f64>,
    ) -> Result<Option<f64>, Faulty> {
        let factor = self.table.header().places[column].map_or(1.0, |place| place.factor);
        let [low, high] = [range.start(), range.end()].map(|end| end / factor);
        let expected = format!("a number from {low} to {high}");
        self.that(column, content, |number| range.contains(&number), &expected)
    }

    fn that(
        &mut self,
        column: usize,
        content: Content,
        is_good: impl Fn(f64) -> bool,
        expected: &str,
    ) -> Result<Option<f64>, Faulty> {
        let factor = self.table.header().places[column].map_or(1.0, |place| place.factor);
        match content {
            Content::NoColumn => Ok(None),
            Content::Number(number) if is_good(number.value * factor) => {
                if !self.keeps_sign(column, &number) {
                    return Err(Faulty);
                }
                self.table.met(column, number.value);
                Ok(Some(number.value * factor))
            }
            content => {
                self.fault(column, &content, expected);
                Err(Faulty)
            }
        }
    }

    fn fault(&mut self, column: usize, content: &Content, expected: &str) {
        let help = match content {
            Content::Other(none) => none.help(),
            _ => None,
        };
        self.refuse_with(column, expected, help);
    }

    /// Whether the decimals of a cell begin with the sign that the table had so far; records a fault if not.
    fn keeps_sign(&mut self, column: usize, number: &Number) -> bool {
        let keeps = self.table.keeps_sign(number);
        if !keeps {
            self.refuse_with(
                column,
                "a number with the decimal sign of the rows before",
                Some("use one decimal sign"),
            );
        }
        keeps
    }
}

/// The text of a cell, cut where it is very long: messages quote it.
pub(crate) fn short(text: &str) -> String {
    const MOST: usize = 60;
    match text.char_indices().nth(MOST) {
        None => text.to_owned(),
        Some((end, _)) => format!("{}...", &text[..end]),
    }
}

impl Table {
    /// Records a fault at bytes of the text: what is wrong, what was expected, what to do.
    pub(crate) fn fault(&mut self, at: Range<usize>, title: String, expected: &str, help: Option<String>) {
        let found = short(unquoted(self.bytes(&at)).as_ref());
        let problem = Problem::at(&self.place(at), title).found(found).expected(expected);
        self.push(Problem { help, ..problem });
    }
}
