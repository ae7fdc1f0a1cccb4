//! What a part makes of its input.

use serde::Deserialize;

use super::Deviation;
use super::statistic::Statistic;
use crate::formula::response::{Peak, response, settling};
use crate::scene::part::{Input, Output, PartCase};

/// Output at every step.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct OutputReading {}

/// The largest output, behind a fold of the input.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PeakReading {
    /// What is asked of it.
    pub peak: Peak,
}

/// When the output is and stays within an error of a step.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SettlingReading {
    /// Share of full scale.
    pub error: f64,
}

/// Trips of a comparator.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TripsReading {
    /// Times of all trips from the start (ns).
    pub at_ns: Vec<f64>,
}

/// A number of output less input.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct OutputErrorReading {
    /// The number that is read from the errors.
    pub statistic: Statistic,
    /// What it should be (shares of full scale).
    pub value: f64,
}

impl OutputReading {
    pub(super) fn deviation(&self, meant: &PartCase, seen: &Output) -> Result<Deviation, String> {
        let expected: Vec<f64> = seen.times.iter().map(|&time| response(meant, time)).collect();
        Ok(Deviation::between("output after step", &seen.output, &expected, 1.0))
    }
}

impl PeakReading {
    pub(super) fn deviation(&self, meant: &PartCase, seen: &Output) -> Result<Deviation, String> {
        let Input::Fold { per_us, fold_us } = meant.scene.input else {
            return Err("peak: expected an input of the kind fold".into());
        };
        let outputs = seen.times.iter().zip(&seen.output);
        let (time, top) = outputs.fold((0.0, 0.0), |best, (&t, &y)| if y > best.1 { (t, y) } else { best });
        let late_us = 1e6 * meant.tau() * std::f64::consts::LN_2;
        Ok(match self.peak {
            Peak::ShortBy => {
                Deviation::of("peak below the fold", per_us * fold_us - top, per_us * late_us, 1.0)
            }
            Peak::LateBy => Deviation::of("peak behind the fold (µs)", 1e6 * time - fold_us, late_us, 1.0),
        })
    }
}

impl SettlingReading {
    pub(super) fn deviation(&self, meant: &PartCase, seen: &Output) -> Result<Deviation, String> {
        let Input::Step { to } = meant.scene.input else {
            return Err("settling: expected an input of the kind step".into());
        };
        let off = |k: usize| (seen.output[k] - to).abs();
        let last = (0..seen.output.len()).rev().find(|&k| off(k) > self.error);
        // Between the last step that is off by more and the next, off by less: a straight line.
        let inside = last.filter(|&last| last + 1 < seen.output.len());
        let found = inside.map_or(f64::INFINITY, |k| {
            let share = (off(k) - self.error) / (off(k) - off(k + 1));
            seen.times[k] + share * (seen.times[k + 1] - seen.times[k])
        });
        Ok(Deviation::of("settling (ns)", 1e9 * found, 1e9 * settling(meant, to, self.error), 1.0))
    }
}

impl TripsReading {
    pub(super) fn deviation(&self, seen: &Output) -> Result<Deviation, String> {
        let found: Vec<f64> = seen.trips.iter().map(|time| 1e9 * time).collect();
        Ok(Deviation::between("trip (ns)", &found, &self.at_ns, 1.0))
    }
}

impl OutputErrorReading {
    pub(super) fn deviation(&self, seen: &Output) -> Result<Deviation, String> {
        let errors: Vec<f64> = seen.output.iter().zip(&seen.input).map(|(y, u)| y - u).collect();
        let what = format!("{} error of output", self.statistic.word());
        Ok(Deviation::of(what, self.statistic.of(&errors), self.value, 1.0))
    }
}
