//! D/As that are alike: one lag behind the sum of what they multiply, in place of one each.
//!
//! **Law.** A lag is linear, so equal lags commute with a sum: of six D/As with one pole and nothing that leaks past them
//! `sum lag(w u) = lag(sum w u)`, also where a word changes, which adds to the one lag what it adds to its own
//! (`converters`). Of 36 multipliers, 36 D/As and seven amplifiers a sum then has 36 + 6 + 7 states, to rounding those of
//! all parts. Rows are six cells behind one function generator of X: an amplifier takes one or several.
//! **Elaboration.** Multipliers that are alike, without an error and without a leak, are products behind which stands the same: it
//! multiplies their common input once. Who looks at single D/As has them, in the
//! form of `grid`.

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use parts::LagStep;
use signal::{Double, Lanes, Real};

use super::block::{BLOCK, Block};
use super::cell::{Cell, CellParts, CellStep, Wires};
use super::grid::{Grid, GridWires, RowInputs};
use super::row_words::RowWords;
use crate::terms::{PAIRS, ROW};

/// What all D/As of a grid are.
#[derive(Debug, Clone)]
pub(super) struct Alike<S> {
    converter: LagStep<S>,
    /// Their time constant (s).
    pub(super) tau: f64,
    /// Whether multipliers are products with the same lag.
    are_products: bool,
}

impl<S: Real> Alike<S> {
    /// Of cells of which `inputs` meet at one amplifier, if their D/As are alike and whole rows meet there.
    pub(super) fn of(cells: &[Cell<S>], inputs: usize) -> Option<Self> {
        let (converter, tau) = (cells.first()?.parts.converter, cells[0].tau);
        let is_alike = |cell: &Cell<S>| cell.parts.converter == converter && cell.parts.past.is_none();
        let is_product = |cell: &Cell<S>| {
            let CellParts { multiplier, leak, lag, .. } = &cell.parts;
            multiplier.is_ideal() && leak.is_none() && *lag == cells[0].parts.lag
        };
        let are_products = cells.iter().all(is_product);
        let meet_whole = inputs.is_multiple_of(ROW);
        (meet_whole && cells.iter().all(is_alike)).then_some(Self { converter, tau, are_products })
    }

    /// Whether multipliers take more of their inputs than a product does.
    pub(super) fn have_errors(&self) -> bool {
        !self.are_products
    }
}

/// The lag of a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct RowWires<S> {
    /// What it leaves for the next sample.
    left: Lanes<S>,
    term: Lanes<S>,
}

impl<S: Real> Default for RowWires<S> {
    fn default() -> Self {
        Self { left: Lanes::default(), term: Lanes::default() }
    }
}

/// A row on its way through a block.
struct Course<'a, S: Real, L: Simd, const PRODUCTS: bool> {
    simd: L,
    steps: [CellStep<S::Double<L>>; PAIRS],
    converter: LagStep<S>,
    wires: [Wires<S::Double<L>>; PAIRS],
    left: S::Vector<L>,
    term: S::Vector<L>,
    inputs: RowInputs<'a, S>,
}

impl<S: Real, L: Simd, const PRODUCTS: bool> Course<'_, S, L, PRODUCTS> {
    /// The step to sample `n`.
    #[inline(always)]
    fn step(&mut self, n: usize) {
        self.multiply(n);
        let met = self.meet();
        self.term = self.converter.end(self.left, met);
        self.left = self.converter.leave(self.term, met);
    }

    /// The same, in which `words` act on row `row`.
    #[inline(always)]
    fn step_with(&mut self, n: usize, (words, row): (&RowWords<S>, usize)) {
        let begin = self.products();
        self.multiply(n);
        self.term = self.converter.end(self.left, self.meet());
        let mut weight = [self.wires[0].weight; PAIRS];
        for pair in 1..PAIRS {
            weight[pair] = self.wires[pair].weight;
        }
        let more = words.act(self.simd, (row, n), [begin, self.products()], &mut weight);
        let [near, far] = more.halves();
        self.term += near + far;
        for pair in 0..PAIRS {
            self.wires[pair].weight = weight[pair];
        }
        self.left = self.converter.leave(self.term, self.meet());
    }

    #[inline(always)]
    fn products(&self) -> [S::Double<L>; PAIRS] {
        [self.wires[0].product, self.wires[1].product, self.wires[2].product]
    }

    /// What comes out of the multipliers at sample `n`.
    #[inline(always)]
    fn multiply(&mut self, n: usize) {
        let x = self.inputs.x(self.simd, n);
        for pair in 0..PAIRS {
            let y = self.inputs.y(self.simd, pair, n);
            let wires = &mut self.wires[pair];
            if PRODUCTS {
                self.steps[0].multiply_ideally(wires, x, y);
            } else {
                let (x, change) = self.inputs.all_of_x(self.simd, n);
                self.steps[pair].multiply(wires, x, change, y);
            }
        }
    }

    /// What all of them make of their words.
    #[inline(always)]
    fn meet(&self) -> S::Vector<L> {
        let mut sum = self.wires[0].product * self.wires[0].weight;
        for pair in 1..PAIRS {
            sum = sum + self.wires[pair].product * self.wires[pair].weight;
        }
        let [low, high] = sum.halves();
        low + high
    }
}

impl<S: Real> Grid<S> {
    /// Rows at rest under multipliers that are.
    pub(super) fn settle_rows(&self, wires: &mut GridWires<S>) {
        let Some(alike) = &self.alike else { return };
        for row in 0..self.cells.len() / ROW {
            let mut term = Lanes::default();
            for index in ROW * row..ROW * (row + 1) {
                term = term + wires.term(index);
            }
            wires.rows[row] = RowWires { left: alike.converter.leave(term, term), term };
        }
    }

    /// As [`run`](Self::run), by rows of D/As that are `alike`.
    #[inline(always)]
    pub(super) fn run_rows<L: Simd>(
        &self,
        simd: L,
        alike: &Alike<S>,
        block: &mut Block<S>,
        count: usize,
        words: &RowWords<S>,
        wires: &mut GridWires<S>,
    ) {
        block.partial.iter_mut().for_each(|sums| *sums = [Lanes::default(); BLOCK]);
        if alike.are_products {
            self.run_rows_of::<L, true>(simd, alike, block, count, words, wires);
        } else {
            self.run_rows_of::<L, false>(simd, alike, block, count, words, wires);
        }
    }

    #[inline(always)]
    fn run_rows_of<L: Simd, const PRODUCTS: bool>(
        &self,
        simd: L,
        alike: &Alike<S>,
        block: &mut Block<S>,
        count: usize,
        words: &RowWords<S>,
        wires: &mut GridWires<S>,
    ) {
        let Block { x, y, partial, .. } = block;
        let GridWires { pairs, rows } = wires;
        let of_pairs = self.steps.chunks_exact(PAIRS).zip(pairs.chunks_exact_mut(PAIRS));
        for (row, ((steps, wires), lag)) in of_pairs.zip(rows).enumerate() {
            let mut course = Course::<S, L, PRODUCTS> {
                simd,
                steps: [steps[0].load(simd), steps[1].load(simd), steps[2].load(simd)],
                converter: alike.converter,
                wires: [wires[0].load(simd), wires[1].load(simd), wires[2].load(simd)],
                left: S::Vector::<L>::from_slice(simd, &lag.left.0),
                term: S::Vector::<L>::from_slice(simd, &lag.term.0),
                inputs: RowInputs::of(row, (x, y)),
            };
            let sums = &mut partial[self.group(ROW * row)];
            let taken = words.samples(row);
            for n in 0..count.min(BLOCK) {
                if taken >> n & 1 == 0 {
                    course.step(n);
                } else {
                    course.step_with(n, (words, row));
                }
                let mut sum = S::Vector::<L>::from_slice(simd, &sums[n].0);
                sum += course.term;
                sum.store_slice(&mut sums[n].0);
            }
            for pair in 0..PAIRS {
                wires[pair].store::<L>(&course.wires[pair]);
            }
            course.left.store_slice(&mut lag.left.0);
            course.term.store_slice(&mut lag.term.0);
        }
    }
}
