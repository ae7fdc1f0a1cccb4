//! The analog side of the hybrid machine: groups of eight sweeps, from programs to lines (section 24).
//!
mod feature_light;
mod group;
mod lane_gate;
mod look;
mod real_parts;
mod record;
mod scales;
mod signal_table;
mod swift;
mod wires;
mod workspace;

pub use group::Group;
pub use look::{Look, Wanted};
pub use real_parts::RealParts;
pub use record::Recorded;
pub use scales::wires;
pub use signal_table::signals;
pub use workspace::Workspace;
