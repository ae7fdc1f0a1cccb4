//! Which part of a run a worker does: shard K of N, as a block of frames.
//!
//! ```text
//! "3/7", or the environment of a job ──▶ Shard ──┐
//! frames of the run, perhaps their costs ────────┴──▶ block of frames
//! ```
//!
//! # Law
//! - Shards are numbered from 1. The blocks of all shards are the frames of the run, each once, in order.
//! - *By count*: of L frames, shard K of N has frames `⌊(K-1) L / N⌋` to `⌊K L / N⌋`, without the last. Two blocks differ by at
//!   most one frame.
//! - *By cost*: the cut between shards K and K+1 lies where the costs before it sum up to `K / N` of all costs, rounded to the
//!   nearest frame; of two cuts as near, the earlier. A frame costs at least 1, and every shard has at least one frame.
//! - A block is a function of the shard, the frames and the costs. Every worker works out the same blocks.
//! - More shards than frames are refused: no shard is empty.
//!
//! # See also
//! `docs/shards.md`; crate `merge`, which joins what the workers did.

mod blocks;
mod environment;
mod error;
mod number;

pub use blocks::{block_by_cost, block_by_count};
pub use environment::{SHARDS, from_environment};
pub use error::ShardError;
pub use number::Shard;
