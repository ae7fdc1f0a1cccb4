//! How high the ground has reached, for cutting spans by depth.

/// Line position held by the projection processor against range: it never grows (section 15.2).
#[derive(Debug, Clone, Copy)]
pub struct Hold<'a, L> {
    /// Inverse ground range of each sample (1/m), descending.
    pub near: &'a [f32],
    /// Held line position of a sample by its index, from the top of the picture.
    pub lines: L,
}

/// Names the type of a hold that is not there: `None::<&NoHold>`.
pub type NoHold = Hold<'static, fn(usize) -> f32>;

impl<L: Fn(usize) -> f32> Hold<'_, L> {
    /// First sample at or beyond an inverse range.
    pub(crate) fn sample(&self, near: f32) -> usize {
        self.near.partition_point(|&sample| sample > near)
    }

    /// The same, from a sample not far from it on.
    pub(crate) fn sample_from(&self, mut sample: usize, near: f32) -> usize {
        let is_nearer = |sample: usize| self.near[sample] > near;
        while sample > 0 && !is_nearer(sample - 1) {
            sample -= 1;
        }
        while sample < self.near.len() && is_nearer(sample) {
            sample += 1;
        }
        sample
    }

    /// Held line position at an inverse range; infinite before the first sample, where no ground is drawn.
    pub fn at(&self, near: f32) -> f32 {
        self.before(self.sample(near), near)
    }

    /// The same before sample `beyond`, the first that is not nearer.
    pub(crate) fn before(&self, beyond: usize, near: f32) -> f32 {
        let last = self.near.len().saturating_sub(1);
        if beyond == 0 {
            return match self.near.first() {
                Some(&first) if first == near => (self.lines)(0),
                _ => f32::INFINITY,
            };
        }
        let (from, to) = (beyond - 1, beyond.min(last));
        if from == to {
            return (self.lines)(last);
        }
        let share = (self.near[from] - near) / (self.near[from] - self.near[to]);
        (self.lines)(from) + share * ((self.lines)(to) - (self.lines)(from))
    }
}

#[cfg(test)]
mod tests {
    use super::Hold;
    use proptest::prelude::{any, prop_assert_eq, proptest};

    proptest! {
        #[test]
        fn from_any_sample_the_same_is_found(
            steps in proptest::collection::vec(0..4u8, 0..40), near in 0..60u8, is_number in any::<bool>(), from in 0..40usize,
        ) {
            let mut at = 80.0;
            let near_of = |step: u8| { at -= f32::from(step); at };
            let samples: Vec<f32> = steps.into_iter().map(near_of).collect();
            let hold = Hold { near: &samples, lines: |_| 0.0 };
            let near = if is_number { 80.0 - f32::from(near) } else { f32::NAN };
            prop_assert_eq!(hold.sample_from(from.min(samples.len()), near), hold.sample(near));
        }
    }
}
