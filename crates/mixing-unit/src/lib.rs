//! Mixing unit (fig. 28, 29; section 14).
//!
//! ```text
//! tg.height ──────────────────────▶ mu.height        to the projection processor
//! tg.reflectivity ─▶ VS1 ▶ VS2 ▶ + ─▶ mu.reflectivity  to the projection processor
//! ```
//!
//! **Law.** A video switch puts features on terrain (VS1), another puts shadow on both (VS2), texture is added.
//! **Elaboration.** A switch whose second input has no source is not there. This machine has terrain alone, so
//! the unit is two wires and costs nothing a sample.
//! **Not modelled yet.** Features, shadow, texture and with them the three switches.

use signal::{Lanes, Signal, Unit};

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("mu.height", Unit::Metre, "height of the composite landscape (fig. 28)"),
    Signal::ground(
        "mu.reflectivity",
        Unit::Reflectivity,
        "reflectivity of the composite landscape (fig. 28)",
    ),
];

/// The landscape profile of a group of sweeps: one [`Lanes`] a sample.
#[derive(Debug, Clone, Copy)]
pub struct Composite<'a, S> {
    /// Height above the eye (m).
    pub height: &'a [Lanes<S>],
    /// Reflectivity with its sign, -1..=1: below 0 is local shadow, drawn as 0.
    pub reflectivity: &'a [Lanes<S>],
}

/// The composite of terrain alone: its own profile.
pub fn terrain_alone<'a, S>(height: &'a [Lanes<S>], reflectivity: &'a [Lanes<S>]) -> Composite<'a, S> {
    Composite { height, reflectivity }
}
