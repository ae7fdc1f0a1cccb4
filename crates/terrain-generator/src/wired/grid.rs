//! The 3 x 36 multipliers, each with the multiplying D/A behind it, and the first sums of their terms.
//!
//! Nearly all parts of a machine stand here, so the loop over them is the machine's cost: a block of samples goes
//! through the cells two by two, eight lanes in a vector, and is divided only where a D/A takes a new word. Each
//! lag keeps what it leaves for the next sample instead of its input and output. A part that is ideal has the
//! coefficients of one.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use parts::{Feedthrough, LagStep, Multiplier, Wire};
use signal::{Lanes, Real};

use super::basis::UNITS;
use super::block::{BLOCK, Block, Factor, Row};
use super::terms::TERMS;
use super::words::Words;

/// A multiplier and its D/A.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell<S> {
    /// The function generators that feed it: X, Y.
    pub(super) factors: [usize; 2],
    pub(super) multiplier: Multiplier<S>,
    /// What leaks of the first input past the multiplier.
    pub(super) leak: Feedthrough<S>,
    pub(super) lag: LagStep<S>,
    pub(super) converter: LagStep<S>,
    /// Time constant of the D/A (s), for steps that a new word divides.
    pub(super) tau: f64,
    /// What leaks of the signal past the D/A, whatever its word.
    pub(super) past: Feedthrough<S>,
}

/// All of them, and how many meet at one amplifier.
#[derive(Debug, Clone)]
pub(super) struct Grid<S> {
    pub(super) cells: Vec<Cell<S>>,
    pub(super) inputs: usize,
}

/// Wires of a cell at a sample: of a group, or of a group in a vector.
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

impl<S: Real> Wires<Lanes<S>> {
    #[inline(always)]
    fn load<L: Simd>(&self, simd: L) -> Wires<S::Vector<L>> {
        Wires {
            product_left: load::<L, S>(simd, &self.product_left),
            product: load::<L, S>(simd, &self.product),
            weight: load::<L, S>(simd, &self.weight),
            term_left: load::<L, S>(simd, &self.term_left),
            term: load::<L, S>(simd, &self.term),
        }
    }

    #[inline(always)]
    fn store<L: Simd>(&mut self, wires: &Wires<S::Vector<L>>) {
        wires.product_left.store_slice(&mut self.product_left.0);
        wires.product.store_slice(&mut self.product.0);
        wires.weight.store_slice(&mut self.weight.0);
        wires.term_left.store_slice(&mut self.term_left.0);
        wires.term.store_slice(&mut self.term.0);
    }
}

#[inline(always)]
fn load<L: Simd, S: Real>(simd: L, lanes: &Lanes<S>) -> S::Vector<L> {
    S::Vector::<L>::from_slice(simd, &lanes.0)
}

impl<S: Real> Cell<S> {
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

    /// Product and term a step later; `x` with its square, and its change over the step.
    #[inline(always)]
    fn step<V: Wire<S>>(&self, wires: &mut Wires<V>, x: [V; 2], change: V, y: V) {
        let raw = self.multiplier.product_of(x, y) + self.leak.of_change(change);
        wires.product = self.lag.end(wires.product_left, raw);
        wires.product_left = self.lag.leave(wires.product, raw);
        wires.term = self.converter.end(wires.term_left, wires.product * wires.weight);
    }

    /// What comes out at the end of a step that the product has begun with `before`.
    #[inline(always)]
    fn put<V: Wire<S>>(&self, wires: &mut Wires<V>, before: V) -> V {
        wires.term_left = self.converter.leave(wires.term, wires.product * wires.weight);
        wires.term + self.past.of_change(wires.product - before)
    }
}

/// Cells side by side on their way through a block: a step of a lag waits for the one before, but not for those of
/// another cell.
struct Beside<'a, S: Real, L: Simd, const N: usize> {
    cells: [Cell<S>; N],
    wires: [Wires<S::Vector<L>>; N],
    x: [&'a Factor<S>; N],
    y: [&'a Row<S>; N],
}

impl<S: Real, L: Simd, const N: usize> Beside<'_, S, L, N> {
    /// Steps without a new word; adds what comes out to `sums`.
    #[inline(always)]
    fn steps(&mut self, simd: L, samples: Range<usize>, sums: &mut Row<S>) {
        for n in samples.start..samples.end.min(BLOCK) {
            let mut sum = load::<L, S>(simd, &sums[n]);
            for k in 0..N {
                let before = self.step(simd, k, n);
                sum += self.cells[k].put(&mut self.wires[k], before);
            }
            sum.store_slice(&mut sums[n].0);
        }
    }

    /// The step to sample `n`, in which `words` act on D/As from number `first` on.
    #[inline(always)]
    fn step_with(&mut self, simd: L, n: usize, (words, first): (&Words, usize), sum: &mut Lanes<S>) {
        let mut out = load::<L, S>(simd, sum);
        for k in 0..N {
            let before = self.step(simd, k, n);
            for words in words.acting(first + k, n) {
                words.act::<L, S>(simd, before, &mut self.wires[k]);
            }
            out += self.cells[k].put(&mut self.wires[k], before);
        }
        out.store_slice(&mut sum.0);
    }

    /// Product and term of cell `k` at sample `n`; the product a sample before.
    #[inline(always)]
    fn step(&mut self, simd: L, k: usize, n: usize) -> S::Vector<L> {
        let before = self.wires[k].product;
        let Factor { value, square, change } = self.x[k];
        let x = [load::<L, S>(simd, &value[n]), load::<L, S>(simd, &square[n])];
        let [change, y] = [load::<L, S>(simd, &change[n]), load::<L, S>(simd, &self.y[k][n])];
        self.cells[k].step(&mut self.wires[k], x, change, y);
        before
    }
}

impl<S: Real> Grid<S> {
    /// Amplifiers of the first stage of one sum.
    pub(super) fn groups(&self) -> usize {
        TERMS.div_ceil(self.inputs)
    }

    /// Everything at rest under the factors at the first sample of the block; the weights stay.
    pub(super) fn settle(&self, block: &mut Block<S>, wires: &mut [Wires<Lanes<S>>]) {
        let Block { x, y, partial, .. } = block;
        for (group, out) in partial.iter_mut().enumerate() {
            let mut sum = Lanes::default();
            let range = self.members(group);
            for (cell, wires) in self.cells[range.clone()].iter().zip(&mut wires[range]) {
                let [a, b] = cell.factors;
                *wires = cell.at_rest([x[a].value[0], y[b][0]], wires.weight);
                sum = sum + wires.term;
            }
            out[0] = sum;
        }
    }

    /// The first `count` samples of a block, after those before it.
    #[inline(always)]
    pub(super) fn run<L: Simd>(
        &self,
        simd: L,
        block: &mut Block<S>,
        count: usize,
        words: &Words,
        wires: &mut [Wires<Lanes<S>>],
    ) {
        let Block { x, y, partial, .. } = block;
        for (group, sums) in partial.iter_mut().enumerate() {
            *sums = [Lanes::default(); BLOCK];
            let Range { start: mut first, end } = self.members(group);
            while first < end {
                let block = (&*x, &*y, count, words);
                first += if first + 1 < end {
                    self.run_some::<L, 2>(simd, first, block, wires, sums)
                } else {
                    self.run_some::<L, 1>(simd, first, block, wires, sums)
                };
            }
        }
    }

    /// `N` cells of a group from number `first` on through a block.
    #[inline(always)]
    fn run_some<L: Simd, const N: usize>(
        &self,
        simd: L,
        first: usize,
        (x, y, count, words): (&[Factor<S>; UNITS], &[Row<S>; UNITS], usize, &Words),
        wires: &mut [Wires<Lanes<S>>],
        sums: &mut Row<S>,
    ) -> usize {
        let mut beside = Beside::<S, L, N> {
            cells: [self.cells[first]; N],
            wires: [wires[first].load(simd); N],
            x: [&x[0]; N],
            y: [&y[0]; N],
        };
        for k in 0..N {
            let cell = self.cells[first + k];
            (beside.x[k], beside.y[k]) = (&x[cell.factors[0]], &y[cell.factors[1]]);
            (beside.cells[k], beside.wires[k]) = (cell, wires[first + k].load(simd));
        }
        let mut done = 0;
        for n in words.samples(first..first + N) {
            beside.steps(simd, done..n, sums);
            beside.step_with(simd, n, (words, first), &mut sums[n]);
            done = n + 1;
        }
        beside.steps(simd, done..count, sums);
        for k in 0..N {
            wires[first + k].store::<L>(&beside.wires[k]);
        }
        N
    }

    /// The cells of a group.
    fn members(&self, group: usize) -> Range<usize> {
        let (sum, part) = (group / self.groups(), group % self.groups());
        let first = TERMS * sum + self.inputs * part;
        first..(first + self.inputs).min(TERMS * (sum + 1))
    }
}
