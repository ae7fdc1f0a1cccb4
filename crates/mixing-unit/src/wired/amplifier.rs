//! The video amplifier: a lag over a signal with breaks.

use parts::LagStep;
use signal::{Break, Breaks, LANES, Real};

use crate::Mixed;

/// Where the decay behind a break is divided, in time constants: chords between these lie within 3 % of a time constant of it.
const TAIL: [f64; 3] = [0.7, 1.6, 3.0];

/// The lag, and what it needs for parts of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Amplifier<S> {
    whole: LagStep<S>,
    /// Time constant (steps).
    tau: f64,
}

/// Breaks behind the amplifier while they are made; used again from group to group.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lagged<S> {
    breaks: Breaks<S>,
    bends: [Vec<bool>; LANES],
}

impl<S: Real> Amplifier<S> {
    /// Of the time constant `tau` for steps of `h`, both in seconds.
    pub fn new(h: f64, tau: f64) -> Self {
        Self { whole: LagStep::new(h, tau), tau: tau / h }
    }

    /// Passes a group through, settled at the first sample. Steps are straight lines but for the breaks.
    pub fn run(
        &self,
        Mixed { height, reflectivity: video, breaks, bends }: &mut Mixed<S>,
        lagged: &mut Lagged<S>,
    ) {
        let Some(&first) = video.first() else { return };
        lagged.breaks.iter_mut().for_each(Vec::clear);
        lagged.bends.iter_mut().for_each(Vec::clear);
        let (mut passed, mut before, mut out) = ([0; LANES], first, first);
        let mut due = next_step(breaks, &passed);
        for (sample, value) in video.iter_mut().enumerate().skip(1) {
            let mut next = self.whole.step(out, before, *value);
            if sample == due {
                for lane in 0..LANES {
                    let own = passed[lane]..breaks[lane].partition_point(|place| place.sample <= sample);
                    if !own.is_empty() {
                        passed[lane] = own.end;
                        let (u, y) = (before[lane].to_f64(), out[lane].to_f64());
                        let mut walk = Walk { amplifier: self, lagged, lane, share: 0.0, u, y };
                        let end = [height[sample][lane], value[lane]];
                        next[lane] = walk.through(&breaks[lane][own.clone()], &bends[lane][own], end);
                    }
                }
                due = next_step(breaks, &passed);
            }
            (before, out) = (*value, next);
            *value = next;
        }
        std::mem::swap(breaks, &mut lagged.breaks);
        std::mem::swap(bends, &mut lagged.bends);
    }
}

/// The first step with a break that has not been passed.
fn next_step<S>(breaks: &Breaks<S>, passed: &[usize; LANES]) -> usize {
    let ahead = breaks.iter().zip(passed).filter_map(|(breaks, &passed)| breaks.get(passed));
    ahead.map(|place| place.sample).min().unwrap_or(usize::MAX)
}

/// One step of one lane.
struct Walk<'a, S> {
    amplifier: &'a Amplifier<S>,
    lagged: &'a mut Lagged<S>,
    lane: usize,
    /// How far into the step, with input and output there.
    share: f64,
    u: f64,
    y: f64,
}

impl<S: Real> Walk<'_, S> {
    /// Over the breaks to the end of the step, where height and input are `end`; the output there.
    fn through(&mut self, breaks: &[Break<S>], bends: &[bool], end: [S; 2]) -> S {
        let [height, input] = end;
        let last = Break { sample: 0, share: S::ONE, height, before: input, after: input };
        let ends = breaks.iter().skip(1).chain(std::iter::once(&last));
        for ((place, &bend), to) in breaks.iter().zip(bends).zip(ends) {
            self.advance(place.share.to_f64(), place.before.to_f64());
            self.put(place, place.height, bend);
            self.u = place.after.to_f64();
            self.decay(place, to);
        }
        self.advance(1.0, input.to_f64());
        S::from_f64(self.y)
    }

    /// Places on the way from a break to the next, or to the end of the step.
    fn decay(&mut self, from: &Break<S>, to: &Break<S>) {
        let (begin, share) = (self.share, to.share.to_f64());
        let (start, u) = (self.u, to.before.to_f64());
        for place in TAIL.map(|part| begin + part * self.amplifier.tau) {
            if place < share {
                let part = (place - begin) / (share - begin);
                self.advance(place, start + (u - start) * part);
                let height = from.height + (to.height - from.height) * S::from_f64(part);
                self.put(from, height, false);
            }
        }
    }

    /// On to `share`, the input going straight to `u`.
    fn advance(&mut self, share: f64, u: f64) {
        let lag = LagStep::part((share - self.share).max(0.0), self.amplifier.tau);
        self.y = lag.step(self.y, self.u, u);
        (self.share, self.u) = (share, u);
    }

    fn put(&mut self, at: &Break<S>, height: S, bend: bool) {
        let value = S::from_f64(self.y);
        let place = Break { share: S::from_f64(self.share), height, before: value, after: value, ..*at };
        self.lagged.breaks[self.lane].push(place);
        self.lagged.bends[self.lane].push(bend);
    }
}
