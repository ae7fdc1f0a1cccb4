//! Analog multiplier.
//!
//! **Law** (section 6), full scale 1: `y = (1 + eg) a b + ex a + ey b + eo + en a (1 - a^2)`, then a lag
//! ([`crate::LagStep`]). What leaks past it at high frequency is the rate of an input times a constant
//! ([`Feedthrough`]); it is added to the product.
//! **Parameters.** [`MultiplierLaw`], shares of full scale.
//! **State and timing.** None.

use std::f64::consts::PI;

use signal::Real;

use crate::Wire;

/// Static errors of a multiplier, shares of full scale; all 0 is an ideal product.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MultiplierLaw {
    /// eg: relative error of the scale.
    pub gain: f64,
    /// ex: feedthrough of the first input.
    pub feed_a: f64,
    /// ey: feedthrough of the second input.
    pub feed_b: f64,
    /// eo: constant offset of the output.
    pub offset: f64,
    /// en: nonlinearity of the first input.
    pub nonlinearity: f64,
}

/// The multiplier with its static errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Multiplier<S> {
    gain: S,
    linear: S,
    feed_b: S,
    offset: S,
    cubic: S,
}

impl<S: Real> Multiplier<S> {
    /// In the scalar of the run.
    pub fn new(law: &MultiplierLaw) -> Self {
        Self {
            gain: S::from_f64(1.0 + law.gain),
            linear: S::from_f64(law.feed_a + law.nonlinearity),
            feed_b: S::from_f64(law.feed_b),
            offset: S::from_f64(law.offset),
            cubic: S::from_f64(law.nonlinearity),
        }
    }
}

impl<S: Real> Multiplier<S> {
    /// Whether it is the product and nothing else.
    pub fn is_ideal(&self) -> bool {
        *self == Self::new(&MultiplierLaw::default())
    }
}

impl<S: Real> Multiplier<S> {
    /// The part with something behind it that multiplies by `factor`.
    pub fn times(&self, factor: S) -> Self {
        self.each(|figure| figure * factor)
    }
}

impl<S: Copy> Multiplier<S> {
    /// Each figure of this part with that of another, through `f`.
    #[inline(always)]
    pub fn beside<T>(&self, other: &Self, f: impl Fn(S, S) -> T) -> Multiplier<T> {
        Multiplier {
            gain: f(self.gain, other.gain),
            linear: f(self.linear, other.linear),
            feed_b: f(self.feed_b, other.feed_b),
            offset: f(self.offset, other.offset),
            cubic: f(self.cubic, other.cubic),
        }
    }

    /// Each figure of this part through `f`.
    #[inline(always)]
    pub fn each<T>(&self, f: impl Fn(S) -> T) -> Multiplier<T> {
        self.beside(self, |figure, _| f(figure))
    }

    /// The product of `a` and `b`, where there is no error ([`is_ideal`](Self::is_ideal), with something behind it that
    /// multiplies).
    #[inline(always)]
    pub fn ideal_product<V: Wire<S>>(&self, a: V, b: V) -> V {
        a * self.gain * b
    }

    /// The product of `a` and `b` with its static errors.
    #[inline(always)]
    pub fn product<V: Wire<S>>(&self, a: V, b: V) -> V {
        self.product_of([a, a * (a * a)], b)
    }

    /// The same, of `a` and its cube.
    #[inline(always)]
    pub fn product_of<V: Wire<S>>(&self, [a, cube]: [V; 2], b: V) -> V {
        (a * self.gain + self.feed_b) * b + (a * self.linear - cube * self.cubic + self.offset)
    }
}

/// A leak in proportion to an input's rate: `k u'`, the mean over the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feedthrough<S> {
    gain: S,
}

impl<S: Real> Feedthrough<S> {
    /// Leak of `share` of a sine wave of `frequency` (Hz), for steps of `h` seconds: `k = share / (2 pi f)`.
    pub fn new(h: f64, share: f64, frequency: f64) -> Self {
        Self { gain: S::from_f64(share / (2.0 * PI * frequency) / h) }
    }
}

impl<S: Real> Feedthrough<S> {
    /// Returns whether nothing leaks past the part.
    pub fn is_none(&self) -> bool {
        self.gain == S::ZERO
    }

    /// The leak behind something that multiplies by `factor`.
    pub fn times(&self, factor: S) -> Self {
        Self { gain: self.gain * factor }
    }
}

impl<S: Copy> Feedthrough<S> {
    /// What it makes of a change by 1 over a step.
    pub fn gain(&self) -> S {
        self.gain
    }

    /// The figure of this part with that of another, through `f`.
    #[inline(always)]
    pub fn beside<T>(&self, other: &Self, f: impl Fn(S, S) -> T) -> Feedthrough<T> {
        Feedthrough { gain: f(self.gain, other.gain) }
    }

    /// The figure of this part through `f`.
    #[inline(always)]
    pub fn each<T>(&self, f: impl Fn(S) -> T) -> Feedthrough<T> {
        self.beside(self, |figure, _| f(figure))
    }

    /// The leak over a step with the input `u0`, `u1` at its start and end.
    #[inline(always)]
    pub fn leak<V: Wire<S>>(&self, u0: V, u1: V) -> V {
        self.of_change(u1 - u0)
    }

    /// The leak over a step in which the input changes by `change`.
    #[inline(always)]
    pub fn of_change<V: Wire<S>>(&self, change: V) -> V {
        change * self.gain
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use signal::Lanes;

    use super::{Feedthrough, Multiplier, MultiplierLaw};

    const LAW: MultiplierLaw =
        MultiplierLaw { gain: 0.002, feed_a: 0.001, feed_b: -0.0015, offset: 4e-4, nonlinearity: 0.0025 };

    #[test]
    fn as_the_law_is_written() {
        let multiplier = Multiplier::<f64>::new(&LAW);
        for (a, b) in [(0.0, 0.0), (1.0, 1.0), (-1.0, 0.5), (0.58, -0.3), (0.0, 1.0)] {
            let errors = LAW.feed_a * a + LAW.feed_b * b + LAW.offset + LAW.nonlinearity * a * (1.0 - a * a);
            let law = (1.0 + LAW.gain) * a * b + errors;
            assert!((multiplier.product(a, b) - law).abs() < 1e-15);
            let lanes = multiplier.product(Lanes::splat(a), Lanes::splat(b));
            assert_eq!(lanes, Lanes::splat(multiplier.product(a, b)));
        }
    }

    #[test]
    fn an_ideal_product_is_the_product() {
        let ideal = Multiplier::<f64>::new(&MultiplierLaw::default());
        assert_eq!(ideal.product(0.3, -0.7), 0.3 * -0.7);
        assert_eq!(ideal.times(0.25).ideal_product(0.3, -0.7), ideal.times(0.25).product(0.3, -0.7));
    }

    #[test]
    fn what_stands_behind_it_multiplies_errors_too() {
        let multiplier = Multiplier::<f64>::new(&LAW);
        let [behind, alone] = [multiplier.times(0.3).product(0.58, -0.3), multiplier.product(0.58, -0.3)];
        assert!((behind - 0.3 * alone).abs() < 1e-16, "{behind} {alone}");
    }

    #[test]
    fn a_sine_wave_leaks_its_share() {
        let h = 1e-9;
        let leak = Feedthrough::<f64>::new(h, 0.005, 1e6);
        let wave = |i: i32| libm::sin(2.0 * PI * 1e6 * f64::from(i) * h);
        let most = (0..1000).map(|i| leak.leak(wave(i), wave(i + 1)).abs()).fold(0.0, f64::max);
        assert!((most - 0.005).abs() < 1e-7, "{most}");
    }
}
