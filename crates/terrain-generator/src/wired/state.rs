//! Wires and registers of a group of sweeps.

use landscape::CornerWords;
use signal::{LANES, Lanes};
use sweep_program::{RampAxis, Step, StepKind, SweepProgram};

use super::basis::{AxisState, UNITS};
use super::ramp::RampState;
use super::summer::SummerState;
use super::timing::Timing;
use crate::{Registers, TerrainGenerator};

/// Wires of a group of sweeps; used again from group to group.
#[derive(Debug, Clone)]
pub struct ArrayState<S> {
    pub(super) ramps: [RampState<S>; 2],
    pub(super) axes: [AxisState<S>; 2],
    /// Products without their lags, now and a sample ago.
    pub(super) raw: [Vec<Lanes<S>>; 2],
    /// Products, now and a sample ago.
    pub(super) products: [Vec<Lanes<S>>; 2],
    /// Factors a sample ago, with their signs: X, Y.
    pub(super) factors: [[Lanes<S>; UNITS]; 2],
    pub(super) terms: Vec<Lanes<S>>,
    /// Terms with what leaks past the D/As.
    pub(super) leaky: Vec<Lanes<S>>,
    pub(super) summers: [SummerState<S>; 3],
    pub(super) sums: [Lanes<S>; 3],
    /// What the datum of each sweep is trimmed by (m).
    pub(super) trim: [f64; LANES],
    /// What each multiplying D/A multiplies by.
    pub(super) weights: Vec<Lanes<S>>,
    pub(super) divided: Vec<Divided>,
    pub(super) lanes: [Lane; LANES],
}

/// The digital side of one sweep of the group.
#[derive(Debug, Clone, Default)]
pub(super) struct Lane {
    pub(super) registers: Registers,
    /// Next step of the program for the accumulators, the polarity and the registers.
    pub(super) folded: usize,
    pub(super) turned: usize,
    pub(super) strobed: usize,
    /// When a nominal D/A had the words of the last strobe (samples).
    strobed_at: f64,
    /// Words that have been strobed and not yet acted.
    pub(super) pending: Vec<Change>,
    pub(super) folds: [u32; 2],
    pub(super) polarity: [f64; 2],
}

/// A multiplying D/A whose word changes within a sample: its output at `share` of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Divided {
    pub(super) lane: usize,
    pub(super) index: usize,
    pub(super) share: f64,
    pub(super) output: f64,
}

/// A multiplying D/A takes a new word.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    /// When (samples).
    pub(super) at: f64,
    pub(super) index: usize,
    /// What it multiplies by from then on.
    pub(super) weight: f64,
    /// Area of the pulse for a product of full scale (full scale times seconds).
    pub(super) pulse: f64,
}

impl<S: signal::Real> Default for ArrayState<S> {
    fn default() -> Self {
        Self {
            ramps: Default::default(),
            axes: Default::default(),
            raw: Default::default(),
            products: Default::default(),
            factors: [[Lanes::default(); UNITS]; 2],
            terms: Vec::new(),
            leaky: Vec::new(),
            summers: Default::default(),
            sums: [Lanes::default(); 3],
            trim: [0.0; LANES],
            weights: Vec::new(),
            divided: Vec::new(),
            lanes: Default::default(),
        }
    }
}

impl Lane {
    /// At the start of a sweep; `pending` is a buffer that is used again.
    pub(super) fn at_start(program: &SweepProgram, mut pending: Vec<Change>) -> Self {
        let registers = Registers::at_start(program);
        let polarity = registers.polarity();
        pending.clear();
        Self {
            registers,
            folded: 0,
            turned: 0,
            strobed: 0,
            strobed_at: f64::NEG_INFINITY,
            pending,
            folds: [0; 2],
            polarity,
        }
    }

    /// Folds of the accumulators up to `range` (m).
    pub(super) fn fold_until(&mut self, program: &SweepProgram, range: f64) {
        for step in program.steps[self.folded..].iter().take_while(|step| step.range <= range) {
            self.folded += 1;
            if let StepKind::Fold(fold) | StepKind::BareFold(fold) = step.kind {
                self.folds[usize::from(fold.axis == RampAxis::Y)] += 1;
            }
        }
    }

    /// Polarity as it is on the wires at `sample`.
    pub(super) fn turn_until(
        &mut self,
        sample: i64,
        program: &SweepProgram,
        (timing, generator): (&Timing, &TerrainGenerator<'_>),
    ) {
        let has_acted = |step: &&Step| timing.of_polarity(step, generator, program) <= sample as f64;
        for step in program.steps[self.turned..].iter().take_while(has_acted) {
            self.turned += 1;
            if let StepKind::Fold(fold) | StepKind::BareFold(fold) = step.kind {
                let axis = usize::from(fold.axis == RampAxis::Y);
                self.polarity[axis] = -self.polarity[axis];
            }
        }
    }

    /// The next strobe, if any D/A has its words by `sample`: what was in the hold registers before it, and when a nominal
    /// D/A has what is there now (samples).
    pub(super) fn strobe(
        &mut self,
        sample: i64,
        program: &SweepProgram,
        (timing, generator): (&Timing, &TerrainGenerator<'_>),
    ) -> Option<([CornerWords; 4], f64)> {
        let step = program.steps.get(self.strobed)?;
        let at = timing.of_words(step, generator, program).max(self.strobed_at);
        if at + timing.earliest > sample as f64 {
            return None;
        }
        let before = self.registers.hold(generator.buffer).map(|words| *words);
        (self.strobed, self.strobed_at) = (self.strobed + 1, at);
        self.registers.apply(step, generator.buffer);
        Some((before, at))
    }
}
