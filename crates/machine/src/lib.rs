//! The hybrid machine: elaboration, control plane, signal plane (fig. 14; section 24).
//!
//! ```text
//!  control plane                         signal plane, eight sweeps side by side
//!  pose ▶ fan ▶ ramps ▶ folds ▶ DPU ────▶ TG, fine and coarse ─▶┐
//!                craters ▶ schedule ────▶ FG ──────────────────▶┤
//!  shadow bank ▶ segments ▶ SC gates ──────────────────────────▶┼▶ MU ▶ DPP ▶ SM ▶ VS3 ▶ [sweep, line] ▶ read-out
//!                                         TXG ─────────────────▶┘          ▲ hold   ▲              (yoke)
//!  bodies ▶ project ▶ spans ───────────────────────────────────────────────┴─ PG ───┘
//! ```
//!
//! Under the economy `Swift` a machine whose terrain generators alone may have parts takes a shorter way (`swift`).
//!
//! Where a model says so, what leaves TG, FG and MU comes through output amplifiers (`wires`).
//!
//! Only this crate knows who is wired to whom. [`HybridMachine`] elaborates a stage: the scalar type is chosen,
//! tables over the sweep are made, and blocks without work are left out (`blocks.rs`, `omissions.rs`). After that a
//! frame is: what its I/O processors bring (`delivery.rs`), programs for every sweep (`control_plane.rs`), profiles
//! and lines (`signal_plane.rs`), one read-out.
//!
//! The unit of work is a group of eight sweeps, whatever the number of threads, and nothing survives from one
//! group to the next: any frame can be made alone, by any number of threads, with the same bits.

mod before_mission;
mod blocks;
mod control_plane;
mod counts;
mod craters_in_sight;
mod crossings;
mod delivery;
mod digital;
mod elaboration;
mod event_list;
mod feature_light;
mod feature_loads;
mod frame_sweeps;
mod lane_gate;
mod look;
mod omissions;
mod picture;
mod pool;
mod raster;
mod real_parts;
mod record;
mod refusal;
mod register_state;
mod residue;
mod session;
mod settings_record;
mod sight;
mod signal_plane;
mod stage;
mod sweep_recorder;
mod swift;
mod timed;
mod timing;
mod unprobed;
mod wires;
mod workspace;

pub use counts::COUNTERS;
pub use elaboration::HybridMachine;
pub use event_list::{DigitalEvent, DigitalUnit, EventWord, LoadedPart, Register};
pub use frame_sweeps::FrameSweeps;
pub use record::{RANGE, signals};
pub use register_state::{RegisterState, RegisterWords};
pub use stage::MachineStage;
pub use timing::ControlPlane;
pub use unprobed::prepare_unprobed;
