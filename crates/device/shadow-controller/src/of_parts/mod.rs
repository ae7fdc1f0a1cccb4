//! Line generators and their comparators made of real parts.
//!
//! ```text
//! x of the sweep ─▶ line generator ─▶ + error ─┐
//! y of the sweep ──────────────────────────────┴▶ comparator, hysteresis ─▶ crossing
//! ```
//!
//! **Law.** A line generator is off by `e` (share of full scale F, the length of the segment in it), so it and the sweep meet
//! where they are apart by `e F` metres; a comparator of offset o and hysteresis V_h answers where they are apart by `o F` and
//! `V_h F / 2` beyond. With r the rate at which they part (metres a metre of range; for a line across the sweep near 1) the
//! crossing moves along the sweep by `(e + o) F / r + V_h F / (2 |r|)`: the first either way, the second outwards, alike at
//! both edges of a shadow. What the comparator sees there has the slope `|r| / F` (full scales a metre).
//! **Parameters.** [`hardware_model::ShadowLineParts`], `comparator.hysteresis`, `comparator.offset`. The comparator's delay
//! moves both edges by v t_c more, and by what a ramp of that slope costs; it is the mixing unit's, which has the gate.
//! **State and timing.** None. Crossings that change their order are the same two changes of the gate.
//! **Elaboration.** Without errors and hysteresis this is not there; the scan converter has no line generators.
//! **Our choices.** Line generators take turns, crossing by crossing; of any number [`MOST`] differ. A line that the sweep
//! meets at a rate below 0.1 counts as one of that rate: outlines have many segments, and another is met first. The segment's
//! point is taken off before multiplier and comparator, and their gain is set with the load: against the ground range
//! of a sweep an error of 0.25 % would be 12 m, and no shadow of the foreground would be where it is.
//! **Not modelled.** Bits of the registers.

use hardware_model::{AnalogParts, ShadowParts};
use parts::{GateEdge, Spread};

use crate::Gate;

/// Line generators that differ from one another where there may be any number.
pub const MOST: u32 = 64;

/// The line generators of a machine, drawn once from the seed of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct PartsLines {
    /// Of each line generator, with the offset of its comparator (share of full scale).
    errors: Vec<f64>,
    /// Half the hysteresis (share).
    behind: f64,
}

impl PartsLines {
    /// Those of `controller`; `None` if it has no line generators.
    pub fn new(controller: &ShadowParts, parts: &AnalogParts, seed: u64) -> Option<Self> {
        let ShadowParts::Digital { line_generators } = *controller else { return None };
        let (spread, count) = (Spread::new(seed), line_generators.unwrap_or(MOST).clamp(1, MOST));
        let error = |index: u32| {
            let index = u64::from(index);
            spread.error("sc.line-generator", index, parts.shadow_line.error)
                + parts.comparator_law(&spread, "sc.comparator", index).offset
        };
        Some(Self { errors: (0..count).map(error).collect(), behind: 0.5 * parts.comparator.hysteresis })
    }

    /// Where the gate changes, ascending, into `edges`.
    pub fn displace(&self, gate: &Gate, edges: &mut Vec<GateEdge>) {
        edges.clear();
        edges.extend(self.answers(gate).map(|(_, edge)| edge));
        edges.sort_by(|a, b| a.range.total_cmp(&b.range));
    }

    /// Every change of the gate with the number of the line generator that finds it, in the order of the true crossings.
    pub fn answers(&self, gate: &Gate) -> impl Iterator<Item = (usize, GateEdge)> {
        let in_turn = self.errors.iter().enumerate().cycle();
        gate.edges().zip(gate.swings()).zip(in_turn).map(|((edge, swing), (number, error))| {
            let range = edge.range + error * swing + self.behind * swing.abs();
            (number, GateEdge { range, ..edge })
        })
    }
}

#[cfg(test)]
mod tests;
