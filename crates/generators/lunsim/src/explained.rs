//! What the program told beside a picture, and where a pixel comes from.

use generator::{Fact, PlaneKind};

use crate::area::ViewedArea;
use crate::film::Film;

/// The viewed area, and what the grid has at the pixel `at`: its column of so many, its line of so many.
pub(crate) fn facts(film: &Film<'_>, area: &ViewedArea, at: [[usize; 2]; 2]) -> Vec<Fact> {
    let mut facts = vec![Fact::new("viewed area", limits(film, area))];
    let Some(point) = film.point_at(at) else {
        facts.push(Fact::new("point", "none is plotted here"));
        return facts;
    };
    let (size, steps) = (film.grid.size, film.grid.steps);
    let (row, column) = (point / size, point % size);
    let [north, east] = film.observer.on_map(film.grid.place(row, column));
    let value = |kind| film.value(kind, point);
    let shade = if film.light[point].is_dark() { "in shadow" } else { "lit" };
    facts.extend([
        Fact::new(
            "point",
            format!(
                "row {row}, column {column} of {size} x {size}, {:.2} m along and {:.2} m across from one to the next",
                steps[0], steps[1]
            ),
        ),
        Fact::new(
            "ground",
            format!("{north:.1} m north, {east:.1} m east, {:.2} m high", value(PlaneKind::Height)),
        ),
        Fact::new("light", format!("reflectivity {:.4}, {shade}", value(PlaneKind::Reflectivity))),
        Fact::new("code", format!("{} of 0 to {}", film.code(point), film.codes.count - 1)),
    ]);
    facts
}

/// The limits that the program printed (columns 10 to 13 of its Table 1), on the map, and how much ground that is.
fn limits(film: &Film<'_>, area: &ViewedArea) -> String {
    let corners = area.along.map(|along| area.across.map(|across| film.observer.on_map([along, across])));
    let ends = |axis: usize| {
        let places = corners.as_flattened().iter().map(|corner| corner[axis]);
        [places.clone().fold(f64::INFINITY, f64::min), places.fold(f64::NEG_INFINITY, f64::max)]
    };
    let ([south, north], [west, east]) = (ends(0), ends(1));
    let [length, width] = [area.along, area.across].map(|[low, high]| high - low);
    format!(
        "{south:.0} to {north:.0} m north, {west:.0} to {east:.0} m east; {:.1} km2",
        1e-6 * length * width
    )
}
