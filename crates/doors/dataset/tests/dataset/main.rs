//! Plans, draws, splits, samples, folders and shards of data sets.

mod draws;
mod grounds;
mod plans;
mod runs;
mod samples;
mod scene;
mod shards;
