//! Craters: closed forms, lists of them, populations, and an index of where they are (report III.A.2, section 9).
//!
//! Heights are added to the terrain; slopes are added as vectors. Axes: x north, y east, h up, metres.

mod crater;
mod field;

pub use crater::{Crater, CraterError, Shape};
pub use field::{Features, Rise};
