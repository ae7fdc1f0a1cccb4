//! Output amplifiers of the main signals.

use serde::Serialize;

/// The wires that can have one: what leaves terrain generator, feature generator and mixing unit, by their names in the signal
/// table, in the order in which the signals arise.
pub const MAIN_WIRES: [&str; 10] = [
    "tg.height",
    "tg.slope.u",
    "tg.slope.v",
    "tg.reflectivity",
    "fg.height",
    "fg.slope.u",
    "fg.slope.v",
    "fg.reflectivity",
    "mu.height",
    "mu.reflectivity",
];

/// The amplifier that drives a main wire.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct WireParts {
    /// Bandwidth (Hz); unlimited if `None`.
    pub bandwidth: Option<f64>,
    /// Fastest change of the output (V/s).
    pub slew: Option<f64>,
    /// Which of [`MAIN_WIRES`] have one.
    pub driven: [bool; MAIN_WIRES.len()],
}

impl WireParts {
    /// Amplifiers that do what wires do.
    pub const IDEAL: Self = Self { bandwidth: None, slew: None, driven: [true; MAIN_WIRES.len()] };

    /// Whether no wire has an amplifier that can be told from none.
    pub fn is_ideal(&self) -> bool {
        self.bandwidth.is_none() && self.slew.is_none() || !self.driven.contains(&true)
    }

    /// Whether the wire of this name has one that can.
    pub fn drives(&self, name: &str) -> bool {
        !self.is_ideal() && MAIN_WIRES.iter().zip(self.driven).any(|(wire, driven)| driven && *wire == name)
    }
}
