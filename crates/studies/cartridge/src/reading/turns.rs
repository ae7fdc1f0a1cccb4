//! Where a ramp turns.

use serde::Deserialize;

use super::Deviation;
use crate::scene::machine::Drawn;

/// Turns of a ramp of sweep 0: found from the straight pieces around each, or told by the folds of its accumulator.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TurnsReading {
    /// Name of the ramp, or of its folds: `sweep.fold.x`.
    pub signal: String,
    /// Ground ranges of all its turns, ascending (m).
    pub at_m: Vec<f64>,
}

impl TurnsReading {
    pub(super) fn deviation(&self, seen: &Drawn) -> Result<Deviation, String> {
        let (ranges, instants) = (seen.ranges_of(0)?, seen.instants(&self.signal, 0)?);
        let found = match instants {
            [] => turns(ranges, seen.wave(&self.signal, 0)?),
            _ => instants.iter().filter_map(|&instant| range_at(ranges, instant)).collect(),
        };
        Ok(Deviation::between(&format!("turns of {}", self.signal), &found, &self.at_m, 1.0))
    }
}

/// Ground range at an instant between samples (m); none before the first and behind the last.
fn range_at(ranges: &[f64], instant: f64) -> Option<f64> {
    let (near, share) = (instant.floor(), instant.rem_euclid(1.0));
    let pair = (near >= 0.0).then(|| ranges.get(near as usize..near as usize + 2)).flatten()?;
    Some(pair[0] + share * (pair[1] - pair[0]))
}

/// Where the straight pieces on both sides of a turn meet: they have one speed and opposite signs, and at most one
/// step between them is broken.
fn turns(ranges: &[f64], ramp: &[f64]) -> Vec<f64> {
    let slope = |k: usize| (ramp[k + 1] - ramp[k]) / (ranges[k + 1] - ranges[k]);
    let mut found: Vec<f64> = Vec::new();
    for k in 1..ramp.len().saturating_sub(2) {
        let (before, after) = (slope(k - 1), slope(k + 1));
        let is_turn = before != 0.0 && (before + after).abs() <= 1e-6 * before.abs();
        if !is_turn {
            continue;
        }
        let turn = (ramp[k + 1] - ramp[k] - after * ranges[k + 1] + before * ranges[k]) / (before - after);
        // A turn that falls on a sample has no broken step and is found from both sides.
        if found.last().is_none_or(|last| turn - last > 1e-6 * turn) {
            found.push(turn);
        }
    }
    found
}
