//! The header of a list.

use diagnostics::CsvRow;

use super::faults::Faults;

/// Names of the columns; the first six must be there.
const NAMES: [&str; 8] = ["x_m", "y_m", "radius_m", "depth_m", "rim_m", "type", "outer_m", "floor_m"];
const NEEDED: usize = 6;

/// A column of a list.
#[derive(Debug, Clone, Copy)]
pub(super) enum Column {
    X,
    Y,
    Radius,
    Depth,
    Rim,
    Type,
    Outer,
    Floor,
}

impl Column {
    /// As the header has it.
    pub fn name(self) -> &'static str {
        NAMES[self as usize]
    }
}

/// Where each column stands.
pub(super) struct Columns {
    places: [Option<usize>; NAMES.len()],
    /// Cells in the header, hence in every row.
    pub width: usize,
}

impl Columns {
    pub fn read(header: &CsvRow, faults: &mut Faults) -> Self {
        let mut places = [None; NAMES.len()];
        faults.expect_closed(header);
        for (index, text) in header.texts().enumerate() {
            match NAMES.iter().position(|name| *name == text) {
                Some(column) if places[column].is_some() => {
                    let title = format!("column `{text}` stands twice");
                    faults.push(header.span(index), title, "each column once");
                }
                Some(column) => places[column] = Some(index),
                None => {
                    let expected = format!("one of {}", NAMES.join(", "));
                    faults.push(header.span(index), format!("unknown column `{text}`"), &expected);
                }
            }
        }
        for (name, _) in NAMES.iter().zip(&places).take(NEEDED).filter(|(_, place)| place.is_none()) {
            let expected = format!("a header such as {}", NAMES[..NEEDED].join(","));
            faults.push(header.whole(), format!("missing column `{name}`"), &expected);
        }
        Self { places, width: header.width() }
    }

    /// Which cell of a row a column is, if the list has it.
    pub fn of(&self, column: Column) -> Option<usize> {
        self.places[column as usize]
    }
}
