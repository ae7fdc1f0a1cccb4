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
//! Only this crate knows who is wired to whom. [`HybridMachine`] elaborates a stage: the scalar type is chosen,
//! tables over the sweep are made, and blocks without work are left out (`omissions.rs`). After that a frame is: what its
//! I/O processors bring and programs for every sweep (crate `control-plane`), profiles and lines (crate `signal-plane`), one
//! read-out.
//!
//! The unit of work is a group of eight sweeps, whatever the number of threads, and nothing survives from one
//! group to the next: any frame can be made alone, by any number of threads, with the same bits.
//!
//! # Modules
//!
//! A module imports only from modules of lower floors (`tests/house/modules.rs` reads this table).
//!
//! | floor | module | what it holds |
//! |---|---|---|
//! | 1 | `again` | some sweeps of a frame drawn without a look at any signal |
//! | 1 | `counts` | what a frame takes |
//! | 1 | `omissions` | what the elaborated machine leaves out |
//! | 1 | `pool` | buffers that are used again |
//! | 1 | `residue` | pictures as they were written, for a tube |
//! | 1 | `wiring` | which block drives which |
//! | 2 | `picture` | a picture while it is written |
//! | 3 | `elaborated` | the machine of a stage: its tables, and what the groups of a frame share |
//! | 4 | `groups` | the groups of a frame |
//! | 4 | `tube` | how pictures are read, and what a tube has left of earlier ones |
//! | 5 | `display` | pictures that were read, and what the picture tube shows of them |
//! | 5 | `lights` | light points of a frame, and what a second beam draws of them |
//! | 6 | `session` | a frame, from its pose to its planes |
//! | 6 | `on_time` | a frame twice: as it is, and with late words on time |
//! | 6 | `resumed` | what a machine remembers at the start of a sweep, and how it goes on |
//! | 7 | `prepare` | from a stage to a session |
//! | 7 | `unprobed` | the machine without probes |
//! | 8 | `hybrid_machine` | the machine as a generator |

mod again;
mod counts;
mod display;
mod elaborated;
mod groups;
mod hybrid_machine;
mod lights;
mod omissions;
mod on_time;
mod picture;
mod pool;
mod prepare;
mod residue;
mod resumed;
mod session;
mod tube;
mod unprobed;
mod wiring;

pub use counts::COUNTERS;
pub use hybrid_machine::HybridMachine;
pub use on_time::{OnTime, Twice, prepare_twice};
pub use prepare::Prepare;
pub use resumed::{Memory, Resumes, Sizes, prepare_resumes};
pub use unprobed::prepare_unprobed;
pub use wiring::{LINKS, Link};

// The command still asks the machine for what the planes hold.
pub use control_plane::{
    BankDemand, ControlPlane, DataKind, DigitalEvent, DigitalUnit, EventWord, FrameSweeps, LateOf, LateWords,
    LoadMiss, LoadedPart, MachineStage, RANGE, Register, RegisterState, RegisterWords,
};
pub use picture_tube::SIGNALS as LINE_SIGNALS;
pub use signal_plane::signals;
