//! The 3 x 36 multipliers, each with the multiplying D/A behind it, and the first sums of their terms.
//!
//! Nearly all parts of a machine stand here, so the loop over them is the machine's cost: a block of samples goes through one
//! cell after the other, eight lanes in a vector, and is divided only where a D/A takes a new word. Each lag keeps what it
//! leaves for the next sample instead of its input and output. A part that is ideal has the coefficients of one.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use parts::{Feedthrough, LagStep, Multiplier, Wire};
use signal::{Lanes, Real};

use super::block::{BLOCK, Block, Factor, Row};
use super::terms::TERMS;
use super::words::{Acting, Words};

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

    /// Steps without a new word; adds what comes out to `sums`.
    #[inline(always)]
    fn steps<L: Simd>(
        &self,
        simd: L,
        wires: &mut Wires<S::Vector<L>>,
        (x, y): (&Factor<S>, &Row<S>),
        samples: Range<usize>,
        sums: &mut Row<S>,
    ) {
        let x =
            x.value[samples.clone()].iter().zip(&x.square[samples.clone()]).zip(&x.change[samples.clone()]);
        let fed = x.zip(&y[samples.clone()]);
        for ((((value, square), change), y), sum) in fed.zip(&mut sums[samples]) {
            let before = wires.product;
            let x = [load::<L, S>(simd, value), load::<L, S>(simd, square)];
            self.step(wires, x, load::<L, S>(simd, change), load::<L, S>(simd, y));
            (load::<L, S>(simd, sum) + self.put(wires, before)).store_slice(&mut sum.0);
        }
    }

    /// The step to sample `n`, in which `words` act.
    #[inline(always)]
    fn step_with<'w, L: Simd>(
        &self,
        simd: L,
        words: impl Iterator<Item = &'w Acting>,
        wires: &mut Wires<S::Vector<L>>,
        (x, y): (&Factor<S>, &Row<S>),
        n: usize,
        sum: &mut Lanes<S>,
    ) {
        let before = wires.product;
        let square = [load::<L, S>(simd, &x.value[n]), load::<L, S>(simd, &x.square[n])];
        self.step(wires, square, load::<L, S>(simd, &x.change[n]), load::<L, S>(simd, &y[n]));
        for words in words {
            words.act::<L, S>(simd, before, wires);
        }
        (load::<L, S>(simd, sum) + self.put(wires, before)).store_slice(&mut sum.0);
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
            for index in self.members(group) {
                let cell = &self.cells[index];
                let [a, b] = cell.factors;
                let fed = (&x[a], &y[b]);
                let changes = words.of(index);
                let (mut now, mut done) = (wires[index].load(simd), 0);
                for n in changes.samples() {
                    cell.steps(simd, &mut now, fed, done..n, sums);
                    cell.step_with(simd, words.acting(changes, n), &mut now, fed, n, &mut sums[n]);
                    done = n + 1;
                }
                cell.steps(simd, &mut now, fed, done..count, sums);
                wires[index].store(&now);
            }
        }
    }

    /// The cells of a group.
    fn members(&self, group: usize) -> Range<usize> {
        let (sum, part) = (group / self.groups(), group % self.groups());
        let first = TERMS * sum + self.inputs * part;
        first..(first + self.inputs).min(TERMS * (sum + 1))
    }
}
