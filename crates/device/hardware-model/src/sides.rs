//! The two sides of the machine, each of which can be made ideal without the other.

use crate::{HardwareModel, Settings, ShadowParts, Yoke};

/// What can be made ideal by itself, to see what the other does to the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// What has words and set-ups ready in time: processor, loader, drums and storage buffers; sub-generators and line
    /// generators, whose words can be late and of which none may be free.
    Digital,
    /// What makes the picture of them: analog parts, storage tubes, mechanics of the yoke, the tube of a shadow map, what
    /// opens a video switch.
    Analog,
}

impl Settings {
    /// These settings with `side` as the ideal machine has it. Both sides keep what is no part: raster, clocks, range programme, laws,
    /// scalar, display, seed, kind of sweep memory, travel of the yoke (the raster that is written goes by it), levels and where they
    /// switch in a turn, fineness of shadow, economy.
    pub fn with_ideal(self, side: Side) -> Self {
        let ideal = HardwareModel::ideal();
        let shadow_side = match self.shadow_controller {
            ShadowParts::Digital { .. } => Side::Digital,
            ShadowParts::ScanConverter { .. } => Side::Analog,
        };
        let shadow_controller =
            if shadow_side == side { ideal.shadow_controller } else { self.shadow_controller };
        match side {
            Side::Digital => Self {
                cpu: ideal.cpu,
                loader: ideal.loader,
                data_banks: ideal.data_banks,
                kind_banks: ideal.kind_banks,
                feature_generator: ideal.feature_generator,
                feature_words: ideal.feature_words,
                segment_words: ideal.segment_words,
                shadow_controller,
                ..self
            },
            Side::Analog => Self {
                analog: ideal.analog,
                shadow_controller,
                mixing_unit: ideal.mixing_unit,
                yoke: self.yoke.map(|Yoke { travel, .. }| Yoke { travel, ..ideal.yoke }),
                ..self
            },
        }
    }
}
