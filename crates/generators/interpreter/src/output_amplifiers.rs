//! Output amplifiers of the main signals: `tau y' = u - y`, and never faster than the slew rate, one wire after another.
//!
//! The input is straight between samples, and between them and where the mixing unit clips it to black. Steps are walked from one
//! change of the motion to the next: slewing ends where the difference of input and output has come down to what the rate times
//! tau allows, and begins where it has grown to it.

use hardware_model::WireParts;

use crate::given::{Given, straight};
use crate::parts::drawn::Drawn;
use crate::parts::figures::sigma;
use crate::scene::SceneData;

/// Which wires lag, in accumulator steps and in their own units.
#[derive(Debug, Clone, Copy)]
pub struct OutputAmplifiers<'a> {
    parts: WireParts,
    full_scale: f64,
    step: f64,
    between: usize,
    units: &'a [(&'static str, f64)],
    drawn: Drawn<'a>,
    /// Whether amplifiers differ from one another.
    differ: bool,
}

/// One amplifier on its way along a sweep.
#[derive(Debug, Clone, Copy)]
struct Amplifier {
    tau: f64,
    rate: f64,
    /// Input and output at the sample before.
    last: Option<(f64, f64)>,
}

impl<'a> OutputAmplifiers<'a> {
    /// Those of a scene.
    pub fn of(scene: &SceneData<'_>, given: &Given<'a>) -> Self {
        let analog = &scene.settings.analog;
        let step = 1.0 / scene.settings.timebase.sample_rate().hertz();
        Self {
            parts: analog.wires,
            full_scale: analog.full_scale,
            step,
            between: given.between,
            units: given.full_scales,
            drawn: given.parts,
            differ: analog.spread,
        }
    }

    /// The amplifier of a wire that lags.
    fn amplifier(&self, name: &str) -> Amplifier {
        let figure = |figure: &str, nominal: f64, sigma: f64| {
            self.drawn.figure(&format!("{name}.{figure}"), 0, nominal, if self.differ { sigma } else { 0.0 })
        };
        let tau = self.parts.bandwidth.map_or(0.0, |band| {
            1.0 / (2.0 * std::f64::consts::PI * figure("driver", band, sigma::BANDWIDTH))
        });
        let unit = self.units.iter().find(|(wire, _)| *wire == name).map_or(1.0, |(_, unit)| *unit);
        let rate = self.parts.slew.map_or(f64::INFINITY, |slew| {
            figure("driver.slew", slew, sigma::SLEW) / self.full_scale * unit * self.step
        });
        Amplifier { tau: tau / self.step, rate, last: None }
    }

    /// A whole signal behind its amplifier.
    pub fn pass(&self, name: &str, signal: Vec<f64>) -> Vec<f64> {
        if !self.lags(name) {
            return signal;
        }
        let mut amplifier = self.amplifier(name);
        straight(signal, self.between).into_iter().map(|value| amplifier.next(value)).collect()
    }

    /// The same of a signal that is clipped at 0 on its way.
    pub fn pass_lit(&self, name: &str, signal: Vec<f64>) -> Vec<f64> {
        let (signal, mut amplifier) = (straight(signal, self.between), self.amplifier(name));
        let before = signal.iter().take(1).chain(&signal);
        before.zip(&signal).map(|(before, now)| amplifier.next_lit(*before, *now)).collect()
    }

    /// Whether the wire of this name lags.
    pub fn lags(&self, name: &str) -> bool {
        self.parts.drives(name)
    }
}

impl Amplifier {
    /// The output at the next sample.
    fn next(&mut self, input: f64) -> f64 {
        let follows_at_once = self.tau == 0.0 && self.rate == f64::INFINITY;
        let output = match self.last.filter(|_| !follows_at_once) {
            None => input,
            Some((before, y)) => self.straight(y, [before, input], 1.0),
        };
        self.last = Some((input, output));
        output
    }

    /// The same of an input that is clipped at 0 on its way.
    fn next_lit(&mut self, before: f64, input: f64) -> f64 {
        let lit = [before, input].map(|value| value.max(0.0));
        let Some((_, mut y)) = self.last else { return self.next(lit[1]) };
        if before * input < 0.0 {
            let edge = before / (before - input);
            y = self.straight(y, [lit[0], 0.0], edge);
            y = self.straight(y, [0.0, lit[1]], 1.0 - edge);
        } else {
            y = self.straight(y, lit, 1.0);
        }
        self.last = Some((lit[1], y));
        y
    }

    /// From output `y` over `length` steps, the input going straight from one value to another.
    fn straight(&self, mut y: f64, [from, to]: [f64; 2], length: f64) -> f64 {
        if length <= 0.0 {
            return y;
        }
        let slope = (to - from) / length;
        let reach = if self.rate == f64::INFINITY { f64::INFINITY } else { self.rate * self.tau };
        let mut behind = from - y;
        let mut rest = length;
        let mut free = behind.abs() <= reach;
        while rest > 0.0 {
            let sign = behind.signum();
            if free {
                // Settles towards slope times tau; leaves the bounds on the way if that lies beyond them.
                let settled = slope * self.tau;
                let bound = reach * settled.signum();
                let leaves = if slope.abs() > self.rate {
                    if self.tau == 0.0 {
                        0.0
                    } else {
                        self.tau * libm::log((settled - behind) / (settled - bound))
                    }
                } else {
                    f64::INFINITY
                };
                let time = leaves.clamp(0.0, rest);
                let decay = if self.tau == 0.0 { 0.0 } else { libm::exp(-time / self.tau) };
                let next = if leaves <= rest { bound } else { settled + (behind - settled) * decay };
                y += slope * time + behind - next;
                (behind, rest, free) = (next, rest - time, false);
                if rest > 0.0 && behind == 0.0 {
                    behind = f64::MIN_POSITIVE.copysign(slope);
                }
            } else {
                let closing = self.rate - slope * sign;
                let catches =
                    if closing > 0.0 { ((behind.abs() - reach) / closing).max(0.0) } else { f64::INFINITY };
                let time = catches.min(rest);
                y += sign * self.rate * time;
                behind =
                    if catches <= rest { sign * reach } else { behind + (slope - sign * self.rate) * time };
                (rest, free) = (rest - time, true);
            }
        }
        y
    }
}
