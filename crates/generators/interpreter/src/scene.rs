//! What a sweep is made from.

use hardware_model::Settings;
use landscape::{Landscape, Level, Sun};
use scenario::Pose;

use crate::frame::Frame;
use crate::shadows::ShadowLine;

/// A frame: ground, light, pose and the numbers of the run.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// Words, craters, texture, law of reflection.
    pub landscape: &'a Landscape,
    /// Raster, clocks, range programme, laws, loader.
    pub settings: &'a Settings,
    /// The light of the frame.
    pub sun: Sun,
    /// Eye: north, east, height (m).
    pub eye: [f64; 3],
    /// Clockwise from north (rad).
    pub heading: f64,
    /// Nose up (rad).
    pub pitch: f64,
    /// Number of the frame.
    pub frame: u64,
    /// Where the eye is in every frame of the mission: what its drums go by. Empty where nobody asks.
    pub course: &'a [Pose],
}

/// What the interpreter does not work out and takes as the machine has it.
#[derive(Debug, Clone, Copy)]
pub struct Given<'a> {
    /// Ground range of each sample (m).
    pub ranges: &'a [f64],
    /// The digital side of the frame.
    pub frame: &'a Frame,
    /// Numbers in 0..1 that a seed draws, each by three words.
    pub draw: fn(u64, [u64; 3]) -> f64,
    /// Lines of shadow on the ground; empty where there is none.
    pub lines: &'a [ShadowLine],
    /// Gate of remote shadow at each sample, 0 or 1; empty where there is no shadow.
    pub shadow: &'a [f64],
    /// Full scale of each main wire in its unit: what its slew rate is against.
    pub full_scales: &'a [(&'static str, f64)],
}

impl Scene<'_> {
    /// The finest level.
    pub(crate) fn fine(&self) -> &Level {
        self.landscape.level()
    }

    /// The coarse level, where the scenario switches to one.
    pub(crate) fn coarse(&self) -> Option<&Level> {
        self.settings.levels.and(self.landscape.bank().levels().get(1))
    }
}
