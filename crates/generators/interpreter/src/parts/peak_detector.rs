//! Occlusion by comparison with the highest elevation so far, of real parts (sheet of the projection processor).
//!
//! While the beam is on the sample-and-hold tracks what rises, and the noise is on both inputs of the comparator. Against a held value
//! it counts.

use super::comparator::{Comparator, Trip};
use super::latch::{Occluded, Parts};
use super::sample_hold::{Held, Trace};

struct Detector<'a> {
    parts: Parts<'a>,
    elevation: &'a [f64],
    comparator: Comparator,
    trips: Vec<Trip>,
    passed: usize,
    trace: Trace,
    memory: Memory,
}

#[derive(Debug, Clone, Copy)]
enum Memory {
    /// The beam is on: the highest value so far.
    Peak(f64),
    /// The beam is off.
    Holds(Held),
}

/// Passes a profile through.
pub fn occlude(parts: Parts<'_>, elevation: &[f64]) -> Occluded {
    let Some(&first) = elevation.first() else { return Occluded::default() };
    let mut out = Occluded::at_start(first);
    let mut detector = Detector {
        comparator: Comparator::new(parts.comparator, true),
        parts,
        elevation,
        trips: Vec::new(),
        passed: 0,
        trace: Trace { at: 0.0, value: first },
        memory: Memory::Peak(first),
    };
    for sample in 1..elevation.len() {
        detector.step(sample, &mut out);
        let value = detector.value(sample as f64);
        out.hold.push(value);
        out.near.push(detector.comparator.nearest);
    }
    out
}

impl Detector<'_> {
    fn value(&self, time: f64) -> f64 {
        match self.memory {
            Memory::Peak(value) => value,
            Memory::Holds(held) => self.parts.hold.holds(held, time),
        }
    }

    fn input(&self, sample: usize, time: f64) -> f64 {
        let share = time - (sample as f64 - 1.0);
        self.elevation[sample - 1] + (self.elevation[sample] - self.elevation[sample - 1]) * share
    }

    /// The comparator first, as the memory is at the begin of the step; then its trips.
    fn step(&mut self, sample: usize, out: &mut Occluded) {
        self.compare(sample);
        let end = sample as f64;
        let mut now = end - 1.0;
        while let Some(trip) = self.trips.get(self.passed).copied().filter(|trip| trip.at <= end) {
            let at = trip.at.max(now);
            self.passed += 1;
            self.rise(sample, [now, at]);
            self.turn(sample, at, trip.high, out);
            now = at;
        }
        self.rise(sample, [now, end]);
    }

    fn compare(&mut self, sample: usize) {
        let times = [sample as f64 - 1.0, sample as f64];
        let (against, deviate) = match self.memory {
            Memory::Peak(peak) => ([peak, self.risen(peak, sample, times)], 0.0),
            Memory::Holds(held) => {
                (times.map(|time| self.parts.hold.holds(held, time)), self.parts.deviates[0](sample))
            }
        };
        let gap = [0, 1].map(|end| self.elevation[sample - 1 + end] - against[end]);
        self.comparator.step(sample, deviate, gap, &mut self.trips);
    }

    fn turn(&mut self, sample: usize, at: f64, high: bool, out: &mut Occluded) {
        match (self.memory, high) {
            (Memory::Peak(peak), false) => {
                out.turn_off(at);
                let command = [at, self.parts.deviates[1](sample)];
                let taken = self.parts.hold.takes(self.trace, &out.hold, command, peak);
                self.memory = Memory::Holds(Held { taken, since: at });
            }
            (Memory::Holds(held), true) => {
                out.turn_on(at);
                let value = self.parts.hold.holds(held, at);
                self.trace = Trace { at, value };
                self.memory = Memory::Peak(value);
            }
            _ => {}
        }
    }

    fn rise(&mut self, sample: usize, span: [f64; 2]) {
        if let Memory::Peak(peak) = self.memory {
            self.memory = Memory::Peak(self.risen(peak, sample, span));
        }
    }

    /// What is tracked over a span, held up by the diode; a lag behind a straight line is never above its ends.
    fn risen(&self, peak: f64, sample: usize, [from, to]: [f64; 2]) -> f64 {
        let ends = [from, to].map(|time| self.input(sample, time));
        let tracked = self.parts.hold.track(peak, ends, to - from);
        tracked.min(ends[0].max(ends[1]).max(peak)).max(peak)
    }
}
