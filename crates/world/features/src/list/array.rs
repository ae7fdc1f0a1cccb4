//! Lists of craters as a NumPy array: nothing is parsed, so a million of them are read in a moment.

use std::path::Path;

use diagnostics::{LongList, Problem, Problems};
use files::{NpyData, read_npy};
use limits::Limit;

use super::row::{FLOOR, OUTER};
use crate::{Crater, Craters, Shape};

/// The craters of an array `[craters, 6]` or `[craters, 8]` of float64: the columns of the text form in their order, `type`
/// as 1, 2 or 3, NaN in `outer_m` and `floor_m` where nothing is given. Faults go to `problems`: a file that cannot be read,
/// another shape or type, and the first twenty rows that are no crater.
pub(super) fn read(path: &Path, problems: &Problems) -> Option<Craters> {
    let name = path.display().to_string();
    let refused = |title: String, help: &str| {
        problems.push(Problem::of_file(&name, title).help(help));
        None
    };
    let array = match read_npy(path, Limit::ListBytes) {
        Ok(array) => array,
        Err(error) => return refused(error.to_string(), "give an array that NumPy's save has written"),
    };
    let (shape, data) = array.into_parts();
    let width = match shape.as_slice() {
        &[_, width @ (6 | 8)] => width,
        _ => {
            let title =
                format!("a list of craters of shape {shape:?}: expected [craters, 6] or [craters, 8]");
            return refused(title, "columns: x_m, y_m, radius_m, depth_m, rim_m, type, outer_m, floor_m");
        }
    };
    let NpyData::F64(values) = data else {
        return refused("a list of craters that is not float64".into(), "save it as float64");
    };
    if values.is_empty() {
        return refused("a list of craters without rows".into(), "give at least one row");
    }
    let (mut craters, mut faults) = (Craters::with_room(values.len() / width), LongList::new(&name));
    for (number, row) in values.chunks_exact(width).enumerate() {
        match crater(row) {
            Ok(crater) => craters.push(crater),
            Err(fault) => faults.push(Problem::of_file(&name, format!("row {number} (from 0): {fault}"))),
        }
    }
    faults.finish(craters, problems)
}

fn crater(row: &[f64]) -> Result<Crater, String> {
    let [x, y, radius, depth, rim, kind] = [0, 1, 2, 3, 4, 5].map(|column| row[column]);
    let given = |column: usize| row.get(column).copied().filter(|value| !value.is_nan());
    let (outer, floor) = (given(6), given(7));
    let is_idle = |value: Option<f64>, name: &str| match value {
        Some(value) => Err(format!("{name} is {value}, but type {kind} has no use for it: give NaN")),
        None => Ok(()),
    };
    let shape = match kind {
        1.0 => {
            is_idle(outer, "outer_m")?;
            is_idle(floor, "floor_m")?;
            Shape::Bowl { r1: radius }
        }
        2.0 => {
            is_idle(floor, "floor_m")?;
            Shape::RimmedBowl { r1: radius, r2: outer.unwrap_or(OUTER * radius) }
        }
        3.0 => Shape::FlatFloor {
            r1: floor.unwrap_or(FLOOR * radius),
            r2: radius,
            r3: outer.unwrap_or(OUTER * radius),
        },
        _ => return Err(format!("type is {kind}, expected 1, 2 or 3")),
    };
    Crater::new([x, y], shape, depth, rim).map_err(|error| error.to_string())
}
