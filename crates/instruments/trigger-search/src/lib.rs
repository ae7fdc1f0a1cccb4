//! Where in a mission a condition on signals is met, and what lies around the place.
//!
//! ```text
//! rehearsal, Condition ─▶ Finder ─▶ search ─▶ Found ─▶ Around ─▶ Report, page of the scope, file of waveforms
//! ```
//!
//! The crate `trigger` has the condition and says what meets it. This crate draws the signals that it names, frame by
//! frame, and records the neighbourhood of a place.

mod around;
mod error;
mod find;
mod pixel;
mod report;
mod write;

pub use around::{Around, BEAM};
pub use error::SearchError;
pub use find::{Area, Ended, Finder, Found};
pub use pixel::pixel_of;
pub use report::Report;
pub use write::{page, write_waveforms};
