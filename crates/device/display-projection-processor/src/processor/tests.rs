//! Occlusion against closed forms, and the two circuits against one another.

use super::{Processor, Projected};
use crate::{BrokenProfile, Deflection};
use landscape::{LUNOID_RADIUS, parabolic_drop};
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
use scenario::{Curvature, Occlusion, Projection};
use signal::{Break, Breaks, LANES, Lanes};

fn project(occlusion: Occlusion, heights: &[f64], ranges: &[f64]) -> Projected<f64> {
    let processor = Processor::new(occlusion, Curvature::None, ranges);
    let height: Vec<_> = heights.iter().map(|&height| Lanes::splat(height)).collect();
    let level = Deflection::new(Projection::Exact, 0.0, 0.0).in_lines(575.0, 0.268);
    let mut out = Projected::default();
    processor.run(&height, &[level; LANES], &mut out);
    out
}

/// A profile of one lane and what lies between its samples: step, share, height, whether it bends there.
type Place = (usize, f64, f64, bool);

fn broken(breaks: &[Place]) -> (Breaks<f64>, [Vec<bool>; LANES]) {
    let place =
        |&(sample, share, height, _): &Place| Break { sample, share, height, before: 0.5, after: 0.5 };
    let list: Vec<_> = breaks.iter().map(place).collect();
    let bends: Vec<_> = breaks.iter().map(|place| place.3).collect();
    (std::array::from_fn(|_| list.clone()), std::array::from_fn(|_| bends.clone()))
}

fn project_broken(occlusion: Occlusion, heights: &[f64], breaks: &[Place], ranges: &[f64]) -> Projected<f64> {
    let processor = Processor::new(occlusion, Curvature::Parabolic, ranges);
    let height: Vec<_> = heights.iter().map(|&height| Lanes::splat(height)).collect();
    let level = Deflection::new(Projection::Exact, 0.0, 0.0).in_lines(575.0, 0.268);
    let (breaks, bends) = broken(breaks);
    let mut out = Projected::default();
    processor.run_broken(
        &height,
        BrokenProfile { breaks: &breaks, bends: &bends },
        &[level; LANES],
        &mut out,
    );
    out
}

fn bowl(range: f64) -> f64 {
    // Type 1 crater, r1 = 10, a = 2, near rim at 50, seen from H = 1.63.
    let rho = range - 60.0;
    let depth = if rho.abs() < 10.0 { 2.0 * (rho * rho / 100.0 - 1.0) } else { 0.0 };
    depth - 1.63
}

#[test]
fn a_crater_is_hidden_by_its_near_rim_until_the_closed_form_says() {
    // Section 15.2: hidden from z1 to z1 + r1 + r1 (1 - r1 H / (a z1)) = 68.37.
    let ranges: Vec<f64> = (0..40_001).map(|k| 40.0 + 0.001 * f64::from(k)).collect();
    let heights: Vec<f64> = ranges.iter().map(|&range| bowl(range)).collect();
    for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
        let out = project(occlusion, &heights, &ranges);
        let hidden = |k: usize| out.elevation[k][0] < out.hold[k][0];
        let first = (0..ranges.len()).find(|&k| hidden(k)).unwrap();
        let last = (0..ranges.len()).rfind(|&k| hidden(k)).unwrap();
        assert!((ranges[first] - 50.0).abs() < 0.0015, "{}", ranges[first]);
        // The rim is a kink: its top is known to a part of a sample.
        assert!((ranges[last] + 0.001 * out.entry[last + 1][0] - 68.37).abs() < 5e-4);
    }
}

#[test]
fn the_top_of_a_hill_lies_between_samples() {
    // tan eta = 0.1 - (z - z0)^2 / 1000, sampled every metre: the top is held wherever it falls.
    for shift in [0.0, 0.2, 0.5, 0.9] {
        let ranges: Vec<f64> = (0..20).map(|k| 100.0 + f64::from(k)).collect();
        let hill = |range: f64| {
            let off = range - 110.0 - shift;
            (0.1 - off * off / 1000.0) * range
        };
        let heights: Vec<f64> = ranges.iter().map(|&range| hill(range)).collect();
        for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
            let out = project(occlusion, &heights, &ranges);
            assert!((out.hold[19][0] - 0.1).abs() < 1e-12, "{shift}: {}", out.hold[19][0]);
        }
    }
}

#[test]
fn check_table_23_5_elevations() {
    let out = project(Occlusion::PeakHold, &[-1.63, 0.87], &[6.0, 100.0]);
    assert!((out.elevation[0][0] + 0.27166666666666667).abs() < 1e-15);
    assert!((out.elevation[1][0] - 0.0087).abs() < 1e-15);
}

#[test]
fn a_rim_between_samples_is_the_top_that_is_held() {
    // Section 15.2 again, with samples a metre apart that miss both rims: 50 m and 70 m.
    let ranges: Vec<f64> = (0..41).map(|k| 40.3 + f64::from(k)).collect();
    let heights: Vec<f64> = ranges.iter().map(|&range| bowl(range) + parabolic_drop(range)).collect();
    let rim = |range: f64| {
        let sample = ranges.partition_point(|&z| z < range);
        (sample, range - ranges[sample - 1], -1.63 + parabolic_drop(range), true)
    };
    for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
        let out = project_broken(occlusion, &heights, &[rim(50.0), rim(70.0)], &ranges);
        let (first, last) = (rim(50.0).0, ranges.partition_point(|&z| z < 68.37));
        assert!((out.hold[first][0] + 1.63 / 50.0).abs() < 1e-12, "{}", out.hold[first][0]);
        assert!((out.breaks.hold[0][0] + 1.63 / 50.0).abs() < 1e-12);
        assert_eq!(out.hold[last - 1][0], out.hold[first][0]);
        // The chord of a metre of the far wall: a parabola with h'' = 0.04.
        let entry = ranges[last - 1] + out.entry[last][0];
        assert!((entry - 68.37).abs() < 0.02, "{entry}");
        assert!((out.breaks.elevation[0][1] + 1.63 / 70.0).abs() < 1e-12);
    }
}

#[test]
fn a_break_is_projected_like_a_sample_there() {
    let (near, far, share, height) = (1000.0, 1400.0, 0.3, -2.5);
    let between = near + share * (far - near);
    let sampled = project_broken(Occlusion::PeakHold, &[-3.0, height, -6.0], &[], &[near, between, far]);
    let broken =
        project_broken(Occlusion::PeakHold, &[-3.0, -6.0], &[(1, share, height, true)], &[near, far]);
    assert!((broken.breaks.elevation[0][0] - sampled.elevation[1][0]).abs() < 1e-15);
    assert!((broken.breaks.position[0][0] - sampled.position[1][0]).abs() < 1e-9);
    assert_eq!(broken.breaks.line[0][0], broken.breaks.position[0][0]);
    assert_eq!(broken.hold[1], Lanes::splat(broken.breaks.hold[0][0]));
}

#[test]
fn a_top_next_to_a_bend_lies_on_the_smooth_side() {
    // tan eta = 0.1 - (z - 110.1)^2 / 1000 up to 110.6, then a steep fall: the top is before the bend.
    let ranges: Vec<f64> = (0..20).map(|k| 100.0 + f64::from(k)).collect();
    let tangent = |range: f64| {
        let off = f64::min(range, 110.6) - 110.1;
        0.1 - off * off / 1000.0 - 0.02 * f64::max(range - 110.6, 0.0)
    };
    let lift = |range: f64| tangent(range) * range + parabolic_drop(range);
    let heights: Vec<f64> = ranges.iter().map(|&range| lift(range)).collect();
    for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
        let out = project_broken(occlusion, &heights, &[(11, 0.6, lift(110.6), true)], &ranges);
        assert!((out.hold[19][0] - 0.1).abs() < 1e-12, "{}", out.hold[19][0]);
    }
}

#[test]
fn an_edge_of_shadow_leaves_the_hold_alone() {
    let ranges: Vec<f64> = (0..20).map(|k| 100.0 + f64::from(k)).collect();
    let heights: Vec<f64> =
        ranges.iter().map(|&range| 0.1 * range - (range - 110.3) * (range - 110.3)).collect();
    let edges = [(10, 0.9, 50.0, false), (11, 0.2, 90.0, false)];
    let plain = project_broken(Occlusion::PeakHold, &heights, &[], &ranges);
    let edged = project_broken(Occlusion::PeakHold, &heights, &edges, &ranges);
    assert_eq!((&plain.hold, &plain.entry), (&edged.hold, &edged.entry));
    assert_eq!(edged.breaks.hold[0], [plain.hold[9][0], plain.hold[10][0]]);
}

/// Places that a list of breaks may have over `samples` samples, ascending.
fn in_order(places: &[(u16, f64, f64, bool)], samples: usize) -> Vec<Place> {
    let step = |sample: u16| 1 + usize::from(sample) % (samples - 1);
    let mut places: Vec<Place> =
        places.iter().map(|&(sample, share, height, bend)| (step(sample), share, height, bend)).collect();
    places.sort_by(|a, b| (a.0, a.1).partial_cmp(&(b.0, b.1)).unwrap());
    places
}

/// Held lines at samples and breaks in the order in which the sweep passes them.
fn walk(out: &Projected<f64>, places: &[Place]) -> Vec<f64> {
    let mut lines = Vec::new();
    for (sample, line) in out.line.iter().enumerate() {
        let within = places.iter().enumerate().filter(|(_, place)| place.0 == sample);
        lines.extend(within.map(|(index, _)| out.breaks.line[0][index]));
        lines.push(line[0]);
    }
    lines
}

proptest! {
    #[test]
    fn both_circuits_hide_the_same_ground(heights in proptest::collection::vec(-30.0..30.0f64, 2..200)) {
        let ranges: Vec<f64> = (0..heights.len()).map(|k| 5.0 + 3.0 * k as f64).collect();
        let peak = project(Occlusion::PeakHold, &heights, &ranges);
        let reported = project(Occlusion::Derivative, &heights, &ranges);
        prop_assert_eq!(&peak.hold, &reported.hold);
        prop_assert_eq!(&peak.entry, &reported.entry);
        prop_assert!(peak.line.windows(2).all(|pair| pair[1][0] <= pair[0][0]));
        prop_assert!(peak.entry.iter().all(|entry| (0.0..=1.0).contains(&entry[0])));
    }

    #[test]
    fn both_circuits_hide_the_same_ground_over_bends(
        heights in proptest::collection::vec(-30.0..30.0f64, 2..100),
        places in proptest::collection::vec((any::<u16>(), 0.0..=1.0f64, -30.0..30.0f64, any::<bool>()), 0..40),
    ) {
        let ranges: Vec<f64> = (0..heights.len()).map(|k| 5.0 + 3.0 * k as f64).collect();
        let places = in_order(&places, heights.len());
        let peak = project_broken(Occlusion::PeakHold, &heights, &places, &ranges);
        let reported = project_broken(Occlusion::Derivative, &heights, &places, &ranges);
        prop_assert_eq!(&peak.hold, &reported.hold);
        prop_assert_eq!(&peak.entry, &reported.entry);
        prop_assert_eq!(&peak.breaks.hold, &reported.breaks.hold);
        prop_assert!(peak.entry.iter().all(|entry| (0.0..=1.0).contains(&entry[0])));
        let lines = walk(&peak, &places);
        prop_assert!(lines.windows(2).all(|pair| pair[1] <= pair[0]), "{:?}", lines);
    }

    #[test]
    fn lanes_without_bends_do_not_notice_those_with(
        heights in proptest::collection::vec(-30.0..30.0f64, 2..100),
        places in proptest::collection::vec((any::<u16>(), 0.0..=1.0f64, -30.0..30.0f64, any::<bool>()), 0..40),
    ) {
        let ranges: Vec<f64> = (0..heights.len()).map(|k| 5.0 + 3.0 * k as f64).collect();
        let (mut breaks, mut bends) = broken(&in_order(&places, heights.len()));
        for lane in [1, 4] {
            breaks[lane].clear();
            bends[lane].clear();
        }
        // Lane 4 has breaks that do not bend.
        breaks[4].extend(&breaks[0].clone());
        bends[4].resize(breaks[4].len(), false);
        let processor = Processor::new(Occlusion::PeakHold, Curvature::Parabolic, &ranges);
        let height: Vec<_> = heights.iter().map(|&height| Lanes::splat(height)).collect();
        let deflection = [Deflection::new(Projection::Exact, 0.1, 0.0).in_lines(575.0, 0.268); LANES];
        let (mut with, mut without) = (Projected::default(), Projected::default());
        processor.run_broken(&height, BrokenProfile { breaks: &breaks, bends: &bends }, &deflection, &mut with);
        processor.run(&height, &deflection, &mut without);
        let pairs = [
            (&with.elevation, &without.elevation),
            (&with.hold, &without.hold),
            (&with.entry, &without.entry),
            (&with.position, &without.position),
            (&with.line, &without.line),
        ];
        for (with, without) in pairs {
            for (with, without) in with.iter().zip(without) {
                for lane in [1, 4] {
                    prop_assert_eq!(with[lane].to_bits(), without[lane].to_bits());
                }
            }
        }
    }
}

/// Level ground under every law of curvature, at samples and at a break between two: the sphere's drop by a right triangle.
#[test]
fn far_ground_drops_by_the_law() {
    let fifth = LUNOID_RADIUS / 5.0;
    let ranges = [1000.0, 3.0 * fifth, 4.0 * fifth];
    let height = [Lanes::splat(-1000.0); 3];
    let (breaks, bends) = broken(&[(2, 0.5, -1000.0, false)]);
    for (law, drops) in [
        (Curvature::None, [0.0; 3]),
        (Curvature::Parabolic, [0.9 * fifth, 1.225 * fifth, 1.6 * fifth]),
        (Curvature::Exact, [fifth, fifth * (5.0 - 12.75_f64.sqrt()), 2.0 * fifth]),
    ] {
        let processor = Processor::<f64>::new(Occlusion::PeakHold, law, &ranges);
        let level = Deflection::new(Projection::Exact, 0.0, 0.0).in_lines(575.0, 0.268);
        let mut out = Projected::default();
        processor.run_broken(
            &height,
            BrokenProfile { breaks: &breaks, bends: &bends },
            &[level; LANES],
            &mut out,
        );
        let found = [out.elevation[1][0], out.breaks.elevation[0][0], out.elevation[2][0]];
        for ((found, drop), share) in found.into_iter().zip(drops).zip([3.0, 3.5, 4.0]) {
            let expected = -(1000.0 + drop) / (share * fifth);
            assert!((found / expected - 1.0).abs() < 1e-12, "{law:?}: {found}, not {expected}");
        }
    }
}
