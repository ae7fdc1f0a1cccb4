//! The full landscape: craters, remote shadow, bodies, texture, two levels and roll, the machine against `exact` and
//! against closed forms, and over time.
//!
//! - `economy`: what is left out, and that it may be.
//! - `profiles`, `shadows`, `pictures`: block by block, by probes and by pictures.
//! - `own_shadow`: the vehicle's.
//! - `preview`: the preview against the whole picture.
//! - `switches`: the video switches with either gate.
//! - `limits`: too few sub-generators and line generators; more craters and segments than anybody draws.
//! - `time`: any frame alone, in any order, by any number of threads.
//! - `moved`: the whole scene elsewhere.

mod economy;
mod limits;
mod moved;
mod own_shadow;
mod pictures;
mod preview;
mod profiles;
mod quality;
mod set;
mod shadows;
mod switches;
mod time;
