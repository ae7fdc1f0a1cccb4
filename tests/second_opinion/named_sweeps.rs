//! Sweeps that a careless machine gets wrong: along an axis, on a boundary, through corners, and within 1e-9 of each.
//!
//! An odd number of sweeps makes the centre one run exactly along the heading.

use lunoid_tests::{ComparedScene, Dice, Lockstep, level_of};
use quantities::radians;
use scenario::{RangeLaw, RangeProgramme, Scalar};

const SIZE: f64 = 200.0;

/// Random ground of 12 x 12 regions around the origin; all corners at exact multiples of the region size.
fn ground() -> ComparedScene {
    let mut dice = Dice::new(6);
    let words: Vec<[f64; 9]> = (0..169).map(|_| std::array::from_fn(|_| 5.0 * dice.normal())).collect();
    let mut scene = ComparedScene::over(level_of(SIZE, [0.0, 0.0], [13, 13], |m, n| words[m * 13 + n]));
    scene.sweeps = 5;
    scene.range = RangeProgramme { law: RangeLaw::ConstantRate, start: 3.0, end: 1051.0 };
    scene
}

/// The eye at (m, n) in regions, a nudge off it (m), all headings given.
fn check(place: [f64; 2], nudges: &[[f64; 2]], headings: &[f64]) {
    for &nudge in nudges {
        for &heading in headings {
            for scalar in [Scalar::F64, Scalar::F32] {
                let mut scene = ground();
                scene.stand(place[0] * SIZE + nudge[0], place[1] * SIZE + nudge[1], 4.0);
                scene.heading = radians(heading);
                scene.scalar = scalar;
                crate::second_opinion::agree(
                    &scene,
                    &format!("eye {place:?} regions {nudge:?} m, heading {heading}, {scalar:?}"),
                );
            }
        }
    }
}

const AXES: [f64; 4] = [0.0, 90.0, 180.0, 270.0];
const DIAGONALS: [f64; 4] = [45.0, 135.0, 225.0, 315.0];
const NEAR: [[f64; 2]; 5] = [[0.0, 0.0], [1e-9, 0.0], [-1e-9, 0.0], [0.0, 1e-9], [-1e-9, -1e-9]];

#[test]
fn exactly_along_an_axis() {
    check([6.3, 5.6], &[[0.0, 0.0]], &AXES);
}

#[test]
fn along_a_boundary_and_within_a_nanometre_of_it() {
    check([6.0, 5.4], &NEAR, &AXES);
    check([5.4, 7.0], &NEAR, &AXES);
}

#[test]
fn from_a_corner_along_its_boundaries() {
    check([6.0, 6.0], &NEAR, &AXES);
    check([5.0, 6.0], &NEAR, &AXES);
}

#[test]
fn through_corners_and_within_a_nanometre_of_them() {
    check([6.0, 6.0], &NEAR, &DIAGONALS);
    check([5.0, 6.0], &NEAR, &DIAGONALS);
    check([5.5, 6.5], &NEAR, &DIAGONALS);
}

#[test]
fn from_the_edges_and_corners_of_the_problem_area() {
    check([0.0, 0.0], &[[0.0, 0.0]], &[0.0, 45.0, 90.0, 180.0, 225.0]);
    check([12.0, 12.0], &[[0.0, 0.0]], &[0.0, 45.0, 90.0, 180.0, 225.0]);
    check([12.0, 5.5], &[[0.0, 0.0]], &AXES);
}

#[test]
fn a_sweep_along_an_axis_never_folds_the_other_ramp() {
    let mut scene = ground();
    scene.sweeps = 1;
    for (heading, moving) in [(0.0, 0), (90.0, 1), (180.0, 0), (270.0, 1)] {
        scene.stand(6.0 * SIZE, 6.0 * SIZE, 4.0);
        scene.heading = radians(heading);
        let lockstep = Lockstep::run(&scene, 0);
        // 1051 m on 200 m regions: the first stop comes a full region out.
        assert_eq!(lockstep.report.counts["folds"], 5, "heading {heading}");
        assert!(
            lockstep.sweeps[0].interpreter.stops.iter().all(|&(_, axis)| axis == moving),
            "heading {heading}"
        );
    }
}

#[test]
fn a_sweep_through_corners_meets_both_stops_each_time() {
    let mut scene = ground();
    scene.sweeps = 1;
    scene.stand(6.0 * SIZE, 6.0 * SIZE, 4.0);
    for heading in DIAGONALS {
        scene.heading = radians(heading);
        // Corners at 283, 566 and 849 m.
        assert_eq!(Lockstep::run(&scene, 0).report.counts["folds"], 6, "heading {heading}");
    }
}

#[test]
fn along_a_boundary_height_is_that_of_either_side() {
    let mut scene = ground();
    scene.sweeps = 1;
    scene.stand(6.0 * SIZE, 5.4 * SIZE, 4.0);
    scene.heading = radians(90.0);
    let on = Lockstep::run(&scene, 0);
    for side in [1e-7, -1e-7] {
        scene.eye[0] = 6.0 * SIZE + side;
        let beside = Lockstep::run(&scene, 0);
        let heights = [&on, &beside].map(|side| &side.sweeps[0].interpreter.signals["tg.height"]);
        assert!(heights[0].len() > 200);
        for (on, beside) in heights[0].iter().zip(heights[1]) {
            assert!((on - beside).abs() < 1e-6);
        }
    }
}
