//! By how much edges across the heading are displaced, below one sample.

use quantities::sin_cos;
use serde::Deserialize;

use super::Deviation;
use super::changes::changes;
use crate::scene::machine::{Drawn, MachineCase};

/// Mean way by which the changes of a signal lie behind straight edges across the heading, over all edges of all sweeps. Each
/// change is known to a step; the sweeps of a fan meet an edge at any phase of their samples, so the mean of many is known to
/// a part of a step.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct EdgeShiftReading {
    /// Name of the signal: a gate, or two levels.
    pub signal: String,
    /// Distances ahead at which the edges lie, ascending (m).
    pub ahead_m: Vec<f64>,
    /// Ground range by which they are displaced outwards (m).
    pub shift_m: f64,
}

impl EdgeShiftReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let (sin, cos) = sin_cos(meant.heading);
        let (mut sum, mut count) = (0.0, 0.0);
        for sweep in meant.sweeps() {
            let [north, east] = meant.direction(sweep).ok_or("no fan covers the pitch")?;
            let found = changes(seen, &self.signal, sweep)?;
            if found.len() != self.ahead_m.len() {
                let what = format!("changes of {} in sweep {sweep}", self.signal);
                return Ok(Deviation::between(&what, &found, &self.ahead_m, 1.0));
            }
            let behind = |(found, ahead): (&f64, &f64)| found - ahead / (north * cos + east * sin);
            sum += found.iter().zip(&self.ahead_m).map(behind).sum::<f64>();
            count += found.len() as f64;
        }
        Ok(Deviation::of(format!("mean shift of {}", self.signal), sum / count, self.shift_m, 1.0))
    }
}
