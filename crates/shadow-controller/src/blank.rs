//! The gate against the sweep clock.

use signal::{Lanes, Real, Signal, Unit};

use crate::Gate;

/// Signals of the block.
pub const SIGNALS: &[Signal] =
    &[Signal::ground("sc.gate", Unit::Gate, "1 while the sweep is in remote shadow (fig. 25)")];

/// Samples `gate` into lane `lane` of `out`: 1 where the sample at `ranges[n]` (m, ascending) lies in shadow, else
/// 0; 0 from `end_range` (m) on, where the sweep has no ground.
pub fn blank<S: Real>(gate: &Gate, ranges: &[f64], end_range: f64, lane: usize, out: &mut [Lanes<S>]) {
    let mut toggles = gate.toggles.iter().peekable();
    let mut dark = gate.dark_at_start;
    for (range, sample) in ranges.iter().zip(out) {
        while toggles.next_if(|toggle| *toggle <= range).is_some() {
            dark = !dark;
        }
        sample[lane] = if dark && *range < end_range { S::ONE } else { S::ZERO };
    }
}
