//! A multiplier and the multiplying D/A behind it.
//!
//! **How it is computed.** Each lag keeps what it leaves for the next sample instead of its input and output, and what comes
//! before and behind it is put together with it ([`CellStep`]). A part that is ideal has the coefficients of one.

use fearless_simd::Simd;
use parts::{Feedthrough, LagStep, Multiplier, Wire};
use signal::{Both, Double, Lanes, Real};

/// A multiplier and its D/A.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell<S> {
    pub(super) parts: CellParts<S>,
    /// Time constant of the D/A (s), for steps that a new word divides.
    pub(super) tau: f64,
}

/// Figures of its parts.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellParts<S> {
    pub(super) multiplier: Multiplier<S>,
    /// What leaks of the first input past the multiplier.
    pub(super) leak: Feedthrough<S>,
    pub(super) lag: LagStep<S>,
    pub(super) converter: LagStep<S>,
    /// What leaks of the signal past the D/A, whatever its word.
    pub(super) past: Feedthrough<S>,
}

/// What a step of a cell takes, or of two cells side by side.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellStep<T> {
    /// The multiplier and its leak, times what its lag makes of an input at the end of the step.
    multiplier: Multiplier<T>,
    leak: Feedthrough<T>,
    /// Share that the multiplier's lag keeps of what it was left.
    keep: T,
    /// What it leaves of what it makes of its input.
    rest: T,
    pub(super) converter: LagStep<T>,
    /// What the D/A's lag leaves of its input.
    converter_rest: T,
    past: T,
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
    pub(super) term_left: V,
    pub(super) term: V,
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

    pub(super) fn set(&mut self, wire: usize, wires: &Wires<Lanes<S>>) {
        self.product_left.set(wire, wires.product_left);
        self.product.set(wire, wires.product);
        self.weight.set(wire, wires.weight);
        self.term_left.set(wire, wires.term_left);
        self.term.set(wire, wires.term);
    }
}

impl<V: Copy> Wires<V> {
    /// The product a step later, at the end of which the multiplier's lag makes `raw` of its input.
    #[inline(always)]
    fn take<S: Copy>(&mut self, step: &CellStep<S>, raw: V)
    where
        V: Wire<S>,
    {
        self.product = self.product_left + raw;
        self.product_left = self.product_left * step.keep + raw * step.rest;
    }
}

impl<S: Copy> CellStep<S> {
    /// Each figure of this step with that of another, through `f`.
    pub(super) fn beside<T>(&self, other: &Self, f: impl Fn(S, S) -> T) -> CellStep<T> {
        CellStep {
            multiplier: self.multiplier.beside(&other.multiplier, &f),
            leak: self.leak.beside(&other.leak, &f),
            keep: f(self.keep, other.keep),
            rest: f(self.rest, other.rest),
            converter: self.converter.beside(&other.converter, &f),
            converter_rest: f(self.converter_rest, other.converter_rest),
            past: f(self.past, other.past),
        }
    }

    /// The product a step later; `x` with its cube, and its change over the step.
    #[inline(always)]
    pub(super) fn multiply<V: Wire<S>>(&self, wires: &mut Wires<V>, x: [V; 2], change: V, y: V) {
        wires.take(self, self.multiplier.product_of(x, y) + self.leak.of_change(change));
    }

    /// The same of a multiplier without an error and without a leak.
    #[inline(always)]
    pub(super) fn multiply_ideally<V: Wire<S>>(&self, wires: &mut Wires<V>, x: V, y: V) {
        wires.take(self, self.multiplier.ideal_product(x, y));
    }

    /// What the D/A makes of a product at the end of a step, there and for the next, while its word stays.
    #[inline(always)]
    pub(super) fn weights<V: Wire<S>>(&self, weight: V) -> [V; 2] {
        [weight * self.converter.to + self.past, weight * self.converter_rest]
    }

    /// What comes out of the D/A at the end of a step that the product has begun with `before`.
    #[inline(always)]
    pub(super) fn convert<V: Wire<S>>(&self, wires: &mut Wires<V>, before: V, [now, rest]: [V; 2]) -> V {
        let out = wires.term_left + wires.product * now - before * self.past;
        wires.term_left = wires.term_left * self.converter.keep + wires.product * rest;
        out
    }

    /// What of `out` has not leaked past the D/A.
    #[inline(always)]
    pub(super) fn term<V: Wire<S>>(&self, wires: &Wires<V>, before: V, out: V) -> V {
        out - (wires.product - before) * self.past
    }
}

impl<S: Real> CellParts<S> {
    /// What their steps take.
    pub(super) fn step(&self) -> CellStep<S> {
        let LagStep { keep, to, .. } = self.lag;
        CellStep {
            multiplier: self.multiplier.times(to),
            leak: self.leak.times(to),
            keep,
            rest: if to > S::ZERO { self.lag.rest() / to } else { S::ZERO },
            converter: self.converter,
            converter_rest: self.converter.rest(),
            past: self.past.gain(),
        }
    }

    /// The wires at rest under factors that stand.
    pub(super) fn at_rest(&self, [x, y]: [Lanes<S>; 2], weight: Lanes<S>) -> Wires<Lanes<S>> {
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

impl<S: Real> CellStep<Both<S>> {
    #[inline(always)]
    pub(super) fn load<L: Simd>(&self, simd: L) -> CellStep<S::Double<L>> {
        self.beside(self, |figure, _| S::Double::<L>::load(simd, &figure))
    }
}
