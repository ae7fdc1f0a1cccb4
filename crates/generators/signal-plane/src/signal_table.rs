//! The signal table of the machine.

use std::sync::OnceLock;

use control_plane::{RANGE, STATE_WIRES, waveforms};
use signal::{Kind, Signal, Unit};
use terrain_generator::{COARSE, FINE};

/// Where the deflection yoke of the read-out stands.
const YOKE: &[Signal] = &[Signal::digital(
    "yoke.angle",
    Unit::Radian,
    Kind::Bus,
    "angle of the deflection yoke: the picture turns counter-clockwise",
    "section 12",
)];

/// Signal of the ground-range programme.
const RANGES: &[Signal] = &[Signal::ground(RANGE, Unit::Metre, "ground range", "section 6.2")];

/// Every signal that the machine can record, in the order of the figure.
pub fn signals() -> &'static [Signal] {
    static TABLE: OnceLock<Vec<Signal>> = OnceLock::new();
    TABLE.get_or_init(|| {
        let [fine, coarse] = [&*FINE, &*COARSE].map(|level| {
            let wires: Vec<Signal> = level.wires.iter().map(|(_, signal)| *signal).collect();
            // Accumulators and ramps are the sweep generator's.
            let array = wires.partition_point(|signal| signal.prefix() == "sweep");
            (wires[..array].to_vec(), wires[array..].to_vec())
        });
        [
            &fine.0,
            RANGES,
            waveforms::WIRES,
            waveforms::REGISTERS,
            &FINE.words,
            &coarse.0,
            waveforms::COARSE,
            &COARSE.words,
            &fine.1,
            &coarse.1,
            terrain_generator::SIGNALS,
            waveforms::FEATURES,
            feature_generator::SIGNALS,
            &feature_generator::UNIT_SIGNALS,
            shadow_controller::SIGNALS,
            &shadow_controller::COMPARATORS,
            texture_generator::SIGNALS,
            mixing_unit::SIGNALS,
            mixing_unit::GATES,
            display_projection_processor::SIGNALS,
            polyhedron_generator::SIGNALS,
            sweep_memory::SIGNALS,
            YOKE,
            &STATE_WIRES,
        ]
        .concat()
    })
}
