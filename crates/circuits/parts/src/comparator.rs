//! Comparator with hysteresis, offset and a delay that depends on overdrive.
//!
//! **Law** (sections 3.6 and 6). Low goes high where the input passes `offset + V_h / 2`, high goes low where it passes
//! `offset - V_h / 2`. The output follows `t_c` after the decision, and a decision needs charge: the area of the
//! overdrive since the passing reaches `k_od`. A steady overdrive V so takes `t_c + k_od / V`, as section 6 has it, and
//! a ramp of slope s takes `t_c + sqrt(2 k_od / s)`. It takes no longer than the longest delay, and an input that goes
//! back before the decision leaves no trace.
//! **Parameters.** [`ComparatorLaw`].
//! **State and timing.** [`ComparatorState`]. The input is a straight line between samples; passings, decisions and
//! trips are instants in closed form, and a trip may come several steps after its passing.
//! **Noise.** Both thresholds move together by `sigma n`, n the deviate of the step's last sample: an input of slope s
//! trips with the jitter `sigma / s`. Steps further from a threshold than noise can reach draw nothing.
//! **Our choices.** Overdrive as an area, because the formula leaves open when a moving input's is taken. A threshold
//! that has been passed stays where it was until the decision.

use quantities::SweepTime;
use signal::Real;

use crate::NoiseSource;
use crate::delay::in_steps;

/// What a comparator is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComparatorLaw {
    /// Threshold between the two (share of full scale).
    pub offset: f64,
    /// Distance V_h of the two thresholds (share of full scale), 0 or more.
    pub hysteresis: f64,
    /// Delay t_c at large overdrive (s).
    pub delay: f64,
    /// k_od (full scales times seconds).
    pub overdrive: f64,
    /// Longest delay in all (s); 500 ns in section 3.6.
    pub longest: f64,
    /// Noise of the thresholds (share of full scale).
    pub noise: f64,
}

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparator<S> {
    /// Inputs that cannot make a low output go high, and a high one low.
    quiet_low: S,
    quiet_high: S,
    /// Thresholds of a high and of a low output.
    thresholds: [f64; 2],
    noise: f64,
    source: NoiseSource,
    /// Steps from a decision to the trip.
    delay: f64,
    /// k_od (full scales times steps).
    charge: f64,
    /// Steps from a passing to a decision at the latest.
    patience: f64,
}

/// What a comparator remembers.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ComparatorState {
    /// Its decision; the output follows.
    pub high: bool,
    /// A threshold that has been passed and not yet led to a decision.
    pub passing: Option<Passing>,
}

/// An input beyond its threshold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passing {
    /// When it was passed.
    pub since: SweepTime,
    /// Threshold that the input has passed (full scales).
    pub threshold: f64,
    /// Area of the overdrive so far (full scales times steps).
    pub charge: f64,
}

/// Where a sweep takes what a comparator sees past its threshold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GateEdge {
    /// Ground range of the passing (m).
    pub range: f64,
    /// How steeply (full scales a metre), above 0; infinite for a jump.
    pub slope: f64,
}

/// A change of the output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trip {
    /// When: a trip at 3.25 lies a quarter into the step from sample 3 to sample 4.
    pub at: SweepTime,
    /// The output from then on.
    pub high: bool,
}

/// The input over a step, seen from the output: beyond the threshold is positive.
struct Line {
    /// Value at the start of the step.
    start: f64,
    /// Change over the step, from start to end.
    change: f64,
}

/// What comes of a passing within a step; instants are shares of it.
enum Outcome {
    Decided(f64),
    Withdrawn(f64),
    Open(f64),
}

impl<S: Real> Comparator<S> {
    /// For steps of `h` seconds; `source` moves its thresholds.
    pub fn new(h: f64, law: &ComparatorLaw, source: NoiseSource) -> Self {
        let thresholds = [law.offset - law.hysteresis / 2.0, law.offset + law.hysteresis / 2.0];
        let margin = law.noise * NoiseSource::LARGEST;
        Self {
            quiet_low: S::from_f64(thresholds[1] - margin),
            quiet_high: S::from_f64(thresholds[0] + margin),
            thresholds,
            noise: law.noise,
            source,
            delay: in_steps(law.delay, h),
            charge: law.overdrive / h,
            patience: in_steps((law.longest - law.delay).max(0.0), h),
        }
    }

    /// Advances over the step from sample `sample - 1` to `sample` of `sweep`; appends the trips it leads to.
    #[inline]
    pub fn step(
        &self,
        state: &mut ComparatorState,
        (sweep, sample): (u64, usize),
        u0: S,
        u1: S,
        trips: &mut Vec<Trip>,
    ) {
        let quiet = if state.high {
            (u0 > self.quiet_high) & (u1 > self.quiet_high)
        } else {
            (u0 < self.quiet_low) & (u1 < self.quiet_low)
        };
        if !quiet || state.passing.is_some() {
            let deviate = if self.noise > 0.0 { self.source.normal(sweep, sample as u64) } else { 0.0 };
            self.walk(state, sample, deviate, [u0, u1], trips);
        }
    }

    /// Thresholds of a high and of a low output.
    pub(crate) fn thresholds(&self) -> [f64; 2] {
        self.thresholds
    }

    /// Deviation of the thresholds, and where their deviates come from.
    pub(crate) fn noise(&self) -> (f64, &NoiseSource) {
        (self.noise, &self.source)
    }

    /// How far noise can move the thresholds in the steps to samples 0, 1, 2 ... of `sweep`, at most (shares of full
    /// scale).
    pub fn reaches(&self, sweep: u64, reaches: &mut [f64]) {
        reaches.fill(0.0);
        if self.noise > 0.0 {
            self.source.fill_most(sweep, reaches);
            reaches.iter_mut().for_each(|most| *most *= self.noise);
        }
    }

    /// Whether [`Comparator::step`] does nothing in a step in which noise moves thresholds by `reach` at most.
    #[inline(always)]
    pub fn is_quiet(&self, state: &ComparatorState, u0: S, u1: S, reach: f64) -> bool {
        state.passing.is_none() && self.is_beyond(state.high, [u0.to_f64(), u1.to_f64()], reach)
    }

    /// Whether an input keeps a high output high or a low one low, with the thresholds nearer by `reach`.
    #[inline(always)]
    fn is_beyond(&self, high: bool, [u0, u1]: [f64; 2], reach: f64) -> bool {
        let [lower, upper] = self.thresholds;
        if high {
            (u0 > lower + reach) & (u1 > lower + reach)
        } else {
            (u0 < upper - reach) & (u1 < upper - reach)
        }
    }

    /// Steps from the instant at which a ramp passes a threshold to the trip, `t_c + sqrt(2 k_od / s)`; `slope` s in full
    /// scales a step, above 0, and infinite for a jump.
    pub fn on_ramp(&self, slope: f64) -> f64 {
        self.delay + Line { start: 0.0, change: slope }.fills(0.0, self.charge).min(self.patience)
    }

    /// [`Comparator::step`] with the `deviate` of its noise at that sample.
    #[cold]
    pub fn walk(
        &self,
        state: &mut ComparatorState,
        sample: usize,
        deviate: f64,
        input: [S; 2],
        trips: &mut Vec<Trip>,
    ) {
        let (base, input) = (sample as f64 - 1.0, input.map(S::to_f64));
        let shift = self.noise * deviate;
        // A trip that rounds to the start of the step must not be found again.
        let (mut now, mut fresh) = (0.0, true);
        loop {
            let open = state.passing.or_else(|| {
                let threshold = self.thresholds[usize::from(!state.high)] + shift;
                let at = Line::new(input, threshold, state.high).passes(now, fresh)?;
                Some(Passing { since: SweepTime(base + at), threshold, charge: 0.0 })
            });
            let Some(passing) = open else { break };
            now = (passing.since.0 - base).max(now);
            fresh = false;
            match self.outcome(&Line::new(input, passing.threshold, state.high), &passing, now, base) {
                Outcome::Decided(at) => {
                    *state = ComparatorState { high: !state.high, passing: None };
                    trips.push(Trip { at: SweepTime(base + at + self.delay), high: state.high });
                    now = at;
                }
                Outcome::Withdrawn(at) => {
                    state.passing = None;
                    now = at;
                }
                Outcome::Open(charge) => {
                    state.passing = Some(Passing { charge, ..passing });
                    break;
                }
            }
        }
    }

    /// What comes of `passing` from share `now` of the step on.
    fn outcome(&self, line: &Line, passing: &Passing, now: f64, base: f64) -> Outcome {
        let over = line.at(now).max(0.0);
        let waited = base + now - passing.since.0;
        let decision = line.fills(over, self.charge - passing.charge).min(self.patience - waited).max(0.0);
        let withdrawal = if line.change < 0.0 { over / -line.change } else { f64::INFINITY };
        let left = 1.0 - now;
        if decision <= left && decision <= withdrawal {
            Outcome::Decided(now + decision)
        } else if withdrawal <= left {
            Outcome::Withdrawn(now + withdrawal)
        } else {
            Outcome::Open(passing.charge + left * (over + line.change * left / 2.0))
        }
    }
}

impl Line {
    fn new([u0, u1]: [f64; 2], threshold: f64, high: bool) -> Self {
        let sign = if high { -1.0 } else { 1.0 };
        Self { start: sign * (u0 - threshold), change: sign * (u1 - u0) }
    }

    fn at(&self, t: f64) -> f64 {
        self.start + self.change * t
    }

    /// The first instant from `now` on at which it goes beyond the threshold. Beyond it already counts at the start of
    /// a step (`fresh`) alone: within a step, right after a trip at this very value, it is rounding.
    fn passes(&self, now: f64, fresh: bool) -> Option<f64> {
        if self.change > 0.0 {
            let at = (-self.start / self.change).max(now);
            return (at <= 1.0).then_some(at);
        }
        (fresh && self.start > 0.0).then_some(now)
    }

    /// How long overdrive that begins at `over` takes to an area of `charge`: the root of
    /// `over t + change t^2 / 2 = charge` in the form without cancellation; for ever if it turns back before.
    fn fills(&self, over: f64, charge: f64) -> f64 {
        let root = over * over + 2.0 * self.change * charge;
        if charge <= 0.0 {
            0.0
        } else if root < 0.0 {
            f64::INFINITY
        } else {
            2.0 * charge / (over + root.sqrt())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Comparator, ComparatorLaw, ComparatorState};
    use crate::NoiseSource;

    #[test]
    fn what_is_out_of_reach_is_not_reached() {
        let law = ComparatorLaw {
            offset: 0.0,
            hysteresis: 2e-3,
            delay: 40e-9,
            overdrive: 0.0,
            longest: 500e-9,
            noise: 1e-3,
        };
        let source = NoiseSource::new(5, "comparator", 0);
        let part = Comparator::<f64>::new(50e-9, &law, source);
        let (mut passed_over, mut reaches) = (0, [0.0; 4000]);
        part.reaches(3, &mut reaches);
        for sample in 0..4000_usize {
            let shift = law.noise * source.normal(3, sample as u64);
            // A deviation to six from the thresholds of a low and of a high output.
            let off = 1e-3 * (1.0 + sample as f64 / 800.0);
            let is_quiet = |high, input: [f64; 2]| {
                let state = ComparatorState { high, passing: None };
                part.is_quiet(&state, input[0], input[1], reaches[sample])
            };
            if is_quiet(false, [-1.0, 1e-3 - off]) {
                assert!(1e-3 - off < 1e-3 + shift, "{sample}");
                passed_over += 1;
            }
            if is_quiet(true, [off - 1e-3, 1.0]) {
                assert!(off - 1e-3 > -1e-3 + shift, "{sample}");
                passed_over += 1;
            }
        }
        assert!((5000..8000).contains(&passed_over), "{passed_over}");
    }
}
