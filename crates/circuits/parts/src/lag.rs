//! Lag: one pole.
//!
//! ```text
//! u ─▶ 1 / (1 + s tau) ─▶ y        tau = 1 / (2 pi B)
//! ```
//!
//! **Law** (section 6). `tau y' = u - y`. Over a step h with `r = h / tau`, exactly:
//! - input a straight line ([`LagStep::new`]): `y1 = k y0 + (f - k) u0 + (1 - f) u1`, `k = e^-r`, `f = (1 - k) / r`;
//! - input that jumps from u0 to u1 at a share p of the step ([`LagStep::jump`]):
//!   `y1 = k y0 + (e^-(1-p)r - k) u0 + (1 - e^-(1-p)r) u1`;
//! - input of two straight lines ([`SplitLag`]): a fold, or a jump between ramps.
//!
//! **Parameters.** h and tau in seconds. `tau = 0`: y is u, to the bit. `tau` infinite: y stays, to the bit.
//! **State and timing.** One value.
//! **Numbers.** The three coefficients add up to 1 in the scalar of the run, so the gain is 1 however slow the lag. What
//! rounding leaves is `epsilon tau / h`, of the time constant and of the signal.
//! **Fold** of a ramp of slope s with this lag: the peak is short by `s tau ln 2`.

use std::f64::consts::{LN_2, LOG2_E};

use signal::Real;

use crate::Wire;
use crate::whole::{WHOLE, whole};

/// One step: `y1 = keep y0 + from u0 + to u1`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LagStep<S> {
    /// Share of the output that stays.
    pub keep: S,
    /// Weight of the input at the start of the step.
    pub from: S,
    /// Weight of the input at its end.
    pub to: S,
}

impl<S: Real> LagStep<S> {
    /// Step of `h` seconds with time constant `tau` (s) for an input that is a straight line over the step.
    /// A part of a step is `LagStep::new(h * share, tau)`.
    pub fn new(h: f64, tau: f64) -> Self {
        let [input, to_share] = straight(ratio(h, tau));
        Self::balanced(1.0 - input, to_share)
    }

    /// Step of `h` seconds for an input that is u0 up to `share` (0..=1) of the step and u1 from there on.
    pub fn jump(h: f64, tau: f64, share: f64) -> Self {
        let keep = libm::exp(-ratio(h, tau));
        let to = -libm::expm1(-ratio(h * (1.0 - share), tau));
        Self::balanced(keep, if to == 0.0 { 0.0 } else { to / (1.0 - keep) })
    }

    /// Step of `h` seconds for an input that holds u0 throughout (zero-order hold).
    pub fn held(h: f64, tau: f64) -> Self {
        Self::jump(h, tau, 1.0)
    }

    /// What an input of 1 at the end of a step leaves for the end of the next: `end` and `leave` in one, so that the next step
    /// waits for a product and a sum alone.
    pub fn rest(&self) -> S {
        self.to * self.keep + self.from
    }

    /// `to_share`: the part of the input's weight that u1 has.
    fn balanced(keep: f64, to_share: f64) -> Self {
        let keep = S::from_f64(keep);
        let input = S::ONE - keep;
        let to = input * S::from_f64(to_share);
        Self { keep, from: input - to, to }
    }
}

impl<S: Copy> LagStep<S> {
    /// Each figure of this step with that of another, through `f`.
    #[inline(always)]
    pub fn beside<T>(&self, other: &Self, f: impl Fn(S, S) -> T) -> LagStep<T> {
        LagStep { keep: f(self.keep, other.keep), from: f(self.from, other.from), to: f(self.to, other.to) }
    }

    /// Each figure of this step through `f`.
    #[inline(always)]
    pub fn each<T>(&self, f: impl Fn(S) -> T) -> LagStep<T> {
        self.beside(self, |figure, _| f(figure))
    }

    /// Output at the end of the step: `y` at its start, input `u0`, `u1` at its start and end.
    #[inline(always)]
    pub fn step<V: Wire<S>>(&self, y: V, u0: V, u1: V) -> V {
        // The next step waits for a product and a sum.
        y * self.keep + (u0 * self.from + u1 * self.to)
    }

    /// What output `y` and input `u0` at the start of a step leave for its end: what of [`LagStep::step`] is known a sample
    /// before.
    #[inline(always)]
    pub fn leave<V: Wire<S>>(&self, y: V, u0: V) -> V {
        y * self.keep + u0 * self.from
    }

    /// Output at the end of a step, from what was left for it and the input `u1` there.
    #[inline(always)]
    pub fn end<V: Wire<S>>(&self, left: V, u1: V) -> V {
        left + u1 * self.to
    }
}

/// Steps of several lags side by side, for an input that is a straight line: what [`LagStep::new`] has to 1e-12 of the input,
/// without a branch and without a library.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LagSteps<const N: usize> {
    /// Shares of the outputs that stay.
    pub keep: [f64; N],
    /// Weights of the inputs at the start of the step.
    pub from: [f64; N],
    /// Weights of the inputs at its end.
    pub to: [f64; N],
}

impl<const N: usize> LagSteps<N> {
    /// Steps of `h` seconds with time constants `tau` (s), from 0 to infinity both.
    #[inline(always)]
    pub fn new(h: [f64; N], tau: [f64; N]) -> Self {
        let mut ratios = [0.0; N];
        for n in 0..N {
            ratios[n] = if h[n] > 0.0 { h[n] / tau[n] } else { 0.0 };
        }
        Self::of(ratios)
    }

    /// Steps that take so many time constants.
    #[inline(always)]
    pub fn of(ratios: [f64; N]) -> Self {
        let [mut keep, mut from, mut to] = [[0.0; N]; 3];
        for n in 0..N {
            let ratio = ratios[n];
            keep[n] = decayed(ratio);
            let mean = (1.0 - keep[n]) / ratio;
            // Short steps: the series of `1 - f`, without the cancellation of the closed form.
            let short = ratio * (0.5 - ratio * (1.0 / 6.0 - ratio * (1.0 / 24.0 - ratio * (1.0 / 120.0))));
            to[n] = if ratio < 0.01 { short } else { 1.0 - mean };
            from[n] = (1.0 - to[n]) - keep[n];
        }
        Self { keep, from, to }
    }
}

impl LagStep<f64> {
    /// [`LagStep::new`] to 1e-12 of the input: for parts of steps, which are new every time.
    #[inline]
    pub fn part(h: f64, tau: f64) -> Self {
        let LagSteps { keep: [keep], from: [from], to: [to] } = LagSteps::new([h], [tau]);
        Self { keep, from, to }
    }
}

/// `e^-x` for x from 0 on, to 1e-14: a power of two, and the series of what is left, up to ln 2 / 2.
#[inline(always)]
fn decayed(x: f64) -> f64 {
    // Beyond 700 nothing is left.
    let x = if x < 700.0 { x } else { 700.0 };
    let power = whole(x * LOG2_E + 0.5);
    let rest = power * LN_2 - x;
    let mut sum = 0.0;
    for factor in INVERSE_FACTORIALS.iter().rev() {
        sum = sum * rest + factor;
    }
    // The exponent of 2^-power stands in the mantissa of the whole number, and goes to its place.
    sum * f64::from_bits((1023.0 - power + WHOLE).to_bits() << 52)
}

/// 1, 1, 1/2, 1/6, ...: as many as `e^(ln 2 / 2)` needs.
const INVERSE_FACTORIALS: [f64; 13] = {
    let mut powers = [1.0; 13];
    let mut n = 1;
    while n < powers.len() {
        powers[n] = powers[n - 1] / n as f64;
        n += 1;
    }
    powers
};

/// A step whose input is two straight lines that meet, or not, at a share of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SplitLag<S> {
    first: LagStep<S>,
    second: LagStep<S>,
}

impl<S: Real> SplitLag<S> {
    /// Split at `share` (0..=1) of the step of `h` seconds.
    pub fn new(h: f64, tau: f64, share: f64) -> Self {
        Self { first: LagStep::new(h * share, tau), second: LagStep::new(h * (1.0 - share), tau) }
    }

    /// Output at the end of the step; the input runs from `u0` to `before`, then from `after` to `u1`.
    #[inline(always)]
    pub fn step<V: Wire<S>>(&self, y: V, u0: V, before: V, after: V, u1: V) -> V {
        self.second.step(self.first.step(y, u0, before), after, u1)
    }
}

/// Time constant (s) of a part with -3 dB `bandwidth` (Hz): 0 if it is infinite.
pub fn time_constant(bandwidth: f64) -> f64 {
    1.0 / (2.0 * std::f64::consts::PI * bandwidth)
}

/// Time constant (s) of a lag that is within `error` (share of the step) after `settling` seconds; the rule of
/// section 6 is `t_acq / 6.9`, which is an error of 0.1 %.
pub fn settling_time_constant(settling: f64, error: f64) -> f64 {
    settling / -libm::log(error)
}

/// What an impulse of area 1 (full scale times seconds) into the lag at `share` of a step adds to its output at the
/// end of the step (1/s). Without a lag it is over by then.
pub fn impulse(h: f64, tau: f64, share: f64) -> f64 {
    if tau == 0.0 { 0.0 } else { libm::exp(-h * (1.0 - share) / tau) / tau }
}

/// `h / tau`; in no time nothing happens, not even without a lag.
fn ratio(h: f64, tau: f64) -> f64 {
    if h == 0.0 { 0.0 } else { h / tau }
}

/// `1 - e^-r`, and of it the share that the end point of a straight input has, `(1 - f) / (1 - e^-r)`: 1/2..=1.
fn straight(ratio: f64) -> [f64; 2] {
    if ratio < 0.5 {
        // 1 - f = r S and 1 - e^-r = r f, without the cancellation of the closed forms.
        let series = ramp_series(ratio);
        let f = 1.0 - ratio * series;
        [ratio * f, series / f]
    } else {
        let input = 1.0 - libm::exp(-ratio);
        [input, (1.0 - input / ratio) / input]
    }
}

/// `S = (1 - f) / r = 1/2 - r/6 + r^2/24 - ...`.
fn ramp_series(ratio: f64) -> f64 {
    INVERSES.iter().rev().fold(0.0, |sum, inverse| (1.0 - sum * ratio) * inverse)
}

/// 1/2, 1/3, ...: as many as a ratio of 1/2 needs.
const INVERSES: [f64; 15] = {
    let mut inverses = [0.0; 15];
    let mut n = 0;
    while n < inverses.len() {
        inverses[n] = 1.0 / (n + 2) as f64;
        n += 1;
    }
    inverses
};

#[cfg(test)]
mod tests {
    use super::{LagStep, LagSteps};

    #[test]
    fn what_an_input_leaves_is_what_its_end_and_its_start_leave() {
        for tau in [0.0, 1e-9, 50e-9, 1e-6] {
            let lag = LagStep::<f64>::new(50e-9, tau);
            let (mut y, mut u, mut left) = (0.3, 0.3, lag.leave(0.3, 0.3));
            for next in [0.5, -0.7, 0.1, 0.1, 0.9] {
                (y, u) = (lag.step(y, u, next), next);
                assert!((left + next * lag.to - y).abs() < 1e-15, "{tau}: {y}");
                left = left * lag.keep + next * lag.rest();
            }
        }
    }

    #[test]
    fn lags_side_by_side_are_lags() {
        let h = 50e-9;
        let mut taus = vec![0.0, f64::INFINITY, 1e-30, 1e30];
        taus.extend((0..2000).map(|k| h * libm::exp2(f64::from(k - 1000) / 60.0)));
        for tau in taus {
            for share in [0.0, 1e-9, 0.3, 0.999, 1.0] {
                let right = LagStep::<f64>::new(h * share, tau);
                let LagSteps { keep, from, to } = LagSteps::new([h * share; 2], [tau; 2]);
                assert_eq!(
                    LagStep::part(h * share, tau),
                    LagStep { keep: keep[0], from: from[0], to: to[0] }
                );
                for (found, right) in [(keep, right.keep), (from, right.from), (to, right.to)] {
                    assert!((found[1] - right).abs() < 1e-12, "{tau} {share}: {found:?} {right}");
                }
            }
        }
    }
}
