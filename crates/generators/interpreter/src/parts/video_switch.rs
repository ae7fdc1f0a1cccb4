//! A video switch of real parts: cross-fade, mismatch of its ways, delay, crosstalk (hardware section 3.6).

use std::f64::consts::PI;

use super::figures::sigma;
use super::kit::Kit;
use super::series::LagMap;

/// Crosstalk is told at this frequency (Hz).
const CROSSTALK_AT: f64 = 5e6;

/// Figures of one video switch.
#[derive(Debug, Clone, Copy)]
pub struct SwitchFigures {
    /// What input S is multiplied by, and what is added to it.
    on: [f64; 2],
    /// Length of the transition (steps).
    pub transition: f64,
    /// How much later S comes than C (steps).
    pub late: f64,
    /// Time constant of the crosstalk (steps); none where nothing comes through.
    crosstalk: Option<f64>,
}

impl SwitchFigures {
    /// The switch called `name`.
    pub fn of(kit: &Kit<'_>, name: &str) -> Self {
        let parts = &kit.analog.video_switch;
        let error = |figure: &str, sigma: f64| kit.drawn.error(&format!("{name}.{figure}"), 0, sigma);
        let time =
            |figure: &str, time: f64| kit.steps(&format!("{name}.{figure}"), 0, time, sigma::SWITCHING);
        // Of a sine wave the share x comes through: w T is x / sqrt(1 - x^2).
        let through = |share: f64| share / (1.0 - share * share).sqrt() / (2.0 * PI * CROSSTALK_AT);
        Self {
            on: [1.0 + error("gain", parts.gain_mismatch), error("level", parts.level_mismatch)],
            transition: time("time", parts.time),
            late: time("delay", parts.delay_mismatch),
            crosstalk: parts.crosstalk.map(|share| through(share) / kit.step),
        }
    }

    /// What comes through of an input that is off, sample by sample: what a lag keeps back of the video.
    pub fn leak(&self, input: &[f64]) -> Vec<f64> {
        let Some(tau) = self.crosstalk else { return vec![0.0; input.len()] };
        let lag = LagMap::of(1.0, tau);
        let mut before = input.first().map_or(0.0, |first| first.clamp(0.0, 1.0));
        let mut kept = before;
        let leaks = input.iter().map(|input| {
            let input = input.clamp(0.0, 1.0);
            kept = lag.step(kept, [before, input]);
            before = input;
            input - kept
        });
        leaks.collect()
    }

    /// The output where the switch is open by `share`: inputs C and S, and what leaks of both.
    pub fn output(&self, share: f64, [c, s]: [f64; 2], [of_c, of_s]: [f64; 2]) -> f64 {
        let on = self.on[0] * s + self.on[1];
        (1.0 - share) * (c + of_s) + share * (on + of_c)
    }
}
