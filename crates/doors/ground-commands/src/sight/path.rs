//! Targets from a file.

use std::path::Path;

use diagnostics::Problems;
use sight::{Height, Point};
use tables::{Column, Form, Row, Table, read_text};

use super::options::point;
use command_line::Failure;

const FORM: Form = Form {
    what: "list of targets",
    columns: &[Column::needed("north_m"), Column::needed("east_m"), Column::optional("height_m")],
    harmless: &[],
};
/// Farthest place from the origin (m).
const FARTHEST: f64 = 1e9;
/// Largest height above the ground (m).
const HIGHEST: f64 = 1e7;

/// Reads targets: a height in a row stands above the ground and counts instead of `height`.
pub fn targets(path: &Path, height: Height) -> Result<Vec<Point>, Failure> {
    let problems = Problems::new();
    let read = read_text(path, &problems).and_then(|text| {
        let mut table = Table::with_header(text, &FORM);
        let mut targets = Vec::new();
        while let Some(mut row) = table.next_row() {
            targets.extend(target(&mut row, height));
        }
        table.finish(targets, &problems)
    });
    let targets = problems.resolve(read)?;
    if targets.is_empty() {
        return Err(Failure::input(format!("{}: no targets; expected a row or more", path.display())));
    }
    Ok(targets)
}

fn target(row: &mut Row<'_>, height: Height) -> Option<Point> {
    let north = row.number(0, -FARTHEST..=FARTHEST);
    let east = row.number(1, -FARTHEST..=FARTHEST);
    let own = row.optional_number(2, 0.0..=HIGHEST).ok()?;
    Some(point([north?, east?], own.map_or(height, Height::AboveGround)))
}
