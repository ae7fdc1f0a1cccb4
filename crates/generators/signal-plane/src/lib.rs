//! The analog side of the hybrid machine: groups of eight sweeps, from programs to lines (section 24).
//!
//! ```text
//! programs ▶ TG ▶ FG ▶ texture ▶ gates ▶ MU ▶ DPP ▶ SM ▶ VS3 ▶ lines
//! ```
//!
//! [`Group::run`] is the order of the report's overall figure. Under the economy `Instants` a machine whose terrain generators
//! alone may have parts takes a shorter way (`preview`). Where a model says so, what leaves TG, FG and MU comes through output
//! amplifiers (`output_amplifiers`). The code is generic over the scalar and compiled where the scalar is chosen: in `machine`.
//!
//! # Modules
//!
//! A module imports only from modules of lower floors (`tests/house/modules.rs` reads this table).
//!
//! | floor | module | what it holds |
//! |---|---|---|
//! | 1 | `signal_table` | every signal that the machine can record |
//! | 1 | `feature_light` | light of the features |
//! | 1 | `lane_gate` | a gate over one sweep |
//! | 1 | `drawing` | samples of a picture, where they are more than the steps |
//! | 2 | `scales` | wires of an elaborated machine, and what full scale means on them |
//! | 3 | `output_amplifiers` | output amplifiers of the main signals |
//! | 4 | `real_parts` | blocks made of parts |
//! | 4 | `workspace` | buffers of one worker |
//! | 5 | `group` | a group of sweeps, block after block |
//! | 6 | `preview` | the same at the samples alone |
//! | 6 | `record` | waveforms of a group that has run |
//! | 7 | `look` | who looks at a group: a probe, or nobody |

mod drawing;
mod feature_light;
mod group;
mod lane_gate;
mod look;
mod output_amplifiers;
mod preview;
mod real_parts;
mod record;
mod scales;
mod signal_table;
mod workspace;

pub use drawing::Drawing;
pub use group::Group;
pub use look::{Look, Wanted};
pub use real_parts::RealParts;
pub use record::Recorded;
pub use scales::wires;
pub use signal_table::signals;
pub use workspace::Workspace;
