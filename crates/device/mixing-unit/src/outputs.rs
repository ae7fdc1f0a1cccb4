//! Output amplifiers of the unit: the composite landscape behind lags and limits of slew.

use parts::{Driver, Jump, Jumps};
use signal::{Break, Breaks, LANES, Lanes, Real};

use crate::Mixed;

/// Where the answer to a jump is divided, in time constants behind it, or behind the end of its slewing: chords between these lie
/// within 3 % of a time constant of it.
const TAIL: [f64; 3] = [0.7, 1.6, 3.0];

/// A jump of the video up to this is drawn without division: a quarter of one of 256 shades.
const SEEN: f64 = 1.0 / 1024.0;

/// Drivers of the unit's outputs; what is `None` is not there.
#[derive(Debug, Clone, Copy)]
pub struct OutputDrivers<S> {
    /// Of the composite height.
    pub height: Option<Driver<S>>,
    /// Of the composite reflectivity. Black is the lower end of what it is given.
    pub video: Option<Driver<S>>,
}

/// Lists while they are made; used again from group to group.
#[derive(Debug, Clone, Default)]
pub struct DriverScratch<S> {
    breaks: Breaks<S>,
    bends: [Vec<bool>; LANES],
    jumps: Jumps,
}

impl<S: Real> OutputDrivers<S> {
    /// Passes a group through, at rest on the first sample. Between samples there are straight lines but for the breaks. Where
    /// the video comes out of black, and behind its jumps, it gets breaks of its own.
    pub fn run(&self, mixed: &mut Mixed<S>, scratch: &mut DriverScratch<S>) {
        if let Some(driver) = &self.video {
            scratch.divide(driver, mixed);
            scratch.drive_video(driver, mixed);
        }
        if let Some(driver) = &self.height {
            scratch.drive_height(driver, mixed);
        }
    }
}

impl<S: Real> DriverScratch<S> {
    fn drive_video(&mut self, driver: &Driver<S>, Mixed { reflectivity, breaks, .. }: &mut Mixed<S>) {
        self.take_jumps(breaks, |place| [place.before, place.after]);
        driver.pass(reflectivity, &mut self.jumps);
        for (breaks, jumps) in breaks.iter_mut().zip(&self.jumps.lists) {
            for (place, jump) in breaks.iter_mut().zip(jumps) {
                (place.before, place.after) = (S::from_f64(jump.before), S::from_f64(jump.after));
            }
        }
    }

    fn drive_height(&mut self, driver: &Driver<S>, Mixed { height, breaks, .. }: &mut Mixed<S>) {
        self.take_jumps(breaks, |place| [place.height; 2]);
        driver.pass(height, &mut self.jumps);
        for (place, jump) in breaks.iter_mut().flatten().zip(self.jumps.lists.iter().flatten()) {
            place.height = S::from_f64(jump.before);
        }
    }

    fn take_jumps(&mut self, breaks: &Breaks<S>, sides: impl Fn(&Break<S>) -> [S; 2]) {
        for (jumps, breaks) in self.jumps.lists.iter_mut().zip(breaks) {
            jumps.clear();
            jumps.extend(breaks.iter().map(|place| {
                let [before, after] = sides(place).map(S::to_f64);
                Jump { at: place.sample as f64 - 1.0 + place.share.to_f64(), before, after }
            }));
        }
    }

    /// Clips the video to black, and lists its breaks anew: with those where it comes out of black and goes into it, and with
    /// places behind jumps at which the answer is looked up.
    fn divide(&mut self, driver: &Driver<S>, mixed: &mut Mixed<S>) {
        self.breaks.iter_mut().for_each(Vec::clear);
        self.bends.iter_mut().for_each(Vec::clear);
        let Some(mut before) = mixed.reflectivity.first().copied() else { return };
        mixed.reflectivity[0] = lit(before);
        let mut passed = [0; LANES];
        let mut due = next_step(&mixed.breaks, &passed);
        for sample in 1..mixed.reflectivity.len() {
            let now = mixed.reflectivity[sample];
            if sample == due || crosses(&before, &now) {
                for lane in 0..LANES {
                    let ends = [before[lane], now[lane]];
                    let step = Step { driver, mixed, lane, sample, ends };
                    passed[lane] = step.divide(passed[lane], self);
                }
                due = next_step(&mixed.breaks, &passed);
            }
            mixed.reflectivity[sample] = lit(now);
            before = now;
        }
        std::mem::swap(&mut mixed.breaks, &mut self.breaks);
        std::mem::swap(&mut mixed.bends, &mut self.bends);
    }
}

#[inline(always)]
fn lit<S: Real>(mut value: Lanes<S>) -> Lanes<S> {
    value.0.iter_mut().for_each(|value| *value = value.at_least(S::ZERO));
    value
}

/// Whether any lane comes out of black or goes into it.
#[inline(always)]
fn crosses<S: Real>(before: &Lanes<S>, now: &Lanes<S>) -> bool {
    (0..LANES).fold(false, |any, lane| any | ((before[lane] < S::ZERO) != (now[lane] < S::ZERO)))
}

/// The first step with a break that has not been passed.
fn next_step<S>(breaks: &Breaks<S>, passed: &[usize; LANES]) -> usize {
    let ahead = breaks.iter().zip(passed).filter_map(|(breaks, &passed)| breaks.get(passed));
    ahead.map(|place| place.sample).min().unwrap_or(usize::MAX)
}

/// One step of one lane: the video, with its sign, at its ends.
struct Step<'a, S> {
    driver: &'a Driver<S>,
    mixed: &'a Mixed<S>,
    lane: usize,
    sample: usize,
    ends: [S; 2],
}

impl<S: Real> Step<'_, S> {
    /// Lists the breaks of the step from number `first` on; the number of the first beyond it.
    fn divide(&self, first: usize, out: &mut DriverScratch<S>) -> usize {
        let Self { mixed, lane, sample, ends: [start, end], .. } = *self;
        let of = |share, height, value| Break { sample, share, height, before: value, after: value };
        let mut from = of(S::ZERO, mixed.height[sample - 1][lane], start);
        let mut next = first;
        while let Some(place) = mixed.breaks[lane].get(next).filter(|place| place.sample <= sample) {
            self.straight(&from, place, out);
            let [before, after] = [place.before, place.after].map(|value| value.at_least(S::ZERO));
            self.put(Break { before, after, ..*place }, mixed.bends[lane][next], out);
            (from, next) = (*place, next + 1);
        }
        self.straight(&from, &of(S::ONE, mixed.height[sample][lane], end), out);
        next
    }

    /// A straight piece: what is left of the jump at its begin, up to where it comes out of black or goes into it.
    fn straight(&self, from: &Break<S>, to: &Break<S>, out: &mut DriverScratch<S>) {
        let (start, end) = (from.after, to.before);
        if (start < S::ZERO) == (end < S::ZERO) || start * end == S::ZERO {
            return self.tail(from, to, out);
        }
        let edge = Break { before: S::ZERO, after: S::ZERO, ..between(from, to, start / (start - end)) };
        self.tail(from, &edge, out);
        self.put(edge, false, out);
    }

    /// Places behind a jump, before `to`.
    fn tail(&self, from: &Break<S>, to: &Break<S>, out: &mut DriverScratch<S>) {
        let [before, after] = [from.before, from.after].map(|value| value.at_least(S::ZERO).to_f64());
        let size = (after - before).abs();
        let length = (to.share - from.share).to_f64();
        if size <= SEEN || length <= 0.0 {
            return;
        }
        let slewing = self.driver.slewing(size);
        let corner = (slewing > 0.0).then_some(slewing);
        let decay = TAIL.map(|part| slewing + part * self.driver.tau());
        for time in corner.into_iter().chain(decay).take_while(|&time| time < length) {
            let place = between(from, to, S::from_f64(time / length));
            let value = place.before.at_least(S::ZERO);
            self.put(Break { before: value, after: value, ..place }, false, out);
        }
    }

    fn put(&self, place: Break<S>, bend: bool, out: &mut DriverScratch<S>) {
        out.breaks[self.lane].push(place);
        out.bends[self.lane].push(bend);
    }
}

/// The place at `part` of a straight piece.
fn between<S: Real>(from: &Break<S>, to: &Break<S>, part: S) -> Break<S> {
    let line = |start: S, end: S| start + (end - start) * part;
    let value = line(from.after, to.before);
    Break {
        sample: to.sample,
        share: line(from.share, to.share),
        height: line(from.height, to.height),
        before: value,
        after: value,
    }
}
