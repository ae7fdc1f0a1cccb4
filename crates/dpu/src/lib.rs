//! Digital processing unit (fig. 15): the digital side of every sweep (sections 6.3, 6.5, 17).
//!
//! ```text
//! folds ──▶ pointers of the four colours ──▶ requests ──▶ loader ──▶ XFIRST, YFIRST (or hold, when late)
//! ```
//!
//! **Law.** At a fold two colours take their preload register into hold; their pointers move by one array step
//! (two corners) along the sweep, and both preload registers of both colours are asked for anew: 18 words used,
//! 36 loaded. `XFIRST(c) = array_c[ptr_c + (cx, 0)]`, `YFIRST(c) = array_c[ptr_c + (0, cy)]`.
//! **Timing.** A fold is seen at the first master tick at or after it; words arrive `access_ticks` later. With an
//! access of 0 ticks the transfer is wired and words arrive with the fold itself. Words that come after the fold
//! that needs them are late: the model's policy says whether they go straight through to hold or are lost.
//! **Our choices.** Home registers: at sweep start all registers are full. A request whose colour has moved on
//! is cancelled. Pointers that leave the stored area clamp to its edge.
//! **Not modelled yet.** CPU, I/O processors, drum, buffers.

mod crossing;
mod home;
mod visible;

pub use crossing::{CrossingService, TimedFold};
pub use home::Pointers;
pub use visible::Sector;
