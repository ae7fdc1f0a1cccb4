//! A machine as meant: SI and exact rates, complete.

use quantities::Rate;
use scenario::{Laws, RangeProgramme};
use sweep_program::{Colour, PreloadRegister};

use crate::{FeatureParts, MixingParts, ShadowParts, Yoke};

/// What the machine is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct HardwareModel {
    /// Name, as the file says.
    pub name: String,
    /// Raster and its clocks.
    pub raster: ModelRaster,
    /// Ground-range programme.
    pub range: RangeProgramme,
    /// Master clock of the digital processing unit.
    pub master_clock: Rate,
    /// Delivery of coefficient words to the registers.
    pub loader: Loader,
    /// Laws that the machine is wired for.
    pub laws: Laws,
    /// Kind of sweep memory.
    pub sweep_memory: SweepMemoryKind,
    /// Feature generator.
    pub feature_generator: FeatureParts,
    /// Shadow controller.
    pub shadow_controller: ShadowParts,
    /// Mixing unit.
    pub mixing_unit: MixingParts,
    /// Deflection yoke.
    pub yoke: Yoke,
}

/// Raster of the model and its clocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelRaster {
    /// Sweeps a frame.
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

/// The path of coefficient words from storage buffer to register (section 6.3; hardware section 4.4).
#[derive(Debug, Clone, PartialEq)]
pub struct Loader {
    /// Master ticks from a fold to the arrival of the words that it asks for.
    pub access_ticks: u64,
    /// What happens to words that come after the transfer they were meant for.
    pub late_policy: LatePolicy,
    /// Single words held back on purpose, to see what a fault does.
    pub delays: Vec<LoadDelay>,
}

/// What happens to words that miss their fold (hardware section 4.5).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LatePolicy {
    /// They go to the hold register as they arrive, word by word.
    StrobeThrough,
    /// The hold register keeps the stale words until the colour is transferred again.
    Latched,
}

/// One word held back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LoadDelay {
    /// Frame, or every frame.
    pub frame: Option<u64>,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// The fold that asks for the word, counted from 0 in the sweep; folds of both axes count.
    pub crossing: u32,
    /// Colour register that waits for the word.
    pub colour: Colour,
    /// Preload register of that colour.
    pub register: PreloadRegister,
    /// Word, `3 p + q`, 0..=8.
    pub word: usize,
    /// Master ticks it comes later.
    pub ticks: u64,
}

/// Kind of sweep memory (section 16).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SweepMemoryKind {
    /// Dual-gun storage tube: written along each sweep, read in any raster.
    ScanConverter,
    /// A/D, digital memory, D/A: read in the raster in which it was written.
    DigitalMemory,
}
