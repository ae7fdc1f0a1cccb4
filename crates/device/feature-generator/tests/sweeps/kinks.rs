//! Tests of the kinks that sweeps cross.

use crate::common::{Sweep, bowl, expected, nearest_kink, ranges, rimmed, run, scene, sweeps};
use feature_generator::{FeatureProfile, Kink};
use features::{Crater, Features};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

/// Kinks of one sweep with samples at every whole metre from 1 to 100.
fn kinks(craters: Vec<Crater>, sweep: Sweep) -> Vec<Kink<f64>> {
    let ranges: Vec<f64> = (1..=100).map(f64::from).collect();
    let mut profile = FeatureProfile::default();
    run(&Features::new(craters), &[sweep; 8], &ranges, &mut profile);
    profile.kinks[5].clone()
}

fn assert_near(found: [f64; 2], expected: [f64; 2]) {
    assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 1e-12), "{found:?} against {expected:?}");
}

#[test]
fn a_crater_hit_in_the_middle() {
    // Rim slopes 4 delta / (r2 - r1) = 1, bowl slope 2 a / r1 = 0.4.
    let found = kinks(vec![rimmed([50.5, 0.0], 10.0, 14.0, 2.0, 1.0)], ([0.0; 2], 0.0));
    let rows = [
        (36.5, 0.0, 1.0, [false, true]),
        (40.5, -1.0, -0.4, [true, true]),
        (60.5, 0.4, 1.0, [true, true]),
        (64.5, -1.0, 0.0, [true, false]),
    ];
    assert_eq!(found.len(), rows.len());
    for (kink, (range, before, after, present)) in found.iter().zip(rows) {
        assert_eq!((kink.range, kink.sample, kink.share), (range, range as usize, 0.5));
        assert_near(kink.before, [before, 0.0]);
        assert_near(kink.after, [after, 0.0]);
        assert_near([kink.height, 0.0], [0.0; 2]);
        assert_eq!(kink.present, present);
    }
}

#[test]
fn a_crater_hit_beside_the_middle() {
    // Centre 12 m to the right: the sweep stays on the rim. Outer slope -1, outwards.
    let found =
        kinks(vec![rimmed([12.0, -50.0], 10.0, 14.0, 2.0, 1.0)], ([0.0; 2], 1.5 * std::f64::consts::PI));
    let half = 52.0_f64.sqrt();
    assert_eq!(found.len(), 2);
    assert_near([found[0].range, found[1].range], [50.0 - half, 50.0 + half]);
    assert_near(found[0].after, [half / 14.0, 12.0 / 14.0]);
    assert_near(found[1].before, [-half / 14.0, 12.0 / 14.0]);
    assert_near(found[1].after, [0.0, 0.0]);
}

#[test]
fn a_touch_is_no_kink() {
    let crater = |side: f64| vec![rimmed([50.0, side], 10.0, 14.0, 2.0, 1.0)];
    let count = |side: f64| kinks(crater(side), ([0.0; 2], 0.0)).len();
    assert_eq!([14.0, 13.999, 10.0, 9.999].map(count), [0, 2, 2, 4]);
}

#[test]
fn kinks_at_one_range_both_stand() {
    let twins = vec![bowl([50.0, 6.0], 10.0), bowl([50.0, -6.0], 10.0)];
    let found = kinks(twins, ([0.0; 2], 0.0));
    assert_eq!(found.iter().map(|kink| kink.range).collect::<Vec<_>>(), [42.0, 42.0, 58.0, 58.0]);
    assert_near(found[0].before, [0.0, 0.0]);
    // Slope 0.4 outwards at (-8, 6) / 10 from the first centre.
    assert_near(found[0].after, [-0.32, -0.24]);
    assert_near(found[1].before, [-0.32, -0.24]);
    assert_near(found[1].after, [-0.64, 0.0]);
    // One is left in the instant in which the next is entered.
    let row = vec![bowl([20.0, 0.0], 10.0), bowl([40.0, 0.0], 10.0)];
    let found = kinks(row, ([0.0; 2], 0.0));
    assert_near([found[1].range, found[2].range], [30.0, 30.0]);
    assert!((found[1].sample, found[1].share) == (29, 1.0) && (found[2].sample, found[2].share) == (30, 0.0));
    assert_eq!((found[1].present, found[2].present), ([true, false], [false, true]));
}

#[test]
fn circles_that_rounding_joins_are_passed_in_order() {
    // A rim of one unit in the last place: both circles are crossed at the same range.
    let crater = rimmed([50.0, 0.0], 1.0, 1.0 + f64::EPSILON, 0.2, 0.1);
    let found = kinks(vec![crater], ([0.0; 2], 0.0));
    assert_eq!(found.iter().map(|kink| kink.range).collect::<Vec<_>>(), [49.0, 49.0, 51.0, 51.0]);
    assert!(!found[0].present[0] && !found[3].present[1]);
    assert_eq!(found[3].after, [0.0; 2]);
}

#[test]
fn kinks_without_samples_on_both_sides_are_left_out() {
    let near = kinks(vec![bowl([0.0, 0.0], 0.5)], ([0.0; 2], 0.0));
    assert!(near.is_empty(), "{near:?}");
    let far = kinks(vec![bowl([105.0, 0.0], 10.0)], ([0.0; 2], 0.0));
    assert_eq!(far.iter().map(|kink| kink.range).collect::<Vec<_>>(), [95.0]);
}

/// How often a sweep crosses the circles of craters between two ranges.
fn crossings(features: &Features, (eye, angle): Sweep, [from, to]: [f64; 2]) -> usize {
    let (sin, cos) = quantities::sin_cos(angle);
    let of = |crater: &Crater| {
        let [dx, dy] = [0, 1].map(|axis| crater.centre()[axis] - eye[axis]);
        let (middle, side) = (dx * cos + dy * sin, dy * cos - dx * sin);
        let half = |radius: f64| (radius * radius - side * side).sqrt();
        let ends = crater.kinks().flat_map(|kink| [middle - half(kink), middle + half(kink)]);
        // A circle beside the sweep has its ends at NaN.
        ends.filter(|range| *range > from && *range < to).count()
    };
    features.craters().iter().map(|crater| of(&crater)).sum()
}

proptest! {
    /// All kinks are there, in order, and on both sides of each stands what the landscape has there.
    #[test]
    fn kinks_are_those_of_the_landscape(features in scene(), sweeps in sweeps()) {
        let ranges = ranges();
        let mut profile = FeatureProfile::<f64>::default();
        run(&features, &sweeps, &ranges, &mut profile);
        for (lane, sweep) in sweeps.into_iter().enumerate() {
            let kinks = &profile.kinks[lane];
            prop_assert_eq!(kinks.len(), crossings(&features, sweep, [ranges[0], ranges[ranges.len() - 1]]));
            let place = |kink: &Kink<f64>| (kink.range, kink.sample, kink.share);
            prop_assert!(kinks.windows(2).all(|pair| place(&pair[0]) <= place(&pair[1])));
            for kink in kinks {
                let (near, far) = (ranges[kink.sample - 1], ranges[kink.sample]);
                prop_assert!((near + kink.share * (far - near) - kink.range).abs() < 1e-9);
                for (side, slopes) in [(-1e-6, kink.before), (1e-6, kink.after)] {
                    let range = kink.range + side;
                    // Another kink, or a chord so short that it bends within a micrometre.
                    if nearest_kink(&features, sweep, range) < 1e-9 || kinks.iter().any(|other| {
                        other != kink && (other.range - kink.range).abs() < 1e-5
                    }) {
                        continue;
                    }
                    let [height, along, across] = expected(&features, sweep, range);
                    prop_assert!((height - kink.height).abs() < 1e-4);
                    prop_assert!((along - slopes[0]).abs() < 1e-3, "{} {:?}", along, kink);
                    prop_assert!((across - slopes[1]).abs() < 1e-3, "{} {:?}", across, kink);
                }
            }
        }
    }
}
