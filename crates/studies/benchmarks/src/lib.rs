//! What a frame costs: in time (`cargo bench -p benchmarks`, the binary `speed`) and in instructions (the binary
//! `instructions`).
//!
//! `docs/measuring.md` says how to read the figures. The scenes are shipped ones, so that the figures are of pictures that
//! one can look at.
//!
//! - [`TimedScene`]: a shipped scenario made ready, and the pose of its first frame.
//! - [`ROWS`], [`frame_times`]: frames whose time `speed` tells, and how they are timed.
//! - [`around`]: what stands before and between frames: ground, shadow boundaries, a survey, whole missions.
//! - [`chain`]: an analog chain by exact steps and by ngspice, held against each other by the binary `goals`.
//! - [`mesh`]: the ground of a scene drawn by a ray tracer, held against the machine by the same binary.
//! - [`peers`]: programs of other people that do the same work, held against the machine by the same binary.
//! - [`startup`]: a large problem area prepared in a folder, and what it takes to begin with it.
//! - [`LADDERS`]: scenes that grow in one thing, timed by the binary `scaling`.
//! - [`KERNELS`]: named pieces of work, each of which can be run by itself.
//! - [`instructions_of`]: how many instructions a kernel takes, counted by callgrind, within [`counted`] alone.
//! - [`Baseline`]: counts of a build that later ones are held against.

pub mod around;
mod baseline;
mod callgrind;
pub mod chain;
mod frames;
mod kernels;
mod ladder;
pub mod mesh;
pub mod peers;
mod rows;
mod scene;
pub mod startup;

pub use baseline::{Baseline, BaselineError, Circumstances, Difference};
pub use callgrind::{Count, CountError, counted, instructions_of};
pub use frames::{FrameTimes, frame_times};
pub use kernels::{KERNELS, Kernel, Work, kernel};
pub use ladder::{BASE, LADDERS, Ladder, Size};
pub use rows::{REAL_TIME, ROWS, Row, STANDARD};
pub use scene::{Choice, TimedScene};
