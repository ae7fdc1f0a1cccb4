//! Data sets for learning: labelled frames whose every draw is a function of seed and number.
//!
//! ```text
//! plan ─▶ Plan ─┬─ number ─▶ Wanted ─▶ Maker ─▶ Made: arrays and row ─┐
//!               │     split, frame, keys; pose by attempts            ▼
//!               └─ range of numbers ─▶ Job ───────────────────▶ folder: samples, manifest, card, record
//!                                       folders of shards ─▶ join ────┘
//! ```
//!
//! # Law
//! - **Numbers.** Sample n has combination n modulo the number of combinations of scenario, machine and fault; the fault changes first. More
//!   draws add samples behind those that are there.
//! - **Draws.** A draw is the BLAKE3 of seed, sample, attempt and the name of the quantity: 53 bits of it are a number of 0..1. A quantity that
//!   is added changes no other. Attempts count for the pose alone.
//! - **Splits.** The split of a sample is drawn first, by the shares. Ground is cut into square blocks; the hash of seed and block gives each to one
//!   split, whatever scenario it is of. A pose is taken where all ground within the reach is of the sample's split.
//! - **Poses.** The vehicle stands by its own law (`scenario::Vehicle`), no steeper than it climbs. A pose that is refused is drawn again with the
//!   next attempt, and counted by its reason. After [`MOST_ATTEMPTS`] the sample is an error.
//! - **Ground of others.** Beyond the reach a picture may show ground of another split. It is measured on the truth's ranges, marked in the plane
//!   `split` and counted in the row.
//! - **Bytes.** A folder is a function of plan, program and range. Threads, interruptions and shards change nothing.
//!
//! # Our choices
//! - A sample is a single look. Of a machine that shows frames before its own it is the first picture of a drive.
//! - Healthy and faulty machine are compared at the same place, each with its own yoke.
//!
//! # See also
//! `docs/dataset-plan.md`: the plan, the folder and the loaders. Crate `drive`: a scenario opened in a program.

mod arrays;
mod card;
mod check;
mod draws;
mod error;
mod estimate;
mod finish;
mod folder;
mod join;
mod looks;
mod plan;
mod record;
mod row;
mod run;
mod sample;
mod splits;
mod written;

pub use arrays::read_array;
pub use draws::{Counter, Draw};
pub use error::DatasetError;
pub use estimate::Estimate;
pub use folder::{CARD, DataFolder, JOURNAL, LOADERS, MANIFEST, PLAN, RECORD, SHEET};
pub use join::{Joined, is_data_set, join};
pub use plan::{Combination, Fault, FlightDraws, KeyDraw, Plan, PoseDraws, Wanted};
pub use record::{MadeFrom, PlanRecord, Record, SCHEMA};
pub use row::{GroundSeen, PoseLabel, Row};
pub use run::{Job, Outcome, run};
pub use sample::{MOST_ATTEMPTS, Made, Maker};
pub use splits::{Split, Splits};
pub use written::FORMAT;
