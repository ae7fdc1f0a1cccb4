//! The 3 x 36 multipliers, each with the multiplying D/A behind it, and the first sums of their terms.
//!
//! Nearly all parts of a machine stand here, so the loop over them is the machine's cost: a block of samples goes
//! through the cells two by two, both with their eight lanes in a vector of sixteen, and is divided only where a D/A takes
//! a new word. Each lag keeps what it leaves for the next sample instead of its input and output. A part that is ideal has
//! the coefficients of one.

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use parts::{Feedthrough, LagStep, Multiplier, Wire};
use signal::{Both, Double, LANES, Lanes, Real};

use super::block::{BLOCK, Block, BothRow, Factor, Row};
use super::rows::{Alike, RowWires};
use super::terms::{TERMS, one_of, side_by_side};
use super::words::{Taking, Words};

/// Cells of a row.
pub(super) const ROW: usize = 6;
/// The same two by two.
pub(super) const PAIRS: usize = ROW / 2;

/// A multiplier and its D/A.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell<S> {
    /// The function generators that feed it: X, Y.
    pub(super) factors: [usize; 2],
    pub(super) parts: CellParts<S>,
    /// Time constant of the D/A (s), for steps that a new word divides.
    pub(super) tau: f64,
}

/// Figures of its parts, or of those of two cells side by side.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellParts<T> {
    pub(super) multiplier: Multiplier<T>,
    /// What leaks of the first input past the multiplier.
    pub(super) leak: Feedthrough<T>,
    pub(super) lag: LagStep<T>,
    pub(super) converter: LagStep<T>,
    /// What leaks of the signal past the D/A, whatever its word.
    pub(super) past: Feedthrough<T>,
}

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

/// Wires of a cell at a sample, of a group; or of two cells side by side.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Wires<V> {
    /// What the multiplier's lag leaves for the next sample.
    product_left: V,
    pub(super) product: V,
    /// What the D/A multiplies by.
    pub(super) weight: V,
    /// What the D/A's lag leaves for the next sample.
    term_left: V,
    pub(super) term: V,
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

    /// The same, of all lanes.
    pub(super) fn weights(&self, index: usize) -> Lanes<S> {
        let [pair, end] = side_by_side(index);
        self.pairs[pair].weight.wire(end)
    }

    /// What D/A `index` puts out.
    pub(super) fn term(&self, index: usize) -> Lanes<S> {
        let [pair, end] = side_by_side(index);
        self.pairs[pair].term.wire(end)
    }
}

impl<S: Real> Wires<Both<S>> {
    #[inline(always)]
    pub(super) fn load<L: Simd>(&self, simd: L) -> Wires<S::Double<L>> {
        let load = |wire| S::Double::<L>::load(simd, wire);
        Wires {
            product_left: load(&self.product_left),
            product: load(&self.product),
            weight: load(&self.weight),
            term_left: load(&self.term_left),
            term: load(&self.term),
        }
    }

    #[inline(always)]
    pub(super) fn store<L: Simd>(&mut self, wires: &Wires<S::Double<L>>) {
        wires.product_left.store(&mut self.product_left);
        wires.product.store(&mut self.product);
        wires.weight.store(&mut self.weight);
        wires.term_left.store(&mut self.term_left);
        wires.term.store(&mut self.term);
    }

    fn set(&mut self, wire: usize, wires: &Wires<Lanes<S>>) {
        self.product_left.set(wire, wires.product_left);
        self.product.set(wire, wires.product);
        self.weight.set(wire, wires.weight);
        self.term_left.set(wire, wires.term_left);
        self.term.set(wire, wires.term);
    }
}

impl<V: Copy> Wires<V> {
    /// The product a step later; `x` with its square, and its change over the step.
    #[inline(always)]
    pub(super) fn multiply<S: Copy>(&mut self, parts: &CellParts<S>, x: [V; 2], change: V, y: V)
    where
        V: Wire<S>,
    {
        self.take(&parts.lag, parts.multiplier.product_of(x, y) + parts.leak.of_change(change));
    }

    /// The product a step later, at the end of which `raw` comes to its lag.
    #[inline(always)]
    pub(super) fn take<S: Copy>(&mut self, lag: &LagStep<S>, raw: V)
    where
        V: Wire<S>,
    {
        self.product = lag.end(self.product_left, raw);
        self.product_left = lag.leave(self.product, raw);
    }
}

impl<S: Copy> CellParts<S> {
    /// Each figure of these parts with that of others, through `f`.
    fn beside<T>(&self, other: &Self, f: impl Fn(S, S) -> T) -> CellParts<T> {
        CellParts {
            multiplier: self.multiplier.beside(&other.multiplier, &f),
            leak: self.leak.beside(&other.leak, &f),
            lag: self.lag.beside(&other.lag, &f),
            converter: self.converter.beside(&other.converter, &f),
            past: self.past.beside(&other.past, &f),
        }
    }

    /// Product and term a step later; `x` with its square, and its change over the step.
    #[inline(always)]
    fn step<V: Wire<S>>(&self, wires: &mut Wires<V>, x: [V; 2], change: V, y: V) {
        wires.multiply(self, x, change, y);
        wires.term = self.converter.end(wires.term_left, wires.product * wires.weight);
    }

    /// What comes out at the end of a step that the product has begun with `before`.
    #[inline(always)]
    fn put<V: Wire<S>>(&self, wires: &mut Wires<V>, before: V) -> V {
        wires.term_left = self.converter.leave(wires.term, wires.product * wires.weight);
        wires.term + self.past.of_change(wires.product - before)
    }
}

impl<S: Real> CellParts<S> {
    /// The wires at rest under factors that stand.
    fn at_rest(&self, [x, y]: [Lanes<S>; 2], weight: Lanes<S>) -> Wires<Lanes<S>> {
        let product = self.multiplier.product(x, y);
        let term = product * weight;
        Wires {
            product_left: self.lag.leave(product, product),
            product,
            weight,
            term_left: self.converter.leave(term, term),
            term,
        }
    }
}

impl<S: Real> CellParts<Both<S>> {
    #[inline(always)]
    pub(super) fn load<L: Simd>(&self, simd: L) -> CellParts<S::Double<L>> {
        let load = |figure: Both<S>| S::Double::<L>::load(simd, &figure);
        CellParts {
            multiplier: self.multiplier.each(load),
            leak: self.leak.each(load),
            lag: self.lag.each(load),
            converter: self.converter.each(load),
            past: self.past.each(load),
        }
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
        (words, pair, n): (&Words, usize, usize),
    ) -> S::Double<L> {
        let before = self.wires.product;
        self.parts.step(&mut self.wires, x.0, x.1, y);
        let (mut taking, mut term) = (Taking::<S, 1>::default(), Both::default());
        before.store(&mut taking.begin[0]);
        self.wires.product.store(&mut taking.end[0]);
        self.wires.weight.store(&mut taking.weight[0]);
        self.wires.term.store(&mut term);
        taking.act(words, pair, n, &mut term.0);
        self.wires.weight = S::Double::<L>::load(simd, &taking.weight[0]);
        self.wires.term = S::Double::<L>::load(simd, &term);
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
        words: &Words,
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
                let taken = words.samples(number..number + 1);
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
