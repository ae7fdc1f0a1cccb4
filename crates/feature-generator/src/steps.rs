//! Where a sweep crosses the kink circles of the craters it draws.

use std::cmp::Ordering;

use features::Crater;

use crate::FeatureLoad;
use crate::sub_generator::Zone;

/// The sweep goes over from one zone of a crater into the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Step {
    /// Ground range (m).
    pub range: f64,
    /// Number of the load in the program.
    pub load: u32,
    /// Zone before it.
    pub from: Zone,
    /// Zone after it.
    pub to: Zone,
}

impl Step {
    /// Whether it leads towards the centre.
    pub fn is_inward(&self) -> bool {
        self.to > self.from
    }

    /// First sample after it. A circle itself counts to what is outside of it (section 9, interval convention).
    pub fn sample(&self, ranges: &[f64]) -> usize {
        let inward = self.is_inward();
        ranges.partition_point(|&range| range < self.range || (inward && range == self.range))
    }

    /// By range; at one range first what is left, then what is entered; circles of a crater in the order of passing.
    pub fn order(&self, other: &Self) -> Ordering {
        let passing = |step: &Self| if step.is_inward() { step.to as i8 } else { -(step.to as i8) };
        let at_one_range = |step: &Self| (step.is_inward(), step.load, passing(step));
        self.range.total_cmp(&other.range).then(at_one_range(self).cmp(&at_one_range(other)))
    }
}

/// Adds the steps of one load.
pub(crate) fn collect(crater: &Crater, load: &FeatureLoad, number: u32, steps: &mut Vec<Step>) {
    let mut outside = Zone::Outside;
    for radius in [crater.outer(), crater.foot()] {
        let inside = if radius > crater.foot() { Zone::Ring } else { Zone::Hollow };
        let square = radius * radius - load.side * load.side;
        let [entry, exit] = [-1.0, 1.0].map(|sign| load.middle + sign * square.max(0.0).sqrt());
        // A chord that only touches the circle, or is lost in rounding, crosses nothing.
        if inside != outside && entry < exit {
            steps.push(Step { range: entry, load: number, from: outside, to: inside });
            steps.push(Step { range: exit, load: number, from: inside, to: outside });
            outside = inside;
        }
    }
}
