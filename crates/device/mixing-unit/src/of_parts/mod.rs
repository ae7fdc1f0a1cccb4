//! The mixing unit made of real parts; the data sheet is the crate's.

mod edges;
mod events;
mod gates;
mod mixer;
mod switch;

pub use gates::SwitchGates;
pub use mixer::{PartsMixer, SwitchScratch};

#[cfg(test)]
mod tests;
