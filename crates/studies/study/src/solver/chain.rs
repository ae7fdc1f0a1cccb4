//! A chain that the machine has, as it stands between a ramp and a hold.
//!
//! ```text
//! ramp X ─▶ smoother ─┐
//!                     ├▶ multiplier ─▶ lag ─▶ summer's lag ─┬▶ comparator ─▶ trip ─┐
//! ramp Y ─▶ smoother ─┘                                     └▶ tracking lag ─▶ hold ┴▶ held
//! ```
//!
//! **Our choices.** Both ramps fold at whole multiples of the coarsest step, so that every method sees a fold between two of
//! its steps, as the machine splits its steps there. Spread, noise, jitter and static errors are left out.

use hardware_model::{AnalogParts, HardwareModel, SMOOTHER_DAMPING};
use parts::{
    Comparator, ComparatorLaw, ComparatorState, LagStep, Multiplier, MultiplierLaw, NoiseSource, SampleHold,
    SampleHoldLaw, SecondOrder, SecondOrderState, Trip, settling_time_constant, summing_time_constant,
    time_constant,
};

use super::flow::Flow;

/// Samples of the run.
pub const SAMPLES: usize = 1024;
/// Samples from fold to fold of each ramp.
pub const FOLDS: [usize; 2] = [64, 128];
/// Inputs of the summer.
const SUMMED: u32 = 6;
/// Between the lowest and the highest product of the run.
const THRESHOLD: f64 = 0.3;
/// A decision takes no longer (s; hardware section 3.6).
const LONGEST_DECISION: f64 = 500e-9;
/// A linear part overshoots no more: `exp(-pi z / sqrt(1 - z^2))` is 1.5 % for each smoother.
pub const OVERSHOOT: f64 = 0.05;

/// The chain: time constants in seconds.
#[derive(Debug, Clone, Copy)]
pub struct Chain {
    /// From sample to sample.
    pub sample: f64,
    smoother: SecondOrder,
    product: f64,
    sum: f64,
    comparator: ComparatorLaw,
    hold: SampleHoldLaw,
}

/// What a method made of a run, step by step from 0 on.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Output of the summer: what the comparator sees.
    pub summed: Vec<f64>,
    /// What the hold tracks.
    pub tracked: Vec<f64>,
}

impl Chain {
    /// Of the parts of a model at its own clock; it must have a smoother, and no part of the chain may be instantaneous.
    pub fn of(model: &HardwareModel) -> Self {
        let (raster, parts) = (&model.raster, &model.analog);
        let steps = f64::from(raster.sweeps) * f64::from(raster.samples + raster.retrace_samples());
        Self::new(1.0 / (raster.update.hertz() * steps), parts)
    }

    fn new(sample: f64, parts: &AnalogParts) -> Self {
        let amplifier = parts.amplifier.gain_bandwidth.unwrap_or(f64::INFINITY);
        let (comparator, hold) = (parts.comparator, parts.sample_hold);
        Self {
            sample,
            smoother: SecondOrder { natural: 1.0 / parts.sweep.smoother, damping: SMOOTHER_DAMPING },
            product: time_constant(parts.multiplier.bandwidth.unwrap_or(f64::INFINITY)),
            sum: summing_time_constant(SUMMED, amplifier),
            comparator: ComparatorLaw {
                offset: THRESHOLD,
                hysteresis: comparator.hysteresis,
                delay: comparator.delay,
                overdrive: comparator.overdrive / parts.full_scale,
                longest: LONGEST_DECISION,
                noise: 0.0,
            },
            hold: SampleHoldLaw {
                acquisition: hold.acquire,
                aperture: hold.aperture,
                jitter: 0.0,
                pedestal: hold.pedestal / parts.full_scale,
                droop: hold.droop / parts.full_scale,
            },
        }
    }

    /// Both ramps at `t` (s): X from 0, Y from 1.
    pub fn ramps(&self, t: f64) -> [f64; 2] {
        let way = |axis: usize| {
            let turns = t / (self.sample * FOLDS[axis] as f64);
            (turns - 2.0 * (turns / 2.0).round()).abs()
        };
        [way(0), 1.0 - way(1)]
    }

    /// States at the start: everything at rest.
    pub fn at_rest(&self) -> [f64; 7] {
        let [x, y] = self.ramps(0.0);
        let product = x * y;
        [x, 0.0, y, 0.0, product, product, product]
    }

    /// The run in steps of `step` samples by the parts of the machine.
    pub fn by_parts(&self, step: f64, steps: usize) -> Record {
        let h = step * self.sample;
        let (smoother, multiplier) =
            (self.smoother.step::<f64>(h), Multiplier::<f64>::new(&MultiplierLaw::default()));
        let [product, sum] = [self.product, self.sum].map(|tau| LagStep::<f64>::new(h, tau));
        let hold = SampleHold::<f64>::new(h, &self.hold);
        let [x, _, y, _, at_rest, ..] = self.at_rest();
        let mut inputs = [x, y];
        let mut smooth = inputs.map(|y| SecondOrderState { y, rate: 0.0 });
        let (mut multiplied, mut lagged, mut summed, mut tracked) = (at_rest, at_rest, at_rest, at_rest);
        let mut record = Record::starting([summed, tracked], steps);
        for k in 1..=steps {
            let next = self.ramps(k as f64 * h);
            smooth = std::array::from_fn(|axis| smoother.step(smooth[axis], inputs[axis], next[axis]));
            let before = [multiplied, lagged, summed];
            multiplied = multiplier.product(smooth[0].y, smooth[1].y);
            lagged = product.step(lagged, before[0], multiplied);
            summed = sum.step(summed, before[1], lagged);
            tracked = hold.track(tracked, before[2], summed);
            record.push([summed, tracked]);
            inputs = next;
        }
        record
    }

    /// Values taken by the hold at every trip to high, from the record of a run in steps of `step` samples; and when, in
    /// samples.
    pub fn held(&self, record: &Record, step: f64) -> Vec<[f64; 2]> {
        let h = step * self.sample;
        let hold = SampleHold::<f64>::new(h, &self.hold);
        let last = record.summed.len() - 1;
        let taken = |trip: &Trip| {
            let at = hold.taken_at(trip.at, 0.0).0.clamp(0.0, last as f64);
            let begin = (at.floor() as usize).min(last - 1);
            let (from, to) = (record.summed[begin], record.summed[begin + 1]);
            let tracked = hold.tracked(record.tracked[begin], from, to, at - begin as f64);
            [hold.held(tracked, 0.0), at * step]
        };
        // A trip after the end holds nothing of the run.
        self.trips(record, h).iter().filter(|trip| trip.high && trip.at.0 <= last as f64).map(taken).collect()
    }

    fn trips(&self, record: &Record, h: f64) -> Vec<Trip> {
        let comparator = Comparator::<f64>::new(h, &self.comparator, NoiseSource::new(0, "study", 0));
        let (mut state, mut trips) = (ComparatorState::default(), Vec::new());
        for (k, pair) in record.summed.windows(2).enumerate() {
            comparator.step(&mut state, (0, k + 1), pair[0], pair[1], &mut trips);
        }
        trips
    }
}

impl Record {
    /// A record of so many steps, which begins with `[summed, tracked]`.
    pub fn starting(values: [f64; 2], steps: usize) -> Self {
        let mut record =
            Self { summed: Vec::with_capacity(steps + 1), tracked: Vec::with_capacity(steps + 1) };
        record.push(values);
        record
    }

    /// Adds the summed and the tracked value of a step.
    pub fn push(&mut self, [summed, tracked]: [f64; 2]) {
        self.summed.push(summed);
        self.tracked.push(tracked);
    }

    /// Whether all values are finite and none lies beyond what the chain can overshoot.
    pub fn is_bounded(&self) -> bool {
        self.summed.iter().chain(&self.tracked).all(|value| value.abs() <= 1.0 + OVERSHOOT)
    }
}

impl Flow<7> for Chain {
    fn rate(&self, t: f64, y: &[f64; 7]) -> [f64; 7] {
        let [to_x, to_y] = self.ramps(t);
        let SecondOrder { natural: w, damping: z } = self.smoother;
        let force = |to: f64, value: f64, rate: f64| w * (w * (to - value) - 2.0 * z * rate);
        [
            y[1],
            force(to_x, y[0], y[1]),
            y[3],
            force(to_y, y[2], y[3]),
            (y[0] * y[2] - y[4]) / self.product,
            (y[4] - y[5]) / self.sum,
            (y[5] - y[6]) / settling_time_constant(self.hold.acquisition, 0.001),
        ]
    }

    fn jacobian(&self, _: f64, y: &[f64; 7]) -> [[f64; 7]; 7] {
        let SecondOrder { natural: w, damping: z } = self.smoother;
        let [product, sum] = [1.0 / self.product, 1.0 / self.sum];
        let track = 1.0 / settling_time_constant(self.hold.acquisition, 0.001);
        let mut out = [[0.0; 7]; 7];
        for axis in [0, 2] {
            out[axis][axis + 1] = 1.0;
            out[axis + 1][axis] = -w * w;
            out[axis + 1][axis + 1] = -2.0 * z * w;
        }
        (out[4][0], out[4][2], out[4][4]) = (y[2] * product, y[0] * product, -product);
        (out[5][4], out[5][5]) = (sum, -sum);
        (out[6][5], out[6][6]) = (track, -track);
        out
    }
}
