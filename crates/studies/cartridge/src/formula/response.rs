//! Textbook responses of one pole and of two.

use libm::{cos, exp, sin};
use serde::Deserialize;

use crate::scene::part::{Input, Part, PartCase};

/// Output at a time from the start (s), from rest: of the lag and of the smoother, for each input.
///
/// - One pole, `r = t / tau`: step `1 - e^-r`; ramp of slope s `s (t - tau (1 - e^-r))`.
/// - Two poles, `a = z w`, `d = w sqrt(1 - z^2)`, z below 1: step `1 - e^-at (cos dt + a/d sin dt)`; ramp of slope s
///   `s (t - 2z/w + e^-at (2z/w cos dt + (2z^2 - 1)/d sin dt))`.
/// - A fold is the ramp less twice the same ramp from the fold on.
pub fn response(of: &PartCase, time: f64) -> f64 {
    match of.scene.input {
        Input::Step { to } => to * step(of, time),
        Input::Ramp { from, per_us } => from * step(of, time) + 1e6 * per_us * ramp(of, time),
        Input::Fold { per_us, fold_us } => {
            let behind = (time - 1e-6 * fold_us).max(0.0);
            1e6 * per_us * (ramp(of, time) - 2.0 * ramp(of, behind))
        }
    }
}

fn step(of: &PartCase, t: f64) -> f64 {
    match of.scene.part {
        Part::Smoother => {
            let (a, d) = poles(of);
            1.0 - exp(-a * t) * (cos(d * t) + a / d * sin(d * t))
        }
        _ => 1.0 - exp(-t / of.tau()),
    }
}

fn ramp(of: &PartCase, t: f64) -> f64 {
    match of.scene.part {
        Part::Smoother => two_pole_ramp(of.smoother().natural, of.smoother().damping, t),
        _ => t - of.tau() * (1.0 - exp(-t / of.tau())),
    }
}

/// Response (s) of two poles to a ramp of slope 1 from time 0 on (s), from rest.
pub fn two_pole_ramp(w: f64, z: f64, t: f64) -> f64 {
    let (a, d) = (z * w, w * (1.0 - z * z).sqrt());
    t - 2.0 * z / w + exp(-a * t) * (2.0 * z / w * cos(d * t) + (2.0 * z * z - 1.0) / d * sin(d * t))
}

fn poles(of: &PartCase) -> (f64, f64) {
    let part = of.smoother();
    (part.damping * part.natural, part.natural * (1.0 - part.damping * part.damping).sqrt())
}

/// What a peak is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Peak {
    /// How far it stays below the fold of the input (shares of full scale): `s tau ln 2` of a lag.
    ShortBy,
    /// How long after the fold it comes (µs): `tau ln 2` of a lag.
    LateBy,
}

/// Time (s) in which an amplifier settles to within `error` of a step V from rest: `V/SR - tau + tau ln(SR tau / error)`
/// where it slews, `V > SR tau`.
pub fn settling(of: &PartCase, step: f64, error: f64) -> f64 {
    let (tau, slew) = (of.tau(), of.slew());
    if step > slew * tau {
        step / slew - tau + tau * libm::log(slew * tau / error)
    } else {
        tau * libm::log(step / error)
    }
}
