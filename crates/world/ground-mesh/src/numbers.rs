//! Numbers of the vertices of a ring, by place.

use crate::grid::Grid;
use crate::rings::Ring;

/// No vertex stands there yet.
const NONE: u32 = u32::MAX;

/// Numbers of the vertices of two rings, that at hand and the one inside it. Where they meet they have the same vertices.
#[derive(Debug, Clone, Default)]
pub(crate) struct Numbers {
    ring: Table,
    inner: Table,
}

impl Numbers {
    /// Forgets all rings.
    pub fn clear(&mut self) {
        self.ring.numbers.clear();
        self.inner.numbers.clear();
    }

    /// Goes on to the next ring outwards.
    pub fn start(&mut self, ring: &Ring, grid: &Grid) {
        std::mem::swap(&mut self.ring, &mut self.inner);
        self.ring.start(ring, grid);
    }

    /// Number of the vertex at a place of the ring at hand; `make` numbers one that has none yet.
    pub fn of(&mut self, at: [i64; 2], make: impl FnOnce() -> u32) -> u32 {
        let Self { ring, inner } = self;
        let slot = ring.slot(at).expect("a place of the ring");
        if ring.numbers[slot] == NONE {
            let known = inner.slot(at).map_or(NONE, |slot| inner.numbers[slot]);
            ring.numbers[slot] = if known == NONE { make() } else { known };
        }
        ring.numbers[slot]
    }
}

/// Numbers of the vertices of a ring: a row for each of its lines to the east, south to north.
#[derive(Debug, Clone, Default)]
struct Table {
    low: [i64; 2],
    step: i64,
    /// Lines to the north and to the east.
    lines: [usize; 2],
    numbers: Vec<u32>,
}

impl Table {
    fn start(&mut self, ring: &Ring, grid: &Grid) {
        self.step = ring.step;
        self.low = ring.square.low.map(|low| low.max(0));
        self.lines = [0, 1].map(|axis| {
            let high = ring.square.high[axis].min(grid.last[axis]);
            self.line(axis, high) as usize + 1
        });
        self.numbers.clear();
        self.numbers.resize(self.lines[0] * self.lines[1], NONE);
    }

    /// Line at a place along an axis: a border of the bank that lies between two lines is the second.
    fn line(&self, axis: usize, at: i64) -> i64 {
        (at - self.low[axis] + self.step - 1).div_euclid(self.step)
    }

    /// Where the number of a place stands; `None` outside the ring.
    fn slot(&self, at: [i64; 2]) -> Option<usize> {
        if self.numbers.is_empty() {
            return None;
        }
        let [row, column] = [0, 1].map(|axis| self.line(axis, at[axis]) as usize);
        (row < self.lines[0] && column < self.lines[1]).then(|| row * self.lines[1] + column)
    }
}
