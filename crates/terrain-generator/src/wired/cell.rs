//! A multiplier and the multiplying D/A behind it.
//!
//! Each lag keeps what it leaves for the next sample instead of its input and output. A part that is ideal has the
//! coefficients of one.

use fearless_simd::Simd;
use parts::{Feedthrough, LagStep, Multiplier, Wire};
use signal::{Both, Double, Lanes, Real};

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
    pub(super) fn beside<T>(&self, other: &Self, f: impl Fn(S, S) -> T) -> CellParts<T> {
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
    pub(super) fn step<V: Wire<S>>(&self, wires: &mut Wires<V>, x: [V; 2], change: V, y: V) {
        wires.multiply(self, x, change, y);
        wires.term = self.converter.end(wires.term_left, wires.product * wires.weight);
    }

    /// What comes out at the end of a step that the product has begun with `before`.
    #[inline(always)]
    pub(super) fn put<V: Wire<S>>(&self, wires: &mut Wires<V>, before: V) -> V {
        wires.term_left = self.converter.leave(wires.term, wires.product * wires.weight);
        wires.term + self.past.of_change(wires.product - before)
    }
}

impl<S: Real> CellParts<S> {
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
