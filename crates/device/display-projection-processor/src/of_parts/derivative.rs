//! Occlusion by derivative, as reported (section 15.2), of real parts.
//!
//! **Latch.** Set while the comparator behind the differentiator says that elevation falls; then reset by the comparator
//! of elevation against hold. Set wins: a blank that comes a little early at a crest stays, and does not free the
//! ground behind it. The comparator against the hold begins low with every hold.

use fearless_simd::prelude::{Select, SimdBase, SimdMask};
use fearless_simd::{Level, Simd, dispatch};
use parts::{Comparator, ComparatorState, NoiseSource, SampleHold, Watch};
use signal::{LANES, Lanes, Real, eight};

use crate::of_parts::chain::Scratch;
use crate::of_parts::falls::Falls;
use crate::of_parts::figures::Figures;
use crate::of_parts::lane::{Beam, Group, Held, Output, Trace, Wire, bits, comparable};

/// The circuit, for one step length.
#[derive(Debug, Clone)]
pub(crate) struct Derivative<S> {
    pub falls: Falls<S>,
    returning: Comparator<S>,
    hold: SampleHold<S>,
    aperture: NoiseSource,
}

impl<S: Real> Derivative<S> {
    pub fn new(h: f64, figures: &Figures<'_>) -> Self {
        let returning = "dpp.hold.comparator";
        let against_hold = figures.comparator(returning, figures.noise());
        Self {
            falls: Falls::new(h, figures),
            returning: Comparator::new(h, &against_hold, figures.source(returning)),
            hold: SampleHold::new(h, &figures.sample_hold("dpp.hold")),
            aperture: figures.source("dpp.hold.aperture"),
        }
    }

    /// Runs a group; `hold` takes what the sample-and-holds have at each sample.
    pub fn run(
        &self,
        group: &Group<'_, S>,
        scratch: &mut Scratch<S>,
        beams: &mut [Beam<'_>; LANES],
        hold: &mut [Lanes<S>],
    ) {
        let mut latches = self.latches(group, scratch);
        dispatch!(Level::new(), simd => latches.run_wide(simd, beams, hold));
    }

    /// The sweeps of a group as they begin, with all falls of theirs.
    fn latches<'a>(&'a self, group: &'a Group<'a, S>, scratch: &'a mut Scratch<S>) -> Latches<'a, S> {
        let Scratch { outputs: [falling, returning], rates, .. } = scratch;
        self.falls.list(group, rates, falling);
        Latches {
            circuit: self,
            group,
            falling,
            returning,
            watch: self.returning.watch(&group.sweeps),
            memories: group.elevation[0].0.map(Memory::Open),
            traces: group.elevation[0].0.map(|value| Trace::new(0.0, value)),
            due: [f64::INFINITY; LANES],
            blanked: 0,
            taken: Lanes::default(),
            since: [0.0; LANES],
        }
    }
}

/// The sample-and-hold of one sweep.
#[derive(Debug, Clone, Copy)]
enum Memory<S> {
    /// Beam on: the tracked value.
    Open(S),
    /// Beam off: the held value, and the comparator that turns the beam on again.
    Blanked(Held<S>, ComparatorState),
}

/// Sweeps side by side. Nearly always those that track go on tracking and those that are blanked go on holding; a sweep whose
/// comparator may stir, or trips, takes the step alone.
struct Latches<'a, S> {
    circuit: &'a Derivative<S>,
    group: &'a Group<'a, S>,
    falling: &'a mut [Output; LANES],
    returning: &'a mut [Output; LANES],
    /// Over the comparators against the hold, of sweeps that are blanked.
    watch: Watch<S>,
    /// As they were after the last step that was taken alone.
    memories: [Memory<S>; LANES],
    traces: [Trace<S>; LANES],
    /// When the next trip comes that a sweep minds.
    due: [f64; LANES],
    /// Sweeps that are blanked, what they hold and since when.
    blanked: u64,
    taken: Lanes<S>,
    since: [f64; LANES],
}

impl<S: Real> Latches<'_, S> {
    #[inline(always)]
    fn run_wide<L: Simd>(&mut self, simd: L, beams: &mut [Beam<'_>; LANES], hold: &mut [Lanes<S>]) {
        let Group { elevation, ends, .. } = *self.group;
        (0..LANES).for_each(|lane| self.settle(lane));
        let mut before = S::Vector::<L>::from_slice(simd, &elevation[0].0);
        for sample in 1..ends.into_iter().max().unwrap_or(0) {
            let now = S::Vector::<L>::from_slice(simd, &elevation[sample].0);
            let last = S::Vector::<L>::from_slice(simd, &hold[sample - 1].0);
            let mut next = self.circuit.hold.track(last, before, now);
            let mut alone = self.due_by(sample as f64);
            if self.blanked != 0 {
                let held = self.held(simd, sample as f64);
                alone |= self.blanked & self.watch.stirs(simd, sample, before - last, now - held);
                next =
                    <S::Vector<L> as SimdBase<L>>::Mask::from_bitmask(simd, self.blanked).select(held, next);
            }
            next.store_slice(&mut hold[sample].0);
            for lane in bits(alone) {
                self.step(lane, sample, &mut beams[lane], hold);
            }
            before = now;
        }
    }

    /// What blanked sweeps hold at `time`.
    #[inline(always)]
    fn held<L: Simd>(&self, simd: L, time: f64) -> S::Vector<L> {
        let mut steps = [0.0; LANES];
        for lane in 0..LANES {
            steps[lane] = time - self.since[lane];
        }
        self.circuit.hold.held(S::Vector::from_slice(simd, &self.taken.0), S::narrow(eight(simd, &steps)))
    }

    /// Sweeps with a trip up to `time`.
    #[inline(always)]
    fn due_by(&self, time: f64) -> u64 {
        let mut lanes = 0;
        for lane in 0..LANES {
            lanes |= u64::from(self.due[lane] <= time) << lane;
        }
        lanes
    }

    /// The step of one sweep to `sample`, or its end.
    #[inline(never)]
    fn step(&mut self, lane: usize, sample: usize, beam: &mut Beam<'_>, hold: &mut [Lanes<S>]) {
        if sample >= self.group.ends[lane] {
            self.blanked &= !(1 << lane);
            self.due[lane] = f64::INFINITY;
            return;
        }
        let memory = match self.memories[lane] {
            Memory::Open(_) => Memory::Open(hold[sample - 1][lane]),
            blanked @ Memory::Blanked(..) => blanked,
        };
        let mut latch = Latch {
            circuit: self.circuit,
            wire: &self.group.wire(lane),
            falling: &mut self.falling[lane],
            returning: &mut self.returning[lane],
            trace: &mut self.traces[lane],
            hold,
            memory,
        };
        latch.step(sample, beam);
        let (value, memory) = (latch.value(sample as f64), latch.memory);
        hold[sample][lane] = value;
        self.memories[lane] = memory;
        self.settle(lane);
    }

    /// What the group is to know of a sweep that has taken a step alone.
    fn settle(&mut self, lane: usize) {
        let fall = self.falling[lane].next_at();
        match &self.memories[lane] {
            Memory::Open(_) => {
                self.blanked &= !(1 << lane);
                self.due[lane] = fall;
            }
            Memory::Blanked(held, comparator) => {
                self.blanked |= 1 << lane;
                (self.taken[lane], self.since[lane]) = (held.taken, held.since);
                self.due[lane] = fall.min(self.returning[lane].next_at());
                self.watch.look(lane, &self.circuit.returning, comparator);
            }
        }
    }
}

/// One sweep in one step.
struct Latch<'a, S> {
    circuit: &'a Derivative<S>,
    wire: &'a Wire<'a, S>,
    falling: &'a mut Output,
    returning: &'a mut Output,
    trace: &'a mut Trace<S>,
    /// What the sample-and-holds had at the samples before.
    hold: &'a [Lanes<S>],
    memory: Memory<S>,
}

impl<S: Real> Latch<'_, S> {
    fn value(&self, time: f64) -> S {
        match self.memory {
            Memory::Open(tracked) => tracked,
            Memory::Blanked(held, _) => held.at(&self.circuit.hold, time),
        }
    }

    /// The step to `sample`, event by event.
    fn step(&mut self, sample: usize, beam: &mut Beam<'_>) {
        let end = sample as f64;
        let mut now = end - 1.0;
        if let Memory::Blanked(held, comparator) = self.memory {
            self.compare(sample, held, comparator);
        }
        loop {
            match self.memory {
                Memory::Open(tracked) => {
                    let at = self.next_fall(end).map(|at| at.max(now));
                    let span = [now, at.unwrap_or(end)];
                    let tracked = self.wire.track(&self.circuit.hold, sample, tracked, span);
                    self.memory = Memory::Open(tracked);
                    let Some(at) = at else { break };
                    beam.turn_off(at);
                    let deviate = self.circuit.aperture.normal(self.wire.sweep, sample as u64);
                    let at_samples = |sample: usize| self.hold[sample][self.wire.lane];
                    let taken = self.trace.taken(&self.circuit.hold, at_samples, (at, deviate), tracked);
                    self.blank(sample, taken, at);
                    now = at;
                }
                Memory::Blanked(held, _) => {
                    let Some(at) = self.next_release(end).map(|at| at.max(now)) else { break };
                    beam.turn_on(at);
                    let value = held.at(&self.circuit.hold, at);
                    *self.trace = Trace::new(at, value);
                    self.memory = Memory::Open(value);
                    now = at;
                }
            }
        }
    }

    fn blank(&mut self, sample: usize, taken: S, since: f64) {
        self.returning.reset(false);
        self.compare(sample, Held { taken, since }, ComparatorState::default());
    }

    /// Feeds the comparator with elevation less hold over the step, whenever in it the hold began: while elevation falls
    /// what it says does not count.
    #[inline(always)]
    fn compare(&mut self, sample: usize, held: Held<S>, mut comparator: ComparatorState) {
        let [start, end] = held.gap(&self.circuit.hold, self.wire, sample);
        let [start, end] = comparable(start, end);
        let part = &self.circuit.returning;
        part.step(&mut comparator, (self.wire.sweep, sample), start, end, &mut self.returning.trips);
        self.memory = Memory::Blanked(held, comparator);
    }

    /// When elevation is found to fall, if before `end`.
    #[inline(always)]
    fn next_fall(&mut self, end: f64) -> Option<f64> {
        loop {
            let at = self.falling.next_at();
            if at > end {
                return None;
            }
            self.falling.advance();
            if self.falling.is_high() {
                return Some(at);
            }
        }
    }

    /// When elevation has returned to the hold and does not fall, if before `end`.
    #[inline(always)]
    fn next_release(&mut self, end: f64) -> Option<f64> {
        loop {
            let next = if self.falling.next_at() <= self.returning.next_at() {
                &mut *self.falling
            } else {
                &mut *self.returning
            };
            let at = next.next_at();
            if at > end {
                return None;
            }
            next.advance();
            if self.returning.is_high() && !self.falling.is_high() {
                return Some(at);
            }
        }
    }
}

#[cfg(test)]
mod tests;
