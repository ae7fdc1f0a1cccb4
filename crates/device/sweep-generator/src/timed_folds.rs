//! Folds of a sweep on the sweep clock.

use sweep_program::{Fold, Step, SweepStart};

use crate::RangeTable;
use crate::ramps::Folds;

/// Folds of one sweep in order of range, X before Y at one instant, and when they are.
#[derive(Debug, Clone)]
pub struct TimedFolds<'a> {
    folds: Folds,
    table: &'a RangeTable,
    region_size: f64,
    end: f64,
}

impl<'a> TimedFolds<'a> {
    /// Folds of a sweep that starts so over regions of side `region_size`, up to ground range `end` (m).
    pub fn new(start: &SweepStart, region_size: f64, table: &'a RangeTable, end: f64) -> Self {
        Self { folds: Folds::new(start), table, region_size, end }
    }
}

impl Iterator for TimedFolds<'_> {
    type Item = Step<Fold>;

    #[inline(always)]
    fn next(&mut self) -> Option<Step<Fold>> {
        let (regions, fold) = self.folds.next_fold();
        let range = regions * self.region_size;
        let (time, sample) = self.table.passing(range);
        (range <= self.end).then_some(Step { time, range, sample, kind: fold })
    }
}
