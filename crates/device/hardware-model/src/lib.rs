//! Hardware model files, and the settings of a run.
//!
//! A [`HardwareModel`] says what parts the machine is made of and how good they are; [`Settings`] is what a run
//! comes to when command line, scenario and model have had their say, in that order of precedence.
//!
//! - [`ModelSource::find`]: from a name or a path to the model meant.
//! - [`HardwareModel::read`]: a model over its bases, under overlays and single settings, as a [`LoadedModel`]
//!   that knows where each value came from. The format is described in `docs/hardware-model-format.md`.
//! - [`HardwareModel::budget`]: what the clocks allow over a [`GroundScale`]; [`HardwareModel::check`]: what cannot hold
//!   together, and what will show; [`PartCounts`]: the block diagram.

mod analog;
mod budget;
mod check;
mod diagram;
mod digital;
mod faults;
mod layering;
mod loaded;
mod model;
mod parts;
mod record;
mod settings;
mod sides;
mod source;
mod written;

pub use analog::{
    AmplifierParts, AnalogParts, BlendWeight, CROSSTALK_FREQUENCY, ComparatorParts, FEEDTHROUGH_FREQUENCY,
    FeatureChainParts, FoldDetect, FunctionGeneratorParts, LevelBlendParts, LoopParts, MAIN_WIRES,
    MemoryParts, MultiplierParts, MultiplyingDacParts, PictureTubeParts, ProjectionParts, ReflectivityParts,
    SMOOTHER_DAMPING, SampleHoldParts, ShadowLineParts, SweepParts, TextureParts, VideoSwitchParts,
    WireParts, WriteCompensation,
};
pub use budget::{
    Budget, BudgetLine, CpuBudget, CrossingBudget, DrumBudget, GroundScale, LoaderBudget, SweepBudget,
};
pub use check::{Finding, Grade};
pub use diagram::{BLOCK_TABLES, PartCounts};
pub use digital::{
    BankPlace, Channels, Cpu, CrossingServer, DataBanks, Drum, DrumQueue, IoProcessor, KindBank, KindBanks,
    LatePolicy, LoadDelay, Loader,
};
pub use faults::{FAULTS, prediction, proof};
pub use loaded::{EffectiveValue, LoadedModel};
pub use model::{HardwareModel, ModelRaster, SweepMemoryKind};
pub use parts::{Economy, FeatureParts, Forced, Gate, LevelTurn, MixingParts, Organisation, ShadowParts};
pub use record::MachineRecord;
pub use scenario::{LevelSwitch, ShadowFineness, Yoke};
pub use settings::{Raster, Settings, SettingsError, ShadowCache};
pub use sides::Side;
pub use source::{Asked, BUILT_IN, ModelSource};
pub use written::FORMAT;
