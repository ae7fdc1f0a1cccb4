//! The mixing unit made of real parts: figures of [`hardware_model::AnalogParts`] for each.
//!
//! ```text
//! fg.present ─▶ comparator ─▶ ┐
//! terrain, features ────────▶ VS1 ─▶ black limiter ─▶ VS2 ─▶ + texture ─▶ limiters ─▶ lag ─▶ mu.reflectivity
//! sc.dark ────▶ comparator ──────────────────────────▶ ┘
//! ```
//!
//! **Law.** That of [`crate::MixingUnit`], switch by switch. A gate comes late by the delay of its comparator, the
//! switch then fades over its transition, and what comes in at S is off by its level ([`parts::Switch`]).
//! **Samples.** A sample of a fade is its mean over a step around it, so an edge keeps its place between samples.
//! **State.** Comparators, switches and the video amplifier settle in retrace.

mod edges;
mod mixer;

pub use mixer::{PartsMixer, SwitchScratch};

#[cfg(test)]
mod tests;
