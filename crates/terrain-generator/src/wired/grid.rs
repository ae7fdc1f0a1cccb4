//! The 3 x 36 multipliers, each with the multiplying D/A behind it, and the first sums of their terms.
//!
//! Nearly all parts of a machine stand here, so the loop over them is the machine's cost: coefficients stand side by side,
//! eight lanes go through a part without a branch, and each lag keeps what it leaves for the next sample instead of its
//! input and output. A part that is ideal has the coefficients of one.

use parts::{Feedthrough, LagStep, Multiplier};
use signal::{LANES, Lanes, Real};

use super::basis::UNITS;
use super::terms::TERMS;

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
    /// What leaks of the signal past the D/A, whatever its word.
    pub(super) past: Feedthrough<S>,
}

/// All of them, and how many meet at one amplifier.
#[derive(Debug, Clone)]
pub(super) struct Grid<S> {
    pub(super) cells: Vec<Cell<S>>,
    pub(super) inputs: usize,
}

/// Wires of a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wires<S> {
    /// What the multiplier's lag leaves for the next sample.
    product_left: Lanes<S>,
    /// Product, now and a sample ago.
    pub(super) product: Lanes<S>,
    pub(super) before: Lanes<S>,
    /// What the D/A multiplies by.
    pub(super) weight: Lanes<S>,
    /// What the D/A's lag leaves for the next sample.
    pub(super) term_left: Lanes<S>,
    pub(super) term: Lanes<S>,
}

impl<S: Real> Cell<S> {
    /// The wires at rest under factors that stand.
    fn at_rest(&self, [x, y]: [Lanes<S>; 2], weight: Lanes<S>) -> Wires<S> {
        let product = self.multiplier.product(x, y);
        let term = product * weight;
        Wires {
            product_left: self.lag.leave(product, product),
            product,
            before: product,
            weight,
            term_left: self.converter.leave(term, term),
            term,
        }
    }

    /// A step later; adds the term to `sum`. `change` is that of X over the step.
    #[inline(always)]
    fn step(&self, wires: &mut Wires<S>, x: &Lanes<S>, change: &Lanes<S>, y: &Lanes<S>, sum: &mut Lanes<S>) {
        for n in 0..LANES {
            let raw = self.multiplier.product(x.0[n], y.0[n]) + self.leak.of_change(change.0[n]);
            let product = self.lag.end(wires.product_left.0[n], raw);
            wires.product_left.0[n] = self.lag.leave(product, raw);
            let before = wires.product.0[n];
            wires.before.0[n] = before;
            wires.product.0[n] = product;
            let weighted = product * wires.weight.0[n];
            let term = self.converter.end(wires.term_left.0[n], weighted);
            wires.term_left.0[n] = self.converter.leave(term, weighted);
            wires.term.0[n] = term;
            sum.0[n] += term + self.past.of_change(product - before);
        }
    }
}

impl<S: Real> Grid<S> {
    /// Amplifiers of the first stage of one sum.
    pub(super) fn groups(&self) -> usize {
        TERMS.div_ceil(self.inputs)
    }

    /// Everything at rest; the weights stay.
    pub(super) fn settle(
        &self,
        factors: &[[Lanes<S>; UNITS]; 2],
        wires: &mut [Wires<S>],
        sums: &mut [Lanes<S>],
    ) {
        for (cell, wires) in self.cells.iter().zip(wires.iter_mut()) {
            let [x, y] = cell.factors;
            *wires = cell.at_rest([factors[0][x], factors[1][y]], wires.weight);
        }
        for (group, sum) in sums.iter_mut().enumerate() {
            *sum = self.sum(group, wires);
        }
    }

    /// A step later: `factors` at its end, `before` at its start. `sums` are those of the first stages, group by group.
    #[inline(always)]
    pub(super) fn step(
        &self,
        [x, y]: &[[Lanes<S>; UNITS]; 2],
        before: &[Lanes<S>; UNITS],
        wires: &mut [Wires<S>],
        sums: &mut [Lanes<S>],
    ) {
        let mut change = *x;
        for (change, &before) in change.iter_mut().zip(before) {
            *change = *change - before;
        }
        for (group, out) in sums.iter_mut().enumerate() {
            let range = self.members(group);
            let mut sum = Lanes::default();
            for (cell, wires) in self.cells[range.clone()].iter().zip(&mut wires[range]) {
                let [a, b] = cell.factors;
                cell.step(wires, &x[a], &change[a], &y[b], &mut sum);
            }
            *out = sum;
        }
    }

    /// What meets in a group, from its wires.
    pub(super) fn sum(&self, group: usize, wires: &[Wires<S>]) -> Lanes<S> {
        let range = self.members(group);
        let mut sum = Lanes::default();
        for (cell, wires) in self.cells[range.clone()].iter().zip(&wires[range]) {
            sum = sum + (wires.term + cell.past.of_change(wires.product - wires.before));
        }
        sum
    }

    /// The group in which cell `index` has its term.
    pub(super) fn group_of(&self, index: usize) -> usize {
        index / TERMS * self.groups() + index % TERMS / self.inputs
    }

    /// The cells of a group.
    fn members(&self, group: usize) -> std::ops::Range<usize> {
        let (sum, part) = (group / self.groups(), group % self.groups());
        let first = TERMS * sum + self.inputs * part;
        first..(first + self.inputs).min(TERMS * (sum + 1))
    }
}

impl<S: Real> Default for Wires<S> {
    fn default() -> Self {
        let zero = Lanes::default();
        Self { product_left: zero, product: zero, before: zero, weight: zero, term_left: zero, term: zero }
    }
}
