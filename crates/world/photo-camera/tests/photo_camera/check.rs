//! Control points: residuals, their root mean square, the best shift, and lists that say nothing.

use photo_camera::{CameraError, ControlPoint, Image, check};

use crate::{Random, ground, thesis_camera};

/// Control points whose measured pixels are off by `offset(index)`.
fn points(offset: impl Fn(usize) -> [f64; 2]) -> Vec<ControlPoint> {
    ["37:23:10 N", "37:24:02 N", "37:24:40 N", "37:25:20 N"]
        .iter()
        .enumerate()
        .map(|(index, latitude)| {
            let ground = ground(latitude, "122:02:06 W", 5.0 * index as f64);
            let Image::Front { pixel, .. } = thesis_camera().project(ground) else { panic!("in front") };
            let off = offset(index);
            ControlPoint { ground, pixel: [pixel[0] + off[0], pixel[1] + off[1]] }
        })
        .collect()
}

#[test]
fn a_shift_is_found_and_taken_away() {
    let found = check(&thesis_camera(), &points(|_| [3.0, -4.0])).expect("four points");
    assert!((found.root_mean_square - 5.0).abs() < 1e-9);
    assert!((found.best_shift[0] - 3.0).abs() < 1e-9 && (found.best_shift[1] + 4.0).abs() < 1e-9);
    assert!(found.root_mean_square_shifted < 1e-9);
    assert!(found.within(5.1) && !found.within(4.9));
}

#[test]
fn residuals_are_told_point_by_point_with_the_worst() {
    let offsets = [[1.0, 0.0], [-1.0, 0.0], [0.0, 7.0], [0.0, 1.0]];
    let found = check(&thesis_camera(), &points(|index| offsets[index])).expect("four points");
    assert_eq!(found.worst, 2);
    for (found, expected) in found.residuals.iter().zip(offsets) {
        assert!((found[0] - expected[0]).abs() < 1e-9 && (found[1] - expected[1]).abs() < 1e-9);
    }
    assert!((found.root_mean_square - 13.0_f64.sqrt()).abs() < 1e-9);
}

#[test]
fn no_other_shift_leaves_less() {
    let mut random = Random(6);
    let offsets: Vec<[f64; 2]> =
        (0..4).map(|_| [random.between(-9.0, 9.0), random.between(-9.0, 9.0)]).collect();
    let found = check(&thesis_camera(), &points(|index| offsets[index])).expect("four points");
    for _ in 0..200 {
        let by = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        let other = [0, 1].map(|k| found.best_shift[k] + by[k]);
        let moved = points(|index| [0, 1].map(|k| offsets[index][k] - other[k]));
        let left = check(&thesis_camera(), &moved).expect("four points").root_mean_square;
        assert!(left > found.root_mean_square_shifted);
    }
}

#[test]
fn lists_that_say_nothing_are_refused() {
    let camera = thesis_camera();
    let good = points(|_| [0.0; 2]);
    for count in [0, 1] {
        let refused = check(&camera, &good[..count]);
        assert_eq!(refused, Err(CameraError::TooFewPoints { found: count, least: 2 }));
    }
    let mut behind = good.clone();
    behind[3].ground = camera.centre() * 2.0 - behind[3].ground;
    assert_eq!(check(&camera, &behind), Err(CameraError::Behind { index: 3 }));
    let mut unknown = good;
    unknown[1].pixel[0] = f64::NAN;
    assert!(matches!(check(&camera, &unknown), Err(CameraError::Figure { .. })));
}
