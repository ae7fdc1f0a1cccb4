//! Smoother, multiplier, comparator and sample-and-hold in a chain, against the integrator and against ngspice.

mod circuit;

use std::path::Path;
use std::process::Command;

use crate::assert_near;
use crate::runge_kutta::integrate;

use circuit::{
    B, DELAY, MULTIPLIER, Outputs, RASTER, RISE, SMOOTHER, Stepped, TAU_H, TAU_M, THRESHOLD, netlist,
};

/// Rasters up to the time at which all is looked at: the first triangle still rises.
const TIMES: usize = 31;
const END: f64 = 1.5e-6;

/// What is looked at.
#[derive(Debug)]
struct Seen {
    /// Multiplier's output at the end.
    m: f64,
    /// When the comparator trips (s).
    trip: f64,
    /// Value that the sample-and-hold holds.
    held: f64,
}

/// The first of eight chains side by side.
fn by_parts(a_raster: usize) -> Seen {
    let mut out = Outputs::<f64>::default();
    Stepped::new(a_raster, TIMES).run(&mut out);
    assert!((RASTER * (TIMES - 1) as f64 - END).abs() < 1e-15);
    let &[(trip, held)] = &out.held[0][..] else { panic!("{:?}", out.held[0]) };
    Seen { m: out.m[TIMES - 1][0], trip, held }
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
    for (a_raster, off) in [(1, 3e-5), (5, 1.2e-6)] {
        let seen = by_parts(a_raster);
        assert_near(seen.m, integrated(END)[2], off);
        assert_near(seen.trip * 1e6, trip * 1e6, off * 2.0);
        assert_near(seen.held, integrated(trip)[3], off);
    }
}

/// Each chain does what the first does, later: five rasters, a whole number of steps.
#[test]
fn chains_side_by_side_do_the_same_later() {
    let mut out = Outputs::<f64>::default();
    Stepped::new(1, 2 * TIMES).run(&mut out);
    for chain in 1..8 {
        let times = 0..2 * TIMES - 5 * chain;
        let late = |n: usize| (out.m[n][0] - out.m[n + 5 * chain][chain]).abs();
        // Before its triangle begins a lag has the errors of the product at 0.
        let most = times.map(late).fold(0.0, f64::max);
        assert!(most < 2e-3, "chain {chain}: {most}");
        let by = |chain: usize, n: usize| out.held[chain][n];
        let ((first, held), (later, value)) = (by(0, 0), by(chain, 0));
        assert!((later - first - 0.25e-6 * chain as f64).abs() < 1e-10, "chain {chain}: {first}, {later}");
        assert!((value - held).abs() < 1e-4, "chain {chain}: {held}, {value}");
    }
}

#[test]
fn as_ngspice_has_it() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("chain.cir");
    let analysis = format!(
        ".options reltol=1e-6 abstol=1e-14 vntol=1e-9
.tran 0.02n {END:e} 0 0.02n uic
.meas tran m FIND v(m0) AT={last:e}
.meas tran passing WHEN v(m0)={THRESHOLD} RISE=1
.meas tran held FIND v(held0) AT={last:e}
.end
",
        last = END * 0.999_999,
    );
    std::fs::write(&path, netlist(1) + &analysis).expect("the target folder can be written");
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
    let seen = by_parts(5);
    // It prints seven digits; its switch opens within a step of 20 ps.
    assert_near(measured("m"), seen.m, 2e-6);
    assert_near((measured("passing") + DELAY) * 1e9, seen.trip * 1e9, 2e-3);
    assert_near(measured("held"), seen.held, 5e-6);
}
