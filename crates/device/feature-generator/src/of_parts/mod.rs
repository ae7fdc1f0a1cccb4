//! The feature generator made of real parts.
//!
//! ```text
//! x, y of the sweep ─▶ - centre ─▶ 2 squarers ─▶ + ─▶ limiter ─▶ parabola ─▶ height, slopes ─▶ sum of all
//!                       └──────────── lag of the chain ────────────────┘ └▶ comparator ─▶ fg.present
//! ```
//!
//! **Law.** That of the block with, in every sub-generator, a squarer of x and one of y that are off by a scale error
//! each, a sum with an offset (full scale is the square of the footprint's radius: centres are taken off before the
//! squarers, and the gain is set with the load), and a parabola with a scale error. Together: a footprint and circles that
//! are ellipses, a little off, which for one sweep is a crater with another foot and other radii in closed form
//! ([`sub_generator`]). Behind it height and slopes pass one lag ([`parts::LagStep`]), exactly for straight lines
//! between samples, split at every circle that the sweep crosses. The comparator of the footprint is off by an offset o of
//! full scale, which is a presence line for a radius `R sqrt(1 - o)`; what it sees there has a slope ([`footprint`]).
//! **Parameters.** [`hardware_model::FeatureChainParts`]: static error (one sigma of each multiplier), bandwidth;
//! `comparator.offset`. The delay of the comparators is the mixing unit's, which has the gate.
//! **State and timing.** A chain settles in retrace, and comes to rest behind each footprint. At a rate v of ground range a
//! crater lies v tau farther away than it is; the floor of a bowl with curvature c is higher by `c (v tau)^2 / 2`.
//! **Elaboration.** With ideal figures the block is its algebra, and nothing of this is there.
//! **Our choices.** The lag behind the parabola, where it rounds rims; before it it would be the same but for terms of
//! second order. The limiter holds what is beyond the footprint at 0, so the comparator moves the gate alone. Of any
//! number of sub-generators [`MOST`] differ from one another, and take turns. Slope outputs have the errors of their height.
//! **Not modelled.** Noise, the summing amplifier, bits of the registers.

mod chain;
mod footprint;
mod sub_generator;
#[cfg(test)]
mod tests;

pub use chain::{ChainScratch, MOST, PartsFeatures};
