//! Which blocks are ideal for a stage: made of algebra and not of parts.

use crate::preview::preview_obstacle;
use hardware_model::{AnalogParts, Economy, WireParts, WriteCompensation};

use crate::stage::MachineStage;

/// Whether the mixing unit is made of parts: its gates wait for their comparators.
pub fn mixing_has_parts(parts: &AnalogParts) -> bool {
    !(parts.mixing_is_ideal() && parts.comparator_is_ideal())
}

/// Whether the projection processor and the write gun are made of parts.
pub fn beam_has_parts(parts: &AnalogParts) -> bool {
    let memory = &parts.memory;
    !parts.projection_is_ideal()
        || memory.write_compensation != WriteCompensation::Exact
        || memory.deflection.is_some()
}

/// Whether the outputs of the mixing unit have amplifiers.
pub(crate) fn drives_mixing(parts: &WireParts) -> bool {
    parts.drives("mu.height") || parts.drives("mu.reflectivity")
}

/// Whether the machine of `stage` draws a preview: its economy says so, and nothing is in the way.
pub(crate) fn draws_swiftly(stage: &MachineStage) -> bool {
    stage.settings.economy == Economy::Swift && preview_obstacle(&stage.settings).is_none()
}
