//! Sweeps as the occlusion circuits see them, and what they make of them.

use parts::{SampleHold, Trip};
use quantities::SweepTime;
use signal::{LANES, Lanes, Real};

/// The elevation of a group.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Group<'a, S> {
    /// Of one sample at least.
    pub elevation: &'a [Lanes<S>],
    /// Samples of the profiles.
    pub ends: [usize; LANES],
    /// Counted over all frames: the addresses of noise.
    pub sweeps: [u64; LANES],
}

impl<'a, S: Real> Group<'a, S> {
    pub fn wire(&self, lane: usize) -> Wire<'a, S> {
        Wire { elevation: self.elevation, lane, end: self.ends[lane], sweep: self.sweeps[lane] }
    }
}

/// The numbers of the bits that are set.
pub(crate) fn bits(mut word: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = (word != 0).then(|| word.trailing_zeros() as usize)?;
        word &= word - 1;
        Some(lane)
    })
}

/// The elevation of one sweep, in straight lines between its samples.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wire<'a, S> {
    pub elevation: &'a [Lanes<S>],
    pub lane: usize,
    /// Samples of the profile.
    pub end: usize,
    /// Counted over all frames: the address of noise.
    pub sweep: u64,
}

impl<S: Real> Wire<'_, S> {
    #[inline(always)]
    pub fn at(&self, sample: usize) -> S {
        self.elevation[sample][self.lane]
    }

    /// The elevation at `time` within the step to `sample`, and its change in a step.
    pub fn line(&self, sample: usize, time: f64) -> [S; 2] {
        let (before, now) = (self.at(sample - 1), self.at(sample));
        let change = now - before;
        [before + change * S::from_f64(time - (sample as f64 - 1.0)), change]
    }

    /// What a sample-and-hold has tracked at `to`, from `tracked` at `from`, both within the step to `sample`.
    #[inline(always)]
    pub fn track(&self, part: &SampleHold<S>, sample: usize, tracked: S, [from, to]: [f64; 2]) -> S {
        if to - from == 1.0 {
            return part.track(tracked, self.at(sample - 1), self.at(sample));
        }
        let [start, change] = self.line(sample, from);
        part.tracked(tracked, start, start + change, to - from)
    }
}

/// The ends of a step for a comparator about 0. A start that is 0 but for rounding is 0: the comparator counts instants
/// in steps of the sweep, and one so early in a step is the step's start.
#[inline(always)]
pub(crate) fn comparable<S: Real>(start: S, end: S) -> [S; 2] {
    let size = |value: S| if value < S::ZERO { -value } else { value };
    let is_rounding = size(start) < size(end) * S::from_f64(ROUNDING);
    [if is_rounding { S::ZERO } else { start }, end]
}

/// Part of a step below which an instant is its start.
const ROUNDING: f64 = 1e-9;

/// What the sample-and-hold has while the beam is off.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Held<S> {
    /// Tracked value that it took.
    pub taken: S,
    /// Instant at which it took the value (steps).
    pub since: f64,
}

impl<S: Real> Held<S> {
    #[inline(always)]
    pub fn at(&self, part: &SampleHold<S>, time: f64) -> S {
        part.held(self.taken, S::from_f64(time - self.since))
    }

    /// Elevation less hold at both ends of the step to `sample`.
    #[inline(always)]
    pub fn gap(&self, part: &SampleHold<S>, wire: &Wire<'_, S>, sample: usize) -> [S; 2] {
        let less_hold = |sample: usize| wire.at(sample) - self.at(part, sample as f64);
        [less_hold(sample - 1), less_hold(sample)]
    }
}

/// Since when, and from where, the sample-and-hold has tracked. What it tracked since are straight lines between the samples.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trace<S> {
    at: f64,
    value: S,
}

impl<S: Real> Trace<S> {
    /// The beam comes on.
    pub fn new(at: f64, value: S) -> Self {
        Self { at, value }
    }

    /// What a `command` with its deviate takes, `tracked` then and `sample` at the samples before: the value of an aperture
    /// delay before. What was there before the beam came on is forgotten.
    pub fn taken(
        &self,
        part: &SampleHold<S>,
        sample: impl Fn(usize) -> S,
        (command, deviate): (f64, f64),
        tracked: S,
    ) -> S {
        let at = part.taken_at(SweepTime(command), deviate).0;
        if at >= command {
            return tracked;
        }
        if at < self.at {
            return self.value;
        }
        let (before, behind) = (at.floor(), at.floor() + 1.0);
        let [from, value] = if before > self.at {
            [before, sample(before as usize).to_f64()]
        } else {
            [self.at, self.value.to_f64()]
        };
        let [to, end] = if behind < command {
            [behind, sample(behind as usize).to_f64()]
        } else {
            [command, tracked.to_f64()]
        };
        S::from_f64(value + (end - value) * ((at - from) / (to - from)))
    }
}

/// Trips of a comparator that have not come yet, and its output by those that have.
#[derive(Debug, Clone, Default)]
pub(crate) struct Output {
    pub trips: Vec<Trip>,
    next: usize,
    high: bool,
}

impl Output {
    pub fn reset(&mut self, high: bool) {
        self.trips.clear();
        (self.next, self.high) = (0, high);
    }

    /// When the next trip comes.
    #[inline(always)]
    pub fn next_at(&self) -> f64 {
        self.trips.get(self.next).map_or(f64::INFINITY, |trip| trip.at.0)
    }

    pub fn advance(&mut self) {
        self.high = self.trips[self.next].high;
        self.next += 1;
    }

    #[inline(always)]
    pub fn is_high(&self) -> bool {
        self.high
    }
}

/// Where the beam of a sweep is on, as it comes about.
#[derive(Debug)]
pub(crate) struct Beam<'a> {
    pub on: &'a mut Vec<[f64; 2]>,
    since: Option<f64>,
}

impl<'a> Beam<'a> {
    /// On from the first sample.
    pub fn begin(on: &'a mut Vec<[f64; 2]>) -> Self {
        on.clear();
        Self { on, since: Some(0.0) }
    }

    pub fn turn_on(&mut self, at: f64) {
        self.since = Some(at);
    }

    pub fn turn_off(&mut self, at: f64) {
        if let Some(since) = self.since.take().filter(|&since| since < at) {
            self.on.push([since, at]);
        }
    }
}
