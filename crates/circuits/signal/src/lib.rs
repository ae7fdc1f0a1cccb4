//! Sweep buffers in groups of lanes, the scalar of a run, numbers side by side, the signal table, probes.
//!
//! Sweeps do not depend on one another, so the signal plane runs [`LANES`] of them side by side: a buffer holds
//! one [`Lanes`] a sample. A group of sweeps is the unit of work whatever the number of threads, so threads
//! cannot change a bit.

mod breaks;
mod double;
mod lanes;
mod number;
mod probe;
mod real;
mod square;
mod table;

pub use breaks::{Break, Breaks, Stretches};
pub use double::{Both, Double};
pub use lanes::{LANES, Lanes};
pub use number::{Comparable, Number, Truth, eight, pair};
pub use probe::{Probe, Waveform};
pub use real::Real;
pub use square::turn_square;
pub use table::{Axis, Kind, Signal, Unit, Wire, name_matches};
