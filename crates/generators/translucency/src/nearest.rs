//! The nearest of some features at each sampling point.

use std::ops::Range;

use crate::entry::Entry;
use crate::feature::Feature;

/// One feature for each sampling point: distances (q, 1/m) and numbers side by side.
#[derive(Debug, Clone)]
pub(crate) struct Nearest {
    pub q: Vec<f64>,
    pub numbers: Vec<u32>,
}

impl Nearest {
    /// Nothing at so many sampling points.
    pub fn new(samples: usize) -> Self {
        Self { q: vec![Entry::NONE.q; samples], numbers: vec![Entry::NONE.number; samples] }
    }

    /// Forgets what sampling points have.
    pub fn clear(&mut self, samples: Range<usize>) {
        self.q[samples.clone()].fill(Entry::NONE.q);
        self.numbers[samples].fill(Entry::NONE.number);
    }

    /// What a sampling point has.
    pub fn of(&self, sample: usize) -> Entry {
        Entry { q: self.q[sample], number: self.numbers[sample] }
    }

    /// Takes an entry if it is nearer than what its sampling point has.
    pub fn offer(&mut self, sample: usize, entry: Entry, features: &[Feature]) {
        if entry.is_nearer(self.of(sample), features) {
            (self.q[sample], self.numbers[sample]) = (entry.q, entry.number);
        }
    }
}
