//! Why there is no shard.

/// A shard that cannot be had.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ShardError {
    /// The words name no shard.
    #[error("expected K/N with 1 <= K <= N, as 3/7, or auto, not `{0}`")]
    NoShard(String),
    /// The environment is that of no job whose parts are numbered.
    #[error(
        "found neither SLURM_ARRAY_TASK_ID nor JOB_COMPLETION_INDEX in the environment; run this in a Slurm array or an indexed \
         Kubernetes job, or name the shard: --shard 3/7"
    )]
    NoJob,
    /// The environment is that of two engines.
    #[error(
        "found both SLURM_ARRAY_TASK_ID and JOB_COMPLETION_INDEX in the environment; unset one of them, or name the shard: --shard 3/7"
    )]
    TwoJobs,
    /// A variable of the environment that is not there.
    #[error("found no {name} in the environment; set it to {meaning}, or name the shard: --shard 3/7")]
    Missing {
        /// Name of the variable.
        name: &'static str,
        /// What the variable should hold, in words.
        meaning: &'static str,
    },
    /// A variable of the environment with another value than expected.
    #[error("{name}={found}: expected {expected}; mend it, or name the shard: --shard 3/7")]
    Variable {
        /// Name of the variable.
        name: &'static str,
        /// Value of the variable.
        found: String,
        /// Values that are taken, in words.
        expected: String,
    },
    /// More shards than frames.
    #[error("shard {shard}: the run has {frames} frames, expected at most as many shards; give fewer shards")]
    TooMany {
        /// The shard as it was asked for.
        shard: crate::Shard,
        /// Frames of the run.
        frames: u64,
    },
}
