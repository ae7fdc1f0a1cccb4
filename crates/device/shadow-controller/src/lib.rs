//! Shadow controller (fig. 25, 26; section 11.2): boundary segments into the gate that blanks a sweep.
//!
//! ```text
//!  shadow bank --segments--> I/O processor --true boundaries--> line generators --+--> OR --> comparator --> sc.gate
//!                            (order, union)   or scan converter ------------------+            ^
//!                            initial state -------------------------------------- x, y of the sweep
//! ```
//!
//! **Law.** Remote shadow is enclosed by directed segments, shadow to the right of each. Along a sweep a segment
//! crossed leftwards begins a shadow, one crossed rightwards ends it; the number of shadows at a range is what was
//! begun less what was ended, and the gate is 1 where it is above 0. Shadows that overlap (of ground, bodies and
//! tracks) therefore unite. The gate's state at the eye is what makes the number 0 beyond all segments.
//!
//! **Parts.** Digital: the I/O processor edits the data of each sweep and hands on the true boundaries, in order of
//! range. Each occupies a line generator while the sweep is within the segment's extent along x, or along y if the
//! segment is nearer to y (loaded in swapped form: y in, x out). A segment that finds none free is dropped: its
//! crossing is missed and the gate is inverted from there to the end of the sweep or the next miss. Scan converter:
//! the boundaries are read displaced by `offset` of the map's side and scaled about its centre by `1 + gain`; nothing
//! is ever dropped.
//!
//! **State and timing.** None between sweeps. A crossing acts at once. Four words a boundary,
//! one after another on a line of so many words a second, from the retrace before the sweep on, in the order in which the
//! sweep comes to need line generators ([`ShadowController::gates_by`]); or in no time. A boundary whose words come behind
//! the crossing changes the gate when they come (strobe-through) or not in this sweep (latched).
//!
//! **Elaboration.** Where no segment is in view all gates are 0 for the whole frame, and the block can be left out.
//!
//! **Parts.** [`PartsLines`]: errors of the line generators, hysteresis, offset; the comparator's delay is the mixing unit's.
//! **Not modelled.** Quantisation of the line generators; the width of a line in the scan converter; two crossings within one comparator delay.
//!
//! **Our choices.** Ends count half-open by the sweep that they lie on, so a shared corner counts once and a sweep
//! along an edge is not crossed by it. Two boundaries within `RESOLUTION` of each other cancel: the edges of
//! neighbouring tiles leave no slit of light. Any number of segments in one sweep is served.

mod controller;
mod crossing;
mod crossings;
mod fan;
mod line_generators;
mod lines;
mod nearly;
mod network;
mod of_parts;
mod side_by_side;

pub use controller::{Gate, ShadowController};
pub use line_generators::{SEGMENT_WORDS, SegmentLoad, SegmentMiss};
pub use of_parts::{MOST, PartsLines};

use std::sync::LazyLock;

use signal::{Kind, Signal, Unit};

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground(
        "sc.or",
        Unit::Gate,
        "1 while the sweep is in remote shadow, before the comparator",
        "fig. 25",
    ),
    Signal::ground(
        "sc.gate",
        Unit::Gate,
        "1 while the sweep is in remote shadow, behind the comparator",
        "fig. 25",
    ),
];

/// Line generators that have a wire of their own. Real controllers have at most as many (hardware section 3.7: 4 to 16).
const TOLD: usize = 32;

/// Wires of the comparators behind the line generators, number by number: each answers where the sweep passes the line that is in it.
pub static COMPARATORS: LazyLock<Vec<Signal>> = LazyLock::new(|| {
    // Names live as long as the program: the table is made once.
    let wire = |n: usize| {
        let meaning = "the sweep has passed the line in this line generator, behind its comparator: the gate of shadow changes";
        Signal::digital(format!("sc.comparator.{n}").leak(), Unit::Number, Kind::Event, meaning, "fig. 25")
    };
    (0..TOLD).map(wire).collect()
});

/// The line generator whose comparator has this name; none of another wire.
pub fn comparator_of(name: &str) -> Option<usize> {
    let number = name.strip_prefix("sc.comparator.")?.parse().ok()?;
    (number < TOLD).then_some(number)
}
