//! The ground-range programme as a table: range of each sample, and back.

use quantities::SweepTime;
use scenario::RangeProgramme;

/// Ground range of every sample of a sweep, ascending (m).
#[derive(Debug, Clone, PartialEq)]
pub struct RangeTable {
    ranges: Vec<f64>,
}

impl RangeTable {
    /// The programme over `samples` samples (at least 2).
    pub fn new(programme: &RangeProgramme, samples: usize) -> Self {
        Self { ranges: (0..samples).map(|sample| programme.at_sample(sample, samples)).collect() }
    }

    /// Range of each sample (m).
    pub fn ranges(&self) -> &[f64] {
        &self.ranges
    }

    /// When the sweep passes `range`: 0 at the first sample; negative before it, infinite beyond the last.
    pub fn time_of(&self, range: f64) -> SweepTime {
        self.time_before(self.ranges.partition_point(|&z| z < range), range)
    }

    /// When the sweep passes a range, for ranges that ascend from call to call: from where the last one was. Of the next
    /// eight samples, where most folds are, those that are nearer are counted, which takes no branch; beyond them in steps that
    /// double, then by halves.
    pub fn times(&self) -> impl FnMut(f64) -> SweepTime {
        let mut after = 0;
        move |range| {
            let rest = &self.ranges[after..];
            after += match rest.first_chunk::<8>().map(|next| next.iter().filter(|&&z| z < range).count()) {
                Some(nearer) if nearer < 8 => nearer,
                _ => {
                    let mut bound = 8;
                    while rest.get(bound).is_some_and(|&z| z < range) {
                        bound *= 2;
                    }
                    let near = if bound == 8 { 0 } else { bound / 2 }..rest.len().min(bound + 1);
                    near.start + rest[near].partition_point(|&z| z < range)
                }
            };
            self.time_before(after, range)
        }
    }

    /// When the sweep passes `range`, given the first sample that is not nearer.
    #[inline]
    fn time_before(&self, after: usize, range: f64) -> SweepTime {
        SweepTime(match after {
            0 => range / self.ranges[0] - 1.0,
            k if k == self.ranges.len() => f64::INFINITY,
            k => {
                let (near, far) = (self.ranges[k - 1], self.ranges[k]);
                (k - 1) as f64 + (range - near) / (far - near)
            }
        })
    }

    /// Range at an instant of the sweep (m), straight between samples and from the eye's foot to the first.
    #[inline]
    pub fn range_at(&self, time: SweepTime) -> f64 {
        if time.0 <= 0.0 {
            return self.ranges[0] * (1.0 + time.0).max(0.0);
        }
        let before = (time.0 as usize).min(self.ranges.len() - 1);
        match self.ranges.get(before + 1) {
            Some(&far) => {
                let near = self.ranges[before];
                near + (far - near) * (time.0 - before as f64)
            }
            // The ramps have ended: what happens later happens beyond every range.
            None if time.0 > before as f64 => f64::INFINITY,
            None => self.ranges[before],
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
    fn time_and_range_are_inverse() {
        for law in LAWS {
            let table = table(law);
            for time in [-0.75, 0.0, 0.3, 17.0, 444.44, 998.99] {
                let back = table.time_of(table.range_at(SweepTime(time)));
                assert!((back.0 - time).abs() < 1e-9, "{law:?}: {time} became {}", back.0);
            }
            let mut walk = table.times();
            for range in [0.5, 1.5, 1.5, 77.0, 4999.0, 5000.0, 6000.0] {
                assert_eq!(walk(range), table.time_of(range), "{law:?}");
            }
            // Steps within the next eight samples, just beyond them and far beyond.
            for step in [0.2, 0.9, 1.0, 3.7, 7.0, 7.5, 8.0, 8.5, 9.0, 15.9, 16.0, 17.0, 40.3, 333.0] {
                let mut walk = table.times();
                for k in 0..(1000.0 / step) as usize {
                    let range = table.range_at(SweepTime(step * k as f64 - 0.5));
                    assert_eq!(walk(range), table.time_of(range), "{law:?}, steps of {step}");
                }
            }
            assert_eq!(table.time_of(5000.1), SweepTime(f64::INFINITY));
            assert_eq!(table.range_at(SweepTime(999.0)), 5000.0);
            for beyond in [999.1, 1000.0, 1e9] {
                assert_eq!(table.range_at(SweepTime(beyond)), f64::INFINITY);
            }
        }
    }
}
