//! The way of a mission: waypoints, and where the vehicle is in between.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use quantities::wrap_heading;

use crate::curve::Curve;

/// One instant of a path. What is left open follows from travel (heading) and from the ground (the rest).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waypoint {
    /// Seconds since the start of the mission.
    pub time: f64,
    /// Place of the vehicle: north, east (m).
    pub at: [f64; 2],
    /// Clockwise from north (rad); the direction of travel if open.
    pub heading: Option<f64>,
    /// Height of the eye (m) above what the path counts from, see [`HeightOver`].
    pub eye_height: Option<f64>,
    /// Pitch, positive with the nose up (rad).
    pub pitch: Option<f64>,
    /// Roll, positive with starboard down (rad).
    pub roll: Option<f64>,
}

/// What heights of a path count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HeightOver {
    /// The lunoid's tangent plane, to which the heights of the bank refer.
    #[default]
    Datum,
    /// The ground under the place.
    Ground,
}

impl HeightOver {
    /// The height above the tangent plane (m) of something that is `height` above this, where the ground is at `ground`.
    pub(crate) fn above(self, height: f64, ground: f64) -> f64 {
        match self {
            Self::Datum => height,
            Self::Ground => ground + height,
        }
    }
}

/// Where the path is at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Place of the vehicle: north, east (m).
    pub at: [f64; 2],
    /// Velocity over the ground: north, east (m/s).
    pub velocity: [f64; 2],
    /// Clockwise from north, in `[0, 2 pi)` (rad).
    pub heading: f64,
    /// Height of the eye (m) above what the path counts from, where the path says it.
    pub eye_height: Option<f64>,
    /// What that height counts from.
    pub height_over: HeightOver,
    /// Rate of change of the eye height (m/s), where the path gives the height.
    pub climb: Option<f64>,
    /// Nose up (rad), where the path says it.
    pub pitch: Option<f64>,
    /// Starboard down (rad), where the path says it.
    pub roll: Option<f64>,
}

/// Waypoints joined by smooth curves in time; before the first and after the last the vehicle stands.
///
/// Position is C1 and never overshoots a waypoint. Between two waypoints without heading the vehicle looks along
/// its travel; between others the heading turns smoothly, the shortest way around, a waypoint without heading
/// counting with its direction of travel.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    name: String,
    waypoints: Vec<Waypoint>,
    position: [Curve; 2],
    heading: Curve,
    /// For each span, the span whose direction the vehicle has in it; nothing if it never moves.
    moving: Vec<usize>,
    height_over: HeightOver,
    eye_height: Option<Curve>,
    pitch: Option<Curve>,
    roll: Option<Curve>,
    /// Whether the rolls of all waypoints do, so that one beyond it is a way around.
    rolls_within_half_a_turn: bool,
}

/// Why waypoints are no path; `index` counts from 0.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PathError {
    /// No waypoint at all.
    #[error("a path without waypoints: expected at least one")]
    Empty,
    /// A number is NaN or infinite.
    #[error("waypoint {index}: expected finite numbers")]
    NotFinite {
        /// Index of the waypoint, from 0.
        index: usize,
    },
    /// Time does not rise.
    #[error("waypoint {index}: t = {time} s after {before} s; expected ascending times")]
    Time {
        /// Index of the waypoint, from 0.
        index: usize,
        /// Time of that waypoint (s).
        time: f64,
        /// Time of the one before (s).
        before: f64,
    },
    /// Two times are so near to each other that speeds between them are no numbers.
    #[error(
        "waypoint {index}: t = {time} s is {} s after the waypoint before; expected at least {LEAST_STEP} s between two times",
        time - before
    )]
    Near {
        /// Index of the waypoint, from 0.
        index: usize,
        /// Time of that waypoint (s).
        time: f64,
        /// Time of the one before (s).
        before: f64,
    },
    /// Height, pitch or roll is given for some waypoints only.
    #[error("{what} is given for some waypoints only; expected for all or for none")]
    Partly {
        /// Name of the quantity that is missing for some waypoints.
        what: &'static str,
    },
}

impl Path {
    /// The path of `waypoints`, in order of time. It is called `the path`.
    ///
    /// # Errors
    /// As [`PathError`] says.
    pub fn new(waypoints: Vec<Waypoint>) -> Result<Self, PathError> {
        check(&waypoints)?;
        let times: Arc<[f64]> = waypoints.iter().map(|w| w.time).collect();
        let curve = |values: Vec<f64>| Curve::new(times.clone(), values);
        let whole = |values: Option<Vec<f64>>| values.map(curve);
        let position = [0, 1].map(|axis| curve(waypoints.iter().map(|w| w.at[axis]).collect()));
        let moving = moving(&waypoints);
        let headings = headings(&waypoints, &position, &moving);
        Ok(Self {
            name: "the path".into(),
            eye_height: whole(all(&waypoints, "z_m", |w| w.eye_height)?),
            pitch: whole(all(&waypoints, "pitch_deg", |w| w.pitch)?.map(unwrapped)),
            roll: whole(all(&waypoints, "roll_deg", |w| w.roll)?.map(unwrapped)),
            heading: curve(headings),
            rolls_within_half_a_turn: waypoints.iter().all(|w| w.roll.is_none_or(|roll| roll.abs() <= PI)),
            height_over: HeightOver::Datum,
            moving,
            position,
            waypoints,
        })
    }

    /// The same under the name of the file that says it.
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// The same with heights of the eye that count from `over`.
    pub fn with_heights_over(self, over: HeightOver) -> Self {
        Self { height_over: over, ..self }
    }

    /// What its heights count from.
    pub fn height_over(&self) -> HeightOver {
        self.height_over
    }

    /// What it is called where it cannot be driven.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The waypoints, in order of time.
    pub fn waypoints(&self) -> &[Waypoint] {
        &self.waypoints
    }

    /// Whether a waypoint lies at `time` (s), as closely as a file has it.
    pub(crate) fn has_waypoint_at(&self, time: f64) -> bool {
        const NEAR: f64 = 1e-6;
        let next = self.waypoints.partition_point(|waypoint| waypoint.time < time - NEAR);
        self.waypoints.get(next).is_some_and(|waypoint| waypoint.time <= time + NEAR)
    }

    /// Where the path is at `time` (s).
    pub fn at(&self, time: f64) -> Station {
        let value = |curve: &Option<Curve>| curve.as_ref().map(|curve| curve.at(time));
        Station {
            at: self.position.each_ref().map(|curve| curve.at(time)),
            velocity: self.position.each_ref().map(|curve| curve.rate(time)),
            heading: self.heading_at(time),
            eye_height: value(&self.eye_height),
            height_over: self.height_over,
            climb: self.eye_height.as_ref().map(|curve| curve.rate(time)),
            pitch: value(&self.pitch),
            roll: value(&self.roll).map(|roll| self.rolled(roll)),
        }
    }

    /// A roll between two that lie within half a turn: the way around leads over its end.
    fn rolled(&self, roll: f64) -> f64 {
        if roll.abs() > PI && self.rolls_within_half_a_turn { roll - TAU.copysign(roll) } else { roll }
    }

    /// Heading, pitch and roll (rad) of a path that states them at `time` (s), with the whole turns that they have made.
    pub(crate) fn turned(&self, time: f64) -> [f64; 3] {
        let stated = |curve: &Option<Curve>| curve.as_ref().map_or(0.0, |curve| curve.at(time));
        [self.heading.at(time), stated(&self.pitch), stated(&self.roll)]
    }

    fn heading_at(&self, time: f64) -> f64 {
        let along_travel = |index: usize| {
            self.waypoints[index].heading.is_none() && self.waypoints[index + 1].heading.is_none()
        };
        let heading = match self.heading.locate(time) {
            Some((index, ..)) if along_travel(index) => {
                travel(&self.waypoints, &self.position, &self.moving, index, time)
            }
            _ => self.heading.at(time),
        };
        wrap_heading(heading)
    }
}

fn check(waypoints: &[Waypoint]) -> Result<(), PathError> {
    if waypoints.is_empty() {
        return Err(PathError::Empty);
    }
    for (index, w) in waypoints.iter().enumerate() {
        let open = [w.heading, w.eye_height, w.pitch, w.roll];
        let mut numbers = [w.time, w.at[0], w.at[1]].into_iter().chain(open.into_iter().flatten());
        if !numbers.all(f64::is_finite) {
            return Err(PathError::NotFinite { index });
        }
    }
    for (pair, index) in waypoints.windows(2).zip(1..) {
        let (time, before) = (pair[1].time, pair[0].time);
        if time <= before {
            return Err(PathError::Time { index, time, before });
        }
        // As near as the rounding of decimal times allows.
        if time - before < LEAST_STEP * (1.0 - ROUNDING) {
            return Err(PathError::Near { index, time, before });
        }
    }
    Ok(())
}

/// Least time from one waypoint to the next (s): what a clock in seconds since 1970 can just tell apart.
const LEAST_STEP: f64 = 1e-6;
/// Share of it by which two such times may be off.
const ROUNDING: f64 = 0.25;

/// The values of a quantity that is given for all waypoints or for none.
fn all(
    waypoints: &[Waypoint],
    what: &'static str,
    value: impl Fn(&Waypoint) -> Option<f64>,
) -> Result<Option<Vec<f64>>, PathError> {
    let values: Vec<f64> = waypoints.iter().filter_map(value).collect();
    match values.len() {
        0 => Ok(None),
        n if n == waypoints.len() => Ok(Some(values)),
        _ => Err(PathError::Partly { what }),
    }
}

/// The same directions, each within half a turn of the one before.
fn unwrapped(mut angles: Vec<f64>) -> Vec<f64> {
    for i in 1..angles.len() {
        angles[i] = angles[i - 1] + shortest_turn(angles[i - 1], angles[i]);
    }
    angles
}

/// The shortest way around from one direction to another, in `[-pi, pi)` (rad).
pub(crate) fn shortest_turn(from: f64, to: f64) -> f64 {
    wrap_heading(to - from + PI) - PI
}

fn headings(waypoints: &[Waypoint], position: &[Curve; 2], moving: &[usize]) -> Vec<f64> {
    let last_span = waypoints.len().saturating_sub(2);
    let heading = |(index, w): (usize, &Waypoint)| {
        w.heading.unwrap_or_else(|| travel(waypoints, position, moving, index.min(last_span), w.time))
    };
    unwrapped(waypoints.iter().enumerate().map(heading).collect())
}

/// For each span between two waypoints, the span whose direction the vehicle has in it: itself if it moves there, else the
/// last before in which it moved, else the first in which it will. Empty if it never moves.
fn moving(waypoints: &[Waypoint]) -> Vec<usize> {
    let moves = |pair: &[Waypoint]| pair[0].at != pair[1].at;
    let Some(first) = waypoints.windows(2).position(moves) else { return Vec::new() };
    let follow = |last: &mut usize, (span, pair): (usize, &[Waypoint])| {
        *last = if moves(pair) { span } else { *last };
        Some(*last)
    };
    waypoints.windows(2).enumerate().scan(first, follow).collect()
}

/// Direction of travel (rad) at `time` in the span from waypoint `index`; north if the vehicle never moves.
fn travel(waypoints: &[Waypoint], position: &[Curve; 2], moving: &[usize], index: usize, time: f64) -> f64 {
    let Some(&span) = moving.get(index) else { return 0.0 };
    let (from, to) = (waypoints[span].time, waypoints[span + 1].time);
    let time = time.clamp(from, to);
    direction(position, time).unwrap_or_else(|| {
        // A vehicle that starts or stops here has no direction at this very instant, but has just beside it.
        let inwards = if time - from < to - time { 1e-3 } else { -1e-3 };
        direction(position, time + inwards * (to - from)).unwrap_or(0.0)
    })
}

fn direction(position: &[Curve; 2], time: f64) -> Option<f64> {
    let [north, east] = position.each_ref().map(|curve| curve.rate(time));
    // Slower than this is rounding.
    const STANDING: f64 = 1e-9;
    (north * north + east * east > STANDING * STANDING).then(|| libm::atan2(east, north))
}
