//! The lattice of corners that a relief is evaluated on.

use crate::CornerWords;
use rayon::prelude::{IndexedParallelIterator, ParallelIterator, ParallelSliceMut};
use std::ops::Range;

/// Corners at `origin + region_size * (m, n)`.
pub(super) struct Grid {
    /// Place of corner (0, 0): north, east (m).
    pub origin: [f64; 2],
    /// Side of a region (m).
    pub region_size: f64,
    /// Corners to the north and to the east.
    pub corners: [usize; 2],
}

impl Grid {
    /// Place north of row `m` (m).
    pub fn north(&self, m: usize) -> f64 {
        self.region_size * m as f64 + self.origin[0]
    }

    /// Place east of column `n` (m).
    pub fn east(&self, n: usize) -> f64 {
        self.region_size * n as f64 + self.origin[1]
    }

    /// Runs `law(m, row)` for every row of corners; rows are independent, so threads cannot change the sums.
    pub fn for_rows(&self, words: &mut [CornerWords], law: impl Fn(usize, &mut [CornerWords]) + Sync) {
        words.par_chunks_mut(self.corners[1]).enumerate().for_each(|(m, row)| law(m, row));
    }

    /// Columns of corners within `reach` (m) of `y`.
    pub fn columns_near(&self, y: f64, reach: f64) -> Range<usize> {
        let last = self.corners[1] as f64;
        let y = y - self.origin[1];
        let first = ((y - reach) / self.region_size).ceil().clamp(0.0, last);
        let end = ((y + reach) / self.region_size + 1.0).floor().clamp(first, last);
        first as usize..end as usize
    }
}
