//! One row of a list.

use tables::{Faulty, Row};

use super::form::{DEPTH, FLOOR_RADIUS, OUTER_RADIUS, RADIUS, RIM, TYPE, X, Y};
use crate::{Crater, Shape};

/// Outer foot of the rim over radius, where the list does not say.
pub(super) const OUTER: f64 = 1.4;

/// Floor over radius, where the list does not say.
pub(super) const FLOOR: f64 = 0.4;

/// Radii beyond this are a mistake (m).
const LARGEST: f64 = 1e8;

/// The crater of a row; nothing where the row has a fault or a needed column is missing.
pub(super) fn crater(row: &mut Row) -> Option<Crater> {
    let (x, y) = (length(row, X, -1e9, 1e9), length(row, Y, -1e9, 1e9));
    let is_radius = |radius: f64| radius > 0.0 && radius <= LARGEST;
    let radius = row.number_that(RADIUS, is_radius, &format!("a number above 0 to {LARGEST} m"));
    let (depth, rim) = (length(row, DEPTH, 0.0, 1e5), length(row, RIM, 0.0, 1e5));
    let kind = row.number_that(TYPE, |kind| [1.0, 2.0, 3.0].contains(&kind), "1, 2 or 3");
    let (radius, kind) = (radius?, kind? as u32);
    let shape = shape(row, kind, radius, rim).ok()?;
    let made = Crater::new([x?, y?], shape, depth?, rim?);
    made.map_err(|error| row.refuse_row(error.to_string(), "a crater that can be")).ok()
}

/// A length in metres from a range, both ends allowed.
fn length(row: &mut Row, column: usize, low: f64, high: f64) -> Option<f64> {
    row.number_that(
        column,
        |number| (low..=high).contains(&number),
        &format!("a number from {low} to {high} m"),
    )
}

/// The shape of a crater type; a value that the type has no use for is a fault, not passed over.
fn shape(row: &mut Row, kind: u32, radius: f64, rim: Option<f64>) -> Result<Shape, Faulty> {
    let none = |_: f64| false;
    let outer = match kind {
        1 => row.optional_number_that(OUTER_RADIUS, none, "nothing: type 1 has no rim"),
        _ => {
            let expected = format!("a number above radius_m = {radius} to {LARGEST} m");
            row.optional_number_that(OUTER_RADIUS, |outer| outer > radius && outer <= LARGEST, &expected)
        }
    };
    let floor = match kind {
        3 => {
            let expected = format!("a number above 0 and below radius_m = {radius} m");
            row.optional_number_that(FLOOR_RADIUS, |floor| floor > 0.0 && floor < radius, &expected)
        }
        _ => row.optional_number_that(FLOOR_RADIUS, none, "nothing: only type 3 has a flat floor"),
    };
    if kind == 1 && rim.is_some_and(|rim| rim > 0.0) {
        row.refuse(RIM, "0: type 1 has no rim");
        return Err(Faulty);
    }
    let (outer, floor) = (outer?.unwrap_or(OUTER * radius), floor?.unwrap_or(FLOOR * radius));
    Ok(match kind {
        1 => Shape::Bowl { r1: radius },
        2 => Shape::RimmedBowl { r1: radius, r2: outer },
        _ => Shape::FlatFloor { r1: floor, r2: radius, r3: outer },
    })
}
