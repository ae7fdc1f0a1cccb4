//! The terrain generator's chain of one sweep as a circuit for ngspice: an array, or the stage that makes light of its slopes.
//!
//! ```text
//! interpreter's array of one sweep, or its light ─▶ circuit ─▶ text ─▶ ngspice -b ─▶ waveforms
//! ```
//!
//! **Law.** Every part is what `docs/hardware-1969.md` says of it, continuous in time: no sample, no straight line between samples.
//! What is digital is given: instants of words and of polarity, words of converters, and the triangle in the accumulators.
//! **Units.** Seconds from the sample at which everything is at rest; shares of full scale, as in the array. The three sums are in metres
//! and in slopes.
//! **Our choices.** A lag is a resistor of 1 ohm and a capacitor of its time constant. What jumps takes [`EDGE`] seconds, and a pulse
//! of a carry [`PULSE`] seconds. Noise is left out: it is added behind the sums. Light is given the slopes of the machine, straight between
//! its samples; its root and its divider are the loops themselves, without a gain that stands over a step.

mod agreement;
mod circuit;
mod light;
mod run;
mod sources;
mod written;

pub use agreement::{Agreement, INSTANTS, compare};
pub use circuit::{ARRAY, Circuit, of_array};
pub use light::{LIGHT, LightCircuit, of_light};
pub use run::{Curves, RunError, run};
pub use written::Netlist;

/// Length of a jump (s).
pub const EDGE: f64 = 1e-12;

/// Length of the pulse of a carry (s).
pub const PULSE: f64 = 2e-10;
