//! The 3 x 36 multipliers, each with the multiplying D/A behind it, and the first sums of their terms.
//!
//! Nearly all parts of a machine stand here, so the loop over them is the machine's cost: a block of samples goes
//! through the cells two by two, both with their eight lanes in a vector of sixteen, and is divided only where a D/A takes
//! a new word. D/As that are alike need less (`rows`).

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use signal::{Both, Double, LANES, Lanes, Real};

use super::block::{BLOCK, Block, BothRow, Factor, Row};
use super::cell::{Cell, CellParts, Wires};
use super::rows::{Alike, RowWires};
use super::terms::{PAIRS, ROW, TERMS, one_of, side_by_side};
use super::words::Words;

/// All of them, and how many meet at one amplifier.
#[derive(Debug, Clone)]
pub(super) struct Grid<S> {
    pub(super) cells: Vec<Cell<S>>,
    /// The same two by two, as they are side by side ([`side_by_side`]).
    pub(super) pairs: Vec<CellParts<Both<S>>>,
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
    /// Of the row whose first cell is fed by these units.
    #[inline(always)]
    pub(super) fn of([a, b]: [usize; 2], block: (&'a [Factor<S>], &'a [BothRow<S>])) -> Self {
        let ([a, end], [b, _]) = (side_by_side(a), side_by_side(b));
        Self { x: &block.0[a], end, y: &block.1[b..b + PAIRS] }
    }

    /// The factor of X at sample `n`, the same beside itself.
    #[inline(always)]
    pub(super) fn x<L: Simd>(&self, simd: L, n: usize) -> S::Double<L> {
        self.half(simd, &self.x.value[n])
    }

    /// The same with its square, and its change.
    #[inline(always)]
    pub(super) fn all_of_x<L: Simd>(&self, simd: L, n: usize) -> ([S::Double<L>; 2], S::Double<L>) {
        ([self.x(simd, n), self.half(simd, &self.x.square[n])], self.half(simd, &self.x.change[n]))
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

/// Two cells on their way through a block.
struct Pair<S: Real, L: Simd> {
    parts: CellParts<S::Double<L>>,
    wires: Wires<S::Double<L>>,
}

impl<S: Real, L: Simd> Pair<S, L> {
    /// A step, and what comes out at its end.
    #[inline(always)]
    fn step(&mut self, x: ([S::Double<L>; 2], S::Double<L>), y: S::Double<L>) -> S::Double<L> {
        let before = self.wires.product;
        self.parts.step(&mut self.wires, x.0, x.1, y);
        self.parts.put(&mut self.wires, before)
    }

    /// The step to sample `n`, in which `words` act on pair number `pair`.
    #[inline(always)]
    fn step_with(
        &mut self,
        simd: L,
        x: ([S::Double<L>; 2], S::Double<L>),
        y: S::Double<L>,
        (words, pair, n): (&Words<S>, usize, usize),
    ) -> S::Double<L> {
        let before = self.wires.product;
        self.parts.step(&mut self.wires, x.0, x.1, y);
        let Wires { product, weight, term, .. } = &mut self.wires;
        words.act(simd, (pair, n), [before, *product], (weight, term));
        self.parts.put(&mut self.wires, before)
    }
}

impl<S: Real> Grid<S> {
    /// Of these cells, of which `inputs` meet at one amplifier; whether their D/As switch in the same instant, without a
    /// pulse.
    pub(super) fn new(cells: Vec<Cell<S>>, inputs: usize, act_together: bool) -> Self {
        let parts = |pair: usize, end: usize| &cells[one_of(pair, end)].parts;
        let beside = |pair| parts(pair, 0).beside(parts(pair, 1), |near, far| Both::splat([near, far]));
        let pairs = (0..cells.len() / 2).map(beside).collect();
        Self { pairs, alike: Alike::of(&cells, inputs).filter(|_| act_together), cells, inputs }
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
            let [[a, at_a], [b, at_b]] = cell.factors.map(side_by_side);
            let [pair, end] = side_by_side(index);
            let (factors, wires) = ([x[a].value[0].wire(at_a), y[b][0].wire(at_b)], &mut wires.pairs[pair]);
            let at_rest = cell.parts.at_rest(factors, wires.weight.wire(end));
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
        let mut out = [[Both::default(); BLOCK]; PAIRS];
        for row in 0..self.pairs.len() / PAIRS {
            let inputs = RowInputs::of(self.cells[ROW * row].factors, (x, y));
            for place in 0..PAIRS {
                let number = PAIRS * row + place;
                let wires = &mut wires.pairs[number];
                let mut pair = Pair::<S, L> { parts: self.pairs[number].load(simd), wires: wires.load(simd) };
                let taken = words.samples(number);
                for (n, out) in out[place][..count].iter_mut().enumerate() {
                    let (x, y) = (inputs.all_of_x(simd, n), inputs.y(simd, place, n));
                    let takes = taken >> n & 1 == 1;
                    let term =
                        if takes { pair.step_with(simd, x, y, (words, number, n)) } else { pair.step(x, y) };
                    term.store(out);
                }
                wires.store::<L>(&pair.wires);
            }
            for cell in 0..ROW {
                let [place, end] = side_by_side(cell);
                add(simd, &out[place][..count], end, &mut partial[self.group(ROW * row + cell)]);
            }
        }
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
