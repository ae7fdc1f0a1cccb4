//! Operational amplifier: bandwidth, slew rate, saturation, recovery.
//!
//! ```text
//! u ─▶ lag tau, rate within ±SR ─▶ y ─▶ clip to ±saturation, late out of overload ─▶ out
//! ```
//!
//! **Law** (section 6). `y' = clip((u - y) / tau, ±SR)`, see `slew`; output `clip(y + x)`, x the store of the
//! overload, see `overload`. Input a straight line over the step.
//! **Parameters.** [`AmplifierLaw`]. A summer of n unity inputs has `tau = (n + 1) / (2 pi GBW)`
//! ([`summing_time_constant`]); one of many inputs is a tree of such parts.
//! **State and timing.** [`AmplifierState`]. A step V settles to an error e in `V/SR - tau + tau ln(SR tau / e)`.
//! **Elaboration.** Nearly all steps neither slew nor clip: then the part is its lag. The test is safe: the difference d
//! of input and output stays between its value at the start and `s tau`, and y within its start and the ends of the
//! input. Only lanes that fail it are walked piece by piece, in f64; a walk that meets no event is the lag again.

use std::f64::consts::PI;

use fearless_simd::Simd;
use fearless_simd::prelude::{Select, SimdBase, SimdFrom, SimdMask};
use signal::{LANES, Lanes, Real};

use crate::lag::LagStep;
use crate::overload::Overload;
use crate::slew::Slew;

/// What an amplifier is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AmplifierLaw {
    /// Closed-loop time constant (s).
    pub tau: f64,
    /// Slew rate (full scales a second); may be infinite.
    pub slew: f64,
    /// Saturation (full scales); may be infinite.
    pub saturation: f64,
    /// Time constant of the recovery from overload (s).
    pub recovery: f64,
}

/// A shorter time (s) is none: rates by it would leave the numbers.
const SHORTEST: f64 = 1e-200;

/// The part, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Amplifier<S> {
    pub(crate) lag: LagStep<S>,
    /// Share of the overload that is left after a step.
    remains: S,
    /// The bounds within which a step neither slews nor clips: of what input and output differ by, of what the input
    /// climbs, of both.
    pub(crate) reach: S,
    pub(crate) climb: S,
    pub(crate) saturation: S,
    h: f64,
    slew: Slew,
    overload: Overload,
}

/// A group in a vector.
type Signal<S, L> = <S as Real>::Vector<L>;

/// State of an amplifier; all 0 is a quiet one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct AmplifierState<V> {
    /// Output before the clip.
    pub y: V,
    /// Overload that is stored, and delays the recovery.
    pub excess: V,
}

impl<S: Real> Amplifier<S> {
    /// For steps of `h` seconds.
    pub fn new(h: f64, law: &AmplifierLaw) -> Self {
        let [tau, recovery] = [law.tau, law.recovery].map(|time| if time < SHORTEST { 0.0 } else { time });
        let slew = Slew { tau, rate: law.slew };
        let climb = if law.slew == f64::INFINITY { f64::INFINITY } else { law.slew * h };
        Self {
            lag: LagStep::new(h, tau),
            remains: LagStep::new(h, recovery).keep,
            reach: S::from_f64(slew.reach()),
            climb: S::from_f64(climb),
            saturation: S::from_f64(law.saturation),
            h,
            slew,
            overload: Overload { saturation: law.saturation, recovery },
        }
    }

    /// Advances over a step with the input `u0`, `u1` at its start and end; returns the output at its end.
    #[inline]
    pub fn step(&self, state: &mut AmplifierState<S>, u0: S, u1: S) -> S {
        if self.is_linear(state.y, u0, u1) {
            state.y = self.lag.step(state.y, u0, u1);
            state.excess *= self.remains;
        } else {
            *state = self.walk(state, u0, u1);
        }
        self.clip(state.y + state.excess)
    }

    /// Passes samples of a group through, from the state at the first of `input` on: `out` takes one less. Each lane
    /// has the bits that [`Amplifier::step`] gives it alone.
    #[inline(always)]
    pub fn pass<L: Simd>(
        &self,
        simd: L,
        state: &mut AmplifierState<Lanes<S>>,
        input: &[Lanes<S>],
        out: &mut [Lanes<S>],
    ) {
        let before = *state;
        if !self.pass_linear(simd, state, input, out) {
            *state = before;
            self.pass_one_by_one(state, input, out);
        }
    }

    /// The same as a lag, with all of it looked at once: false if a step may slew or clip.
    #[inline(always)]
    fn pass_linear<L: Simd>(
        &self,
        simd: L,
        state: &mut AmplifierState<Lanes<S>>,
        input: &[Lanes<S>],
        out: &mut [Lanes<S>],
    ) -> bool {
        let [saturation, least] =
            [self.saturation, -self.saturation].map(|level| Signal::<S, L>::simd_from(simd, level));
        let zero = Signal::<S, L>::simd_from(simd, S::ZERO);
        let mut y = Signal::<S, L>::from_slice(simd, &state.y.0);
        let mut excess = Signal::<S, L>::from_slice(simd, &state.excess.0);
        let mut from = Signal::<S, L>::from_slice(simd, &input[0].0);
        let (mut level, mut gap, mut climb) = (from.abs(), zero, zero);
        for (to, out) in input[1..].iter().zip(out) {
            let to = Signal::<S, L>::from_slice(simd, &to.0);
            level = level.max(y.abs()).max(to.abs());
            gap = gap.max((from - y).abs());
            climb = climb.max((to - from).abs());
            y = self.lag.step(y, from, to);
            excess *= self.remains;
            let sum = y + excess;
            let sum = sum.simd_gt(saturation).select(saturation, sum);
            sum.simd_lt(least).select(least, sum).store_slice(&mut out.0);
            from = to;
        }
        y.store_slice(&mut state.y.0);
        excess.store_slice(&mut state.excess.0);
        let beyond = level.simd_gt(saturation) | gap.simd_gt(self.reach) | climb.simd_gt(self.climb);
        !beyond.any_true()
    }

    #[cold]
    fn pass_one_by_one(
        &self,
        state: &mut AmplifierState<Lanes<S>>,
        input: &[Lanes<S>],
        out: &mut [Lanes<S>],
    ) {
        for (ends, out) in input.windows(2).zip(out) {
            for lane in 0..LANES {
                let mut alone = AmplifierState { y: state.y[lane], excess: state.excess[lane] };
                out[lane] = self.step(&mut alone, ends[0][lane], ends[1][lane]);
                (state.y[lane], state.excess[lane]) = (alone.y, alone.excess);
            }
        }
    }

    /// Whether the step neither slews nor clips.
    #[inline(always)]
    fn is_linear(&self, y: S, u0: S, u1: S) -> bool {
        self.beyond(y, u0, u1) <= S::ZERO
    }

    /// How far the step is beyond the bounds within which it neither slews nor clips: below or at 0 within them all.
    #[inline(always)]
    fn beyond(&self, y: S, u0: S, u1: S) -> S {
        let over = |value: S, bound: S| (-value).at_least(value) - bound;
        over(u0 - y, self.reach)
            .at_least(over(u1 - u0, self.climb))
            .at_least(over(y, self.saturation))
            .at_least(over(u0, self.saturation))
            .at_least(over(u1, self.saturation))
    }

    #[cold]
    fn walk(&self, state: &AmplifierState<S>, u0: S, u1: S) -> AmplifierState<S> {
        let mut excess = state.excess.to_f64();
        let input = [u0.to_f64(), u1.to_f64()];
        let y = self.slew.advance(self.h, state.y.to_f64(), input, |piece| {
            excess = self.overload.advance(excess, piece);
        });
        AmplifierState { y: S::from_f64(y), excess: S::from_f64(excess) }
    }

    #[inline(always)]
    fn clip(&self, y: S) -> S {
        let y = if y > self.saturation { self.saturation } else { y };
        if y < -self.saturation { -self.saturation } else { y }
    }
}

/// Time constant (s) of a summer of `inputs` unity inputs and gain-bandwidth `gbw` (Hz): its noise gain is one more
/// than its inputs (section 3.2).
pub fn summing_time_constant(inputs: u32, gbw: f64) -> f64 {
    (f64::from(inputs) + 1.0) / (2.0 * PI * gbw)
}
