//! A summing tree: 36 products into one voltage (hardware section 3.2, noise gain).

use fearless_simd::Simd;
use hardware_model::AnalogParts;
use parts::{
    Amplifier, AmplifierLaw, AmplifierState, QuietAmplifiers, Spread, Tolerance, relative_sigma,
    summing_time_constant,
};
use signal::{Both, Lanes, Real};

use super::block::{BLOCK, Row};
use crate::terms::TERMS;

/// Amplifiers of a tree, stage by stage.
#[derive(Debug, Clone)]
pub struct Summer<S> {
    /// Inputs of one amplifier.
    inputs: usize,
    stages: Vec<Vec<Amplifier<S>>>,
    /// The same two by two, while they neither slew nor clip; one that is left over is both.
    quiet: Vec<Vec<QuietAmplifiers<S>>>,
    slowest: Vec<f64>,
    delay: f64,
}

/// State of a tree.
#[derive(Debug, Clone)]
pub struct SummerState<S> {
    stages: Vec<Vec<Stage<S>>>,
}

/// An amplifier of a group.
#[derive(Debug, Clone, Copy)]
struct Stage<S> {
    amplifier: AmplifierState<Lanes<S>>,
    /// Its input at the sample that went through last.
    fed: Lanes<S>,
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
        let two = |pair: &[Amplifier<S>]| QuietAmplifiers::new([&pair[0], &pair[pair.len() - 1]]);
        let quiet = stages.iter().map(|stage| stage.chunks(2).map(two).collect()).collect();
        Self { inputs, delay: tau * stages.len() as f64, stages, quiet, slowest }
    }

    /// Returns the nominal delay of the tree (s).
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

    /// The tree at rest; `rows` are what meets at the amplifiers of its first stage, at the first sample, and are used
    /// up.
    pub fn at_rest(&self, rows: &mut [Row<S>], state: &mut SummerState<S>) -> Lanes<S> {
        state.stages.resize_with(self.stages.len(), Vec::new);
        let mut met = rows.len();
        for (number, (stage, states)) in self.stages.iter().zip(&mut state.stages).enumerate() {
            if number > 0 {
                met = self.meet(&mut rows[..met], 1);
            }
            states.clear();
            states.extend(rows[..stage.len()].iter().map(|row| Stage::at_rest(row[0])));
        }
        total(&rows[..met], 1)[0]
    }

    /// The sum at the first `count` samples of a block; `rows` are what meets at the first stage, and are used up.
    #[inline(always)]
    pub fn run<L: Simd>(
        &self,
        simd: L,
        rows: &mut [Row<S>],
        count: usize,
        state: &mut SummerState<S>,
    ) -> Row<S> {
        let mut met = rows.len();
        for (number, (stage, states)) in self.stages.iter().zip(&mut state.stages).enumerate() {
            if number > 0 {
                met = self.meet(&mut rows[..met], count);
            }
            let pairs = self.quiet[number].iter().zip(stage.chunks(2));
            for ((quiet, parts), (states, rows)) in pairs.zip(states.chunks_mut(2).zip(rows.chunks_mut(2))) {
                if !pass_quietly(simd, quiet, states, rows, count) {
                    for ((part, state), row) in parts.iter().zip(states).zip(rows) {
                        state.pass(simd, part, &mut row[..count]);
                    }
                }
            }
        }
        total(&rows[..met], count)
    }

    /// Adds up what meets at each amplifier of the next stage, into the first of `rows`; how many these are.
    #[inline(always)]
    fn meet(&self, rows: &mut [Row<S>], count: usize) -> usize {
        let amplifiers = rows.len().div_ceil(self.inputs);
        for amplifier in 0..amplifiers {
            let first = amplifier * self.inputs;
            let last = (first + self.inputs).min(rows.len());
            rows[amplifier] = total(&rows[first..last], count);
        }
        amplifiers
    }
}

impl<S: Real> Stage<S> {
    fn at_rest(input: Lanes<S>) -> Self {
        Self { amplifier: AmplifierState { y: input, excess: Lanes::default() }, fed: input }
    }

    /// The samples of `row` through the amplifier.
    #[inline(always)]
    fn pass<L: Simd>(&mut self, simd: L, part: &Amplifier<S>, row: &mut [Lanes<S>]) {
        let mut fed = [self.fed; BLOCK + 1];
        fed[1..=row.len()].copy_from_slice(row);
        part.pass(simd, &mut self.amplifier, &fed[..=row.len()], row);
        self.fed = fed[row.len()];
    }
}

/// The first `count` samples of one or two rows through their amplifiers; false, and nothing is changed, if one might slew or
/// clip.
#[inline(always)]
fn pass_quietly<L: Simd, S: Real>(
    simd: L,
    parts: &QuietAmplifiers<S>,
    stages: &mut [Stage<S>],
    rows: &mut [Row<S>],
    count: usize,
) -> bool {
    let last = stages.len() - 1;
    let mut states = [stages[0].amplifier, stages[last].amplifier];
    let mut out = [Both::default(); BLOCK];
    let from = [&stages[0].fed, &stages[last].fed];
    let inputs = [&rows[0][..count], &rows[last][..count]];
    let is_quiet = parts.pass(simd, states.each_mut(), from, inputs, &mut out);
    if is_quiet {
        for (k, (stage, row)) in stages.iter_mut().zip(rows).enumerate() {
            (stage.amplifier, stage.fed) = (states[k], row[count - 1]);
            for (put, out) in row.iter_mut().zip(&out[..count]) {
                *put = out.wire(k);
            }
        }
    }
    is_quiet
}

/// The sum of `rows` at the first `count` samples.
#[inline(always)]
fn total<S: Real>(rows: &[Row<S>], count: usize) -> Row<S> {
    let mut sums = [Lanes::default(); BLOCK];
    for n in 0..count.min(BLOCK) {
        let mut sum = Lanes::default();
        for row in rows {
            sum = sum + row[n];
        }
        sums[n] = sum;
    }
    sums
}
