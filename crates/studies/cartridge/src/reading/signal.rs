//! A signal at every sample, or at some.

use serde::Deserialize;

use super::Deviation;
use crate::formula::along::Along;
use crate::scene::machine::{Drawn, MachineCase};

/// A signal against a formula.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SignalReading {
    /// Name of the signal.
    pub signal: String,
    /// What it should be.
    pub formula: Along,
    /// Ground ranges that are compared, from and to (m); all if it is missing.
    pub between_m: Option<[f64; 2]>,
}

/// A signal at some ground ranges, each of which is a sample.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SamplesReading {
    /// Name of the signal.
    pub signal: String,
    /// Ground ranges that are looked at (m).
    pub at_m: Vec<f64>,
    /// Values of the signal there, in its unit.
    pub values: Vec<f64>,
}

impl SignalReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let sweeps = meant.sweeps().map(|sweep| {
            let [found, expected] = pair(meant, seen, &self.signal, &self.formula, sweep, self.between_m)?;
            let largest = expected.iter().fold(f64::MIN_POSITIVE, |largest, value| value.abs().max(largest));
            let scale = self.formula.full_scale(meant).unwrap_or(largest);
            Ok(Deviation::between(&format!("{} of sweep {sweep}", self.signal), &found, &expected, scale))
        });
        worst(sweeps)
    }
}

/// A signal of a sweep within some ground ranges, and what a formula has in its place.
pub(super) fn pair(
    meant: &MachineCase,
    seen: &Drawn,
    signal: &str,
    formula: &Along,
    sweep: u32,
    between: Option<[f64; 2]>,
) -> Result<[Vec<f64>; 2], String> {
    let direction = meant.direction(sweep).ok_or("no fan covers the pitch")?;
    let [from, to] = between.unwrap_or([0.0, f64::INFINITY]);
    let samples = seen.ranges_of(sweep)?.iter().zip(seen.wave(signal, sweep)?);
    let inside = samples.filter(|(range, _)| (from..=to).contains(*range));
    let values = inside.map(|(&range, &found)| (found, formula.at(meant, range, direction)));
    let (found, expected): (Vec<f64>, Vec<f64>) = values.unzip();
    Ok([found, expected])
}

/// The worst of several sweeps.
pub(super) fn worst(sweeps: impl Iterator<Item = Result<Deviation, String>>) -> Result<Deviation, String> {
    let all: Vec<Deviation> = sweeps.collect::<Result<_, _>>()?;
    all.into_iter().reduce(Deviation::worse).ok_or("the frame has no sweeps".into())
}

impl SamplesReading {
    pub(super) fn deviation(&self, seen: &Drawn) -> Result<Deviation, String> {
        let (ranges, values) = (seen.ranges_of(0)?, seen.wave(&self.signal, 0)?);
        let sample = |&at: &f64| {
            let index = ranges.iter().position(|range| (range - at).abs() < 1e-9 * at);
            index.map(|index| values[index]).ok_or(format!("{}: no sample is at {at} m", self.signal))
        };
        let found: Result<Vec<f64>, String> = self.at_m.iter().map(sample).collect();
        Ok(Deviation::between(&self.signal, &found?, &self.values, 1.0))
    }
}
