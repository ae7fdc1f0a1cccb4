//! Where a sweep crosses the kink circles of the craters it draws.

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

/// Samples that are looked at one by one before the rest is searched.
const STRIDE: usize = 8;

impl Step {
    /// Whether it leads towards the centre.
    pub fn is_inward(&self) -> bool {
        self.to > self.from
    }

    /// First sample after it. A circle itself counts to what is outside of it (section 9, interval convention).
    pub fn sample(&self, ranges: &[f64]) -> usize {
        let inward = self.is_inward();
        let before = |range: &f64| *range < self.range || (inward && *range == self.range);
        // Nearly always a few samples on.
        let near = ranges.iter().take(STRIDE).take_while(|range| before(range)).count();
        if near < STRIDE { near } else { STRIDE + ranges[STRIDE..].partition_point(before) }
    }

    /// Its place in the order of a sweep as one number: by range; at one range first what is left, then what is entered;
    /// circles of a crater in the order of passing.
    fn rank(&self) -> u128 {
        // IEEE bits of ascending numbers ascend, those of negative ones the other way round.
        let bits = self.range.to_bits();
        let range = if bits >> 63 == 1 { !bits } else { bits | 1 << 63 };
        let inward = self.is_inward();
        let passing = if inward { self.to as u64 } else { Zone::Hollow as u64 - self.to as u64 };
        u128::from(range) << 64 | u128::from(inward) << 63 | u128::from(self.load) << 2 | u128::from(passing)
    }

    /// Puts steps in the order in which the sweep comes to them.
    pub fn sort(steps: &mut [Self]) {
        steps.sort_unstable_by_key(Self::rank);
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
    let zone = steps[first..].iter().filter(passed).max_by_key(|step| step.rank()).map(|step| step.to);
    let mut index = 0;
    steps.retain(|step| {
        index += 1;
        index <= first || step.range >= range
    });
    if let Some(to) = zone.filter(|&zone| zone != Zone::Outside) {
        steps.push(Step { range, load, from: Zone::Outside, to, is_late: true });
    }
}
