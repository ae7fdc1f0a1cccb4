//! What of the machine is made of real parts: a block whose parts are all ideal is its algebra, and nothing of this.

use generator::Stage;
use landscape::Level;
use parts::LagStep;
use signal::Real;
use terrain_generator::PartsArray;

/// Blocks made of parts.
#[derive(Debug)]
pub(crate) struct RealParts<S> {
    /// Terrain generators of the fine and of the coarse level.
    pub terrain: Option<Terrain<S>>,
}

/// Terrain generators made of parts.
#[derive(Debug)]
pub(crate) struct Terrain<S> {
    pub fine: PartsArray<S>,
    pub coarse: Option<PartsArray<S>>,
    /// Delay of the reflectivity against the height.
    pub reflectivity: Option<LagStep<S>>,
}

impl<S: Real> RealParts<S> {
    /// The parts that the model of `stage` names.
    pub fn new(stage: &Stage) -> Self {
        let settings = &stage.settings;
        let step = 1.0 / settings.timebase.sample_rate().hertz();
        let array = |level: &Level, name| PartsArray::new(step, level, &settings.analog, settings.seed, name);
        let levels = stage.landscape.bank().levels();
        let mismatch = settings.analog.reflectivity.delay_mismatch;
        let terrain = || Terrain {
            fine: array(&levels[0], "tg"),
            coarse: settings.levels.and_then(|_| levels.get(1)).map(|level| array(level, "mtg")),
            reflectivity: (mismatch > 0.0).then(|| LagStep::new(step, mismatch)),
        };
        Self { terrain: (!settings.analog.terrain_is_ideal()).then(terrain) }
    }
}
