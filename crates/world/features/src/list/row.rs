//! One row of a list.

use diagnostics::CsvRow;

use super::columns::{Column, Columns};
use super::faults::Faults;
use crate::{Crater, Shape};

/// Outer foot of the rim over radius, where the list does not say.
pub(super) const OUTER: f64 = 1.4;

/// Floor over radius, where the list does not say.
pub(super) const FLOOR: f64 = 0.4;

/// Radii beyond this are a mistake (m).
const LARGEST: f64 = 1e8;

/// The crater of a row; nothing where the row has a fault or a needed column is missing.
pub(super) fn crater(row: &CsvRow, columns: &Columns, faults: &mut Faults) -> Option<Crater> {
    if !faults.expect_closed(row) {
        return None;
    }
    if row.width() != columns.width {
        let title = format!("a row of {} cells under a header of {}", row.width(), columns.width);
        faults.push(row.whole(), title, "as many cells");
        return None;
    }
    let mut reader = Row { row, columns, faults };
    let place = |_: f64| true;
    let (x, y) = (reader.length(Column::X, -1e9..=1e9, place), reader.length(Column::Y, -1e9..=1e9, place));
    let radius = reader.length(Column::Radius, 0.0..=LARGEST, |radius| radius > 0.0);
    let depth = reader.length(Column::Depth, 0.0..=1e5, place);
    let rim = reader.length(Column::Rim, 0.0..=1e5, place);
    let kind = reader.kind();
    let (radius, kind) = (radius?, kind?);
    let shape = reader.shape(kind, radius, rim)?;
    let made = Crater::new([x?, y?], shape, depth?, rim?);
    made.map_err(|error| reader.faults.push(row.whole(), error.to_string(), "a crater that can be")).ok()
}

struct Row<'a> {
    row: &'a CsvRow<'a>,
    columns: &'a Columns,
    faults: &'a mut Faults,
}

impl<'a> Row<'a> {
    /// What stands in a column, if the list has it.
    fn text(&self, column: Column) -> Option<&'a str> {
        self.columns.of(column).map(|cell| self.row.text(cell))
    }

    /// A length in metres from a range, both ends allowed, that is `good` besides.
    fn length(
        &mut self,
        column: Column,
        range: std::ops::RangeInclusive<f64>,
        good: impl Fn(f64) -> bool,
    ) -> Option<f64> {
        let text = self.text(column)?;
        // NaN is not in the range either.
        let number = text.parse().ok().filter(|number| range.contains(number) && good(*number));
        if number.is_none() {
            let (low, high) = (range.start(), range.end());
            let low = if good(*low) { format!("from {low}") } else { format!("above {low}") };
            self.refuse(column, &format!("a number {low} to {high} m"));
        }
        number
    }

    /// The same where the cell may be missing or empty.
    fn wish(
        &mut self,
        column: Column,
        good: impl Fn(f64) -> bool,
        expected: &str,
    ) -> Result<Option<f64>, ()> {
        let Some(text) = self.text(column).filter(|text| !text.is_empty()) else {
            return Ok(None);
        };
        let number = text.parse().ok().filter(|number| good(*number));
        if number.is_none() {
            self.refuse(column, expected);
        }
        number.map(Some).ok_or(())
    }

    fn kind(&mut self) -> Option<u32> {
        let kind = self.text(Column::Type)?.parse().ok().filter(|kind| (1..=3).contains(kind));
        if kind.is_none() {
            self.refuse(Column::Type, "1, 2 or 3");
        }
        kind
    }

    /// The shape of a crater type; a value that the type has no use for is a fault, not passed over.
    fn shape(&mut self, kind: u32, radius: f64, rim: Option<f64>) -> Option<Shape> {
        let none = |_: f64| false;
        let outer = match kind {
            1 => self.wish(Column::Outer, none, "nothing: type 1 has no rim"),
            _ => {
                let expected = format!("a number above radius_m = {radius} to {LARGEST} m");
                self.wish(Column::Outer, |outer| outer > radius && outer <= LARGEST, &expected)
            }
        };
        let floor = match kind {
            3 => {
                let expected = format!("a number above 0 and below radius_m = {radius} m");
                self.wish(Column::Floor, |floor| floor > 0.0 && floor < radius, &expected)
            }
            _ => self.wish(Column::Floor, none, "nothing: only type 3 has a flat floor"),
        };
        if kind == 1 && rim.is_some_and(|rim| rim > 0.0) {
            self.refuse(Column::Rim, "0: type 1 has no rim");
            return None;
        }
        let (outer, floor) = (outer.ok()?.unwrap_or(OUTER * radius), floor.ok()?.unwrap_or(FLOOR * radius));
        Some(match kind {
            1 => Shape::Bowl { r1: radius },
            2 => Shape::RimmedBowl { r1: radius, r2: outer },
            _ => Shape::FlatFloor { r1: floor, r2: radius, r3: outer },
        })
    }

    fn refuse(&mut self, column: Column, expected: &str) {
        let Some(cell) = self.columns.of(column) else { return };
        let text = self.row.text(cell);
        let found = if text.is_empty() { "nothing" } else { text };
        let title = format!("`{}` must be {expected}, not {found}", column.name());
        self.faults.push(self.row.span(cell), title, expected);
    }
}
