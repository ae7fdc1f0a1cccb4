//! What makes a path that can be driven doubtful all the same: told, not refused.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

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
