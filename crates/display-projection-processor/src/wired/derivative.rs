//! Occlusion by derivative, as reported (section 15.2), of real parts.
//!
//! **Latch.** Set while the comparator behind the differentiator says that elevation falls; then reset by the comparator
//! of elevation against hold. Set wins: a blank that comes a little early at a crest stays, and does not free the
//! ground behind it. The comparator against the hold begins low with every hold.

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use parts::{Comparator, ComparatorState, Differentiator, NoiseSource, SampleHold, SecondOrderState};
use signal::{Lanes, Real};

use crate::wired::chain::Scratch;
use crate::wired::figures::{DERIVATIVE, Figures};
use crate::wired::lane::{Beam, Held, Output, Trace, Wire, comparable};

/// The circuit, for one step length.
#[derive(Debug, Clone)]
pub(crate) struct Derivative<S> {
    differentiator: Differentiator<S>,
    /// Steps by which the nominal differentiator is late; everything else is delayed by as much.
    late: f64,
    falling: Comparator<S>,
    returning: Comparator<S>,
    hold: SampleHold<S>,
    aperture: NoiseSource,
}

impl<S: Real> Derivative<S> {
    pub fn new(h: f64, figures: &Figures<'_>) -> Self {
        let [lag, nominal] = figures.derivative_lags("dpp.derivative.bandwidth");
        let (falling, returning) = ("dpp.derivative.comparator", "dpp.hold.comparator");
        let against_hold = figures.comparator(returning, figures.noise());
        Self {
            differentiator: Differentiator::new(h, DERIVATIVE, lag),
            late: lateness(h, nominal),
            falling: Comparator::new(h, &figures.falling(falling), figures.source(falling)),
            returning: Comparator::new(h, &against_hold, figures.source(returning)),
            hold: SampleHold::new(h, &figures.sample_hold("dpp.hold")),
            aperture: figures.source("dpp.hold.aperture"),
        }
    }

    /// Runs a sweep of a group that has been differentiated; `hold` takes what the sample-and-hold has at each sample.
    pub fn run(
        &self,
        wire: &Wire<'_, S>,
        scratch: &mut Scratch<S>,
        mut beam: Beam<'_>,
        mut hold: impl FnMut(S),
    ) {
        let Some(last) = wire.end.checked_sub(1) else { return };
        let Scratch { outputs: [falling, returning], trace, reaches, rates, .. } = scratch;
        reaches.resize(wire.end, 0.0);
        self.falling.reaches(wire.sweep, reaches);
        self.list_falls(wire, (rates, reaches), falling);
        self.returning.reaches(wire.sweep, reaches);
        trace.begin(0.0, wire.at(0));
        let memory = Memory::Open(wire.at(0));
        let mut latch = Latch { circuit: self, wire, falling, returning, reaches, trace, memory };
        hold(wire.at(0));
        for sample in 1..=last {
            latch.step(sample, &mut beam);
            hold(latch.value(sample as f64));
        }
        beam.turn_off(last as f64);
    }

    /// What comes out of the differentiator (units of the wire a second), earlier by what everything else is delayed.
    pub fn rates(&self, wire: &Wire<'_, S>) -> Vec<f64> {
        let Some(last) = wire.end.checked_sub(1) else { return Vec::new() };
        let mut rates = Vec::new();
        self.differentiate(wire.elevation, &mut rates);
        let out: Vec<f64> = rates.iter().map(|rate| rate[wire.lane].to_f64() / DERIVATIVE).collect();
        let late = |sample: usize| {
            let at = (sample as f64 + self.late).min(last as f64);
            let (before, share) = (at as usize, at.fract());
            out[before] + share * (out[last.min(before + 1)] - out[before])
        };
        (0..=last).map(late).collect()
    }

    /// What the differentiator has at the samples of a group.
    pub fn differentiate(&self, elevation: &[Lanes<S>], rates: &mut Vec<Lanes<S>>) {
        rates.resize(elevation.len(), Lanes::default());
        dispatch!(Level::new(), simd => self.differentiate_wide(simd, elevation, rates));
    }

    #[inline(always)]
    fn differentiate_wide<L: Simd>(&self, simd: L, elevation: &[Lanes<S>], rates: &mut [Lanes<S>]) {
        let Some(first) = elevation.first() else { return };
        let mut before = S::Vector::<L>::from_slice(simd, &first.0);
        let mut poles = SecondOrderState { y: before, rate: S::Vector::<L>::simd_from(simd, S::ZERO) };
        rates[0] = Lanes::default();
        for (now, rate) in elevation.iter().zip(rates).skip(1) {
            let now = S::Vector::<L>::from_slice(simd, &now.0);
            self.differentiator.step(&mut poles, before, now).store_slice(&mut rate.0);
            before = now;
        }
    }

    /// Trips of the comparator behind the differentiator do not depend on the hold: all of a sweep come first.
    fn list_falls(&self, wire: &Wire<'_, S>, (rates, reaches): (&[Lanes<S>], &[f64]), falling: &mut Output) {
        falling.reset(false);
        let (mut comparator, mut before) = (ComparatorState::default(), S::ZERO);
        for sample in 1..wire.end {
            let rate = rates[sample][wire.lane];
            let [start, end] = comparable(-before, -rate);
            if !self.falling.is_quiet(&comparator, start, end, reaches[sample]) {
                self.falling.step(&mut comparator, (wire.sweep, sample), start, end, &mut falling.trips);
            }
            before = rate;
        }
        falling.trips.iter_mut().for_each(|trip| trip.at.0 -= self.late);
    }
}

/// Steps by which the differentiator's output at the samples is behind the slope of a parabola, of which it sees the
/// chords: `1/2 + q / (1 - q) + r q / (1 - q)^2`, `r = h / tau_f`, `q = e^-r`, which is `2 tau_f / h` for long lags.
pub(crate) fn lateness(h: f64, lag: f64) -> f64 {
    if lag == 0.0 {
        return 0.5;
    }
    let ratio = h / lag;
    let left = -libm::expm1(-ratio);
    let kept = libm::exp(-ratio) / left;
    0.5 + kept + ratio * kept / left
}

/// The sample-and-hold of one sweep.
#[derive(Debug, Clone, Copy)]
enum Memory<S> {
    /// Beam on: the tracked value.
    Open(S),
    /// Beam off.
    Blanked(Held<S>, ComparatorState),
}

struct Latch<'a, S> {
    circuit: &'a Derivative<S>,
    wire: &'a Wire<'a, S>,
    falling: &'a mut Output,
    returning: &'a mut Output,
    /// How far noise can move the thresholds of the comparator against the hold, sample by sample.
    reaches: &'a [f64],
    trace: &'a mut Trace,
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
                    self.trace.go_on(span[1], tracked);
                    let Some(at) = at else { break };
                    beam.turn_off(at);
                    let deviate = self.circuit.aperture.normal(self.wire.sweep, sample as u64);
                    let taken = self.trace.taken(&self.circuit.hold, at, deviate, tracked);
                    self.blank(sample, taken, at);
                    now = at;
                }
                Memory::Blanked(held, _) => {
                    let Some(at) = self.next_release(end).map(|at| at.max(now)) else { break };
                    beam.turn_on(at);
                    let value = held.at(&self.circuit.hold, at);
                    self.trace.begin(at, value);
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
        if !part.is_quiet(&comparator, start, end, self.reaches[sample]) {
            let address = (self.wire.sweep, sample);
            part.step(&mut comparator, address, start, end, &mut self.returning.trips);
        }
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
