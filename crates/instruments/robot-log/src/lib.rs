//! A finished run as a robot log (MCAP) and as OpenEXR files, for viewers and readers of the robotics and film worlds.
//!
//! Both follow from the run folder and the path alone: pictures and truth are read from the folder and held against their hashes.
//! So an interrupted run resumes as `replay` does, a shard has a log of its own frames, and equal runs give equal bytes.
//!
//! ```text
//! run folder (pictures, truth) ─┬─▶ write_mcap: one log, topics below
//! path (poses) ─────────────────┼─▶ write_exr:  exr/frame-000000.exr, one file a frame
//! digital side (late words) ────┘
//! ```
//!
//! | module | what it does |
//! |---|---|
//! | `finished` | reads pictures and truth of a frame |
//! | `axes` | turns poses of the program into right-handed axes and quaternions |
//! | `depth` | distance along the ray to depth along the axis of view |
//! | `clock` | simulated time in nanoseconds |
//! | `late` | late words of a frame of the hybrid machine |
//! | `messages`, `mcap_file` | the log (feature `mcap`) |
//! | `exr_file` | the OpenEXR files (feature `exr`) |
//! | `form`, `absent` | which of both this build has, and what it says without |
//!
//! # Axes
//! `site`: x east, y north, z up, from the origin of the program's map. `vehicle`: x forward, y to port, z up, with its origin at the
//! eye. `camera`: x right, y down, z along the axis of view, with the same origin.
//!
//! # See also
//! `docs/robot-logs.md`

mod axes;
mod clock;
mod depth;
mod error;
mod finished;
mod form;
mod late;
mod outcome;
mod truth_of_log;

#[cfg(not(all(feature = "mcap", feature = "exr")))]
mod absent;
#[cfg(feature = "exr")]
mod exr_file;
#[cfg(feature = "mcap")]
mod mcap_file;
#[cfg(feature = "mcap")]
mod messages;

#[cfg(not(feature = "exr"))]
pub use absent::write_exr;
#[cfg(not(feature = "mcap"))]
pub use absent::{expect_own_log, write_mcap};
pub use axes::{Placement, camera_in_vehicle, vehicle_in_site};
pub use clock::nanoseconds;
pub use depth::depth;
pub use error::LogError;
#[cfg(feature = "exr")]
pub use exr_file::write_exr;
pub use finished::{FinishedRun, FrameFiles};
pub use form::{EXR_IN_THIS_BUILD, Form, MCAP_IN_THIS_BUILD};
pub use late::{LateWord, LateWords};
#[cfg(feature = "mcap")]
pub use mcap_file::{expect_own_log, write_mcap};
pub use outcome::Outcome;
pub use truth_of_log::{TRUTH_OF_LOG, expect_truth_of_log};
