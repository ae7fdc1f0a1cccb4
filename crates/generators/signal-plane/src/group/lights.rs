//! Light points of a group, behind its polyhedra.

use hardware_model::{Gate, MixingParts};
use light_point_generator::{Before, PointTable, Third};
use polyhedron_generator::Hold;
use signal::{Lanes, Real};
use sweep_memory::FarStroke;

use super::Group;
use crate::workspace::ThirdSwitch;

/// A sweep that light points are laid on.
#[derive(Debug, Clone, Copy)]
pub struct LitSweep {
    /// Number of the sweep.
    pub sweep: u32,
    /// Sweep with whose set-up it is drawn.
    pub drawn: u32,
    /// Its lane in the group.
    pub lane: usize,
    /// Whether polyhedra have just been composed on it.
    pub has_bodies: bool,
}

impl<S: Real> Group<'_, S> {
    /// VS3: light points over the `row` of a sweep, by the lines of the held elevation and the mountains behind the last sample.
    pub(super) fn lay_lights(
        &self,
        table: &PointTable,
        on: LitSweep,
        (held, far): (&[Lanes<S>], &[FarStroke]),
        switch: &mut ThirdSwitch,
        row: &mut [f32],
    ) {
        let chords = table.sweep(on.drawn);
        if chords.is_empty() {
            return;
        }
        let ThirdSwitch { overlay, lights, .. } = switch;
        let hold = Hold { near: self.near, lines: |sample: usize| held[sample][on.lane].to_f64() as f32 };
        let standing = self.delivery.polyhedra.table().sweep(on.drawn as usize);
        let before = Before {
            hold: &hold,
            mountains: far.iter().map(|stroke| stroke.line).reduce(f32::min),
            bodies: on.has_bodies.then_some((&*overlay, standing)),
        };
        let MixingParts { gate, threshold } = self.stage.settings.mixing_unit;
        let key = (gate == Gate::SelfKeyed).then_some(threshold as f32);
        let third = Third { parts: self.parts.bodies.as_ref(), key };
        lights.lay(on.sweep, (table, chords), &before, third, row);
    }
}
