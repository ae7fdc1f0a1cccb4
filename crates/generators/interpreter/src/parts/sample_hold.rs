//! The sample-and-hold of the projection processor (hardware sections 3.6 and 6).

use super::figures::{SETTLED, sigma};
use super::kit::Kit;
use super::series::LagMap;

/// The part; times in steps, voltages as shares of full scale.
#[derive(Debug, Clone, Copy)]
pub struct SampleHold {
    tau: f64,
    aperture: f64,
    jitter: f64,
    pedestal: f64,
    /// Loss in a step.
    droop: f64,
}

/// What it has while the beam is off.
#[derive(Debug, Clone, Copy)]
pub struct Held {
    /// Tracked value that it took.
    pub taken: f64,
    /// When it was told to hold (steps).
    pub since: f64,
}

/// Since when it tracks, and from where.
#[derive(Debug, Clone, Copy)]
pub struct Trace {
    /// When the beam came on (steps).
    pub at: f64,
    /// What it had then.
    pub value: f64,
}

impl SampleHold {
    /// The one called `dpp.hold`.
    pub fn of(kit: &Kit<'_>) -> Self {
        let parts = &kit.analog.sample_hold;
        let name = |figure: &str| format!("dpp.hold.{figure}");
        let acquire = kit.steps(&name("acquisition"), 0, parts.acquire, sigma::SETTLING);
        Self {
            tau: acquire / -libm::log(SETTLED),
            aperture: kit.steps(&name("aperture"), 0, parts.aperture, sigma::SWITCHING),
            jitter: parts.jitter / kit.step,
            pedestal: kit.figure(&name("pedestal"), 0, kit.share(parts.pedestal), sigma::CHARGE),
            droop: kit.figure(&name("droop"), 0, kit.share(parts.droop), sigma::CHARGE) * kit.step,
        }
    }

    /// What it has tracked over `length` steps, from `value`, of an input that goes straight between `ends`.
    pub fn track(&self, value: f64, ends: [f64; 2], length: f64) -> f64 {
        LagMap::of(length, self.tau).step(value, ends)
    }

    /// What it holds at an instant (steps).
    pub fn holds(&self, held: Held, time: f64) -> f64 {
        held.taken + self.pedestal - (time - held.since) * self.droop
    }

    /// What a command at `command` takes, whose jitter has this deviate: the value of an aperture delay before. `wire` has what was
    /// tracked at the samples before, `tracked` is there at the command.
    pub fn takes(&self, trace: Trace, wire: &[f64], [command, deviate]: [f64; 2], tracked: f64) -> f64 {
        let at = command - self.aperture + self.jitter * deviate;
        if at >= command {
            return tracked;
        }
        if at < trace.at {
            return trace.value;
        }
        let first = at.floor().max((trace.at + 1.0).floor()) as usize;
        let samples = (first..).take_while(|sample| (*sample as f64) < command);
        let mut points = vec![[trace.at, trace.value]];
        points.extend(samples.map(|sample| [sample as f64, wire[sample]]));
        points.push([command, tracked]);
        let behind = points.iter().position(|point| point[0] > at).unwrap_or(points.len() - 1);
        let ([from, value], [to, end]) = (points[behind - 1], points[behind]);
        value + (end - value) * (at - from) / (to - from)
    }
}
