//! Catalogues of stars as CSV.

use std::path::Path;

use diagnostics::Problems;
use limits::Limit;
use quantities::radians;
use tables::{Column, Form, Row, Table, read_text};

use crate::Star;

const RIGHT_ASCENSION: usize = 0;
const DECLINATION: usize = 1;
const MAGNITUDE: usize = 2;
const COLOUR_INDEX: usize = 3;

/// The table of a catalogue of stars.
const FORM: Form = Form {
    what: "catalogue of stars",
    columns: &[
        Column::needed("right_ascension_deg"),
        Column::needed("declination_deg"),
        Column::needed("magnitude"),
        Column::optional("b_v"),
    ],
    harmless: &["name"],
};

/// The stars of a catalogue, in its order; every broken row goes to `problems`.
pub(super) fn read(path: &Path, problems: &Problems) -> Option<Vec<Star>> {
    let mut table = Table::with_header(read_text(path, problems)?, &FORM);
    let mut stars = Vec::new();
    while let Some(mut row) = table.next_row() {
        if !Limit::Stars.allows(stars.len() as u64 + 1) {
            let most = Limit::Stars.value();
            let title = format!("more than {most} stars; {}", Limit::Stars);
            row.refuse_row(title, &format!("at most {most} stars"));
            break;
        }
        stars.extend(star(&mut row));
    }
    table.finish(stars, problems)
}

/// The star of a row; nothing where the row has a fault.
fn star(row: &mut Row) -> Option<Star> {
    let right_ascension = row.number(RIGHT_ASCENSION, -360.0..=360.0);
    let declination = row.number(DECLINATION, -90.0..=90.0);
    let magnitude = row.number(MAGNITUDE, -50.0..=50.0);
    let colour_index = row.optional_number(COLOUR_INDEX, -0.5..=6.0);
    Some(Star::at(radians(right_ascension?), radians(declination?), magnitude?, colour_index.ok()?))
}
