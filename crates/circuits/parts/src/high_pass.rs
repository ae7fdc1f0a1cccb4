//! High pass: what a small capacity lets through, as from the input of a switch that is off.
//!
//! ```text
//! u ─▶ s tau / (1 + s tau) ─▶ y
//! ```
//!
//! **Law.** `y = u - x` with `tau x' = u - x`. Over a step h, input a straight line, exactly: `y1 = k y0 + f (u1 - u0)`,
//! `k = e^-r`, `f = (1 - k) / r`, `r = h / tau`. Of a sine wave of frequency F well below `1 / (2 pi tau)` the share
//! `2 pi F tau` comes through: crosstalk that grows with frequency.
//! **Parameters.** tau in seconds, or the share at one frequency ([`HighPass::of_share`]).
//! **State and timing.** One value. A jump of the input that falls between two samples is taken as a slope over the step: the
//! area of what comes through is the same, `tau` times the jump.

use signal::Real;

use crate::Wire;

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HighPass<S> {
    keep: S,
    pass: S,
}

impl<S: Real> HighPass<S> {
    /// Step `h` and time constant `tau` in seconds.
    pub fn new(h: f64, tau: f64) -> Self {
        let ratio = if h == 0.0 { 0.0 } else { h / tau };
        let left = -libm::expm1(-ratio);
        let pass = if ratio == 0.0 { 1.0 } else { left / ratio };
        Self { keep: S::from_f64(1.0 - left), pass: S::from_f64(pass) }
    }

    /// The part that lets `share` (0 to less than 1) of a sine wave of `frequency` (Hz) through.
    pub fn of_share(h: f64, share: f64, frequency: f64) -> Self {
        let through = share / (1.0 - share * share).sqrt();
        Self::new(h, through / (2.0 * std::f64::consts::PI * frequency))
    }

    /// Output at the end of a step that begins with `y` and has the input from `u0` to `u1`.
    #[inline(always)]
    pub fn step<V: Wire<S>>(&self, y: V, u0: V, u1: V) -> V {
        y * self.keep + (u1 - u0) * self.pass
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use signal::Lanes;

    use super::HighPass;
    use crate::LagStep;

    #[test]
    fn what_a_lag_keeps_back() {
        for (h, tau) in [(50e-9, 20e-9), (50e-9, 3e-6), (1e-9, 1.0), (50e-9, 0.0), (50e-9, f64::INFINITY)] {
            let (part, lag) = (HighPass::<f64>::new(h, tau), LagStep::<f64>::new(h, tau));
            let (mut y, mut x, mut before) = (0.0, 0.3, 0.3);
            for k in 0..200 {
                let u = 0.3 + libm::sin(f64::from(k) * 0.7);
                (y, x) = (part.step(y, before, u), lag.step(x, before, u));
                assert!((y - (u - x)).abs() < 1e-12, "{tau}: {y}, {}", u - x);
                before = u;
            }
        }
    }

    #[test]
    fn the_share_is_that_of_its_frequency_and_grows_with_it() {
        let (h, share) = (1e-9, 0.01);
        let part = HighPass::<f64>::of_share(h, share, 5e6);
        for (frequency, expected) in [(5e6, share), (0.5e6, 0.1 * share), (10e6, 2.0 * share)] {
            let wave = |k: i32| libm::sin(2.0 * PI * frequency * f64::from(k) * h);
            let mut y = 0.0;
            let through = |k| {
                y = part.step(y, wave(k - 1), wave(k));
                if k > 4000 { y.abs() } else { 0.0 }
            };
            let most = (1..8000).map(through).fold(0.0, f64::max);
            assert!((most / expected - 1.0).abs() < 3e-3, "{frequency}: {most}");
        }
        let (a, b, c) = (Lanes::splat(0.1), Lanes::splat(0.2), Lanes::splat(0.7));
        assert_eq!(part.step(a, b, c), Lanes::splat(part.step(0.1, 0.2, 0.7)));
    }
}
