//! The deviates that noise is made of: two parts of two machines that differ in their seed.

use hardware_model::HardwareModel;
use parts::NoiseSource;
use serde::Deserialize;

use super::within;
use crate::hardware::Hardware;

/// Noise of two parts, as `amplifier.noise_mv` and `spread.seed` have it. Signals are shares of full scale.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct NoiseScene {
    /// Names of the two parts.
    pub parts: [String; 2],
    /// Number of sweeps that are drawn.
    pub sweeps: u64,
    /// Number of samples per sweep.
    pub samples: u64,
    /// The figures of the part.
    pub hardware: Hardware,
}

/// Noise under one hardware model.
#[derive(Debug, Clone)]
pub struct NoiseCase {
    pub scene: NoiseScene,
    pub model: HardwareModel,
}

/// Noise of each part, sweep after sweep; that of the first part drawn again backwards; and of another seed.
#[derive(Debug, Clone)]
pub struct Deviates {
    pub parts: [Vec<f64>; 2],
    pub again: Vec<f64>,
    pub other_seed: Vec<f64>,
    /// Number of samples per sweep.
    pub samples: usize,
}

impl NoiseScene {
    pub(super) fn cases(&self) -> Result<Vec<NoiseCase>, String> {
        within("sweeps", self.sweeps as f64, 1.0, 1e4)?;
        within("samples", self.samples as f64, 4.0, 1e5)?;
        within("sweeps x samples", (self.sweeps * self.samples) as f64, 100.0, 1e7)?;
        let case = |model| NoiseCase { scene: self.clone(), model };
        Ok(self.hardware.load()?.into_iter().map(case).collect())
    }
}

impl NoiseCase {
    pub(super) fn run(&self) -> Deviates {
        let NoiseScene { parts, sweeps, samples, .. } = &self.scene;
        let sigma = self.model.analog.amplifier.noise / self.model.analog.full_scale;
        let drawn = |seed: u64, part: &str, backwards: bool| -> Vec<f64> {
            let source = NoiseSource::new(seed, part, 0);
            let total = sweeps * samples;
            let at = |index: u64| sigma * source.normal(index / samples, index % samples);
            match backwards {
                false => (0..total).map(at).collect(),
                true => {
                    let mut values: Vec<f64> = (0..total).rev().map(at).collect();
                    values.reverse();
                    values
                }
            }
        };
        let seed = self.model.seed;
        Deviates {
            parts: [0, 1].map(|part| drawn(seed, &parts[part], false)),
            again: drawn(seed, &parts[0], true),
            other_seed: drawn(seed.wrapping_add(1), &parts[0], false),
            samples: *samples as usize,
        }
    }
}
