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

mod counts;
mod hybrid_machine;
mod omissions;
mod picture;
mod pool;
mod prepare;
mod residue;
mod session;
mod settings_record;
mod unprobed;

pub use counts::COUNTERS;
pub use hybrid_machine::HybridMachine;
pub use prepare::Prepare;
pub use unprobed::prepare_unprobed;

// The command still asks the machine for what the planes hold.
pub use control_plane::{
    ControlPlane, DigitalEvent, DigitalUnit, EventWord, FrameSweeps, LoadedPart, MachineStage, RANGE,
    Register, RegisterState, RegisterWords,
};
pub use signal_plane::signals;
