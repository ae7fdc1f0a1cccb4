//! The table as text: a row for each family of signals, a column for each overlay.

use std::collections::BTreeSet;

use signal_plane::signals;

use crate::overlays::Row;
use crate::overlays::drawing::{behind, family};
use crate::overlays::exceptions::EXCEPTIONS;

/// The overlays by number, the table, and why some signals do not move: as the page has them.
pub fn page(rows: &[Row]) -> String {
    let numbered = |(number, row): (usize, &Row)| format!("{} {}", number + 1, row.overlay.name);
    let names: Vec<String> = rows.iter().enumerate().map(numbered).collect();
    let mut page = format!("```text\n{}\n```\n\n{}.\n\n", table(rows), names.join(", "));
    page += "| overlay | need not move | because |\n|---|---|---|\n";
    for (overlay, families, reason) in EXCEPTIONS {
        let families: Vec<String> = families.iter().map(|family| format!("`{family}`")).collect();
        page += &format!("| `{overlay}` | {} | {reason} |\n", families.join(", "));
    }
    page
}

/// Rows in the order of the signal table.
fn table(rows: &[Row]) -> String {
    let mut told = BTreeSet::new();
    let families: Vec<String> = signals()
        .iter()
        .map(|signal| family(signal.name))
        .filter(|family| told.insert(family.clone()))
        .collect();
    let width = families.iter().map(String::len).max().unwrap_or(0);
    let mut text = format!("{:width$} ", "");
    (1..=rows.len()).for_each(|number| text += &(number / 10).to_string());
    text += &format!("\n{:width$} ", "");
    (1..=rows.len()).for_each(|number| text += &(number % 10).to_string());
    let reach: Vec<_> = rows.iter().map(|row| behind(row.overlay.at)).collect();
    for name in &families {
        text += &format!("\n{name:width$} ");
        for (row, reach) in rows.iter().zip(&reach) {
            text.push(match (row.moved.contains(name), reach.contains(name)) {
                (true, true) => '#',
                (true, false) => '+',
                (false, true) => '=',
                (false, false) => '.',
            });
        }
    }
    text
}
