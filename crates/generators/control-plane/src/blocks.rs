//! What of the machine is there for a stage: a block without work is left out (section 24; economy).

use std::sync::Arc;

use crate::stage::MachineStage;
use hardware_model::{Forced, Loader};
use remote_shadow::{Resolution, ShadowBank};
use scenario::ShadowFineness;
use shadow_controller::ShadowController;

use crate::elaboration::{Block, Elaboration};

/// Blocks beside the terrain path.
#[derive(Debug)]
pub struct Blocks {
    /// Feature generator and VS1.
    pub features: bool,
    /// Shadow controller and VS2.
    pub shadows: Option<Shadows>,
    /// Texture generator and the adder.
    pub texture: bool,
    /// Polyhedron generator and VS3.
    pub bodies: bool,
    /// Second terrain generator, for the coarse level.
    pub coarse: Option<Coarse>,
    /// Whether the mixing unit has anything to switch, add or clip.
    pub mixing: bool,
    /// Whether switches without a source are there as well.
    pub all_switches: bool,
    /// Whether breaks are walked in groups that have none as well.
    pub breaks: bool,
    /// Instants a step of the accumulators, if groups are drawn straight between instants unless someone looks at them.
    pub instants: Option<u32>,
}

/// Remote shadow: computed before the mission, and the block that blanks by it.
#[derive(Debug)]
pub struct Shadows {
    /// Boundaries of shadow on the ground, worked out before the mission and as it goes on.
    pub bank: ShadowBank,
    /// The block that blanks by them.
    pub controller: ShadowController,
    /// Ground range beyond which no shadow is drawn (m).
    pub reach: f64,
}

/// The second terrain generator of the modified one.
#[derive(Debug)]
pub struct Coarse {
    /// Single words are held back on the fine level only.
    pub loader: Loader,
}

impl Blocks {
    /// The blocks of `list`, which is the machine for `stage`.
    pub fn new(stage: &MachineStage, list: &Elaboration) -> Self {
        let settings = &stage.settings;
        let tells_lines = list.has_parts(Block::Shadows) || list.has_parts(Block::Mixing);
        let shadows = settings.shadows.filter(|_| list.has(Block::Shadows));
        Self {
            features: list.has(Block::Features),
            shadows: shadows.map(|fineness| Shadows::new(stage, &fineness, tells_lines)),
            texture: list.has(Block::Texture),
            mixing: list.has(Block::Mixing),
            all_switches: settings.economy.forces(Forced::Switches),
            breaks: settings.economy.forces(Forced::Breaks),
            instants: list.instants(),
            bodies: list.has(Block::Bodies),
            coarse: list.has(Block::SecondLevel).then(|| Coarse::new(&settings.loader)),
        }
    }
}

impl Coarse {
    /// The second generator behind a loader such as the fine level's.
    pub fn new(loader: &Loader) -> Self {
        Self { loader: Loader { delays: Vec::new(), ..loader.clone() } }
    }
}

impl Shadows {
    /// The map of the controller is the finest level.
    fn new(
        MachineStage { landscape, settings, .. }: &MachineStage,
        fineness: &ShadowFineness,
        tells_lines: bool,
    ) -> Self {
        let [south, west, north, east] = landscape.level().extent();
        let ShadowFineness { finest, angle, reach } = *fineness;
        let bank = ShadowBank::new(Arc::clone(landscape), Resolution { finest, angle });
        Self {
            bank: match &settings.shadow_cache {
                Some(cache) => bank.with_cache(&cache.folder, cache.most_bytes),
                None => bank,
            },
            reach: reach.unwrap_or(settings.range.end).min(settings.range.end),
            controller: ShadowController {
                parts: settings.shadow_controller,
                map_centre: [0.5 * (south + north), 0.5 * (west + east)],
                map_side: (north - south).max(east - west),
                tells_lines,
            },
        }
    }
}
