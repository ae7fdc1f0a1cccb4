//! The laws of sharing: blocks that are a partition, cuts that are the nearest, environments that name a shard.

mod blocks;
mod environment;
mod numbers;
