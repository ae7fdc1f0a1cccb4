//! Places between two samples where a profile bends or its intensity jumps.
//!
//! Analog events have a real time: a rim that the sweep crosses, a shadow that begins. They are kept beside the
//! samples, so that an edge lies where it lies and not at the next sample.

use crate::LANES;

/// One such place of one lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Break<S> {
    /// The step: it lies between samples `sample - 1` and `sample`, so this is at least 1.
    pub sample: usize,
    /// Part of the step, 0..=1.
    pub share: S,
    /// Height above the eye there (m): the profile is continuous.
    pub height: S,
    /// Intensity just before it.
    pub before: S,
    /// Intensity just after it.
    pub after: S,
}

/// Breaks of a group, lane by lane, ascending along the sweep.
pub type Breaks<S> = [Vec<Break<S>>; LANES];

/// Stretches of each sweep of a group, as begin and end on the sweep clock (samples), in order and apart: where the beam
/// of a machine with real comparators is on.
pub type Stretches = [Vec<[f64; 2]>; LANES];
