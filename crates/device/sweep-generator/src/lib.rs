//! Sweep generator: folded ramps and the ground-range programme (fig. 17; sections 6.2, 6.5).
//!
//! ```text
//! azimuth, start ─▶ accumulators ─▶ D/A ─▶ sweep.x, sweep.y   folded, 0..1, to the terrain generator
//!                        │                 sweep.range          unfolded, to the projection processor
//!                        └──▶ limit stops ─▶ folds             to registers, polarity, crossing service
//! ```
//!
//! **Law.** `x/d = K + X0 + lambda cos theta`, likewise y; the ramps are that, folded at 0 and 1. A fold changes
//! the direction of a ramp; overshoot is given back, not lost.
//! **Timing.** One accumulator step is one sample; between samples range grows in a straight line, so a fold has
//! a real time between samples.
//! **Of real parts.** The steps of the D/A and its smoother stand in the terrain generator's array of parts
//! (`terrain_generator::PartsArray`), which the ramps feed.
//! **Our choices.** The stop fires only on arrival, never on a ramp that stands on it. When both ramps arrive in
//! the same instant X is served first (section 6.5).

mod ramps;
mod range_table;
mod sample_finder;
mod timed_folds;

pub use ramps::set_up;
pub use range_table::RangeTable;
pub use timed_folds::TimedFolds;
