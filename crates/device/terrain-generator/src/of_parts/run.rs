//! A group of sweeps on its way through the array.

use std::ops::Range;

use fearless_simd::Simd;
use signal::{LANES, Lanes, Real};
use sweep_program::SweepProgram;

use super::Tap;
use super::basis::UNITS;
use super::block::{BLOCK, Block, Row};
use super::out::Out;
use super::parts_array::PartsArray;
use super::rows::Alike;
use super::scale::Scale;
use super::state::{ArrayState, Coded, Due, Lane};
use crate::TerrainGenerator;
use crate::array::array;
use crate::generator::{OUT_OF_SIGHT, Profile};
use crate::terms::{ALL, side_by_side, sign};

/// One group on its way through the array.
#[derive(Clone, Copy)]
pub(super) struct Run<'a, S> {
    pub(super) array: &'a PartsArray<S>,
    pub(super) generator: &'a TerrainGenerator<'a>,
    pub(super) programs: &'a [SweepProgram; LANES],
}

impl<S: Real> Run<'_, S> {
    /// The digital side as it is at the eye's foot.
    pub(super) fn begin(&self, state: &mut ArrayState<S>) {
        let when = (&self.array.timing, self.generator);
        for (number, program) in self.programs.iter().enumerate() {
            let mut lane = Lane::at_start(program);
            lane.look_ahead(program, when);
            (0..2).for_each(|axis| state.accumulators.set(number, axis, program, 0));
            state.lanes[number] = lane;
        }
        state.due = Due::of(&state.lanes);
        state.words.clear();
        state.coded = [Coded::NONE; 4];
        state.wires.resize(ALL);
        state.block.partial.resize(3 * self.array.grid.groups(), [Lanes::default(); BLOCK]);
        self.fill_registers(state);
        self.put_signs(state);
    }

    /// Through the samples of `span`, from as long before it as the parts remember.
    #[inline(always)]
    pub(super) fn trace<L: Simd, T: Tap<S>>(
        &self,
        simd: L,
        span: Range<usize>,
        address: u64,
        state: &mut ArrayState<S>,
        profile: &mut Profile<S>,
        tap: &mut T,
    ) {
        let timing = &self.array.timing;
        // The accumulators leave the eye's foot a sample before the first, and the beam is behind them.
        let foot = -(1.0 + timing.lead / timing.step).ceil() as i64;
        let at_foot = self.accumulated(0.0, state);
        if !timing.preset {
            self.act_until(foot, state);
        }
        self.settle(simd, at_foot, state);
        self.trim(state);
        let first = foot.max((span.start as i64).saturating_sub(self.array.warm_up));
        if timing.preset || first > foot {
            let ramps = self.accumulators(first, state);
            self.act_until(first, state);
            self.settle(simd, ramps, state);
        }
        self.sweep(simd, first, span, address, state, profile, tap);
    }

    /// Polarity and words as they are on the wires at `sample`, before anything moves.
    fn act_until(&self, sample: i64, state: &mut ArrayState<S>) {
        self.turn(sample, state);
        self.strobe(sample, state);
        self.take_words(sample, state);
    }

    /// Everything at rest under accumulators that stand: the block is one sample.
    #[inline(always)]
    fn settle<L: Simd>(&self, simd: L, ramps: [Lanes<S>; 2], state: &mut ArrayState<S>) {
        let array = self.array;
        for axis in 0..2 {
            state.ramps[axis] = array.ramps[axis].at_rest(ramps[axis]);
            let fed = array.generators[axis].feed(simd, state.ramps[axis].output());
            state.axes[axis] = array.generators[axis].at_rest(simd, &fed);
            state.block.fed[axis][0] = fed;
        }
        state.put_factors(simd, 0, true);
        array.grid.settle(&mut state.block, &mut state.wires);
        let Block { partial, sums, .. } = &mut *state.block;
        for (sum, summer) in array.summers.iter().enumerate() {
            sums[sum][0] = summer.at_rest(rows_of(sum, partial), &mut state.summers[sum]);
        }
    }

    /// The datum is set in retrace so that the height at the eye's foot is right: offsets are common to all of a sweep.
    fn trim(&self, state: &mut ArrayState<S>) {
        let Scale { datum, height, .. } = self.array.scale;
        for (lane, program) in self.programs.iter().enumerate() {
            let digital = &state.lanes[lane].registers;
            let foot = program.start.ramps.map(|ramp| ramp.start);
            let [right, ..] = array(digital.hold(self.generator.buffer), digital.polarity(), foot);
            state.trim[lane] = right - (state.block.sums[0][0][lane].to_f64() * height + datum);
        }
    }

    /// From rest at sample `first` to the end of `span`, whose samples go into `profile`.
    #[inline(always)]
    fn sweep<L: Simd, T: Tap<S>>(
        &self,
        simd: L,
        first: i64,
        span: Range<usize>,
        address: u64,
        state: &mut ArrayState<S>,
        profile: &mut Profile<S>,
        tap: &mut T,
    ) {
        let (out, end) = (Out::new(self, address, &state.trim), span.end as i64);
        let mut samples = first..(first + 1).min(end);
        while !samples.is_empty() {
            if samples.start > first {
                self.advance::<L, T>(simd, &samples, state);
            }
            for (n, sample) in
                samples.clone().enumerate().skip_while(|(_, sample)| *sample < span.start as i64)
            {
                out.put((sample as usize, n), sample == span.start as i64, state, profile);
            }
            if samples.end > span.start as i64 {
                tap.see(self.array, state);
            }
            samples = samples.end..(samples.end + T::PACE as i64).min(end);
        }
    }

    /// From the sample before to the last of `samples`.
    #[inline(always)]
    fn advance<L: Simd, T: Tap<S>>(&self, simd: L, samples: &Range<i64>, state: &mut ArrayState<S>) {
        let (array, count) = (self.array, (samples.end - samples.start) as usize);
        let alike = array.grid.alike.as_ref().filter(|_| !T::WIRES);
        let has_strobes = state.due.strobe <= (samples.end - 1) as f64;
        match alike {
            Some(alike) => {
                state.row_words.begin(samples);
                if has_strobes {
                    self.strobe_rows(samples.end - 1, state);
                    state.row_words.divide([array.timing.step, alike.tau], &array.converters);
                }
            }
            None => {
                state.words.begin(samples);
                if has_strobes {
                    self.strobe(samples.end - 1, state);
                }
                state.words.divide(array.timing.step, &array.converters);
            }
        }
        self.ramps(simd, samples, state);
        let have_errors = alike.is_none_or(Alike::have_errors);
        for (n, sample) in samples.clone().enumerate() {
            for axis in 0..2 {
                array.generators[axis].step(simd, &mut state.axes[axis], &state.block.fed[axis][n]);
            }
            if state.due.turn <= sample as f64 {
                self.turn(sample, state);
            }
            state.put_factors(simd, n, have_errors);
        }
        let ArrayState { block, words, row_words, wires, .. } = state;
        match alike {
            Some(alike) => array.grid.run_rows(simd, alike, block, count, row_words, wires),
            None => array.grid.run(simd, block, count, words, wires),
        }
        let Block { partial, sums, .. } = &mut *state.block;
        for (sum, summer) in array.summers.iter().enumerate() {
            sums[sum] = summer.run(simd, rows_of(sum, partial), count, &mut state.summers[sum]);
        }
    }

    /// Ramps from the sample before to the last of `samples`, and what they feed: one ramp after the other, since each step waits
    /// for the one before.
    #[inline(always)]
    fn ramps<L: Simd>(&self, simd: L, samples: &Range<i64>, state: &mut ArrayState<S>) {
        let (array, count) = (self.array, samples.clone().count());
        let late = i64::from(array.ramps[0].has_steps());
        let mut values = [[Lanes::default(); BLOCK]; 2];
        for (n, sample) in samples.clone().enumerate() {
            [values[0][n], values[1][n]] = self.accumulators(sample - late, state);
        }
        for axis in 0..2 {
            let values = &mut values[axis][..count];
            array.ramps[axis].pass(simd, &mut state.ramps[axis], values);
            for (fed, &value) in state.block.fed[axis].iter_mut().zip(&*values) {
                *fed = array.generators[axis].feed(simd, value);
            }
        }
    }

    /// Ramps in the accumulators as the beam is at `sample`.
    #[inline(always)]
    fn accumulators(&self, sample: i64, state: &mut ArrayState<S>) -> [Lanes<S>; 2] {
        let range = self.array.timing.accumulated(self.generator.ranges, sample as f64);
        self.accumulated(range, state)
    }

    /// The same at a ground range (m).
    #[inline(always)]
    fn accumulated(&self, range: f64, state: &mut ArrayState<S>) -> [Lanes<S>; 2] {
        if range >= state.due.fold {
            self.fold(range, state);
        }
        state.accumulators.at(range / self.generator.region_size)
    }

    #[inline(never)]
    fn fold(&self, range: f64, state: &mut ArrayState<S>) {
        for (number, (lane, program)) in state.lanes.iter_mut().zip(self.programs).enumerate() {
            if lane.due.fold <= range {
                let folds = lane.fold_until(program, range);
                (0..2).for_each(|axis| state.accumulators.set(number, axis, program, folds[axis]));
            }
        }
        state.due = Due::of(&state.lanes);
    }

    #[inline(never)]
    fn turn(&self, sample: i64, state: &mut ArrayState<S>) {
        for (lane, program) in state.lanes.iter_mut().zip(self.programs) {
            lane.turn_until(sample, program, (&self.array.timing, self.generator));
        }
        state.due = Due::of(&state.lanes);
        self.put_signs(state);
    }

    fn put_signs(&self, state: &mut ArrayState<S>) {
        for (lane, from) in state.lanes.iter().enumerate() {
            for axis in 0..2 {
                for unit in 0..UNITS {
                    let [curve, end] = side_by_side(unit);
                    let sign = S::from_f64(sign(unit, from.polarity[axis]));
                    state.signs[axis][curve].0[LANES * end + lane] = sign;
                }
            }
        }
    }

    pub(super) fn end_profiles(&self, span: Range<usize>, profile: &mut Profile<S>) {
        for (lane, program) in self.programs.iter().enumerate() {
            let last = self.generator.ranges.partition_point(|&range| range <= program.end_range);
            for sample in last.clamp(span.start, span.end)..span.end {
                profile.height[sample][lane] = S::from_f64(OUT_OF_SIGHT);
                profile.along[sample][lane] = S::ZERO;
                profile.across[sample][lane] = S::ZERO;
            }
        }
    }
}

/// What meets at the first stage of a sum.
#[inline(always)]
fn rows_of<S>(sum: usize, partial: &mut [Row<S>]) -> &mut [Row<S>] {
    let groups = partial.len() / 3;
    &mut partial[groups * sum..groups * (sum + 1)]
}
