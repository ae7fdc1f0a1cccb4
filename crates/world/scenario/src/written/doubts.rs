//! What makes a path that can be driven doubtful all the same: told, not refused.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use landscape::Attitude;
use quantities::{degrees, radians};

use crate::Waypoint;
use crate::path::shortest_turn;

/// How far headings may be from the way, on the mean, and still fit it (rad).
const FITS: f64 = 10.0 * PI / 180.0;

/// Share of the way on which a heading must be across for the whole way to be (the rest may be rounding at a halt).
const WHOLE: f64 = 0.98;

/// How headings lie to the way that is driven.
#[derive(Debug, Clone, Copy)]
struct Bearing {
    /// Share of it on which the heading is more than 45 degrees from both directions of the way.
    across: f64,
    /// Mean turn from the way to the heading (rad).
    turn: f64,
}

impl Bearing {
    /// Of headings as `meant` takes them; `None` if the vehicle does not move or has no heading.
    fn of<'w>(
        waypoints: impl Iterator<Item = &'w Waypoint> + Clone,
        meant: impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let (mut length, mut across, mut turn) = (0.0, 0.0, 0.0);
        for (from, to) in waypoints.clone().zip(waypoints.skip(1)) {
            let (Some(first), Some(last)) = (from.heading, to.heading) else { continue };
            let [north, east] = [to.at[0] - from.at[0], to.at[1] - from.at[1]];
            // Half of the leg counts with the heading of each of its ends.
            let half = 0.5 * (north * north + east * east).sqrt();
            for heading in [first, last].map(&meant) {
                let away = shortest_turn(libm::atan2(east, north), heading).abs();
                length += half;
                turn += half * away;
                across += if (FRAC_PI_4..=PI - FRAC_PI_4).contains(&away) { half } else { 0.0 };
            }
        }
        (length > 0.0).then(|| Self { across: across / length, turn: turn / length })
    }
}

/// Says so if headings in degrees look like radians: all of them lie within 2 pi, one is not 0, and they do not fit the way
/// that is driven. Places on the sphere have no way that could be compared.
pub(super) fn radians_named_degrees(waypoints: &[Waypoint], is_of_plane: bool) -> Option<String> {
    let headings: Vec<f64> = waypoints.iter().filter_map(|waypoint| waypoint.heading).collect();
    let is_within = headings.iter().all(|heading| degrees(*heading).abs() <= 2.0 * PI);
    let is_open = headings.iter().all(|heading| *heading == 0.0);
    let fits = is_of_plane
        && Bearing::of(waypoints.iter(), |heading| heading).is_some_and(|bearing| bearing.turn < FITS);
    let is_doubtful = headings.len() > 1 && is_within && !is_open && !fits;
    is_doubtful.then(|| {
        "every heading_deg lies within 2 pi: if they are radians, name the column heading_rad".to_owned()
    })
}

/// Says so if the headings of a column, `heading_deg` or `heading_rad`, fit the way that is driven only in the other unit.
pub fn other_unit(column: &str, waypoints: &[Waypoint]) -> Option<String> {
    let (other, in_other): (_, fn(f64) -> f64) = match column {
        "heading_deg" => ("heading_rad", degrees),
        "heading_rad" => ("heading_deg", radians),
        _ => return None,
    };
    let own = Bearing::of(waypoints.iter(), |heading| heading)?;
    let other_way = Bearing::of(waypoints.iter(), in_other)?;
    (own.turn >= FITS && other_way.turn < FITS).then(|| {
        format!(
            "headings fit the way that is driven only if they are those of a column {other}, not {column}"
        )
    })
}

/// Says so if a path rolls the vehicle, although nothing turns the picture with it.
pub(super) fn hidden_roll(waypoints: &[Waypoint]) -> Option<String> {
    let rolls = waypoints.iter().any(|waypoint| waypoint.roll.is_some_and(|roll| roll != 0.0));
    rolls.then(|| {
        "roll_deg turns no picture, since the scenario does not say how roll is shown; `[roll] display = \"yoke\"` turns \
         pictures with the vehicle, and \"none\" keeps them upright without this note"
            .into()
    })
}

/// Says so if a vehicle turns much further between two rows than from the one to the other: each of its angles goes the shortest way, and
/// near straight up or down that is no short way around.
pub(super) fn turns_by_angles(waypoints: &[Waypoint]) -> Option<String> {
    const STEPS: u32 = 8;
    const SMALL: f64 = 10.0 * PI / 180.0;
    let far = waypoints.windows(2).find(|pair| {
        let ends = [0, 1].map(|end| attitude(&pair[end]));
        let [Some(from), Some(to)] = ends else { return false };
        let turn = [
            shortest_turn(from.heading, to.heading),
            shortest_turn(from.pitch, to.pitch),
            shortest_turn(from.roll, to.roll),
        ];
        if turn.iter().all(|turn| turn.abs() < SMALL) {
            return false;
        }
        let at = |step: u32| {
            let share = f64::from(step) / f64::from(STEPS);
            let [heading, pitch, roll] = turn.map(|turn| share * turn);
            Attitude { heading: from.heading + heading, pitch: from.pitch + pitch, roll: from.roll + roll }
        };
        let way: f64 = (0..STEPS).map(|step| between(at(step), at(step + 1))).sum();
        way > 2.0 * between(from, to) + SMALL
    })?;
    Some(format!(
        "from {} to {} s heading, pitch and roll go their own shortest ways, and the camera turns more than twice as far as it must; give more \
         rows there",
        far[0].time, far[1].time
    ))
}

/// Attitude of a waypoint that states all of it.
fn attitude(waypoint: &Waypoint) -> Option<Attitude> {
    let Waypoint { heading, pitch, roll, .. } = *waypoint;
    Some(Attitude { heading: heading?, pitch: pitch?, roll: roll? })
}

/// Angle of the turn from one attitude to another (rad).
fn between(from: Attitude, to: Attitude) -> f64 {
    let (from, to) = (from.to_terrain().to_cols_array(), to.to_terrain().to_cols_array());
    let trace: f64 = from.iter().zip(to).map(|(a, b)| a * b).sum();
    libm::acos((0.5 * (trace - 1.0)).clamp(-1.0, 1.0))
}

/// Says so if the headings of a path lie across its way from its beginning to its end.
pub(super) fn heading_across(waypoints: &[Waypoint]) -> Option<String> {
    let bearing = Bearing::of(waypoints.iter(), |heading| heading)?;
    let other = Bearing::of(waypoints.iter(), |heading| FRAC_PI_2 - heading)?;
    if bearing.turn > FRAC_PI_4 && other.turn < FITS {
        return Some(
            "headings fit the way only with x (north) and y (east) exchanged, or if they count from east, \
             anticlockwise; headings count clockwise from north"
                .into(),
        );
    }
    (bearing.across >= WHOLE).then(|| {
        format!(
            "the vehicle looks across its way for the whole drive, {:.0} degrees away from it on the mean; headings count \
             clockwise from north",
            degrees(bearing.turn)
        )
    })
}

#[cfg(test)]
mod tests {
    use quantities::radians;

    use super::turns_by_angles;
    use crate::Waypoint;

    fn told(attitudes: [[f64; 3]; 2]) -> Option<String> {
        let row = |time: f64, [heading, pitch, roll]: [f64; 3]| Waypoint {
            time,
            at: [0.0; 2],
            heading: Some(radians(heading)),
            eye_height: Some(100.0),
            pitch: Some(radians(pitch)),
            roll: Some(radians(roll)),
        };
        turns_by_angles(&[row(0.0, attitudes[0]), row(8.0, attitudes[1])])
    }

    /// 20 degrees over the nadir: heading and roll go half around.
    #[test]
    fn a_way_over_the_nadir_is_told() {
        let said = told([[0.0, -80.0, 0.0], [180.0, -80.0, 180.0]]).unwrap();
        assert!(said.starts_with("from 0 to 8 s"), "{said}");
        assert_eq!(told([[0.0, -90.0, 0.0], [90.0, -90.0, 0.0]]), None);
        assert_eq!(told([[350.0, 10.0, -5.0], [40.0, -30.0, 60.0]]), None);
        assert_eq!(told([[0.0, 0.0, 170.0], [0.0, 0.0, -170.0]]), None);
    }
}
