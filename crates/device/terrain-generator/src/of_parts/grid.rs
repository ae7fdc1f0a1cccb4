//! The 3 x 36 multipliers, each with the multiplying D/A behind it, and the first sums of their terms.
//!
//! Nearly all parts of a machine stand here, so the loop over them is the machine's cost: a block of samples goes
//! through the cells two by two, both with their eight lanes in a vector of sixteen, and is divided only where a D/A takes
//! a new word. D/As that are alike need less (`rows`).

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use signal::{Both, Double, LANES, Lanes, Real};

use super::block::{BLOCK, Block, BothRow, Factor, Row};
use super::cell::{Cell, CellStep, Wires};
use super::rows::{Alike, RowWires};
use super::words::Words;
use crate::terms::{PAIRS, ROW, TERMS, factors, one_of, side_by_side};

/// All of them, and how many meet at one amplifier.
#[derive(Debug, Clone)]
pub(super) struct Grid<S> {
    pub(super) cells: Vec<Cell<S>>,
    /// Their steps two by two, as they are side by side ([`side_by_side`]).
    pub(super) steps: Vec<CellStep<Both<S>>>,
    inputs: usize,
    /// What all D/As are, if they are alike.
    pub(super) alike: Option<Alike<S>>,
}

/// Wires of all cells of a group, two by two, and of rows of cells whose D/As are alike.
#[derive(Debug, Clone, Default)]
pub(super) struct GridWires<S> {
    pub(super) pairs: Vec<Wires<Both<S>>>,
    pub(super) rows: Vec<RowWires<S>>,
}

impl<S: Real> GridWires<S> {
    pub(super) fn resize(&mut self, cells: usize) {
        self.pairs.resize(cells / 2, Wires::default());
        self.rows.resize(cells / ROW, RowWires::default());
    }

    /// What D/A `index` multiplies by in a lane.
    #[inline(always)]
    pub(super) fn weight(&mut self, index: usize, lane: usize) -> &mut S {
        let [pair, end] = side_by_side(index);
        &mut self.pairs[pair].weight.0[LANES * end + lane]
    }

    /// What multiplier `index` puts out.
    pub(super) fn product(&self, index: usize) -> Lanes<S> {
        let [pair, end] = side_by_side(index);
        self.pairs[pair].product.wire(end)
    }

    /// What D/A `index` puts out.
    pub(super) fn term(&self, index: usize) -> Lanes<S> {
        let [pair, end] = side_by_side(index);
        self.pairs[pair].term.wire(end)
    }
}

/// What a row of six cells is fed with: one function generator of X, and the three curves of Y at both ends.
#[derive(Clone, Copy)]
pub(super) struct RowInputs<'a, S> {
    x: &'a Factor<S>,
    /// Which end of X.
    end: usize,
    y: &'a [BothRow<S>],
}

impl<'a, S: Real> RowInputs<'a, S> {
    /// Picks the inputs of row `row` from the block.
    #[inline(always)]
    pub(super) fn of(row: usize, block: (&'a [Factor<S>], &'a [BothRow<S>])) -> Self {
        let [[a, end], [b, _]] = factors(ROW * row / TERMS, ROW * row % TERMS).map(side_by_side);
        Self { x: &block.0[a], end, y: &block.1[b..b + PAIRS] }
    }

    /// The factor of X at sample `n`, the same beside itself.
    #[inline(always)]
    pub(super) fn x<L: Simd>(&self, simd: L, n: usize) -> S::Double<L> {
        self.half(simd, &self.x.value[n])
    }

    /// The same with its cube, and its change.
    #[inline(always)]
    pub(super) fn all_of_x<L: Simd>(&self, simd: L, n: usize) -> ([S::Double<L>; 2], S::Double<L>) {
        ([self.x(simd, n), self.half(simd, &self.x.cube[n])], self.half(simd, &self.x.change[n]))
    }

    #[inline(always)]
    fn half<L: Simd>(&self, simd: L, both: &Both<S>) -> S::Double<L> {
        let lanes = &both.0[LANES * self.end..LANES * (self.end + 1)];
        let half = S::Vector::<L>::from_slice(simd, lanes);
        S::Double::<L>::of(half, half)
    }

    /// The factors of Y of a pair at sample `n`.
    #[inline(always)]
    pub(super) fn y<L: Simd>(&self, simd: L, pair: usize, n: usize) -> S::Double<L> {
        S::Double::<L>::load(simd, &self.y[pair][n])
    }
}

impl<S: Real> Grid<S> {
    /// Of these cells, of which `inputs` meet at one amplifier; whether their D/As switch in the same instant, without a
    /// pulse.
    pub(super) fn new(cells: Vec<Cell<S>>, inputs: usize, act_together: bool) -> Self {
        let step = |pair: usize, end: usize| cells[one_of(pair, end)].parts.step();
        let beside = |pair| step(pair, 0).beside(&step(pair, 1), |near, far| Both::splat([near, far]));
        let steps = (0..cells.len() / 2).map(beside).collect();
        Self { steps, alike: Alike::of(&cells, inputs).filter(|_| act_together), cells, inputs }
    }

    /// Amplifiers of the first stage of one sum.
    pub(super) fn groups(&self) -> usize {
        TERMS.div_ceil(self.inputs)
    }

    /// The amplifier of the first stages that cell `index` feeds.
    #[inline(always)]
    pub(super) fn group(&self, index: usize) -> usize {
        index / TERMS * self.groups() + index % TERMS / self.inputs
    }

    /// Everything at rest under the factors at the first sample of the block; the weights stay.
    pub(super) fn settle(&self, block: &mut Block<S>, wires: &mut GridWires<S>) {
        let Block { x, y, partial, .. } = block;
        partial.iter_mut().for_each(|sums| sums[0] = Lanes::default());
        for (index, cell) in self.cells.iter().enumerate() {
            let [[a, at_a], [b, at_b]] = factors(index / TERMS, index % TERMS).map(side_by_side);
            let [pair, end] = side_by_side(index);
            let (inputs, wires) = ([x[a].value[0].wire(at_a), y[b][0].wire(at_b)], &mut wires.pairs[pair]);
            let at_rest = cell.parts.at_rest(inputs, wires.weight.wire(end));
            wires.set(end, &at_rest);
            let sum = &mut partial[self.group(index)][0];
            *sum = *sum + at_rest.term;
        }
        self.settle_rows(wires);
    }

    /// The first `count` samples of a block, after those before it.
    #[inline(always)]
    pub(super) fn run<L: Simd>(
        &self,
        simd: L,
        block: &mut Block<S>,
        count: usize,
        words: &Words<S>,
        wires: &mut GridWires<S>,
    ) {
        let Block { x, y, partial, .. } = block;
        partial.iter_mut().for_each(|sums| *sums = [Lanes::default(); BLOCK]);
        // Cells of a row that meet at one amplifier are added up before its two ends are taken apart.
        let meet_whole = self.inputs.is_multiple_of(ROW);
        let mut out = [Both::default(); BLOCK];
        for (row, (steps, wires)) in
            self.steps.chunks_exact(PAIRS).zip(wires.pairs.chunks_exact_mut(PAIRS)).enumerate()
        {
            let inputs = RowInputs::of(row, (x, y));
            for place in 0..PAIRS {
                let number = PAIRS * row + place;
                let (step, wires) = (steps[place].load(simd), &mut wires[place]);
                let mut pair = Pair::<S, L> { simd, number, step, wires: wires.load(simd) };
                pair.run(&inputs, words, count, &mut out);
                wires.store::<L>(&pair.wires);
                if !meet_whole || place == PAIRS - 1 {
                    for end in 0..2 {
                        add(simd, &out[..count], end, &mut partial[self.group(one_of(number, end))]);
                    }
                    out = [Both::default(); BLOCK];
                }
            }
        }
    }
}

/// Two cells on their way through a block.
struct Pair<S: Real, L: Simd> {
    simd: L,
    number: usize,
    step: CellStep<S::Double<L>>,
    wires: Wires<S::Double<L>>,
}

impl<S: Real, L: Simd> Pair<S, L> {
    /// Adds to `out` what comes out at the first `count` samples.
    #[inline(always)]
    fn run(&mut self, inputs: &RowInputs<'_, S>, words: &Words<S>, count: usize, out: &mut BothRow<S>) {
        let (place, taken) = (self.number % PAIRS, words.samples(self.number));
        let mut weights = self.step.weights(self.wires.weight);
        let (mut before, mut last) = (self.wires.product, self.wires.term);
        for n in 0..count.min(BLOCK) {
            let (x, change) = inputs.all_of_x(self.simd, n);
            before = self.wires.product;
            self.step.multiply(&mut self.wires, x, change, inputs.y(self.simd, place, n));
            last = self.step.convert(&mut self.wires, before, weights);
            if taken >> n & 1 == 1 {
                let at = (self.number, n);
                let [now, rest] = words.act(self.simd, at, &self.step, (before, &mut self.wires));
                last = last + now;
                self.wires.term_left = self.wires.term_left + rest;
                weights = self.step.weights(self.wires.weight);
            }
            (S::Double::<L>::load(self.simd, &out[n]) + last).store(&mut out[n]);
        }
        self.wires.term = self.step.term(&self.wires, before, last);
    }
}

/// Adds what comes out of a cell to the sum of its amplifier.
#[inline(always)]
fn add<L: Simd, S: Real>(simd: L, out: &[Both<S>], end: usize, sums: &mut Row<S>) {
    for (out, sum) in out.iter().zip(sums) {
        let mut total = S::Vector::<L>::from_slice(simd, &sum.0);
        total += S::Vector::<L>::from_slice(simd, &out.0[LANES * end..LANES * (end + 1)]);
        total.store_slice(&mut sum.0);
    }
}
