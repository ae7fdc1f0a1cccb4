//! Driver: the output amplifier of a wire, over whole sweeps side by side.
//!
//! ```text
//! u ─▶ lag tau, rate within ±SR ─▶ y
//! ```
//!
//! **Law** (section 6). `y' = clip((u - y) / tau, ±SR)`, see `slew`. The input is a straight line between samples, and between
//! samples and the places at which it jumps or bends ([`Jump`]); each piece is the exact solution.
//! **Parameters.** Time constant (s), slew rate (units of the signal a second).
//! **State and timing.** One value, at rest on the first sample: nothing moves in retrace.
//! **Between samples** the output is continuous, and its answer to a jump may be much shorter than a step. Whoever draws
//! straight lines from place to place gets, behind each place, the value from which the line to the next place or sample
//! covers the area of the answer, as far as the input goes: so a fast driver leaves nearly the whole jump, a slow one
//! hardly any, and a bend is no jump.
//! **Elaboration.** A driver whose rate has no bound is its lag, without a test. With a bound one test for several samples of
//! eight sweeps says whether any is slewing; such steps are walked piece by piece, in f64. A lane has the bits that it has
//! alone.

use std::array;

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use signal::{LANES, Lanes, Real};

use crate::Jump;
use crate::broken::step_of;
use crate::lag::{LagStep, LagSteps};
use crate::slew::Slew;

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Driver<S> {
    lag: LagStep<S>,
    /// Largest difference of input and output, and largest change of the input in a step, that it follows freely.
    bounds: Option<[S; 2]>,
    /// Lag and slew rate in units of steps.
    slew: Slew,
}

/// Steps that are looked at together for one that slews.
const BLOCK: usize = 16;

/// Jumps of a group of sweeps, and what drivers need beside them; used again from signal to signal.
#[derive(Debug, Clone, Default)]
pub struct Jumps {
    /// Lane by lane, ascending.
    pub lists: [Vec<Jump>; LANES],
    /// The lag of the part of a step before each jump, and of the rest of its step.
    lags: [Vec<[LagStep<f64>; 2]>; LANES],
}

/// Input and output of a group at one sample.
#[derive(Debug, Clone, Copy)]
struct State<S> {
    u: Lanes<S>,
    y: Lanes<S>,
}

impl<S: Real> Driver<S> {
    /// For steps of `h` seconds: time constant `tau` (s), 0 for none; slew rate `rate` (1/s), infinite for none.
    pub fn new(h: f64, tau: f64, rate: f64) -> Self {
        let slew = Slew { tau: tau / h, rate: rate * h };
        let bounds = [slew.reach(), slew.rate].map(S::from_f64);
        Self { lag: LagStep::new(h, tau), bounds: (rate < f64::INFINITY).then_some(bounds), slew }
    }

    /// Returns the time constant (steps).
    pub fn tau(&self) -> f64 {
        self.slew.tau
    }

    /// How long (steps) it slews behind a jump of `size`.
    pub fn slewing(&self, size: f64) -> f64 {
        ((size - self.slew.reach()) / self.slew.rate).max(0.0)
    }

    /// Passes several groups that do not jump through their drivers; one without a driver stays as it is. A step of a lag waits
    /// for the one before, but not for those of other lags: three together take little longer than one.
    pub fn pass_together<const N: usize>(drivers: [Option<&Self>; N], signals: [&mut [Lanes<S>]; N]) {
        if let Some(Some(first)) = drivers.first()
            && drivers.iter().all(Option::is_some)
        {
            let drivers = drivers.map(|driver| driver.unwrap_or(first));
            return dispatch!(Level::new(), simd => Self::pass_together_wide(simd, drivers, signals));
        }
        for (driver, signal) in drivers.into_iter().zip(signals) {
            driver.into_iter().for_each(|driver| driver.pass(signal, &mut Jumps::default()));
        }
    }

    #[inline(always)]
    fn pass_together_wide<L: Simd, const N: usize>(
        simd: L,
        drivers: [&Self; N],
        mut signals: [&mut [Lanes<S>]; N],
    ) {
        let samples = signals.iter().map(|signal| signal.len()).min().unwrap_or(0);
        if samples > 0 {
            let mut states = signals.each_ref().map(|signal| State { u: signal[0], y: signal[0] });
            let rest = signals.each_mut().map(|signal| &mut signal[1..samples]);
            Self::follow(simd, drivers, rest, &mut states);
        }
    }

    /// Passes a group through. Its jumps become those of the output.
    pub fn pass(&self, signal: &mut [Lanes<S>], jumps: &mut Jumps) {
        dispatch!(Level::new(), simd => self.pass_wide(simd, signal, jumps));
    }

    #[inline(always)]
    fn pass_wide<L: Simd>(&self, simd: L, signal: &mut [Lanes<S>], jumps: &mut Jumps) {
        let Some(&first) = signal.first() else { return };
        jumps.prepare(self.slew.tau);
        let Jumps { lists: jumps, lags } = jumps;
        let mut state = State { u: first, y: first };
        let (mut passed, mut sample) = ([0; LANES], 1);
        let ahead = |jumps: &[Jump], passed: usize| jumps.get(passed).map_or(f64::INFINITY, |jump| jump.at);
        let mut next: [f64; LANES] = array::from_fn(|lane| ahead(&jumps[lane], 0));
        while sample < signal.len() {
            let soonest = next.iter().fold(signal.len() as f64, |soonest, &at| soonest.min(at));
            let due = step_of(soonest.max(sample as f64));
            Self::follow(simd, [self], [&mut signal[sample..due]], array::from_mut(&mut state));
            if let Some(now) = signal.get_mut(due) {
                let (before, inputs) = (state, *now);
                match self.bounds {
                    None => self.lag(now, &mut state),
                    Some(bounds) => self.slew_step(now, &mut state, bounds),
                }
                let end = due as f64;
                for lane in 0..LANES {
                    if next[lane] > end {
                        continue;
                    }
                    let own = &mut jumps[lane][passed[lane]..];
                    let count = own.iter().take_while(|jump| jump.at <= end).count();
                    let (own, lags) = (&mut own[..count], &lags[lane][passed[lane]..]);
                    let last = own[count - 1];
                    if last.at == end {
                        // At the sample itself: the input goes on from behind it.
                        state.u[lane] = S::from_f64(last.after);
                    }
                    let begin = (end - 1.0, before.u[lane].to_f64(), before.y[lane].to_f64());
                    now[lane] = S::from_f64(self.through(own, lags, begin, inputs[lane].to_f64()));
                    passed[lane] += count;
                    next[lane] = ahead(&jumps[lane], passed[lane]);
                }
                state.y = *now;
            }
            sample = due + 1;
        }
    }

    /// Steps without jumps, of signals of one length.
    #[inline(always)]
    fn follow<L: Simd, const N: usize>(
        simd: L,
        drivers: [&Self; N],
        mut signals: [&mut [Lanes<S>]; N],
        states: &mut [State<S>; N],
    ) {
        let (samples, mut inputs) = (signals[0].len(), [[Lanes::default(); BLOCK]; N]);
        for first in (0..samples).step_by(BLOCK) {
            let block = first..samples.min(first + BLOCK);
            let blocks = signals.each_mut().map(|signal| &mut signal[block.clone()]);
            Self::follow_block(simd, drivers, blocks, &mut inputs, states);
        }
    }

    /// Up to [`BLOCK`] steps as the lag, and again one by one if any lane slews in any of them.
    #[inline(always)]
    fn follow_block<L: Simd, const N: usize>(
        simd: L,
        drivers: [&Self; N],
        mut blocks: [&mut [Lanes<S>]; N],
        inputs: &mut [[Lanes<S>; BLOCK]; N],
        states: &mut [State<S>; N],
    ) {
        let (begin, count) = (*states, blocks[0].len());
        let ranges = Self::lag_block(simd, drivers, &mut blocks, inputs, states);
        for n in 0..N {
            let Some(bounds) = drivers[n].bounds else { continue };
            let [behind, change] = &ranges[n];
            if behind.leaves(bounds[0]) || change.leaves(bounds[1]) {
                blocks[n].copy_from_slice(&inputs[n][..count]);
                states[n] = begin[n];
                blocks[n].iter_mut().for_each(|value| drivers[n].slew_step(value, &mut states[n], bounds));
            }
        }
    }

    /// Steps as the lag, in the computer's vectors; what came in is kept in `inputs`. How far each output was behind its input,
    /// and how much the input changed.
    #[inline(always)]
    fn lag_block<L: Simd, const N: usize>(
        simd: L,
        drivers: [&Self; N],
        blocks: &mut [&mut [Lanes<S>]; N],
        inputs: &mut [[Lanes<S>; BLOCK]; N],
        states: &mut [State<S>; N],
    ) -> [[Range<S>; 2]; N] {
        let zero = S::Vector::<L>::simd_from(simd, S::ZERO);
        let (mut weights, mut lasts, mut ranges) = ([[zero; 3]; N], [[zero; 2]; N], [[zero; 4]; N]);
        for n in 0..N {
            let LagStep { keep, from, to } = drivers[n].lag;
            weights[n] = [keep, from, to].map(|weight| S::Vector::<L>::simd_from(simd, weight));
            let State { u, y } = &states[n];
            lasts[n] = [u, y].map(|lanes| S::Vector::<L>::from_slice(simd, &lanes.0));
        }
        for sample in 0..blocks[0].len() {
            for n in 0..N {
                let ([keep, from, to], [u, y]) = (weights[n], lasts[n]);
                let value = &mut blocks[n][sample];
                let now = S::Vector::<L>::from_slice(simd, &value.0);
                now.store_slice(&mut inputs[n][sample].0);
                let (late, step, [a, b, c, d]) = (u - y, now - u, ranges[n]);
                ranges[n] = [a.min(late), b.max(late), c.min(step), d.max(step)];
                // What the input adds does not wait for the output before it.
                lasts[n] = [now, y * keep + (u * from + now * to)];
                lasts[n][1].store_slice(&mut value.0);
            }
        }
        let mut found = [[Range::NONE; 2]; N];
        for n in 0..N {
            lasts[n][0].store_slice(&mut states[n].u.0);
            lasts[n][1].store_slice(&mut states[n].y.0);
            for (k, range) in found[n].iter_mut().enumerate() {
                ranges[n][2 * k].store_slice(&mut range.least.0);
                ranges[n][2 * k + 1].store_slice(&mut range.most.0);
            }
        }
        found
    }

    /// One step as the lag.
    #[inline(always)]
    fn lag(&self, value: &mut Lanes<S>, state: &mut State<S>) {
        let LagStep { keep, from, to } = self.lag;
        let mut next = *value;
        for lane in 0..LANES {
            // What the input adds does not wait for the output before it.
            next.0[lane] = state.y.0[lane] * keep + (state.u.0[lane] * from + value.0[lane] * to);
        }
        *state = State { u: *value, y: next };
        *value = next;
    }

    /// One step; lanes that are beyond the bounds are walked.
    #[inline(never)]
    fn slew_step(&self, value: &mut Lanes<S>, state: &mut State<S>, bounds: [S; 2]) {
        let (State { u, y }, now) = (*state, *value);
        self.lag(value, state);
        let size = |value: S| (-value).at_least(value);
        let is_beyond =
            |lane: usize| size(u[lane] - y[lane]) > bounds[0] || size(now[lane] - u[lane]) > bounds[1];
        for lane in (0..LANES).filter(|&lane| is_beyond(lane)) {
            let input = [u[lane], now[lane]].map(S::to_f64);
            value[lane] = S::from_f64(self.slew.advance(1.0, y[lane].to_f64(), input, |_| {}));
        }
        state.y = *value;
    }

    /// One step of one lane over its jumps, which become the output's; time, input and output where it begins, the input
    /// where it ends. The output there.
    fn through(
        &self,
        jumps: &mut [Jump],
        lags: &[[LagStep<f64>; 2]],
        (mut at, mut u, mut y): (f64, f64, f64),
        last: f64,
    ) -> f64 {
        let end = at + 1.0;
        for k in 0..jumps.len() {
            let jump = jumps[k];
            let length = (jump.at - at).max(0.0);
            let next = self.over(y, [u, jump.before], length, &lags[k][0]);
            if let Some(passed) = k.checked_sub(1) {
                jumps[passed].after = next.straight_from([y, u], length);
            }
            (at, u, y) = (jump.at, jump.after, next.y);
            jumps[k].before = y;
        }
        let Some((jump, lag)) = jumps.iter_mut().zip(lags).last() else { return y };
        let length = (end - at).max(0.0);
        let next = self.over(y, [u, last], length, &lag[1]);
        jump.after = next.straight_from([y, u], length);
        next.y
    }

    /// From output `y` over `length` steps, the input going straight from `u0` to `u1`; `lag` is that of the length.
    #[inline(always)]
    fn over(&self, y: f64, [u0, u1]: [f64; 2], length: f64, lag: &LagStep<f64>) -> Answer {
        let free = (u0 - y).abs() <= self.slew.reach() && (u1 - u0).abs() <= self.slew.rate * length;
        if free || length == 0.0 {
            let next = lag.step(y, u0, u1);
            return Answer { y: next, area: 0.5 * (u0 + u1) * length - self.slew.tau * (next - y) };
        }
        self.slewed(y, [u0, u1], length)
    }

    #[inline(never)]
    fn slewed(&self, y: f64, input: [f64; 2], length: f64) -> Answer {
        let mut area = 0.0;
        let next = self.slew.advance(length, y, input, |piece| area += piece.area());
        Answer { y: next, area }
    }
}

impl Jumps {
    /// Makes the jumps of a group from one list a lane.
    pub fn of(lists: [Vec<Jump>; LANES]) -> Self {
        Self { lists, ..Self::default() }
    }

    /// Lags of time constant `tau` (steps) for the parts of steps around each jump, several side by side.
    #[inline(always)]
    fn prepare(&mut self, tau: f64) {
        for (jumps, lags) in self.lists.iter().zip(&mut self.lags) {
            lags.clear();
            for some in (0..jumps.len()).step_by(LANES) {
                // Places beyond the last jump repeat it.
                let place = |k: usize| (some + k).min(jumps.len() - 1);
                let [mut before, mut rest] = [[0.0; LANES]; 2];
                for k in 0..LANES {
                    let at = jumps[place(k)].at;
                    let end = step_of(at).max(1) as f64;
                    let passed = place(k).checked_sub(1).map_or(0.0, |passed| jumps[passed].at);
                    (before[k], rest[k]) = ((at - passed.max(end - 1.0)).max(0.0), (end - at).max(0.0));
                }
                // No `map` of both: its closure would be called, without the vectors of its caller.
                let before = LagSteps::new(before, [tau; LANES]);
                let rest = LagSteps::new(rest, [tau; LANES]);
                let lag = |of: &LagSteps<LANES>, k: usize| LagStep {
                    keep: of.keep[k],
                    from: of.from[k],
                    to: of.to[k],
                };
                lags.extend((0..LANES.min(jumps.len() - some)).map(|k| [lag(&before, k), lag(&rest, k)]));
            }
        }
    }
}

/// What came of a piece.
struct Answer {
    /// Output at its end.
    y: f64,
    /// Integral of the output over it (steps).
    area: f64,
}

impl Answer {
    /// Where the straight line begins that ends as the output does and covers its area: between output and input at the
    /// begin, `y` and `u`; `y` if it takes no time.
    fn straight_from(&self, [y, u]: [f64; 2], length: f64) -> f64 {
        if length > 0.0 { (2.0 * self.area / length - self.y).max(y.min(u)).min(y.max(u)) } else { y }
    }
}

/// Least and greatest differences of two signals of a group.
#[derive(Debug, Clone, Copy)]
struct Range<S> {
    least: Lanes<S>,
    most: Lanes<S>,
}

impl<S: Real> Range<S> {
    const NONE: Self = Self { least: Lanes([S::ZERO; LANES]), most: Lanes([S::ZERO; LANES]) };

    #[inline(always)]
    fn leaves(&self, bound: S) -> bool {
        (0..LANES).fold(false, |any, lane| any | (self.least.0[lane] < -bound) | (self.most.0[lane] > bound))
    }
}
