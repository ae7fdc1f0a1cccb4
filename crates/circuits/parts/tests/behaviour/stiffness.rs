//! The ill-conditioned cases of section 6: every part at its extremes, driven hard, stays bounded and a number.

use parts::{
    Amplifier, AmplifierLaw, AmplifierState, BandNoise, Comparator, ComparatorLaw, ComparatorState,
    Converter, ConverterLaw, Delay, Differentiator, Fade, HighPass, LagStep, NoiseSource, SampleHold,
    SampleHoldLaw, SecondOrder, SecondOrderState, SplitLag, Switch, SwitchLaw,
};
use signal::Real;

const H: f64 = 52.6e-9;
const TIMES: [f64; 9] = [0.0, 5e-324, 1e-15, 1e-12, 14e-9, 1e-6, 1.0, 1e6, f64::INFINITY];
const SHARES: [f64; 4] = [0.0, 1e-12, 0.5, 1.0];
const STEPS: u64 = 300;

/// Input of either sign within 1: steady, jumping, creeping.
fn input(n: u64) -> f64 {
    match n % 60 {
        0..20 => NoiseSource::new(1, "rough", 0).normal(0, n).clamp(-1.0, 1.0),
        20..40 => 1.0,
        _ => (n % 60) as f64 * 1e-9,
    }
}

/// Runs a part over the rough input, and checks that its output stays within `bound`.
fn drive<S: Real>(name: &str, bound: f64, mut part: impl FnMut(u64, S, S) -> S) {
    for n in 1..=STEPS {
        let out = part(n, S::from_f64(input(n - 1)), S::from_f64(input(n))).to_f64();
        assert!(out.abs() <= bound * (1.0 + 1e-5), "{name}: {out} at step {n}, bound {bound}");
    }
}

fn lags<S: Real>() {
    for tau in TIMES {
        for share in SHARES {
            let name = format!("lag, tau {tau:e}, share {share:e}");
            let steps =
                [LagStep::<S>::new(H, tau), LagStep::jump(H, tau, share), LagStep::new(H * share, tau)];
            for step in steps {
                let mut y = S::ZERO;
                drive(&name, 1.0, |_, u0, u1| {
                    y = step.step(y, u0, u1);
                    y
                });
            }
            let (split, mut y) = (SplitLag::<S>::new(H, tau, share), S::ZERO);
            drive(&name, 1.0, |_, u0, u1| {
                y = split.step(y, u0, u1, u0, u1);
                y
            });
        }
    }
}

fn second_orders<S: Real>() {
    for natural in TIMES.map(|tau| 1.0 / tau) {
        for damping in [0.05, 0.7, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 3.0, 1e6] {
            let part = SecondOrder { natural, damping };
            let name = format!("second order, {natural:e} rad/s, damping {damping}");
            for step in [part.step::<S>(H), part.staircase(H, 0.3), part.staircase(H, 1.0)] {
                let mut state = SecondOrderState::<S>::default();
                // Resonance at damping 0.05 may rise to 1 / 2z.
                drive(&name, 12.0, |_, u0, u1| {
                    state = step.step(state, u0, u1);
                    state.y
                });
            }
        }
    }
}

fn amplifiers<S: Real>() {
    for tau in TIMES {
        for slew in [0.0, 1e-300, 0.03e6, 20e6, 1e300, f64::INFINITY] {
            for (saturation, recovery) in
                [(0.0, 0.0), (0.5, 1e-15), (0.5, 1e-6), (0.9, 1e6), (f64::INFINITY, 0.0)]
            {
                let law = AmplifierLaw { tau, slew, saturation, recovery };
                let (amplifier, mut state) = (Amplifier::<S>::new(H, &law), AmplifierState::default());
                drive(&format!("{law:?}"), saturation.min(1.0), |_, u0, u1| {
                    amplifier.step(&mut state, u0, u1)
                });
                for recovery in TIMES {
                    let amplifier = Amplifier::<S>::new(H, &AmplifierLaw { recovery, ..law });
                    let mut state = AmplifierState::default();
                    drive(&format!("{law:?}, recovery {recovery:e}"), 2.0, |_, u0, u1| {
                        amplifier.step(&mut state, u0, u1);
                        state.excess
                    });
                }
            }
        }
    }
}

fn differentiators<S: Real>() {
    for tau_f in TIMES {
        let (part, mut state) = (Differentiator::<S>::new(H, H, tau_f), SecondOrderState::<S>::default());
        drive(&format!("differentiator, {tau_f:e}"), 2.0, |_, u0, u1| part.step(&mut state, u0, u1));
    }
}

fn converters<S: Real>() {
    for tau in TIMES {
        for delay in TIMES {
            for bits in [0, 1, 10, 24, 99] {
                let law = ConverterLaw { bits, nonlinearity: 0.0, glitch_area: 0.0, delay, tau };
                let (converter, mut state) = (Converter::<S>::new(H, &law), Default::default());
                drive(&format!("{law:?}"), 1.0, |_, _, u1| {
                    let word = converter.word(u1);
                    converter.step(&mut state, word)
                });
            }
        }
    }
}

fn holds_and_switches<S: Real>() {
    for time in TIMES {
        let hold = SampleHoldLaw { acquisition: time, aperture: 0.0, jitter: 0.0, pedestal: 0.0, droop: 0.0 };
        let (hold, mut y) = (SampleHold::<S>::new(H, &hold), S::ZERO);
        drive(&format!("sample-and-hold, {time:e}"), 1.0, |n, u0, u1| {
            y = if n % 3 == 0 { hold.tracked(y, u0, u1, 0.4) } else { hold.track(y, u0, u1) };
            hold.held(y, u0)
        });
        let (switch, mut fade) = (Switch::<S>::new(&SwitchLaw::default()), Fade::default());
        fade.follow(false, (1..400).map(|n| f64::from(n) * 2.3), time / H);
        drive(&format!("switch, {time:e}"), 1.0, |n, u0, u1| {
            let [before, after] = fade.at(n as f64).map(S::from_f64);
            switch.output(before, u0, u1) + switch.output(after, u0, u1) - switch.output(before, u0, u1)
        });
        let (leak, mut x) = (HighPass::<S>::new(H, time), S::ZERO);
        drive(&format!("high pass, {time:e}"), 2.0, |_, u0, u1| {
            x = leak.step(x, u0, u1);
            x
        });
        let (noise, mut x) = (BandNoise::<S>::new(H, time, 0.1), S::ZERO);
        drive(&format!("noise, {time:e}"), 2.0, |_, _, u1| {
            x = noise.step(x, u1);
            x
        });
    }
}

fn comparators<S: Real>() {
    for hysteresis in [0.0, 1e-3, 5.0, f64::INFINITY] {
        for delay in TIMES {
            for (overdrive, noise) in [(0.0, 0.0), (1e-11, 1e-3), (f64::INFINITY, 10.0), (0.0, 10.0)] {
                let law = ComparatorLaw { offset: 0.0, hysteresis, delay, overdrive, longest: 500e-9, noise };
                let comparator = Comparator::<S>::new(H, &law, NoiseSource::new(1, "comparator", 0));
                let (mut state, mut trips) = (ComparatorState::default(), Vec::new());
                drive(&format!("{law:?}"), 0.0, |n, u0, u1| {
                    comparator.step(&mut state, (0, n as usize), u0, u1, &mut trips);
                    S::ZERO
                });
                assert!(trips.len() as u64 <= 2 * STEPS);
                assert!(trips.iter().all(|trip| !trip.at.0.is_nan()), "{law:?}");
                assert!(trips.windows(2).all(|pair| pair[0].high != pair[1].high));
            }
        }
    }
}

fn all<S: Real>() {
    lags::<S>();
    second_orders::<S>();
    amplifiers::<S>();
    differentiators::<S>();
    converters::<S>();
    holds_and_switches::<S>();
    comparators::<S>();
}

#[test]
fn every_part_at_its_extremes_in_double() {
    all::<f64>();
}

#[test]
fn every_part_at_its_extremes_in_single() {
    all::<f32>();
}

#[test]
fn delays_at_their_extremes() {
    for time in TIMES {
        let delay = Delay::new(H, time);
        assert!((0.0..1.0).contains(&delay.share));
    }
}
