//! Occlusion by derivative, of real parts: a latch that falls set and the return to the hold resets (sheet of the projection processor).

use super::comparator::{Comparator, ComparatorFigures, Trip};
use super::sample_hold::{Held, SampleHold, Trace};

/// What occlusion makes of a profile.
#[derive(Debug, Clone, Default)]
pub struct Occluded {
    /// What the sample-and-hold has at the samples.
    pub hold: Vec<f64>,
    /// Where the beam is on: from, to (steps).
    pub on: Vec<[f64; 2]>,
    /// Instants at which it was turned on or off (steps).
    pub turns: Vec<f64>,
    /// By sample, how near a comparator has come to another decision so far (shares of full scale).
    pub near: Vec<f64>,
}

impl Occluded {
    /// Nothing has been hidden of a profile that begins at `first`.
    pub fn at_start(first: f64) -> Self {
        Self {
            hold: vec![first],
            on: vec![[0.0, f64::INFINITY]],
            turns: Vec::new(),
            near: vec![f64::INFINITY],
        }
    }

    /// The beam comes on.
    pub fn turn_on(&mut self, at: f64) {
        self.on.push([at, f64::INFINITY]);
        self.turns.push(at);
    }

    /// The beam goes off.
    pub fn turn_off(&mut self, at: f64) {
        if let Some(last) = self.on.last_mut() {
            last[1] = last[1].min(at);
        }
        self.on.retain(|[begin, end]| begin < end);
        self.turns.push(at);
    }
}

/// Parts of the circuit.
#[derive(Clone, Copy)]
pub struct Parts<'a> {
    /// Sample-and-hold of the latch.
    pub hold: &'a SampleHold,
    /// The comparator of elevation against hold.
    pub comparator: ComparatorFigures,
    /// Deviates of that comparator and of the aperture at a sample.
    pub deviates: [&'a dyn Fn(usize) -> f64; 2],
}

/// The circuit along a sweep.
struct Latch<'a> {
    parts: Parts<'a>,
    elevation: &'a [f64],
    falls: Queue,
    returns: Queue,
    trace: Trace,
    memory: Memory,
}

#[derive(Debug, Clone, Copy)]
enum Memory {
    /// The beam is on: what is tracked.
    Tracks(f64),
    /// The beam is off: what is held, and the comparator that turns it on again.
    Holds(Held, Comparator),
}

/// Trips that have not come yet, and the output by those that have.
#[derive(Debug, Clone, Default)]
struct Queue {
    trips: Vec<Trip>,
    next: usize,
    high: bool,
}

impl Queue {
    fn next_at(&self) -> f64 {
        self.trips.get(self.next).map_or(f64::INFINITY, |trip| trip.at)
    }

    fn take(&mut self) {
        if let Some(trip) = self.trips.get(self.next) {
            self.high = trip.high;
            self.next += 1;
        }
    }
}

/// Passes a profile through, whose falls are known.
pub fn occlude(parts: Parts<'_>, elevation: &[f64], (falls, near): (Vec<Trip>, &[f64])) -> Occluded {
    let Some(&first) = elevation.first() else { return Occluded::default() };
    let mut out = Occluded::at_start(first);
    let mut latch = Latch {
        parts,
        elevation,
        falls: Queue { trips: falls, ..Queue::default() },
        returns: Queue::default(),
        trace: Trace { at: 0.0, value: first },
        memory: Memory::Tracks(first),
    };
    let mut nearest = near[0];
    out.near[0] = nearest;
    for sample in 1..elevation.len() {
        let own = latch.step(sample, &mut out);
        let value = latch.value(sample as f64);
        nearest = nearest.min(own).min(near[sample]);
        out.hold.push(value);
        out.near.push(nearest);
    }
    out
}

impl Latch<'_> {
    fn value(&self, time: f64) -> f64 {
        match self.memory {
            Memory::Tracks(value) => value,
            Memory::Holds(held, _) => self.parts.hold.holds(held, time),
        }
    }

    /// The elevation within the step to `sample`.
    fn input(&self, sample: usize, time: f64) -> f64 {
        let share = time - (sample as f64 - 1.0);
        self.elevation[sample - 1] + (self.elevation[sample] - self.elevation[sample - 1]) * share
    }

    /// The step to `sample`, event by event; how near its comparator has come to another decision.
    fn step(&mut self, sample: usize, out: &mut Occluded) -> f64 {
        let end = sample as f64;
        let mut now = end - 1.0;
        let mut nearest = f64::INFINITY;
        if let Memory::Holds(held, comparator) = self.memory {
            nearest = self.compare(sample, held, comparator);
        }
        loop {
            match self.memory {
                Memory::Tracks(value) => {
                    let fall = self.next_fall(end).map(|at| at.max(now));
                    let until = fall.unwrap_or(end);
                    let ends = [now, until].map(|time| self.input(sample, time));
                    let tracked = self.parts.hold.track(value, ends, until - now);
                    self.memory = Memory::Tracks(tracked);
                    let Some(at) = fall else { return nearest };
                    out.turn_off(at);
                    let command = [at, self.parts.deviates[1](sample)];
                    let taken = self.parts.hold.takes(self.trace, &out.hold, command, tracked);
                    self.returns = Queue::default();
                    let comparator = Comparator::new(self.parts.comparator, false);
                    nearest = nearest.min(self.compare(sample, Held { taken, since: at }, comparator));
                    now = at;
                }
                Memory::Holds(held, _) => {
                    let Some(at) = self.next_return(end).map(|at| at.max(now)) else { return nearest };
                    out.turn_on(at);
                    let value = self.parts.hold.holds(held, at);
                    self.trace = Trace { at, value };
                    self.memory = Memory::Tracks(value);
                    now = at;
                }
            }
        }
    }

    /// Elevation less hold over the whole step, to the comparator; how near it has come to another decision.
    fn compare(&mut self, sample: usize, held: Held, mut comparator: Comparator) -> f64 {
        let gap = [sample - 1, sample]
            .map(|sample| self.elevation[sample] - self.parts.hold.holds(held, sample as f64));
        comparator.step(sample, self.parts.deviates[0](sample), gap, &mut self.returns.trips);
        self.memory = Memory::Holds(held, comparator);
        comparator.nearest
    }

    fn next_fall(&mut self, end: f64) -> Option<f64> {
        while self.falls.next_at() <= end {
            let at = self.falls.next_at();
            self.falls.take();
            if self.falls.high {
                return Some(at);
            }
        }
        None
    }

    /// When elevation is back at the hold and does not fall.
    fn next_return(&mut self, end: f64) -> Option<f64> {
        loop {
            let next = if self.falls.next_at() <= self.returns.next_at() {
                &mut self.falls
            } else {
                &mut self.returns
            };
            let at = next.next_at();
            if at > end {
                return None;
            }
            next.take();
            if self.returns.high && !self.falls.high {
                return Some(at);
            }
        }
    }
}
