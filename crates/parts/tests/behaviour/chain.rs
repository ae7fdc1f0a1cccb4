//! Smoother, multiplier, comparator and sample-and-hold in a chain, against the integrator and against ngspice.
//!
//! ```text
//! ramp u ─▶ smoother ─▶ a ─┐
//! constant b ──────────────┴▶ multiplier ─▶ lag ─▶ m ─┬▶ sample-and-hold ─▶ held
//!                                                     └▶ comparator ──────────┘ command
//! ```

use std::path::Path;
use std::process::Command;

use parts::{
    Comparator, ComparatorLaw, ComparatorState, LagStep, Multiplier, MultiplierLaw, NoiseSource, SampleHold,
    SampleHoldLaw, SecondOrder, SecondOrderState,
};

use crate::assert_near;
use crate::runge_kutta::integrate;

const RISE: f64 = 2e-6;
const END: f64 = 1.5e-6;
const B: f64 = 0.9;
const SMOOTHER: SecondOrder = SecondOrder { natural: 1.6 / 40e-9, damping: 0.8 };
const TAU_M: f64 = 20e-9;
const MULTIPLIER: MultiplierLaw =
    MultiplierLaw { gain: 0.002, feed_a: 0.003, feed_b: -0.002, offset: 0.001, nonlinearity: 0.0025 };
const THRESHOLD: f64 = 0.4;
const DELAY: f64 = 40e-9;
const HOLD: SampleHoldLaw =
    SampleHoldLaw { acquisition: 400e-9, aperture: 0.0, jitter: 0.0, pedestal: 0.0, droop: 0.0 };
/// 400 ns over ln 1000.
const TAU_H: f64 = 400e-9 / 6.907_755_278_982_137;

/// What is looked at.
#[derive(Debug)]
struct Seen {
    /// Multiplier's output at the end.
    m: f64,
    /// When the comparator trips (s).
    trip: f64,
    /// What is held.
    held: f64,
}

fn by_parts(h: f64) -> Seen {
    let smoother = SMOOTHER.step::<f64>(h);
    let multiplier = Multiplier::new(&MULTIPLIER);
    let lag = LagStep::new(h, TAU_M);
    let law = ComparatorLaw {
        offset: THRESHOLD,
        hysteresis: 0.0,
        delay: DELAY,
        overdrive: 0.0,
        longest: 500e-9,
        noise: 0.0,
    };
    let comparator = Comparator::new(h, &law, NoiseSource::new(0, "chain", 0));
    let hold = SampleHold::new(h, &HOLD);
    let (mut a, mut m, mut tracked) = (SecondOrderState::default(), vec![0.0], vec![0.0]);
    let (mut state, mut trips) = (ComparatorState::default(), Vec::new());
    let mut product = multiplier.product(0.0, B);
    for n in 1..=(END / h).round() as usize {
        a = smoother.step(a, (n - 1) as f64 * h / RISE, n as f64 * h / RISE);
        let next = multiplier.product(a.y, B);
        m.push(lag.step(m[n - 1], product, next));
        product = next;
        comparator.step(&mut state, (0, n), m[n - 1], m[n], &mut trips);
        tracked.push(hold.track(tracked[n - 1], m[n - 1], m[n]));
    }
    assert_eq!(trips.len(), 1);
    let at = hold.taken_at(trips[0].at, 0.0).0;
    let n = at as usize;
    let held = hold.held(hold.tracked(tracked[n], m[n], m[n + 1], at.fract()), 100.0);
    Seen { m: m[m.len() - 1], trip: trips[0].at.0 * h, held }
}

/// Smoothed ramp and its rate, multiplier, tracked signal at `t`.
fn integrated(t: f64) -> [f64; 4] {
    let (w, z, law) = (SMOOTHER.natural * 1e-6, SMOOTHER.damping, MULTIPLIER);
    // In microseconds.
    integrate([0.0; 4], t * 1e6, 1e-13, |t, &[a, rate, m, held]| {
        let errors = law.feed_a * a + law.feed_b * B + law.offset + law.nonlinearity * a * (1.0 - a * a);
        let product = (1.0 + law.gain) * a * B + errors;
        [
            rate,
            w * w * (t / (RISE * 1e6) - a) - 2.0 * z * w * rate,
            (product - m) / (TAU_M * 1e6),
            (m - held) / (TAU_H * 1e6),
        ]
    })
}

#[test]
fn as_the_integrator_has_it() {
    // The instant at which m passes the threshold, by halving.
    let (mut low, mut high) = (0.0, END);
    for _ in 0..40 {
        let middle = (low + high) / 2.0;
        (low, high) = if integrated(middle)[2] < THRESHOLD { (middle, high) } else { (low, middle) };
    }
    let trip = high + DELAY;
    // The product of a ramp bends between samples: only that is left, and it goes with the square of the step.
    for (h, off) in [(50e-9, 3e-5), (10e-9, 1.2e-6)] {
        let seen = by_parts(h);
        assert_near(seen.m, integrated(END)[2], off);
        assert_near(seen.trip * 1e6, trip * 1e6, off * 2.0);
        assert_near(seen.held, integrated(trip)[3], off);
    }
}

/// The chain as a netlist: an RLC smoother, a formula, RC lags, a delay line, a switch.
fn netlist() -> String {
    let SecondOrder { natural, damping } = SMOOTHER;
    let MultiplierLaw { gain, feed_a, feed_b, offset, nonlinearity } = MULTIPLIER;
    // L = 1 uH: C = 1 / (w^2 L), R = 2 z w L.
    let (c, r) = (1e6 / (natural * natural), 2e-6 * damping * natural);
    format!(
        "smoother, multiplier, comparator, sample-and-hold
Vu u 0 PWL(0 0 {RISE:e} 1)
Rs u s1 {r:e}
Ls s1 a 1e-6
Cs a 0 {c:e}
Bp p 0 V = {scale:e}*V(a) + {feed_a:e}*V(a) + {of_b:e} + {offset:e} + {nonlinearity:e}*V(a)*(1 - V(a)*V(a))
Rm p m1 1000
Cm m1 0 {cm:e} IC=0
Em m 0 m1 0 1
Bc c 0 V = 0.5*(1 - tanh(2e4*(V(m) - {THRESHOLD})))
Rc c c1 50
Tc c1 0 c2 0 Z0=50 TD={DELAY:e}
Rt c2 0 50
Sh m held c2 0 track
Ch held 0 {ch:e} IC=0
.model track SW(vt=0.25 vh=0 ron=1000 roff=1e14)
.options reltol=1e-6 abstol=1e-14 vntol=1e-9
.tran 0.02n {END:e} 0 0.02n uic
.meas tran m FIND v(m) AT={last:e}
.meas tran passing WHEN v(m)={THRESHOLD} RISE=1
.meas tran held FIND v(held) AT={last:e}
.end
",
        scale = (1.0 + gain) * B,
        of_b = feed_b * B,
        cm = TAU_M / 1e3,
        ch = TAU_H / 1e3,
        last = END * 0.999_999,
    )
}

#[test]
fn as_ngspice_has_it() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("chain.cir");
    std::fs::write(&path, netlist()).expect("the target folder can be written");
    let Ok(run) = Command::new("ngspice").arg("-b").arg(&path).output() else {
        println!("skipped: no ngspice here; its netlist is in the target folder");
        return;
    };
    let text = String::from_utf8_lossy(&run.stdout);
    let measured = |name: &str| -> f64 {
        let line = text.lines().find_map(|line| line.trim().strip_prefix(name)?.trim().strip_prefix('='));
        let value = line.and_then(|rest| rest.split_whitespace().next()?.parse().ok());
        value.unwrap_or_else(|| panic!("ngspice says nothing of {name}:\n{text}"))
    };
    let seen = by_parts(10e-9);
    // It prints seven digits; its switch opens within a step of 20 ps.
    assert_near(measured("m"), seen.m, 2e-6);
    assert_near((measured("passing") + DELAY) * 1e9, seen.trip * 1e9, 2e-3);
    assert_near(measured("held"), seen.held, 5e-6);
}
