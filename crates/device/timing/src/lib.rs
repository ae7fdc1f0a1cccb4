//! Timing records: what the digital side did and when, and baselines to hold it to (hardware report, sections 4, 5).
//!
//! ```text
//! control plane ─▶ FrameTiming, a frame ─┬─▶ TimingRecord ─┬─▶ tables, numbers for plots
//!    sweeps ─▶ EventHash, joined in order ┘                 ├─▶ JSON under version control ─┐ baseline
//!                                                           └─▶ compare ◀───────────────────┘
//!                                                                  └─▶ Comparison: diff, JSON, JUnit XML, met or not
//! ```
//!
//! **Law.** Slack = due - ready, in master ticks; below 0 is missed, 0 is met. Utilisation = time at work over length
//! of the frame. Two records agree if everything digital is the same to the last bit (counters, slack, bins, queues,
//! hash of the ordered events) and everything analog (instants on the sweep clock, ground ranges) is within a
//! [`Tolerance`].
//! A frame may tell its work [`Task`] by task; a record without deadlines is of a program, which takes the time that it takes.
//! **State and timing.** Data without a clock of their own. A record says nothing of when, where or how fast it was
//! made: the same inputs give the same bytes.
//! **Events.** [`EventHash`] depends on the order of events. Sweeps are hashed apart, on any thread, and joined in
//! their order.
//! **Files.** JSON, one line for a counter, a slack, a unit or a miss, so that a change of one is a change of one line.
//! [`read`] refuses another format, damage, and records that do not [hold together](TimingRecord::check).
//! **Our choices.** Sixteen bins of slack between powers of two near the decades of a tick. A miss is the same miss if
//! frame, sweep, fold, deadline, colour, register, part and crater are; what else has changed of it is told value by value. A
//! difference of scenario, machine, inputs or clock is told before all others: such a baseline is of another run.
//! **Not modelled.** What is late in the picture; a record has the sweep, the fold and the range that lead there.
//!
//! ```
//! let mut slack = timing::Slack::default();
//! [40, 0, -3].into_iter().for_each(|ticks| slack.add(ticks));
//! assert_eq!((slack.count, slack.missed, slack.least), (3, 1, Some(-3)));
//! ```

mod allowance;
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
mod level_change;
mod missed;
mod plot;
mod record;
mod task;
mod text;
mod totals;

pub use allowance::{Allowance, AllowanceError, Allowed, NoSuchDeadline};
pub use check::Fault;
pub use comparison::{Comparison, MovedEvent, Tolerance, ToleranceError, compare};
pub use deadline::{BINS, Deadline, Slack};
pub use difference::Difference;
pub use event_hash::EventHash;
pub use file::{RecordError, read, write};
pub use level_change::LevelChange;
pub use missed::{Cause, Missed};
pub use record::{FORMAT, FrameTiming, Sets, TimingRecord, UnitUse, Vertices};
pub use task::Task;
pub use totals::{DeadlineTotals, Totals, UnitTotals};
