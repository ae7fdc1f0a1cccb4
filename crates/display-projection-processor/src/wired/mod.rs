//! The processor made of real parts: figures of [`hardware_model::AnalogParts`] for each.
//!
//! ```text
//! mu.height ─▶ - z²/2R ─▶ ÷ z ─▶ limiter, bow, lag ─┬─▶ deflection ─▶ bow, lag ─▶ position
//!                                                   ├─▶ d/dt ─▶ comparator ─┐
//!                                                   └─▶ S/H ──▶ comparator ─┴▶ latch ─▶ beam on, off
//! mu.reflectivity ─▶ delay line ─────────────────────────────────────────────▶ intensity
//! ```
//!
//! **Full scale.** Elevation is a share of the field: -1 and 1 at the lower and the upper edge of the picture on the
//! sweep, 0 half way, since pitch is subtracted before. A limiter stands a tenth beyond ([`field`]).
//! **Static error.** A bow, `e (1 - u²)`: trimmed at both edges of the field, off by e in its middle; one for the
//! elevation, one for the deflection.
//! **Latch.** The beam is off from the trip of one comparator to the trip of another ([`derivative`], [`peak_hold`]).
//! **Trim.** Nominal delays cancel: the intensity by a delay line, the blanking by another, the differentiator by
//! delaying everything else. What is left is the spread of the parts, dispersion, and comparators.
//! **State.** All parts settle in retrace; no sweep knows of another.

mod chain;
mod derivative;
mod field;
mod figures;
mod function;
mod lane;
mod peak_hold;

pub use chain::{Driven, PartsProcessor, Scratch};

#[cfg(test)]
mod tests;
