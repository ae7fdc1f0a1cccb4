//! Lag of a part that solves its law by what stands in its feedback: a root or a divider.
//!
//! ```text
//! u ─▶ amplifier ─┬─▶ y          tau y' = g (q - y)
//!         ▲       │
//!         └── g ◀─┘              g: gain of the feedback; q: what the loop comes to rest at
//! ```
//!
//! **Law.** Over a step h the gain is the mean of what it is at both ends, and q is a straight line between them. With
//! `r = g h / tau` and `k = e^-r`, `f = (1 - k) / r`, exactly: `y1 = k y0 + (f - k) q0 + (1 - f) q1`.
//! **Parameters.** h and tau in seconds; tau is that of a gain of 1. `tau = 0`: y is q, to the bit.
//! **State and timing.** One value.
//! **Numbers.** f is summed at a 64th of r and doubled six times, and k is `1 - r f`: both are right to 2e-15.
//! No table and no branch: numbers go side by side. Beyond r = 40 nothing is left of y0.

use signal::{Comparable, Truth};

use crate::Wire;

/// Largest `r` of which anything is left, e^-40 being 4e-18.
const FORGOTTEN: f64 = 40.0;

/// Halvings of `r`, and as many doublings.
const HALVINGS: usize = 6;

/// `(1 - e^-x) / x` by powers of x, of x up to 40 / 64.
const SERIES: [f64; 15] = series();

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoopLag {
    /// Step over time constant, of a gain of 1.
    ratio: f64,
}

impl LoopLag {
    /// Step of `h` seconds, time constant `tau` (s).
    pub fn new(h: f64, tau: f64) -> Self {
        Self { ratio: if tau == 0.0 { f64::INFINITY } else { h / tau } }
    }

    /// Output at the end of a step, from `y` at its start; `rest` is what the loop comes to rest at, and `gain` (above 0) that of its
    /// feedback, at its start and end.
    #[inline(always)]
    pub fn step<V: Wire<f64> + Comparable>(&self, y: V, rest: [V; 2], gain: [V; 2]) -> V {
        let r = (gain[0] + gain[1]) * (0.5 * self.ratio);
        let [keep, mean] = shares(r);
        y * keep + rest[0] * (mean - keep) + rest[1] * (y.like(1.0) - mean)
    }
}

/// `e^-r` and `(1 - e^-r) / r`.
#[inline(always)]
fn shares<V: Comparable>(r: V) -> [V; 2] {
    // No closures: these would be compiled without the width of vectors of whoever asks.
    let (zero, one, half, most) = (r.like(0.0), r.like(1.0), r.like(0.5), r.like(FORGOTTEN));
    let mut x = r.at_most(most) * r.like(1.0 / 64.0);
    let mut mean = r.like(SERIES[SERIES.len() - 1]);
    for &power in SERIES[..SERIES.len() - 1].iter().rev() {
        mean = mean * x + r.like(power);
    }
    let mut keep = one - x * mean;
    for _ in 0..HALVINGS {
        mean = mean * (one + keep) * half;
        x = x + x;
        keep = one - x * mean;
    }
    let is_forgotten = r.is_above(most);
    [is_forgotten.choose(zero, keep), is_forgotten.choose(one / r, mean)]
}

/// `(-1)^n / (n + 1)!`.
const fn series() -> [f64; 15] {
    let mut powers = [1.0; 15];
    let mut n = 1;
    while n < 15 {
        powers[n] = -powers[n - 1] / (n as f64 + 1.0);
        n += 1;
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::{LoopLag, shares};
    use crate::LagStep;

    #[test]
    fn shares_are_those_of_an_exponential() {
        for n in 0..4000 {
            let r = libm::exp2(-40.0 + 0.0125 * f64::from(n));
            let [keep, mean] = shares(r);
            assert!((keep - libm::exp(-r)).abs() < 2e-15, "{r}: {keep}");
            assert!((mean + libm::expm1(-r) / r).abs() < 2e-15, "{r}: {mean}");
        }
    }

    #[test]
    fn a_gain_that_stands_is_a_lag() {
        for (h, tau, gain) in [(50e-9, 20e-9, 1.0), (50e-9, 20e-9, 0.1), (1e-9, 1e-3, 0.5), (1.0, 0.01, 1.0)]
        {
            let (part, lag) = (LoopLag::new(h, tau), LagStep::<f64>::new(h, tau / gain));
            let found = part.step(0.3, [-0.2, 0.7], [gain; 2]);
            assert!((found - lag.step(0.3, -0.2, 0.7)).abs() < 1e-14, "{h} {tau} {gain}: {found}");
        }
    }

    #[test]
    fn no_time_constant_is_what_it_rests_at() {
        let part = LoopLag::new(50e-9, 0.0);
        assert_eq!(part.step(0.3, [-0.2, 0.7], [0.001, 1.0]), 0.7);
    }

    /// A tenth of the gain is a tenth of the bandwidth: what a step has left after a time t is e^-(g t / tau).
    #[test]
    fn a_step_is_left_by_its_gain() {
        let (h, tau) = (10e-9, 40e-9);
        let part = LoopLag::new(h, tau);
        for gain in [1.0, 0.1] {
            let mut y = 0.0;
            (0..7).for_each(|_| y = part.step(y, [1.0; 2], [gain; 2]));
            assert!((1.0 - y - libm::exp(-7.0 * gain * h / tau)).abs() < 1e-14, "{gain}: {y}");
        }
    }
}
