//! The driver over whole sweeps: closed forms, the integrator, and what is left of its jumps.

use std::array;

use parts::{Driver, Jump, Jumps};
use proptest::prelude::{Just, Strategy, any, prop_assert, prop_assert_eq, prop_oneof, proptest};
use signal::{LANES, Lanes};

use crate::assert_near;
use crate::runge_kutta::integrate;

const H: f64 = 50e-9;
const SAMPLES: usize = 12;

/// One sweep: samples, and jumps between them.
type Sweep = (Vec<f64>, Vec<Jump>);

/// The output of one sweep alone.
fn pass(driver: &Driver<f64>, (samples, jumps): &Sweep) -> Sweep {
    let mut signal: Vec<_> = samples.iter().map(|&value| Lanes::splat(value)).collect();
    let mut out = Jumps::of(array::from_fn(|_| jumps.clone()));
    driver.pass(&mut signal, &mut out);
    let lists = out.lists;
    assert!(lists.iter().all(|list| *list == lists[0]));
    (signal.iter().map(|value| value[0]).collect(), lists[0].clone())
}

fn step_at(at: f64, size: f64) -> Sweep {
    let samples = (0..SAMPLES).map(|k| if k as f64 > at { size } else { 0.0 }).collect();
    (samples, vec![Jump { at, before: 0.0, after: size }])
}

/// Times and values of the lines from place to place.
fn lines((samples, jumps): &Sweep) -> Vec<[[f64; 2]; 2]> {
    let mut found = Vec::new();
    let mut from = [0.0, samples[0]];
    for (k, &value) in samples.iter().enumerate().skip(1) {
        for jump in jumps.iter().filter(|jump| jump.at > k as f64 - 1.0 && jump.at < k as f64) {
            found.push([from, [jump.at, jump.before]]);
            from = [jump.at, jump.after];
        }
        found.push([from, [k as f64, value]]);
        from = [k as f64, value];
    }
    found
}

fn area(sweep: &Sweep) -> f64 {
    lines(sweep).iter().map(|[[t0, v0], [t1, v1]]| (t1 - t0) * (v0 + v1) / 2.0).sum()
}

#[test]
fn a_jump_between_samples_decays_from_its_instant_on() {
    for (tau, at) in [(0.3, 4.25), (1.0, 4.9), (6.0, 4.5), (0.01, 4.99)] {
        let driver = Driver::<f64>::new(H, tau * H, f64::INFINITY);
        let (samples, jumps) = pass(&driver, &step_at(at, 0.8));
        for (k, value) in samples.iter().enumerate() {
            assert_near(*value, -0.8 * libm::expm1(-(k as f64 - at).max(0.0) / tau), 1e-12);
        }
        assert_eq!((jumps[0].at, jumps[0].before), (at, 0.0));
        // The line to the next sample has the area of the answer: the input's, less what the output has risen by tau.
        let rest = 5.0 - at;
        assert_near((jumps[0].after + samples[5]) / 2.0 * rest, 0.8 * rest - tau * samples[5], 1e-12);
    }
}

#[test]
fn a_slewing_jump_is_a_ramp_and_then_a_lag() {
    let (tau, rate, size, at) = (0.5, 0.2, 1.0, 2.5);
    let driver = Driver::<f64>::new(H, tau * H, rate / H);
    let (samples, jumps) = pass(&driver, &step_at(at, size));
    let corner = at + driver.slewing(size);
    assert_near(corner, at + (size - tau * rate) / rate, 1e-12);
    for (k, value) in samples.iter().enumerate() {
        let time = k as f64;
        let expected = if time <= corner {
            rate * (time - at).max(0.0)
        } else {
            size - rate * tau * libm::exp(-(time - corner) / tau)
        };
        assert_near(*value, expected, 1e-12);
    }
    // A ramp is a straight line: nothing of the jump is left.
    assert_near(jumps[0].after, 0.0, 1e-12);
}

#[test]
fn a_fast_driver_leaves_the_jump_and_a_slow_one_none_of_it() {
    let left = |tau: f64| pass(&Driver::<f64>::new(H, tau * H, f64::INFINITY), &step_at(3.5, 1.0)).1[0].after;
    // By twice the time constant over the rest of the step.
    for tau in [1e-3, 1e-4] {
        assert_near(left(tau), 1.0 - 4.0 * tau, 1e-9);
    }
    assert!(left(5.0) < 2e-3 && left(5.0) >= 0.0, "{}", left(5.0));
}

#[test]
fn a_bend_is_no_jump() {
    let ramp = (0..SAMPLES).map(|k| (k as f64 - 3.5).max(0.0)).collect();
    let bent = (ramp, vec![Jump { at: 3.5, before: 0.0, after: 0.0 }]);
    let (samples, jumps) = pass(&Driver::new(H, 0.4 * H, f64::INFINITY), &bent);
    assert_eq!((jumps[0].before, jumps[0].after), (0.0, 0.0));
    for (k, value) in samples.iter().enumerate() {
        let time = (k as f64 - 3.5).max(0.0);
        assert_near(*value, time - 0.4 * -libm::expm1(-time / 0.4), 1e-12);
    }
}

#[test]
fn a_driver_without_a_fault_is_a_wire() {
    let sweep = step_at(4.25, 0.3);
    for rate in [f64::INFINITY, 1e300] {
        assert_eq!(pass(&Driver::new(H, 0.0, rate), &sweep), sweep);
    }
    let (samples, jumps) = pass(&Driver::new(H, 0.0, 0.0), &sweep);
    assert_eq!((samples, jumps[0].after), (vec![0.0; SAMPLES], 0.0));
}

fn sweep() -> impl Strategy<Value = Sweep> {
    let samples = proptest::collection::vec(-1.0..1.0f64, SAMPLES);
    let place = prop_oneof![0.0..10.9f64, (0..11u32).prop_map(f64::from), Just(4.5)];
    let jumps = proptest::collection::vec((place, -1.0..1.0f64, -1.0..1.0f64), 0..6);
    (samples, jumps).prop_map(|(samples, mut jumps)| {
        jumps.sort_by(|a, b| a.0.total_cmp(&b.0));
        (samples, jumps.into_iter().map(|(at, before, after)| Jump { at, before, after }).collect())
    })
}

proptest! {
    /// Each line of the input is followed as the integrator does.
    #[test]
    fn whatever_comes_is_followed(
        input in sweep(), tau in 0.05..4.0f64, rate in prop_oneof![Just(f64::INFINITY), 0.1..2.0f64],
    ) {
        let mut input = input;
        input.1.dedup_by(|next, kept| next.at == kept.at || next.at.fract() == 0.0);
        input.1.retain(|jump| jump.at.fract() != 0.0);
        let out = pass(&Driver::<f64>::new(H, tau * H, rate / H), &input);
        let mut y = input.0[0];
        for ([[t0, u0], [t1, u1]], [_, [_, found]]) in lines(&input).into_iter().zip(lines(&out)) {
            let length = t1 - t0;
            [y] = integrate([y], length, 1e-12, |t, &[y]| {
                [((u0 + (u1 - u0) * t / length - y) / tau).clamp(-rate, rate)]
            });
            prop_assert!((y - found).abs() < 1e-9, "{} {} at {}", y, found, t1);
        }
    }

    /// A lane has the bits that it has alone, and no output is beyond its input.
    #[test]
    fn lanes_do_not_see_one_another(
        inputs in proptest::collection::vec(sweep(), LANES), tau in prop_oneof![Just(0.0), 1e-6..50.0f64],
        rate in prop_oneof![Just(f64::INFINITY), Just(0.0), 1e-6..3.0f64], wide in any::<bool>(),
    ) {
        let driver = Driver::<f64>::new(H, tau * H, rate / H);
        let mut signal: Vec<_> = (0..SAMPLES).map(|k| Lanes::from_fn(|lane| inputs[lane].0[k])).collect();
        let mut out = Jumps::of(array::from_fn(|lane| inputs[lane].1.clone()));
        driver.pass(&mut signal, &mut out);
        let jumps = out.lists;
        for lane in 0..if wide { LANES } else { 1 } {
            let (samples, alone) = pass(&driver, &inputs[lane]);
            let found: Vec<f64> = signal.iter().map(|value| value[lane]).collect();
            prop_assert_eq!(&found, &samples);
            prop_assert_eq!(&jumps[lane], &alone);
            prop_assert!(found.iter().all(|value| value.abs() <= 1.0 + 1e-12));
            prop_assert!(alone.iter().all(|jump| jump.before.abs().max(jump.after.abs()) <= 1.0 + 1e-12));
        }
    }

    /// Signals that pass together are what each is by itself, and one without a driver is what it was.
    #[test]
    fn together_is_each_alone(
        inputs in proptest::collection::vec(proptest::collection::vec(-1.0..1.0f64, 40), 3),
        parts in proptest::collection::vec((0.0..4.0f64, prop_oneof![Just(f64::INFINITY), 0.02..2.0f64], 0..5u8), 3),
    ) {
        let drivers: Vec<_> = parts.iter().map(|&(tau, rate, some)| {
            (some > 0).then(|| Driver::<f64>::new(H, tau * H, rate / H))
        }).collect();
        // Lanes differ, so that some slew and others do not.
        let group = |input: &Vec<f64>| -> Vec<Lanes<f64>> {
            input.iter().map(|&value| Lanes::from_fn(|lane| value * (0.1 + 0.2 * lane as f64))).collect()
        };
        let mut together: Vec<_> = inputs.iter().map(group).collect();
        let [first, second, third] = &mut together[..] else { unreachable!() };
        let wired = [0, 1, 2].map(|n: usize| drivers[n].as_ref());
        Driver::pass_together(wired, [first, second, third]);
        for ((input, driver), found) in inputs.iter().zip(&drivers).zip(&together) {
            let mut alone = group(input);
            driver.iter().for_each(|driver| driver.pass(&mut alone, &mut Jumps::default()));
            prop_assert_eq!(found, &alone);
        }
    }
}

/// A jump at a sample counts whichever side of it the sample has.
#[test]
fn a_jump_at_a_sample_is_one_jump() {
    let driver = Driver::<f64>::new(H, 0.7 * H, f64::INFINITY);
    let sample =
        |there: f64| (0..SAMPLES).map(move |k| if k == 4 { there } else { f64::from(u8::from(k > 4)) });
    for there in [0.0, 1.0] {
        let (samples, _) =
            pass(&driver, &(sample(there).collect(), vec![Jump { at: 4.0, before: 0.0, after: 1.0 }]));
        for (k, value) in samples.iter().enumerate() {
            assert_near(*value, -libm::expm1(-(k as f64 - 4.0).max(0.0) / 0.7), 1e-12);
        }
    }
}

/// What is drawn in straight lines has the area of the answer, however many jumps a step has.
#[test]
fn lines_have_the_area_of_the_answer() {
    let jump = |at: f64, before: f64, after: f64| Jump { at, before, after };
    let samples = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0];
    let input = (samples, vec![jump(2.2, 0.0, 0.7), jump(2.5, 0.7, 0.2), jump(2.8, 0.2, 1.0)]);
    for tau in [0.02, 0.3, 2.0] {
        let driver = Driver::<f64>::new(H, tau * H, f64::INFINITY);
        let out = pass(&driver, &input);
        // Up to sample 3: what comes later has no jumps.
        let until = |sweep: &Sweep| area(&(sweep.0[..4].to_vec(), sweep.1.clone()));
        let expected = until(&input) - tau * out.0[3];
        assert_near(until(&out), expected, 1e-12);
    }
}
