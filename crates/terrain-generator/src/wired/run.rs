//! A group of sweeps on its way through the array.

use std::mem;
use std::ops::Range;

use signal::{LANES, Lanes, Real};
use sweep_program::SweepProgram;

use super::Tap;
use super::out::Out;
use super::parts_array::PartsArray;
use super::scale::Scale;
use super::state::{ArrayState, Due, Lane};
use super::terms::{ALL, signed};
use super::timing::range_at;
use crate::TerrainGenerator;
use crate::array::array;
use crate::generator::{OUT_OF_SIGHT, Profile};

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
            let mut lane = Lane::at_start(program, mem::take(&mut state.lanes[number].pending));
            lane.look_ahead(program, when);
            (0..2).for_each(|axis| state.accumulators.set(number, axis, program, 0));
            state.lanes[number] = lane;
        }
        state.due = Due::of(&state.lanes);
        state.wires.resize(ALL, Default::default());
        state.partial.resize(3 * self.array.grid.groups(), Lanes::default());
        self.fill_registers(state);
        self.put_signs(state);
    }

    /// Everything at rest under ramps that stand as they do at sample `first`, with the words that act there.
    pub(super) fn settle(&self, first: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        let ramps = self.accumulators(first, state);
        for axis in 0..2 {
            state.ramps[axis] = array.ramps[axis].at_rest(ramps[axis]);
            state.axes[axis] = array.generators[axis].at_rest(state.ramps[axis].output());
        }
        self.turn(first, state);
        self.strobe(first, state);
        self.take_words(first, state);
        state.factors = [0, 1].map(|axis| signed(&state.axes[axis].out, state.signs[axis]));
        array.grid.settle(&state.factors, &mut state.wires, &mut state.partial);
        for (sum, summer) in array.summers.iter().enumerate() {
            state.sums[sum] = summer.at_rest(groups_of(sum, &state.partial), &mut state.summers[sum]);
        }
    }

    /// The datum is set in retrace so that the height at the eye's foot is right: offsets are common to all of a sweep.
    pub(super) fn trim(&self, state: &mut ArrayState<S>) {
        let Scale { datum, height, .. } = self.array.scale;
        for (lane, program) in self.programs.iter().enumerate() {
            let digital = &state.lanes[lane].registers;
            let foot = program.start.ramps.map(|ramp| ramp.start);
            let [right, ..] = array(digital.hold(self.generator.buffer), digital.polarity(), foot);
            state.trim[lane] = right - (state.sums[0][lane].to_f64() * height + datum);
        }
    }

    /// From rest at sample `first` to the end of `span`, whose samples go into `profile`.
    #[inline(always)]
    pub(super) fn sweep(
        &self,
        first: i64,
        span: Range<usize>,
        address: u64,
        state: &mut ArrayState<S>,
        profile: &mut Profile<S>,
        tap: &mut impl Tap<S>,
    ) {
        let out = Out::new(self, address, &state.trim);
        for sample in first..span.end as i64 {
            if sample > first {
                self.advance(sample, state);
            }
            if sample >= span.start as i64 {
                if self.array.sigma > 0.0 && (sample % 2 == 0 || sample == span.start as i64) {
                    for sum in 0..3 {
                        state.noise[sum] = out.noise[sum].pair(sample as u64 / 2);
                    }
                }
                out.put(sample as usize, state, profile);
                tap.see(self.array, state);
            }
        }
    }

    /// From the sample before to `sample`.
    #[inline(always)]
    fn advance(&self, sample: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        let ramps = self.accumulators(sample - i64::from(array.ramps[0].has_steps()), state);
        for axis in 0..2 {
            let ramp = array.ramps[axis].step(&mut state.ramps[axis], ramps[axis]);
            array.generators[axis].step(&mut state.axes[axis], ramp);
        }
        if state.due.turn <= sample as f64 {
            self.turn(sample, state);
        }
        if state.due.strobe <= sample as f64 {
            self.strobe(sample, state);
        }
        let before = state.factors[0];
        for axis in 0..2 {
            state.factors[axis] = signed(&state.axes[axis].out, state.signs[axis]);
        }
        array.grid.step(&state.factors, &before, &mut state.wires, &mut state.partial);
        if state.due.change <= sample as f64 {
            self.change_words(sample, state);
        }
        for (sum, summer) in array.summers.iter().enumerate() {
            state.sums[sum] = summer.step(groups_of(sum, &state.partial), &mut state.summers[sum]);
        }
    }

    /// Ramps in the accumulators as the beam is at `sample`.
    #[inline(always)]
    fn accumulators(&self, sample: i64, state: &mut ArrayState<S>) -> [Lanes<S>; 2] {
        let timing = &self.array.timing;
        let range = range_at(self.generator.ranges, sample as f64 + timing.lead / timing.step);
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
        let polarity = |axis: usize| Lanes::from_fn(|lane| S::from_f64(state.lanes[lane].polarity[axis]));
        state.signs = [polarity(0), polarity(1)];
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
fn groups_of<S>(sum: usize, partial: &[Lanes<S>]) -> &[Lanes<S>] {
    let groups = partial.len() / 3;
    &partial[groups * sum..groups * (sum + 1)]
}
