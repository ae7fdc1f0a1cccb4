//! An amplifier of a tree: lag, slew rate, clip, recovery (hardware 3.2, 6).
//!
//! `y' = (u - y) / tau`, never faster than the slew rate; `T x' = (y - clip y) - x`; the output is `clip (y + x)`. A step that can
//! neither slew nor clip is a lag. Any other is walked by Runge and Kutta's fourth order, in steps that are halved until two of
//! them agree with one.

use super::figures::AmplifierFigures;
use super::series::LagMap;

/// Two halves and a whole agree to this (full scales).
const AGREED: f64 = 1e-13;
/// The shortest step of a walk (of a step of the machine).
const SHORTEST: f64 = 1e-7;

/// One amplifier along a sweep.
#[derive(Debug, Clone, Copy)]
pub struct AmplifierCircuit {
    figures: AmplifierFigures,
    step: f64,
    lag: LagMap,
    recovery: LagMap,
    input: f64,
    /// Output before the clip, and stored overload.
    state: [f64; 2],
}

impl AmplifierCircuit {
    /// At rest under `input`, for steps of `step` seconds.
    pub fn at_rest(figures: AmplifierFigures, step: f64, input: f64) -> Self {
        Self {
            lag: LagMap::of(step, figures.tau),
            recovery: LagMap::of(step, figures.recovery),
            figures,
            step,
            input,
            state: [input, 0.0],
        }
    }

    /// The output a step later, when the input has gone straight to `input`.
    pub fn step(&mut self, input: f64) -> f64 {
        let ends = [self.input, input];
        if self.is_quiet(ends) {
            let [y, excess] = self.state;
            self.state = [self.lag.step(y, ends), excess * self.recovery.keep];
        } else {
            self.walk(ends);
        }
        self.input = input;
        let limit = self.figures.saturation;
        (self.state[0] + self.state[1]).clamp(-limit, limit)
    }

    /// The output a `share` of a step later, at whose end the input has gone straight to what `after` has.
    pub fn towards(&self, after: &Self, share: f64) -> f64 {
        let part = Self::at_rest(self.figures, share * self.step, self.input);
        let mut part = Self { state: self.state, ..part };
        part.step(self.input + (after.input - self.input) * share)
    }

    /// Whether it can neither slew nor clip in a step: what input and output differ by lies between its start and what a ramp
    /// settles to, and the output between its start and the ends of the input.
    fn is_quiet(&self, [u0, u1]: [f64; 2]) -> bool {
        let AmplifierFigures { tau, slew, saturation, .. } = self.figures;
        let (y, slope) = (self.state[0], (u1 - u0).abs() / self.step);
        let follows = slew == f64::INFINITY || ((u0 - y).abs() <= slew * tau && slope <= slew);
        follows && [y, u0, u1].iter().all(|value| value.abs() < saturation)
    }

    fn walk(&mut self, ends: [f64; 2]) {
        if self.figures.tau == 0.0 {
            self.state[0] = ends[0];
        }
        // Against a shorter time constant a long step would go to and fro, and so would its halves.
        let longest = if self.figures.tau > 0.0 { 0.25 * self.figures.tau / self.step } else { 1.0 };
        let (mut at, mut length) = (0.0, longest);
        while at < 1.0 {
            length = length.min(longest).min(1.0 - at);
            let whole = self.runge_kutta(self.state, ends, at, length);
            let half = self.runge_kutta(self.state, ends, at, 0.5 * length);
            let both = self.runge_kutta(half, ends, at + 0.5 * length, 0.5 * length);
            let off = (whole[0] - both[0]).abs().max((whole[1] - both[1]).abs());
            if off > AGREED && length > SHORTEST {
                length *= 0.5;
                continue;
            }
            (self.state, at) = (both, at + length);
            if off < AGREED / 32.0 {
                length *= 2.0;
            }
        }
    }

    fn runge_kutta(&self, state: [f64; 2], ends: [f64; 2], at: f64, length: f64) -> [f64; 2] {
        let beyond = |rates: [f64; 2], share: f64| {
            [state[0] + share * length * rates[0], state[1] + share * length * rates[1]]
        };
        let first = self.rates(state, ends, at);
        let second = self.rates(beyond(first, 0.5), ends, at + 0.5 * length);
        let third = self.rates(beyond(second, 0.5), ends, at + 0.5 * length);
        let fourth = self.rates(beyond(third, 1.0), ends, at + length);
        let mean = |k: usize| (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]) / 6.0;
        beyond([mean(0), mean(1)], 1.0)
    }

    /// Rates of output and store, by the step.
    fn rates(&self, [y, excess]: [f64; 2], [u0, u1]: [f64; 2], at: f64) -> [f64; 2] {
        let AmplifierFigures { tau, slew, saturation, recovery } = self.figures;
        let input = u0 + (u1 - u0) * at;
        let follows_at_once = tau == 0.0;
        let y = if follows_at_once { input } else { y };
        let rate =
            if follows_at_once { (u1 - u0) / self.step } else { ((input - y) / tau).clamp(-slew, slew) };
        let beyond = y - y.clamp(-saturation, saturation);
        let fills = if recovery > 0.0 { (beyond - excess) / recovery } else { 0.0 };
        [rate * self.step, fills * self.step]
    }
}
