//! Second order: two poles, with the damping of a smoother, a deflection amplifier, a yoke or a stepper.
//!
//! ```text
//! u ─▶ w^2 / (s^2 + 2 z w s + w^2) ─▶ y
//! ```
//!
//! **Law** (section 6). `y'' + 2 z w y' + w^2 y = w^2 u`, by the 2 x 2 matrix exponential, for any damping: below 1
//! with sine and cosine, above with the two real modes, and through 1 without a seam. Input: a straight line over the
//! step ([`SecondOrder::step`]), a staircase that switches at the same share of every step ([`SecondOrder::staircase`]), or what a
//! converter makes of one by its own lag ([`SecondOrder::settling`]), which is what a smoother behind it gets.
//! **Parameters.** [`SecondOrder`]. A ramp passes with the delay `2 z / w` ([`SecondOrder::group_delay`]).
//! **State and timing.** [`SecondOrderState`]: output and its rate, in physical units, so steps of different length
//! may follow one another.
//! **Numbers.** A step is `y + from (u0 - y) + to (u1 - y) + coast y'`: a constant stays to the bit, at 90 Hz seen
//! every 50 ns too. Short steps (`w h` small) use the series of the impulse response, where the closed form cancels.

use signal::Real;

use crate::Wire;

/// Parameters of the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondOrder {
    /// Natural frequency w (rad/s); infinite: y is u at once, 0: y coasts.
    pub natural: f64,
    /// Damping z, 0 or more.
    pub damping: f64,
}

/// Output and its rate.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SecondOrderState<V> {
    /// Output of the part.
    pub y: V,
    /// Rate of change of the output (1/s).
    pub rate: V,
}

/// One step; see [`SecondOrder`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondOrderStep<S> {
    from: S,
    to: S,
    coast: S,
    push_from: S,
    push_to: S,
    keep: S,
}

impl SecondOrder {
    /// The part whose ramps are late by `delay` seconds, at `damping` above 0.
    pub fn of_delay(delay: f64, damping: f64) -> Self {
        Self { natural: 2.0 * damping / delay, damping }
    }

    /// Delay of a ramp (s): `2 z / w`.
    pub fn group_delay(&self) -> f64 {
        2.0 * self.damping / self.natural
    }

    /// Step of `h` seconds for an input that is a straight line over the step.
    pub fn step<S: Real>(&self, h: f64) -> SecondOrderStep<S> {
        let free = Free::new(h, self);
        let push = if h == 0.0 { 0.0 } else { free.rise / h };
        free.driven([free.rise - free.ramp, free.ramp], [free.push - push, push])
    }

    /// Step of `h` seconds for an input that is u0 up to `share` (0..=1) of the step and u1 from there on.
    pub fn staircase<S: Real>(&self, h: f64, share: f64) -> SecondOrderStep<S> {
        let (before, after) = (Free::new(h * share, self), Free::new(h * (1.0 - share), self));
        let from = (1.0 - after.rise) * before.rise + after.coast * before.push;
        let push_from = after.keep * before.push - after.push * before.rise;
        Free::new(h, self).driven([from, after.rise], [push_from, after.push])
    }

    /// Step of `h` seconds for an input that goes from u0 to u1 by a lag of `tau` seconds, as that of a converter does.
    ///
    /// The damping must be below 1. A damping of 1 or more has two real poles. The formula has no value where one of them equals the
    /// pole of the lag.
    pub fn settling<S: Real>(&self, h: f64, tau: f64) -> SecondOrderStep<S> {
        if tau == 0.0 || self.natural == f64::INFINITY {
            return self.staircase(h, 0.0);
        }
        let free = Free::new(h, self);
        // The response to what is left of u0 - u1, exp(-t / tau): a multiple of itself, and the free part that begins against it.
        let (rate, own) = (1.0 / tau, self.damping * self.natural);
        let peak = self.natural * self.natural
            / ((rate - own) * (rate - own) + self.natural * self.natural - own * own);
        let left = libm::exp(-h * rate);
        let from = peak * (left - (1.0 - free.rise) + free.coast * rate);
        let push_from = peak * (free.push + free.keep * rate - left * rate);
        free.driven([from, free.rise - from], [push_from, free.push - push_from])
    }

    /// What an impulse of area 1 into the part at `share` of a step of `h` seconds adds to its state at the end of
    /// the step: output (1/s) and rate (1/s^2).
    pub fn impulse(&self, h: f64, share: f64) -> SecondOrderState<f64> {
        let after = Free::new(h * (1.0 - share), self);
        // An infinitely fast part has forgotten it.
        let kick = if after.keep == 0.0 { 0.0 } else { self.natural * self.natural * after.keep };
        SecondOrderState { y: after.push, rate: kick }
    }
}

impl<S: Real> SecondOrderStep<S> {
    /// State at the end of the step; input `u0`, `u1` at its start and end.
    #[inline(always)]
    pub fn step<V: Wire<S>>(&self, state: SecondOrderState<V>, u0: V, u1: V) -> SecondOrderState<V> {
        let SecondOrderState { y, rate } = state;
        let (start, end) = (u0 - y, u1 - y);
        SecondOrderState {
            y: y + start * self.from + end * self.to + rate * self.coast,
            rate: rate * self.keep + start * self.push_from + end * self.push_to,
        }
    }
}

/// The free part over a time h: its matrix is `[[1 - rise, coast], [-push, keep]]`.
#[derive(Debug, Clone, Copy)]
struct Free {
    /// Response to a unit step.
    rise: f64,
    /// Response at the end of a ramp from 0 to 1.
    ramp: f64,
    /// Output from a unit rate (s).
    coast: f64,
    /// Rate of the response to a unit step (1/s).
    push: f64,
    /// Rate from a unit rate.
    keep: f64,
}

/// Below this `w h (1 + 2 z)` the series is used: 24 terms leave less than a rounding.
const SHORT: f64 = 0.5;
const TERMS: usize = 24;

impl Free {
    fn new(h: f64, part: &SecondOrder) -> Self {
        let angle = if h == 0.0 { 0.0 } else { part.natural * h };
        let z = part.damping;
        if angle == f64::INFINITY {
            Self { rise: 1.0, ramp: 1.0, coast: 0.0, push: 0.0, keep: 0.0 }
        } else if angle * (1.0 + 2.0 * z) < SHORT {
            Self::short(h, angle, z)
        } else {
            Self::long(h, angle, z)
        }
    }

    /// By the Taylor series of the impulse response `s`, `s'' = -2 z s' - s`, `s(0) = 0`, `s'(0) = 1`.
    fn short(h: f64, angle: f64, z: f64) -> Self {
        // Derivative n + 1 of s at 0 times angle^n, and the one before it; then over n!.
        let (mut before, mut now, mut factorial) = (0.0, 1.0, 1.0);
        let (mut keep, mut reach, mut rise, mut ramp) = (0.0, 0.0, 0.0, 0.0);
        for n in 1..=TERMS {
            let (n, term) = (n as f64, now / factorial);
            keep += term;
            reach += term / n;
            rise += term / (n * (n + 1.0));
            ramp += term / (n * (n + 1.0) * (n + 2.0));
            (before, now) = (now, -2.0 * z * angle * now - angle * angle * before);
            factorial *= n;
        }
        let square = angle * angle;
        let push = if h == 0.0 { 0.0 } else { square * reach / h };
        Self { rise: rise * square, ramp: ramp * square, coast: h * reach, push, keep }
    }

    fn long(h: f64, angle: f64, z: f64) -> Self {
        let (rise, swing, keep) = if z <= 1.0 { swinging(angle, z) } else { creeping(angle, z) };
        let ramp = 1.0 - (2.0 * z * rise + swing) / angle;
        Self { rise, ramp, coast: swing * (h / angle), push: swing * (angle / h), keep }
    }

    fn driven<S: Real>(&self, [from, to]: [f64; 2], [push_from, push_to]: [f64; 2]) -> SecondOrderStep<S> {
        let s = S::from_f64;
        SecondOrderStep {
            from: s(from),
            to: s(to),
            coast: s(self.coast),
            push_from: s(push_from),
            push_to: s(push_to),
            keep: s(self.keep),
        }
    }
}

/// `[1 - a11, a12, a22]` in units of w, damping up to 1.
fn swinging(angle: f64, z: f64) -> (f64, f64, f64) {
    let beat = ((1.0 - z) * (1.0 + z)).sqrt();
    let decay = libm::exp(-z * angle);
    let cos = decay * libm::cos(beat * angle);
    let sin = decay * if beat == 0.0 { angle } else { libm::sin(beat * angle) / beat };
    (1.0 - cos - z * sin, sin, cos - z * sin)
}

/// The same, damping above 1: modes `e^-(z - q) angle` and `e^-(z + q) angle`.
fn creeping(angle: f64, z: f64) -> (f64, f64, f64) {
    // Not sqrt(z^2 - 1): the damping of two lags far apart is huge.
    let q = z * ((1.0 - 1.0 / z) * (1.0 + 1.0 / z)).sqrt();
    let (slow, fast) = (angle / (z + q), angle * (z + q));
    let (left, gone) = (libm::exp(-slow), libm::exp(-fast));
    let swing = left * -libm::expm1(-2.0 * q * angle) / (2.0 * q);
    // (z - q) / q, small for heavy damping.
    let excess = 1.0 / (q * (z + q));
    if z < 2.0 {
        let mean = (left + gone) / 2.0;
        (1.0 - mean - z * swing, swing, mean - z * swing)
    } else {
        let rise = (-libm::expm1(-slow) * (2.0 + excess) + libm::expm1(-fast) * excess) / 2.0;
        (rise, swing, (gone * (2.0 + excess) - left * excess) / 2.0)
    }
}
