//! Paths as CSV: `t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg`, the header required, in any order.

use diagnostics::{CsvRow, CsvRows, Placed, Problems};
use quantities::radians;

use super::course::{MAX_TIME, PlacedWaypoint};
use super::number_table::{Cell, NumberTable, cells};
use super::scenery::MAX_COORDINATE;
use crate::Waypoint;

/// Columns with a meaning; the first three must be there.
const COLUMNS: [&str; 7] = ["t_s", "x_m", "y_m", "z_m", "heading_deg", "pitch_deg", "roll_deg"];
const NEEDED: usize = 3;
/// Largest numbers in them, either way: of headings a hundred turns.
const MOST: [f64; COLUMNS.len()] =
    [MAX_TIME, MAX_COORDINATE, MAX_COORDINATE, MAX_COORDINATE, 36_000.0, 360.0, 360.0];
/// Columns that `poses.csv` of a run has besides; they follow from the others.
const PASSED_OVER: [&str; 4] = ["frame", "speed_m_s", "turn_deg_s", "slope_deg"];

/// The rows of a path file.
pub(super) fn waypoints(name: &str, text: &str, problems: &Problems) -> Option<Vec<PlacedWaypoint>> {
    let mut table = NumberTable::new(name, text, problems);
    let mut rows = CsvRows::new(text);
    let Some(header) = rows.next_row() else {
        table.fault(&(0..0), "an empty path file".into(), "a header and at least one row");
        return table.finish(Vec::new());
    };
    expect_closed(&mut table, &header);
    let header = cells(&header);
    let (columns, width, first) = (columns(&mut table, &header), header.len(), header[0].span.clone());
    let (mut waypoints, mut has_rows) = (Vec::new(), false);
    while let Some(row) = rows.next_row() {
        has_rows = true;
        if expect_closed(&mut table, &row) {
            waypoints.extend(waypoint(&mut table, &cells(&row), &columns, width));
        }
    }
    if !has_rows {
        table.fault(&first, "a path file without rows".into(), "at least one row under the header");
    }
    table.finish(waypoints)
}

/// Whether every quote of a row ends in it; records a fault if not.
fn expect_closed(table: &mut NumberTable, row: &CsvRow) -> bool {
    let open = row.open_quote();
    open.iter().for_each(|quote| table.fault(quote, "a quote that is not closed".into(), "a second quote"));
    open.is_none()
}

/// For each of [`COLUMNS`], where it stands.
fn columns(table: &mut NumberTable, header: &[Cell]) -> [Option<usize>; COLUMNS.len()] {
    let mut found = [None; COLUMNS.len()];
    for (index, cell) in header.iter().enumerate() {
        match COLUMNS.iter().position(|name| *name == cell.text) {
            Some(column) if found[column].is_some() => {
                table.fault(&cell.span, format!("column `{}` stands twice", cell.text), "each column once");
            }
            Some(column) => found[column] = Some(index),
            None if PASSED_OVER.contains(&cell.text) => {}
            None => {
                let title = format!("unknown column `{}`", cell.text);
                table.fault(&cell.span, title, &format!("one of {}", COLUMNS.join(", ")));
            }
        }
    }
    let line = header[0].span.start..header[header.len() - 1].span.end;
    for (name, _) in COLUMNS.iter().zip(&found).take(NEEDED).filter(|(_, found)| found.is_none()) {
        table.fault(
            &line,
            format!("missing column `{name}`"),
            &format!("a header such as {}", COLUMNS.join(",")),
        );
    }
    found
}

fn waypoint(
    table: &mut NumberTable,
    row: &[Cell],
    columns: &[Option<usize>; COLUMNS.len()],
    width: usize,
) -> Option<PlacedWaypoint> {
    if row.len() != width {
        let span = row[0].span.start..row[row.len() - 1].span.end;
        table.fault(
            &span,
            format!("a row of {} cells under a header of {width}", row.len()),
            "as many cells",
        );
        return None;
    }
    let cell = |column: usize| columns[column].map(|index| &row[index]);
    let mut needed = |column: usize| table.number(cell(column)?, COLUMNS[column], MOST[column]);
    let (time, x, y) = (needed(0), needed(1), needed(2));
    let mut optional = |column: usize| match cell(column) {
        Some(cell) if !cell.text.is_empty() => table.number(cell, COLUMNS[column], MOST[column]),
        _ => None,
    };
    let (eye_height, [heading, pitch, roll]) = (optional(3), [4, 5, 6].map(|i| optional(i).map(radians)));
    let waypoint = Waypoint { time: time?, at: [x?, y?], heading, eye_height, pitch, roll };
    Some(Placed { value: waypoint, place: table.place(&cell(0)?.span), key: COLUMNS[0].into() })
}
