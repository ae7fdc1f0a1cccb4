//! Terrain generator (fig. 16-22; sections 6 and 7).
//!
//! ```text
//! sweep.x ─▶ g0 g1 g2 of X, 1-X ─┐
//! sweep.y ─▶ g0 g1 g2 of Y, 1-Y ─┴▶ 36 products ─▶ 36 multiplying D/As ─▶ sum ─▶ tg.height
//!                                        ▲ hold ◀─ XFIRST, YFIRST ◀─ loads      tg.slope.u, tg.slope.v
//! polarity flip-flops s_x, s_y ─▶ signs of the odd terms                        ─▶ Lambert ─▶ tg.reflectivity
//! ```
//!
//! **Law.** With `a = 1` for colours at X = 1, `b = 1` at Y = 1, `e_x = s_x (-1)^a`, `e_y = s_y (-1)^b`:
//! `h = sum e_x^p e_y^q g_p(X_a) g_q(Y_b) f_pq` over the four colours and nine words (section 6.4). Slopes are the
//! derivatives of the same sum; reflectivity is `n.s`, drawn as 0 where it is negative (section 7).
//! **How it is computed.** Between two events the registers stand still and both ramps are straight, so the sum
//! is one polynomial of degree 10 in ground range. [`Segment`] expands it from the words *now in the hold
//! registers* with the present polarity: a late or stale word shows. The slope along the sweep is its derivative,
//! the slope across has its own polynomial of degree 9; the sun is turned into (along, across, up) once a sweep.
//! A stretch of one or two samples is cheaper straight through the array.
//! **Timing.** Fold, polarity and transfer happen in the instant of the fold; the first sample at or after an
//! event sees its effect.
//! **Our choices.** The eye's height is subtracted in the summer, so that f32 signals keep their precision near
//! the eye. Beyond the end of the profile the height drops out of sight ([`OUT_OF_SIGHT`]).
//! **Not modelled yet.** Function generators as diode broken lines, bandwidths, D/A bits: ideal parts only.

mod array;
mod generator;
mod light;
mod registers;
mod segment;

pub use array::array;
pub use generator::{OUT_OF_SIGHT, Profile, SIGNALS, TerrainGenerator};
pub use light::SweepLight;
pub use registers::Registers;
pub use segment::{Segment, Span};
