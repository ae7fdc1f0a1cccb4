//! Chatter of the derivative over flat far ground: A16.

use parts::differentiated_noise;
use scenario::Occlusion;
use signal::LANES;

use super::{H, parts, run};
use crate::Driven;
use crate::of_parts::figures::DERIVATIVE;

const SAMPLES: usize = 4000;
/// Full scale 10 V, 0.1 mV of noise: a slope of five sigma stays within the field.
const NOISE: f64 = 1e-5;

/// The derivative's own full scale, for a share of the elevation a step.
const OF_FULL_SCALE: f64 = DERIVATIVE / H;

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
    // The comparator trips with the probability p of a deviate beyond the slope, and back with 1 - p; it counts as
    // one drop-out where two follow before the elevation is back at the hold.
    for slope in [1.0, 2.0, 3.0, 5.0] {
        let p = beyond(slope);
        let (rate, expected) =
            (blankings(&noisy(Occlusion::Derivative, slope * sigma(), 0.0)), p * (1.0 - p));
        let chance = 4.0 * (expected / (LANES * SAMPLES) as f64).sqrt();
        println!("{slope} sigma: {rate} blankings a sample, {expected}");
        assert!(
            rate < expected + chance && rate > 0.75 * expected - chance,
            "{slope} sigma: {rate}, {expected}"
        );
    }
}

#[test]
fn a_narrow_processor_has_the_noise_of_its_band() {
    let band = 2.5e6;
    let narrow = parts(|parts| {
        parts.amplifier.noise = NOISE;
        parts.projection.bandwidth = Some(band);
    });
    let sigma = differentiated_noise(0.5 * NOISE, band) * H;
    let out = run(Occlusion::Derivative, &narrow, SAMPLES, |k| -0.5 + 2.0 * sigma * k);
    let p = beyond(2.0);
    assert!((blankings(&out) / (p * (1.0 - p)) - 0.9).abs() < 0.2, "{}", blankings(&out) / p);
}

#[test]
fn hysteresis_of_three_sigma_ends_it() {
    let flat = |sigmas: f64| blankings(&noisy(Occlusion::Derivative, 0.0, sigmas * sigma() * OF_FULL_SCALE));
    assert!(flat(0.0) > 0.01, "{}", flat(0.0));
    assert!(flat(3.0) < 2.0 * beyond(3.0), "{}", flat(3.0));
    assert!(flat(4.5) < 1e-4, "{}", flat(4.5));
}

#[test]
fn the_nominal_hysteresis_is_three_sigma() {
    let sigma = differentiated_noise(0.5e-3 / 10.0 * 0.8_f64.sqrt(), 8e6) * DERIVATIVE;
    assert!((0.001 / sigma - 3.0).abs() < 0.1, "{}", 0.001 / sigma);
}

#[test]
fn what_stops_it_misses_shallow_hollows() {
    let shallow = 2.0 * sigma();
    let hollow = |k: f64| 0.1 + if k < 400.0 { 0.0 } else { -shallow * (k - 400.0).min(100.0) };
    let quiet = parts(|parts| parts.comparator.hysteresis = 3.0 * sigma() * OF_FULL_SCALE);
    assert_eq!(run(Occlusion::Derivative, &quiet, 600, hollow).on[0], vec![[0.0, 599.0]]);
    let sharp = parts(|parts| parts.comparator.hysteresis = sigma() * OF_FULL_SCALE);
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
