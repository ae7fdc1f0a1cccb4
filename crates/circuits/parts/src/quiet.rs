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
    /// Joins two amplifiers side by side.
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

    /// Passes samples through, from `states` at the inputs `from` on; `out` has at least as many as the `inputs` of each. False,
    /// and only `out` is changed, if an amplifier might slew or clip, or is still coming out of an overload.
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

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};
    use quantities::unit_interval;
    use signal::{Both, LANES, Lanes, Real};

    use super::QuietAmplifiers;
    use crate::{Amplifier, AmplifierLaw, AmplifierState};

    const H: f64 = 50e-9;

    /// Two amplifiers, their state, and a stretch of inputs that climb by up to `climb` of what the slew rate allows.
    struct Stretch<S> {
        amplifiers: [Amplifier<S>; 2],
        states: [AmplifierState<Lanes<S>>; 2],
        inputs: [[Lanes<S>; 17]; 2],
    }

    /// Outputs, and the states behind them.
    type Passed<S> = ([[Lanes<S>; 16]; 2], [AmplifierState<Lanes<S>>; 2]);

    impl<S: Real> Stretch<S> {
        fn drawn(number: u64, climb: f64) -> Self {
            let draw = |what: &[u64]| unit_interval(number, what);
            let law = |k: u64| AmplifierLaw {
                tau: H * libm::exp2(4.0 * draw(&[1, k]) - 2.0),
                slew: 2e5 * (1.0 + draw(&[2, k])),
                saturation: 0.9 + draw(&[3, k]),
                recovery: 1e-6,
            };
            let laws = [law(0), law(1)];
            let mut inputs = [[Lanes::default(); 17]; 2];
            for (k, row) in inputs.iter_mut().enumerate() {
                for lane in 0..LANES {
                    let mut input = 1.6 * draw(&[4, k as u64, lane as u64]) - 0.8;
                    for (n, sample) in row.iter_mut().enumerate() {
                        sample[lane] = S::from_f64(input);
                        let way = 2.0 * draw(&[5, k as u64, lane as u64, n as u64]) - 1.0;
                        input += way * climb * laws[k].slew * H;
                    }
                }
            }
            let states = inputs.map(|row| AmplifierState { y: row[0], excess: Lanes::default() });
            Self { amplifiers: laws.map(|law| Amplifier::new(H, &law)), states, inputs }
        }

        /// Each amplifier by itself.
        fn alone(&self) -> Passed<S> {
            let (mut out, mut states) = ([[Lanes::default(); 16]; 2], self.states);
            for k in 0..2 {
                let (input, out) = (&self.inputs[k], &mut out[k]);
                dispatch!(Level::new(), simd => self.amplifiers[k].pass(simd, &mut states[k], input, out));
            }
            (out, states)
        }

        /// The same side by side, if they are quiet.
        fn quietly(&self) -> Option<Passed<S>> {
            let (mut out, mut states) = ([Both::default(); 16], self.states);
            let [a, b] = &self.amplifiers;
            let from = [&self.inputs[0][0], &self.inputs[1][0]];
            let inputs = [&self.inputs[0][1..], &self.inputs[1][1..]];
            let is_quiet = dispatch!(Level::new(), simd => {
                QuietAmplifiers::new([a, b]).pass(simd, states.each_mut(), from, inputs, &mut out)
            });
            if !is_quiet {
                assert_eq!(states, self.states, "nothing is changed");
            }
            is_quiet.then(|| ([0, 1].map(|k| out.map(|both| both.wire(k))), states))
        }
    }

    fn are_as_alone<S: Real>() {
        let mut quiet = 0;
        for number in 0..400 {
            let stretch = Stretch::<S>::drawn(number, if number % 2 == 0 { 0.2 } else { 1.003 });
            if let Some(found) = stretch.quietly() {
                assert_eq!(found, stretch.alone(), "{number}");
                quiet += 1;
            }
        }
        assert!((220..390).contains(&quiet), "{quiet}");
    }

    #[test]
    fn quiet_amplifiers_have_the_bits_that_they_have_alone() {
        are_as_alone::<f32>();
        are_as_alone::<f64>();
    }

    /// One lane of one of the two that begins away from its input, comes out of an overload, climbs too fast or too high.
    #[test]
    fn whatever_may_slew_or_clip_is_not_quiet() {
        let quiet =
            (0..).map(|number| Stretch::<f64>::drawn(number, 0.2)).find(|one| one.quietly().is_some());
        let quiet = || {
            let Stretch { amplifiers, states, inputs } = quiet.as_ref().unwrap();
            Stretch { amplifiers: *amplifiers, states: *states, inputs: *inputs }
        };
        let loud: [fn(&mut Stretch<f64>); 4] = [
            |one| one.states[1].y[3] += 1.0,
            |one| one.states[0].excess[7] = 1e-9,
            |one| one.inputs[1][9][0] += 0.05,
            |one| one.inputs[0].iter_mut().for_each(|sample| sample[5] += 3.0),
        ];
        for (number, change) in loud.into_iter().enumerate() {
            let mut one = quiet();
            change(&mut one);
            assert!(one.quietly().is_none(), "{number}");
        }
    }
}
