//! The digital side of the hybrid machine: what the sweeps of a frame are, before any of them is drawn (section 24).
//!
mod before_mission;
mod blocks;
mod control_plane;
mod craters_in_sight;
mod crossings;
mod delivery;
mod digital;
mod digital_event;
mod event_list;
mod feature_loads;
mod frame_plan;
mod frame_sweeps;
mod guests;
mod ideal;
mod raster;
mod refusal;
mod register_state;
mod sight;
mod stage;
mod sweep_recorder;
mod ticks;
mod timed;
mod timing_record;
pub mod waveforms;

pub use blocks::{Blocks, Coarse, Shadows};
pub use control_plane::ControlPlane;
pub use craters_in_sight::CratersInSight;
pub use crossings::Crossings;
pub use delivery::{Delivery, Supply};
pub use digital::{Digital, DigitalFrame};
pub use digital_event::{DigitalEvent, DigitalUnit, EventWord, LoadedPart, Register};

pub use feature_loads::FeatureLoads;
pub use frame_plan::FramePlan;
pub use frame_sweeps::FrameSweeps;
pub use guests::guest_omissions;
pub use ideal::{beam_has_parts, mixing_has_parts};
pub use raster::WrittenRaster;
pub use register_state::{RegisterState, RegisterWords};
pub use sight::vertices;
pub use stage::{MachineStage, RANGE, scan};
