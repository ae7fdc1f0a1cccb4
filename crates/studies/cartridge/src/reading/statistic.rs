//! Numbers that say how a signal errs.

use serde::Deserialize;

use super::Deviation;
use super::signal::pair;
use crate::formula::along::Along;
use crate::scene::machine::{Drawn, MachineCase};

/// A number of the error of a signal, that is, of the signal less a formula.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct StatisticReading {
    /// Name of the signal.
    pub signal: String,
    /// What it should be.
    pub formula: Along,
    /// The number that is read from the errors.
    pub statistic: Statistic,
    /// What it should be.
    pub value: f64,
    /// Ground ranges that are looked at, from and to (m); all if it is missing.
    pub between_m: Option<[f64; 2]>,
}

/// A number of a list of errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Statistic {
    /// Mean of the errors.
    Mean,
    /// Root of the mean square.
    Rms,
    /// Root of the mean square of what is left without the mean.
    Deviation,
    /// Largest error, by size.
    Largest,
    /// Correlation of neighbours, -1 to 1.
    NeighbourCorrelation,
}

impl Statistic {
    /// Its word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Mean => "mean",
            Self::Rms => "rms",
            Self::Deviation => "deviation",
            Self::Largest => "largest",
            Self::NeighbourCorrelation => "neighbour-correlation",
        }
    }

    /// The number; NaN of nothing.
    pub fn of(self, errors: &[f64]) -> f64 {
        let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / errors.len() as f64;
        match self {
            Self::Mean => mean(&mut errors.iter().copied()),
            Self::Rms => mean(&mut errors.iter().map(|error| error * error)).sqrt(),
            Self::Deviation => {
                let middle = Self::Mean.of(errors);
                mean(&mut errors.iter().map(|error| (error - middle) * (error - middle))).sqrt()
            }
            Self::Largest => errors.iter().fold(0.0, |largest: f64, error| largest.max(error.abs())),
            Self::NeighbourCorrelation => {
                let product: f64 = errors.windows(2).map(|pair| pair[0] * pair[1]).sum();
                product / errors.iter().map(|error| error * error).sum::<f64>()
            }
        }
    }
}

impl StatisticReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let mut errors = Vec::new();
        for sweep in meant.sweeps() {
            let [found, right] = pair(meant, seen, &self.signal, &self.formula, sweep, self.between_m)?;
            errors.extend(found.iter().zip(right).map(|(found, right)| found - right));
        }
        let what = format!("{} error of {}", self.statistic.word(), self.signal);
        Ok(Deviation::of(what, self.statistic.of(&errors), self.value, 1.0))
    }
}
