//! Wires and registers of a group of sweeps.

use fearless_simd::Simd;
use landscape::CornerWords;
use signal::{Both, Double, LANES, Lanes, Real};
use sweep_program::{Fold, RampAxis, Step, SweepProgram};

use super::basis::{AxisState, CURVES};
use super::block::{Block, Factor};
use super::grid::GridWires;
use super::ramp::RampState;
use super::row_words::RowWords;
use super::summer::SummerState;
use super::timing::Timing;
use super::words::Words;
use crate::{Registers, TerrainGenerator};

/// Wires of a group of sweeps; used again from group to group.
#[derive(Debug, Clone)]
pub struct ArrayState<S> {
    pub(super) accumulators: Accumulators,
    pub(super) ramps: [RampState<S>; 2],
    pub(super) axes: [AxisState<S>; 2],
    /// Signs that the polarity gives the function generators.
    pub(super) signs: [[Both<S>; CURVES]; 2],
    /// Factors of X with their signs, at the sample that went through last.
    pub(super) before: [Both<S>; CURVES],
    pub(super) wires: GridWires<S>,
    pub(super) summers: [SummerState<S>; 3],
    /// The samples that went through last.
    pub(super) block: Box<Block<S>>,
    pub(super) words: Words<S>,
    /// Those of D/As that are alike.
    pub(super) row_words: RowWords<S>,
    /// What was coded last, colour by colour: sweeps of a group meet the same corners.
    pub(super) coded: [Coded; 4],
    /// Deviates of the sums, at this sample and at the other of its pair.
    pub(super) noise: [[[f64; LANES]; 2]; 3],
    /// What the datum of each sweep is trimmed by (m).
    pub(super) trim: [f64; LANES],
    pub(super) lanes: [Lane; LANES],
    pub(super) due: Due,
}

/// Both ramps of a group in their accumulators, `base + sign (rate lambda + offset)` with the bracket within 0..=1 and
/// lambda the range in regions: [`sweep_program::Ramp::at`] after so many folds.
#[derive(Debug, Clone, Default)]
pub(super) struct Accumulators {
    rate: [[f64; LANES]; 2],
    offset: [[f64; LANES]; 2],
    base: [[f64; LANES]; 2],
    sign: [[f64; LANES]; 2],
}

/// Words of a corner, their numbers in D/As, and their shares of full scale there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coded {
    pub(super) words: CornerWords,
    pub(super) numbers: [i32; 9],
    pub(super) shares: [f64; 9],
}

impl Coded {
    /// The set that belongs to no corner.
    pub(super) const NONE: Self = Self { words: [f64::NAN; 9], numbers: [0; 9], shares: [0.0; 9] };
}

/// When something digital is next due in any lane: between these instants nobody asks.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Due {
    /// A step for the accumulators (m of ground range).
    pub(super) fold: f64,
    /// A step for the polarity, a strobe (samples).
    pub(super) turn: f64,
    pub(super) strobe: f64,
}

/// The digital side of one sweep of the group.
#[derive(Debug, Clone, Default)]
pub(super) struct Lane {
    pub(super) registers: Registers,
    /// Next step of the program for the accumulators, the polarity of each axis and the registers.
    folded: usize,
    turned: [usize; 2],
    strobed: usize,
    /// When the polarity of each axis turns next (samples): neither axis waits for the other.
    turns: [f64; 2],
    /// When a nominal D/A had the words of the last strobe (samples).
    strobed_at: f64,
    /// Words in the hold registers after the last strobe, and their numbers in a D/A, by colour.
    pub(super) held: [CornerWords; 4],
    pub(super) numbers: [[i32; 9]; 4],
    folds: [u32; 2],
    pub(super) polarity: [f64; 2],
    pub(super) due: Due,
}

impl<S: Real> Default for ArrayState<S> {
    fn default() -> Self {
        Self {
            accumulators: Accumulators::default(),
            ramps: Default::default(),
            axes: Default::default(),
            signs: [[Both::default(); CURVES]; 2],
            before: [Both::default(); CURVES],
            wires: GridWires::default(),
            summers: Default::default(),
            block: Box::default(),
            words: Words::default(),
            row_words: RowWords::default(),
            coded: [Coded::NONE; 4],
            noise: [[[0.0; LANES]; 2]; 3],
            trim: [0.0; LANES],
            lanes: Default::default(),
            due: Due::default(),
        }
    }
}

impl<S: Real> ArrayState<S> {
    /// Gives what the function generators put out its signs: the factors at sample `n` of the block, with what errors of
    /// multipliers take of them where these have any.
    #[inline(always)]
    pub(super) fn put_factors<L: Simd>(&mut self, simd: L, n: usize, have_errors: bool) {
        let Self { axes: [x, y], signs, block, before, .. } = self;
        let load = |both: &Both<S>| S::Double::<L>::load(simd, both);
        for curve in 0..CURVES {
            let value = load(&x.out[curve]) * load(&signs[0][curve]);
            let Factor { value: values, cube, change: changes } = &mut block.x[curve];
            value.store(&mut values[n]);
            if have_errors {
                let change = value - load(&before[curve]);
                (value * (value * value)).store(&mut cube[n]);
                change.store(&mut changes[n]);
                value.store(&mut before[curve]);
            }
            (load(&y.out[curve]) * load(&signs[1][curve])).store(&mut block.y[curve][n]);
        }
    }
}

impl Accumulators {
    /// Ramp `axis` of a lane from its next fold on.
    pub(super) fn set(&mut self, lane: usize, axis: usize, program: &SweepProgram, folds: u32) {
        let ramp = &program.start.ramps[axis];
        let (rate, offset, falls) = if folds == 0 {
            (ramp.rate, ramp.start, false)
        } else {
            let (first, stop) = ramp.first_stop();
            let falls = (stop == sweep_program::Stop::One) == (folds % 2 == 1);
            (ramp.rate.abs(), -(first + f64::from(folds - 1)), falls)
        };
        self.rate[axis][lane] = rate;
        self.offset[axis][lane] = offset;
        (self.base[axis][lane], self.sign[axis][lane]) = if falls { (1.0, -1.0) } else { (0.0, 1.0) };
    }

    /// Both ramps at range `lambda` (in regions).
    #[inline(always)]
    pub(super) fn at<S: Real>(&self, lambda: f64) -> [Lanes<S>; 2] {
        let mut out = [Lanes::default(); 2];
        for axis in 0..2 {
            for lane in 0..LANES {
                let way = self.rate[axis][lane] * lambda + self.offset[axis][lane];
                let way = if way > 0.0 { way } else { 0.0 };
                let way = if way < 1.0 { way } else { 1.0 };
                out[axis].0[lane] = S::from_f64(self.base[axis][lane] + self.sign[axis][lane] * way);
            }
        }
        out
    }
}

impl Due {
    /// The earliest of all lanes.
    pub(super) fn of(lanes: &[Lane; LANES]) -> Self {
        let earliest = |which: fn(&Self) -> f64| {
            lanes
                .iter()
                .map(|lane| which(&lane.due))
                .fold(f64::INFINITY, |first, at| if at < first { at } else { first })
        };
        Self {
            fold: earliest(|due| due.fold),
            turn: earliest(|due| due.turn),
            strobe: earliest(|due| due.strobe),
        }
    }
}

impl Lane {
    /// At the start of a sweep.
    pub(super) fn at_start(program: &SweepProgram) -> Self {
        let registers = Registers::at_start(program);
        let polarity = registers.polarity();
        Self { registers, strobed_at: f64::NEG_INFINITY, polarity, ..Self::default() }
    }

    /// Looks up when something is next due.
    pub(super) fn look_ahead(&mut self, program: &SweepProgram, when: (&Timing, &TerrainGenerator<'_>)) {
        self.turns = [0, 1].map(|axis| self.next_turn(axis, program, when));
        self.due = Due {
            fold: self.next_fold(program),
            turn: self.turns[0].min(self.turns[1]),
            strobe: self.next_strobe(program, when) + when.0.earliest,
        };
    }

    fn next_fold(&self, program: &SweepProgram) -> f64 {
        program.steps.get(self.folded).map_or(f64::INFINITY, |step| step.range)
    }

    /// When the polarity of an axis turns next (samples).
    fn next_turn(
        &mut self,
        axis: usize,
        program: &SweepProgram,
        (timing, generator): (&Timing, &TerrainGenerator<'_>),
    ) -> f64 {
        let is_of_axis = |step: &Step| step.kind.fold().is_some_and(|fold| axis_of(fold) == axis);
        while program.steps.get(self.turned[axis]).is_some_and(|step| !is_of_axis(step)) {
            self.turned[axis] += 1;
        }
        let next = program.steps.get(self.turned[axis]);
        next.map_or(f64::INFINITY, |step| timing.of_polarity(step, generator, program))
    }

    /// When a nominal D/A has the words of the next strobe; at once where a step leaves those in hold alone.
    fn next_strobe(
        &self,
        program: &SweepProgram,
        (timing, generator): (&Timing, &TerrainGenerator<'_>),
    ) -> f64 {
        match program.steps.get(self.strobed) {
            Some(step) if step.kind.changes_hold() => {
                timing.of_words(step, generator, program).max(self.strobed_at)
            }
            Some(_) => self.strobed_at,
            None => f64::INFINITY,
        }
    }

    /// Folds of the accumulators up to `range` (m); the folds of each axis so far.
    pub(super) fn fold_until(&mut self, program: &SweepProgram, range: f64) -> [u32; 2] {
        for step in program.steps[self.folded..].iter().take_while(|step| step.range <= range) {
            self.folded += 1;
            if let Some(fold) = step.kind.fold() {
                self.folds[axis_of(fold)] += 1;
            }
        }
        self.due.fold = self.next_fold(program);
        self.folds
    }

    /// Polarity as it is on the wires at `sample`.
    pub(super) fn turn_until(
        &mut self,
        sample: i64,
        program: &SweepProgram,
        when: (&Timing, &TerrainGenerator<'_>),
    ) {
        loop {
            let axis = usize::from(self.turns[1] < self.turns[0]);
            self.due.turn = self.turns[axis];
            if self.due.turn > sample as f64 {
                return;
            }
            self.polarity[axis] = -self.polarity[axis];
            self.turned[axis] += 1;
            self.turns[axis] = self.next_turn(axis, program, when);
        }
    }

    /// The next strobe, if any D/A has its words by `sample`: when a nominal D/A has them (samples), and whether they are
    /// others than before.
    pub(super) fn strobe(
        &mut self,
        sample: i64,
        program: &SweepProgram,
        when: (&Timing, &TerrainGenerator<'_>),
    ) -> Option<(f64, bool)> {
        if self.due.strobe > sample as f64 {
            return None;
        }
        let step = program.steps.get(self.strobed)?;
        let at = self.next_strobe(program, when);
        (self.strobed, self.strobed_at) = (self.strobed + 1, at);
        self.registers.apply(step, when.1.buffer);
        self.due.strobe = self.next_strobe(program, when) + when.0.earliest;
        Some((at, step.kind.changes_hold()))
    }
}

fn axis_of(fold: &Fold) -> usize {
    usize::from(fold.axis == RampAxis::Y)
}
