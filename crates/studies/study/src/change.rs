//! One setting over the base.

use hardware_model::{Economy, HardwareModel, ShadowParts, SweepMemoryKind};
use scenario::{Projection, RangeLaw, Scalar, Scenario, ShadowFineness};

/// A scenario on a model, to be changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Variant {
    /// Scenario, with its raster and laws.
    pub scenario: Scenario,
    /// Hardware model that draws it.
    pub model: HardwareModel,
    /// What is left out.
    pub economy: Economy,
}

/// What a rung does to the base setting.
#[derive(Debug, Clone)]
pub enum Change {
    /// So many samples a sweep.
    Samples(u32),
    /// So many sweeps a frame; a digital memory then has as many columns.
    Sweeps(u32),
    /// Scalar type of the analog signals.
    Scalar(Scalar),
    /// Analog parts, storage tubes and yoke of another model; the digital side stays.
    Parts(Box<HardwareModel>),
    /// Another law of the ground-range programme, between the same ends.
    Programme(RangeLaw),
    /// Another projection law of the sweeps.
    Projection(Projection),
    /// The fine level alone, to its edge.
    FineLevelAlone,
    /// Another kind of shadow controller.
    Shadow(ShadowParts),
    /// Profiles of shadow so many times as far from one another.
    CoarserShadows(f64),
    /// What is left out.
    Economy(Economy),
}

impl Change {
    /// Changes scenario and model of `variant`.
    pub fn apply(&self, variant: &mut Variant) {
        let Variant { scenario, model, economy } = variant;
        match self {
            Self::Samples(samples) => scenario.raster.samples = Some(*samples),
            Self::Sweeps(sweeps) => {
                scenario.raster.sweeps = Some(*sweeps);
                if model.sweep_memory == SweepMemoryKind::DigitalMemory {
                    scenario.raster.columns = Some(*sweeps);
                }
            }
            Self::Scalar(scalar) => scenario.scalar = *scalar,
            Self::Parts(other) => {
                model.analog = other.analog.clone();
                model.sweep_memory = other.sweep_memory;
                model.mixing_unit = other.mixing_unit;
                model.yoke = other.yoke;
            }
            Self::Programme(law) => {
                if let Some(range) = &mut scenario.range {
                    range.law = *law;
                }
            }
            Self::Projection(projection) => scenario.laws.projection = Some(*projection),
            Self::FineLevelAlone => scenario.levels = None,
            Self::Shadow(parts) => model.shadow_controller = *parts,
            Self::CoarserShadows(times) => {
                if let Some(ShadowFineness { finest, angle, .. }) = &mut scenario.shadows {
                    (*finest, *angle) = (*finest * times, *angle * times);
                }
            }
            Self::Economy(other) => *economy = *other,
        }
    }
}
