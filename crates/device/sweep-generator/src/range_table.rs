//! The ground-range programme as a table: range of each sample, and back.

use quantities::SweepTime;
use scenario::RangeProgramme;

use crate::sample_finder::SampleFinder;

/// Ground range of every sample of a sweep, ascending (m).
#[derive(Debug, Clone, PartialEq)]
pub struct RangeTable {
    finder: SampleFinder,
}

impl RangeTable {
    /// The programme over `samples` samples (at least 2).
    pub fn new(programme: &RangeProgramme, samples: usize) -> Self {
        let ranges: Vec<f64> = (0..samples).map(|sample| programme.at_sample(sample, samples)).collect();
        Self { finder: SampleFinder::new(&ranges) }
    }

    /// The same sweep with `instants` samples a step (1 and more): sample k of this table is sample `instants k` of that one, and
    /// range grows in a straight line in between, as the sweep does.
    pub fn divided(&self, instants: u32) -> Self {
        let ranges = self.ranges();
        let part = |instant: u32| f64::from(instant) / f64::from(instants);
        let within = |ends: &[f64]| {
            let (near, far) = (ends[0], ends[1]);
            (0..instants).map(move |instant| near + (far - near) * part(instant))
        };
        let mut divided: Vec<f64> = ranges.windows(2).flat_map(within).collect();
        divided.extend(ranges.last());
        Self { finder: SampleFinder::new(&divided) }
    }

    /// Range of each sample (m).
    pub fn ranges(&self) -> &[f64] {
        self.finder.ranges()
    }

    /// When the sweep passes `range`: 0 at the first sample; negative before it, infinite beyond the last.
    pub fn time_of(&self, range: f64) -> SweepTime {
        self.passing(range).0
    }

    /// When the sweep passes `range`, and the first sample that sees it: that at or after the time, which rounding may put on
    /// the sample before.
    // Asked at every fold: where it is called and not inlined, first light takes a twentieth longer.
    #[inline(always)]
    pub fn passing(&self, range: f64) -> (SweepTime, usize) {
        let ranges = self.ranges();
        match self.finder.not_nearer(range) {
            0 => (SweepTime(range / ranges[0] - 1.0), 0),
            k if k == ranges.len() => (SweepTime(f64::INFINITY), k),
            k => {
                let (near, far) = (ranges[k - 1], ranges[k]);
                let time = (k - 1) as f64 + (range - near) / (far - near);
                (SweepTime(time), k - usize::from(time <= (k - 1) as f64))
            }
        }
    }

    /// Place of a range on the sweep clock: sample k is at k, and between two samples range grows in a straight line. Before the
    /// first sample it is half a step before it, beyond the last half a step beyond it.
    #[inline]
    pub fn place(&self, range: f64) -> f64 {
        let ranges = self.ranges();
        match self.finder.not_nearer(range) {
            0 => -0.5,
            k if k == ranges.len() => k as f64 - 0.5,
            k => {
                let (near, far) = (ranges[k - 1], ranges[k]);
                k as f64 - (far - range) / (far - near)
            }
        }
    }

    /// Range at an instant of the sweep (m), straight between samples and from the eye's foot to the first.
    #[inline]
    pub fn range_at(&self, time: SweepTime) -> f64 {
        let ranges = self.ranges();
        if time.0 <= 0.0 {
            return ranges[0] * (1.0 + time.0).max(0.0);
        }
        let before = (time.0 as usize).min(ranges.len() - 1);
        match ranges.get(before + 1) {
            Some(&far) => {
                let near = ranges[before];
                near + (far - near) * (time.0 - before as f64)
            }
            // The ramps have ended: what happens later happens beyond every range.
            None if time.0 > before as f64 => f64::INFINITY,
            None => ranges[before],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::RangeTable;
    use quantities::SweepTime;
    use scenario::{RangeLaw, RangeProgramme};

    const LAWS: [RangeLaw; 4] = [
        RangeLaw::ConstantRate,
        RangeLaw::TwoRate { switch: 100.0, fine_share: 0.5 },
        RangeLaw::ConstantElevation,
        RangeLaw::Geometric,
    ];

    fn table(law: RangeLaw) -> RangeTable {
        RangeTable::new(&RangeProgramme { law, start: 1.5, end: 5000.0 }, 1000)
    }

    #[test]
    fn every_programme_ascends_to_its_end() {
        for law in LAWS {
            let table = table(law);
            assert!(table.ranges().windows(2).all(|pair| pair[0] < pair[1]), "{law:?}");
            assert_eq!(table.ranges()[999], 5000.0, "{law:?}");
            let short = RangeTable::new(&RangeProgramme { law, start: 1.5, end: 5000.0 }, 2);
            assert!(short.ranges()[0] < short.ranges()[1], "{law:?}");
        }
    }

    #[test]
    fn half_the_picture_in_the_first_samples_at_constant_rate() {
        // Hardware section 4.8: 20 m, that is 343 of 500 lines, is reached in the first four samples.
        assert!(table(RangeLaw::ConstantRate).time_of(20.0) <= SweepTime(4.0));
        assert!(table(RangeLaw::Geometric).time_of(20.0) > SweepTime(300.0));
    }

    #[test]
    fn constant_elevation_crosses_lines_evenly() {
        let table = table(RangeLaw::ConstantElevation);
        let tangent = |k: usize| 1.0 / table.ranges()[k];
        let step = tangent(0) - tangent(1);
        for k in 1..999 {
            assert!((tangent(k) - tangent(k + 1) - step).abs() < 1e-12);
        }
    }

    #[test]
    fn the_sample_that_sees_a_range_is_that_at_or_after_its_time() {
        for table in LAWS.map(table) {
            let on_samples = table.ranges().iter().flat_map(|&at| [at.next_down(), at, at.next_up()]);
            let between = table.ranges().windows(2).map(|pair| pair[0] + 0.3 * (pair[1] - pair[0]));
            for range in on_samples.chain(between).chain([0.0, 0.4]).filter(|&range| range <= 5000.0) {
                let (time, sample) = table.passing(range);
                assert_eq!((sample, time), (time.sample_at_or_after(), table.time_of(range)), "{range}");
            }
        }
    }

    #[test]
    fn a_divided_sweep_passes_each_range_at_the_same_instant() {
        for table in LAWS.map(table) {
            assert_eq!(table.divided(1), table);
            for instants in [2, 4, 5] {
                let divided = table.divided(instants);
                let of_steps: Vec<f64> =
                    divided.ranges().iter().step_by(instants as usize).copied().collect();
                assert_eq!(of_steps, table.ranges(), "the steps are among the instants");
                for time in [0.0, 0.3, 17.0, 444.44, 998.99] {
                    let range = table.range_at(SweepTime(time));
                    let found = divided.time_of(range).0 / f64::from(instants);
                    assert!(
                        (found - time).abs() < 1e-9,
                        "{time} became {found} at {instants} instants a step"
                    );
                }
            }
        }
    }

    #[test]
    fn time_and_range_are_inverse() {
        for law in LAWS {
            let table = table(law);
            for time in [-0.75, 0.0, 0.3, 17.0, 444.44, 998.99] {
                let back = table.time_of(table.range_at(SweepTime(time)));
                assert!((back.0 - time).abs() < 1e-9, "{law:?}: {time} became {}", back.0);
            }
            assert_eq!(table.time_of(5000.1), SweepTime(f64::INFINITY));
            assert_eq!(table.range_at(SweepTime(999.0)), 5000.0);
            for beyond in [999.1, 1000.0, 1e9] {
                assert_eq!(table.range_at(SweepTime(beyond)), f64::INFINITY);
            }
        }
    }
}
