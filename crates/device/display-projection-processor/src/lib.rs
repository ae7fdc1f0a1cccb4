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
//!
//! # Of real parts
//!
//! [`PartsProcessor`] is the same block with the figures of [`hardware_model::AnalogParts`]; a machine has one or the
//! other.
//!
//! ```text
//! height ─▶ - z²/2R ─▶ ÷ z ─▶ limiter, bow, lag ─┬─▶ deflection ─▶ bow, lag ─▶ position
//!                                                ├─▶ d/dt ─▶ comparator ─┐
//!                                                └─▶ S/H ──▶ comparator ─┴▶ latch ─▶ beam on, off
//! reflectivity ─▶ delay line ───────────────────────────────────────────────▶ intensity
//! ```
//!
//! **Law.** Elevation is a share of the field, -1 and 1 at the lower and the upper edge of the picture on the sweep,
//! held within 1.1. A function generator is off by `e (1 - u²)` and a lag behind. By derivative: the beam goes off where a
//! comparator finds `tau_d eta' < -V_h`, and on where another finds the elevation `V_h / 2` above the held one and no
//! fall. By peak-hold: off `V_h / 2` below the highest, on `V_h / 2` above the held. Both trip late ([`parts::Comparator`]);
//! the sample-and-hold tracks with a lag, adds its pedestal and droops ([`parts::SampleHold`]).
//! **Parameters.** `projection`, `comparator`, `sample_hold`, `amplifier.noise`, `video_bandwidth`, `full_scale`,
//! `spread`; the seed of the model.
//! **State and timing.** A step is a sample; trips lie between samples, and the beam's stretches ([`signal::Stretches`])
//! with them. Everything settles in retrace. Nominal delays are trimmed out: the intensity waits in a delay line for the
//! position, so does the blanking, and everything waits for the differentiator. Video that is later than the elevation
//! stays late.
//! **Elaboration.** A bow of no error and a lag of no bandwidth are not there.
//! **Our choices.** Full scale, the limiter, and where a profile ends (a tangent below -1000: the control plane blanks).
//! Full scale of the derivative: 4 full scales a microsecond, so that 0.1 % is three sigma of a nominal noise. Noise is
//! that of the processor's band, at the comparators; a peak detector that tracks has it on both inputs. A comparator
//! needs twice its delay at an overdrive of 3.75 mV of 10 V, and at most 12.5 delays or 500 ns. Set wins in the latch.
//! **Not modelled.** Noise and slew on the deflection, offset, bends of height between samples: a rim is as sharp as
//! the samples around it.

mod deflection;
mod occlusion;
mod of_parts;
mod preview;
mod processor;

pub use deflection::Deflection;
pub use occlusion::BrokenProfile;
pub use of_parts::{DERIVATIVE, Driven, PartsProcessor, Scratch};
pub use preview::PreviewSight;
pub use processor::{Processor, Projected, SIGNALS};
