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
    /// Whether it is no circle that is crossed but the arrival of late words.
    pub is_late: bool,
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

/// Adds the steps of one load. Where its words come behind its edge, the crater is there from then on: one step into the
/// zone of that place, and no kink, since its height does not begin at 0.
pub(crate) fn collect(crater: &Crater, load: &FeatureLoad, number: u32, steps: &mut Vec<Step>) {
    let first = steps.len();
    let mut outside = Zone::Outside;
    for radius in [crater.outer(), crater.foot()] {
        let inside = if radius > crater.foot() { Zone::Ring } else { Zone::Hollow };
        let square = radius * radius - load.side * load.side;
        let [entry, exit] = [-1.0, 1.0].map(|sign| load.middle + sign * square.max(0.0).sqrt());
        // A chord that only touches the circle, or is lost in rounding, crosses nothing.
        if inside != outside && entry < exit {
            steps.push(Step { range: entry, load: number, from: outside, to: inside, is_late: false });
            steps.push(Step { range: exit, load: number, from: inside, to: outside, is_late: false });
            outside = inside;
        }
    }
    if load.from > f64::NEG_INFINITY {
        delay(load.from, number, first, steps);
    }
}

/// Puts one step at `range` in the place of those before it, of the steps from `first` on.
fn delay(range: f64, load: u32, first: usize, steps: &mut Vec<Step>) {
    let passed = |step: &&Step| step.range < range;
    let zone = steps[first..].iter().filter(passed).max_by(|a, b| a.order(b)).map(|step| step.to);
    let mut index = 0;
    steps.retain(|step| {
        index += 1;
        index <= first || step.range >= range
    });
    if let Some(to) = zone.filter(|&zone| zone != Zone::Outside) {
        steps.push(Step { range, load, from: Zone::Outside, to, is_late: true });
    }
}
