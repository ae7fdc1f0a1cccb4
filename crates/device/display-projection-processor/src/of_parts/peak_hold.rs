//! Occlusion by comparison with the highest elevation so far, of real parts.
//!
//! **Circuit.** While the beam is on, the sample-and-hold tracks what rises (a diode stands before it). One comparator
//! of elevation against hold turns the beam off and on. While it tracks, noise is on both of its inputs and does not
//! count; against the held value it does.

use parts::{Comparator, ComparatorState, NoiseSource, SampleHold};
use signal::{Lanes, Real};

use crate::of_parts::chain::Scratch;
use crate::of_parts::figures::Figures;
use crate::of_parts::lane::{Beam, Held, Output, Trace, Wire, comparable};

/// The circuit, for one step length.
#[derive(Debug, Clone)]
pub(crate) struct PeakHold<S> {
    tracking: Comparator<S>,
    holding: Comparator<S>,
    hold: SampleHold<S>,
    aperture: NoiseSource,
}

impl<S: Real> PeakHold<S> {
    pub fn new(h: f64, figures: &Figures<'_>) -> Self {
        let part = "dpp.hold.comparator";
        let comparator =
            |noise: f64| Comparator::new(h, &figures.comparator(part, noise), figures.source(part));
        Self {
            tracking: comparator(0.0),
            holding: comparator(figures.noise()),
            hold: SampleHold::new(h, &figures.sample_hold("dpp.hold")),
            aperture: figures.source("dpp.hold.aperture"),
        }
    }

    /// Runs a sweep; its lane of `hold` takes what the sample-and-hold has at each sample.
    pub fn run(
        &self,
        wire: &Wire<'_, S>,
        scratch: &mut Scratch<S>,
        beam: &mut Beam<'_>,
        hold: &mut [Lanes<S>],
    ) {
        let Some(last) = wire.end.checked_sub(1) else { return };
        let Scratch { outputs: [[output, ..], _], reaches, .. } = scratch;
        reaches.resize(wire.end, 0.0);
        self.holding.reaches(wire.sweep, reaches);
        output.reset(true);
        let comparator = ComparatorState { high: true, passing: None };
        let (trace, memory) = (Trace::new(0.0, wire.at(0)), Memory::Open(wire.at(0)));
        let mut detector = Detector { circuit: self, wire, output, reaches, trace, comparator, memory };
        hold[0][wire.lane] = wire.at(0);
        for sample in 1..=last {
            detector.step(sample, beam, hold);
            hold[sample][wire.lane] = detector.value(sample as f64);
        }
    }
}

#[derive(Debug, Clone, Copy)]
enum Memory<S> {
    /// Beam on: the highest tracked value.
    Open(S),
    /// Beam off: the held value.
    Blanked(Held<S>),
}

struct Detector<'a, S> {
    circuit: &'a PeakHold<S>,
    wire: &'a Wire<'a, S>,
    output: &'a mut Output,
    /// How far noise can move the thresholds against the held value, sample by sample.
    reaches: &'a [f64],
    trace: Trace<S>,
    comparator: ComparatorState,
    memory: Memory<S>,
}

impl<S: Real> Detector<'_, S> {
    fn value(&self, time: f64) -> S {
        match self.memory {
            Memory::Open(peak) => peak,
            Memory::Blanked(held) => held.at(&self.circuit.hold, time),
        }
    }

    /// The step to `sample`: the comparator first, then its trips. A trip within the step changes what it compares from
    /// the next step on.
    fn step(&mut self, sample: usize, beam: &mut Beam<'_>, hold: &[Lanes<S>]) {
        self.compare(sample);
        let end = sample as f64;
        let mut now = end - 1.0;
        while self.output.next_at() <= end {
            let at = self.output.next_at().max(now);
            self.output.advance();
            self.rise(sample, [now, at]);
            self.turn((sample, at), beam, hold);
            now = at;
        }
        self.rise(sample, [now, end]);
    }

    fn compare(&mut self, sample: usize) {
        let Self { circuit, wire, .. } = *self;
        let (part, gap) = match self.memory {
            Memory::Open(peak) => {
                let risen = self.risen(peak, sample, [sample as f64 - 1.0, sample as f64]);
                (&circuit.tracking, [wire.at(sample - 1) - peak, wire.at(sample) - risen])
            }
            Memory::Blanked(held) => (&circuit.holding, held.gap(&circuit.hold, wire, sample)),
        };
        let [start, end] = comparable(gap[0], gap[1]);
        if !part.is_quiet(&self.comparator, start, end, self.reaches[sample]) {
            part.step(&mut self.comparator, (wire.sweep, sample), start, end, &mut self.output.trips);
        }
    }

    fn turn(&mut self, (sample, at): (usize, f64), beam: &mut Beam<'_>, hold: &[Lanes<S>]) {
        match self.memory {
            Memory::Open(peak) if !self.output.is_high() => {
                beam.turn_off(at);
                let deviate = self.circuit.aperture.normal(self.wire.sweep, sample as u64);
                let at_samples = |sample: usize| hold[sample][self.wire.lane];
                let taken = self.trace.taken(&self.circuit.hold, at_samples, (at, deviate), peak);
                self.memory = Memory::Blanked(Held { taken, since: at });
            }
            Memory::Blanked(held) if self.output.is_high() => {
                beam.turn_on(at);
                let value = held.at(&self.circuit.hold, at);
                self.trace = Trace::new(at, value);
                self.memory = Memory::Open(value);
            }
            _ => {}
        }
    }

    fn rise(&mut self, sample: usize, span: [f64; 2]) {
        if let Memory::Open(peak) = self.memory {
            let risen = self.risen(peak, sample, span);
            self.memory = Memory::Open(risen);
        }
    }

    /// A straight input takes the hold no higher than its own ends: a peak above the sample by rounding would be a fall.
    fn risen(&self, peak: S, sample: usize, span: [f64; 2]) -> S {
        let risen = self.wire.track(&self.circuit.hold, sample, peak, span).at_least(peak);
        if span[1] < sample as f64 {
            return risen;
        }
        let most = self.wire.line(sample, span[0])[0].at_least(self.wire.at(sample)).at_least(peak);
        -(-risen).at_least(-most)
    }
}
