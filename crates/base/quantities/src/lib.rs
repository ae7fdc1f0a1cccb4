//! Time and clocks as exact rationals, ticks, samples, angles at the edge, seeds, numbers in words.
//!
//! Time is counted in integers and rounded once. A [`Timebase`] holds the clocks of one machine; a
//! [`SweepTime`] is a real instant inside one sweep, in units of accumulator steps (samples), and only
//! [`SweepClock::tick_at_or_after`] turns it into a master-clock [`Tick`].

mod angle;
mod hash;
mod luminance;
mod reading;
mod time;

pub use angle::{degrees, radians, sin_cos, wrap_heading};
pub use hash::{hash_on, hash_words, mix, unit_interval};
pub use luminance::{LUMINANCE_WEIGHTS, intensity, is_grey, luminance};
pub use reading::fixed;
pub use time::{Rate, SweepClock, SweepTime, Tick, Timebase, TimebaseError};
