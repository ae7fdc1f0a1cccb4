//! Where a signal goes from one level to another.

use serde::Deserialize;

use super::Deviation;
use crate::scene::machine::{Drawn, MachineCase};

/// Ground ranges at which a signal of the middle sweep passes the middle of its span: in the middle of the step.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ChangesReading {
    /// Name of the signal: a gate, or two levels.
    pub signal: String,
    /// Ground ranges of all its changes, ascending (m).
    pub at_m: Vec<f64>,
}

impl ChangesReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let found = changes(seen, &self.signal, meant.settings.raster.sweeps / 2)?;
        Ok(Deviation::between(&format!("changes of {}", self.signal), &found, &self.at_m, 1.0))
    }
}

/// Ground ranges (m) at which a signal passes the middle of its span: the middle of each such step.
pub(super) fn changes(seen: &Drawn, signal: &str, sweep: u32) -> Result<Vec<f64>, String> {
    let (ranges, values) = (seen.ranges_of(sweep)?, seen.wave(signal, sweep)?);
    let (low, high) = values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| (low.min(value), high.max(value)));
    let middle = 0.5 * (low + high);
    let steps = (1..values.len()).filter(|&k| (values[k - 1] < middle) != (values[k] < middle));
    Ok(steps.map(|k| 0.5 * (ranges[k - 1] + ranges[k])).collect())
}
