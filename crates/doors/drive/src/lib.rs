//! A scenario opened in a program: what the command draws, tells and records, as values.
//!
//! ```text
//! scenario, wishes ─▶ Drive ─┬─ frame n, pose ─▶ Viewpoint ─┬──────────▶ Seen     picture and pose
//!                            │                      ▲       ├─ names ──▶ Truth    exact planes, each with its bound
//!                            │                      │       ├─ globs ──▶ Traces   signals of sweeps
//!                            │                      │       ├─ pixel ──▶ Explained
//!                            │                      │       ├─ sweeps ─▶ Events   digital events
//!                            │                      │       ├─ condition ─▶ Triggered   places where it is met
//!                            │                      │       ├──────────▶ FrameTiming   deadlines, and those that were not met
//!                            │                      │       └─ late word ─▶ LateWordsEffect   pixels that it changed
//!                            └─▶ Loop ─ last frame ─┘
//!                                 ├─ pose ─▶ Seen ─▶ your controller ─▶ pose ...
//!                                 └─▶ saved: a scenario and a path, which `lunoid replay` draws again
//! ```
//!
//! # Law
//! - A [`Drive`] has the defaults and the bits of the command. It holds no law of its own: every value comes from the crate that the
//!   command calls for it.
//! - A [`Loop`] drives one frame a pose. Frame n is n over the update rate after the start. Generators with memory between frames have the
//!   poses that were driven before. Where a generator lacks that memory the call is an error.
//! - What a loop has driven is saved as a scenario whose `path.driven` is one row a frame. Its replay has the same pixels.
//! - An error tells all faults at once ([`DriveError`]).
//!
//! # See also
//! `docs/python.md`: the same from Python. `front-door`: scenario, model and wishes. `replay`: runs in folders.

mod bench;
mod built;
mod closed_loop;
mod digital;
mod error;
mod explained;
mod identity;
mod late;
mod open;
mod parameters;
mod placed;
mod pose;
mod saved;
mod seen;
#[cfg(feature = "studies")]
mod studied;
mod threads;
mod timed;
mod traces;
mod triggered;
mod truth;
mod viewpoint;
mod wires;

pub use closed_loop::Loop;
pub use digital::{EventWishes, Events};
pub use error::{DriveError, Fault};
pub use event_list::Filter;
pub use explained::Explained;
pub use front_door::Wishes;
pub use generator::{Fact, FrameCounts, Omission, PlaneKind, Weight};
pub use hardware_model::Economy;
pub use late::LateWordsEffect;
pub use machine::Link;
pub use open::{Drive, Raster};
pub use parameters::Parameter;
pub use placed::{Flight, Place, Unplaced};
pub use pose::EyePose;
pub use run_record::Program;
pub use saved::SavedFile;
pub use scenario::Scalar;
pub use seen::Seen;
#[cfg(feature = "studies")]
pub use studied::Study;
pub use timed::{DeadlineCount, FrameTiming};
pub use traces::{Trace, Traces};
pub use triggered::{TriggerPlace, TriggerWishes, Triggered};
pub use truth::{Codes, Truth, TruthPlane};
pub use viewpoint::Viewpoint;
pub use wires::{BlockRow, FaultRow, SignalRow};
