//! Timing records: what the digital side did and when, and baselines to hold it to.

mod check;
mod comparison;
mod deadline;
mod diff;
mod difference;
mod event_hash;
mod file;
mod frame_differences;
mod junit;
mod layout;
mod missed;
mod plot;
mod record;
mod text;
mod totals;

pub use check::Fault;
pub use comparison::{Comparison, FrameComparison, Tolerance, ToleranceError, compare};
pub use deadline::{BINS, Deadline, Slack};
pub use difference::Difference;
pub use event_hash::EventHash;
pub use file::{RecordError, read, write};
pub use missed::{Cause, Missed};
pub use record::{FORMAT, FrameTiming, Sets, TimingRecord, UnitUse};
pub use totals::{DeadlineTotals, SweepMisses, Totals, UnitTotals};
