//! A feature at one sampling point.

use std::cmp::Ordering;

use crate::feature::Feature;

/// A feature, by its number in the sub-area, and how near it is (q = 1/w, 1/m).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    pub q: f64,
    pub number: u32,
}

impl Entry {
    /// Nothing: farther than any feature.
    pub const NONE: Self = Self { q: f64::NEG_INFINITY, number: u32::MAX };

    /// Whether this is no feature.
    pub fn is_none(self) -> bool {
        self.number == Self::NONE.number
    }

    /// Whether this feature, not [`Entry::NONE`], lies nearer than another or nothing. What has no number for a distance, or is
    /// infinitely far behind, never does.
    #[inline]
    pub fn is_nearer(self, other: Self, features: &[Feature]) -> bool {
        if self.q == other.q && !other.is_none() {
            let [own, other] = [self, other].map(|entry| &features[entry.number as usize]);
            own.order_at_one_distance(other) == Ordering::Less
        } else {
            self.q > other.q
        }
    }
}
