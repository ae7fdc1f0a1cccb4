//! Lists of craters as CSV: `x_m,y_m,radius_m,depth_m,rim_m,type` and, where wanted, `outer_m` and `floor_m`; the header
//! is required, its columns may stand in any order. The crate `tables` says what else a table may look like.
//!
//! `radius_m` is the radius at which the bowl or wall comes up to the ground around, the inner foot of the rim (r1 of
//! types 1 and 2, r2 of type 3). `outer_m` is the outer foot of the rim, 1.4 times as far where nothing is given (the
//! rim crest then stands at 1.2 radii: Pike 1977 has the radius at ground level as 0.83 of that of the crest);
//! `floor_m` the radius of the flat floor, 0.4 times as far where nothing is given (our choice).
//!
//! A file whose name ends in `.npy` holds the same columns as an array.

mod array;
mod form;
mod row;

use std::path::Path;

use diagnostics::{ProblemList, Problems};
use tables::{Table, read_text};

use crate::Craters;
use form::FORM;
use row::crater;

/// The craters of a list, in its order.
///
/// # Errors
/// Every fault of the file by line and column, the first twenty of them in full: a file that cannot be read, missing,
/// doubled or unknown columns, cells that are no finite number or out of range, radii that do not ascend, a type that
/// is not 1, 2 or 3, values that the type has no use for. Of an array: by row.
pub fn read(path: impl AsRef<Path>) -> Result<Craters, ProblemList> {
    let problems = Problems::new();
    let craters = read_into(path.as_ref(), &problems);
    problems.resolve(craters)
}

/// The same, with faults and notes in `problems`.
pub fn read_into(path: &Path, problems: &Problems) -> Option<Craters> {
    if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("npy")) {
        return array::read(path, problems);
    }
    let mut table = Table::with_header(read_text(path, problems)?, &FORM);
    let mut craters = Craters::default();
    while let Some(mut row) = table.next_row() {
        craters.extend(crater(&mut row));
    }
    table.finish(craters, problems)
}
