//! The levels of terrain that a stage draws.

use landscape::Level;
use machine::MachineStage;

/// One level of terrain that sweeps run over.
#[derive(Clone, Copy)]
pub struct DrawnLevel<'a> {
    /// Place of its program among those of a sweep.
    pub number: usize,
    /// Name of the level: `fine` or `coarse`.
    pub name: &'static str,
    /// Stored ground of the level.
    pub level: &'a Level,
}

/// The fine level, and the coarse one where the scenario goes over to it.
pub fn drawn_levels(stage: &MachineStage) -> Vec<DrawnLevel<'_>> {
    let names = if stage.settings.levels.is_some() { &["fine", "coarse"][..] } else { &["fine"] };
    let levels = stage.landscape.bank().levels().iter().zip(names).enumerate();
    levels.map(|(number, (level, name))| DrawnLevel { number, name, level }).collect()
}
