//! Terrain generator, alone or one a level (fig. 16-22; sections 6 to 8).
//!
//! ```text
//! sweep.x ─▶ g0 g1 g2 of X, 1-X ─┐
//! sweep.y ─▶ g0 g1 g2 of Y, 1-Y ─┴▶ 36 products ─▶ 36 multiplying D/As ─▶ sum ─▶ tg.height
//!                                        ▲ hold ◀─ XFIRST, YFIRST ◀─ loads      tg.slope.u, tg.slope.v
//! polarity flip-flops s_x, s_y ─▶ signs of the odd terms                        ─▶ light ─▶ tg.reflectivity
//!
//! fine   ─▶ height, slopes ─┐ × w
//!                           ├─────── + ─▶ height, slopes ─▶ light     (modified terrain generator)
//! coarse ─▶ height, slopes ─┘ × 1-w      ▲ w: 1 to 0 before the switch, by ground range
//! ```
//!
//! **Law.** With `a = 1` for colours at X = 1, `b = 1` at Y = 1, `e_x = s_x (-1)^a`, `e_y = s_y (-1)^b`:
//! `h = sum e_x^p e_y^q g_p(X_a) g_q(Y_b) f_pq` over the four colours and nine words (section 6.4). Slopes are the
//! derivatives of the same sum; reflectivity is `n.s` times albedo, drawn as 0 where it is negative (section 7), and
//! times the factor of another law of reflection if the landscape has one ([`landscape::Photometry`]).
//! **How it is computed.** Between two events the registers stand still and both ramps are straight, so the sum
//! is one polynomial of degree 10 in ground range. [`Segment`] expands it from the words *now in the hold
//! registers* with the present polarity: a late or stale word shows. The slope along the sweep is its derivative,
//! the slope across has its own polynomial of degree 9; the sun is turned into (along, across, up) once a sweep.
//! A stretch of one or two samples is cheaper straight through the array. Stretches of eight sweeps are expanded side by side,
//! each is evaluated eight samples at a time: compiled for each width of vectors, chosen as the program runs, to the same bits.
//! **Parameters.** Corner words, region size, ranges of the samples, datum; with two levels the switch of every sweep
//! (m) and the length of the blend (m).
//! **Timing.** Fold, polarity and transfer happen in the instant of the fold; the first sample at or after an
//! event sees its effect.
//! **Elaboration.** A landscape of one level has one generator. Of two, each computes only the samples that its group
//! takes from it. Under Lambert's law nothing asks for the line of sight.
//! **Our choices.** The eye's height is subtracted in the summer, so that f32 signals keep their precision near
//! the eye. Beyond the end of the profile the height drops out of sight ([`OUT_OF_SIGHT`]). Levels
//! are blended before the light, so the light is that of the ground that is shown.
//! **Of real parts.** [`PartsArray`] is the same array wire by wire, [`PartsLight`] the light of its slopes; a machine has one or the other. Whoever looks inside
//! either names [`InnerWire`]s and gets [`Inside`]: accumulators, ramps, function generators, products, D/As and sums.

mod array;
mod eight_stretches;
mod generator;
mod inner;
mod inside;
mod light_of_parts;
mod modified;
mod of_parts;
mod points;
mod polynomials;
#[cfg(test)]
mod programs;
mod region;
mod registers;
mod segment;
mod stretches;
mod terms;

pub use array::array;
pub use generator::{LIGHT, Method, OUT_OF_SIGHT, Profile, SIGNALS, TerrainGenerator};
pub use inner::{COARSE, FINE, InnerSignals, InnerWire};
pub use inside::{Inside, held_words};
pub use light_of_parts::{LitGroup, PartsLight, light_full_scales, light_wires};
pub use modified::{ModifiedTerrainGenerator, Overlap};
pub use of_parts::{ArrayState, Logic, PartsArray, PartsTerrain, Scale, broken_lines};
pub use polynomials::Polynomials;
pub use region::Region;
pub use registers::Registers;
pub use segment::{Segment, Span};
