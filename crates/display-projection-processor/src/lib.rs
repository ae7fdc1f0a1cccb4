//! Display projection processor (fig. 30; section 15).
//!
//! ```text
//! mu.height ─▶ - z²/2R ─▶ ÷ z ─▶ dpp.elevation ─▶ derivative or peak-hold ─▶ dpp.blank, dpp.hold
//! sweep.range ─┘                                                          └▶ dpp.y  line position
//! ```
//!
//! **Law.** `tan eta = (h - H - z^2/2R) / z`. Elevation is compared by its tangent: both are monotonic in one
//! another, and no angle is needed. Ground is seen where the tangent is not below any before it. The deflection
//! is `Y = (a - b t) / (c + e t)` with constants per sweep ([`Deflection`]).
//! **Occlusion.** [`scenario::Occlusion::Derivative`] as reported: blank when elevation falls, hold it, unblank
//! when it returns. [`scenario::Occlusion::PeakHold`]: compare with the highest so far. With ideal parts both
//! blank the same ground; they differ once comparators have thresholds and noise.
//! **Timing.** The derivative changes sign between two samples: the held elevation is the top of the parabola
//! through the three around. A profile comes back into sight between two samples; [`Projected::entry`] says where.
//! **Breaks.** A profile that bends between two samples ([`Processor::run_broken`]) is walked over its bends, each a
//! step of the circuit: a rim is the top that is held, wherever it falls. No parabola reaches across a bend; a
//! bend nearer than an eighth of a step is no support for one. Breaks that do not bend the profile (edges of
//! shadow) are projected and pass the circuits by. Range grows in a straight line between samples, and each break
//! has the curvature drop of its own range.
//! **Elaboration.** [`Processor::run`] knows nothing of breaks; lanes without bends have the same bits either way.
//! **Our choices.** Unblank when the elevation equals the held one; ground before the first sample is not drawn.
//! **Not modelled yet.** Comparator threshold, delay, sample-and-hold: ideal parts only.

mod deflection;
mod occlusion;
mod processor;
mod wired;

pub use deflection::Deflection;
pub use occlusion::BrokenProfile;
pub use processor::{Processor, Projected, ProjectedBreaks, SIGNALS};
pub use wired::{Driven, PartsProcessor, Scratch};
