//! What a sweep is made from.

use hardware_model::{LevelTurn, Settings};
use landscape::{Landscape, Level, Sun};
use scenario::{LevelSwitch, Pose};

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

    /// Where frame `frame` goes over to the coarse level, and how, if its heading is `heading` (rad). While that turns fast it is nearer by
    /// the model's share.
    pub(crate) fn switch(&self, frame: u64, heading: f64) -> Option<LevelSwitch> {
        let LevelSwitch { range, blend } = self.settings.levels?;
        let before = self.course.get(frame.saturating_sub(1) as usize);
        let turn = before.map_or(0.0, |before| {
            libm::remainder(heading - before.attitude.heading, 2.0 * std::f64::consts::PI)
        });
        let LevelTurn { rate, share } = self.settings.level_turn;
        // The processor sees a billionth less as the limit.
        let is_fast = turn.abs() * self.settings.timebase.update.hertz() >= rate * (1.0 - 1e-9);
        let share = if is_fast { share } else { 1.0 };
        Some(LevelSwitch { range: share * range, blend: share * blend })
    }

    /// The coarse level, where the scenario switches to one.
    pub(crate) fn coarse(&self) -> Option<&Level> {
        self.settings.levels.and(self.landscape.bank().levels().get(1))
    }
}
