//! The signal table of the machine.

use std::sync::OnceLock;

use control_plane::{RANGE, waveforms};
use signal::{Signal, Unit};

/// Signals of the sweep generator, recorded from the program.
const SWEEP: &[Signal] = &[
    Signal::ground("sweep.x", Unit::Region, "folded ramp to the north", "fig. 17"),
    Signal::ground("sweep.y", Unit::Region, "folded ramp to the east", "fig. 17"),
    Signal::ground(RANGE, Unit::Metre, "ground range", "section 6.2"),
];

/// Every signal that the machine can record, in the order of the figure.
pub fn signals() -> &'static [Signal] {
    static TABLE: OnceLock<Vec<Signal>> = OnceLock::new();
    TABLE.get_or_init(|| {
        [
            SWEEP,
            waveforms::WIRES,
            waveforms::REGISTERS,
            waveforms::COARSE,
            terrain_generator::INNER_SIGNALS,
            terrain_generator::SIGNALS,
            waveforms::FEATURES,
            feature_generator::SIGNALS,
            shadow_controller::SIGNALS,
            texture_generator::SIGNALS,
            mixing_unit::SIGNALS,
            mixing_unit::GATES,
            display_projection_processor::SIGNALS,
            polyhedron_generator::SIGNALS,
            sweep_memory::SIGNALS,
        ]
        .concat()
    })
}
