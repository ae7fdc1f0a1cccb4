//! A path as a line: points along the way, and how far things are from it.

use std::collections::{BTreeMap, BTreeSet};

use crate::path::{Station, shortest_turn};
use crate::{HeightOver, Path, SceneryProblem};

/// An instant of a ride.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Instant {
    /// Seconds since the start of the mission.
    pub time: f64,
    /// Place of the vehicle: north, east (m).
    pub at: [f64; 2],
    /// Clockwise from north (rad).
    pub heading: f64,
    /// Height of the eye (m), where the path says it.
    pub eye_height: Option<f64>,
    /// What that height counts from.
    pub height_over: HeightOver,
}

/// Most instants of one ride.
const MAX_INSTANTS: usize = 4_000_000;

/// Instants along a path, at most about `spacing` (m) and 3 degrees of heading apart; ends and waypoints are among
/// them.
///
/// # Errors
/// If there would be millions.
pub(crate) fn instants(path: &Path, spacing: f64) -> Result<Vec<Instant>, SceneryProblem> {
    let at = |time: f64| {
        let station = path.at(time);
        let Station { at, heading, eye_height, height_over, .. } = station;
        Instant { time, at, heading, eye_height, height_over }
    };
    let mut found = vec![at(path.waypoints()[0].time)];
    for pair in path.waypoints().windows(2) {
        let (from, to) = (pair[0].time, pair[1].time);
        let steps = steps_between(&at(from), &at(to), spacing);
        if steps > MAX_INSTANTS - found.len() {
            return Err(SceneryProblem::LongPath { spacing });
        }
        found.extend((1..=steps).map(|step| at(from + (to - from) * step as f64 / steps as f64)));
    }
    Ok(found)
}

/// Steps of one span: its cubic is at most three times as fast as its chord on the mean, on either axis (Steffen).
fn steps_between(from: &Instant, to: &Instant, spacing: f64) -> usize {
    const FASTEST: f64 = 3.0;
    const TURN: f64 = 0.05;
    let along = FASTEST * distance(from.at, to.at) / spacing;
    let turn = FASTEST * shortest_turn(from.heading, to.heading).abs() / TURN;
    // A long span may bend more in between than at its ends.
    let least = if along > FASTEST { 8.0 } else { 1.0 };
    along.max(turn).max(least).ceil() as usize
}

/// Distance between two places (m).
pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [north, east] = [a[0] - b[0], a[1] - b[1]];
    (north * north + east * east).sqrt()
}

/// Stretches of a ride by where they are: which of them come near a place.
pub(crate) struct Lane {
    cell: f64,
    points: BTreeMap<[i64; 2], Vec<[f64; 2]>>,
}

impl Lane {
    /// The line of points that are at most a fraction of `reach` (m) apart; [`Self::distance`] is right up to `reach`.
    pub fn new(points: impl Iterator<Item = [f64; 2]>, reach: f64) -> Self {
        let mut lane = Self { cell: reach, points: BTreeMap::new() };
        for point in points {
            lane.points.entry(lane.key(point)).or_default().push(point);
        }
        lane
    }

    fn key(&self, place: [f64; 2]) -> [i64; 2] {
        place.map(|part| (part / self.cell).floor() as i64)
    }

    /// Distance (m) from a place to the nearest point, if it is within reach.
    pub fn distance(&self, place: [f64; 2]) -> Option<f64> {
        let [north, east] = self.key(place);
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [north + i, east + j]));
        let points = around.filter_map(|key| self.points.get(&key)).flatten();
        points.map(|&point| distance(point, place)).filter(|&found| found <= self.cell).reduce(f64::min)
    }

    /// Squares of side `reach` that hold all places within reach, as corners (low, high; m), each once.
    pub fn squares(&self) -> Vec<[[f64; 2]; 2]> {
        let around = |[north, east]: [i64; 2]| {
            (-1..=1).flat_map(move |i| (-1..=1).map(move |j| [north + i, east + j]))
        };
        let keys: BTreeSet<[i64; 2]> = self.points.keys().copied().flat_map(around).collect();
        let corner = |key: [i64; 2]| key.map(|index| index as f64 * self.cell);
        keys.into_iter().map(|key| [corner(key), corner(key.map(|index| index + 1))]).collect()
    }
}
