//! One line in the spectrum of an error.

use std::f64::consts::PI;

use serde::Deserialize;

use super::Deviation;
use super::signal::{pair, worst};
use crate::formula::along::Along;
use crate::scene::machine::{Drawn, MachineCase};

/// Amplitude of one wave, by place to the north, in the error of a signal, over the whole waves of each sweep.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FourierLineReading {
    /// Name of the signal.
    pub signal: String,
    /// What it should be.
    pub formula: Along,
    /// Length of the wave to the north (m).
    pub wavelength_m: f64,
    /// Amplitude, in the signal's unit.
    pub amplitude: f64,
}

impl FourierLineReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        worst(meant.sweeps().map(|sweep| {
            let [found, right] = pair(meant, seen, &self.signal, &self.formula, sweep, None)?;
            let north = meant.direction(sweep).ok_or("no fan covers the pitch")?[0];
            let turns: Vec<f64> = seen
                .ranges_of(sweep)?
                .iter()
                .map(|range| (meant.scene.eye_m[0] + range * north) / self.wavelength_m)
                .collect();
            let amplitude = amplitude(&turns, found.iter().zip(&right).map(|(found, right)| found - right));
            let what = format!("line of {} m in {} of sweep {sweep}", self.wavelength_m, self.signal);
            Ok(Deviation::of(what, amplitude, self.amplitude, 1.0))
        }))
    }
}

/// A sample so little before the end of the last whole turn (turns) is the first of the next.
const ROUNDING: f64 = 1e-9;

/// Amplitude of the wave of one turn, over the whole turns from the first sample on; each sample counts for its share of
/// the way.
fn amplitude(turns: &[f64], errors: impl Iterator<Item = f64>) -> f64 {
    let [first, last] = [turns.first(), turns.last()].map(|turn| turn.copied().unwrap_or(0.0));
    let whole = (last - first).abs().floor();
    let inside = turns.iter().zip(errors).filter(|(turn, _)| (*turn - first).abs() < whole - ROUNDING);
    let (mut cosine, mut sine, mut count) = (0.0, 0.0, 0.0);
    for (turn, error) in inside {
        let (sin, cos) = libm::sincos(2.0 * PI * turn);
        (cosine, sine, count) = (cosine + error * cos, sine + error * sin, count + 1.0);
    }
    2.0 * libm::hypot(cosine, sine) / count
}
