//! Samples by ground range without a search.

/// Bits of a range that are dropped for a box of the table: 256 boxes an octave are left.
const COARSE: u32 = 44;

/// Finds samples by their range: a table over the leading bits of the range, and a step or two from there. A programme
/// puts few samples into a box, so this is several times quicker than halves.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SampleFinder {
    /// Of all samples, and infinity behind the last.
    ranges: Vec<f64>,
    first_box: u64,
    /// First sample of each box that is not nearer than where the box begins.
    begins: Vec<u32>,
}

impl SampleFinder {
    /// For samples at `ranges`: above 0, ascending (m).
    pub fn new(ranges: &[f64]) -> Self {
        let first_box = ranges.first().map_or(0, |range| number_of(*range));
        let last_box = ranges.last().map_or(0, |range| number_of(*range));
        let not_nearer = |number: u64| {
            let begin = f64::from_bits(number << COARSE);
            ranges.partition_point(|&range| range < begin) as u32
        };
        let begins = (first_box..=last_box).map(not_nearer).collect();
        Self { ranges: [ranges, &[f64::INFINITY]].concat(), first_box, begins }
    }

    /// The first sample that is not nearer than `range` (m); the number of samples if all are.
    #[inline]
    pub fn not_nearer(&self, range: f64) -> usize {
        // Not `max`, which may take either of two zeros: -0 has the highest number of all.
        let ahead = if range > 0.0 { range } else { 0.0 };
        let Some(number) = number_of(ahead).checked_sub(self.first_box) else { return 0 };
        let Some(&begin) = self.begins.get(number as usize) else { return self.count() };
        let mut sample = begin as usize;
        // Added, not asked: which way it goes cannot be guessed. Few boxes have more than one sample.
        sample += usize::from(self.ranges[sample] < range);
        while self.ranges[sample] < range {
            sample += 1;
        }
        sample
    }

    /// Those that it was made for.
    pub fn ranges(&self) -> &[f64] {
        &self.ranges[..self.count()]
    }

    fn count(&self) -> usize {
        self.ranges.len() - 1
    }
}

/// Number of the box of a range that is not negative: bits of such numbers ascend as they do.
fn number_of(range: f64) -> u64 {
    range.to_bits() >> COARSE
}

#[cfg(test)]
mod tests {
    use scenario::{RangeLaw, RangeProgramme};

    use super::SampleFinder;
    use crate::RangeTable;

    #[test]
    fn the_table_finds_what_a_search_finds() {
        let laws = [
            RangeLaw::ConstantRate,
            RangeLaw::TwoRate { switch: 100.0, fine_share: 0.5 },
            RangeLaw::ConstantElevation,
            RangeLaw::Geometric,
        ];
        for (law, samples) in
            laws.into_iter().flat_map(|law| [2, 3, 17, 1000, 2999].map(|samples| (law, samples)))
        {
            let table = RangeTable::new(&RangeProgramme { law, start: 1.5, end: 5000.0 }, samples);
            let ranges = table.ranges();
            let finder = SampleFinder::new(ranges);
            let on_samples = ranges.iter().flat_map(|&range| [range.next_down(), range, range.next_up()]);
            let between = (0..2000).map(|k| 1.0 + f64::from(k * k) * 0.00126);
            let extremes = [f64::NEG_INFINITY, -1.0, -0.0, 0.0, 1e-300, 1e300, f64::INFINITY];
            for range in on_samples.chain(between).chain(extremes) {
                let searched = ranges.partition_point(|&at| at < range);
                assert_eq!(finder.not_nearer(range), searched, "{range} among {samples} of {law:?}");
                let time = table.time_of(range).0.clamp(-0.5, samples as f64 - 0.5);
                let expected = if searched == 0 { -0.5 } else { time };
                assert!((table.place(range) - expected).abs() < 1e-9, "{range} among {samples} of {law:?}");
            }
        }
    }
}
