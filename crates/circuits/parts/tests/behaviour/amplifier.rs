//! The amplifier against closed forms and against the integrator.

use fearless_simd::{Level, dispatch};
use parts::{Amplifier, AmplifierLaw, AmplifierState, summing_time_constant};
use proptest::prelude::{Just, prop_assert, prop_assert_eq, prop_oneof, proptest};
use signal::{LANES, Lanes};

use crate::assert_near;
use crate::runge_kutta::integrate;

const QUIET: AmplifierState<f64> = AmplifierState { y: 0.0, excess: 0.0 };

/// Output and store after one step, by the integrator.
fn integrated(law: &AmplifierLaw, h: f64, state: &AmplifierState<f64>, [u0, u1]: [f64; 2]) -> [f64; 2] {
    integrate([state.y, state.excess], h, 1e-13, |t, &[y, x]| {
        let u = u0 + (u1 - u0) * t / h;
        let excess = y - y.clamp(-law.saturation, law.saturation);
        [((u - y) / law.tau).clamp(-law.slew, law.slew), (excess - x) / law.recovery]
    })
}

#[test]
fn settling_of_a_slewing_amplifier() {
    let law = AmplifierLaw { tau: 14e-9, slew: 20e6, saturation: f64::INFINITY, recovery: 0.0 };
    for (volts, error) in [(1.0, 1e-3), (0.5, 1e-4), (0.28001, 1e-3), (0.1, 1e-3)] {
        let knee = law.slew * law.tau;
        let settles = if volts > knee {
            volts / law.slew - law.tau + law.tau * libm::log(knee / error)
        } else {
            law.tau * libm::log(volts / error)
        };
        for steps in [1, 2, 7, 100] {
            let amplifier = Amplifier::<f64>::new(settles / f64::from(steps), &law);
            let mut state = QUIET;
            let y = (0..steps).fold(0.0, |_, _| amplifier.step(&mut state, volts, volts));
            assert_near(volts - y, error, 1e-12);
        }
    }
}

#[test]
fn every_order_of_pieces_against_the_integrator() {
    let law = AmplifierLaw { tau: 1.0, slew: 0.8, saturation: 1.0, recovery: 0.7 };
    let inputs = [-6.0, -1.4, -0.5, 0.3, 1.1, 5.0];
    for h in [0.1, 1.0, 5.0] {
        let amplifier = Amplifier::<f64>::new(h, &law);
        for (y, excess) in [(0.0, 0.0), (1.6, 0.2), (-2.5, -0.7), (0.9, 0.5)] {
            for (u0, u1) in inputs.iter().flat_map(|&u0| inputs.map(|u1| (u0, u1))) {
                let mut state = AmplifierState { y, excess };
                let [exact_y, exact_x] = integrated(&law, h, &state, [u0, u1]);
                let out = amplifier.step(&mut state, u0, u1);
                assert_near(state.y, exact_y, 1e-12);
                assert_near(state.excess, exact_x, 1e-12);
                assert_near(out, (exact_y + exact_x).clamp(-1.0, 1.0), 1e-12);
            }
        }
    }
}

#[test]
fn overload_ends_late_by_its_tail() {
    let law = AmplifierLaw { tau: 0.0, slew: f64::INFINITY, saturation: 1.1, recovery: 1e-6 };
    let h = 50e-9;
    let amplifier = Amplifier::<f64>::new(h, &law);
    let mut state = QUIET;
    // One tail constant of overload by 0.9.
    (0..20).for_each(|_| assert_eq!(amplifier.step(&mut state, 2.0, 2.0), 1.1));
    let stored = 0.9 * (1.0 - libm::exp(-1.0));
    assert_near(state.excess, stored, 1e-12);
    for n in 1..=40 {
        let out = amplifier.step(&mut state, 1.0, 1.0);
        let tail = stored * libm::exp(-f64::from(n) * h / 1e-6);
        assert_near(out, (1.0 + tail).min(1.1), 1e-12);
    }
}

#[test]
fn plain_clip_without_recovery() {
    let law = AmplifierLaw { tau: 0.0, slew: f64::INFINITY, saturation: 0.5, recovery: 0.0 };
    let amplifier = Amplifier::<f64>::new(50e-9, &law);
    let mut state = QUIET;
    for (u, out) in [(0.4, 0.4), (0.9, 0.5), (0.2, 0.2), (-3.0, -0.5), (-0.1, -0.1)] {
        assert_eq!(amplifier.step(&mut state, 0.0, u), out);
    }
}

#[test]
fn degenerate_slew_and_lag() {
    let law = AmplifierLaw { tau: 1.0, slew: 0.0, saturation: f64::INFINITY, recovery: 0.0 };
    for tau in [0.0, 1.0, f64::INFINITY] {
        let held = Amplifier::<f64>::new(1.0, &AmplifierLaw { tau, ..law });
        let mut state = AmplifierState { y: 0.3, excess: 0.0 };
        for (u0, u1) in [(5.0, -5.0), (-5.0, 5.0), (0.3, 0.3), (0.3, 0.4)] {
            assert_eq!(held.step(&mut state, u0, u1), 0.3);
        }
    }
    // No lag: a pure limit of the rate, which stays on a slower input to the bit.
    let limiter = Amplifier::<f64>::new(1.0, &AmplifierLaw { tau: 0.0, slew: 0.5, ..law });
    let mut state = QUIET;
    assert_eq!(limiter.step(&mut state, 0.0, 2.0), 0.5);
    assert_eq!(limiter.step(&mut state, 2.0, 2.0), 1.0);
    assert_near(limiter.step(&mut state, 1.0, 1.3), 1.3, 1e-15);
    assert_eq!(limiter.step(&mut state, 1.3, 1.7), 1.7);
    let wire = Amplifier::<f64>::new(1.0, &AmplifierLaw { tau: 0.0, slew: f64::INFINITY, ..law });
    assert_eq!(wire.step(&mut state, 1.0, -7.3), -7.3);
    let still = Amplifier::<f64>::new(1.0, &AmplifierLaw { tau: f64::INFINITY, slew: 2.0, ..law });
    assert_eq!(still.step(&mut state, 100.0, 200.0), -7.3);
}

#[test]
fn figures_of_the_reference() {
    // 36 inputs at 80 MHz: 2.2 MHz; a tree of six: 11.4 MHz.
    let bandwidth = |inputs| 1.0 / (2.0 * std::f64::consts::PI * summing_time_constant(inputs, 80e6));
    assert_near(bandwidth(36), 2.16e6, 0.01e6);
    assert_near(bandwidth(6), 11.4e6, 0.05e6);
}

proptest! {
    #[test]
    fn random_steps_against_the_integrator(
        tau in 0.05..5.0, slew in 0.05..5.0, saturation in 0.2..3.0, recovery in 0.05..5.0,
        y in -3.0..3.0, excess in -1.0..1.0, u0 in -4.0..4.0, u1 in -4.0..4.0,
    ) {
        let law = AmplifierLaw { tau, slew, saturation, recovery };
        let mut state = AmplifierState { y, excess };
        let [exact_y, exact_x] = integrated(&law, 1.0, &state, [u0, u1]);
        Amplifier::<f64>::new(1.0, &law).step(&mut state, u0, u1);
        prop_assert!((state.y - exact_y).abs() < 1e-12, "{} {exact_y}", state.y);
        prop_assert!((state.excess - exact_x).abs() < 1e-12, "{} {exact_x}", state.excess);
    }

    /// A group of lanes has the bits of its sweeps alone, whichever of them slew or clip.
    #[test]
    fn a_lane_is_a_scalar(
        slew in prop_oneof![Just(0.0), Just(1.0), Just(f64::INFINITY)], tau in prop_oneof![Just(0.0), Just(0.3)],
        size in prop_oneof![Just(0.1_f32), Just(0.5), Just(2.0)], lift in -1.0_f32..1.0,
        inputs in proptest::collection::vec(-1.0_f32..1.0, 6 * LANES), first in 0..5_usize,
    ) {
        let law = AmplifierLaw { tau, slew, saturation: 1.1, recovery: 0.5 };
        let amplifier = Amplifier::<f32>::new(0.4, &law);
        let mut group = AmplifierState::<Lanes<f32>>::default();
        let mut alone = [AmplifierState::<f32>::default(); LANES];
        let at = |n: usize| Lanes::from_fn(|lane| lift + size * inputs[n * LANES + lane]);
        let mut right = Vec::new();
        for n in 1..6 {
            let (u0, u1) = (at(n - 1), at(n));
            right.push(Lanes::from_fn(|lane| amplifier.step(&mut alone[lane], u0[lane], u1[lane])));
        }
        let signal: Vec<_> = (0..6).map(at).collect();
        let mut out = [Lanes::default(); 5];
        // In pieces of every length: a step that slews or clips makes its piece go lane by lane.
        for samples in [0..first, first..5] {
            let fed = &signal[samples.start..=samples.end];
            dispatch!(Level::new(), simd => amplifier.pass(simd, &mut group, fed, &mut out[samples.clone()]));
        }
        prop_assert_eq!(&out[..], &right[..]);
    }
}
