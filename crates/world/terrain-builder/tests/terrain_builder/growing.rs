//! Ground that grows from control points, and curves of them.

use proptest::prelude::{prop_assert, proptest};
use terrain_builder::{ControlPoint, Growth, GrowthReported, Pick, runs};

use crate::near;

const USUAL: GrowthReported = GrowthReported { is_sum: false, divides_by_between: false };

fn point(north: f64, east: f64, height: f64, weight: f64) -> ControlPoint {
    ControlPoint { at: [north, east], height, weight, initial: 0.0 }
}

/// The points of the check table, in the middle of an area that is so large that no fade reaches them.
fn table() -> Growth {
    Growth {
        area: [[-100.0; 2], [100.0; 2]],
        spacing: 1.0,
        points: vec![point(0.0, 0.0, 10.0, 1.0), point(0.0, 4.0, 6.0, 2.0), point(3.0, 0.0, 0.0, 1.0)],
        curves: vec![],
        iterations: None,
    }
}

#[test]
fn the_means_of_the_check_table_come_out() {
    let (grown, dropped) = table().grown(USUAL).unwrap();
    assert_eq!(dropped, 0);
    // The table has (east, north).
    let rows =
        [([1.0, 1.0], 6.888_888_888_889), ([2.0, 0.0], 6.651_162_790_698), ([4.0, 3.0], 5.337_895_637_297)];
    for ([east, north], expected) in rows {
        near(grown.height([north, east]), expected, 1e-11);
    }
}

#[test]
fn the_sums_of_the_check_table_come_out() {
    let [heights, weights] = table().reported_sums([101, 101]).unwrap();
    near(heights, 8.968_434_407_967, 1e-11);
    near(weights, 1.786_775_908_720, 1e-11);
    let reported = GrowthReported { is_sum: true, ..USUAL };
    let (once, _) = table().grown(reported).unwrap();
    near(once.height([1.0, 1.0]), heights, 1e-12);
    let (thrice, _) = Growth { iterations: Some(3), ..table() }.grown(reported).unwrap();
    near(thrice.height([1.0, 1.0]), 3.0 * heights, 1e-12);
    // At the post of a point the distance counts as one post.
    near(once.height([0.0, 0.0]), 10.0 + 6.0 / 4.0, 1e-12);
}

#[test]
fn a_curve_runs_from_pick_to_pick_and_passes_its_end_as_reported() {
    assert_eq!(runs(2.0, 6.0, 3, false).collect::<Vec<_>>(), [2.0, 3.0, 4.0, 5.0, 6.0]);
    let reported: Vec<_> = runs(2.0, 6.0, 3, true).collect();
    near(reported[4], 22.0 / 3.0, 1e-12);
    assert_eq!(runs(2.0, 6.0, 0, true).collect::<Vec<_>>(), [2.0, 6.0]);
}

#[test]
fn a_curve_holds_every_post_between_its_picks() {
    let pick = |east: f64, height: f64| Pick { at: [0.0, east], height, weight: 1.0 };
    let curves = vec![vec![pick(0.0, 2.0), pick(4.0, 6.0), pick(6.0, 0.0)]];
    let growth = Growth { points: vec![], curves, ..table() };
    let (grown, dropped) = growth.grown(USUAL).unwrap();
    assert_eq!(dropped, 0);
    for (east, expected) in [2.0, 3.0, 4.0, 5.0, 6.0, 3.0, 0.0].into_iter().enumerate() {
        near(grown.height([0.0, east as f64]), expected, 1e-12);
    }
    let reported = GrowthReported { divides_by_between: true, ..USUAL };
    near(growth.grown(reported).unwrap().0.height([0.0, 4.0]), 22.0 / 3.0, 1e-12);
}

#[test]
fn growth_stops_after_any_iteration() {
    let full = table().grown(USUAL).unwrap().0;
    let mut points = table().points;
    points.iter_mut().for_each(|point| point.initial = 4.0);
    for (iterations, share) in [(1, 0.5), (2, 0.75), (5, 1.0 - 1.0 / 32.0)] {
        let (stopped, _) = Growth { iterations: Some(iterations), ..table() }.grown(USUAL).unwrap();
        near(stopped.height([1.0, 1.0]), share * full.height([1.0, 1.0]), 1e-12);
        let raised = Growth { iterations: Some(iterations), points: points.clone(), ..table() };
        let expected = 4.0 + share * (full.height([1.0, 1.0]) - 4.0);
        near(raised.grown(USUAL).unwrap().0.height([1.0, 1.0]), expected, 1e-12);
    }
}

#[test]
fn the_feature_fades_to_nothing_at_its_border() {
    let (grown, _) = table().grown(USUAL).unwrap();
    assert_eq!([[-100.0, 3.0], [20.0, 100.0]].map(|place| grown.height(place)), [0.0; 2]);
    // Half of the fade: t = 0.5, s = 0.5. Without a fade far heights are the weighted mean.
    let inside = grown.height([-80.0, 0.0]);
    let halfway = grown.height([-90.0, 0.0]);
    assert!((halfway / inside - 0.5).abs() < 0.02, "{halfway} of {inside}");
    assert_eq!(grown.height([-100.1, 0.0]), 0.0);
}

#[test]
fn the_last_of_two_points_on_a_post_stays_and_is_told() {
    let points = vec![point(0.0, 0.0, 10.0, 1.0), point(0.2, 0.1, 7.0, 1.0)];
    let (grown, dropped) = Growth { points, ..table() }.grown(USUAL).unwrap();
    assert_eq!(dropped, 1);
    assert_eq!(grown.height([0.0, 0.0]), 7.0);
}

#[test]
fn bad_growth_is_refused_by_its_key() {
    let refused = |growth: Growth| growth.grown(USUAL).expect_err("refused").key;
    assert_eq!(refused(Growth { points: vec![], ..table() }), "points");
    assert_eq!(refused(Growth { points: vec![point(0.0, 0.0, 1.0, 0.0)], ..table() }), "points");
    assert_eq!(refused(Growth { points: vec![point(0.0, 0.0, 1.0, -1.0)], ..table() }), "points");
    assert_eq!(refused(Growth { points: vec![point(0.0, 0.0, f64::NAN, 1.0)], ..table() }), "points");
    assert_eq!(refused(Growth { spacing: 0.0, ..table() }), "spacing_m");
    assert_eq!(refused(Growth { spacing: 0.001, ..table() }), "spacing_m");
    assert_eq!(refused(Growth { iterations: Some(0), ..table() }), "iterations");
    assert_eq!(refused(Growth { area: [[0.0; 2]; 2], ..table() }), "longitude_deg");
}

proptest! {
    /// A weighted mean stays between its heights, and passes through its points.
    #[test]
    fn growth_stays_between_its_points(heights in proptest::collection::vec(-50.0..50.0f64, 1..6), east in -60.0..60.0f64) {
        let points: Vec<_> = heights.iter().enumerate().map(|(k, h)| point(5.0 * k as f64, 3.0, *h, 1.0 + k as f64)).collect();
        let (grown, _) = Growth { points: points.clone(), ..table() }.grown(USUAL).unwrap();
        let low = heights.iter().copied().fold(0.0, f64::min);
        let high = heights.iter().copied().fold(0.0, f64::max);
        let found = grown.height([7.3, east]);
        prop_assert!(found >= low - 1e-9 && found <= high + 1e-9);
        for point in points {
            prop_assert!((grown.height(point.at) - point.height).abs() < 1e-12);
        }
    }
}
