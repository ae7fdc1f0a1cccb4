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
//! | 1 | `data_kind` | kinds of data that lie in banks |
//! | 1 | `squares` | squares of regions whose data are one chain of records |
//! | 0 | `stage` | ground, scenery and settings of a machine |
//! | 1 | `raster` | what the sweeps write: the screen, or more of it |
//! | 1 | `refusal` | why a frame cannot be drawn |
//! | 1 | `guests` | what a scene may have, and no block draws |
//! | 1 | `instants` | at which instants of a step a picture is evaluated |
//! | 1 | `late_words` | late words of a fold, of a crater or of a shadow boundary |
//! | 1 | `waveforms` | digital wires of a sweep, from its programs |
//! | 2 | `digital_event` | one event of the digital side |
//! | 2 | `absent` | what the storage buffers lack in a frame beside corners |
//! | 2 | `ticks` | ticks of frames and sweeps |
//! | 2 | `elaboration` | the list of blocks: which are there, which have parts, what a record says of the others |
//! | 2 | `frame_plan` | fan, eye and sun of a frame |
//! | 3 | `blocks` | blocks that are there |
//! | 3 | `feature_loads` | craters of a sweep and the loads of their words |
//! | 4 | `crossings` | sweep programs of both levels |
//! | 4 | `sight` | bodies that are near enough to be drawn |
//! | 5 | `demand` | what the frames ask their data banks for |
//! | 5 | `craters_in_sight` | craters that can be told, by groups of sweeps |
//! | 5 | `sweep_recorder` | what the service of one sweep did |
//! | 6 | `banks` | which kinds of data share drums, and what each frame gets |
//! | 7 | `digital` | what the banks lack in a frame, and what its processor has ready |
//! | 6 | `delivery` | shadow gates, polyhedra and craters of a frame |
//! | 2 | `stretches` | what a unit is at over a sweep, from stretches of ticks |
//! | 8 | `drum_waveforms` | digital wires of the drums over a sweep |
//! | 8 | `processor_waveforms` | the same of the central processor |
//! | 8 | `loader_waveforms` | the same of what serves the crossings |
//! | 9 | `bank_waveforms` | the same of channels, I/O processors of the banks, storage buffers |
//! | 10 | `state_wires` | all of these wires: which there are, and what each does |
//! | 8 | `control_plane` | what all frames of a stage share |
//! | 9 | `before_mission` | tasks before frame 0 |
//! | 9 | `frame_sweeps` | the sweeps of one frame |
//! | 10 | `load_miss` | loads of craters and shadow boundaries whose words came late |
//! | 10 | `event_list` | all events of a sweep or a frame |
//! | 10 | `register_state` | registers at an instant |
//! | 10 | `timing_record` | the timing record of a frame |
//! | 11 | `timed` | the control plane as a job that takes time; hash of what decides its timing |

mod absent;
mod bank_waveforms;
mod banks;
mod before_mission;
mod blocks;
mod control_plane;
mod craters_in_sight;
mod crossings;
mod data_kind;
mod delivery;
mod demand;
mod digital;
mod digital_event;
mod drum_waveforms;
mod elaboration;
mod event_list;
mod feature_loads;
mod frame_plan;
mod frame_sweeps;
mod guests;
mod instants;
mod late_words;
mod load_miss;
mod loader_waveforms;
mod processor_waveforms;
mod raster;
mod refusal;
mod register_state;
mod sight;
mod squares;
mod stage;
mod state_wires;
mod stretches;
mod sweep_recorder;
mod ticks;
mod timed;
mod timing_record;
pub mod waveforms;

pub use absent::{Absent, AbsentCrater};
pub use banks::{BankDemand, Supplied};
pub use blocks::{Blocks, Coarse, Shadows};
pub use control_plane::ControlPlane;
pub use crossings::Crossings;
pub use data_kind::DataKind;
pub use delivery::{Delivery, ShadowBoundary, Supply, view_plane};
pub use digital::{Digital, DigitalFrame, Surroundings};
pub use digital_event::{DigitalEvent, DigitalUnit, EventWord, LoadedPart};
pub use dpu::Register;
pub use elaboration::{Block, Elaboration};
pub use feature_loads::FeatureLoads;
pub use frame_plan::FramePlan;
pub use frame_sweeps::FrameSweeps;
pub use guests::guest_omissions;
pub use instants::instants_obstacle;
pub use late_words::{LateOf, LateWords};
pub use load_miss::LoadMiss;
pub use raster::WrittenRaster;
pub use register_state::{RegisterState, RegisterWords};
pub use sight::vertices;
pub use squares::SquareGrid;
pub use stage::{MachineStage, RANGE, scan};
pub use state_wires::{STATE_WIRES, has_state, is_state, state_changes};
