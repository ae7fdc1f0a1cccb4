//! What a sweep is made from.

use hardware_model::Settings;
use landscape::{Landscape, Level, Sun};
use scenario::Pose;

/// A frame: ground, light, pose and the numbers of the run.
#[derive(Debug, Clone, Copy)]
pub struct SceneData<'a> {
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
    /// Pitch, positive with the nose up (rad).
    pub pitch: f64,
    /// Number of the frame.
    pub frame: u64,
    /// Where the eye is in every frame of the mission: what its drums go by. Empty where nobody asks.
    pub course: &'a [Pose],
}

impl SceneData<'_> {
    /// Returns the finest level of the terrain.
    pub(crate) fn fine(&self) -> &Level {
        self.landscape.level()
    }

    /// The coarse level, where the scenario switches to one.
    pub(crate) fn coarse(&self) -> Option<&Level> {
        self.settings.levels.and(self.landscape.bank().levels().get(1))
    }
}
