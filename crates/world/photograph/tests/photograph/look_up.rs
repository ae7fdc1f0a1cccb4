//! The bilinear look-up: centres, planes, edges, depths, the grey curve.

use photo_camera::Light;
use picture::Depth;
use quantities::unit_interval;

use crate::{from_above, picture};

/// Places inside a picture of `size`, the same in every run.
fn places(size: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    (0..500_u64).map(move |at| [0, 1].map(|axis| size[axis as usize] * unit_interval(7, &[at, axis])))
}

#[test]
fn a_centre_has_its_code() {
    let codes = |column: usize, line: usize| (5 * column + 2 * line) as u16;
    let photo = from_above(picture(40, 30, Depth::Eight, codes), Light::default());
    for (column, line) in [(0, 0), (39, 0), (17, 11), (0, 29), (39, 29)] {
        let found = photo.level([column as f64 + 0.5, line as f64 + 0.5]).expect("inside");
        assert!((255.0 * found - f64::from(codes(column, line))).abs() < 1e-12);
    }
}

/// Codes that are linear in column and line make a plane, and bilinear values lie on it.
#[test]
fn planes_are_exact_in_both_depths() {
    for (depth, scale) in [(Depth::Eight, 1.0), (Depth::Sixteen, 257.0)] {
        let codes = |column: usize, line: usize| (scale * (3.0 * column as f64 + 4.0 * line as f64)) as u16;
        let photo = from_above(picture(40, 30, depth, codes), Light::default());
        let inner = |[i, j]: &[f64; 2]| (0.5..=39.5).contains(i) && (0.5..=29.5).contains(j);
        for [i, j] in places([40.0, 30.0]).filter(inner) {
            let expected = (3.0 * (i - 0.5) + 4.0 * (j - 0.5)) / 255.0;
            assert!((photo.level([i, j]).expect("inside") - expected).abs() < 1e-12, "{i}, {j}");
        }
    }
}

/// A second look-up: the four weights by areas.
#[test]
fn between_centres_the_weights_are_areas() {
    let codes = |column: usize, line: usize| (251.0 * unit_interval(3, &[column as u64, line as u64])) as u16;
    let photo = from_above(picture(40, 30, Depth::Eight, codes), Light::default());
    for [i, j] in places([40.0, 30.0]) {
        let weight = |at: f64, centre: usize, last: usize| {
            let apart = (at.clamp(0.5, last as f64 + 0.5) - (centre as f64 + 0.5)).abs();
            (1.0 - apart).max(0.0)
        };
        let mut expected = 0.0;
        for column in 0..40 {
            for line in 0..30 {
                expected += weight(i, column, 39) * weight(j, line, 29) * f64::from(codes(column, line));
            }
        }
        let found = 255.0 * photo.level([i, j]).expect("inside");
        assert!((found - expected).abs() < 1e-9, "{i}, {j}: {found}, not {expected}");
    }
}

#[test]
fn the_edge_holds_half_a_pixel_and_beyond_there_is_nothing() {
    let photo = from_above(picture(40, 30, Depth::Eight, |column, _| column as u16), Light::default());
    let level = |i: f64, j: f64| photo.level([i, j]).map(|level| 255.0 * level);
    assert_eq!((level(0.0, 0.0), level(0.5, 3.0)), (Some(0.0), Some(0.0)));
    let outermost = level(39.99, 29.99).expect("inside");
    assert!((outermost - 39.0).abs() < 1e-12);
    for beside in [[-1e-9, 3.0], [40.0, 3.0], [3.0, -1e-9], [3.0, 30.0], [f64::NAN, 3.0]] {
        assert_eq!((photo.level(beside), photo.holds(beside)), (None, false));
    }
}

/// Halfway between black and white there is half the light, not the light of the middle code.
#[test]
fn light_is_mixed_in_light() {
    let codes = |column: usize, _: usize| if column < 20 { 0 } else { 255 };
    let light = Light::new(None, Some([0.5, 2.2])).expect("a grey curve");
    let photo = from_above(picture(40, 30, Depth::Eight, codes), light);
    let middle = [20.0, 15.0];
    assert!((photo.level(middle).expect("inside") - 0.5).abs() < 1e-12);
    assert!((photo.light(middle).expect("inside") - 0.25).abs() < 1e-7);
    let dim = from_above(picture(4, 3, Depth::Eight, |_, _| 51), light);
    // 0.2^2.2, worked out by hand: exp(2.2 ln 0.2).
    let expected = 0.5 * 0.028_991_186_547_107_8;
    assert!((dim.light([2.0, 1.0]).expect("inside") - expected).abs() < 1e-7);
}
