//! Craters: closed forms, lists of them, populations, and an index of where they are (report III.A.2, section 9).
//!
//! Heights are added to the terrain; slopes are added as vectors. Axes: x north, y east, h up, metres.
//!
//! - [`Crater`]: the three types of the report, checked once.
//! - [`Ring`]: a ring of a crater, in which its height is a quadratic in the distance from the centre.
//! - [`Craters`]: any number of them, in as few numbers as they take.
//! - [`Features`]: all craters of a problem area; queries look only at what is near.
//! - [`Outlook`]: which of them are large enough to be told from where they are seen.
//! - [`kept_share`]: how much of a crater samples of the ground can show.
//! - [`list`]: craters from a CSV file.
//! - [`population`]: craters from a seed and a size-frequency law.

mod crater;
mod craters;
mod fade;
mod fan;
mod field;
mod index;
pub mod list;
mod outlook;
pub mod population;
mod rings;
mod spot;
mod tier;

pub use crater::{Crater, CraterError, Shape};
pub use craters::Craters;
pub use fade::kept_share;
pub use field::{Features, Rise};
pub use outlook::{LeftOut, Outlook};
pub use rings::Ring;
pub use spot::MOST_CRATERS;
