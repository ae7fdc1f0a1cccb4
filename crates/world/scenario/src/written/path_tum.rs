//! Paths in the format of the TUM benchmarks: `t tx ty tz qx qy qz qw`, blanks between, `#` comments.
//!
//! The world is the report's terrain frame (section 4): x north, y east, z down, metres. The quaternion, scalar
//! last, turns vehicle axes (forward, starboard, down) into terrain axes: `v_terrain = q v_vehicle q*`. The place
//! is that of the eye. Times count from the first row, since recorders write seconds since 1970.

use diagnostics::{Placed, Problems};

use super::course::{MAX_TIME, PlacedWaypoint};
use super::number_table::{Cell, NumberTable, lines};
use super::scenery::MAX_COORDINATE;
use crate::Waypoint;

const COLUMNS: [&str; 8] = ["t", "tx", "ty", "tz", "qx", "qy", "qz", "qw"];
/// Largest numbers in them, either way.
const MOST: [f64; COLUMNS.len()] =
    [MAX_TIME, MAX_COORDINATE, MAX_COORDINATE, MAX_COORDINATE, 2.0, 2.0, 2.0, 2.0];
/// How far the length of a quaternion may be from 1: recorders write a few digits.
const LENGTH_TOLERANCE: f64 = 1e-2;

/// The rows of a path file.
pub(super) fn waypoints(name: &str, text: &str, problems: &Problems) -> Option<Vec<PlacedWaypoint>> {
    let mut table = NumberTable::new(name, text, problems);
    let mut rows = lines(text).peekable();
    if rows.peek().is_none() {
        table.fault(&(0..0), "a path file without rows".into(), "rows of t tx ty tz qx qy qz qw");
    }
    let mut waypoints: Vec<PlacedWaypoint> = rows.filter_map(|row| waypoint(&mut table, &row)).collect();
    let start = waypoints.first().map_or(0.0, |first| first.value.time);
    for waypoint in &mut waypoints {
        waypoint.value.time -= start;
    }
    table.finish(waypoints)
}

fn waypoint(table: &mut NumberTable, row: &[Cell]) -> Option<PlacedWaypoint> {
    let line = row[0].span.start..row[row.len() - 1].span.end;
    if row.len() != COLUMNS.len() {
        let title = format!("a row of {} numbers", row.len());
        table.fault(&line, title, "the 8 numbers t tx ty tz qx qy qz qw");
        return None;
    }
    let columns = row.iter().zip(COLUMNS.iter().zip(MOST));
    let numbers: Vec<_> = columns.map(|(cell, (name, most))| table.number(cell, name, most)).collect();
    let numbers: Vec<f64> = numbers.into_iter().collect::<Option<_>>()?;
    let [time, north, east, down, quaternion @ ..]: [f64; 8] = numbers.try_into().ok()?;
    let length = quaternion.iter().map(|part| part * part).sum::<f64>().sqrt();
    if (length - 1.0).abs() > LENGTH_TOLERANCE {
        table.fault(&line, format!("a quaternion of length {length}"), "length 1: qx qy qz qw, scalar last");
        return None;
    }
    let [heading, pitch, roll] = angles(quaternion.map(|part| part / length)).map(Some);
    let waypoint = Waypoint { time, at: [north, east], heading, eye_height: Some(-down), pitch, roll };
    Some(Placed { value: waypoint, place: table.place(&row[0].span), key: COLUMNS[0].into() })
}

/// Heading, pitch, roll (rad) of a unit quaternion, from the elements of `R = Phi Theta Psi`.
fn angles([x, y, z, w]: [f64; 4]) -> [f64; 3] {
    let heading = libm::atan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z));
    let pitch = libm::asin((2.0 * (w * y - x * z)).clamp(-1.0, 1.0));
    let roll = libm::atan2(2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y));
    [heading, pitch, roll]
}

#[cfg(test)]
mod tests {
    use super::angles;
    use landscape::Attitude;
    use quantities::{degrees, radians};

    /// Matrix of a unit quaternion, vehicle to terrain, by the textbook formula for `q v q*`.
    fn matrix([x, y, z, w]: [f64; 4]) -> [[f64; 3]; 3] {
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    }

    #[test]
    fn quarter_turns() {
        let half = 0.5f64.sqrt();
        let quarter = radians(90.0);
        assert!((angles([0.0, 0.0, half, half])[0] - quarter).abs() < 1e-12, "a turn to starboard");
        assert!((angles([half, 0.0, 0.0, half])[2] - quarter).abs() < 1e-12, "starboard down");
        let up = angles([0.0, libm::sin(radians(15.0)), 0.0, libm::cos(radians(15.0))]);
        assert!((up[1] - radians(30.0)).abs() < 1e-12, "nose up");
    }

    /// The conversion that `docs/scenario-format.md` gives for east-north-up worlds.
    #[test]
    fn east_north_up_is_converted() {
        let converted = |[x, y, z, w]: [f64; 4]| {
            angles([x + y, x - y, w - z, w + z].map(|part| part * 0.5f64.sqrt())).map(degrees)
        };
        let (sin, cos) = (libm::sin(radians(10.0)), libm::cos(radians(10.0)));
        // Along x, east; 20 degrees to port; 20 degrees nose up, about minus port; 20 degrees starboard down.
        let cases = [
            ([0.0, 0.0, 0.0, 1.0], [90.0, 0.0, 0.0]),
            ([0.0, 0.0, sin, cos], [70.0, 0.0, 0.0]),
            ([0.0, -sin, 0.0, cos], [90.0, 20.0, 0.0]),
            ([sin, 0.0, 0.0, cos], [90.0, 0.0, 20.0]),
        ];
        for (quaternion, expected) in cases {
            let found = converted(quaternion);
            assert!((0..3).all(|i| (found[i] - expected[i]).abs() < 1e-9), "{found:?} {expected:?}");
        }
    }

    #[test]
    fn the_matrix_is_that_of_section_4() {
        let parts = [0.1, -0.25, 0.4, 0.8];
        let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
        let quaternion = parts.map(|part| part / length);
        let [heading, pitch, roll] = angles(quaternion);
        let ours = Attitude { roll, pitch, heading }.to_terrain();
        for (i, row) in matrix(quaternion).iter().enumerate() {
            for (j, expected) in row.iter().enumerate() {
                assert!((ours.col(j)[i] - expected).abs() < 1e-12, "R[{i}][{j}]");
            }
        }
    }
}
