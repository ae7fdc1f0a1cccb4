//! Ground that is hidden.

use landscape::LUNOID_RADIUS;
use serde::Deserialize;

use super::Deviation;
use super::signal::worst;
use crate::scene::machine::{Drawn, MachineCase};

/// Ground that the middle column does not show. Of an engine that is read by pixels the near end counts only where ground
/// within the stretch is seen.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HiddenReading {
    /// Ground ranges from which and up to which it is hidden (m).
    pub between_m: [f64; 2],
}

/// The farthest ground seen, in every sweep.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HorizonRangeReading {}

impl HiddenReading {
    /// The widest stretch without seen ground that overlaps the one that is meant: its ends are those of the ground seen on
    /// both sides of it. Without ground on both sides there is none.
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let [from, to] = self.between_m;
        let mut ranges = ranges_seen(meant, seen)?;
        ranges.sort_by(f64::total_cmp);
        let gaps = ranges.windows(2).filter(|pair| pair[0] < to && pair[1] > from);
        let widest = gaps.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        let Some(&[near, far]) = widest else {
            return Ok(Deviation::between("hidden stretches", &[], &[from], 1.0));
        };
        // A line of the picture reaches up to the crest; the range of its pixel lies before it.
        let near = if seen.has_signals() { near } else { near.max(from) };
        Ok(Deviation::between("end of hidden ground", &[near, far], &self.between_m, 1.0))
    }
}

/// Ground ranges seen in the middle column: unblanked samples, or pixels of the range plane.
fn ranges_seen(meant: &MachineCase, seen: &Drawn) -> Result<Vec<f64>, String> {
    let raster = meant.settings.raster;
    let middle = raster.sweeps / 2;
    if seen.has_signals() {
        return unblanked(seen, middle);
    }
    let pixels = seen.ranges.iter().skip(middle as usize).step_by(raster.columns as usize);
    Ok(pixels.map(|&range| f64::from(range)).filter(|range| range.is_finite()).collect())
}

fn unblanked(seen: &Drawn, sweep: u32) -> Result<Vec<f64>, String> {
    let samples = seen.ranges_of(sweep)?.iter().zip(seen.wave("dpp.blank", sweep)?);
    Ok(samples.filter(|(_, blank)| **blank == 0.0).map(|(&range, _)| range).collect())
}

impl HorizonRangeReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let [north, east, eye] = meant.scene.eye_m;
        let [ground, ..] = meant.surface([north, east]);
        let expected = (2.0 * LUNOID_RADIUS * (eye - ground)).sqrt();
        worst(meant.sweeps().map(|sweep| {
            let last = unblanked(seen, sweep)?.into_iter().fold(0.0, f64::max);
            Ok(Deviation::of(format!("farthest ground of sweep {sweep} (m)"), last, expected, expected))
        }))
    }
}
