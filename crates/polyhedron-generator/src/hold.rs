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

    /// Held line position at an inverse range; infinite before the first sample, where no ground is drawn.
    pub fn at(&self, near: f32) -> f32 {
        let beyond = self.sample(near);
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
