//! Which blocks are ideal for a stage: made of algebra and not of parts.

use hardware_model::{AnalogParts, Economy, Gate, WireParts, WriteCompensation};
use scenario::FeatureLight;

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

/// Whether the machine of `stage` draws swiftly: its economy says so, its parts are ideal beside those of the terrain
/// generators, and its laws are such that what features and terrain add up to can be lit as one surface. Tubes may have what
/// they have: they come after.
pub(crate) fn draws_swiftly(stage: &MachineStage) -> bool {
    let (settings, parts) = (&stage.settings, &stage.settings.analog);
    settings.economy == Economy::Swift
        && settings.laws.feature_light == FeatureLight::Combined
        && settings.mixing_unit.gate == Gate::Presence
        && parts.reflectivity.delay_mismatch == 0.0
        && parts.features_are_ideal()
        && parts.shadow_lines_are_ideal()
        && parts.texture_is_ideal()
        && parts.body_switch_is_ideal()
        && !mixing_has_parts(parts)
        && !beam_has_parts(parts)
}
