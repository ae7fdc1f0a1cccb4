//! How high the ground has reached, for cutting spans by depth.

use crate::NearTable;
use crate::order::{greater, lesser};

/// Line position held by the projection processor against range: it never grows (section 15.2).
#[derive(Debug, Clone, Copy)]
pub struct Hold<'a, L> {
    /// Where the samples are.
    pub near: &'a NearTable,
    /// Held line position of a sample by its index, from the top of the picture.
    pub lines: L,
}

/// Names the type of a hold that is not there: `None::<&NoHold>`.
pub type NoHold = Hold<'static, fn(usize) -> f32>;

/// Part of an inverse range by which rounding may throw a place off it.
const HAIR: f32 = 1e-5;

impl<L: Fn(usize) -> f32> Hold<'_, L> {
    /// Held line position at an inverse range; infinite before the first sample, where no ground is drawn.
    pub fn at(&self, near: f32) -> f32 {
        self.between(self.near.not_nearer(near), near)
    }

    /// The same by the first sample at or beyond it.
    #[inline(always)]
    pub(crate) fn between(&self, beyond: usize, near: f32) -> f32 {
        let samples = self.near.samples();
        let last = samples.len().saturating_sub(1);
        if beyond == 0 {
            return match samples.first() {
                Some(&first) if first == near => (self.lines)(0),
                _ => f32::INFINITY,
            };
        }
        let (from, to) = (beyond - 1, beyond.min(last));
        if from == to {
            return (self.lines)(last);
        }
        let share = (samples[from] - near) / (samples[from] - samples[to]);
        (self.lines)(from) + share * ((self.lines)(to) - (self.lines)(from))
    }

    /// Least and greatest line position between two inverse ranges, but for rounding: what is held between two samples lies
    /// between what is held at them.
    #[inline(always)]
    pub(crate) fn extremes(&self, [a, b]: [f32; 2]) -> [f32; 2] {
        let begin = self.near.not_nearer(greater(a, b) * (1.0 + HAIR));
        let end = (self.near.not_nearer(lesser(a, b) * (1.0 - HAIR)) + 1).min(self.near.samples().len());
        let before = if begin == 0 { f32::INFINITY } else { (self.lines)(begin - 1) };
        let widen = |[low, high]: [f32; 2], line: f32| [lesser(low, line), greater(high, line)];
        (begin..end).map(&self.lines).fold([before; 2], widen)
    }
}
