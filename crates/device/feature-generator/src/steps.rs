//! Where a sweep crosses the kink circles of the craters it draws.

use features::Crater;

use crate::FeatureLoad;
use crate::chord::half_chord;
use crate::sub_generator::Zone;

/// The sweep goes over from one zone of a crater into the next. As a number, so that a sweep's steps sort as they are met:
///
/// ```text
/// 127..64 ground range   63 inward   37..6 load   5..4 order of passing   3..1 what it comes from, late
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Step(u128);

/// Zones by their numbers.
const ZONES: [Zone; 3] = [Zone::Outside, Zone::Ring, Zone::Hollow];

/// Samples that are looked at one by one before the rest is searched.
const STRIDE: usize = 8;

impl Step {
    /// At `range` (m) the sweep goes over from zone `from` of the crater of a load into zone `to`: by range; at one range first
    /// what is left, then what is entered; circles of a crater in the order of passing.
    fn new(range: f64, load: u32, [from, to]: [Zone; 2], is_late: bool) -> Self {
        // IEEE bits of ascending numbers ascend, those of negative ones the other way round.
        let bits = range.to_bits();
        let place = if bits >> 63 == 1 { !bits } else { bits | 1 << 63 };
        let inward = to > from;
        let passing = if inward { to as u64 } else { Zone::Hollow as u64 - to as u64 };
        let which = u64::from(inward) << 63 | u64::from(load) << 6 | passing << 4;
        Self(u128::from(place) << 64 | u128::from(which | (from as u64) << 1 | u64::from(is_late)))
    }

    /// Returns the ground range of the step (m).
    pub fn range(self) -> f64 {
        let place = (self.0 >> 64) as u64;
        f64::from_bits(if place >> 63 == 1 { place ^ 1 << 63 } else { !place })
    }

    /// Number of the load in the program.
    pub fn load(self) -> u32 {
        (self.0 as u64 >> 6) as u32
    }

    /// Zones before and after it.
    pub fn zones(self) -> [Zone; 2] {
        let passing = self.0 as usize >> 4 & 3;
        let to = if self.is_inward() { passing } else { Zone::Hollow as usize - passing };
        [ZONES[self.0 as usize >> 1 & 3], ZONES[to]]
    }

    /// Whether it leads towards the centre.
    pub fn is_inward(self) -> bool {
        self.0 as u64 >> 63 == 1
    }

    /// Whether it is no circle that is crossed but the arrival of late words.
    pub fn is_late(self) -> bool {
        self.0 & 1 == 1
    }

    /// First sample after it. A circle itself counts to what is outside of it (section 9, interval convention).
    pub fn sample(self, ranges: &[f64]) -> usize {
        let (range, inward) = (self.range(), self.is_inward());
        let before = |place: &f64| *place < range || (inward && *place == range);
        // Nearly always a few samples on.
        let near = ranges.iter().take(STRIDE).take_while(|place| before(place)).count();
        if near < STRIDE { near } else { STRIDE + ranges[STRIDE..].partition_point(before) }
    }
}

/// Adds the steps of one load. Where its words come behind its edge, the crater is there from then on: one step into the
/// zone of that place, and no kink, since its height does not begin at 0.
pub(crate) fn collect(crater: &Crater, load: &FeatureLoad, number: u32, steps: &mut Vec<Step>) {
    let first = steps.len();
    let mut outside = Zone::Outside;
    for radius in [crater.outer(), crater.foot()] {
        let inside = if radius > crater.foot() { Zone::Ring } else { Zone::Hollow };
        let half = half_chord(radius, load.side);
        let [entry, exit] = [load.middle - half, load.middle + half];
        // A chord that only touches the circle, or is lost in rounding, crosses nothing.
        if inside != outside && entry < exit {
            steps.push(Step::new(entry, number, [outside, inside], false));
            steps.push(Step::new(exit, number, [inside, outside], false));
            outside = inside;
        }
    }
    if load.from > f64::NEG_INFINITY {
        delay(load.from, number, first, steps);
    }
}

/// Puts one step at `range` in the place of those before it, of the steps from `first` on.
fn delay(range: f64, load: u32, first: usize, steps: &mut Vec<Step>) {
    let passed = |step: &&Step| step.range() < range;
    let zone = steps[first..].iter().filter(passed).max().map(|step| step.zones()[1]);
    let mut index = 0;
    steps.retain(|step| {
        index += 1;
        index <= first || step.range() >= range
    });
    if let Some(to) = zone.filter(|&zone| zone != Zone::Outside) {
        steps.push(Step::new(range, load, [Zone::Outside, to], true));
    }
}
