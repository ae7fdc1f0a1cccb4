//! What noise is like.

use serde::Deserialize;

use super::Deviation;
use super::statistic::Statistic;
use crate::scene::noise::Deviates;

/// A number of noise.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct NoiseReading {
    /// The number that is read from the noise.
    pub measure: Measure,
    /// What it should be.
    pub value: f64,
}

/// A number of noise, of the first part unless another is named.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Mean (shares of full scale).
    Mean,
    /// Mean square (shares of full scale, squared).
    Variance,
    /// Mean fourth power over the square of the mean square: 3 for normal deviates.
    Kurtosis,
    /// Largest correlation of samples 1 to 16 apart, by size.
    Correlation,
    /// Correlation of sweeps, sample by sample, each with the next, by size.
    SweepCorrelation,
    /// Correlation with the second part, by size.
    PartCorrelation,
    /// Correlation with the first part of the next seed, by size.
    SeedCorrelation,
    /// Samples that are not the same when they are drawn again in the opposite order.
    Differing,
}

/// Lags over which correlation is looked for.
const LAGS: usize = 16;

impl Measure {
    /// Its word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Mean => "mean",
            Self::Variance => "variance",
            Self::Kurtosis => "kurtosis",
            Self::Correlation => "correlation",
            Self::SweepCorrelation => "sweep-correlation",
            Self::PartCorrelation => "part-correlation",
            Self::SeedCorrelation => "seed-correlation",
            Self::Differing => "differing",
        }
    }

    fn of(self, seen: &Deviates) -> f64 {
        let noise = &seen.parts[0];
        let moment =
            |power: fn(f64) -> f64| noise.iter().map(|&x| power(x)).sum::<f64>() / noise.len() as f64;
        let square = moment(|x| x * x);
        match self {
            Self::Mean => Statistic::Mean.of(noise),
            Self::Variance => square,
            Self::Kurtosis => moment(|x| x * x * x * x) / (square * square),
            Self::Correlation => {
                (1..=LAGS).map(|lag| correlation(noise, noise.get(lag..).unwrap_or(&[]))).fold(0.0, f64::max)
            }
            Self::SweepCorrelation => correlation(noise, noise.get(seen.samples..).unwrap_or(&[])),
            Self::PartCorrelation => correlation(noise, &seen.parts[1]),
            Self::SeedCorrelation => correlation(noise, &seen.other_seed),
            Self::Differing => {
                noise.iter().zip(&seen.again).filter(|(a, b)| a.to_bits() != b.to_bits()).count() as f64
            }
        }
    }
}

/// Size of the correlation of two lists, as far as both go.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let (mut product, mut squares) = (0.0, [0.0; 2]);
    for (a, b) in a.iter().zip(b) {
        product += a * b;
        squares = [squares[0] + a * a, squares[1] + b * b];
    }
    (product / (squares[0] * squares[1]).sqrt()).abs()
}

impl NoiseReading {
    pub(super) fn deviation(&self, seen: &Deviates) -> Result<Deviation, String> {
        Ok(Deviation::of(format!("{} of noise", self.measure.word()), self.measure.of(seen), self.value, 1.0))
    }
}
