//! Parts without faults do what the ideal processor does.

use std::f64::consts::TAU;

use hardware_model::AnalogParts;
use proptest::prelude::{prop_assert, proptest};
use scenario::{Curvature, Occlusion};
use signal::{Breaks, LANES, Lanes};

use super::{BOTH, Driven, H, HALF, LINES, PartsProcessor, Scratch, level, parts, run, run_by};
use crate::{Processor, Projected};

const SAMPLES: usize = 300;

fn ideal(occlusion: Occlusion, share: impl Fn(f64) -> f64) -> Projected<f64> {
    let ranges: Vec<f64> = (0..SAMPLES).map(|k| 1.0 + 1e-6 * k as f64).collect();
    let height: Vec<_> =
        ranges.iter().enumerate().map(|(k, z)| Lanes::splat(HALF * share(k as f64) * z)).collect();
    let mut out = Projected::default();
    Processor::new(occlusion, Curvature::None, &ranges).run(&height, &[level(); LANES], &mut out);
    out
}

fn is_on(out: &Driven<f64>, sample: usize) -> bool {
    out.on[0].iter().any(|&[begin, end]| begin <= sample as f64 && sample as f64 <= end)
}

/// What the comparator of falls sees; of peak-hold there is no such wire.
#[test]
fn the_derivative_of_a_slope_is_its_rate() {
    let share = |k: f64| if k < 100.0 { 0.001 * k } else { 0.1 - 0.002 * (k - 100.0) };
    let (processor, out) = run_by(Occlusion::Derivative, &AnalogParts::ideal(), SAMPLES, share);
    let rates = processor.derivative(&out, 3).unwrap();
    assert_eq!(rates.len(), SAMPLES);
    for (sample, rate) in rates.into_iter().enumerate().filter(|(k, _)| !(98..103).contains(k) && *k > 2) {
        let expected = HALF / H * if sample < 100 { 0.001 } else { -0.002 };
        assert!((rate / expected - 1.0).abs() < 1e-9, "{rate} at {sample}, expected {expected}");
    }
    let (processor, out) = run_by(Occlusion::PeakHold, &AnalogParts::ideal(), SAMPLES, share);
    assert_eq!(processor.derivative(&out, 3), None);
}

proptest! {
    /// Waves of 25 samples and more: the straight lines between samples are within `bend / 8` of them.
    #[test]
    fn the_same_ground_is_hidden(
        amplitudes in proptest::array::uniform3(0.0..0.15_f64),
        phases in proptest::array::uniform3(0.0..6.3_f64),
        rise in 0.0..0.002_f64,
    ) {
        let lengths = [25.0, 60.0, 140.0];
        let wave = |k: f64, n: usize| amplitudes[n] * libm::sin(phases[n] + TAU * k / lengths[n]);
        let share = |k: f64| -0.3 + rise * k + wave(k, 0) + wave(k, 1) + wave(k, 2);
        let bend: f64 = (0..3).map(|n| amplitudes[n] * (TAU / lengths[n]) * (TAU / lengths[n])).sum();
        for occlusion in BOTH {
            let (clean, made) = (ideal(occlusion, share), run(occlusion, &AnalogParts::ideal(), SAMPLES, share));
            for k in 1..SAMPLES {
                let (now, before) = (clean.elevation[k][0] / HALF, clean.hold[k - 1][0] / HALF);
                if now < before - 0.5 * bend {
                    prop_assert!(!is_on(&made, k), "{occlusion:?} on at {k}: {:?}", made.on[0]);
                }
                if now > before + 0.5 * bend {
                    prop_assert!(is_on(&made, k), "{occlusion:?} off at {k}: {:?}", made.on[0]);
                }
                prop_assert!((made.position[k][0] - clean.position[k][0]).abs() < 1e-9 || clean.position[k][0] > LINES);
            }
        }
    }
}

/// The beam comes on within one step, and the next begins where the hold is above the sample by rounding.
#[test]
fn a_beam_that_has_come_on_stays_on() {
    let waves = [
        (0.095_420_361_674_548_86, 0.660_390_055_537_972_3, 25.0),
        (0.082_699_033_641_610_84, 1.055_653_617_680_887_5, 60.0),
    ];
    let last = (0.008_938_264_915_835_666, 5.301_833_912_538_777, 140.0);
    let share = |k: f64| {
        let wave =
            |&(amplitude, phase, length): &(f64, f64, f64)| amplitude * libm::sin(phase + TAU * k / length);
        -0.3 + 0.001_559_796_196_495_943_4 * k + wave(&waves[0]) + wave(&waves[1]) + wave(&last)
    };
    let made = run(Occlusion::PeakHold, &AnalogParts::ideal(), SAMPLES, share);
    let [from, to] = made.on[0][made.on[0].len() - 1];
    assert!(from > 297.8 && from < 298.0 && to == 299.0, "{:?}", made.on[0]);
}

#[test]
fn intensity_is_not_delayed() {
    let out = run(Occlusion::Derivative, &AnalogParts::ideal(), 50, |_| 0.0);
    assert!(out.intensity.iter().enumerate().all(|(k, value)| value[0] == k as f64 / 50.0));
    assert_eq!(out.on[0], vec![[0.0, 49.0]]);
}

#[test]
fn a_bow_moves_the_middle_of_the_field_and_not_its_edges() {
    let bowed = parts(|parts| parts.projection.error = 0.01);
    let at = |share: f64| run(Occlusion::PeakHold, &bowed, 2, |_| share);
    let line = |share: f64| at(share).position[0][0] - 250.0 * (1.0 - share);
    assert!(line(1.0).abs() < 1e-9 && line(-1.0).abs() < 1e-9);
    let elevation = at(0.0).elevation[0][0] / HALF;
    assert!(elevation.abs() > 1e-4 && elevation.abs() < 0.04);
    assert!(line(0.0).abs() > 0.02 && line(0.0).abs() < 20.0, "{}", line(0.0));
    // Beyond the field both are as without it.
    assert_eq!(at(1.05).elevation[0][0], 1.05 * HALF);
}

#[test]
fn parts_are_drawn_once_and_apart() {
    let spread = parts(|parts| {
        parts.spread = true;
        parts.comparator.delay = 40e-9;
        parts.projection.bandwidth = Some(8e6);
    });
    let share = |k: f64| 0.5 - 0.002 * (k - 100.0) * (k - 100.0);
    let ranges: Vec<f64> = (0..SAMPLES).map(|k| 1.0 + 1e-6 * k as f64).collect();
    let height: Vec<_> = (0..SAMPLES).map(|k| Lanes::splat(HALF * share(k as f64))).collect();
    let edge = |seed: u64| {
        let law = (Occlusion::Derivative, Curvature::None);
        let made = PartsProcessor::new(law, &ranges, LINES, H, &spread, seed);
        let mut out = Driven::default();
        made.run(
            &height,
            (&height, &Breaks::default()),
            &[level(); LANES],
            &[0; LANES],
            &mut Scratch::default(),
            &mut out,
        );
        out.on[0][0][1]
    };
    assert_eq!(edge(7), edge(7));
    assert_ne!(edge(7), edge(8));
    // 40 +- 10 ns are 0.8 +- 0.2 steps, and the lags differ by 20 % of a third of a step each.
    assert!((1..20).all(|seed| (edge(seed) - 102.2).abs() < 2.5));
}
