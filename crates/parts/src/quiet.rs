//! Two amplifiers side by side that neither slew nor clip: nearly all of them, nearly always.
//!
//! **Law.** That of [`Amplifier`] without its events: a lag each. Over a stretch of steps it holds if the input stays within
//! the saturation and climbs by no more a step than the slew rate allows, and if both hold as it begins. Then nothing can
//! begin: the difference d of input and output obeys `d' = u' - d / tau`, so it stays within what it was and `tau` times
//! the slew rate, and the output stays within its start and the input.
//! **Numbers.** The bounds are tighter than the amplifier's own by far more than rounding, so a stretch that keeps them has
//! the bits of the amplifier.

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use signal::{Both, Double, Lanes, Real};

use crate::{Amplifier, AmplifierState, LagStep};

/// Share of the amplifier's own bounds that is asked for.
const TIGHTER: f64 = 1.0 - 1e-4;

/// Two amplifiers, for one step length.
#[derive(Debug, Clone)]
pub struct QuietAmplifiers<S> {
    lag: LagStep<Both<S>>,
    reach: Both<S>,
    climb: Both<S>,
    saturation: Both<S>,
}

impl<S: Real> QuietAmplifiers<S> {
    /// Samples that are passed at once, at most.
    pub const MOST: usize = 16;

    /// These two.
    pub fn new([a, b]: [&Amplifier<S>; 2]) -> Self {
        let both = |a, b| Both::splat([a, b]);
        let tighter = |a: S, b: S| both(a * S::from_f64(TIGHTER), b * S::from_f64(TIGHTER));
        Self {
            lag: a.lag.beside(&b.lag, both),
            reach: tighter(a.reach, b.reach),
            climb: tighter(a.climb, b.climb),
            saturation: tighter(a.saturation, b.saturation),
        }
    }

    /// Passes at most [`Self::MOST`] samples through, from `states` at the inputs `from` on; of each amplifier `inputs` has
    /// as many. False, and only `out` is changed, if an amplifier might slew or clip, or is still coming out of an overload.
    #[inline(always)]
    pub fn pass<L: Simd>(
        &self,
        simd: L,
        states: [&mut AmplifierState<Lanes<S>>; 2],
        from: [&Lanes<S>; 2],
        inputs: [&[Lanes<S>]; 2],
        out: &mut [Both<S>],
    ) -> bool {
        let half = |lanes: &Lanes<S>| S::Vector::<L>::from_slice(simd, &lanes.0);
        let join = |low: &Lanes<S>, high: &Lanes<S>| S::Double::<L>::of(half(low), half(high));
        let load = |both: &Both<S>| S::Double::<L>::load(simd, both);
        let [mut from, mut y] = [join(from[0], from[1]), join(&states[0].y, &states[1].y)];
        let none = load(&Both::default());
        let excess = join(&states[0].excess, &states[1].excess).size();
        let gap = (from - y).size();
        let (mut level, mut climb) = (y.size().at_least(from.size()), none);
        let lag = self.lag.each(|figure| load(&figure));
        for ((low, high), out) in inputs[0].iter().zip(inputs[1]).zip(out) {
            let to = join(low, high);
            level = level.at_least(to.size());
            climb = climb.at_least((to - from).size());
            y = lag.step(y, from, to);
            y.store(out);
            from = to;
        }
        let is_loud = level.is_beyond(load(&self.saturation))
            || climb.is_beyond(load(&self.climb))
            || gap.is_beyond(load(&self.reach))
            || excess.is_beyond(none);
        if !is_loud {
            for (state, y) in states.into_iter().zip(y.halves()) {
                y.store_slice(&mut state.y.0);
            }
        }
        !is_loud
    }
}
