//! The matrix of stability as a picture.

use std::path::Path;

use plots::{MatrixBlock, MatrixCell, MatrixRow, Tone, matrix_picture};

use super::folder::{ReportError, save};
use crate::stability::{Action, Cell, rows};

const LEGEND: [(Tone, &str); 7] = [
    (Tone::Holds, "holds"),
    (Tone::Split, "holds, split where its law changes"),
    (Tone::Clamped, "holds, something left out and counted"),
    (Tone::Refused, "refused, as it must be"),
    (Tone::Worse, "method for comparison: less exact than parts must be"),
    (Tone::Breaks, "method for comparison: no bounds"),
    (Tone::Fault, "method of the machine: does not hold"),
];
const READING: &str = "One case a line; methods of the machine in black, methods for comparison in grey. In a cell: the largest \
                       error in full scales; of parts in whole frames its root mean square, of the machine the RMSE of \
                       the picture against exact.";

/// A method, and whether it is there for comparison only.
type Method<'a> = (&'a str, bool);

/// `matrix.svg` and `matrix.png` of the single extremes; of pairs and mixtures, thousands, `facts` has the counts.
pub fn write_matrix(folder: &Path, facts: &str, cells: &[Cell]) -> Result<(), ReportError> {
    let known = rows();
    let singles: Vec<&Cell> = cells.iter().filter(|cell| known.contains(&cell.row)).collect();
    let dimensions: Vec<&[&Cell]> = singles.chunk_by(|a, b| a.row == b.row).collect();
    if dimensions.is_empty() {
        return Ok(());
    }
    let with_methods: Vec<(Vec<Method<'_>>, &[&Cell])> =
        dimensions.into_iter().map(|cells| (methods(cells), cells)).collect();
    let blocks: Vec<MatrixBlock<'_>> = with_methods
        .chunk_by(|a, b| a.0 == b.0)
        .map(|alike| MatrixBlock {
            methods: alike[0].0.clone(),
            rows: alike.iter().flat_map(|(methods, cells)| matrix_rows(methods, cells)).collect(),
        })
        .collect();
    let facts = [facts.to_owned(), READING.to_owned()];
    save(folder, "matrix", matrix_picture("Stability", &facts, &LEGEND, &blocks))
}

/// Methods of a dimension in the order in which they appear: not every case knows all of them.
fn methods<'a>(cells: &[&'a Cell]) -> Vec<Method<'a>> {
    let mut methods = Vec::new();
    for cell in cells {
        if !methods.contains(&(cell.method, !cell.own)) {
            methods.push((cell.method, !cell.own));
        }
    }
    methods
}

fn matrix_rows<'a>(methods: &[Method<'_>], cells: &[&'a Cell]) -> Vec<MatrixRow<'a>> {
    let row = |case: &[&'a Cell]| MatrixRow {
        group: case[0].row,
        case: &case[0].case,
        cells: methods
            .iter()
            .map(|(method, _)| case.iter().find(|cell| cell.method == *method).map(|cell| matrix_cell(cell)))
            .collect(),
    };
    cells.chunk_by(|a, b| a.case == b.case).map(row).collect()
}

fn matrix_cell(cell: &Cell) -> MatrixCell {
    let tone = match &cell.action {
        _ if cell.fault.is_some() => Tone::Fault,
        _ if !cell.finite || !cell.bounded => Tone::Breaks,
        _ if !cell.is_sound() => Tone::Worse,
        Action::Refused(_) => Tone::Refused,
        Action::Clamped(_) => Tone::Clamped,
        Action::Split => Tone::Split,
        Action::Exact | Action::Stepped | Action::Panicked(_) => Tone::Holds,
    };
    let text = match (&cell.action, cell.error) {
        (Action::Refused(_), _) => "refused".to_owned(),
        (Action::Panicked(_), _) => "panic".to_owned(),
        (_, Some(error)) if !cell.finite || !error.is_finite() => "inf".to_owned(),
        (_, Some(0.0)) => "0".to_owned(),
        (_, Some(error)) => format!("{error:.0e}"),
        (_, None) => String::new(),
    };
    MatrixCell { tone, text }
}
