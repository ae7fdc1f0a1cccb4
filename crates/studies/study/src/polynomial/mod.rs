//! Evaluation of the ground along a sweep: 36 products, their factors, one polynomial a segment, and its Chebyshev sum.
//!
//! **Law.** Error is against the sum of section 6.4 worked out with twice the digits of f64 (`Double`), ramps included; words,
//! ranges and starts of the ramps are the machine's own f64. Time is of an evaluation; what is done once a segment is not in it.
//! **Our choices.** Twelve sweeps spread over the frame, stretches of three samples and more: shorter ones the machine does not
//! expand.

mod double;
mod measure;
mod method;
mod stretch;

pub use double::Double;
pub use measure::{POLYNOMIAL, polynomial_ladder};
pub use method::{Method, Ready};
pub use stretch::{Point, Stretch, stretches};
