//! The front door: from a scenario file, a hardware model and wishes to a generator on a stage.
//!
//! ```text
//! scenario file ─┬─▶ Scenario ──────┬─▶ Settings ─┬─▶ view ─────────────────┐
//! wishes ────────┤                  │             └─▶ hybrid machine ─┐     ├─▶ Stage ─▶ Session
//! model file ────┴─▶ HardwareModel ─┘   registry row ─▶ generator ────┤     │
//!                    Scenario ─▶ bank ─▶ landscape ─▶ scenery ────────┼─────┘
//!                                                                     └─▶ Opened
//! ```
//!
//! - [`open`]: reads everything that people write, and refuses it before any ground is made. [`Opened`] has what came of
//!   it, makes the [stage](Opened::stage), and says what [poses](Opened::poses) the frames have.
//! - [`Wishes`]: what a command line, a notebook or a page asks for over the scenario's own wishes.
//! - [`decides`]: which of wishes, scenario and model decides a key.
//! - [`Kind`]: what a TOML file is, by its keys.
//! - [`settings`], [`build`], [`over`], [`under`], [`bank`], [`landscape`](fn@landscape): the steps by themselves.

mod albedo;
mod database;
mod error;
mod extremes;
mod face_lists;
mod ground;
mod keys;
mod kind;
mod open;
mod opened;
mod overlays;
mod photographs;
mod stage;
mod together;
mod wishes;
mod written_keys;

pub use error::{OpenError, StageError, path_problems};
pub use extremes::{expect_drawable, expect_followable};
pub use ground::landscape;
pub use keys::{Decides, decides};
pub use kind::{KNOWN, Kind, read_model, read_scenario};
pub use open::{base_model, open};
pub use opened::Opened;
pub use stage::{bank, build, over, settings, under, with_course};
pub use wishes::Wishes;
