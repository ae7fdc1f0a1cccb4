//! The world grid over a bank.

use landscape::Bank;

/// Places of whole numbers, from the south-western corner of a bank; the last ones lie on its borders.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Grid {
    low: [f64; 2],
    high: [f64; 2],
    /// Finest step (m).
    pub step: f64,
    /// Number of the northern and the eastern border.
    pub last: [i64; 2],
}

impl Grid {
    /// The grid of a finest step (m) over all levels of a bank.
    pub fn new(bank: &Bank, step: f64) -> Self {
        let [south, west, north, east] = extent(bank);
        let (low, high) = ([south, west], [north, east]);
        let last = [0, 1].map(|axis| ((high[axis] - low[axis]) / step).ceil() as i64);
        Self { low, high, step, last }
    }

    /// Where a number lies along an axis (m); what lies beyond the bank is on its border.
    pub fn place(&self, axis: usize, number: i64) -> f64 {
        if number >= self.last[axis] {
            self.high[axis]
        } else {
            self.low[axis] + number.max(0) as f64 * self.step
        }
    }

    /// A place (m) along an axis in steps from the corner.
    pub fn steps(&self, axis: usize, place: f64) -> f64 {
        (place - self.low[axis]) / self.step
    }
}

/// South, west, north and east border of all levels of a bank (m).
pub(crate) fn extent(bank: &Bank) -> [f64; 4] {
    let both = |a: [f64; 4], b: [f64; 4]| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])];
    let empty = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    bank.levels().iter().map(|level| level.extent()).fold(empty, both)
}
