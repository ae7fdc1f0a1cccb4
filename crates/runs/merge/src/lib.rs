//! Shards of a run into one run.
//!
//! ```text
//! run folder of shard 1/3 ─┐
//! run folder of shard 3/3 ─┼─▶ one run? ─▶ gaps? ─▶ hashes ─▶ the run folder of one machine
//! run folder of shard 2/3 ─┘   refused     listed   refused
//! ```
//!
//! # Law
//! - The order of the folders changes nothing.
//! - Folders are joined if their records are equal in everything but what depends on the frames: frames, range, shard, totals,
//!   limits, check, outputs. Else the first difference is named, with both files.
//! - A frame that several folders have must have one record, hash for hash. Else the frame is named, with both files.
//! - The whole run is the range asked for; else the smallest range that holds every folder's frames, and every run that a folder
//!   is a shard of. Frames of the range that no folder has are gaps, and nothing is joined.
//! - Every file of every folder is read and hashed before anything is written, and files are known by their hashes alone.
//! - Totals are summed over the frames by the counters of the generator. Stretches beyond a limit of the vehicle are joined where
//!   one ends at the frame where the next begins. Tables of poses are joined row by row. Contact sheet and film are made from the
//!   pictures. A check is over the sweeps of a whole run, and is left out.
//! - `run.json`, the frames, what follows from them, and the truth are then those of one machine, byte for byte. Wall times are no
//!   part of a record: `performance.json` is not joined.
//!
//! Timing records are joined alike: the same record but for its frames, the same timing of a frame that several have, gaps.
//!
//! Each thread has one file in memory. The records of all frames are held, as `replay` holds them.
//!
//! # See also
//! `docs/shards.md`; crate `shard`, which shares the frames out; `replay::JoinedRun`, which writes the folder.

mod error;
mod frames;
mod gaps;
mod join;
mod limits;
mod rows;
mod same;
mod source;
mod timings;
mod truth;
mod verify;

pub use error::MergeError;
pub use gaps::Gap;
pub use join::{Joined, Merge, Outcome, merge};
pub use timings::{Timings, merge_timings};
