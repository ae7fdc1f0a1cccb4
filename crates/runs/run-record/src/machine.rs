//! Settings of the hybrid machine, as its runs have them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Everything that decides a picture of the hybrid machine beside ground, light, view and pose.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MachineRecord {
    /// Scalar type of the analog signals: "f32" or "f64".
    pub scalar: String,
    /// Sweeps and their samples.
    pub raster: SweepRecord,
    /// Clocks.
    pub clocks: ClockRecord,
    /// Ground-range programme by key.
    pub range: BTreeMap<String, Value>,
    /// Central processor, times in ticks of the master clock.
    pub cpu_ticks: Value,
    /// Delivery of coefficient words.
    pub loader: Value,
    /// Drums and storage buffers, times in ticks of the master clock.
    pub data_banks_ticks: Value,
    /// The analog side in SI units.
    pub analog_si: Value,
    /// Seed of part-to-part spread and noise.
    pub seed: u64,
    /// Kind of sweep memory.
    pub sweep_memory: String,
    /// Parts of the blocks beside the terrain path; a number that is not there is "any".
    pub blocks: Value,
    /// What may be left out.
    pub economy: String,
}

/// Sweeps of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct SweepRecord {
    /// Sweeps a frame.
    pub sweeps: u32,
    /// Samples drawn in one sweep.
    pub samples_per_sweep: u32,
}

impl SweepRecord {
    /// Sweeps and samples as plain counts.
    pub fn counts(&self) -> [u64; 2] {
        [self.sweeps, self.samples_per_sweep].map(u64::from)
    }
}

/// Clocks, rates as `10000000 Hz`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClockRecord {
    /// Master clock of the digital side.
    pub master: String,
    /// Samples a second.
    pub sample: String,
    /// Samples that are drawn in one sweep.
    pub active_samples: u32,
    /// Samples of retrace in one sweep.
    pub retrace_samples: u32,
}
