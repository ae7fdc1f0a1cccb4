//! A cycle over coarser and coarser grids: what is wrong over many posts is mended where few stand for them.
//!
//! Four posts of a grid, two by two, are one of the next. Its equations are the sums of theirs (Galerkin's with a constant over the four),
//! so any shape of hole, islands in it and edges of the grid are right on every level. Two rounds a level: the W cycle. It leads conjugate
//! gradients, so numbers of 24 bits are enough.

use rayon::prelude::*;

use super::super::holes::Hole;

/// Share of the box around a hole that the hole fills at least. Chosen: one that fills less is thin, its rim is near, and few steps do
/// without a cycle.
const LEAST_SHARE: f64 = 1.0 / 32.0;
/// Share of a residual that is smoothed away at once. Chosen: of 0.8 and 0.9 that with fewer steps over a round lake.
const SMOOTH: f32 = 0.8;
/// How much of a coarse grid's correction is taken. Chosen: a constant over four posts bends too little (1, 1.5 and 1.8 were tried).
const CORRECT: f32 = 1.5;
/// Smoothings on the coarsest grid, of nine posts at most.
const LAST: usize = 8;
/// Rows that a thread takes at a time.
const ROWS: usize = 32;

/// Grids over a hole, from its posts to a few.
pub(super) struct Cycle {
    /// Place of each post of the hole in the finest grid.
    places: Vec<u32>,
    levels: Vec<Level>,
}

/// A rectangle of posts with one more all around, which has no equation.
struct Level {
    columns: usize,
    rows: usize,
    /// Diagonal of the equations; 0 where there is none.
    diagonal: Vec<f32>,
    /// One over the diagonal; 0 where there is none.
    inverse: Vec<f32>,
    /// Weight of the bond with the post to the right.
    right: Vec<f32>,
    /// Weight of the bond with the post below.
    below: Vec<f32>,
}

impl Cycle {
    /// The grids over a hole of a grid; none over one that is thin.
    pub fn over([grid_rows, grid_columns]: [usize; 2], hole: Hole) -> Option<Self> {
        let column = |post: &usize| post % grid_columns;
        let (first, last) = (hole.posts.iter().map(column).min()?, hole.posts.iter().map(column).max()?);
        let [top, bottom] = [hole.posts.first()?, hole.posts.last()?].map(|post| post / grid_columns);
        let (columns, rows) = (last - first + 1, bottom - top + 1);
        if (hole.posts.len() as f64) < LEAST_SHARE * (columns * rows) as f64 {
            return None;
        }
        let mut level = Level::empty(columns, rows);
        let place =
            |post: usize| (post / grid_columns - top + 1) * level.stride() + post % grid_columns - first + 1;
        let places: Vec<usize> = hole.posts.iter().map(|&post| place(post)).collect();
        for (&at, &post) in places.iter().zip(hole.posts) {
            let (row, column) = (post / grid_columns, post % grid_columns);
            let edges = [row == 0, row + 1 == grid_rows, column == 0, column + 1 == grid_columns];
            level.diagonal[at] = 4.0 - edges.iter().filter(|edge| **edge).count() as f32;
        }
        let stride = level.stride();
        for &at in &places {
            let bond = |other: usize| if level.diagonal[other] > 0.0 { 1.0 } else { 0.0 };
            (level.right[at], level.below[at]) = (bond(at + 1), bond(at + stride));
        }
        level.invert();
        let mut levels = vec![level];
        while let Some(finest) = levels.last().filter(|level| level.columns.max(level.rows) > 3) {
            let coarser = finest.coarser();
            levels.push(coarser);
        }
        Some(Self { places: places.into_iter().map(|at| at as u32).collect(), levels })
    }

    /// About what must be added to the heights to leave no `residual`, whose largest part is `largest`.
    pub fn correct(&self, residual: &[f64], largest: f64) -> Vec<f64> {
        let mut wrong = vec![0.0; self.levels[0].diagonal.len()];
        // In parts of the largest: a residual of 1e-300 m is none to 24 bits.
        for (&at, part) in self.places.iter().zip(residual) {
            wrong[at as usize] = (part / largest) as f32;
        }
        let correction = round(&self.levels, &wrong);
        self.places.iter().map(|&at| largest * f64::from(correction[at as usize])).collect()
    }
}

/// About the solution of the first level for `wrong`, with two rounds of all coarser ones.
fn round(levels: &[Level], wrong: &[f32]) -> Vec<f32> {
    let level = &levels[0];
    let mut values: Vec<f32> =
        wrong.iter().zip(&level.inverse).map(|(part, one)| SMOOTH * part * one).collect();
    let mut rest = vec![0.0; values.len()];
    let Some(coarser) = levels.get(1) else {
        (0..LAST).for_each(|_| level.smooth(&mut values, wrong, &mut rest));
        return values;
    };
    level.rest(&values, wrong, &mut rest);
    let sums = level.gathered(coarser, &rest);
    let mut correction = round(&levels[1..], &sums);
    if levels.len() > 2 {
        let mut left = vec![0.0; sums.len()];
        coarser.rest(&correction, &sums, &mut left);
        let more = round(&levels[1..], &left);
        correction.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }
    level.spread(coarser, &correction, &mut values);
    level.smooth(&mut values, wrong, &mut rest);
    values
}

impl Level {
    fn empty(columns: usize, rows: usize) -> Self {
        let zeros = || vec![0.0; (columns + 2) * (rows + 2)];
        Self { columns, rows, diagonal: zeros(), inverse: zeros(), right: zeros(), below: zeros() }
    }

    fn stride(&self) -> usize {
        self.columns + 2
    }

    fn invert(&mut self) {
        let one_over = |diagonal: &f32| if *diagonal > 0.0 { 1.0 / diagonal } else { 0.0 };
        self.inverse = self.diagonal.iter().map(one_over).collect();
    }

    /// The place of a post in a grid of half as many columns and rows, and whether it is the right and the lower one of its four.
    fn under(&self, coarser: &Self, row: usize, column: usize) -> (usize, bool, bool) {
        ((row / 2 + 1) * coarser.stride() + column / 2 + 1, column % 2 == 1, row % 2 == 1)
    }

    /// The grid of half as many columns and rows.
    fn coarser(&self) -> Self {
        let mut coarser = Self::empty(self.columns.div_ceil(2), self.rows.div_ceil(2));
        for row in 0..self.rows {
            for column in 0..self.columns {
                let at = (row + 1) * self.stride() + column + 1;
                let (under, is_right, is_lower) = self.under(&coarser, row, column);
                coarser.diagonal[under] += self.diagonal[at];
                // A bond within the four takes from the diagonal twice; others join two of the next grid.
                for (bond, leaves, bonds) in [
                    (self.right[at], is_right, &mut coarser.right),
                    (self.below[at], is_lower, &mut coarser.below),
                ] {
                    if leaves {
                        bonds[under] += bond;
                    } else {
                        coarser.diagonal[under] -= 2.0 * bond;
                    }
                }
            }
        }
        coarser.invert();
        coarser
    }

    /// Writes what the values leave of `wrong`.
    fn rest(&self, values: &[f32], wrong: &[f32], rest: &mut [f32]) {
        let (stride, columns) = (self.stride(), self.columns);
        let inner = &mut rest[stride..][..self.rows * stride];
        inner.par_chunks_mut(ROWS * stride).enumerate().for_each(|(run, rest)| {
            for (row, rest) in rest.chunks_mut(stride).enumerate() {
                let at = (run * ROWS + row + 1) * stride + 1;
                self.rest_of_row(at, values, wrong, &mut rest[1..=columns]);
            }
        });
    }

    /// What the values leave of `wrong` in the row whose first post is at `at`.
    fn rest_of_row(&self, at: usize, values: &[f32], wrong: &[f32], rest: &mut [f32]) {
        let (stride, columns) = (self.stride(), self.columns);
        let [here, left, right, above, below] =
            [at, at - 1, at + 1, at - stride, at + stride].map(|at| &values[at..at + columns]);
        let [to_right, to_left] = [at, at - 1].map(|at| &self.right[at..at + columns]);
        let [to_below, to_above] = [at, at - stride].map(|at| &self.below[at..at + columns]);
        let [diagonal, wrong] = [&self.diagonal[..], wrong].map(|numbers| &numbers[at..at + columns]);
        let rest = &mut rest[..columns];
        for k in 0..columns {
            let beside = (to_left[k] * left[k] + to_right[k] * right[k])
                + (to_above[k] * above[k] + to_below[k] * below[k]);
            rest[k] = wrong[k] - (diagonal[k] * here[k] - beside);
        }
    }

    /// Takes a share of what is left at each post away.
    fn smooth(&self, values: &mut [f32], wrong: &[f32], rest: &mut [f32]) {
        self.rest(values, wrong, rest);
        for ((value, rest), one) in values.iter_mut().zip(rest).zip(&self.inverse) {
            *value += SMOOTH * *rest * one;
        }
    }

    /// Sums over the four posts of each of the next grid.
    fn gathered(&self, coarser: &Self, rest: &[f32]) -> Vec<f32> {
        let mut sums = vec![0.0; coarser.diagonal.len()];
        for row in 0..self.rows {
            let (at, under) = ((row + 1) * self.stride() + 1, (row / 2 + 1) * coarser.stride() + 1);
            let sums = &mut sums[under..under + coarser.columns];
            for (sum, pair) in sums.iter_mut().zip(rest[at..at + self.columns].chunks(2)) {
                *sum += pair.iter().sum::<f32>();
            }
        }
        sums
    }

    /// Adds the correction of each post of the next grid to its four.
    fn spread(&self, coarser: &Self, correction: &[f32], values: &mut [f32]) {
        for row in 0..self.rows {
            let (at, under) = ((row + 1) * self.stride() + 1, (row / 2 + 1) * coarser.stride() + 1);
            let correction = &correction[under..under + coarser.columns];
            let (values, diagonal) =
                (&mut values[at..at + self.columns], &self.diagonal[at..at + self.columns]);
            for ((pair, diagonal), correction) in values.chunks_mut(2).zip(diagonal.chunks(2)).zip(correction)
            {
                for (value, diagonal) in pair.iter_mut().zip(diagonal) {
                    *value += if *diagonal > 0.0 { CORRECT * correction } else { 0.0 };
                }
            }
        }
    }
}
