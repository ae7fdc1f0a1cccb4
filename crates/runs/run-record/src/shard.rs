//! The shard that a run is.

use serde::{Deserialize, Serialize};

/// Which part of a larger run a worker drew. It decides no pixel.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ShardRecord {
    /// Number of the shard and of all shards, as `3/7`.
    pub shard: String,
    /// Law by which the frames were shared out: "count" or "cost".
    pub by: String,
    /// First frame of the whole run, and the frame behind its last.
    pub of: [u64; 2],
    /// Words of the command that draws the whole run, behind `lunoid replay`, without its folder.
    pub words: Vec<String>,
}
