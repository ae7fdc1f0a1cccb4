//! The mixing unit made of real parts; the data sheet is the crate's.

mod edges;
mod mixer;

pub use mixer::{PartsMixer, SwitchScratch};

#[cfg(test)]
mod tests;
