//! Hardware model files, and the settings of a run.
//!
//! A [`HardwareModel`] says what parts the machine is made of and how good they are; [`Settings`] is what a run
//! comes to when command line, scenario and model have had their say, in that order of precedence.

mod model;
mod settings;

pub use model::{HardwareModel, LatePolicy, LoadDelay, Loader, ModelRaster, SweepMemoryKind};
pub use settings::{Raster, Settings, SettingsError};
