//! A group of sweeps on its way through the array.

use std::ops::Range;
use std::{array as lanes, mem};

use signal::{LANES, Lanes, Real};
use sweep_program::SweepProgram;

use super::basis::UNITS;
use super::parts_array::PartsArray;
use super::scale::Scale;
use super::state::{ArrayState, Lane};
use super::terms::{ALL, TERMS, factors, signed, word_of};
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
    /// Everything at rest under ramps that stand as they do at sample `first`.
    pub(super) fn settle(&self, first: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        state.lanes = lanes::from_fn(|lane| {
            Lane::at_start(&self.programs[lane], mem::take(&mut state.lanes[lane].pending))
        });
        state.weights.clear();
        let weight = |lane: &Lane, index: usize| {
            array.weight(lane.registers.hold(self.generator.buffer)[word_of(index % TERMS)[0]], index)
        };
        let weights =
            (0..ALL).map(|index| Lanes::from_fn(|lane| S::from_f64(weight(&state.lanes[lane], index))));
        state.weights.extend(weights);
        let ramps = self.accumulators(first, state);
        for axis in 0..2 {
            state.ramps[axis] = array.ramps[axis].at_rest(ramps[axis]);
            state.axes[axis] = array.generators[axis].at_rest(state.ramps[axis].output());
        }
        state.factors = self.factors(state);
        self.multiply(state);
        let [raw, before] = &mut state.raw;
        before.clone_from(raw);
        state.products.clone_from(&state.raw);
        state.terms.clear();
        state.terms.extend((0..ALL).map(|index| state.products[0][index] * state.weights[index]));
        for (sum, summer) in array.summers.iter().enumerate() {
            state.sums[sum] = summer.at_rest(&state.terms[sum * TERMS..][..TERMS], &mut state.summers[sum]);
        }
        self.trim(state);
    }

    /// The datum is set in retrace so that the height at the eye's foot is right: offsets are common to all of a sweep.
    fn trim(&self, state: &mut ArrayState<S>) {
        let Scale { datum, height, .. } = self.array.scale;
        for (lane, program) in self.programs.iter().enumerate() {
            let digital = &state.lanes[lane].registers;
            let foot = program.start.ramps.map(|ramp| ramp.start);
            let [right, ..] = array(digital.hold(self.generator.buffer), digital.polarity(), foot);
            state.trim[lane] = right - (state.sums[0][lane].to_f64() * height + datum);
        }
    }

    /// From the sample before to `sample`.
    pub(super) fn advance(&self, sample: i64, state: &mut ArrayState<S>) {
        let array = self.array;
        let ramps = self.accumulators(sample - i64::from(array.ramps[0].has_steps()), state);
        for axis in 0..2 {
            let ramp = array.ramps[axis].step(&mut state.ramps[axis], ramps[axis]);
            array.generators[axis].step(&mut state.axes[axis], ramp);
        }
        for (lane, program) in state.lanes.iter_mut().zip(self.programs) {
            lane.turn_until(sample, program, (&array.timing, self.generator));
        }
        state.raw.swap(0, 1);
        self.multiply(state);
        state.products.swap(0, 1);
        let [now, before] = &mut state.products;
        if array.multiplier_lags.is_empty() {
            now.clone_from(&state.raw[0]);
        }
        for (index, lag) in array.multiplier_lags.iter().enumerate() {
            now[index] = lag.step(before[index], state.raw[1][index], state.raw[0][index]);
        }
        self.convert(sample, state);
        self.leak(state);
        let terms = if array.converter_leaks.is_empty() { &state.terms } else { &state.leaky };
        for (sum, summer) in array.summers.iter().enumerate() {
            state.sums[sum] = summer.step(&terms[sum * TERMS..][..TERMS], &mut state.summers[sum]);
        }
    }

    /// Ramps in the accumulators as the beam is at `sample`.
    fn accumulators(&self, sample: i64, state: &mut ArrayState<S>) -> [Lanes<S>; 2] {
        let timing = &self.array.timing;
        let range = range_at(self.generator.ranges, sample as f64 + timing.lead / timing.step);
        let mut out = [Lanes::default(); 2];
        for (number, (lane, program)) in state.lanes.iter_mut().zip(self.programs).enumerate() {
            lane.fold_until(program, range);
            for axis in 0..2 {
                let ramp = &program.start.ramps[axis];
                let (value, _) = ramp.at(lane.folds[axis], range / self.generator.region_size);
                out[axis][number] = S::from_f64(value);
            }
        }
        out
    }

    /// What the function generators put out, with their signs.
    fn factors(&self, state: &ArrayState<S>) -> [[Lanes<S>; UNITS]; 2] {
        std::array::from_fn(|axis| {
            let sign = Lanes::from_fn(|lane| S::from_f64(state.lanes[lane].polarity[axis]));
            signed(&state.axes[axis].out, sign)
        })
    }

    /// All products, without their lags, into `state.raw[0]`.
    fn multiply(&self, state: &mut ArrayState<S>) {
        let [x, y] = self.factors(state);
        let before = mem::replace(&mut state.factors, [x, y]);
        let raw = &mut state.raw[0];
        raw.clear();
        raw.extend((0..ALL).map(|index| {
            let [a, b] = factors(index / TERMS, index % TERMS);
            self.array.multipliers[index].product(x[a], y[b])
        }));
        for (index, leak) in self.array.multiplier_leaks.iter().enumerate() {
            let [a, _] = factors(index / TERMS, index % TERMS);
            raw[index] = raw[index] + leak.leak(before[0][a], x[a]);
        }
    }

    /// Past the multiplying D/As, whatever their words.
    fn leak(&self, state: &mut ArrayState<S>) {
        let [now, before] = &state.products;
        let leaks = self.array.converter_leaks.iter().zip(before.iter().zip(now));
        let leaky = state.terms.iter().zip(leaks);
        state.leaky.clear();
        state.leaky.extend(leaky.map(|(&term, (leak, (&before, &now)))| term + leak.leak(before, now)));
    }

    /// Height and slopes at one sample.
    pub(super) fn put(&self, sample: usize, address: u64, state: &ArrayState<S>, profile: &mut Profile<S>) {
        let Scale { datum, height, slope } = self.array.scale;
        let noise = |sum: usize, lane: usize| match self.array.sigma {
            0.0 => 0.0,
            sigma => sigma * self.array.noise[sum].normal(address + lane as u64, sample as u64),
        };
        for (lane, program) in self.programs.iter().enumerate() {
            let value = |sum: usize| state.sums[sum][lane].to_f64() + noise(sum, lane);
            let [hu, hv] = [1, 2].map(|sum| value(sum) * slope / self.generator.region_size);
            let [cos, sin] = program.start.direction;
            profile.height[sample][lane] =
                S::from_f64(value(0) * height + datum + state.trim[lane] - self.generator.datum);
            profile.along[sample][lane] = S::from_f64(hu * cos + hv * sin);
            profile.across[sample][lane] = S::from_f64(hv * cos - hu * sin);
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
