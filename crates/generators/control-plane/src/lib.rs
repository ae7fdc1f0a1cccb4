//! The digital side of the hybrid machine: what the sweeps of a frame are, before any of them is drawn (section 24).
//!
//! ```text
//! pose ▶ FramePlan ▶ folds ▶ DPU ▶ sweep programs, one a level ──▶ signal plane
//!                      │       └▶ what it did ▶ timing record, list of events, registers at an instant
//!                      ├▶ data banks, processor: corners and set-ups that are ready
//!                      └▶ deliveries: shadow gates, polyhedra, craters ──▶ signal plane
//! ```
//!
//! [`MachineStage`] is what a machine is made for: ground, scenery and settings. [`ControlPlane`] is the digital side of a
//! stage, and [`FrameSweeps`] that of one frame. Nothing here knows a signal's value.
//!
//! # Modules
//!
//! A module imports only from modules of lower floors (`tests/house/modules.rs` reads this table).
//!
//! | floor | module | what it holds |
//! |---|---|---|
//! | 1 | `stage` | ground, scenery and settings of a machine |
//! | 1 | `raster` | what the sweeps write: the screen, or more of it |
//! | 1 | `refusal` | why a frame cannot be drawn |
//! | 1 | `guests` | what a scene may have, and no block draws |
//! | 1 | `digital_event` | one event of the digital side |
//! | 1 | `preview` | what keeps a machine from drawing a preview |
//! | 1 | `late_crossing` | one fold that found words missing |
//! | 1 | `waveforms` | digital wires of a sweep, from its programs |
//! | 2 | `ticks` | ticks of frames and sweeps |
//! | 2 | `elaboration` | the list of blocks: which are there, which have parts, what a record says of the others |
//! | 2 | `frame_plan` | fan, eye and sun of a frame |
//! | 3 | `blocks` | blocks that are there |
//! | 3 | `feature_loads` | craters of a sweep and the loads of their words |
//! | 4 | `crossings` | sweep programs of both levels |
//! | 4 | `sight` | bodies that are near enough to be drawn |
//! | 5 | `craters_in_sight` | craters that can be told, by groups of sweeps |
//! | 5 | `sweep_recorder` | what the service of one sweep did |
//! | 6 | `digital` | data banks and processor of a frame |
//! | 6 | `delivery` | shadow gates, polyhedra and craters of a frame |
//! | 7 | `drum_waveforms` | digital wires of the drums over a sweep |
//! | 7 | `control_plane` | what all frames of a stage share |
//! | 8 | `before_mission` | tasks before frame 0 |
//! | 8 | `frame_sweeps` | the sweeps of one frame |
//! | 9 | `event_list` | all events of a sweep or a frame |
//! | 9 | `register_state` | registers at an instant |
//! | 9 | `timing_record` | the timing record of a frame |
//! | 10 | `timed` | the control plane as a job that takes time; hash of what decides its timing |

mod before_mission;
mod blocks;
mod control_plane;
mod craters_in_sight;
mod crossings;
mod delivery;
mod digital;
mod digital_event;
mod drum_waveforms;
mod elaboration;
mod event_list;
mod feature_loads;
mod frame_plan;
mod frame_sweeps;
mod guests;
mod late_crossing;
mod preview;
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
pub use crossings::Crossings;
pub use delivery::{Delivery, Supply};
pub use digital::{Digital, DigitalFrame};
pub use digital_event::{DigitalEvent, DigitalUnit, EventWord, LoadedPart};
pub use dpu::Register;
pub use drum_waveforms::{DRUM_WIRES, drum_changes, drum_of};

pub use elaboration::{Block, Elaboration};
pub use feature_loads::FeatureLoads;
pub use frame_plan::FramePlan;
pub use frame_sweeps::FrameSweeps;
pub use guests::guest_omissions;
pub use late_crossing::LateCrossing;
pub use preview::preview_obstacle;
pub use raster::WrittenRaster;
pub use register_state::{RegisterState, RegisterWords};
pub use sight::vertices;
pub use stage::{MachineStage, RANGE, scan};
