//! Samples by inverse ground range without a search.

/// Bits of an inverse range that are dropped for a box of the table: 256 boxes an octave are left.
const COARSE: u32 = 15;

/// Inverse ground ranges of the samples of a sweep. A table over the leading bits tells which is where, and a step or two from
/// there: a programme puts few samples into a box.
#[derive(Debug, Clone, PartialEq)]
pub struct NearTable {
    /// Of all samples, and behind the last what is beyond all.
    near: Vec<f32>,
    /// The box of the first sample: all others are in boxes of lower numbers.
    first_box: u32,
    /// First sample beyond each box that is nearer, from the first box on.
    begins: Vec<u32>,
}

impl NearTable {
    /// Of samples at inverse ranges that descend and are above 0 (1/m).
    pub fn new(near: impl IntoIterator<Item = f32>) -> Self {
        let mut near: Vec<f32> = near.into_iter().collect();
        let box_of = |near: Option<&f32>| near.map_or(0, |near| number_of(*near));
        let (first_box, last_box) = (box_of(near.first()), box_of(near.last()));
        let begin = |number: u32| near.partition_point(|&sample| number_of(sample) > number) as u32;
        let begins = (last_box..=first_box).rev().map(begin).collect();
        near.push(f32::NEG_INFINITY);
        Self { near, first_box, begins }
    }

    /// Inverse range of each sample (1/m).
    pub fn samples(&self) -> &[f32] {
        &self.near[..self.near.len() - 1]
    }

    /// First sample at or beyond an inverse range (1/m), which is a number; how many there are if all are nearer.
    #[inline(always)]
    pub fn not_nearer(&self, near: f32) -> usize {
        // Not `max`, which may take either of two zeros: -0 has the highest number of all.
        let ahead = if near > 0.0 { near } else { 0.0 };
        let Some(number) = self.first_box.checked_sub(number_of(ahead)) else { return 0 };
        let Some(&begin) = self.begins.get(number as usize) else { return self.samples().len() };
        let mut sample = begin as usize;
        // Added, not asked: which way it goes cannot be guessed.
        sample += usize::from(self.near[sample] > near);
        while self.near[sample] > near {
            sample += 1;
        }
        sample
    }
}

/// Number of the box of an inverse range that is not negative: bits of such numbers ascend as they do.
fn number_of(near: f32) -> u32 {
    near.to_bits() >> COARSE
}

#[cfg(test)]
mod tests {
    use super::NearTable;
    use proptest::prelude::{prop_assert_eq, proptest};

    proptest! {
        /// Samples far apart, in one box and at one place; asked at samples, beside them and anywhere.
        #[test]
        fn the_table_finds_what_a_search_finds(
            ratios in proptest::collection::vec((0..3u8, 0.5..1.0f32), 0..60),
            nearest in 0.001..10.0f32,
            elsewhere in proptest::collection::vec(0.0..12.0f32, 20),
        ) {
            let mut at = nearest;
            let mut next = |(kind, ratio): (u8, f32)| {
                at *= [1.0, 1.0 - (1.0 - ratio) * 1e-5, ratio][kind as usize];
                at
            };
            let samples: Vec<f32> = ratios.into_iter().map(&mut next).collect();
            let table = NearTable::new(samples.iter().copied());
            prop_assert_eq!(table.samples(), &samples[..]);
            let beside = samples.iter().flat_map(|&near| [near.next_down(), near, near.next_up()]);
            let extremes = [f32::NEG_INFINITY, -1.0, -0.0, 0.0, f32::MIN_POSITIVE, f32::MAX, f32::INFINITY];
            for near in beside.chain(elsewhere).chain(extremes) {
                prop_assert_eq!(table.not_nearer(near), samples.partition_point(|&sample| sample > near), "{}", near);
            }
        }
    }
}
