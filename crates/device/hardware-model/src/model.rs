//! A machine as meant: SI and exact rates, complete.

use quantities::Rate;
use scenario::{Laws, RangeProgramme};

use crate::{
    AnalogParts, Cpu, DataBanks, FeatureParts, KindBanks, LevelTurn, Loader, MixingParts, ShadowParts, Yoke,
};

/// What the machine is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct HardwareModel {
    /// Name, as the file says.
    pub name: String,
    /// Raster and its clocks.
    pub raster: ModelRaster,
    /// Ground-range programme of the sweeps.
    pub range: RangeProgramme,
    /// Master clock of the digital processing unit.
    pub master_clock: Rate,
    /// Central processor of the digital side.
    pub cpu: Cpu,
    /// What the processor does about far ground while the vehicle turns.
    pub level_turn: LevelTurn,
    /// Delivery of coefficient words to the registers.
    pub loader: Loader,
    /// Drums and storage buffers of terrain.
    pub data_banks: DataBanks,
    /// Banks of the other kinds of data.
    pub kind_banks: KindBanks,
    /// Seed of part-to-part spread and noise.
    pub seed: u64,
    /// Laws that the machine is wired for.
    pub laws: Laws,
    /// Kind of sweep memory.
    pub sweep_memory: SweepMemoryKind,
    /// Sub-generators of the feature generator and their organisation.
    pub feature_generator: FeatureParts,
    /// Variant and parts of the shadow controller.
    pub shadow_controller: ShadowParts,
    /// Parts of the mixing unit.
    pub mixing_unit: MixingParts,
    /// Deflection yoke of the display.
    pub yoke: Yoke,
    /// Words a second that reach the sub-generators of the feature generator; any number if `None`.
    pub feature_words: Option<f64>,
    /// Words a second that reach the line generators of the shadow controller; any number if `None`.
    pub segment_words: Option<f64>,
    /// Parts of the analog side.
    pub analog: AnalogParts,
}

/// Raster of the model and its clocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelRaster {
    /// Number of sweeps a frame.
    pub sweeps: u32,
    /// Samples drawn in one sweep.
    pub samples: u32,
    /// Share of the sweep period spent in retrace, 0..1; the nearest whole number of steps is used.
    pub blanking_fraction: f64,
    /// Pictures computed a second.
    pub update: Rate,
    /// Pictures shown a second.
    pub refresh: Rate,
}

impl ModelRaster {
    /// Steps of retrace in a sweep.
    pub fn retrace_samples(&self) -> u32 {
        retrace(self.samples, self.blanking_fraction)
    }
}

/// Steps of retrace, nearest to the blanking fraction of the whole sweep.
pub(crate) fn retrace(samples: u32, blanking_fraction: f64) -> u32 {
    (f64::from(samples) * blanking_fraction / (1.0 - blanking_fraction)).round() as u32
}

/// Kind of sweep memory (section 16).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SweepMemoryKind {
    /// Dual-gun storage tube: written along each sweep, read in any raster.
    ScanConverter,
    /// A/D, digital memory, D/A: read in the raster in which it was written.
    DigitalMemory,
}
