//! What cannot be is refused: one clear error, the exit code of its kind, and nothing half-written.
//!
//! Every case runs the real command in a folder of its own. [`room::Room::refused`] holds what all refusals have in
//! common; the files here hold the classes: what people write, what stands on the ground, elevation, banks, run folders, pictures, outputs,
//! what they would replace, what is too much, attacks on folders, and runs that are killed.

mod arguments;
#[cfg(unix)]
mod attacks;
mod banks;
mod build;
mod cases;
mod control;
mod elevation;
mod extremes;
#[cfg(target_os = "linux")]
mod failing_disk;
#[cfg(unix)]
mod interrupted;
#[cfg(unix)]
mod killed;
mod landscape;
mod limits;
mod outputs;
mod pictures;
mod replaced;
mod room;
mod runs;
mod scenery;
mod written;
