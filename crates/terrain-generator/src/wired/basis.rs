//! Function generators: the three basis functions and their slopes, fed with a ramp and with its complement.

use hardware_model::AnalogParts;
use landscape::basis::{NEAR, derivatives, values};
use parts::{
    Ends, FunctionGenerator, FunctionLaw, LagStep, Spread, Tolerance, relative_sigma, time_constant,
};
use signal::{Lanes, Real};

use super::scale::{PEAKS, SLOPE_PEAKS};

/// Function generators of one axis: values and slopes, at the near and at the far end, of the three orders.
pub const UNITS: usize = 12;

/// A function generator: `6 slope + 3 end + order`.
#[derive(Debug, Clone)]
struct Unit<S> {
    law: Curve<S>,
    /// Deviation at the middle, in the shape of a bow (share).
    bow: S,
}

#[derive(Debug, Clone)]
enum Curve<S> {
    /// Ascending powers.
    Exact([S; 6]),
    Broken(FunctionGenerator<S>),
}

/// The function generators of one axis.
#[derive(Debug, Clone)]
pub struct AxisGenerators<S> {
    units: Vec<Unit<S>>,
    lags: Vec<LagStep<S>>,
}

/// Inputs of a group's function generators a sample ago, and their outputs.
#[derive(Debug, Clone)]
pub struct AxisState<S> {
    before: [Lanes<S>; UNITS],
    /// Outputs, shares of full scale.
    pub out: [Lanes<S>; UNITS],
}

impl<S: Real> Default for AxisState<S> {
    fn default() -> Self {
        Self { before: [Lanes::default(); UNITS], out: [Lanes::default(); UNITS] }
    }
}

impl<S: Real> AxisGenerators<S> {
    /// Those of axis `axis` (0: X) of the array called `name`, for steps of `h` seconds.
    pub fn new(h: f64, parts: &AnalogParts, spread: &Spread, name: &str, axis: usize) -> Self {
        let figures = &parts.function_generator;
        let knee = figures.rounding / parts.full_scale;
        let number = |unit: usize| (UNITS * axis + unit) as u64;
        let unit = |unit: usize| Unit {
            law: curve(figures.segments, knee, unit / 6 == 1, unit % 3),
            bow: S::from_f64(spread.error(&format!("{name}.fn"), number(unit), figures.error)),
        };
        let sigma = if parts.spread { relative_sigma::BANDWIDTH } else { 0.0 };
        let lag = |unit: usize, bandwidth: f64| {
            let tolerance = Tolerance { nominal: bandwidth, sigma };
            let bandwidth = spread.figure(&format!("{name}.fn.bandwidth"), number(unit), &tolerance);
            LagStep::new(h, time_constant(bandwidth))
        };
        Self {
            units: (0..UNITS).map(unit).collect(),
            lags: figures.bandwidth.map_or(Vec::new(), |b| (0..UNITS).map(|unit| lag(unit, b)).collect()),
        }
    }

    /// The generators at rest under a ramp that stands.
    pub fn at_rest(&self, ramp: Lanes<S>) -> AxisState<S> {
        let before = self.inputs(ramp);
        AxisState { before, out: before }
    }

    /// A step later, the ramp at `ramp` at its end.
    pub fn step(&self, state: &mut AxisState<S>, ramp: Lanes<S>) {
        let now = self.inputs(ramp);
        if self.lags.is_empty() {
            state.out = now;
        }
        for (unit, lag) in self.lags.iter().enumerate() {
            state.out[unit] = lag.step(state.out[unit], state.before[unit], now[unit]);
        }
        state.before = now;
    }

    fn inputs(&self, ramp: Lanes<S>) -> [Lanes<S>; UNITS] {
        let far = Lanes::splat(S::ONE) - ramp;
        std::array::from_fn(|unit| {
            let fed = if unit / 3 % 2 == 0 { ramp } else { far };
            self.units[unit].at(fed)
        })
    }
}

impl<S: Real> Unit<S> {
    fn at(&self, ramp: Lanes<S>) -> Lanes<S> {
        let curve = match &self.law {
            Curve::Exact(powers) => {
                let [rest @ .., top] = powers;
                rest.iter().rev().fold(Lanes::splat(*top), |sum, &power| sum * ramp + Lanes::splat(power))
            }
            Curve::Broken(line) => ramp.map(|z| line.value(z)),
        };
        let bow = ramp * (Lanes::splat(S::ONE) - ramp) * Lanes::splat(S::from_f64(4.0) * self.bow);
        curve + bow
    }
}

/// The curve of one order, scaled to its peak.
fn curve<S: Real>(segments: Option<u32>, knee: f64, slope: bool, order: usize) -> Curve<S> {
    match segments {
        None => {
            let powers = if slope { derivative(NEAR[order]) } else { NEAR[order] };
            let peak = if slope { SLOPE_PEAKS[order] } else { PEAKS[order] };
            Curve::Exact(powers.map(|power| S::from_f64(power / peak)))
        }
        Some(segments) => {
            let law =
                FunctionLaw { segments: segments as usize, rounding: knee, ends: Ends::Trimmed([0.0; 2]) };
            let line = if slope {
                FunctionGenerator::new(&law, |z| derivatives(z)[order] / SLOPE_PEAKS[order])
            } else {
                FunctionGenerator::new(&law, |z| values(z)[order] / PEAKS[order])
            };
            Curve::Broken(line)
        }
    }
}

fn derivative(powers: [f64; 6]) -> [f64; 6] {
    std::array::from_fn(|n| powers.get(n + 1).map_or(0.0, |power| power * (n + 1) as f64))
}
