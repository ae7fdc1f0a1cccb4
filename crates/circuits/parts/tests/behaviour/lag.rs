//! The lag against its analytic responses.

use std::f64::consts::LN_2;

use parts::{LagStep, SplitLag, impulse, settling_time_constant, time_constant};
use proptest::prelude::{any, prop_assert, proptest};
use signal::Lanes;

use crate::assert_near;

/// From much shorter than a step to much longer.
const RATIOS: [f64; 9] = [1e-9, 1e-3, 0.1, 0.4999, 0.5001, 1.0, 2.6, 80.0, 1e4];

#[test]
fn step_response() {
    for ratio in RATIOS {
        let lag = LagStep::<f64>::new(ratio, 1.0);
        let mut y = 0.0;
        for n in 1..=1000 {
            y = lag.step(y, 1.0, 1.0);
            assert_near(y, -libm::expm1(-ratio * f64::from(n)), 1e-12);
        }
    }
}

#[test]
fn ramp_response() {
    for ratio in RATIOS {
        let lag = LagStep::<f64>::new(ratio, 1.0);
        let mut y = 0.0;
        for n in 1..=1000 {
            // A ramp that reaches 1 at the end, whatever the step.
            let u = |n: i32| f64::from(n) / 1000.0;
            y = lag.step(y, u(n - 1), u(n));
            let t = ratio * f64::from(n);
            let exact =
                if t < 1e-3 { t * t / 2.0 * (1.0 - t / 3.0 + t * t / 12.0) } else { t + libm::expm1(-t) };
            assert_near(y, exact / (1000.0 * ratio), 1e-12);
        }
    }
}

#[test]
fn fold_of_a_ramp() {
    // The ramp turns at a share of a step; before, it has run for ever.
    let (tau, slope) = (40e-9, 95.0 / 300.0 * 1e6);
    let unit = slope * tau;
    for h in [5e-9, 26.3e-9, 52.6e-9] {
        for share in [0.0, 0.3, 0.77, 1.0] {
            let (before, after) = (h * share, h * (1.0 - share));
            let split = SplitLag::<f64>::new(h, tau, share);
            let mut y = split.step(-slope * (before + tau), -slope * before, 0.0, 0.0, -slope * after);
            let lag = LagStep::<f64>::new(h, tau);
            for n in 0..100 {
                let t = after + h * f64::from(n);
                let exact = -slope * (t - tau) - 2.0 * unit * libm::exp(-t / tau);
                assert_near(y / unit, exact / unit, 1e-12);
                y = lag.step(y, -slope * t, -slope * (t + h));
            }
        }
    }
}

#[test]
fn peak_and_deviation_of_a_fold() {
    let (tau, slope) = (40e-9, 1e6);
    // The peak comes tau ln 2 after the reversal and is short by 0.693 s tau.
    let to_peak = LagStep::<f64>::new(tau * LN_2, tau);
    let peak = to_peak.step(-slope * tau, 0.0, -slope * tau * LN_2);
    assert_near(peak / (slope * tau), -LN_2, 1e-12);
    // At tau after it the output is 0.736 s tau off the late ramp.
    let to_tau = LagStep::<f64>::new(tau, tau);
    let y = to_tau.step(-slope * tau, 0.0, -slope * tau);
    assert_near(y / (slope * tau), -2.0 / std::f64::consts::E, 1e-12);
}

#[test]
fn a_jump_within_a_step() {
    for ratio in RATIOS {
        for share in [0.0, 0.2, 0.5, 0.999, 1.0] {
            let y = LagStep::<f64>::jump(ratio, 1.0, share).step(0.3, -0.5, 0.8);
            let at_jump = -0.5 + 0.8 * libm::exp(-ratio * share);
            let exact = 0.8 + (at_jump - 0.8) * libm::exp(-ratio * (1.0 - share));
            assert_near(y, exact, 1e-12);
            assert_near(
                SplitLag::<f64>::new(ratio, 1.0, share).step(0.3, -0.5, -0.5, 0.8, 0.8),
                exact,
                1e-12,
            );
        }
        let held = LagStep::<f64>::held(ratio, 1.0);
        assert_eq!(held.to, 0.0);
    }
}

#[test]
fn an_impulse_is_a_jump_of_its_area_over_tau() {
    let (h, tau, width) = (50e-9, 20e-9, 1e-15);
    let pulse = LagStep::<f64>::new(width, tau).step(0.0, 1.0 / width, 1.0 / width);
    let after = LagStep::<f64>::new(h * 0.6, tau).step(pulse, 0.0, 0.0);
    assert_near(impulse(h, tau, 0.4) / after, 1.0, 1e-6);
    assert_eq!(impulse(h, 0.0, 0.4), 0.0);
}

#[test]
fn extremes_are_exact() {
    for (u0, u1) in [(0.1, 0.7), (-3.3, 1e9), (0.0, 0.0)] {
        assert_eq!(LagStep::<f64>::new(50e-9, 0.0).step(0.123, u0, u1), u1);
        assert_eq!(LagStep::<f64>::new(50e-9, f64::INFINITY).step(0.123, u0, u1), 0.123);
        assert_eq!(LagStep::<f64>::new(0.0, 1e-9).step(0.123, u0, u1), 0.123);
        assert_eq!(LagStep::<f32>::new(50e-9, 0.0).step(0.123, u0 as f32, u1 as f32), u1 as f32);
    }
}

#[test]
fn figures_of_the_reference() {
    assert_near(time_constant(8e6) * 1e9, 19.9, 0.05);
    assert_near(settling_time_constant(400e-9, 0.001) * 1e9, 400.0 / 6.9, 0.1);
    assert_eq!(time_constant(f64::INFINITY), 0.0);
}

#[test]
fn a_constant_stays_to_rounding_however_slow_the_lag() {
    for exponent in -12..=12 {
        let tau = libm::pow(10.0, f64::from(exponent));
        let lag = LagStep::<f32>::new(1.0, tau);
        let y = (0..10_000).fold(0.7_f32, |y, _| lag.step(y, 0.7, 0.7));
        assert_near(f64::from(y), f64::from(0.7_f32), 6e-8 * tau.clamp(1.0, 1e4));
        assert_eq!(lag.keep + (lag.from + lag.to), 1.0);
    }
}

proptest! {
    /// Cutting a step anywhere changes nothing.
    #[test]
    fn parts_of_a_step_make_the_step(
        exponent in -12.0..12.0, share in 0.0..1.0, y in -1.0..1.0, u0 in -1.0..1.0, u1 in -1.0..1.0,
    ) {
        let ratio = libm::pow(10.0, exponent);
        let there = u0 + (u1 - u0) * share;
        let whole: f64 = LagStep::<f64>::new(ratio, 1.0).step(y, u0, u1);
        let cut = SplitLag::<f64>::new(ratio, 1.0, share).step(y, u0, there, there, u1);
        prop_assert!((whole - cut).abs() < 1e-12);
    }

    /// The output never leaves the hull of where it was and its input; a lane is a scalar.
    #[test]
    fn bounded_and_the_same_in_a_lane(
        exponent in -12.0..12.0, y in any::<i16>(), u0 in any::<i16>(), u1 in any::<i16>(),
    ) {
        let [y, u0, u1] = [y, u0, u1].map(f32::from);
        let lag = LagStep::<f32>::new(libm::pow(10.0, exponent), 1.0);
        let out = lag.step(y, u0, u1);
        let most = y.abs().max(u0.abs()).max(u1.abs());
        prop_assert!(out.abs() <= most * 1.000_001);
        prop_assert!(lag.step(Lanes::splat(y), Lanes::splat(u0), Lanes::splat(u1)) == Lanes::splat(out));
    }
}
