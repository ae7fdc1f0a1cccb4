//! Chatter of the derivative over flat far ground: A16.

use parts::differentiated_noise;
use scenario::Occlusion;
use signal::LANES;

use super::{H, parts, run};
use crate::Driven;

const SAMPLES: usize = 4000;
/// Full scale 10 V, 0.1 mV of noise: a slope of five sigma stays within the field.
const NOISE: f64 = 1e-5;

/// Sigma of the derivative (shares a step).
fn sigma() -> f64 {
    differentiated_noise(NOISE, 10e6) * H
}

fn noisy(occlusion: Occlusion, slope: f64, hysteresis: f64) -> Driven<f64> {
    let faulty = parts(|parts| {
        parts.full_scale = 10.0;
        parts.amplifier.noise = 10.0 * NOISE;
        parts.comparator.hysteresis = hysteresis;
    });
    run(occlusion, &faulty, SAMPLES, |k| -0.5 + slope * k)
}

/// Blankings a sample, over all lanes.
fn blankings(out: &Driven<f64>) -> f64 {
    let all: usize = out.on.iter().map(|on| on.len() - 1).sum();
    all as f64 / (LANES * SAMPLES) as f64
}

/// Probability that a deviate is beyond `z`.
fn beyond(z: f64) -> f64 {
    0.5 * libm::erfc(z / 2.0_f64.sqrt())
}

#[test]
fn drop_outs_begin_where_the_slope_is_below_three_sigma() {
    for (slope, most, least) in [(5.0, 1e-4, 0.0), (3.0, 4e-3, 2e-4), (2.0, 0.03, 0.01), (1.0, 0.16, 0.08)] {
        let rate = blankings(&noisy(Occlusion::Derivative, slope * sigma(), 0.0));
        assert!(rate <= most && rate >= least, "{slope} sigma: {rate} blankings a sample, {}", beyond(slope));
    }
}

#[test]
fn hysteresis_of_three_sigma_ends_it() {
    // In the derivative's own full scale: tau_d = 100 ns is two samples.
    let flat = |sigmas: f64| blankings(&noisy(Occlusion::Derivative, 0.0, sigmas * sigma() * 2.0));
    assert!(flat(0.0) > 0.01, "{}", flat(0.0));
    assert!(flat(3.0) < 2.0 * beyond(3.0), "{}", flat(3.0));
    assert!(flat(4.5) < 1e-4, "{}", flat(4.5));
}

#[test]
fn what_stops_it_misses_shallow_hollows() {
    let shallow = 2.0 * sigma();
    let hollow = |k: f64| 0.1 + if k < 400.0 { 0.0 } else { -shallow * (k - 400.0).min(100.0) };
    let quiet = parts(|parts| parts.comparator.hysteresis = 2.0 * 3.0 * sigma());
    assert_eq!(run(Occlusion::Derivative, &quiet, 600, hollow).on[0], vec![[0.0, 599.0]]);
    let sharp = parts(|parts| parts.comparator.hysteresis = 2.0 * sigma());
    assert_eq!(run(Occlusion::Derivative, &sharp, 600, hollow).on[0].len(), 1);
    assert!((run(Occlusion::Derivative, &sharp, 600, hollow).on[0][0][1] - 400.0).abs() < 1.0);
}

#[test]
fn a_peak_detector_does_not_chatter() {
    let rate = blankings(&noisy(Occlusion::PeakHold, 0.1 * sigma(), 0.0));
    assert_eq!(rate, 0.0);
}

#[test]
fn noise_is_a_matter_of_the_sweep() {
    let out = noisy(Occlusion::Derivative, sigma(), 0.0);
    assert_ne!(out.on[0], out.on[1]);
    assert_eq!(out.on, noisy(Occlusion::Derivative, sigma(), 0.0).on);
}
