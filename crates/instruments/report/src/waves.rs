//! Values of recorded sweeps, for the scope of the page.

use serde::{Deserialize, Serialize};

/// Waveforms of one recorded sweep, as the scope of the page draws them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweepWaves {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// From one sample to the next (µs).
    pub sample_us: f64,
    /// Name of the signal that says the place of each sample.
    pub place: String,
    /// Place of each sample (m).
    pub places: Vec<f32>,
    /// The signals that the plot shows, in its order.
    pub signals: Vec<Wave>,
}

/// One signal of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Wave {
    /// Name in the signal table.
    pub name: String,
    /// Symbol of the unit; `1` for a number.
    pub unit: String,
    /// Kind of the signal: `analog`, or a digital one.
    pub kind: String,
    /// Instants of the values (samples); empty for a signal with a value a sample.
    pub times: Vec<f32>,
    /// Its values; none where the value is no number.
    pub values: Vec<Option<f32>>,
}

impl SweepWaves {
    /// Number of values: what decides how much of a page they take.
    pub(crate) fn size(&self) -> usize {
        self.places.len()
            + self.signals.iter().map(|wave| wave.times.len() + wave.values.len()).sum::<usize>()
    }
}
