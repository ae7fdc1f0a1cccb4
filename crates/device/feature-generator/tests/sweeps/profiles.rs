//! Height and slopes of the features along sweeps.

use crate::common::{Sweep, bowl, expected, nearest_kink, program, ranges, rimmed, run, scene, sweeps};
use feature_generator::{FeatureGenerator, FeatureProfile};
use features::{Crater, Features, Shape};
use hardware_model::FeatureParts;
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
use signal::Real;

/// Full scale of height (m) and of slope at a place: what all craters together could add, at least 1.
fn full_scale(features: &Features) -> [f64; 3] {
    let sum =
        |of: fn(&Crater) -> f64| features.craters().iter().map(|crater| of(&crater)).sum::<f64>().max(1.0);
    let slope = sum(Crater::steepest);
    [sum(|crater| crater.depth() + crater.rim()), slope, slope]
}

fn signals<S: Real>(profile: &FeatureProfile<S>, sample: usize, lane: usize) -> [f64; 3] {
    [&profile.height, &profile.along, &profile.across].map(|signal| signal[sample][lane].to_f64())
}

#[test]
fn check_table_23_4_along_sweeps() {
    let t1 = Crater::new([0.0; 2], Shape::Bowl { r1: 100.0 }, 20.0, 0.0).unwrap();
    let t2 = rimmed([0.0; 2], 100.0, 140.0, 20.0, 6.0);
    let t3 = Crater::new([0.0; 2], Shape::FlatFloor { r1: 40.0, r2: 100.0, r3: 140.0 }, 20.0, 6.0).unwrap();
    let rows = [
        ([30.0, 40.0], t1, [-15.0, 0.12, 0.16]),
        ([30.0, 40.0], t2, [-15.0, 0.12, 0.16]),
        ([30.0, 40.0], t3, [-19.44444444444444, 0.06666666666666667, 0.08888888888888889]),
        ([3.0, 4.0], t2, [-19.95, 0.012, 0.016]),
        ([3.0, 4.0], t3, [-20.0, 0.0, 0.0]),
        ([66.0, 88.0], t1, [0.0, 0.0, 0.0]),
        ([66.0, 88.0], t2, [4.5, 0.18, 0.24]),
        ([66.0, 88.0], t3, [4.5, 0.18, 0.24]),
        ([100.0, 75.0], t2, [5.625, -0.12, -0.09]),
        ([100.0, 75.0], t3, [5.625, -0.12, -0.09]),
        ([0.0, 119.0], t3, [5.985, 0.0, 0.03]),
    ];
    for (at, crater, expected) in rows {
        let features = Features::new(vec![crater]);
        // Eight ways to the place, 300 m each.
        let way = |lane: usize| {
            let angle = 0.7 * lane as f64;
            let (sin, cos) = quantities::sin_cos(angle);
            ([at[0] - 300.0 * cos, at[1] - 300.0 * sin], angle)
        };
        let sweeps: [Sweep; 8] = std::array::from_fn(way);
        let mut profile = FeatureProfile::<f64>::default();
        run(&features, &sweeps, &[10.0, 300.0, 301.0], &mut profile);
        for (lane, (_, angle)) in sweeps.into_iter().enumerate() {
            let [height, along, across] = signals(&profile, 1, lane);
            let (sin, cos) = quantities::sin_cos(angle);
            let found = [height, along * cos - across * sin, along * sin + across * cos];
            let near =
                found.into_iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12);
            assert!(near, "{crater:?} at {at:?}, lane {lane}: {found:?}");
            assert_eq!(profile.present[1][lane], if at == [66.0, 88.0] && crater == t1 { 0.0 } else { 1.0 });
        }
    }
}

proptest! {
    /// Every sample of every lane is what the landscape has there: to 1e-12 of full scale in f64, to 2e-5 in f32.
    #[test]
    fn lanes_are_the_landscape(features in scene(), sweeps in sweeps()) {
        let ranges = ranges();
        let (mut double, mut single) = (FeatureProfile::<f64>::default(), FeatureProfile::<f32>::default());
        run(&features, &sweeps, &ranges, &mut double);
        run(&features, &sweeps, &ranges, &mut single);
        let scale = full_scale(&features);
        for (lane, sweep) in sweeps.into_iter().enumerate() {
            for (sample, &range) in ranges.iter().enumerate() {
                if nearest_kink(&features, sweep, range) < 1e-9 {
                    continue;
                }
                let expected = expected(&features, sweep, range);
                let (exact, rounded) = (signals(&double, sample, lane), signals(&single, sample, lane));
                for signal in 0..3 {
                    prop_assert!((exact[signal] - expected[signal]).abs() < 1e-12 * scale[signal]);
                    prop_assert!((rounded[signal] - expected[signal]).abs() < 2e-5 * scale[signal]);
                }
                let (sin, cos) = quantities::sin_cos(sweep.1);
                let present = features.at(sweep.0[0] + range * cos, sweep.0[1] + range * sin).present;
                prop_assert_eq!(double.present[sample][lane], f64::from(u8::from(present)));
            }
        }
    }

    /// A used profile forgets what was in it.
    #[test]
    fn runs_repeat_to_the_bit(first in scene(), second in scene(), sweeps in sweeps()) {
        let (mut fresh, mut used) = (FeatureProfile::<f32>::default(), FeatureProfile::<f32>::default());
        run(&first, &sweeps, &ranges(), &mut fresh);
        run(&second, &sweeps, &ranges()[..100], &mut used);
        run(&first, &sweeps, &ranges(), &mut used);
        prop_assert_eq!(&fresh.height, &used.height);
        prop_assert_eq!(&fresh.along, &used.along);
        prop_assert_eq!(&fresh.across, &used.across);
        prop_assert_eq!(&fresh.present, &used.present);
        prop_assert_eq!(&fresh.kinks, &used.kinks);
    }
}

#[test]
fn a_hundred_nested_craters_add_up() {
    let features = Features::new((1..=100).map(|k| bowl([50.0, 0.0], 0.4 * f64::from(k))).collect());
    let mut profile = FeatureProfile::<f64>::default();
    run(&features, &[([0.0, 0.0], 0.0); 8], &[1.0, 50.0, 120.0], &mut profile);
    let depth = (1..=100).map(|k| 0.08 * f64::from(k)).sum::<f64>();
    assert!((profile.height[1][3] + depth).abs() < 1e-12 * depth);
    assert_eq!(profile.kinks[3].len(), 200);
}

#[test]
fn far_away_single_precision_keeps_its_millimetres() {
    let features = Features::new(vec![rimmed([49_999.3, 0.2], 3.0, 4.2, 1.0, 0.2)]);
    let ranges: Vec<f64> = (0..100).map(|sample| 49_995.0 + 0.1 * f64::from(sample)).collect();
    let mut profile = FeatureProfile::<f32>::default();
    run(&features, &[([0.0, 0.0], 0.0); 8], &ranges, &mut profile);
    for (sample, &range) in ranges.iter().enumerate() {
        let expected = features.at(range, 0.0).height;
        assert!((f64::from(profile.height[sample][0]) - expected).abs() < 1e-6, "{range}");
    }
}

#[test]
fn nothing_is_drawn_beyond_the_end() {
    let features = Features::new(vec![bowl([50.0, 0.0], 20.0)]);
    let ranges: Vec<f64> = (1..100).map(f64::from).collect();
    let programs =
        [50.0; 8].map(|end| program(&features, FeatureParts::default(), ([0.0; 2], 0.0), [0.0, end]));
    let mut profile = FeatureProfile::<f64>::default();
    FeatureGenerator { ranges: &ranges }.run(&features, &programs, &mut profile);
    assert_eq!(profile.height[49][0], -4.0);
    assert!(profile.height[50..].iter().all(|sample| sample[0] == 0.0));
    assert_eq!(profile.kinks[0].len(), 1);
}
