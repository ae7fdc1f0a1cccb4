//! Control points as a table.
//!
//! | column | what |
//! |---|---|
//! | `i_px`, `j_px` | the pixel where the photograph shows the point, I to the right, J downward; the centre of the first is 0.5, 0.5 |
//! | `east_m`, `north_m` | the place in the metres of the elevation file |
//! | `latitude`, `longitude` | or the place in degrees: -122.0383, or 122:02:17.89 W |
//! | `height_m` | the height; that of the elevation grid where it is left out |
//! | `name` | a name for the report |

use std::path::Path;

use diagnostics::{ProblemList, Problems};
use photo_camera::{Axis, ControlPoint, parse_angle};
use quantities::radians;
use survey::Frame;
use tables::{Column, Form, Row, Table, read_text};

use crate::Ground;

const FORM: Form = Form {
    what: "list of control points",
    columns: &[
        Column::needed("i_px"),
        Column::needed("j_px"),
        Column::optional("east_m"),
        Column::optional("north_m"),
        Column::optional("latitude"),
        Column::optional("longitude"),
        Column::optional("height_m"),
        Column::optional("name"),
    ],
    harmless: &[],
};
const PIXEL: [usize; 2] = [0, 1];
const METRES: [usize; 2] = [2, 3];
const ANGLES: [usize; 2] = [4, 5];
const HEIGHT: usize = 6;
const NAME: usize = 7;

/// Farthest place and pixel that a table may hold.
const FARTHEST: f64 = 1e9;

/// A control point with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Control {
    /// Name of the point; its number, from 1, where the table has none.
    pub name: String,
    /// Ground point in the axes of the photograph, and measured pixel.
    pub point: ControlPoint,
}

/// The control points of a table, for a photograph over `ground`.
///
/// # Errors
/// Every fault of the table by line and column; a point without a height beside the grid.
pub fn read_points(path: &Path, ground: &Ground) -> Result<Vec<Control>, ProblemList> {
    let problems = Problems::new();
    let points = read_text(path, &problems).and_then(|source| {
        let mut table = Table::with_header(source, &FORM);
        let by_angles = by_angles(&mut table, ground);
        let mut points = Vec::new();
        while let Some(mut row) = table.next_row() {
            let number = points.len() + 1;
            points.extend(control(&mut row, ground, by_angles, number));
        }
        table.finish(points, &problems)
    });
    problems.resolve(points)
}

/// Whether the places are latitudes and longitudes; records columns that are missing.
fn by_angles(table: &mut Table, ground: &Ground) -> bool {
    let in_plane = matches!(ground.frame(), Frame::Plane(_));
    let by_angles = !in_plane || (table.has(ANGLES[0]) && !matches!(ground.frame(), Frame::Plane(None)));
    let needed = if by_angles { ANGLES } else { METRES };
    for column in needed {
        if !table.has(column) {
            table.refuse_without(column);
        }
    }
    by_angles
}

fn control(row: &mut Row<'_>, ground: &Ground, by_angles: bool, number: usize) -> Option<Control> {
    let reach = -FARTHEST..=FARTHEST;
    let pixel = PIXEL.map(|column| row.number(column, reach.clone()));
    let height = row.optional_number(HEIGHT, -20_000.0..=20_000.0);
    let place = if by_angles {
        let [latitude, longitude] =
            [angle(row, ANGLES[0], Axis::Latitude), angle(row, ANGLES[1], Axis::Longitude)];
        let found = ground.coordinates_of([latitude?, longitude?]);
        if found.is_none() {
            row.refuse_row(
                "a place that the map of the elevation file does not show".into(),
                "a place on it",
            );
        }
        found?
    } else {
        let [east, north] = METRES.map(|column| row.number(column, reach.clone()));
        [north?, east?]
    };
    let height = match height.ok()? {
        Some(height) => height,
        None => match ground.height_between(ground.post_at(place)) {
            Some(height) => height,
            None => {
                let title = "a point without a height where the elevation grid has none".into();
                row.refuse_row(title, "a value in `height_m`");
                return None;
            }
        },
    };
    let name = row.text(NAME).filter(|name| !name.is_empty());
    let name = name.map_or_else(|| number.to_string(), |name| name.into_owned());
    let ground = ground.point_of(place, height)?;
    Some(Control { name, point: ControlPoint { ground, pixel: [pixel[0]?, pixel[1]?] } })
}

/// An angle (rad): degrees as a number like any other of the table, or D:M:S with a hemisphere letter.
fn angle(row: &mut Row<'_>, column: usize, axis: Axis) -> Option<f64> {
    let text = row.text(column)?.into_owned();
    if !text.contains(':') {
        let most = if axis == Axis::Latitude { 90.0 } else { 180.0 };
        return row.number(column, -most..=most).map(radians);
    }
    match parse_angle(&text, axis) {
        Ok(angle) => Some(angle),
        Err(error) => {
            row.refuse_row(error.to_string(), "an angle that cannot be read two ways");
            None
        }
    }
}
