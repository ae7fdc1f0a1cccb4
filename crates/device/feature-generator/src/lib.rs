//! Feature generator (section 10; report III.A.2, III.C.4).
//!
//! ```text
//! features ─▶ Schedule: chords of the sweep ─▶ FeatureProgram: loads ─┐
//!                                                                     ▼
//! x = z cos θ, y = z sin θ ─▶ sub-generators: type 1 … type 1 │ type 2 … │ type 3 … ─▶ sum ─▶ fg.height
//!                                    └ presence, any of them ─▶ fg.present                 fg.slope.u, fg.slope.v
//! ```
//!
//! **Law.** Section 9: each sub-generator holds one crater and answers with height and slope while the sweep is in
//! its footprint. Heights add, slopes add as vectors; `rho^2 = (z - m)^2 + q^2` with the foot m of the centre on the
//! sweep and its distance q beside it. The light of the sum is the machine's (fg.reflectivity): it depends on
//! whether terrain slopes are added first.
//! **Parameters.** [`hardware_model::FeatureParts`]: sub-generators of each crater type, and how craters come to them.
//! *Scheduled* (report, organisation B): a sub-generator is taken for the chord of one crater. *By region* (A): craters
//! are stored with every region they touch and loaded group by group, so a sub-generator stays taken from the edge
//! where the sweep enters the first region of the chord to the edge where it leaves the last.
//! **State and timing.** Eight words a crater, one crater after another on a line of so many words a second, from the
//! retrace before the sweep on, in the order in which the sweep comes to need them ([`Schedule::write_by`]); or in no time.
//! A crater whose words come behind its leading edge is drawn from where they come (strobe-through) or not at all in this
//! sweep (latched); words that could not set out before the sweep has left the crater do not. No sub-generator free: the
//! crater is not drawn in this sweep and counted as dropped; the nearest come first (22, row 14). Between two kink circles
//! all sub-generators stand still in one zone of their law, so a sweep is drawn stretch by stretch; the crossings of the
//! circles are the kinks, at their real range.
//! **Precision.** The offset from a crater is taken in f64 and only then rounded to the signal's scalar, so that far
//! craters keep their shape: f64 signals agree with the direct sum to 1e-12 of full scale, f32 signals to 2e-5 of it
//! where rims are at least a tenth as wide as their radius.
//! **Elaboration.** Without features there is nothing to load and nothing to draw.
//! **Preview.** [`FeatureGenerator::lay`] adds craters at the samples, as the sweeps of a group pass them ([`Passings`]), and
//! looks for no kinks.
//! **Our choices.** Unfolded sweep voltages relative to the eye's foot (section 10). Sums run in the order of the
//! crater list, so that they are those of [`features::Features::at`]. A footprint is a circle, not its bounding square.
//! **Texture.** [`FeatureGenerator::grain`]: what craters add to the gain of texture (fg.grain), where the texture generator asks.
//! **Parts.** [`PartsFeatures`]: bandwidth and static errors of the chain, offsets of the footprints' comparators; their
//! delay is the mixing unit's.

mod bank;
mod chord;
mod generator;
mod grain;
mod loads;
mod of_parts;
mod passing;
mod preview;
mod profile;
mod schedule;
mod side_by_side;
mod steps;
mod sub_generator;
mod units;

pub use generator::FeatureGenerator;
pub use loads::{CRATER_WORDS, FeatureArrival, FeatureMiss};
pub use of_parts::{ChainScratch, MOST, PartsFeatures};
pub use passing::Passings;
pub use profile::{FeatureProfile, Kink, SIGNALS, Surface};
pub use schedule::{FeatureLoad, FeatureProgram, Schedule};
pub use units::{SubGeneratorPlace, UNIT_SIGNALS, place_of};
