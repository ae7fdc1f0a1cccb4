//! Mixing unit (fig. 28, 29; section 14).
//!
//! ```text
//! tg.height ───────────────┬ + ──────────────────────────────▶ mu.height        to the projection processor
//! fg.height ───────────────┘
//! tg.reflectivity ─▶ C ┐
//! fg.reflectivity ─▶ S ┴ VS1 ─▶ C ┐
//! fg.present ──────▶ G            ┴ VS2 ─▶ + ──────────────▶ mu.reflectivity  to the projection processor
//!                black (0) ─▶ S ──┘ G      ↑ texture
//!                          sc.dark ─┘
//! sweep memory, as it is written ─▶ C ┐
//! pg.reflectivity ─────────────────▶ S ┴ VS3 ─▶ display
//! pg.present ──────────────────────▶ G
//! ```
//!
//! **Law.** A `VideoSwitch` has its input C through while its gate G is not above a threshold, and S while it is.
//! The order is the report's: VS1 lays features on terrain, VS2 lays shadow on both, texture is added, and VS3
//! lays polyhedra on whatever the sweep memory is given. VS3 acts in display-plane position, behind the projection
//! processor, so it stands with the polyhedron generator; its law is the same. Heights add.
//! **Parameters.** [`hardware_model::MixingParts`]: what opens VS1 (and VS3), and the level of a self-keyed gate.
//! [`scenario::TextureInShadow`]: whether the adder stands behind VS2, as reported (shadow is grained), or before
//! it (shadow is black).
//! **State and timing.** None; switches and adder follow their inputs at once. A rim that the sweep crosses and a
//! shadow that begins fall between two samples: they leave the unit as [`signal::Breaks`], with the reflectivity
//! on both sides, and the samples hold what is at the samples.
//! **Reflectivity** keeps its sign: below 0 is local shadow, drawn black, and the sign says where between two
//! samples it begins. Remote shadow is exactly 0. Above 1 is clipped.
//! **Elaboration.** A switch whose second input has no source is not there. With terrain alone the unit is two
//! wires ([`terrain_alone`]) and costs nothing a sample.
//! **Our choices.** Presence lines as gates; `self-keyed` shows what the figure taken literally does: the dark wall
//! of a crater drops the gate, and lit terrain shines through it. Texture as reported is added to what is drawn, so
//! local shadow is grained like remote shadow; where texture ends the sign comes back.
//! **Preview.** [`MixingUnit::run_preview`] does the same at the samples alone.
//! **Not modelled.** A self-keyed gate that opens between two samples without a kink there switches at the later one.
//!
//! # Of real parts
//!
//! [`PartsMixer`] is the same block with the figures of [`hardware_model::AnalogParts`]; a machine has one or the other.
//!
//! **Law.** A gate is late by the delay of its comparator on a ramp of the slope with which the generator met the edge; about that instant the switch fades from one input to the other
//! in a straight line over its transition ([`parts::Fade`]). What it takes from S is off by gain and level
//! ([`parts::Switch`]) and later by the difference of both ways. Of the input that is off a small capacity lets through
//! what changes fast ([`parts::HighPass`]). Black and white are limits before VS2 and behind the adder. A lag of the video
//! bandwidth ends the chain.
//! **Parameters.** `comparator.delay` and `.overdrive`, `video_switch`, `video_bandwidth`, `spread`; the seed of the model.
//! **State and timing.** A step is a sample; all settles in retrace. Between samples the video is straight lines, but for
//! breaks: where a fade begins and ends, where the video of a feature jumps, where local shadow begins, at rims. They leave the unit as
//! [`signal::Breaks`], at their instants and with what the chain makes of them there; the lag is split at each, exactly,
//! and its decay behind a jump that can be seen is divided by three more ([`OutputDrivers`], which `[wires]` of a model puts behind
//! the ideal unit too).
//! **Our choices.** Presence lines have one comparator, the shadow gate another. Beyond its footprint the video of a
//! feature is the ground's, since it adds no slope; so a late gate leaves no black seam. A gate that changes without a
//! rim does so half way between samples. Level and gain are static errors: drawn for each switch, without `spread` too.
//! The toggle is the middle of a fade: what a switch needs to get there is in the comparator's delay.
//! **Not modelled.** Hysteresis of the gates; curves between samples.

mod breaks;
mod inputs;
mod of_parts;
mod outputs;
mod preview;
mod stretch;
mod switch;
mod unit;

use signal::{Lanes, Signal, Unit};

pub use inputs::{FeatureInput, Inputs, Kink, Toggle, ToggleList};
pub use of_parts::{PartsMixer, SwitchGates, SwitchScratch};
pub use outputs::{DriverScratch, OutputDrivers};
pub use unit::{Mixed, MixingUnit};

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("mu.height", Unit::Metre, "height of the composite landscape", "fig. 28"),
    Signal::ground(
        "mu.reflectivity",
        Unit::Reflectivity,
        "reflectivity of the composite landscape",
        "fig. 28",
    ),
];

/// Gates of the video switches, where there are switches, behind their comparators: [`PartsMixer::gates`], or without parts
/// [`Inputs::vs1_gate`] and [`Inputs::vs2_gate`].
pub const GATES: &[Signal] = &[
    Signal::ground("mu.vs1", Unit::Gate, "1 while features lie on terrain", "fig. 28"),
    Signal::ground("mu.vs2", Unit::Gate, "1 while remote shadow lies on both", "fig. 28"),
    Signal::ground("mu.vs1.fade", Unit::Number, "how far VS1 is open to features", "fig. 28"),
    Signal::ground("mu.vs2.fade", Unit::Number, "how far VS2 is open to black", "fig. 28"),
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
