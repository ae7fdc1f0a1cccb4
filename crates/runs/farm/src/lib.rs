//! How far the shards of a run are, from what their folders say.
//!
//! ```text
//! FOLDER/full-drive-shard-1-of-7/   record, journal, lock ─┐
//! FOLDER/full-drive-shard-2-of-7/                          ├─▶ state of each shard ─▶ frames done, rate, time left
//! FOLDER/full-drive-shard-3-of-7.failed.json               ┘
//! ```
//!
//! # Law
//! - A shard is a folder whose name ends in `shard-K-of-N`, as `replay --shard` names it. Shards with the same words before that, and the
//!   same N, are those of one run.
//! - A shard is *running* while a process holds the lock of its folder; else *done* if its record is there, with the truth that its
//!   command asks for; else *failed* if a note of failure lies beside it or a file of it cannot be read; else *stale* if it has a folder;
//!   else *waiting*.
//! - Frames that are done are those of the record, else those of the journal.
//! - The rate counts the pictures of the last ten minutes, over the time since the oldest of them, and over a second at least. Pictures that
//!   a join or a copy wrote are not told apart. There is a rate while a shard is running.
//!
//! Nothing is written. Asking for a lock takes it for an instant; a process that takes the lock waits that long.
//!
//! # See also
//! `docs/shards.md`; crate `merge`, which joins the shards.

mod failure;
mod name;
mod rate;
mod shards;
mod status;

pub use failure::{FAILED_SCHEMA, Failure, note_of};
pub use shards::{ShardStatus, State};
pub use status::{RunStatus, StatusError, status};
