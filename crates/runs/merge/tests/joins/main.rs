//! Shards drawn into folders, joined, and held against the folder of one machine, byte for byte.

mod damage;
mod drive;
mod gaps;
mod models;
mod orders;
mod refusals;
mod timings;
mod truths;
