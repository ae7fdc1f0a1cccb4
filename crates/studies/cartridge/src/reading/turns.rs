//! Where a ramp turns.

use serde::Deserialize;

use super::Deviation;
use crate::scene::machine::Drawn;

/// Turns of a ramp of sweep 0: found from the straight pieces around each, or told by the stops that find its folds. The answer is a list
/// of ground ranges, or the turns of another ramp.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TurnsReading {
    /// Name of the ramp, or of its folds: `sweep.fold.x`.
    pub signal: String,
    /// Ground ranges of all its turns, ascending (m).
    #[serde(default)]
    pub at_m: Vec<f64>,
    /// Name of the ramp at whose turns they are, in place of ground ranges.
    #[serde(default)]
    pub at_turns_of: Option<String>,
}

impl TurnsReading {
    pub(super) fn deviation(&self, seen: &Drawn) -> Result<Deviation, String> {
        let right = match (&self.at_turns_of, &self.at_m[..]) {
            (Some(ramp), []) => turns_of(seen, ramp)?,
            (None, [_, ..]) => self.at_m.clone(),
            _ => return Err("turns: expected either at_m or at_turns_of".into()),
        };
        let found = turns_of(seen, &self.signal)?;
        Ok(Deviation::between(&format!("turns of {}", self.signal), &found, &right, 1.0))
    }

    /// The signals that it looks at.
    pub(super) fn signals(&self) -> impl Iterator<Item = &str> {
        [Some(&self.signal), self.at_turns_of.as_ref()].into_iter().flatten().map(String::as_str)
    }
}

/// Ground ranges of the turns of a ramp, or of the folds that a stop tells (m).
fn turns_of(seen: &Drawn, signal: &str) -> Result<Vec<f64>, String> {
    let ranges = seen.ranges_of(0)?;
    Ok(match seen.instants(signal, 0)? {
        [] => turns(ranges, seen.wave(signal, 0)?),
        instants => instants.iter().filter_map(|&instant| range_at(ranges, instant)).collect(),
    })
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
