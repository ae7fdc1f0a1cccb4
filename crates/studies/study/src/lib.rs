//! Studies: error against run time, one factor at a time.
//!
//! ```text
//! subject: scenario, model, frames
//!    │
//!    ├─▶ ladders of settings ─▶ session of each rung ─▶ frames, timed in turn ─▶ seconds a frame
//!    │                                  └─▶ signals, picture ─┐
//!    └─▶ exact: profiles, pictures (kept by hash) ────────────┴▶ errors ─▶ order, Pareto fronts, advice
//! ```
//!
//! **Law.** A *ladder* changes one factor of a base setting, or a named pair of them, rung by rung. The error of a rung is
//! against `exact` under the laws of the rung; where a rung has another law than the base, its picture is held against
//! the base's law as well, so that error of parts and difference of law are two numbers. Time is the median of several
//! repetitions, and within a ladder the rungs take turns, so that a machine that slows down slows all of them.
//! **Run parameters** ([`parameter_ladder`]): the picture of a generator over a parameter of its own, where the scenario
//! names that generator.
//! **Economy** ([`economy`]): what a scene does not need, what leaving it out saves, the waste that remains. **Banks**
//! ([`regions()`]): region size of a survey against the ground. **Shadow** ([`shadow`]): the vehicle's, on flat
//! ground and on true, by every law and method.
//! **Pops** ([`pops`]): distances along the view axis, frame by frame, and what levels of detail do to them.
//! **Descents** ([`descent`]): pictures of the ways beside those curves, for a page.
//! **Levels** ([`levels`]): what levels of detail lose, against triangles and time. **Tracks** ([`tracks`]): corners that are followed
//! while levels change.
//! **Judged** ([`judged`]): pictures of a generator against those of the judge, frame by frame.
//! **Lights** ([`lights`]): the light of a lamp over a mission, in each way that a generator has to draw it.
//! **Seas** ([`sea`]): contrast and spectrum of a sea of false normals beside those of true waves.
//! **Reports** ([`report`]): what came of a study as text, as a document, and as tables and plots in a folder.
//! **Not in the time.** Reading, elaboration, shadow boundaries that are found once, encoding.
//! **Our choices.** Signals are compared on six groups of eight sweeps spread over the frame. A picture of fewer or more sweeps than the
//! base is held against the base's columns, each taken from the nearest sweep.

mod advice;
mod change;
pub mod descent;
pub mod economy;
mod figures;
mod fronts;
pub mod judged;
pub mod ladder;
pub mod levels;
pub mod lights;
mod order;
mod parameter;
pub mod polynomial;
pub mod pops;
mod reference;
mod regions;
pub mod report;
pub mod sea;
pub mod shadow;
pub mod solver;
pub mod stability;
mod subject;
mod table;
pub mod tracks;
mod work;

pub use advice::{Setting, advise};
pub use change::Change;
pub use figures::{Figures, NAMES};
pub(crate) use fronts::front;
pub use fronts::{Front, OnFront, fronts};
pub use order::{Order, fit};
pub use parameter::{Configure, parameter_ladder};
pub use reference::ExactPictures;
pub use regions::{REGION_LADDERS, regions};
pub use subject::{StudyError, Subject};
pub use table::{csv, table};
pub use work::{Effort, Rehearsed, climb};
