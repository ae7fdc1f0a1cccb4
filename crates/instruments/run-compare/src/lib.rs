//! How far one picture, or one run, is from another, frame by frame.
//!
//! [`Pictures`] pairs them. Pixels along edges can be left out ([`LeftOut`]), as the closed form sees them in the scenario
//! of the runs. [`Compared`] holds the errors, and says whether [`Tolerances`] are met.

mod compared;
mod edges;
mod error;
mod pair;
mod pictures;

pub use compared::{Compared, Tolerances};
pub use edges::EdgeKind;
pub use error::RunCompareError;
pub use pictures::{LeftOut, Pictures};
