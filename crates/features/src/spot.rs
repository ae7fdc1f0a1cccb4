//! What the index keeps of a crater.

use crate::Crater;
use crate::fan::Fan;

/// Slack of lengths (m and share): places are up to 1e9 m, so a difference of two is good to 1e-7 m.
const SLACK: f64 = 1e-6;

/// A length that rounding cannot have made too short (m).
pub(crate) fn with_slack(length: f64) -> f64 {
    length * (1.0 + SLACK) + SLACK
}

/// A crater in short: enough to pass over most of those that are near but do not meet the query, without a look at
/// the crater itself, which is far away in memory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Spot {
    /// Centre from the corner of the grid: north, east (m).
    centre: [f32; 2],
    /// Outer radius, with what the centre lost in rounding and some slack (m).
    outer: f32,
    /// Index of the crater.
    pub index: u32,
}

impl Spot {
    pub fn new(crater: &Crater, index: u32, corner: [f64; 2]) -> Self {
        let centre = [0, 1].map(|axis| (crater.centre()[axis] - corner[axis]) as f32);
        let lost = f64::from(f32::EPSILON) * centre.iter().map(|&place| f64::from(place.abs())).sum::<f64>();
        let outer = with_slack(crater.outer() + lost);
        Self { centre, outer: outer as f32, index }
    }

    /// Whether its bounding square may meet a box.
    pub fn meets_box(&self, low: [f64; 2], high: [f64; 2]) -> bool {
        let outer = f64::from(self.outer);
        let meets = |axis: usize| {
            let place = f64::from(self.centre[axis]);
            place + outer >= low[axis] && place - outer <= high[axis]
        };
        meets(0) && meets(1)
    }

    /// Whether its circle may meet the stretch from a point on along a unit vector.
    pub fn meets_stretch(&self, from: [f64; 2], direction: [f64; 2], length: f64) -> bool {
        let [dx, dy] = [0, 1].map(|axis| f64::from(self.centre[axis]) - from[axis]);
        let nearest = (dx * direction[0] + dy * direction[1]).max(0.0).min(length);
        let [dx, dy] = [dx - nearest * direction[0], dy - nearest * direction[1]];
        let outer = f64::from(self.outer);
        dx * dx + dy * dy <= outer * outer
    }

    /// Whether its circle may meet a ray of a fan that begins at `origin` of the grid.
    pub fn meets_fan(&self, fan: &Fan, origin: [f64; 2]) -> bool {
        let offset = [0, 1].map(|axis| f64::from(self.centre[axis]) - origin[axis]);
        fan.may_reach(offset, f64::from(self.outer))
    }
}
