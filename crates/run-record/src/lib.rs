//! The record of a run, as it is written and read: one set of types.

mod file;
mod inputs;

pub use file::{FileRecord, MAX_BYTES, file_hash, hash};
pub use inputs::Inputs;
