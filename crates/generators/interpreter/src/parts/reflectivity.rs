//! What is left of the light's delay against the height (hardware 3.4).

use super::series::LagMap;
use crate::given::straight;
use crate::scene::SceneData;

/// The stage along a sweep, at rest under its first input.
#[derive(Debug, Clone, Copy)]
pub struct ReflectivityStage {
    lag: LagMap,
    follows_at_once: bool,
    /// Input and output at the sample before.
    last: Option<[f64; 2]>,
}

impl ReflectivityStage {
    /// The stage of a scene's model.
    pub fn of(scene: &SceneData<'_>) -> Self {
        let settings = scene.settings;
        let tau = settings.analog.reflectivity.delay_mismatch;
        let lag = LagMap::of(1.0 / settings.timebase.sample_rate().hertz(), tau);
        Self { lag, follows_at_once: tau == 0.0, last: None }
    }

    /// Light behind the stage, `between` steps in each sample of the machine.
    pub fn pass(mut self, light: Vec<f64>, between: usize) -> Vec<f64> {
        if self.follows_at_once {
            return light;
        }
        straight(light, between).into_iter().map(|light| self.next(light)).collect()
    }

    fn next(&mut self, input: f64) -> f64 {
        let [before, output] = self.last.unwrap_or([input; 2]);
        let output = self.lag.step(output, [before, input]);
        self.last = Some([input, output]);
        output
    }
}
