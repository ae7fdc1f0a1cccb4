//! The reflectivity stage: its light comes later than the height (hardware 3.4).

use super::series::LagMap;
use crate::scene::SceneData;

/// The stage along a sweep, at rest under its first input.
#[derive(Debug, Clone, Copy)]
pub struct ReflectivityStage {
    lag: LagMap,
    /// Input and output at the sample before.
    last: Option<[f64; 2]>,
}

impl ReflectivityStage {
    /// The stage of a scene's model.
    pub fn of(scene: &SceneData<'_>) -> Self {
        let settings = scene.settings;
        let tau = settings.analog.reflectivity.delay_mismatch;
        Self { lag: LagMap::of(1.0 / settings.timebase.sample_rate().hertz(), tau), last: None }
    }

    /// The output at the next sample.
    pub fn next(&mut self, input: f64) -> f64 {
        let [before, output] = self.last.unwrap_or([input; 2]);
        let output = self.lag.step(output, [before, input]);
        self.last = Some([input, output]);
        output
    }
}
