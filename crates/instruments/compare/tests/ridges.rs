//! Ridge lines: marked where they are, and measured.

use compare::{CompareError, RidgeError, horizon_of_picture, horizon_of_range, ridge_error, ridge_mask};
use picture::{Depth, GreyPicture};

const SKY: f32 = f32::INFINITY;

/// The mask as text, one line of the picture a line.
fn drawn(range: &[f32], columns: usize, jump: f32) -> Vec<String> {
    let mask = ridge_mask(range, columns, range.len() / columns, jump).expect("a good plane");
    let letters = |line: &[bool]| line.iter().map(|marked| if *marked { '#' } else { '.' }).collect();
    mask.chunks(columns).map(letters).collect()
}

#[test]
fn the_edge_of_the_sky_is_a_ridge_of_three_lines() {
    let range = [[SKY; 4], [SKY; 4], [SKY; 4], [90.0; 4], [85.0; 4], [80.0; 4]].concat();
    assert_eq!(drawn(&range, 4, 0.5), ["....", "....", "####", "####", "####", "...."]);
}

#[test]
fn a_jump_of_range_is_marked_around_its_nearer_side() {
    let range = [[100.0; 6], [99.0; 6], [98.0, 98.0, 98.0, 98.0, 98.0, 40.0], [97.0; 6], [96.0; 6]].concat();
    assert_eq!(drawn(&range, 6, 0.5), ["......", "....##", "....##", "....##", "......"]);
    assert_eq!(drawn(&range, 6, 2.0), ["......"; 5]);
}

#[test]
fn the_jump_is_relative_and_exclusive() {
    assert_eq!(drawn(&[150.0, 100.0], 1, 0.5), [".", "."]);
    assert_eq!(drawn(&[151.0, 100.0], 1, 0.5), ["#", "#"]);
    assert_eq!(drawn(&[1.51, 1.0], 2, 0.5), ["##"]);
}

#[test]
fn ends_of_lines_are_not_neighbours() {
    assert_eq!(drawn(&[10.0, 15.0, 22.0, 11.0, 16.0, 23.0], 3, 0.8), ["...", "..."]);
    assert_eq!(drawn(&[22.0, 15.0, 10.0, 23.0, 16.0, 11.0], 3, 0.8), ["...", "..."]);
}

#[test]
fn planes_that_cannot_be_are_refused() {
    assert!(matches!(ridge_mask(&[1.0; 5], 3, 2, 0.1), Err(CompareError::Plane { expected: 6, .. })));
    let nan = ridge_mask(&[1.0, 1.0, 1.0, f32::NAN], 2, 2, 0.1).expect_err("not a range");
    assert_eq!(nan.to_string(), "range NaN at pixel 1, 1, expected 0 or more, infinity for the sky");
    assert!(matches!(horizon_of_range(&[-1.0], 1, 1), Err(CompareError::Range { .. })));
}

#[test]
fn horizons_are_the_first_ground_from_the_top() {
    let range = [[SKY, SKY, 9.0], [SKY, 5.0, SKY], [SKY, 4.0, 3.0]].concat();
    assert_eq!(horizon_of_range(&range, 3, 3).expect("a good plane"), [None, Some(1), Some(0)]);
    let codes = vec![0, 2, 3, 1, 3, 0];
    let picture = GreyPicture::new(3, 2, Depth::Eight, codes).expect("a good picture");
    assert_eq!(horizon_of_picture(&picture, 2), [None, Some(1), Some(0)]);
}

#[test]
fn a_horizon_one_line_off_is_noticed() {
    let reference: Vec<_> = (0..200).map(|column| Some(100 + column % 7)).collect();
    let mut test = reference.clone();
    assert_eq!(ridge_error(&test, &reference, 0).expect("one size").maximum, 0);
    test[17] = Some(100 + 17 % 7 - 1);
    let one = ridge_error(&test, &reference, 0).expect("one size");
    assert_eq!((one.median, one.percentile_99, one.maximum), (0, 0, 1));
    test[18] = Some(0);
    test[19] = None;
    test[20] = Some(104 + 20 % 7);
    let error = ridge_error(&test, &reference, 0).expect("one size");
    // 199 columns: rank 198 of the sorted errors is the 99th percentile.
    let expected = RidgeError { compared: 199, only_one: 1, median: 0, percentile_99: 4, maximum: 104 };
    assert_eq!(error, expected);
    assert!(ridge_error(&test[1..], &reference, 0).is_err());
}

#[test]
fn a_mast_may_stand_a_column_aside() {
    let with_mast =
        |at: usize| (0..20).map(|column| Some(if column == at { 40 } else { 60 })).collect::<Vec<_>>();
    let maximum =
        |test: &[_], reference: &[_], reach| ridge_error(test, reference, reach).expect("one size").maximum;
    let (mast, aside, far) = (with_mast(7), with_mast(8), with_mast(9));
    assert_eq!(maximum(&aside, &mast, 0), 20);
    assert_eq!(maximum(&aside, &mast, 1), 0);
    assert_eq!(maximum(&far, &mast, 1), 20);
    // Within reach the lines between foot and top are the mast's; above its top nothing is.
    let mut between = aside.clone();
    between[8] = Some(50);
    assert_eq!(maximum(&between, &mast, 1), 0);
    between[8] = Some(38);
    assert_eq!(maximum(&between, &mast, 1), 2);
}
