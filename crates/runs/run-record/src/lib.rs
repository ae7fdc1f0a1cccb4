//! The record of a run, as it is written and read: one set of types.
//!
//! ```text
//! run.json         RunRecord: program, inputs, world, view, settings of the generator, frames, outputs
//! truth/truth.json TruthRecord: the same world and view, planes and their conventions, frames
//! ```
//!
//! Records are equal for equal inputs: they hold no clock, no thread and no folder. Units stand in the keys. Clocks are
//! exact fractions in words, because a float would round them.
//!
//! - [`RunRecord`], [`RunRecord::read`]: the record of a run. [`FrameRecord`]: a frame in it.
//! - [`ViewRecord`], [`GroundRecord`], [`SceneryRecord`]: what was drawn, for any generator.
//! - [`TruthRecord`]: the record of the truth.
//! - [`Inputs`], [`FileRecord`]: the files that a run was made from.
//! - [`sealed`], [`is_as_sealed`]: the hash at the end of a record, which tells whether the record was changed.

mod channel;
mod differences;
mod file;
mod frame;
mod ground;
mod inputs;
mod mission;
mod omission;
mod run;
mod scenery;
mod seal;
mod shard;
mod sky;
mod truth;
mod view;

pub use channel::ChannelRecord;
pub use differences::{differences, differences_of};
pub use file::{FileRecord, MAX_BYTES, file_hash, hash, stays_inside};
pub use frame::{FrameRecord, total_work};
pub use ground::{AlbedoMapRecord, GroundRecord, LevelRecord};
pub use inputs::{Inputs, ModelRecord, ModelValue};
pub use mission::{LimitRecord, PathRecord, SunRecord, VehicleRecord};
pub use omission::{OmissionRecord, WeightRecord};
pub use run::{
    CheckRecord, CheckedSweep, ErrorRecord, PicturesRecord, Program, RUN_FORMAT, RUN_SCHEMA, RecordError,
    RunRecord, ScenarioRecord,
};
pub use scenery::{SceneryRecord, hash_of};
pub use seal::{is_as_sealed, sealed};
pub use shard::ShardRecord;
pub use sky::{PhaseRecord, PlaceRecord, SeenRecord, SkyRecord};
pub use truth::{TRUTH_SCHEMA, TruthFrame, TruthRecord};
pub use view::{DisplayRecord, LevelsRecord, ShadowsRecord, ViewRecord, YokeRecord};
