//! Lists of craters as CSV: `x_m,y_m,radius_m,depth_m,rim_m,type` and, where wanted, `outer_m` and `floor_m`; the header
//! is required, its columns may stand in any order. Lines that begin with `#` are comments.
//!
//! `radius_m` is the radius at which the bowl or wall comes up to the ground around, the inner foot of the rim (r1 of
//! types 1 and 2, r2 of type 3). `outer_m` is the outer foot of the rim, 1.4 times as far where nothing is given (the
//! rim crest then stands at 1.2 radii: Pike 1977 has the radius at ground level as 0.83 of that of the crest);
//! `floor_m` the radius of the flat floor, 0.4 times as far where nothing is given (our choice).
//!
//! A file whose name ends in `.npy` holds the same columns as an array.

mod array;
mod columns;
mod faults;
mod row;

use std::path::Path;
use std::sync::Arc;

use diagnostics::{CsvRows, Problem, ProblemList, Source};
use limits::Limit;

use crate::Craters;
use columns::Columns;
use faults::Faults;
use row::crater;

/// The craters of a list, in its order.
///
/// # Errors
/// Every fault of the file by line and column, the first twenty of them in full: a file that cannot be read, missing,
/// doubled or unknown columns, cells that are no finite number or out of range, radii that do not ascend, a type that
/// is not 1, 2 or 3, values that the type has no use for. Of an array: by row.
pub fn read(path: impl AsRef<Path>) -> Result<Craters, ProblemList> {
    if path.as_ref().extension().is_some_and(|end| end == "npy") {
        return array::read(path.as_ref());
    }
    let name = path.as_ref().display().to_string();
    let bytes = files::read_all(path.as_ref(), Limit::ListBytes)
        .map_err(|error| Problem::of_file(&name, error.to_string()))?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let title = format!("not text: byte {} is not UTF-8", error.utf8_error().valid_up_to());
        Problem::of_file(&name, title).help("save the file as UTF-8")
    })?;
    parse(Source { name, text })
}

fn parse(source: Source) -> Result<Craters, ProblemList> {
    let source = Arc::new(source);
    let mut faults = Faults::new(source.clone());
    let mut rows = CsvRows::new(&source.text);
    let mut craters = Craters::default();
    let Some(header) = rows.next_row() else {
        faults.push(0..0, "an empty list of craters".into(), "a header and at least one row");
        return faults.finish(craters);
    };
    let (columns, line) = (Columns::read(&header, &mut faults), header.whole());
    while let Some(row) = rows.next_row() {
        if let Some(crater) = crater(&row, &columns, &mut faults) {
            craters.push(crater);
        }
    }
    if craters.is_empty() && faults.is_empty() {
        faults.push(line, "a list of craters without rows".into(), "at least one row under the header");
    }
    faults.finish(craters)
}
