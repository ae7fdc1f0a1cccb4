//! A summing tree: 36 products into one voltage (hardware section 3.2, noise gain).

use hardware_model::AnalogParts;
use parts::{
    Amplifier, AmplifierLaw, AmplifierState, Spread, Tolerance, relative_sigma, summing_time_constant,
};
use signal::{Lanes, Real};

use super::terms::TERMS;

/// Amplifiers of a tree, stage by stage.
#[derive(Debug, Clone)]
pub struct Summer<S> {
    /// Inputs of one amplifier.
    inputs: usize,
    stages: Vec<Vec<Amplifier<S>>>,
    slowest: Vec<f64>,
    delay: f64,
}

/// State of a tree.
#[derive(Debug, Clone)]
pub struct SummerState<S> {
    stages: Vec<Vec<Stage<S>>>,
}

#[derive(Debug, Clone, Copy)]
struct Stage<S> {
    amplifier: AmplifierState<Lanes<S>>,
    before: Lanes<S>,
    out: Lanes<S>,
}

impl<S: Real> Default for SummerState<S> {
    fn default() -> Self {
        Self { stages: Vec::new() }
    }
}

impl<S: Real> Summer<S> {
    /// The tree called `name`, for steps of `h` seconds.
    pub fn new(h: f64, parts: &AnalogParts, spread: &Spread, name: &str) -> Self {
        let figures = &parts.amplifier;
        let inputs = parts.summer_inputs.map_or(TERMS, |inputs| (inputs as usize).max(2));
        let is_ideal =
            figures.gain_bandwidth.is_none() && figures.slew.is_none() && figures.saturation.is_none();
        let mut counts = Vec::new();
        let mut left = TERMS;
        while left > 1 && !is_ideal {
            left = left.div_ceil(inputs);
            counts.push(left);
        }
        // A single summing point has no noise gain of its inputs.
        let gain = parts.summer_inputs.map_or(1, |_| inputs as u32);
        let tau = figures.gain_bandwidth.map_or(0.0, |gbw| summing_time_constant(gain, gbw));
        let full_scale = parts.full_scale;
        let mut number = 0;
        let mut amplifier = || {
            number += 1;
            let draw = |figure: &str, nominal: f64, sigma: f64| {
                let sigma = if parts.spread { sigma } else { 0.0 };
                spread.figure(&format!("{name}.{figure}"), number, &Tolerance { nominal, sigma })
            };
            let law = AmplifierLaw {
                tau: draw("tau", tau, relative_sigma::BANDWIDTH),
                slew: draw(
                    "slew",
                    figures.slew.map_or(f64::INFINITY, |slew| slew / full_scale),
                    relative_sigma::SLEW,
                ),
                saturation: figures.saturation.map_or(f64::INFINITY, |volts| volts / full_scale),
                recovery: figures.recovery,
            };
            (law.tau, Amplifier::new(h, &law))
        };
        let (mut stages, mut slowest) = (Vec::new(), Vec::new());
        for &count in &counts {
            let (taus, stage): (Vec<f64>, Vec<_>) = (0..count).map(|_| amplifier()).unzip();
            slowest.push(taus.into_iter().fold(0.0, f64::max));
            stages.push(stage);
        }
        Self { inputs, delay: tau * stages.len() as f64, stages, slowest }
    }

    /// Nominal delay (s).
    pub fn delay(&self) -> f64 {
        self.delay
    }

    /// Terms that meet at one amplifier of the first stage; all, where there are no amplifiers.
    pub fn inputs(&self) -> usize {
        if self.stages.is_empty() { TERMS } else { self.inputs }
    }

    /// Time constants from terms to sum, the largest of each stage (s).
    pub fn slowest(&self) -> &[f64] {
        &self.slowest
    }

    /// The tree at rest; `sums` are what meets at the amplifiers of its first stage.
    pub fn at_rest(&self, sums: &[Lanes<S>], state: &mut SummerState<S>) -> Lanes<S> {
        state.stages.resize_with(self.stages.len(), Vec::new);
        for index in 0..state.stages.len() {
            let (done, left) = state.stages.split_at_mut(index);
            left[0].clear();
            match done.last() {
                None => left[0].extend(sums.iter().map(|&sum| Stage::at_rest(sum))),
                Some(below) => {
                    left[0].extend(below.chunks(self.inputs).map(|group| Stage::at_rest(outputs(group))));
                }
            }
        }
        state.stages.last().map_or_else(|| total(sums), |last| outputs(last))
    }

    /// A step later, with `sums` at the first stage at its end.
    #[inline(always)]
    pub fn step(&self, sums: &[Lanes<S>], state: &mut SummerState<S>) -> Lanes<S> {
        let Some((first, rest)) = self.stages.split_first() else { return total(sums) };
        let (first_state, rest_state) = state.stages.split_at_mut(1);
        for ((part, state), &sum) in first.iter().zip(&mut first_state[0]).zip(sums) {
            state.step(part, sum);
        }
        let mut below = &first_state[0];
        for (stage, states) in rest.iter().zip(rest_state) {
            for ((part, state), group) in stage.iter().zip(states.iter_mut()).zip(below.chunks(self.inputs)) {
                state.step(part, outputs(group));
            }
            below = states;
        }
        outputs(below)
    }
}

impl<S: Real> Stage<S> {
    fn at_rest(input: Lanes<S>) -> Self {
        Self { amplifier: AmplifierState { y: input, excess: Lanes::default() }, before: input, out: input }
    }

    #[inline(always)]
    fn step(&mut self, part: &Amplifier<S>, input: Lanes<S>) {
        self.out = part.step_lanes(&mut self.amplifier, self.before, input);
        self.before = input;
    }
}

#[inline(always)]
fn total<S: Real>(terms: &[Lanes<S>]) -> Lanes<S> {
    let mut sum = Lanes::default();
    for &term in terms {
        sum = sum + term;
    }
    sum
}

#[inline(always)]
fn outputs<S: Real>(stages: &[Stage<S>]) -> Lanes<S> {
    let mut sum = Lanes::default();
    for stage in stages {
        sum = sum + stage.out;
    }
    sum
}
