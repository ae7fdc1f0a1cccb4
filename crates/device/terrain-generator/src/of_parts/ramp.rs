//! One folded ramp as a voltage: accumulator, D/A converter, smoother (hardware section 3.1).

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use hardware_model::{SMOOTHER_DAMPING, SweepParts};
use parts::{
    Converter, ConverterLanes, ConverterLaw, SecondOrder, SecondOrderState, SecondOrderStep,
    settling_time_constant,
};
use signal::{Lanes, Real};

/// Settling is told to this error.
const SETTLED: f64 = 1e-3;

/// The parts of a ramp; both ramps are alike.
#[derive(Debug, Clone)]
pub struct RampParts<S> {
    converter: Option<Converter<S>>,
    smoother: Option<SecondOrderStep<S>>,
    delay: f64,
    slowest: [f64; 2],
}

/// One ramp of a group.
#[derive(Debug, Clone)]
pub struct RampState<S> {
    converter: ConverterLanes<S>,
    input: Lanes<S>,
    smooth: SecondOrderState<Lanes<S>>,
}

impl<S: Real> Default for RampState<S> {
    fn default() -> Self {
        let zero = Lanes::default();
        Self {
            converter: ConverterLanes::default(),
            input: zero,
            smooth: SecondOrderState { y: zero, rate: zero },
        }
    }
}

impl<S: Real> RampState<S> {
    /// The ramp, at rest.
    pub fn output(&self) -> Lanes<S> {
        self.smooth.y
    }
}

impl<S: Real> RampParts<S> {
    /// For steps of `h` seconds; `full_scale` in volts.
    pub fn new(h: f64, full_scale: f64, parts: &SweepParts) -> Self {
        let settle = settling_time_constant(parts.settle, SETTLED);
        let law = |bits| ConverterLaw {
            bits,
            nonlinearity: parts.nonlinearity,
            glitch_area: parts.glitch / full_scale,
            delay: 0.0,
            tau: settle,
        };
        let smoother = SecondOrder { natural: 1.0 / parts.smoother, damping: SMOOTHER_DAMPING };
        let has_smoother = parts.smoother > 0.0;
        // A staircase is late by half a step.
        let stairs = parts.dac_bits.map_or(0.0, |_| settle + if has_smoother { 0.5 * h } else { 0.0 });
        let smooth = |law: &SecondOrder| match parts.dac_bits {
            // The word changes as the step begins, and the converter settles within it.
            Some(_) => law.settling(h, settle),
            None => law.step(h),
        };
        Self {
            converter: parts.dac_bits.map(|bits| Converter::new(h, &law(bits))),
            smoother: has_smoother.then(|| smooth(&smoother)),
            delay: stairs + if has_smoother { smoother.group_delay() } else { 0.0 },
            // The envelope of two poles falls by their damping.
            slowest: [settle, parts.smoother / SMOOTHER_DAMPING],
        }
    }

    /// From the accumulator to the ramp (s).
    pub fn delay(&self) -> f64 {
        self.delay
    }

    /// Time constants of its parts, one after the other (s).
    pub fn slowest(&self) -> [f64; 2] {
        self.slowest
    }

    /// Whether the ramp is a staircase, which changes as a step begins.
    pub fn has_steps(&self) -> bool {
        self.converter.is_some()
    }

    /// A ramp that stands at `value`.
    pub fn at_rest(&self, value: Lanes<S>) -> RampState<S> {
        let (converter, input) = match &self.converter {
            Some(part) => {
                let state = part.lanes_at_rest(value);
                (state, state.y)
            }
            None => (ConverterLanes::default(), value),
        };
        RampState { converter, input, smooth: SecondOrderState { y: input, rate: Lanes::default() } }
    }

    /// Steps later, one for each of `values`, which become the ramp's; the accumulator changes to each as a step begins (to the
    /// converter's word), or moves to it in a straight line where there is no converter.
    #[inline(always)]
    pub fn pass<L: Simd>(&self, simd: L, state: &mut RampState<S>, values: &mut [Lanes<S>]) {
        let Some(smoother) = &self.smoother else {
            if let Some(part) = &self.converter {
                values.iter_mut().for_each(|value| *value = part.step_lanes(&mut state.converter, *value));
            }
            return;
        };
        let load = |lanes: &Lanes<S>| S::Vector::<L>::from_slice(simd, &lanes.0);
        let mut before = load(&state.input);
        let mut smooth = SecondOrderState { y: load(&state.smooth.y), rate: load(&state.smooth.rate) };
        for value in values {
            let [begin, end] = match &self.converter {
                Some(part) => part.settling_lanes(&mut state.converter, *value).each_ref().map(load),
                None => [before, load(value)],
            };
            smooth = smoother.step(smooth, begin, end);
            smooth.y.store_slice(&mut value.0);
            before = end;
        }
        before.store_slice(&mut state.input.0);
        smooth.y.store_slice(&mut state.smooth.y.0);
        smooth.rate.store_slice(&mut state.smooth.rate.0);
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::RampParts;
    use hardware_model::{AnalogParts, SweepParts};
    use signal::Lanes;

    const H: f64 = 1e-9;

    /// A ramp of one unit in 1 µs that folds at 1, from -10 µs on.
    fn triangle(time: f64) -> f64 {
        if time < 0.0 { 1.0 + time / 1e-6 } else { 1.0 - time / 1e-6 }
    }

    fn run(parts: &SweepParts) -> Vec<f64> {
        let ramp = RampParts::<f64>::new(H, 10.0, parts);
        let steps = f64::from(u8::from(ramp.has_steps()));
        let mut state = ramp.at_rest(Lanes::splat(triangle(-0.9e-6)));
        let value = |k: i32| triangle(-0.9e-6 + (f64::from(k) - steps) * H);
        let mut values: Vec<_> = (1..1700).map(|k| Lanes::splat(value(k))).collect();
        dispatch!(Level::new(), simd => ramp.pass(simd, &mut state, &mut values));
        values.iter().map(|value| value[3]).collect()
    }

    /// Artefact 8: behind a lag the peak is short by 0.693 of what the ramp makes in its time constant.
    #[test]
    fn a_settling_converter_falls_short_at_the_fold() {
        let settle = 345e-9;
        let tau = settle / libm::log(1e3);
        let parts = SweepParts { dac_bits: Some(24), settle, ..AnalogParts::ideal().sweep };
        let peak = run(&parts).into_iter().fold(0.0, f64::max);
        let short = 1.0 - peak;
        let expected = std::f64::consts::LN_2 * tau / 1e-6;
        assert!((short - expected).abs() < 0.02 * expected, "{short} against {expected}");
    }

    #[test]
    fn a_smoother_is_late_by_its_delay() {
        let parts = SweepParts { smoother: 20e-9, ..AnalogParts::ideal().sweep };
        let ramp = RampParts::<f64>::new(H, 10.0, &parts);
        assert!((ramp.delay() - 32e-9).abs() < 1e-18);
        // Half a microsecond before the fold, transients are over.
        let found = run(&parts)[399];
        assert!((found - triangle(-0.5e-6 - 32e-9)).abs() < 1e-7, "{found}");
    }

    /// Converter, settling lag, pulse of the carry and smoother are what their equations make of them. Euler's method with two thousand short
    /// steps in place of each is the judge.
    #[test]
    fn a_smoother_follows_its_converter_within_the_step() {
        let (h, glitch) = (50e-9, 20e-9);
        for (settle, smoother) in [(150e-9, 40e-9), (0.0, 40e-9), (100e-9, 6e-9), (100e-9, 75e-9)] {
            let parts =
                SweepParts { dac_bits: Some(6), settle, smoother, glitch, ..AnalogParts::ideal().sweep };
            let ramp = RampParts::<f64>::new(h, 10.0, &parts);
            let place = |k: i32| 0.2 + 0.007 * f64::from(k);
            let mut values: Vec<_> = (0..80).map(|k| Lanes::splat(place(k))).collect();
            let mut state = ramp.at_rest(Lanes::splat(place(0)));
            dispatch!(Level::new(), simd => ramp.pass(simd, &mut state, &mut values));
            let (tau, steps, w) = (settle / libm::log(1e3), 2000, 1.0 / smoother);
            let word = |k: i32| (place(k) * 64.0 + 0.5).floor();
            let (mut converted, mut y, mut rate) = (word(0) / 64.0, word(0) / 64.0, 0.0);
            let dt = h / f64::from(steps);
            for k in 0..80 {
                let changed = (word(k.max(1) - 1) as u32 ^ word(k) as u32).checked_ilog2();
                let weight = changed.map_or(0.0, |bit| libm::exp2(f64::from(bit) - 5.0));
                converted += if tau > 0.0 { weight * glitch / 10.0 / tau } else { 0.0 };
                for _ in 0..steps {
                    converted = if tau > 0.0 {
                        converted + (word(k) / 64.0 - converted) * dt / tau
                    } else {
                        word(k) / 64.0
                    };
                    let pull = w * w * (converted - y) - 2.0 * 0.8 * w * rate;
                    (y, rate) = (y + rate * dt, rate + pull * dt);
                }
                let found = values[k as usize][3];
                assert!((found - y).abs() < 2e-4, "{settle} {smoother}, sample {k}: {found} {y}");
            }
        }
    }

    #[test]
    fn steps_are_those_of_the_converter() {
        let parts = SweepParts { dac_bits: Some(4), ..AnalogParts::ideal().sweep };
        let levels = run(&parts);
        assert!(levels.iter().all(|level| (level * 16.0).fract() == 0.0));
        assert!(
            levels.windows(2).any(|pair| pair[1] > pair[0])
                && levels.windows(2).any(|pair| pair[1] < pair[0])
        );
    }
}
