//! Nested square rings of blocks around the eye.

use landscape::Bank;

use crate::error::MeshError;
use crate::grid::{Grid, extent};

/// Fewest cells of half a ring: with fewer, a ring that is moved to its grid could leave the one around it.
pub const FEWEST_CELLS: u32 = 8;

/// Most cells of half a ring. Chosen: numbers of the grid then fit their integers with room.
pub const MOST_CELLS: u32 = 1 << 14;

/// Least half side of the finest ring, as a share of the bank's longer side. Chosen: at most 20 rings.
const LEAST_SHARE: f64 = 1.0 / (1 << 20) as f64;

/// How wide and how fine the rings are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rings {
    /// Half the side of the innermost square (m); each next one is twice as wide.
    pub half_side: f64,
    /// Cells along half the side of every square: a multiple of 4 from [`FEWEST_CELLS`] to [`MOST_CELLS`].
    pub cells: u32,
}

impl Rings {
    /// Step of the innermost square (m).
    pub fn finest_step(&self) -> f64 {
        self.half_side / f64::from(self.cells)
    }

    pub(crate) fn check(&self, bank: &Bank) -> Result<(), MeshError> {
        let [south, west, north, east] = extent(bank);
        let side = (north - south).max(east - west);
        let least = LEAST_SHARE * side;
        if !(least..=side).contains(&self.half_side) {
            return Err(MeshError::HalfSide { found: self.half_side, least, most: side });
        }
        let is_number = self.cells.is_multiple_of(4) && (FEWEST_CELLS..=MOST_CELLS).contains(&self.cells);
        if is_number { Ok(()) } else { Err(MeshError::Cells(self.cells)) }
    }
}

/// Two by two cells of a ring, cut at the borders of the bank.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block {
    /// Numbers of its three lines on the grid, by axis, ascending; equal ones beyond a border.
    pub lines: [[i64; 3]; 2],
    /// Whether its low and its high side, by axis, meet a coarser ring.
    pub meets_coarser: [[bool; 2]; 2],
}

impl Block {
    /// Whether the crossing of two of its lines, by axis, belongs to a coarser ring too.
    pub fn is_shared(&self, line: [usize; 2]) -> bool {
        (0..2).any(|axis| {
            let [low, high] = self.meets_coarser[axis];
            low && line[axis] == 0 || high && line[axis] == 2
        })
    }
}

/// A square around the eye: its low and high side by axis, in steps of the grid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Square {
    pub low: [i64; 2],
    pub high: [i64; 2],
}

impl Square {
    /// The square of `cells` cells of a `step` about the eye, moved to a multiple of four steps. Its border then lies on the
    /// blocks of the next ring.
    fn new(eye: [f64; 2], cells: i64, step: i64) -> Self {
        let coarse = 4 * step;
        let middle = eye.map(|at| (at / coarse as f64).round() as i64 * coarse);
        Self { low: middle.map(|at| at - cells * step), high: middle.map(|at| at + cells * step) }
    }

    fn holds(&self, place: [i64; 2]) -> bool {
        (0..2).all(|axis| (self.low[axis]..self.high[axis]).contains(&place[axis]))
    }

    fn holds_all(&self, last: [i64; 2]) -> bool {
        (0..2).all(|axis| self.low[axis] <= 0 && self.high[axis] >= last[axis])
    }
}

/// A square without the one inside it: blocks of cells of one step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ring {
    /// Side of a cell, in steps of the grid.
    pub step: i64,
    /// Its outer border.
    pub square: Square,
    inner: Option<Square>,
}

/// All rings, from the innermost outwards, until the bank is covered. `eye` is in steps of the grid.
pub(crate) fn rings(grid: &Grid, eye: [f64; 2], cells: u32) -> impl Iterator<Item = Ring> {
    let square = move |step| Square::new(eye, i64::from(cells), step);
    let first = Ring { step: 1, square: square(1), inner: None };
    let last = grid.last;
    std::iter::successors(Some(first), move |ring| {
        let next = || Ring { step: 2 * ring.step, square: square(2 * ring.step), inner: Some(ring.square) };
        (!ring.square.holds_all(last)).then(next)
    })
}

impl Ring {
    /// Blocks of the ring that have something on the bank, row by row from the south-west.
    pub fn blocks(self, grid: &Grid) -> impl Iterator<Item = Block> {
        let (last, side) = (grid.last, 2 * self.step);
        // Blocks beyond the bank are passed over.
        let first = move |axis: usize| self.square.low[axis].max(-side).div_euclid(side) * side;
        let along =
            move |axis: usize| (first(axis)..self.square.high[axis].min(last[axis])).step_by(side as usize);
        let places = along(0).flat_map(move |x| along(1).map(move |y| [x, y]));
        let is_own = move |at: &[i64; 2]| !self.inner.is_some_and(|inner| inner.holds(*at));
        places.filter(is_own).filter_map(move |at| self.block(at, last))
    }

    /// The block at a place; `None` if nothing of it is on the bank.
    fn block(&self, at: [i64; 2], last: [i64; 2]) -> Option<Block> {
        let Self { step, square, .. } = self;
        let lines = [0, 1].map(|axis| [0, 1, 2].map(|k| (at[axis] + k * step).clamp(0, last[axis])));
        let meets_coarser = [0, 1].map(|axis| {
            let [low, _, high] = lines[axis];
            [low > 0 && low == square.low[axis], high < last[axis] && high == square.high[axis]]
        });
        lines.iter().all(|[low, _, high]| low < high).then_some(Block { lines, meets_coarser })
    }
}
