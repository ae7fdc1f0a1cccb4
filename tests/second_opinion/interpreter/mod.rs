//! A slow and obvious interpreter of one sweep, as the report draws it (sections 6, 7, 15.1, 15.2, 15.4, 24).
//!
//! It takes the words of the bank and the plain numbers of a scene, and shares no code with the machine. It knows
//! no polynomials in ground range: at every accumulator step it reads the two ramps, forms 36 products and adds
//! them. Files, by part of the drawing: [`ramp`] (accumulators, limit stops, polarity), [`registers`] (hold, XFIRST,
//! YFIRST of 36 multipliers, pointers, words on their way), [`terrain`] (function generators, products, sums,
//! Lambert), [`projector`] (elevation and the occlusion circuit), [`sweep`] (one sweep in order).

pub mod projector;
pub mod ramp;
pub mod registers;
pub mod sweep;
pub mod terrain;

pub use sweep::{Record, interpret, range_programme};
