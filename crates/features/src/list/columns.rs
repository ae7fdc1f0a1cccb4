//! The header of a list.

use std::ops::Range;

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
    pub fn read(header: &[Range<usize>], faults: &mut Faults) -> Self {
        let mut places = [None; NAMES.len()];
        for (index, cell) in header.iter().enumerate() {
            let text = faults.text(cell).to_owned();
            match NAMES.iter().position(|name| *name == text) {
                Some(column) if places[column].is_some() => {
                    faults.push(cell.clone(), format!("column `{text}` stands twice"), "each column once");
                }
                Some(column) => places[column] = Some(index),
                None => {
                    let expected = format!("one of {}", NAMES.join(", "));
                    faults.push(cell.clone(), format!("unknown column `{text}`"), &expected);
                }
            }
        }
        let line = header[0].start..header[header.len() - 1].end;
        for (name, _) in NAMES.iter().zip(&places).take(NEEDED).filter(|(_, place)| place.is_none()) {
            let expected = format!("a header such as {}", NAMES[..NEEDED].join(","));
            faults.push(line.clone(), format!("missing column `{name}`"), &expected);
        }
        Self { places, width: header.len() }
    }

    /// The cell of a column, if the list has it.
    pub fn of<'r>(&self, row: &'r [Range<usize>], column: Column) -> Option<&'r Range<usize>> {
        self.places[column as usize].map(|index| &row[index])
    }
}
