//! What is asked for over a scenario.

use std::path::PathBuf;

use hardware_model::Economy;
use scenario::Scalar;

/// Wishes of a command line, a notebook or a page. What is left out is the scenario's, and then the model's.
#[derive(Debug, Clone, Default)]
pub struct Wishes {
    /// Hardware model by name or path, or the name of a generator; the scenario's own if left out.
    pub machine: Option<String>,
    /// Files of differences over the hardware model, the later over the earlier.
    pub overlays: Vec<PathBuf>,
    /// Single keys and their values as TOML, over everything else.
    pub set: Vec<(String, String)>,
    /// Channel of the scenario that is looked through; without it, the vehicle's own camera.
    pub channel: Option<String>,
    /// Ground from this bank instead of the scenario's.
    pub bank: Option<PathBuf>,
    /// Sweeps a frame, 1..=8192.
    pub sweeps: Option<u32>,
    /// Samples a sweep, 2..=65536.
    pub samples: Option<u32>,
    /// Scalar type of the analog signals.
    pub scalar: Option<Scalar>,
    /// What may be left out.
    pub economy: Economy,
    /// Folder in which shadow boundaries are kept from run to run; it changes no picture.
    pub shadow_cache: Option<PathBuf>,
}
