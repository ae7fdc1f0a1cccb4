//! Deadlines of the digital side: which are missed, why, what that does to the picture, and which parts would do.
//!
//! ```text
//! scenario, model ─▶ Rehearsal ─▶ timing record ─▶ critical path, misses, timeline of a sweep, plots
//!                        ├─▶ columns: every column that differs from the ideal machine, traced to lines of the record
//!                        └─▶ sizing: the report's formulas against what was measured, the slowest parts that would do
//! ```
//!
//! [`Rehearsal`] is a mission on the hybrid machine without its pictures. [`Rehearsed`] is the same for any generator
//! whose frames take time. `docs/timing.md` says what each figure means.

mod changed;
pub mod columns;
mod critical_path;
mod error;
mod idle_delays;
mod levels;
mod misses;
mod moved;
mod overload;
mod plots;
mod rehearsal;
mod rehearsed;
mod routines;
mod sets;
mod show;
pub mod sizing;
mod timeline;

pub use changed::changed_pixels;
pub use error::DeadlineError;
pub use moved::first_moved;
pub use overload::OverloadMap;
pub use plots::{write_slack, write_utilisation};
pub use rehearsal::{Rehearsal, first, spread};
pub use rehearsed::{Other, Rehearsed, lines_of};
pub use routines::{Routine, routines_text};
pub use show::Deadlines;
pub use timeline::{TimelineOf, write_timeline};
