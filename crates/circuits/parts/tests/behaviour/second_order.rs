//! The second order against closed forms, in all three kinds of damping.

use parts::{SecondOrder, SecondOrderState, SecondOrderStep};
use proptest::prelude::{prop_assert, proptest};
use signal::Lanes;

use crate::assert_near;
use crate::runge_kutta::integrate;

const DAMPINGS: [f64; 7] = [0.05, 0.2, 0.8, 1.0, 1.5, 2.5, 20.0];

/// Response to a unit step at w = 1, and its rate, as the textbooks have it.
fn step_response(z: f64, t: f64) -> [f64; 2] {
    if z < 1.0 {
        let q = (1.0 - z * z).sqrt();
        let (sin, cos) = libm::sincos(q * t);
        let e = libm::exp(-z * t);
        [1.0 - e * (cos + z / q * sin), e * sin / q]
    } else if z == 1.0 {
        let e = libm::exp(-t);
        [1.0 - e * (1.0 + t), e * t]
    } else {
        let q = (z * z - 1.0).sqrt();
        // (z - q)(z + q) = 1.
        let (a, b) = (libm::exp(-t / (z + q)), libm::exp(-(z + q) * t));
        let (slow, fast) = (1.0 / (z + q), z + q);
        [1.0 - (fast * a - slow * b) / (2.0 * q), (a - b) / (2.0 * q)]
    }
}

fn run(step: &SecondOrderStep<f64>, steps: i32, u: impl Fn(i32) -> f64) -> SecondOrderState<f64> {
    (1..=steps).fold(SecondOrderState::default(), |state, n| step.step(state, u(n - 1), u(n)))
}

#[test]
fn step_responses() {
    for z in DAMPINGS {
        for angle in [1e-3, 0.03, 0.3, 1.0, 7.0] {
            let natural = 2.0e7;
            let step = SecondOrder { natural, damping: z }.step(angle / natural);
            for n in [1, 2, 10, 300] {
                let state = run(&step, n, |_| 1.0);
                let [y, rate] = step_response(z, angle * f64::from(n));
                assert_near(state.y, y, 1e-12);
                assert_near(state.rate / natural, rate, 1e-12);
            }
        }
    }
}

#[test]
fn ramp_responses() {
    for z in DAMPINGS {
        for angle in [0.03, 0.3, 1.0, 7.0] {
            let step = SecondOrder { natural: 1.0, damping: z }.step(angle);
            for n in [1, 3, 100] {
                let t = angle * f64::from(n);
                let state = run(&step, n, |n| f64::from(n) / 100.0);
                // Integral of the step response: t - 2 z y - y'.
                let [y, rate] = step_response(z, t);
                assert_near(state.y, (t - 2.0 * z * y - rate) / (100.0 * angle), 1e-12);
                assert_near(state.rate, y / (100.0 * angle), 1e-12);
            }
        }
    }
}

#[test]
fn a_ramp_is_late_by_the_group_delay() {
    let smoother = SecondOrder::of_delay(40e-9, 0.8);
    assert_near(smoother.group_delay() * 1e9, 40.0, 1e-9);
    let h = 20e-9;
    let state = run(&smoother.step(h), 200, |n| f64::from(n) * h * 1e6);
    assert_near(state.y, (200.0 * h - 40e-9) * 1e6, 1e-12);
}

#[test]
fn staircases_are_two_held_steps() {
    for z in [0.2, 0.8, 1.0, 1.5] {
        for share in [0.0, 0.13, 0.5, 1.0] {
            let (part, h) = (SecondOrder { natural: 3e7, damping: z }, 50e-9);
            let state = SecondOrderState { y: 0.3, rate: -2e6 };
            let found = part.staircase::<f64>(h, share).step(state, 0.9, -0.4);
            let middle = part.step::<f64>(h * share).step(state, 0.9, 0.9);
            let end = part.step::<f64>(h * (1.0 - share)).step(middle, -0.4, -0.4);
            assert_near(found.y, end.y, 1e-13);
            assert_near(found.rate / 3e7, end.rate / 3e7, 1e-13);
        }
    }
}

/// An input that settles by a lag is one of many short straight pieces.
#[test]
fn an_input_that_settles_is_many_straight_pieces() {
    let h = 50e-9;
    for (natural, damping) in
        [(1.0 / 40e-9, 0.8), (1.0 / 3e-9, 0.7), (1.0 / 900e-9, 0.99), (1.0 / 40e-9, 0.0)]
    {
        for tau in [20e-9, 1e-9, 400e-9, 0.0] {
            let part = SecondOrder { natural, damping };
            let begin = SecondOrderState { y: 0.3, rate: 2e6 };
            let (from, to) = (0.9, -0.4);
            let found = part.settling::<f64>(h, tau).step(begin, from, to);
            let pieces = 20_000;
            let piece = part.step::<f64>(h / f64::from(pieces));
            let input = |k: i32| {
                let since = h * f64::from(k) / f64::from(pieces);
                if tau == 0.0 { to } else { to + (from - to) * libm::exp(-since / tau) }
            };
            let right = (0..pieces).fold(begin, |state, k| piece.step(state, input(k), input(k + 1)));
            assert!((found.y - right.y).abs() < 1e-6, "{natural} {damping} {tau}: {} {}", found.y, right.y);
            assert!((found.rate - right.rate).abs() < 1e-6 * natural, "{natural} {damping} {tau}: rate");
        }
    }
}

#[test]
fn a_smoothed_staircase_lies_on_the_late_ramp() {
    // Mean over a step of a staircase that leads by half a step: the ramp, late by the group delay less that half.
    let (smoother, h) = (SecondOrder::of_delay(400e-9, 0.8), 20e-9);
    let state = run(&smoother.staircase(h, 0.0), 400, f64::from);
    assert_near(state.y, 400.0 - 400.0 / 20.0 + 0.5, 0.01);
}

#[test]
fn against_the_integrator() {
    for z in [0.2, 1.0, 1.5] {
        let step = SecondOrder { natural: 1.0, damping: z }.step::<f64>(0.7);
        let u = |t: f64| 0.4 - 1.3 * t;
        let found = step.step(SecondOrderState { y: -0.2, rate: 0.9 }, u(0.0), u(0.7));
        let [y, rate] = integrate([-0.2, 0.9], 0.7, 1e-14, |t, &[y, v]| [v, u(t) - y - 2.0 * z * v]);
        assert_near(found.y, y, 1e-12);
        assert_near(found.rate, rate, 1e-12);
    }
}

#[test]
fn no_seam_at_critical_damping() {
    for angle in [0.01, 0.3, 2.0, 30.0] {
        let at = |damping: f64| {
            let step = SecondOrder { natural: 1.0, damping }.step::<f64>(angle);
            step.step(SecondOrderState { y: 0.3, rate: -0.7 }, 0.9, 0.1)
        };
        for near in [1e-15, 1e-12, 1e-9] {
            for z in [1.0 - near, 1.0 + near] {
                assert_near(at(z).y, at(1.0).y, 1e-14 + 3.0 * near);
                assert_near(at(z).rate, at(1.0).rate, 1e-14 + 3.0 * near);
            }
        }
        let (below, above) = (at(2.0 - 1e-13), at(2.0 + 1e-13));
        assert_near(below.y, above.y, 1e-12);
    }
}

#[test]
fn an_impulse_is_the_rate_of_the_step_response() {
    let part = SecondOrder { natural: 3e7, damping: 0.8 };
    let h = 50e-9;
    let [_, rate] = step_response(0.8, 3e7 * h * 0.7);
    assert_near(part.impulse(h, 0.3).y / 3e7, rate, 1e-12);
    // Its own rate, by difference.
    let e = 1e-6;
    let slope =
        (step_response(0.8, 3e7 * h * 0.7 + e)[1] - step_response(0.8, 3e7 * h * 0.7 - e)[1]) / (2.0 * e);
    assert_near(part.impulse(h, 0.3).rate / 9e14, slope, 1e-9);
}

#[test]
fn extremes() {
    let state = SecondOrderState { y: 0.3, rate: 2.0 };
    let at_once = SecondOrder { natural: f64::INFINITY, damping: 0.8 };
    assert_near(at_once.step::<f64>(1e-8).step(state, 0.1, 0.7).y, 0.7, 1e-15);
    assert_eq!(at_once.staircase::<f64>(1e-8, 0.4).step(state, 0.1, 0.7).rate, 0.0);
    assert_eq!(at_once.impulse(1e-8, 0.5), SecondOrderState { y: 0.0, rate: 0.0 });
    let coasting = SecondOrder { natural: 0.0, damping: 0.8 }.step::<f64>(0.5).step(state, 9.0, 9.0);
    assert_eq!(coasting, SecondOrderState { y: 1.3, rate: 2.0 });
    let nothing = SecondOrder { natural: 1e9, damping: 0.8 }.step::<f64>(0.0).step(state, 9.0, 9.0);
    assert_eq!(nothing, state);
}

#[test]
fn a_constant_stays_at_ninety_hertz_seen_every_fifty_nanoseconds() {
    let step = SecondOrder { natural: 565.0, damping: 0.25 }.step::<f32>(50e-9);
    let mut state = SecondOrderState { y: 0.7_f32, rate: 0.0 };
    (0..10_000).for_each(|_| state = step.step(state, 0.7, 0.7));
    assert_eq!(state, SecondOrderState { y: 0.7, rate: 0.0 });
}

proptest! {
    /// Cutting a step anywhere changes nothing, and a lane is a scalar.
    #[test]
    fn parts_of_a_step_make_the_step(
        exponent in -6.0..4.0, z in 0.05..5.0, share in 0.0..1.0, y in -1.0..1.0, u0 in -1.0..1.0, u1 in -1.0..1.0,
    ) {
        let (h, part) = (libm::pow(10.0, exponent), SecondOrder { natural: 1.0, damping: z });
        let start: SecondOrderState<f64> = SecondOrderState { y, rate: u0 * u1 };
        let there = u0 + (u1 - u0) * share;
        let whole = part.step::<f64>(h).step(start, u0, u1);
        let middle = part.step::<f64>(h * share).step(start, u0, there);
        let cut = part.step::<f64>(h * (1.0 - share)).step(middle, there, u1);
        prop_assert!((whole.y - cut.y).abs() < 1e-12 && (whole.rate - cut.rate).abs() < 1e-12);
        let lanes = SecondOrderState { y: Lanes::splat(y), rate: Lanes::splat(u0 * u1) };
        let lanes = part.step::<f64>(h).step(lanes, Lanes::splat(u0), Lanes::splat(u1));
        prop_assert!(lanes.y == Lanes::splat(whole.y) && lanes.rate == Lanes::splat(whole.rate));
    }
}
