//! Differentiator of the projection processor (fig. 30).
//!
//! **Law** (section 6). `H = s tau_d / (1 + s tau_f)^2`: the rate of a critically damped second order of natural
//! frequency `1 / tau_f`, times `tau_d`; exact for an input that is a straight line between samples. With `tau_f = 0`
//! it is the difference quotient of the step.
//! **Parameters.** `tau_d`: output for a unit rate of input (s). `tau_f`: the lags that bound its noise (s).
//! **State and timing.** [`SecondOrderState`]. A ramp's slope is late by `2 tau_f`.
//! **Noise.** White noise sigma in a band B comes out as `2 pi B sigma / sqrt 3` ([`differentiated_noise`]).

use std::f64::consts::PI;

use signal::Real;

use crate::{SecondOrder, SecondOrderState, SecondOrderStep, Wire};

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Differentiator<S> {
    poles: SecondOrderStep<S>,
    gain: S,
}

impl<S: Real> Differentiator<S> {
    /// Step `h`, gain `tau_d` and lag `tau_f` in seconds.
    pub fn new(h: f64, tau_d: f64, tau_f: f64) -> Self {
        let poles = SecondOrder { natural: 1.0 / tau_f, damping: 1.0 };
        Self { poles: poles.step(h), gain: S::from_f64(tau_d) }
    }

    /// Advances `state` over a step with the input `u0`, `u1` at its start and end; returns the output at its end.
    #[inline(always)]
    pub fn step<V: Wire<S>>(&self, state: &mut SecondOrderState<V>, u0: V, u1: V) -> V {
        *state = self.poles.step(*state, u0, u1);
        state.rate * self.gain
    }
}

/// Sigma of the rate (1/s) of noise with `sigma`, white up to `bandwidth` (Hz) and nothing above.
pub fn differentiated_noise(sigma: f64, bandwidth: f64) -> f64 {
    2.0 * PI * bandwidth * sigma / 3.0_f64.sqrt()
}
