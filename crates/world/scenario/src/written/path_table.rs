//! Paths as tables: CSV with a header, and the format of the TUM benchmarks.
//!
//! TUM files have rows of `t tx ty tz qx qy qz qw`. Their world is the report's terrain frame (section 4): x north, y east,
//! z down, metres. The place is that of the eye. Their times count from the first row, since recorders write seconds since
//! 1970.

use std::f64::consts::PI;
use std::path::Path as FilePath;

use diagnostics::{Placed, Problems};
use quantities::radians;
use tables::{Clock, Column, Faulty, Form, Row, Table, read_text};

use super::coordinates::Coordinates;
use super::doubts::{other_unit, radians_named_degrees};
use super::points::{PlacedWaypoint, Points};
use super::quaternion;
use super::scenery::MAX_COORDINATE;
use crate::{HeightOver, Waypoint};

const T: usize = 0;
const X: usize = 1;
const Y: usize = 2;
const LATITUDE: usize = 3;
const LONGITUDE: usize = 4;
const Z: usize = 5;
const HEIGHT: usize = 6;
const HEADING: usize = 7;
const PITCH: usize = 8;
const ROLL: usize = 9;
const QUATERNION: [usize; 4] = [10, 11, 12, 13];

/// Degrees of a radian.
const DEGREES: f64 = 180.0 / PI;

/// The columns of a path with a header.
const CSV: Form = Form {
    what: "path file",
    columns: &[
        Column::needed("t_s").also(&[("t_ms", 1e-3), ("t_us", 1e-6), ("t_ns", 1e-9), ("t_utc", 1.0)]),
        Column::optional("x_m").also(&[("northing_m", 1.0)]),
        Column::optional("y_m").also(&[("easting_m", 1.0)]),
        Column::optional("lat_deg").also(&[("lat_rad", DEGREES)]),
        Column::optional("lon_deg").also(&[("lon_rad", DEGREES)]),
        Column::optional("z_m").also(&[("altitude_m", 1.0)]),
        Column::optional("height_m"),
        Column::optional("heading_deg").also(&[("heading_rad", DEGREES)]),
        Column::optional("pitch_deg").also(&[("pitch_rad", DEGREES)]),
        Column::optional("roll_deg").also(&[("roll_rad", DEGREES)]),
        Column::optional("qx"),
        Column::optional("qy"),
        Column::optional("qz"),
        Column::optional("qw"),
    ],
    // Columns of the `poses.csv` of a run that follow from the others.
    harmless: &["frame", "speed_m_s", "turn_deg_s", "slope_deg"],
};

/// The columns of a path of the TUM benchmarks, in their order.
const TUM: Form = Form {
    what: "path file",
    columns: &[
        Column::needed("t").also(&[("timestamp", 1.0)]),
        Column::needed("tx"),
        Column::needed("ty"),
        Column::needed("tz"),
        Column::needed("qx"),
        Column::needed("qy"),
        Column::needed("qz"),
        Column::needed("qw"),
    ],
    harmless: &[],
};

/// Headings beyond a hundred turns are a mistake (degrees).
const MOST_HEADING: f64 = 36_000.0;

/// The rows of a CSV file.
pub(super) fn csv(path: &FilePath, wished: Option<Coordinates>, problems: &Problems) -> Option<Points> {
    let mut table = Table::with_header(read_text(path, problems)?, &CSV);
    let coordinates = coordinates(&mut table, wished);
    check_columns(&mut table);
    let height_over = if table.has(HEIGHT) { HeightOver::Ground } else { HeightOver::Datum };
    let heading = table.name(HEADING);
    let (mut clock, mut waypoints) = (Clock::from_zero(), Vec::new());
    while let Some(mut row) = table.next_row() {
        waypoints.extend(csv_row(&mut row, coordinates, &mut clock));
    }
    let name = path.display().to_string();
    let waypoints = table.finish(waypoints, problems)?;
    let doubt = heading.and_then(|column| unit_of_headings(column, &waypoints, coordinates));
    clock.note().into_iter().chain(doubt).for_each(|note| problems.note(format!("{name}: {note}")));
    Some(Points { waypoints, coordinates, height_over })
}

/// What makes the unit doubtful that the column of headings names.
fn unit_of_headings(column: &str, placed: &[PlacedWaypoint], coordinates: Coordinates) -> Option<String> {
    let is_of_plane = coordinates != Coordinates::LonLat;
    let waypoints: Vec<Waypoint> = placed.iter().map(|waypoint| waypoint.value).collect();
    match column {
        "heading_deg" => radians_named_degrees(&waypoints, is_of_plane),
        _ if is_of_plane => other_unit(column, &waypoints),
        _ => None,
    }
}

/// What the columns say of the coordinates; a fault if they do not say what was wished.
fn coordinates(table: &mut Table, wished: Option<Coordinates>) -> Coordinates {
    let on_sphere = [LATITUDE, LONGITUDE].iter().any(|column| table.has(*column));
    let in_plane = [X, Y].iter().any(|column| table.has(*column));
    let found = wished.unwrap_or(match on_sphere && !in_plane {
        true => Coordinates::LonLat,
        false => Coordinates::Bank,
    });
    let (needed, others) = match found {
        Coordinates::LonLat => ([LATITUDE, LONGITUDE], in_plane),
        Coordinates::Bank | Coordinates::File => ([X, Y], on_sphere),
    };
    if others {
        let expected = format!("columns for `path.coordinates = \"{}\"` alone", found.word());
        table.refuse_header("columns of other coordinates".into(), &expected);
    } else {
        let missing: Vec<usize> = needed.into_iter().filter(|column| !table.has(*column)).collect();
        missing.into_iter().for_each(|column| table.refuse_without(column));
    }
    found
}

/// Columns that say the same must not stand side by side, and a quaternion has four.
fn check_columns(table: &mut Table) {
    if let (Some(datum), Some(ground)) = (table.name(Z), table.name(HEIGHT)) {
        table.refuse_header(
            format!("`{datum}` and `{ground}` both say how high the eye is"),
            "one of the two",
        );
    }
    let parts = QUATERNION.iter().filter(|column| table.has(**column)).count();
    let has_angles = [HEADING, PITCH, ROLL].iter().any(|column| table.has(*column));
    if parts > 0 && has_angles {
        table.refuse_header("a quaternion and angles both say the attitude".into(), "one of the two");
    } else if parts > 0 && parts < QUATERNION.len() {
        table.refuse_header("a quaternion of fewer than four columns".into(), "qx, qy, qz and qw");
    }
}

fn csv_row(row: &mut Row, coordinates: Coordinates, clock: &mut Clock) -> Option<PlacedWaypoint> {
    let time = row.time(T, clock);
    let most = MAX_COORDINATE;
    let at = match coordinates {
        Coordinates::LonLat => [row.number(LATITUDE, -90.0..=90.0), row.number(LONGITUDE, -360.0..=360.0)]
            .map(|angle| angle.map(radians)),
        in_plane => {
            let far = farthest(in_plane);
            [row.number(X, -far..=far), row.number(Y, -far..=far)]
        }
    };
    let height = match (row.optional_number(Z, -most..=most), row.optional_number(HEIGHT, 0.0..=most)) {
        (Ok(over_datum), Ok(over_ground)) => Ok(over_datum.or(over_ground)),
        _ => Err(Faulty),
    };
    let angles =
        if row.has(QUATERNION[0]) { turned(row, QUATERNION)?.map(Some) } else { angles(row).ok()? };
    let ([x, y], [heading, pitch, roll]) = (at, angles);
    let waypoint = Waypoint { time: time?, at: [x?, y?], heading, eye_height: height.ok()?, pitch, roll };
    Some(Placed { value: waypoint, place: row.place(T), key: CSV.columns[T].name.into() })
}

/// Largest place in a plane (m): maps count from far away.
pub(super) fn farthest(coordinates: Coordinates) -> f64 {
    if coordinates == Coordinates::File { 1e9 } else { MAX_COORDINATE }
}

/// Heading, pitch and roll (rad), where the row gives them.
fn angles(row: &mut Row) -> Result<[Option<f64>; 3], Faulty> {
    let mut angle = |column: usize, most: f64| row.optional_number(column, -most..=most);
    let angles = [angle(HEADING, MOST_HEADING), angle(PITCH, 360.0), angle(ROLL, 360.0)];
    let [heading, pitch, roll] = angles;
    Ok([heading?, pitch?, roll?].map(|angle| angle.map(radians)))
}

/// Heading, pitch and roll (rad) of the quaternion in these columns.
fn turned(row: &mut Row, columns: [usize; 4]) -> Option<[f64; 3]> {
    let parts = columns.map(|column| row.number(column, -2.0..=2.0));
    let [x, y, z, w] = parts;
    let found = quaternion::angles([x?, y?, z?, w?]);
    found
        .map_err(|length| {
            let expected = "length 1: qx qy qz qw, scalar last";
            row.refuse_row(format!("a quaternion of length {length}"), expected);
        })
        .ok()
}

/// The rows of a file of the TUM benchmarks.
pub(super) fn tum(path: &FilePath, wished: Option<Coordinates>, problems: &Problems) -> Option<Points> {
    let mut table = Table::in_order(read_text(path, problems)?, &TUM);
    let coordinates = wished.unwrap_or(Coordinates::Bank);
    let (mut clock, mut waypoints) = (Clock::from_first_row(), Vec::new());
    while let Some(mut row) = table.next_row() {
        waypoints.extend(tum_row(&mut row, coordinates, &mut clock));
    }
    let waypoints = table.finish(waypoints, problems)?;
    clock.note().into_iter().for_each(|note| problems.note(format!("{}: {note}", path.display())));
    Some(Points { waypoints, coordinates, height_over: HeightOver::Datum })
}

fn tum_row(row: &mut Row, coordinates: Coordinates, clock: &mut Clock) -> Option<PlacedWaypoint> {
    let time = row.time(0, clock);
    let far = farthest(coordinates);
    let [north, east] = [1, 2].map(|column| row.number(column, -far..=far));
    let down = row.number(3, -MAX_COORDINATE..=MAX_COORDINATE);
    let [heading, pitch, roll] = turned(row, [4, 5, 6, 7])?.map(Some);
    let eye_height = Some(-down?);
    let waypoint = Waypoint { time: time?, at: [north?, east?], heading, eye_height, pitch, roll };
    Some(Placed { value: waypoint, place: row.place(0), key: TUM.columns[0].name.into() })
}
